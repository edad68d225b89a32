"""Emission of derived functions as NumPy, C99 and LaTeX, with a manifest for later checks.

`program` orders and shortens the expressions once for all languages.  Each language has a folder with its printer,
its layout and templates, which contain no mathematics: those in `registry` are back ends, whose files `product`
combines; `latex` is the derivation page.  The languages share `commentary` for prose, `layout` for line wrapping and
`provenance` for headers.
"""
