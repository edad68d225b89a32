"""A robot with the modes measured on it, checked once: coordinates, set values, poses, and priors of candidates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from decimal import Decimal
from os import PathLike
from typing import NoReturn

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import is_all
from pkmodes.core.base.errors import MeasurementError, PkmodesError, PoseError, nearest_name, shown
from pkmodes.core.mechanism.poses import LARGE_LENGTH, check_poses, format_pose
from pkmodes.core.mechanism.registry import Mechanism, mechanism, names
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.units import NUMBER, QuantityError, base_units, check_plain_number, likely_unit
from pkmodes.core.robot.usable import USABLE, read_usable
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.arguments import check_measurements
from pkmodes.loop.diagnosis.problem import Candidate, Loss, Parameter
from pkmodes.loop.measured.columns import Stated, merge_stated
from pkmodes.loop.measured.header import OTHER_MACHINE_REMEDY, SPREAD_PREFIX, owners
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.rules import SHAPE
from pkmodes.loop.updating.candidates import suspects
from pkmodes.loop.updating.channels import channels
from pkmodes.loop.updating.load_cases import LoadCases, columns_in_words, load_cases_of
from pkmodes.loop.updating.losses import is_loss, losses_of, without_losses
from pkmodes.loop.updating.robot_structure import RobotStructure
from pkmodes.loop.updating.robot_with_terms import ExtensibleRobot
from pkmodes.loop.updating.usual import with_frame_ranges

#: Factors for lengths in another unit than stated, and the remedy.
OTHER_LENGTHS = {
    1e-3: "the numbers look like millimetres: write {0} in the header",
    1e3: "the numbers look like metres, but the header says otherwise: write {1} there",
}


@dataclass(frozen=True, eq=False)
class MeasuredRobot:
    """A robot and measurements that it can have.

    - loads: the robot with the values set at each pose, which it can reach
    """

    robot: Robot
    data: Measurements
    loads: LoadCases

    @classmethod
    def of(cls, robot: Robot | Model, data: Measurements) -> MeasuredRobot:
        """Return a robot with its measurements.

        Raises PkmodesError if an argument is something else.
        Raises MeasurementError if there are no measurements, the poses have other components than the mechanism's, a
        shape component is not a coordinate of the robot, a set value is refused, or a pose cannot be evaluated: for
        the first such pose, with the line of its first row.
        """
        robot = robot_of(robot)
        check_measurements(data, "pkmodes.loop.updating.read(path)")
        names = tuple(component.name for component in robot.mechanism.pose)
        if data.components != names:
            problem = f"expected poses with {joined(names)}, found {joined(data.components)}"
            raise MeasurementError(problem, data.source, f"give the pose components of {robot.source}")
        known_channels = channels(robot.mechanism)
        for name in data.channels:
            if name not in known_channels:
                unknown = [f"{SHAPE}{channel}" for channel in data.channels if channel not in known_channels]
                if whose := owners(unknown, columns_of_others(robot.mechanism)):
                    problem = f"{shown(f'{SHAPE}{name}')} is a column of another machine: {whose}"
                    raise MeasurementError(problem, data.source, OTHER_MACHINE_REMEDY)
                problem = f"{shown(name)} is not a coordinate of {robot.source}"
                raise MeasurementError(problem, data.source, nearest_name(name, known_channels))
        loads = load_cases_of(robot, data)
        check_reachable(robot, data, loads)
        return cls(robot, data, loads)

    def where_usable(self) -> MeasuredRobot:
        """Return the robot with the limits of ``[usable]`` that the measurements state in place of those it declares.

        Raises MeasurementError if there is no such limit, or it is none.
        """
        stated = self.data.usable

        def refuse(path: str, what: str, remedy: str) -> NoReturn:
            name = path.removeprefix(f"{USABLE}.").partition(".")[0]
            raise MeasurementError(what, stated[name].where, remedy)

        raw = {name: statement.value for name, statement in stated.items()}
        limits = {**self.robot.usable, **read_usable(self.robot.mechanism, raw, refuse)}
        return replace(self, robot=Robot.of(replace(self.robot, usable=limits)))

    def structure(
        self, candidates: Sequence[str] | None = None, priors: Mapping[str, float | str] | None = None
    ) -> RobotStructure:
        """Return the robot at the measured poses, with its nuisances and candidates, for the diagnosis.

        Raises PkmodesError if a candidate or the name of a prior is unknown, or a loss is suspected whose damping was
        not measured.
        """
        candidates = None if is_all(candidates) else candidates
        losses: tuple[Loss, ...] = ()
        if not np.isnan(self.data.damping).all():
            losses = losses_of(self.robot, candidates)
        elif candidates is not None and not isinstance(candidates, str):
            for name in candidates:
                if is_loss(self.robot, name):
                    problem = f"no damping was measured, and {name} changes nothing else"
                    remedy = "leave it out, or add a column damping to the measurements"
                    raise PkmodesError(problem, "candidates", remedy)
        parameters, causes, paths = suspects(self.robot, without_losses(self.robot, candidates), self.loads)
        parameters = with_frame_ranges(parameters, self.data)
        cause_names = {cause.name for cause in causes}
        # Priors that the measurements state for candidates outside the choice are ignored.
        stated = {n: prior for n, prior in self.data.priors.items() if candidates is None or n in cause_names}
        causes = _with_priors(self.robot, parameters, causes, merge_stated(stated, priors or {}, "priors"))
        return ExtensibleRobot(self.robot, self.data.points, parameters, causes, paths, self.loads, losses)


def columns_of_others(excluded: Mechanism) -> dict[str, frozenset[str]]:
    """Return the shape and pose columns that measurements of every other mechanism may have, by its name."""
    machines = [mechanism(name) for name in names() if name != excluded.name]
    return {
        machine.name: frozenset(
            [
                *(f"{SHAPE}{channel}" for channel in channels(machine)),
                *(
                    f"{prefix}{component.name}"
                    for component in machine.pose
                    for prefix in ("", SPREAD_PREFIX)
                ),
            ]
        )
        for machine in machines
    }


def robot_of(robot: Robot | Model) -> Robot:
    """Return a robot from a robot or a model."""
    if isinstance(robot, Model):
        return robot.robot
    if not isinstance(robot, Robot):
        path = isinstance(robot, str | PathLike)
        remedy = (
            f"read it: pkmodes.read_robot({shown(str(robot))})" if path else "give what pkmodes.load returns"
        )
        raise PkmodesError(f"expected a robot or a model, found {shown(robot)}", "robot", remedy)
    return robot


def _with_priors(
    robot: Robot,
    parameters: Sequence[Parameter],
    candidates: Sequence[Candidate],
    priors: Mapping[str, Stated],
) -> list[Candidate]:
    """Return the candidates with priors, given by candidate name, each with its place for messages.

    Raises PkmodesError if there is no such candidate, or a prior is not a standard deviation of its parameters.
    """
    by_name = {parameter.name: parameter for parameter in parameters}
    with_sigma = {candidate.name: candidate for candidate in candidates}
    claimable = [candidate.name for candidate in candidates if candidate.claimable]
    for name, (prior, where) in priors.items():
        if name not in claimable:
            path = str(name).removeprefix("parameter:")
            quantity = robot.quantities.get(path)
            if quantity is not None and quantity.sigma is not None:
                state = "refitted anyway, within its sigma" if quantity.sigma else "known exactly"
                problem = f"{path} is not a candidate: the robot file gives a sigma, so it is {state}"
                raise PkmodesError(problem, where, "leave it out, or remove the sigma from the robot file")
            problem = f"there is no candidate {shown(name)} for a prior"
            raise PkmodesError(problem, where, nearest_name(name, claimable))
        sigmas = tuple(
            _deviation(prior, by_name[parameter], where) for parameter in with_sigma[name].parameters
        )
        with_sigma[name] = replace(with_sigma[name], sigma=sigmas)
    return list(with_sigma.values())


def _deviation(prior: float | str, parameter: Parameter, where: str) -> float:
    """Return a standard deviation in the unit of a parameter, from a number, text with a unit, or a percentage.

    Raises PkmodesError if it is not above 0.
    """
    example = f'"0.01 {parameter.unit}"' if parameter.unit != "1" else "0.01"
    remedy = f"write a number in {parameter.unit}, or text with a unit such as {example}"
    value = prior
    if isinstance(prior, str):
        number, unit = NUMBER.fullmatch(prior), ""
        if number is not None:
            value, unit = float(number[1]), number[2]
        try:
            check_plain_number(prior, f"a standard deviation in {parameter.unit}")
            if number is None or not unit:
                raise QuantityError(f"{shown(prior)} is not a number with a unit")
            if unit == "%":
                value = float(value) / 100.0 * abs(parameter.value)
            else:
                factor, powers = base_units(unit)
                parameter_factor, parameter_powers = base_units(parameter.unit)
                if powers != parameter_powers:
                    raise QuantityError(f"{shown(prior)} has the wrong dimension")
                value = float(Decimal(number[1]) * factor / parameter_factor)
        except QuantityError as error:
            problem, expected = str(error), f"expected a standard deviation in {parameter.unit}"
            problem = problem if problem.startswith(expected) else f"{expected}: {problem}"
            if number is not None and (suggested_unit := likely_unit(unit, parameter.unit)) is not None:
                remedy = f'write "{number[1]} {suggested_unit}"'
            raise PkmodesError(problem, where, error.remedy or remedy) from None
    if isinstance(value, bool) or not isinstance(value, int | float | np.integer | np.floating):
        raise PkmodesError(f"expected a standard deviation, found {shown(prior)}", where, remedy)
    if not 0.0 < value < np.inf:
        raise PkmodesError(f"expected a standard deviation above 0, found {shown(prior)}", where, remedy)
    return float(value)


def check_reachable(robot: Robot, data: Measurements, loads: LoadCases) -> None:
    """Refuse the first pose that cannot be evaluated, with the line of its first row.

    Raises MeasurementError.
    """
    valid = np.ones(len(data.points), dtype=bool)
    for c, case in enumerate(loads.cases):
        rows = np.flatnonzero(loads.case_index == c)
        valid[rows] = _is_reachable(case.robot, data.points[rows])
    if valid.all():
        return
    columns, first = f"columns {joined(data.components)}", int(np.argmin(valid))
    line = data.lines[int(np.argmax(data.pose == first))]
    where = f"{data.source}: line {line}, {columns}"
    if (unreachable_count := int((~valid).sum())) > 1:
        where += f", the first of {unreachable_count} bad poses"
    if not valid.any():
        _refuse_another_unit(robot, data, where)
    load, remedy = data.load(first), f"check the row and {robot.source}"
    if _is_reachable(robot, data.points[first]).all():  # as declared, the robot reaches it
        where, remedy = where.replace(columns, columns_in_words(load)), "check the set values"
    loaded = loads.cases[loads.case_index[first]].robot
    try:
        check_poses(data.points[first], robot.mechanism, loaded.parameters, "raise")
    except PoseError as error:
        label, position = shown(data.labels[first]), format_pose(robot.mechanism, data.points[first])
        set_values = " with the set values" if load else ""
        problem = f"pose {label} at {position} cannot be reached{set_values}: {error.what}"
        raise MeasurementError(problem, where, f"{error.remedy}; {remedy}") from None


def _refuse_another_unit(robot: Robot, data: Measurements, where: str) -> None:
    """Refuse poses that can all be reached with lengths in another unit than stated."""
    lengths = [component.unit == "m" for component in robot.mechanism.pose]
    is_large = np.abs(data.points[:, lengths]).max(initial=0.0) >= LARGE_LENGTH
    for factor, remedy in OTHER_LENGTHS.items():
        scaled = data.points * np.where(lengths, factor, 1.0)
        if (factor > 1.0 or is_large) and _is_reachable(robot, scaled).all():
            columns = ",".join(
                f"{name} [mm]" if length else name
                for name, length in zip(data.components, lengths, strict=True)
            )
            problem = f"no pose can be reached, but all can if multiplied by {factor:g}"
            raise MeasurementError(problem, where, remedy.format(columns, ",".join(data.components)))


def _is_reachable(robot: Robot, points: NDArray[np.float64]) -> NDArray[np.bool_]:
    return check_poses(points, robot.mechanism, robot.parameters, "nan").valid
