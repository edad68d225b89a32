"""The measurement frame: poses of a file that are shifted or turned with respect to the robot's.

A wrong zero of the height, or a table that is not parallel to the rails, is in all poses alike.  The true pose is
taken as the measured one, turned about the base frame's z axis by the yaw, then shifted by the offset.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.problem import Candidate, Parameter

Array = NDArray[np.float64]
#: What candidates of the measurement are called.
PREFIX = "measurement:"
AXES = ("x", "y", "z")
#: How far a measurement frame plausibly is from the robot's [m], [rad].
OFFSET, YAW = 0.02, 0.035
#: Parameters by name: unit and plausible size.
PARAMETERS = {f"measurement.offset.{axis}": ("m", OFFSET) for axis in AXES} | {
    "measurement.yaw": ("rad", YAW)
}


def suspects() -> tuple[list[Parameter], list[Candidate]]:
    """Parameters of the frame, and the candidates that suspect them."""
    parameters = [Parameter(name, 0.0, unit) for name, (unit, _) in PARAMETERS.items()]
    what = {name: f"all poses are shifted along {name[-1]}" for name in PARAMETERS}
    what["measurement.yaw"] = "the frame of the poses is turned about z"
    candidates = [
        Candidate(name.replace("measurement.", PREFIX), (name,), what[name], sigma=(size,))
        for name, (_, size) in PARAMETERS.items()
    ]
    return parameters, candidates


def true_points(points: Array, values: Mapping[str, float]) -> Array:
    """Poses with respect to the robot, (P, 3) [m]."""
    yaw = values.get("measurement.yaw", 0.0)
    offset = np.array([values.get(f"measurement.offset.{axis}", 0.0) for axis in AXES])
    if not yaw:
        return np.asarray(points + offset)
    c, s = np.cos(yaw), np.sin(yaw)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    return np.asarray(points @ turn.T + offset)


def rate(name: str, points: Array, values: Mapping[str, float]) -> Array:
    """Derivative of the true poses with respect to one of the parameters, (P, 3)."""
    if name != "measurement.yaw":
        return np.tile(np.eye(3)[AXES.index(name[-1])], (len(points), 1))
    turned = true_points(points, {"measurement.yaw": values.get("measurement.yaw", 0.0)})
    return np.stack([-turned[:, 1], turned[:, 0], np.zeros(len(points))], axis=1)
