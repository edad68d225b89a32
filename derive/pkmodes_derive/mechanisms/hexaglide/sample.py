"""A hexaglide without symmetry: oblique rails, axes that differ in every parameter, tilted gravity.

The checks evaluate this robot, in which no terms vanish or cancel as they do in a real one.
"""

from __future__ import annotations

DIRECTIONS = (
    (0.1, 0.05, 0.99),
    (-0.08, 0.1, 0.98),
    (0.06, -0.12, 0.97),
    (0.12, 0.07, 0.96),
    (-0.1, -0.06, 0.95),
    (0.04, 0.11, 1.0),
)

SAMPLE: dict[str, object] = {
    "platform_mass": 1.7,
    "platform_center": [0.012, -0.007, 0.021],
    "platform_inertia": [3.1e-3, 2.6e-3, 4.4e-3],
    "platform_products": [2.1e-4, -3.3e-4, 1.7e-4],
    "gravity": [1.1, -2.3, -9.2],
    "origin": [
        [0.46, -0.11, 0.01],
        [0.44, 0.13, -0.02],
        [-0.12, 0.47, 0.0],
        [-0.34, 0.35, 0.015],
        [-0.33, -0.32, -0.01],
        [-0.1, -0.45, 0.02],
    ],
    "direction": [[c / sum(x * x for x in row) ** 0.5 for c in row] for row in DIRECTIONS],
    "joint": [
        [0.06, -0.09, -0.015],
        [0.11, 0.01, -0.02],
        [0.05, 0.1, -0.01],
        [-0.05, 0.09, -0.018],
        [-0.11, -0.01, -0.012],
        [-0.06, -0.1, -0.016],
    ],
    "link_length": [0.61, 0.62, 0.6, 0.63, 0.64, 0.615],
    "link_mass": [0.2, 0.25, 0.22, 0.24, 0.21, 0.23],
    "carriage_mass": [0.9, 1.0, 1.2, 1.1, 0.95, 1.05],
    "carriage_length": [0.05, 0.06, 0.07, 0.055, 0.065, 0.06],
    "belt_specific_stiffness": [2.2e6, 2.4e6, 2.6e6, 2.3e6, 2.5e6, 2.45e6],
    "belt_width": [0.015, 0.02, 0.025, 0.016, 0.02, 0.018],
    "pulley_radius": [0.03, 0.035, 0.04, 0.032, 0.036, 0.034],
    "pulley_inertia": [1.1e-4, 1.3e-4, 1.5e-4, 1.2e-4, 1.4e-4, 1.25e-4],
    "motor_inertia": [1.5e-5, 1.7e-5, 1.9e-5, 1.6e-5, 1.8e-5, 1.55e-5],
    "gear_ratio": [8.0, 10.0, 12.0, 9.0, 11.0, 10.0],
    "drive": [[1.0, 0.0], [0.0, 1.0], [0.0, 1.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    "limits": [[-0.9, 1.4], [-0.8, 1.5], [-0.9, 1.3], [-0.85, 1.4], [-0.9, 1.45], [-0.8, 1.35]],
    "branch": [1.0, 1.0, 1.0, 1.0, 1.0, 1.0],
}
