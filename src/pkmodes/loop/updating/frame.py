"""The measurement frame: measured poses that are shifted or rotated with respect to the robot's frame.

A wrong zero of the height, or a table that is not parallel to the machine, affects all poses equally.  The true pose
is the measured one, rotated about the base frame's z axis by the yaw and then shifted by the offset.  Offsets are
along the linear components of a pose; the yaw rotates the first two of them, which span the plane of a planar robot,
and a platform that turns about z.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.rotations import (
    AXES,
    left_jacobian,
    matrices_of_vectors,
    vectors_about,
    vectors_of_matrices,
)
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.loop.diagnosis.problem import Candidate, Parameter

Array = NDArray[np.float64]
#: Prefixes of the parameters of the measurement frame and of its candidates.
OF_MEASUREMENT, PREFIX = "measurement.", "measurement:"
YAW = f"{OF_MEASUREMENT}yaw"
#: The axis of the yaw.
Z = "z"
#: Prior standard deviations of the measurement frame, by unit.
PLAUSIBLE = {"m": 0.02, "rad": 0.035}


def parameters(mechanism: Mechanism) -> dict[str, str]:
    """Return the names of the parameters of the frame, and their units."""
    linear = _linear(mechanism)
    yaw = {YAW: "rad"} if len(linear) > 1 else {}
    return {_offset(mechanism, i): "m" for i in linear} | yaw


def suspects(mechanism: Mechanism) -> tuple[list[Parameter], list[Candidate]]:
    """Return the parameters of the frame, and their candidates."""
    named = parameters(mechanism)
    sentences = {
        _offset(mechanism, i): f"all poses are shifted along {mechanism.pose[i].name}"
        for i in _linear(mechanism)
    }
    sentences[YAW] = "the frame of the poses is rotated about z"
    candidates = [
        Candidate(name.replace(OF_MEASUREMENT, PREFIX), (name,), sentences[name], sigma=(PLAUSIBLE[unit],))
        for name, unit in named.items()
    ]
    return [Parameter(name, 0.0, unit) for name, unit in named.items()], candidates


def true_points(mechanism: Mechanism, points: Array, values: Mapping[str, float]) -> Array:
    """Return the poses with respect to the robot, (P, d)."""
    offset = np.array([values.get(_offset(mechanism, i), 0.0) for i in range(len(mechanism.pose))])
    yaw = values.get(YAW, 0.0)
    if not yaw:
        return np.asarray(points + offset)
    i, k = _linear(mechanism)[:2]
    turn = np.eye(len(mechanism.pose))
    turn[i, i] = turn[k, k] = np.cos(yaw)
    turn[k, i] = np.sin(yaw)
    turn[i, k] = -turn[k, i]
    true = np.asarray(points @ turn.T + offset)
    if Z in mechanism.rotations:
        turning = _turning(mechanism)
        about_z = matrices_of_vectors(vectors_about((Z,), np.array([yaw])))
        turned = vectors_of_matrices(
            about_z @ matrices_of_vectors(vectors_about(mechanism.rotations, points[:, turning]))
        )
        true[:, turning] = turned[:, _axes(mechanism)]
    return true


def rate(mechanism: Mechanism, name: str, points: Array, values: Mapping[str, float]) -> Array:
    """Return the derivative of the true poses with respect to one of the parameters, (P, d)."""
    rates = np.zeros(points.shape)
    if name != YAW:
        rates[:, [_offset(mechanism, i) for i in range(len(mechanism.pose))].index(name)] = 1.0
        return rates
    i, k = _linear(mechanism)[:2]
    turned = true_points(mechanism, points, {YAW: values.get(YAW, 0.0)})
    rates[:, i], rates[:, k] = -turned[:, k], turned[:, i]
    if Z in mechanism.rotations:
        turning, axes = _turning(mechanism), _axes(mechanism)
        inverse = np.linalg.inv(left_jacobian(vectors_about(mechanism.rotations, turned[:, turning])))
        rates[:, turning] = inverse[:, axes, AXES.index(Z)]
    return rates


def _linear(mechanism: Mechanism) -> list[int]:
    return [i for i, component in enumerate(mechanism.pose) if component.unit == "m"]


def _turning(mechanism: Mechanism) -> list[int]:
    """Return the components of a rotation vector in the pose."""
    names = [component.name for component in mechanism.pose]
    return [names.index(name) for name in mechanism.components[len(mechanism.directions) :]]


def _axes(mechanism: Mechanism) -> list[int]:
    return [AXES.index(axis) for axis in mechanism.rotations]


def _offset(mechanism: Mechanism, component: int) -> str:
    return f"{OF_MEASUREMENT}offset.{mechanism.pose[component].name}"
