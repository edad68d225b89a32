"""C99: one source and one header, for controllers."""

from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.c99.source import files

BACKEND = Backend("C99", files)
