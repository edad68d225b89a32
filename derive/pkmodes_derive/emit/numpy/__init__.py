"""NumPy: one module, batch first."""

from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.numpy.module import files

BACKEND = Backend("NumPy", files)
