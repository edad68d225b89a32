"""What responses and state space models of a robot have in common: poses, inputs and outputs."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.robot.robot import Robot
from pkmodes.solve.results import AtPoses


@dataclass(frozen=True, repr=False, eq=False)
class Channels(AtPoses):
    """Inputs and outputs of a robot at poses.

    Attributes
    ----------
    poses : ndarray, shape (..., d)
    inputs, outputs : tuple of str
    units : tuple of tuple of str
        Of each output (rows) per input (columns).
    quantity, drives : str
    robot : Robot
    """

    poses: NDArray[np.float64]
    inputs: tuple[str, ...]
    outputs: tuple[str, ...]
    units: tuple[tuple[str, ...], ...]
    quantity: str
    drives: str
    robot: Robot
