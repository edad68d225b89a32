"""NumPy: one module, batch first."""

from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.numpy.module import files
from pkmodes_derive.emit.numpy.printer import expression

BACKEND = Backend("NumPy", expression, model=files)
