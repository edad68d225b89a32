"""The measurement frame: poses of a file that are shifted or turned with respect to the robot's.

A wrong zero of the height, or a table that is not parallel to the machine, is in all poses alike.  The true pose is
taken as the measured one, turned about the base frame's z axis by the yaw, then shifted by the offset.  Offsets are
along the linear components of a pose; the yaw turns the first two of them, which span the plane of a planar one.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.problem import Candidate, Parameter
from pkmodes.mechanism import Mechanism

Array = NDArray[np.float64]
#: What parameters of the measurement begin with, and its candidates.
OF_MEASUREMENT, PREFIX = "measurement.", "measurement:"
YAW = f"{OF_MEASUREMENT}yaw"
#: How far a measurement frame plausibly is from the robot's: by the unit of what it moves.
PLAUSIBLE = {"m": 0.02, "rad": 0.035}


def parameters(kind: Mechanism) -> dict[str, str]:
    """Names of the parameters of the frame, and their units."""
    linear = _linear(kind)
    yaw = {YAW: "rad"} if len(linear) > 1 else {}
    return {_offset(kind, i): "m" for i in linear} | yaw


def suspects(kind: Mechanism) -> tuple[list[Parameter], list[Candidate]]:
    """Parameters of the frame, and the candidates that suspect them."""
    named = parameters(kind)
    what = {_offset(kind, i): f"all poses are shifted along {kind.pose[i].name}" for i in _linear(kind)}
    what[YAW] = "the frame of the poses is turned about z"
    candidates = [
        Candidate(name.replace(OF_MEASUREMENT, PREFIX), (name,), what[name], sigma=(PLAUSIBLE[unit],))
        for name, unit in named.items()
    ]
    return [Parameter(name, 0.0, unit) for name, unit in named.items()], candidates


def true_points(kind: Mechanism, points: Array, values: Mapping[str, float]) -> Array:
    """Poses with respect to the robot, (P, d)."""
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
    """Derivative of the true poses with respect to one of the parameters, (P, d)."""
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
