"""Figures, drawn with matplotlib through one style sheet; `style` and `svg` are for all of them."""
