"""What responses and state space models of a robot have in common: poses, inputs and outputs, and python-control."""

from __future__ import annotations

import operator
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import check_argument, one_of
from pkmodes.core.base.drives import checked_drives
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.poses import CheckedPoses
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.results import AtPoses
from pkmodes.core.support.extras import require
from pkmodes.machine.response.ports import QUANTITIES, Output, Port, inputs_of, outputs_of, units_of

Index = tuple[int, ...] | int


@dataclass(frozen=True, repr=False, eq=False)
class Channels(AtPoses):
    """Inputs and outputs of a robot at poses.

    Attributes
    ----------
    poses : ndarray, shape (..., d)
    inputs, outputs : tuple of str
    units : tuple of tuple of str
        Units of each output (rows) per input (columns).
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
        indices = index if isinstance(index, tuple) else (index,)
        try:
            pose_index: tuple[int, ...] = tuple(operator.index(i) for i in indices)
            pose = self.poses[pose_index] if len(pose_index) == len(shape) else None
        except (TypeError, IndexError):
            pose = None
        if pose is None:
            problem = f"expected the index of one of the poses, an array of shape {shape}, found {index!r}"
            raise PkmodesError(problem, "index", "give one integer for each axis of the poses")
        if not self.valid[pose_index]:
            problem = f"the pose {pose_index} could not be evaluated: {self.reason[pose_index]}"
            raise PkmodesError(problem, "index", "choose another pose")
        return pose_index


def control_library() -> Any:
    """Return python-control.

    Raises MissingExtraError if it is not installed.
    """
    require("systems for python-control", "control", "control")
    import control

    return control


@dataclass(frozen=True)
class ResponseRequest:
    """What is requested of a robot: a quantity of some outputs per some inputs."""

    model: Model
    inputs: tuple[Port, ...]
    outputs: tuple[Port, ...]
    quantity: str
    drives: str

    @classmethod
    def of(
        cls, model: Model, inputs: Sequence[str], outputs: Sequence[Output], quantity: str, drives: str
    ) -> ResponseRequest:
        """Return what is requested by name.

        Raises PkmodesError if a name is unknown, or a port is not one with these drives.
        """
        checked_drives(drives)
        check_argument(quantity, one_of(QUANTITIES), "quantity", 'for example: "acceleration"')
        input_ports, output_ports = inputs_of(model, inputs, drives), outputs_of(model, outputs)
        return cls(model, input_ports, output_ports, quantity, drives)

    def fields(self, checked: CheckedPoses) -> dict[str, Any]:
        """Return the fields of `Channels` at poses."""
        return {
            "codes": checked.codes.reshape(checked.batch),
            "known": checked.reasons,
            "poses": checked.points.reshape((*checked.batch, -1)),
            "inputs": tuple(port.name for port in self.inputs),
            "outputs": tuple(port.name for port in self.outputs),
            "units": units_of(self.inputs, self.outputs, self.quantity),
            "quantity": self.quantity,
            "drives": self.drives,
            "robot": self.model.robot,
        }
