"""Emission: from derived functions to NumPy, C99, LaTeX, and the manifest that keeps them honest.

`program` orders and shortens the expressions, once for all languages.  Each language has a folder, with its printer,
its layout, and templates that contain no mathematics: `numpy` and `c99` are `backend`s, whose files `product` puts
together; `latex` is the page of the derivation.  What languages share lies beside them: `commentary` has the words,
`layout` the lines, `provenance` the header.
"""
