"""Lanes: C with vector types, several poses side by side, for the compiled evaluator of `pkmodes.core.compiled`."""

from pkmodes_derive.emit.backend import Backend
from pkmodes_derive.emit.lanes.printer import expression
from pkmodes_derive.emit.lanes.source import files

BACKEND = Backend("lanes", expression, mechanism=files)
