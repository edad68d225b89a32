"""The figures of a robot: `pictures` draws them, `write_pictures` writes them (docs/figures.md)."""

from pkmodes.figures.files import write_pictures
from pkmodes.figures.pictures import Picture, pictures
from pkmodes.figures.working_plane import working_plane

__all__ = ["Picture", "pictures", "working_plane", "write_pictures"]
