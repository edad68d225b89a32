"""Import of packages by names without their rooms: ``pkmodes.updating`` is ``pkmodes.loop.updating``.

Users' imports thus do not depend on the room that a package is in.  Both names give the same module.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence
from importlib import import_module
from importlib.abc import Loader, MetaPathFinder
from importlib.machinery import ModuleSpec
from types import ModuleType

#: The packages of each room.
ROOMS = {
    "core": ("support",),
    "loop": ("robot_files", "measured", "diagnosis", "sensitivity", "updating"),
    "modaltest": ("identification", "signals", "campaign"),
    "machine": ("dataset", "shaping", "response", "maps"),
    "pages": ("view", "plots", "figures", "report"),
}
_ROOM_OF = {package: room for room, packages in ROOMS.items() for package in packages}


class _RoomFinder(MetaPathFinder, Loader):
    """Finds packages, and the modules in them, by their names without the room."""

    def __init__(self) -> None:
        self._specs: dict[str, ModuleSpec | None] = {}

    def find_spec(
        self, fullname: str, path: Sequence[str] | None, target: ModuleType | None = None
    ) -> ModuleSpec | None:
        """Return the spec of a name without a room, None for other names."""
        parts = fullname.split(".")
        if parts[0] != "pkmodes" or len(parts) < 2 or parts[1] not in _ROOM_OF:
            return None
        return ModuleSpec(fullname, self, origin=".".join(("pkmodes", _ROOM_OF[parts[1]], *parts[1:])))

    def create_module(self, spec: ModuleSpec) -> ModuleType:
        """Return the module of the room."""
        assert spec.origin is not None
        module = import_module(spec.origin)
        self._specs[spec.name] = module.__spec__
        return module

    def exec_module(self, module: ModuleType) -> None:
        """Restore the spec of the module, which has already been executed."""
        assert module.__spec__ is not None
        module.__spec__ = self._specs.pop(module.__spec__.name)


def install_room_finder() -> None:
    """Let packages be imported by their names without the room."""
    sys.meta_path.insert(0, _RoomFinder())  # before the finder of files, which would load a module twice
