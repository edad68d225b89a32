"""A robot at measured poses, as a structure for the diagnosis."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import HELD
from pkmodes.core.mechanism.poses import MAX_CONDITION, check_poses
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import field_keys
from pkmodes.core.mechanism.rods import rods_of, singular_angles
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import SingularAngle, singular_angle_text
from pkmodes.core.robot.usable_poses import bounding_box, within_limits
from pkmodes.core.support.motors import motors_give_way
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.core.system.motors import motor_effects_among, motor_springs_among
from pkmodes.loop.diagnosis.problem import Batch, Candidate, Loss, Parameter, Prediction, Sensor
from pkmodes.loop.sensitivity.locked import locked_joints
from pkmodes.loop.sensitivity.matrices import POSE
from pkmodes.loop.sensitivity.paths import ParameterPath, change_quantities
from pkmodes.loop.updating import frame
from pkmodes.loop.updating.candidates import EFFECTS
from pkmodes.loop.updating.channels import channels, sensors
from pkmodes.loop.updating.load_cases import LoadCase, LoadCases, payloads
from pkmodes.loop.updating.losses import rates_of_losses
from pkmodes.loop.updating.predictions import Motions, SolvedRobots, join_modes, predict_along, solve_together

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Number of poses drawn around the measured ones for the next measurement, and the random seed.
DRAWS, SEED = 400, 7
#: Smallest angle of a rod to its singular direction at a proposed pose [rad].
MIN_ROD_ANGLE = float(np.radians(10.0))
#: Kinds of keys of the robot file that define a location or orientation, regardless of their dimension.
GEOMETRY_KINDS = ("direction", "choice", "signs", "pair")


class Machines(NamedTuple):
    """The robots of all load cases with one set of values, the system of each, and all poses."""

    robots: list[Robot]
    systems: list[ExtendedSystem]
    points: Array


class _SolvedSetups(NamedTuple):
    """Modes at some setups, for B robots of load cases that can be evaluated together."""

    rows: Index
    owners: list[int]
    modes: SolvedRobots


class RobotStructure:
    """A robot at P platform poses.

    - points: poses, (P, d)
    - parameters, candidates, parameter_paths: from `pkmodes.loop.updating.candidates.suspects`; parameters of the
      measurement frame have no path
    - loads: values set at the poses; by default none
    - losses: from `pkmodes.loop.updating.losses.losses_of`; empty if damping is not to be diagnosed
    """

    def __init__(
        self,
        robot: Robot,
        points: Array,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
        parameter_paths: Mapping[str, ParameterPath],
        loads: LoadCases | None = None,
        losses: Sequence[Loss] = (),
    ) -> None:
        self.robot, self.points = robot, np.asarray(points, dtype=float)
        self.parameters: tuple[Parameter, ...] = tuple(parameters)
        self.candidates: tuple[Candidate, ...] = tuple(candidates)
        self.losses: tuple[Loss, ...] = tuple(losses)
        self._mechanism = robot.mechanism
        self.motor_effects = motor_effects_among(self._mechanism, [c.name for c in self.candidates])
        units = channels(self._mechanism)
        self.channels, self.channel_units = tuple(units), tuple(units.values())
        self.shifts = tuple(
            ParameterPath(f"{POSE}.{component.name}", 0.0, component.unit, {(POSE, (i,)): 1.0})
            for i, component in enumerate(self._mechanism.pose)
        )
        self._path_of = dict(parameter_paths)
        self.loads = LoadCases.as_declared(robot, len(self.points)) if loads is None else loads
        self._free_paths = [
            {name: case.reduced(path) for name, path in self._path_of.items()} for case in self.loads.cases
        ]
        self._cached_modes: tuple[bytes, list[_SolvedSetups]] | None = None
        self._cached_prediction: tuple[object, Prediction] | None = None

    def __getstate__(self) -> dict[str, object]:
        # The last modes hold their solver, which cannot be pickled.
        return {**self.__dict__, "_cached_modes": None, "_cached_prediction": None}

    @property
    def sensors(self) -> tuple[Sensor, ...]:
        """Channels that are axes of one sensor."""
        return sensors(self._mechanism)

    @property
    def settings(self) -> tuple[str, ...]:
        """Paths of the values set at some of the poses."""
        return self.loads.settings

    def at(self, points: Array, loads: LoadCases | None = None) -> RobotStructure:
        """Return the same robot at other poses, as declared, or with load cases."""
        suspects = self.parameters, self.candidates, self._path_of
        return type(self)(self.robot, points, *suspects, loads, self.losses)

    def extended(
        self,
        parameters: Sequence[Parameter],
        parameter_paths: Mapping[str, ParameterPath],
        candidates: Sequence[Candidate],
    ) -> RobotStructure:
        """Return the same robot with further parameters, the path of each, and other candidates."""
        arguments = (*self.parameters, *parameters), candidates, {**self._path_of, **parameter_paths}
        return type(self)(self.robot, self.points, *arguments, self.loads, self.losses)

    def subset(self, setups: Sequence[int]) -> RobotStructure:
        """Return the same robot at some of its poses."""
        return self.at(self.points[list(setups)], self.loads.subset(setups))

    @property
    def drives(self) -> str:
        """What the motors do, at most of the poses."""
        return self.loads.usual_drives

    def with_other_drives(self, setups: Sequence[int]) -> RobotStructure:
        """Return the robot at the same poses, with motors free instead of held, or held instead of free, in some."""
        return self.at(self.points, self.loads.with_other_drives(setups))

    def may_be_held(self, causes: Collection[str]) -> bool:
        """Return whether a measurement with held motors may be proposed: motors that give way only if some were."""
        held = any(self.loads.cases[c].drives == HELD for c in set(self.loads.case_index.tolist()))
        return held or not (motors_give_way(self.robot) or motor_springs_among(self._mechanism, causes))

    def loaded(self) -> list[tuple[dict[str, float], RobotStructure]]:
        """Return payloads (values by path), each with the robot at its poses under it."""
        case_index = np.zeros(len(self.points), dtype=np.intp)
        cases = [
            (load, LoadCase.of(self.robot, load, self.drives)) for load in payloads(self.robot, self.points)
        ]
        return [
            (load, self.at(self.points, LoadCases(tuple(load), (case,), case_index))) for load, case in cases
        ]

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")  # a fit may try impossible values
    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to some of the parameters."""
        request = values.tobytes(), tuple(by), shape_rates
        # A fit evaluates the same values more than once.
        if self._cached_prediction is not None and self._cached_prediction[0] == request:
            return self._cached_prediction[1]
        parts = []
        for part in self._at_values(values):
            motions = self.motions_of(values, by, part.rows, part.owners)
            parts.append((part.rows, predict_along(part.modes, motions, shape_rates)))
        prediction = join_modes(parts, len(self.points))
        if by:
            self._cached_prediction = request, prediction
        return prediction

    @np.errstate(over="ignore", invalid="ignore", divide="ignore")  # a fit may try impossible values
    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Return the modes at all poses for several sets of values; sets that differ only in numbers form one batch.

        Sets that also differ in locked joints or in reachable poses are evaluated separately.
        """
        machines = [self.machines(v) for v in values]
        groups: dict[object, list[int]] = {}
        for k, (machine, indices) in enumerate(zip(machines, by, strict=True)):
            paths = self._paths(indices)
            is_separate = any(locked_joints(machine.systems[c], paths[c]).paths for c in paths)
            key = k if is_separate else tuple(map(self._evaluation_key, machine.systems))
            groups.setdefault(key, []).append(k)
        all_poses = np.ones(len(self.points), dtype=bool)
        count, batches = len(self.points), []
        for members in groups.values():
            blocks = self._blocks(machines[members[0]], all_poses)
            batch = members if len(members) > 1 else []
            parts = _solved_blocks([machines[k] for k in batch], blocks, checked=False)
            if parts is None:
                batch = [k for k in batch if self.reachable(machines[k]).all()]
                parts = _solved_blocks([machines[k] for k in batch], blocks, checked=True)
            if parts is None or not all(np.isfinite(part.eigenvalues).all() for part in parts):
                batch = []
            for k in (k for k in members if k not in batch):
                batches.append(Batch(np.array([k]), self.predict(values[k], by[k], shape_rates=shape_rates)))
            if batch:
                assert parts is not None
                first_rows = count * np.arange(len(batch))[:, None]
                predictions = []
                for part, (rows, owners) in zip(parts, blocks, strict=True):
                    motions = [m for k in batch for m in self.motions_of(values[k], by[k], rows, owners)]
                    prediction = predict_along(part, motions, shape_rates)
                    predictions.append(((first_rows + rows).ravel(), prediction))
                batches.append(Batch(np.array(batch), join_modes(predictions, count * len(batch))))
        return batches

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> Prediction:
        """Return the modes at all poses, with derivatives with respect to the platform's position."""
        parts = []
        for part in self._at_values(values):
            motions = [Motions(self.shifts, None)] * len(part.owners)
            parts.append((part.rows, predict_along(part.modes, motions, shape_rates)))
        return join_modes(parts, len(self.points))

    def damping_rates(self, values: Array) -> Array:
        """Return the damping ratio of each elastic mode per unit of each loss, (P, m, losses).

        NaN where a pose has fewer modes, or the measurements set the loss.
        """
        prediction = self.predict(values, ())
        count = prediction.eigenvalues.shape[1] - prediction.rigid
        rates = np.full((len(self.points), count, len(self.losses)), np.nan)
        for part in self._at_values(values):
            elastic = rates_of_losses(part.modes, self.losses)[:, part.modes.system.rigid_modes :]
            rates[part.rows, : elastic.shape[1]] = elastic
        for c, case in enumerate(self.loads.cases):
            set_losses = [
                case.is_set((loss.parameter.name.removeprefix(EFFECTS), ())) for loss in self.losses
            ]
            setups = self.loads.case_index == c
            rates[np.ix_(setups, np.arange(count), np.array(set_losses, dtype=bool))] = np.nan
        return rates

    @property
    def surroundings(self) -> str:
        """What `elsewhere` offers, in words."""
        limits = ["are within [usable]"] if self.robot.usable else []
        limits += [f"have {singular_angle_text(self._min_rod_angle)}"] if rods_of(self._mechanism) else []
        return "reachable poses around the measured ones" + (
            f" that {' and '.join(limits)}" if limits else ""
        )

    @property
    def _min_rod_angle(self) -> float:
        """Least angle of a rod to its singular direction at a proposed pose [rad]."""
        stated = [bound.value for bound in self.robot.usable.values() if isinstance(bound, SingularAngle)]
        return max([MIN_ROD_ANGLE, *stated])

    def elsewhere(self, count: int) -> tuple[Array, RobotStructure]:
        """Return reachable poses in and around the measured ones, and the robot there, as declared.

        They are within the usable limits of the robot; near a limit, if all measured poses are beyond it.  No rod is
        near its singular direction, where frequencies depend strongly on how exactly a pose is reached.  The motors
        do what they mostly did.
        """
        rng = np.random.default_rng(SEED)
        low, high = self.points.min(axis=0), self.points.max(axis=0)
        margin = 0.25 * max(float((high - low).max()), 0.1)
        lowest, highest = bounding_box(self._mechanism, self.robot.usable)
        low, high = np.clip(low - margin, lowest, highest), np.clip(high + margin, lowest, highest)
        low = np.where(low == high, np.maximum(low - margin, lowest), low)
        high = np.where(high == lowest, np.minimum(high + margin, highest), high)
        poses = rng.uniform(low, high, (DRAWS, len(low)))
        check = check_poses(poses, self._mechanism, self.robot.parameters, "nan", MAX_CONDITION / 1e5)
        poses = poses[check.valid]
        angles = singular_angles(self._mechanism, self.robot.parameters, poses)
        poses = poses[within_limits(self.robot, poses) & (angles >= self._min_rod_angle).all(axis=-1)][:count]
        return poses, self.at(poses, LoadCases.as_declared(self.robot, len(poses), self.drives))

    def motions_of(
        self, values: Array, by: Sequence[int], rows: Index, owners: Sequence[int]
    ) -> list[Motions]:
        """Return the motions of some parameters in the robots of some cases, each at an equal number of setups."""
        names, paths = [self.parameters[i].name for i in by], self._paths(by)
        robot_names = [name for name in names if name in self._path_of]
        if len(robot_names) == len(names):
            return [Motions(paths[c], None) for c in owners]
        # A parameter of the frame moves all poses, each according to its distance from the frame's origin.
        column_of = {name: k for k, name in enumerate(robot_names)}
        motions = np.zeros((len(self.points), len(robot_names) + len(self.shifts), len(by)))
        for column, name in enumerate(names):
            if name in column_of:
                motions[:, column_of[name], column] = 1.0
            else:
                motions[:, len(robot_names) :, column] = frame.pose_rates(
                    self._mechanism, name, self.points, self._frame_values(values)
                )
        with_shifts = {c: (*case_paths, *self.shifts) for c, case_paths in paths.items()}
        blocks = rows.reshape(len(owners), -1)
        return [Motions(with_shifts[c], motions[block]) for c, block in zip(owners, blocks, strict=True)]

    def _paths(self, by: Sequence[int]) -> dict[int, tuple[ParameterPath, ...]]:
        """Return the paths of some parameters of the robot in each load case."""
        names = [self.parameters[i].name for i in by]
        return {
            c: tuple(free_paths[name] for name in names if name in self._path_of)
            for c, free_paths in enumerate(self._free_paths)
        }

    def _frame_values(self, values: Array) -> dict[str, float]:
        """Return the values of the parameters of the measurement frame."""
        pairs = zip(self.parameters, values, strict=True)
        return {p.name: float(value) for p, value in pairs if p.name not in self._path_of}

    def machines(self, values: Array) -> Machines:
        """Return the robot of each load case with these values of the parameters."""
        changed = [
            (p.name, value - self._path_of[p.name].value)
            for p, value in zip(self.parameters, values, strict=True)
            if p.name in self._path_of and value != self._path_of[p.name].value
        ]
        cases = self.loads.cases
        robots = [
            change_quantities(case.robot, [(free_paths[name], step) for name, step in changed])
            for case, free_paths in zip(cases, self._free_paths, strict=True)
        ]
        systems = [case.system(robot) for case, robot in zip(cases, robots, strict=True)]
        true_points = frame.true_points(self._mechanism, self.points, self._frame_values(values))
        return Machines(robots, systems, true_points)

    def _at_values(self, values: Array) -> list[_SolvedSetups]:
        """Return the modes for one set of values; robots that can be are evaluated together."""
        key = values.tobytes()
        # Derivatives are mostly requested where the modes are known.
        if self._cached_modes is None or self._cached_modes[0] != key:
            machines = self.machines(values)
            blocks = self._blocks(machines, np.ones(len(self.points), dtype=bool))
            parts = _solved_blocks([machines], blocks, checked=False)
            if parts is None:
                blocks = self._blocks(machines, self.reachable(machines))
                parts = _solved_blocks([machines], blocks, checked=True)
            assert parts is not None
            solved = [_SolvedSetups(*block, part) for block, part in zip(blocks, parts, strict=True)]
            self._cached_modes = key, solved
        return self._cached_modes[1]

    def _blocks(self, machines: Machines, valid: NDArray[np.bool_]) -> list[tuple[Index, list[int]]]:
        """Return the valid setups of the cases that can be evaluated together, with the cases in their order."""
        cases_by_key: dict[object, list[int]] = {}
        for c, system in enumerate(machines.systems):
            cases_by_key.setdefault(self._evaluation_key(system), []).append(c)
        return [self.loads.setup_blocks(cases, valid) for cases in cases_by_key.values()]

    def _evaluation_key(self, system: ExtendedSystem) -> object:
        """Return a key that is the same for robots that can be evaluated together."""
        has_several_cases = len(self.loads.cases) > 1 and len(system.free) > system.base_count
        massless = system.massless.tobytes() if has_several_cases else b""
        return system.free.tobytes(), system.rigid_modes, massless, system.basis is None

    def reachable(self, machines: Machines) -> NDArray[np.bool_]:
        """Return a mask of the poses that these robots of the cases reach; declared ones were checked before."""
        points = machines.points
        reached = np.ones(len(points), dtype=bool)
        is_as_measured = np.array_equal(points, self.points)
        for c, (robot, case) in enumerate(zip(machines.robots, self.loads.cases, strict=True)):
            if not (is_as_measured and _same_geometry(self._mechanism, robot, case.robot)):
                rows = np.flatnonzero(self.loads.case_index == c)
                reached[rows] = check_poses(points[rows], self._mechanism, robot.parameters, "nan").valid
        return reached


def _solved_blocks(
    sets: Sequence[Machines], blocks: Sequence[tuple[Index, list[int]]], *, checked: bool
) -> list[SolvedRobots] | None:
    """Return the modes of each block of cases for all sets of values; None if not all are solved."""
    parts = []
    for rows, owners in blocks:
        robots = [machines.robots[c] for machines in sets for c in owners]
        systems = [machines.systems[c] for machines in sets for c in owners]
        points = [machines.points[rows] for machines in sets]
        part = solve_together(robots, systems, np.concatenate(points), checked=checked) if sets else None
        if part is None:
            return None
        parts.append(part)
    return parts


@cache
def _geometry(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the generated parameters that determine which poses a robot reaches."""
    keys = [
        key
        for key in field_keys(mechanism)
        if key.kind in GEOMETRY_KINDS or key.dimension in ("length", "angle")
    ]
    return tuple(dict.fromkeys(key.field for key in keys))


def _same_geometry(mechanism: Mechanism, a: Robot, b: Robot) -> bool:
    """Return whether two robots have the same geometry, and so reach the same poses."""
    of_a, of_b = a.parameters, b.parameters
    if of_a is of_b:
        return True
    pairs = ((getattr(of_a, name), getattr(of_b, name)) for name in _geometry(mechanism))
    return all(first is second or np.array_equal(first, second) for first, second in pairs)
