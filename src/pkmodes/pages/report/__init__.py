"""Reports: one self-contained HTML page for a diagnosis, a comparison or a map.

`report` and `map_report` make the page; `view_of_result` and `view_of` the view in three dimensions inside it;
`Source` names an input file by its content.  docs/how-to/report.md says what a page contains.
`pkmodes.pages.report.page.page` makes other pages from `pkmodes.pages.report.blocks`.
"""

import lazy_loader

# The command line shows tables of this package without loading what draws the figures of its pages.
__getattr__, __dir__, __all__ = lazy_loader.attach_stub(__name__, __file__)
