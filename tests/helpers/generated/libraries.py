"""What tests of the back ends share: a robot, and the libraries that a folder keeps."""

from __future__ import annotations

from pathlib import Path

import pkmodes

ROOT = Path(__file__).parents[3]
ROBOT = ROOT / "robots/corexy-printer.toml"
POSE = [0.15, 0.2]


def libraries(folder: Path) -> list[Path]:
    return sorted(folder.glob("*.so"))


def frequencies(backend: str = "auto") -> pkmodes.Modes:
    return pkmodes.load(ROBOT).modes(POSE, backend=backend, fields=["frequencies"])
