"""The measurement frame: measured poses that are shifted or rotated with respect to the robot's frame.

A wrong zero of the height, or a table that is not parallel to the machine, affects all poses equally.  The true pose
is the measured one, rotated about the base frame's z axis by the yaw and then shifted by the offset.  Offsets are
along the linear components of a pose; the yaw rotates the first two of them, which span the plane of a planar robot.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.problem import Candidate, Parameter
from pkmodes.mechanism.registry import Mechanism

Array = NDArray[np.float64]
#: Prefixes of the parameters of the measurement, and of its candidates.
OF_MEASUREMENT, PREFIX = "measurement.", "measurement:"
YAW = f"{OF_MEASUREMENT}yaw"
#: Prior standard deviations of the measurement frame, by unit.
PLAUSIBLE = {"m": 0.02, "rad": 0.035}


def parameters(kind: Mechanism) -> dict[str, str]:
    """Return the names of the parameters of the frame, and their units."""
    linear = _linear(kind)
    yaw = {YAW: "rad"} if len(linear) > 1 else {}
    return {_offset(kind, i): "m" for i in linear} | yaw


def suspects(kind: Mechanism) -> tuple[list[Parameter], list[Candidate]]:
    """Return the parameters of the frame, and their candidates."""
    named = parameters(kind)
    what = {_offset(kind, i): f"all poses are shifted along {kind.pose[i].name}" for i in _linear(kind)}
    what[YAW] = "the frame of the poses is rotated about z"
    candidates = [
        Candidate(name.replace(OF_MEASUREMENT, PREFIX), (name,), what[name], sigma=(PLAUSIBLE[unit],))
        for name, unit in named.items()
    ]
    return [Parameter(name, 0.0, unit) for name, unit in named.items()], candidates


def true_points(kind: Mechanism, points: Array, values: Mapping[str, float]) -> Array:
    """Return the poses with respect to the robot, (P, d)."""
    offset = np.array([values.get(_offset(kind, i), 0.0) for i in range(len(kind.pose))])
    yaw = values.get(YAW, 0.0)
    if not yaw:
        return np.asarray(points + offset)
    i, k = _linear(kind)[:2]
    turn = np.eye(len(kind.pose))
    turn[i, i] = turn[k, k] = np.cos(yaw)
    turn[k, i] = np.sin(yaw)
    turn[i, k] = -turn[k, i]
    return np.asarray(points @ turn.T + offset)


def rate(kind: Mechanism, name: str, points: Array, values: Mapping[str, float]) -> Array:
    """Return the derivative of the true poses with respect to one of the parameters, (P, d)."""
    found = np.zeros(points.shape)
    if name != YAW:
        found[:, [_offset(kind, i) for i in range(len(kind.pose))].index(name)] = 1.0
        return found
    i, k = _linear(kind)[:2]
    turned = true_points(kind, points, {YAW: values.get(YAW, 0.0)})
    found[:, i], found[:, k] = -turned[:, k], turned[:, i]
    return found


def _linear(kind: Mechanism) -> list[int]:
    return [i for i, component in enumerate(kind.pose) if component.unit == "m"]


def _offset(kind: Mechanism, component: int) -> str:
    return f"{OF_MEASUREMENT}offset.{kind.pose[component].name}"
