"""A linear delta without symmetry: oblique rails, axes that differ in every parameter, tilted gravity.

The checks evaluate this robot, in which no terms vanish or cancel as they do in a real one.
"""

from __future__ import annotations

DIRECTIONS = ((0.9, 0.2, 0.3), (-0.1, 0.8, 0.5), (0.3, -0.4, 0.9))

SAMPLE: dict[str, object] = {
    "platform_mass": 1.3,
    "gravity": [1.1, -2.3, -9.2],
    "origin": [[-0.7, 0.1, 0.2], [0.1, -0.6, -0.1], [-0.2, 0.3, -0.8]],
    "direction": [[c / sum(x * x for x in row) ** 0.5 for c in row] for row in DIRECTIONS],
    "joint": [[0.03, -0.02, 0.01], [-0.04, 0.03, -0.02], [0.02, 0.01, 0.05]],
    "link_length": [0.45, 0.5, 0.55],
    "link_mass": [0.4, 0.5, 0.6],
    "carriage_mass": [0.9, 1.0, 1.2],
    "carriage_length": [0.05, 0.06, 0.07],
    "belt_specific_stiffness": [2.2e6, 2.4e6, 2.6e6],
    "belt_width": [0.015, 0.02, 0.025],
    "pulley_radius": [0.03, 0.035, 0.04],
    "pulley_inertia": [1.1e-4, 1.3e-4, 1.5e-4],
    "motor_inertia": [1.5e-5, 1.7e-5, 1.9e-5],
    "gear_ratio": [8.0, 10.0, 12.0],
    "drive": [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0]],
    "limits": [[0.0, 1.4], [0.1, 1.5], [-0.1, 1.3]],
    "branch": [-1.0, -1.0, -1.0],
}
