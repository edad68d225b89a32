"""Minima and maxima of the natural frequencies along the centre line, the stated poses of the printed rows."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

import pkmodes
from pkmodes_generated import linear_delta
from printed import Array

#: Spacing of the poses along the line [m].
STEP = 0.0005


@dataclass(frozen=True)
class Extremes:
    """Extremes of the vibration modes 1 to 6 along a line.

    Attributes
    ----------
    poses : ndarray, shape (N, 3)
        Poses along the line.
    modes : Modes
        Modes at these poses.
    index : dict of (str, int) to int
        Index of the pose of each point (``minimum``, ``maximum``) and mode.
    frequency : dict of (str, int) to float
        [Hz].
    """

    poses: Array
    modes: pkmodes.Modes
    index: dict[tuple[str, int], int]
    frequency: dict[tuple[str, int], float]

    def relative(self, printed: dict[tuple[str, int], float]) -> Array:
        """Return the relative differences from printed frequencies."""
        return np.array([self.frequency[key] / value - 1.0 for key, value in printed.items()])


def centre_line(robot: pkmodes.Robot, z: float, shortest: float, step: float = STEP) -> Array:
    """Return the poses with y = 0 at which every free belt span has at least a given length [m]."""
    parameters = robot.parameters
    reach = parameters.link_length.max()
    x = np.arange(parameters.limits.min() - reach, parameters.limits.max() + reach, step)
    poses = np.column_stack([x, np.zeros_like(x), np.full_like(x, z)])
    with np.errstate(invalid="ignore"):  # out of reach a span is NaN, which fails the comparison
        spans = linear_delta.belt_spans(poses, parameters)
    return poses[(spans >= shortest).all(axis=(1, 2))]


def extremes(robot: pkmodes.Robot, poses: Array) -> Extremes:
    """Find the extremes among some poses."""
    modes = pkmodes.Model(robot).modes(poses)
    index, frequency = {}, {}
    for point, pick in (("minimum", np.argmin), ("maximum", np.argmax)):
        for mode in range(1, 7):
            along = modes.frequencies[:, modes.rigid_modes + mode - 1]
            index[point, mode] = int(pick(along))
            frequency[point, mode] = float(along[index[point, mode]])
    return Extremes(poses, modes, index, frequency)


def percent(relative: Array) -> tuple[float, float]:
    """Return the root mean square and the largest of relative differences, in percent."""
    return 100.0 * float(np.sqrt(np.mean(np.square(relative)))), 100.0 * float(np.abs(relative).max())
