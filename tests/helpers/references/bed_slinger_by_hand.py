"""A bed slinger by hand: each axis is a slide and a rotor, with the two runs of a belt between them.

With the rotor's inertia J at the radius R, the slide of mass m and the rotor are two masses on one spring
k = w k_sp (1 / l_1 + 1 / l_2), so that omega^2 = k (1 / m + R^2 / J).
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import eigh

RADIUS, PULLEY, MOTOR = 6.366e-3, 2e-7, 5.7e-6
STIFFNESS = 6e-3 * 2.5e6
MASSES = (0.42, 0.85)
LENGTHS = ((0.09, 0.64), (0.07, 0.70))
SIGMA = 0.002

ROBOT = """\
format = 1
name = "bench-slinger"
mechanism = "bed_slinger"
gravity = ["0 m/s^2", "0 m/s^2", "-9.81 m/s^2"]
[toolhead]
mass = { value = "420 g", sigma = "1 %" }
[bed]
mass = { value = "850 g", sigma = "1 %" }
[belt]
specific_stiffness = { value = "2.5e6 N/m", sigma = "10 %" }
width = { value = "6 mm", sigma = 0 }
[pulley]
radius = { value = "6.366 mm", sigma = 0 }
inertia = { value = "2 g*cm^2", sigma = "5 %" }
[motor]
inertia = { value = "57 g*cm^2", sigma = "5 %" }
gear_ratio = { value = 1, sigma = 0 }
[workspace]
x = ["0 mm", "235 mm"]
y = ["0 mm", "235 mm"]
[[axis]]
lengths = ["90 mm", "640 mm"]
[[axis]]
lengths = ["70 mm", "700 mm"]
"""


@dataclass(frozen=True)
class Frame:
    """A frame that yields along an axis: mass [kg] and compliance [m/N]."""

    mass: float
    compliance: float


def frequencies(axis: int, position: float, *, factor: float = 0.0, frame: Frame | None = None) -> np.ndarray:
    """Vibration frequencies of an axis [Hz], ascending, with a relative change of its belt's stiffness.

    Coordinates are the slide relative to the frame, the belt at the rotor, and the frame, which carries both slides.
    """
    run, back = LENGTHS[axis]
    k = (1.0 + factor) * STIFFNESS * (1.0 / (run + position) + 1.0 / (back - position))
    m, rotor = MASSES[axis], (PULLEY + MOTOR) / RADIUS**2
    mass, stiffness = np.diag([m, rotor]), np.array([[k, -k], [-k, k]])
    if frame is not None:
        mass = np.array([[m, 0.0, m], [0.0, rotor, 0.0], [m, 0.0, sum(MASSES) + frame.mass]])
        stiffness = np.pad(stiffness, (0, 1))
        stiffness[2, 2] = 1.0 / frame.compliance
    values = eigh(stiffness, mass, eigvals_only=True)
    found: np.ndarray = np.sqrt(values[1:]) / (2.0 * np.pi)
    return found


def measured(
    poses: Sequence[tuple[float, float]],
    seed: int,
    *,
    factors: tuple[float, float] = (0.0, 0.0),
    frames: tuple[Frame | None, Frame | None] = (None, None),
) -> str:
    """A measurement file: every mode at every pose with its shape, and with relative errors of `SIGMA`."""
    rng, lines = np.random.default_rng(seed), ["pose,x,y,frequency,sigma,shape:p_x,shape:p_y"]
    for number, pose in enumerate(poses, start=1):
        for axis in (0, 1):
            for f in frequencies(axis, pose[axis], factor=factors[axis], frame=frames[axis]):
                heard = f * (1.0 + SIGMA * rng.standard_normal())
                shape = rng.normal((1 - axis, axis), 0.02)
                lines.append(
                    f"P{number},{pose[0]},{pose[1]},{heard},{SIGMA * f},{shape[0]:.4f},{shape[1]:.4f}"
                )
    return "\n".join(lines) + "\n"
