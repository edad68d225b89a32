"""LaTeX: the derivation as a page."""

from pkmodes_derive.emit.latex.page import page

__all__ = ["page"]
