"""What responses and state space models of a robot have in common: poses, inputs and outputs."""

from __future__ import annotations

import operator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import PkmodesError
from pkmodes.robot.robot import Robot
from pkmodes.solve.results import AtPoses

Index = tuple[int, ...] | int


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

    def one(self, index: Index) -> tuple[int, ...]:
        """Return the index of one pose that could be evaluated.

        Raises
        ------
        PkmodesError
            If it does not select one, or the pose could not be evaluated.
        """
        shape = self.poses.shape[:-1]
        chosen = index if isinstance(index, tuple) else (index,)
        try:
            where: tuple[int, ...] = tuple(operator.index(i) for i in chosen)
            found = self.poses[where] if len(where) == len(shape) else None
        except (TypeError, IndexError):
            found = None
        if found is None:
            what = f"expected the index of one of the poses, an array of shape {shape}, found {index!r}"
            raise PkmodesError(what, "index", "give one integer for each axis of the poses")
        if not self.valid[where]:
            what = f"the pose {where} could not be evaluated: {self.reason[where]}"
            raise PkmodesError(what, "index", "choose another pose")
        return where
