"""The figures of a robot: `pkmodes.figures.pictures` draws them, `pkmodes.figures.files` writes them."""
