"""A hexapod without symmetry: legs that differ in every parameter, products of inertia, tilted gravity.

The checks evaluate this robot, in which no terms vanish or cancel as they do in a real one.
"""

from __future__ import annotations

SAMPLE: dict[str, object] = {
    "platform_mass": 1.7,
    "platform_center": [0.012, -0.007, 0.021],
    "platform_inertia": [3.1e-3, 2.6e-3, 4.4e-3],
    "platform_products": [2.1e-4, -3.3e-4, 1.7e-4],
    "gravity": [1.1, -2.3, -9.2],
    "base": [
        [0.21, -0.05, 0.01],
        [0.19, 0.07, -0.02],
        [-0.06, 0.22, 0.0],
        [-0.15, 0.17, 0.015],
        [-0.16, -0.14, -0.01],
        [-0.04, -0.2, 0.02],
    ],
    "joint": [
        [0.06, -0.09, -0.015],
        [0.11, 0.01, -0.02],
        [0.05, 0.1, -0.01],
        [-0.05, 0.09, -0.018],
        [-0.11, -0.01, -0.012],
        [-0.06, -0.1, -0.016],
    ],
    "limits": [[0.15, 0.45], [0.16, 0.46], [0.14, 0.44], [0.15, 0.47], [0.17, 0.48], [0.15, 0.45]],
    "leg_stiffness": [1.9e7, 2.1e7, 2.3e7, 1.8e7, 2.0e7, 2.2e7],
    "leg_base_mass": [0.21, 0.23, 0.19, 0.22, 0.24, 0.2],
    "leg_base_center": [0.05, 0.06, 0.045, 0.055, 0.052, 0.048],
    "leg_base_inertia": [2.1e-4, 2.4e-4, 1.9e-4, 2.2e-4, 2.5e-4, 2.0e-4],
    "leg_rod_mass": [0.11, 0.13, 0.12, 0.1, 0.14, 0.115],
    "leg_rod_center": [0.07, 0.06, 0.065, 0.072, 0.068, 0.066],
    "leg_rod_inertia": [1.6e-4, 1.4e-4, 1.5e-4, 1.7e-4, 1.3e-4, 1.45e-4],
    "motor_inertia": [1.1e-5, 1.3e-5, 1.2e-5, 1.0e-5, 1.4e-5, 1.15e-5],
    "motor_travel": [8e-4, 9e-4, 8.5e-4, 7.5e-4, 8.2e-4, 8.8e-4],
}
