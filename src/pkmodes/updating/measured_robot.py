"""A robot with the modes measured on it, checked once: coordinates, set values, and poses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from os import PathLike

import numpy as np

from pkmodes.core.base.errors import MeasurementError, PkmodesError, nearest, shown
from pkmodes.core.mechanism.registry import Mechanism, mechanism, names
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.arguments import check_measurements
from pkmodes.diagnosis.problem import Loss
from pkmodes.measured.header import OTHER_MACHINE, SPREAD, in_words, owners
from pkmodes.measured.measurements import Measurements
from pkmodes.measured.rules import SHAPE
from pkmodes.updating.candidates import suspects
from pkmodes.updating.load_cases import LoadCases, load_cases
from pkmodes.updating.losses import is_loss, losses_of, without_losses
from pkmodes.updating.poses import check_reachable
from pkmodes.updating.priors import with_priors
from pkmodes.updating.robot_structure import RobotStructure, channels
from pkmodes.updating.usual import of_frame


@dataclass(frozen=True, eq=False)
class MeasuredRobot:
    """A robot and measurements that it can have.

    Attributes
    ----------
    loads : LoadCases
        The robot with the values set at each pose, which it can reach.
    """

    robot: Robot
    data: Measurements
    loads: LoadCases

    @classmethod
    def of(cls, robot: Robot | Model, data: Measurements) -> MeasuredRobot:
        """Return a robot with its measurements.

        Raises
        ------
        PkmodesError
            If an argument is something else.
        MeasurementError
            If there are no measurements, the poses have other components than the mechanism's, a shape component is
            not a coordinate of the robot, a set value is refused, or a pose cannot be evaluated: for the first such
            pose, with the line of its first row.
        """
        robot = robot_of(robot)
        check_measurements(data, "pkmodes.updating.read(path)")
        names = tuple(component.name for component in robot.mechanism.pose)
        if data.components != names:
            what = f"expected poses with {in_words(names)}, found {in_words(data.components)}"
            raise MeasurementError(what, data.source, f"give the pose components of {robot.source}")
        known = channels(robot.mechanism)
        for name in data.channels:
            if name not in known:
                unknown = [f"{SHAPE}{one}" for one in data.channels if one not in known]
                if whose := owners(unknown, columns_of_others(robot.mechanism)):
                    what = f"{shown(f'{SHAPE}{name}')} is a column of another machine: {whose}"
                    raise MeasurementError(what, data.source, OTHER_MACHINE)
                what = f"{shown(name)} is not a coordinate of {robot.source}"
                raise MeasurementError(what, data.source, nearest(name, known))
        loads = load_cases(robot, data)
        check_reachable(robot, data, loads)
        return cls(robot, data, loads)

    def structure(
        self, candidates: Sequence[str] | None = None, priors: Mapping[str, float | str] | None = None
    ) -> RobotStructure:
        """Return the robot at the measured poses, with its nuisances and candidates, for the diagnosis.

        Raises
        ------
        PkmodesError
            If a candidate or the name of a prior is unknown, or a loss is suspected whose damping was not measured.
        """
        losses = self._losses(candidates)
        parameters, causes, moves = suspects(self.robot, without_losses(self.robot, candidates), self.loads)
        parameters = of_frame(parameters, self.data)
        if priors is not None:
            causes = with_priors(self.robot, parameters, causes, priors)
        return RobotStructure(self.robot, self.data.points, parameters, causes, moves, self.loads, losses)

    def _losses(self, chosen: Sequence[str] | None) -> tuple[Loss, ...]:
        """Return the losses to be diagnosed: none where no damping was measured."""
        if not np.isnan(self.data.damping).all():
            return losses_of(self.robot, chosen)
        asked = [] if chosen is None or isinstance(chosen, str) else chosen
        for name in asked:
            if is_loss(self.robot, name):
                what = f"no damping was measured, and {name} changes nothing else"
                raise PkmodesError(
                    what, "candidates", "leave it out, or add a column damping to the measurements"
                )
        return ()


def columns_of_others(own: Mechanism) -> dict[str, frozenset[str]]:
    """Return the shape and pose columns that measurements of each other known mechanism may have, by its name."""
    others = [mechanism(name) for name in names() if name != own.name]
    return {
        one.name: frozenset(
            [
                *(f"{SHAPE}{channel}" for channel in channels(one)),
                *(f"{prefix}{component.name}" for component in one.pose for prefix in ("", SPREAD)),
            ]
        )
        for one in others
    }


def robot_of(given: Robot | Model) -> Robot:
    """Return a robot, given as such or as a model."""
    if isinstance(given, Model):
        return given.robot
    if not isinstance(given, Robot):
        path = isinstance(given, str | PathLike)
        remedy = (
            f"read it: pkmodes.read_robot({shown(str(given))})" if path else "give what pkmodes.load returns"
        )
        raise PkmodesError(f"expected a robot or a model, found {shown(given)}", "robot", remedy)
    return given
