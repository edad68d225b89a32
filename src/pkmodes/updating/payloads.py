"""Plausible payloads for another measurement, relative to the mass of the platform."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.layout import EFFECTS, items
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.paths import ParameterPath, resolve

Array = NDArray[np.float64]
#: The effect of a mass on the platform, and its parameter.
PAYLOAD = "payload"
PATH = f"{EFFECTS}.{PAYLOAD}.mass"
#: Payloads as parts of the platform's mass.
PARTS = (0.1, 0.3, 1.0)
#: Significant digits of a payload.
DIGITS = 3


def payloads(robot: Robot, points: Array) -> list[dict[str, float]]:
    """Return payloads as values to set, added to the declared one; empty if the mechanism has no payload effect.

    Parameters
    ----------
    points : ndarray, shape (P, d)
        Poses that can be evaluated.
    """
    platform = platform_mass(robot, points)
    if platform is None:
        return []
    there = robot.effects.get(PATH.removeprefix(f"{EFFECTS}."), 0.0)
    return [{PATH: there + float(f"{part * platform.value:.{DIGITS}g}")} for part in PARTS]


def platform_mass(robot: Robot, points: Array) -> ParameterPath | None:
    """Return the path of the mass that acts like a payload; None if there is none."""
    mechanism = robot.mechanism
    if PAYLOAD not in mechanism.effects or not len(points):
        return None
    names = [
        item.path for item in items(mechanism) if item.key.dimension == "mass" and item.index is not None
    ]
    paths = [resolve(robot, path) for path in (PATH, *names)]
    dM, dK = MatrixDerivatives(ExtendedSystem.of(robot), points[:1], [paths]).dense()
    for place, path in enumerate(paths[1:], start=1):
        alike = (np.allclose(d[0, place], d[0, 0], atol=1e-9 * np.abs(d[0, 0]).max()) for d in (dM, dK))
        if all(alike):
            return path
    return None
