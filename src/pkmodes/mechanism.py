"""Mechanisms: those that come with pkmodes, and user-defined ones (docs/how-to/adding-a-mechanism.md)."""

from pkmodes.core.mechanism import add_folder, mechanism, names

__all__ = ["add_folder", "mechanism", "names"]
