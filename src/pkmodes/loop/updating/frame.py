"""The measurement frame: measured poses may be shifted or rotated with respect to the robot's frame.

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
PRIOR_SIGMAS = {"m": 0.02, "rad": 0.035}


def parameters(mechanism: Mechanism) -> dict[str, str]:
    """Return the names of the parameters of the frame, and their units."""
    linear = _linear_components(mechanism)
    yaw = {YAW: "rad"} if len(linear) > 1 else {}
    return {_offset_name(mechanism, i): "m" for i in linear} | yaw


def suspects(mechanism: Mechanism) -> tuple[list[Parameter], list[Candidate]]:
    """Return the parameters of the frame, and their candidates."""
    named = parameters(mechanism)
    sentences = {
        _offset_name(mechanism, i): f"all poses are shifted along {mechanism.pose[i].name}"
        for i in _linear_components(mechanism)
    }
    sentences[YAW] = "the frame of the poses is rotated about z"
    candidates = [
        Candidate(name.replace(OF_MEASUREMENT, PREFIX), (name,), sentences[name], sigma=(PRIOR_SIGMAS[unit],))
        for name, unit in named.items()
    ]
    return [Parameter(name, 0.0, unit) for name, unit in named.items()], candidates


def true_points(mechanism: Mechanism, points: Array, values: Mapping[str, float]) -> Array:
    """Return the poses with respect to the robot, (P, d)."""
    offset = np.array([values.get(_offset_name(mechanism, i), 0.0) for i in range(len(mechanism.pose))])
    yaw = values.get(YAW, 0.0)
    if not yaw:
        return np.asarray(points + offset)
    i, k = _linear_components(mechanism)[:2]
    rotation = np.eye(len(mechanism.pose))
    rotation[i, i] = rotation[k, k] = np.cos(yaw)
    rotation[k, i] = np.sin(yaw)
    rotation[i, k] = -rotation[k, i]
    true_poses = np.asarray(points @ rotation.T + offset)
    if Z in mechanism.rotations:
        rotation_components = _rotation_components(mechanism)
        about_z = matrices_of_vectors(vectors_about((Z,), np.array([yaw])))
        rotated_vectors = vectors_of_matrices(
            about_z @ matrices_of_vectors(vectors_about(mechanism.rotations, points[:, rotation_components]))
        )
        true_poses[:, rotation_components] = rotated_vectors[:, _rotation_axes(mechanism)]
    return true_poses


def pose_rates(mechanism: Mechanism, name: str, points: Array, values: Mapping[str, float]) -> Array:
    """Return the derivative of the true poses with respect to one of the parameters, (P, d)."""
    rates = np.zeros(points.shape)
    if name != YAW:
        rates[:, [_offset_name(mechanism, i) for i in range(len(mechanism.pose))].index(name)] = 1.0
        return rates
    i, k = _linear_components(mechanism)[:2]
    rotated = true_points(mechanism, points, {YAW: values.get(YAW, 0.0)})
    rates[:, i], rates[:, k] = -rotated[:, k], rotated[:, i]
    if Z in mechanism.rotations:
        rotation_components, rotation_axes = _rotation_components(mechanism), _rotation_axes(mechanism)
        inverse = np.linalg.inv(
            left_jacobian(vectors_about(mechanism.rotations, rotated[:, rotation_components]))
        )
        rates[:, rotation_components] = inverse[:, rotation_axes, AXES.index(Z)]
    return rates


def _linear_components(mechanism: Mechanism) -> list[int]:
    return [i for i, component in enumerate(mechanism.pose) if component.unit == "m"]


def _rotation_components(mechanism: Mechanism) -> list[int]:
    """Return the components of a rotation vector in the pose."""
    names = [component.name for component in mechanism.pose]
    return [names.index(name) for name in mechanism.components[len(mechanism.directions) :]]


def _rotation_axes(mechanism: Mechanism) -> list[int]:
    return [AXES.index(axis) for axis in mechanism.rotations]


def _offset_name(mechanism: Mechanism, component: int) -> str:
    return f"{OF_MEASUREMENT}offset.{mechanism.pose[component].name}"
