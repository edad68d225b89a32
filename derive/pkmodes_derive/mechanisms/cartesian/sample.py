"""A Cartesian gantry without symmetry: its belts differ in every parameter, and its plane is not level.

The checks evaluate this machine, in which no terms vanish or cancel as they do in a real one.
"""

from __future__ import annotations

SAMPLE: dict[str, object] = {
    "toolhead_mass": 0.5,
    "beam_mass": 0.9,
    "gravity": [1.2, -2.1, -9.3],
    "axis_lengths": [[0.13, 0.82], [0.19, 0.77]],
    "belt_specific_stiffness": [2.6e6, 2.3e6],
    "belt_width": [0.006, 0.009],
    "pulley_radius": [0.00637, 0.0075],
    "pulley_inertia": [2e-7, 3e-7],
    "motor_inertia": [5.4e-6, 6.1e-6],
    "gear_ratio": [1.0, 1.5],
    "workspace": [[0.0, 0.3], [0.01, 0.31]],
}
