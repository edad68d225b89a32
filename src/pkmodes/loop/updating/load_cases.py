"""Load cases: known differences between setups, such as a payload, or motors that are held.

A value set in a setup is known there: no parameter moves it, even as an element of a group or of a shared value.
Payloads that another measurement could have are fractions of the mass of the platform.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import FREE, HELD, other_drives
from pkmodes.core.base.errors import MeasurementError, PkmodesError, nearest_name, shown
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.declaration import changeable_units
from pkmodes.core.robot.layout import EFFECTS, Slot, effect_parameters, items
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.core.system.motors import solved_system
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.rules import SET
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives
from pkmodes.loop.sensitivity.paths import ParameterPath, resolve

Index = NDArray[np.intp]
SlotSet = frozenset[Slot]
Array = NDArray[np.float64]
#: The effect of a mass on the platform, and its parameter.
PAYLOAD = "payload"
PAYLOAD_MASS = f"{EFFECTS}.{PAYLOAD}.mass"
#: Payloads as fractions of the platform's mass.
PAYLOAD_FRACTIONS = (0.1, 0.3, 1.0)
#: Significant digits of a payload.
DIGITS = 3


@dataclass(frozen=True)
class LoadCase:
    """A robot with set values, the slots of the generated model that these determine, and what its motors do."""

    robot: Robot
    set_slots: SlotSet = frozenset()
    drives: str = FREE

    @classmethod
    def of(cls, robot: Robot, values: dict[str, float], drives: str = FREE) -> LoadCase:
        """Return the load case of a robot with some values, by path.

        Raises PkmodesError as `Robot.with_values` does.
        """
        if not values:
            return cls(robot, drives=drives)
        changed = robot.with_values(values)
        set_slots = frozenset(slot for path in values for slot in resolve(robot, path).weights)
        return cls(changed, set_slots, drives)

    def system(self, robot: Robot) -> ExtendedSystem:
        """Return the system of a robot with the drives of this case."""
        return solved_system(ExtendedSystem.of(robot), self.drives)

    def reduced(self, path: ParameterPath) -> ParameterPath:
        """Return a path without the slots that are set."""
        if not self.set_slots:
            return path
        weights = {slot: weight for slot, weight in path.weights.items() if not self.is_set(slot)}
        return replace(path, weights=weights)

    def is_set(self, slot: Slot) -> bool:
        """Return whether a slot is set; a compliance is set for each of its joints."""
        field, index = slot
        return slot in self.set_slots or (field.rpartition(".")[0], index) in self.set_slots


@dataclass(frozen=True)
class LoadCases:
    """Load cases of S setups.

    - settings: paths of the values set in some of the setups
    - cases: different load cases
    - case_index: index of the case of each setup, (S,)
    """

    settings: tuple[str, ...]
    cases: tuple[LoadCase, ...]
    case_index: Index

    @classmethod
    def as_declared(cls, robot: Robot, setups: int, drives: str = FREE) -> LoadCases:
        """Return the robot as declared in all setups."""
        return cls((), (LoadCase(robot, drives=drives),), np.zeros(setups, dtype=np.intp))

    @property
    def usual_drives(self) -> str:
        """What the motors do in most of the setups."""
        held = sum(
            int((self.case_index == c).sum()) for c, case in enumerate(self.cases) if case.drives == HELD
        )
        return HELD if 2 * held > len(self.case_index) else FREE

    def with_other_drives(self, setups: Sequence[int]) -> LoadCases:
        """Return the load cases with motors free instead of held, or held instead of free, in some of the setups."""
        other_cases = tuple(replace(case, drives=other_drives(case.drives)) for case in self.cases)
        case_index = self.case_index.copy()
        case_index[list(setups)] += len(self.cases)
        extended = LoadCases(self.settings, (*self.cases, *other_cases), case_index)
        return extended.subset(range(len(case_index)))

    def subset(self, setups: Sequence[int]) -> LoadCases:
        """Return the load cases of some of the setups."""
        used, case_index = np.unique(self.case_index[list(setups)], return_inverse=True)
        return LoadCases(self.settings, tuple(self.cases[c] for c in used), case_index)

    def is_always_set(self, path: ParameterPath) -> bool:
        """Return whether all slots of a path are set in every setup."""
        return all(not case.reduced(path).weights for case in self.cases)

    def setup_blocks(self, cases: Sequence[int], included: NDArray[np.bool_]) -> tuple[Index, list[int]]:
        """Return the setups of some cases, ordered in blocks of equal size, one for each robot.

        - included: mask of the setups to include, (S,)

        Returns, in this order:
        - rows: the setups, (N,)
        - owners: cases of the B robots, at N / B setups each, length B
        """
        rows = [np.flatnonzero((self.case_index == c) & included) for c in cases]
        if len({len(block) for block in rows}) == 1 and (len(rows[0]) or len(rows) == 1):
            return np.concatenate(rows), list(cases)
        ordered = np.sort(np.concatenate(rows))
        return ordered, self.case_index[ordered].tolist() if len(ordered) else [cases[0]]


def settable_paths(mechanism: Mechanism, robot: Robot | None = None) -> dict[str, str]:
    """Return the paths that measurements may set, with SI units, for one robot or any robot of a mechanism."""
    if robot is not None:
        return changeable_units(robot)
    units = {number.path: number.unit for item in items(mechanism) for number in item.numbers}
    return {
        **units,
        **effect_parameters(mechanism),
        **{group.path: group.unit for group in mechanism.parameter_groups},
    }


def load_cases_of(robot: Robot, data: Measurements) -> LoadCases:
    """Return the load cases of measurements.

    Raises MeasurementError if the robot does not have a path, or a robot file with a set value would be refused: for
    the first row of the first such pose.
    """
    allowed = settable_paths(robot.mechanism, robot)
    for path in data.settings:
        if path not in allowed:
            problem = f"{shown(f'{SET}{path}')} is not a value that can be set in {robot.source}"
            remedy = nearest_name(path, allowed, "see docs/reference/parameter-paths.md for the paths")
            raise MeasurementError(problem, data.source, remedy)
    cases: dict[tuple[object, ...], LoadCase] = {}
    case_index = []
    for pose, drives in enumerate(data.drives):
        values = data.load(pose)
        key = (drives, *values.items())
        if key not in cases:
            try:
                cases[key] = LoadCase.of(robot, values, drives)
            except PkmodesError as error:
                # All set columns are named if the error concerns several together.
                path = error.where.rpartition(": ")[2]
                refused = {path: values[path]} if path in values else values
                line = data.lines[int(np.argmax(data.pose == pose))]
                where = f"{data.source}: line {line}, {columns_in_words(refused)}"
                raise MeasurementError(error.what, where, error.remedy) from None
        case_index.append(list(cases).index(key))
    return LoadCases(data.settings, tuple(cases.values()), np.array(case_index, dtype=np.intp))


def columns_in_words(values: dict[str, float]) -> str:
    """Return the columns that set some values, as in a sentence."""
    names = [f"{SET}{path}" for path in values]
    return f"column{'s' if len(names) > 1 else ''} {' and '.join(names)}"


def payloads(robot: Robot, points: Array) -> list[dict[str, float]]:
    """Return payloads as values to set, added to the declared one; empty if the mechanism has no payload effect.

    - points: poses that can be evaluated, (P, d)
    """
    mechanism = robot.mechanism
    if PAYLOAD not in mechanism.effects or not len(points):
        return []
    declared_mass = robot.effects.get(PAYLOAD_MASS.removeprefix(f"{EFFECTS}."), 0.0)
    names = [
        item.path for item in items(mechanism) if item.key.dimension == "mass" and item.index is not None
    ]
    paths = [resolve(robot, path) for path in (PAYLOAD_MASS, *names)]
    dM, dK = MatrixDerivatives(ExtendedSystem.of(robot), points[:1], [paths]).dense()
    for index, path in enumerate(paths[1:], start=1):
        is_equal = (np.allclose(d[0, index], d[0, 0], atol=1e-9 * np.abs(d[0, 0]).max()) for d in (dM, dK))
        if all(is_equal):  # the mass acts like a payload
            added = [float(f"{fraction * path.value:.{DIGITS}g}") for fraction in PAYLOAD_FRACTIONS]
            return [{PAYLOAD_MASS: declared_mass + mass} for mass in added]
    return []
