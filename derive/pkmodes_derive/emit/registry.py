"""The back ends, in the order of their files: a further one is a folder beside this module, and a line here."""

from __future__ import annotations

from pkmodes_derive.emit import c99, lanes, numpy
from pkmodes_derive.emit.backend import Backend

BACKENDS: tuple[Backend, ...] = (
    numpy.BACKEND,
    c99.BACKEND,
    lanes.BACKEND,
)
