"""Supplied robots, with any effects, and a pose without symmetry for each mechanism."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

import pkmodes
from pkmodes.core.mechanism.registry import Mechanism, mechanism

ROBOTS = Path(__file__).resolve().parents[3] / "robots"
#: The plain robot file of every mechanism that comes with pkmodes: that with the shortest name.
EVERY = {
    pkmodes.read_robot(path).mechanism_name: path.name
    for path in sorted(ROBOTS.glob("*.toml"), key=lambda path: -len(path.name))
}
#: Those for which tests have a rig or formulas of their own.
FILES = {
    "linear_delta": "linear-delta-2022-identified.toml",
    "rotary_delta": "clavel-delta.toml",
    "corexy": "corexy-printer.toml",
}


POSES = {
    "linear_delta": np.array([0.55, 0.06, -0.26]),
    "rotary_delta": np.array([0.1, 0.05, -0.5]),
    "corexy": np.array([0.1, 0.05]),
    "hexapod": np.array([0.004, 0.0, 0.245, 0.05, 0.02, 0.0]),
    "hexaglide": np.array([0.01, 0.0, 0.2, 0.05, -0.03, 0.02]),
}
for _name, _file in EVERY.items():  # the workspace is the travel of the pose's components
    _parameters = pkmodes.read_robot(ROBOTS / _file).parameters
    if _name not in POSES and hasattr(_parameters, "workspace"):
        _low, _high = _parameters.workspace.T
        POSES[_name] = np.round(_low + (_high - _low) * [1 / 3, 1 / 6], 3)


def load_free(file: str | Path) -> pkmodes.Model:
    """Load a supplied robot with free motors, whatever its file says of its use."""
    return pkmodes.Model(replace(pkmodes.read_robot(ROBOTS / file), drives="free"))


def model_of(name: str, *effects: Mapping[str, float], ratio: float = 0.0) -> pkmodes.Model:
    """The robot of a mechanism with free motors and with effects, without those that do not apply to it."""
    given = {path: value for some in effects for path, value in some.items()}
    # One that applies to no mechanism is misspelt.
    assert given.keys() <= set().union(*(_effect_paths(mechanism(each)) for each in FILES))
    plain = load_free(FILES[name])
    known = _effect_paths(plain.mechanism)
    values = {f"effects.{path}": value for path, value in given.items() if path in known}
    return plain.with_values({**values, "damping.ratio": ratio} if ratio else values)


def _effect_paths(of: Mechanism) -> set[str]:
    return {f"{effect.name}.{p.name}" for effect in of.effects.values() for p in effect.parameters}
