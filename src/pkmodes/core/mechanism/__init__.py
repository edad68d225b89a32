"""Mechanisms: their registry, descriptions, generated functions and poses.

`add_folder` registers a mechanism of your own (docs/how-to/adding-a-mechanism.md).
"""

from pkmodes.core.mechanism.registry import Mechanism, add, add_folder, mechanism, names

__all__ = ["Mechanism", "add", "add_folder", "mechanism", "names"]
