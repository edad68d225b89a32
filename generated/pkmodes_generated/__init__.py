"""Generated models, one package for each mechanism; never edited by hand (see ``derive/``)."""
