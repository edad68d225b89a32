"""C99: one source and one header, for controllers."""

from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.c99.printer import expression
from pkmodes_derive.emit.c99.source import files

BACKEND = Backend("C99", expression, model=files, source=".c")
