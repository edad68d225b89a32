"""LaTeX: the derivation as a page to read."""

from pkmodes_derive.emit.latex.page import page

__all__ = ["page"]
