"""Lanes: C with vector types, several poses side by side, for the compiled evaluator of `pkmodes.compiled`."""

from pkmodes_derive.emit.lanes.source import FILE_NAME, files

__all__ = ["FILE_NAME", "files"]
