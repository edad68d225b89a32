"""A rotary delta without symmetry: oblique axes that differ in every parameter, tilted gravity.

The checks evaluate this robot, in which no terms vanish or cancel as they do in a real one.
"""

from __future__ import annotations

from math import sqrt

AXES = ((0.1, -0.95, 0.15), (0.8, 0.55, -0.1), (-0.75, 0.6, 0.2))
#: Directions at zero before they are made perpendicular to their axes.
OUTWARD = ((1.0, 0.1, -0.05), (-0.5, 0.85, 0.1), (-0.55, -0.8, 0.05))


def _unit(v: tuple[float, ...]) -> list[float]:
    length = sqrt(sum(c * c for c in v))
    return [c / length for c in v]


def _perpendicular(v: tuple[float, ...], axis: list[float]) -> list[float]:
    component = sum(a * b for a, b in zip(v, axis, strict=True))
    return _unit(tuple(a - component * b for a, b in zip(v, axis, strict=True)))


ROTATION = [_unit(axis) for axis in AXES]

SAMPLE: dict[str, object] = {
    "platform_mass": 0.3,
    "gravity": [1.1, -2.3, -9.2],
    "origin": [[0.11, 0.01, 0.02], [-0.06, 0.1, -0.01], [-0.05, -0.09, 0.0]],
    "axis": ROTATION,
    "zero": [_perpendicular(v, axis) for v, axis in zip(OUTWARD, ROTATION, strict=True)],
    "joint": [[0.04, 0.005, 0.003], [-0.02, 0.035, -0.004], [-0.018, -0.03, 0.006]],
    "arm_length": [0.24, 0.25, 0.23],
    "arm_mass": [0.35, 0.4, 0.3],
    "arm_center": [0.09, 0.1, 0.08],
    "arm_inertia": [0.008, 0.009, 0.007],
    "link_length": [0.6, 0.62, 0.59],
    "link_mass": [0.16, 0.18, 0.15],
    "reducer_stiffness": [4000.0, 4400.0, 3700.0],
    "motor_inertia": [6e-5, 6.5e-5, 5.5e-5],
    "gear_ratio": [33.0, 30.0, 35.0],
    "limits": [[-1.7, 1.6], [-1.6, 1.7], [-1.8, 1.6]],
    "branch": [1.0, 1.0, 1.0],
}
