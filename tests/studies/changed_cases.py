"""Pairs of campaigns of one machine: what changed between them, how it is drawn and sized, and how both are measured.

The declared machine is wrong in both campaigns alike.  In the second one a part is changed, or none, and all drives
have another temperature.  A change is sized on the rig alone; no model and no diagnosis takes part.
"""

from __future__ import annotations

import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path

import numpy as np

from pkmodes.core.robot.robot import Robot
from pkmodes_rig import Identified, TrueModes, drawn_values
from pkmodes_rig.one_place import Fault
from pkmodes_rig.one_place.changes import Change, change_drawn, deviating
from pkmodes_rig.robots import with_free_motors
from studies.clear_cases import LEVER
from studies.one_place_cases import (
    CLEAR,
    DRAWS,
    EVERY,
    FAINT,
    PRINTERS,
    SIGMA,
    ModalTest,
    UnreachedError,
    declared,
    found,
)
from studies.specimens import PLATFORM, ROBOTS, SIX_LEGGED, text_of
from studies.true_machines import TrueMachine, sized, with_values

#: The suites: changes as clear as those of `one_place`, changes in standard deviations of the difference, and none.
OF_CLEAR, OF_SIGMAS, UNCHANGED = "clear", "sigmas", "unchanged"
#: Largest relative deviation of a declared mass, inertia or stiffness, beyond its stated uncertainty.
WRONG = 0.03
#: Standard deviation of the relative change of the stiffness of all drives from one day to the other.
TEMPERATURE = 0.01
#: Second campaigns of realistic laboratories: range of their standard deviations relative to the first's, numbers of
#: poses that are left out and added, and the standard deviation of repeated positions [m].
SIGMAS, OTHER_POSES, REPEATED = (0.7, 1.5), (1, 3), 1e-4
#: What tells the draws of a case apart.
OF_POSES, OF_TRUTH, OF_CHANGE, OF_VISIT, OF_SENSORS, *OF_LABORATORIES = range(7)

#: A mode at a pose.
Key = tuple[int, int]


@dataclass(frozen=True)
class PairCase:
    """Two campaigns of one machine, with one thing changed in the second one, or nothing.

    Attributes
    ----------
    suite : str
        ``clear``, ``sigmas`` or ``unchanged``.
    number : int
        Within the suite.
    machine : str
        One of `one_place_cases.EVERY`.
    kind : str
        One of `changes.kinds_of_changes`; empty where nothing changed.
    realistic : bool
        Whether the laboratories miss modes, cut the band, have other sensors and poses the second time, and state
        errors that are not quite right.
    seed : int
    """

    suite: str
    number: int
    machine: str
    kind: str = ""
    realistic: bool = False
    seed: int = 1

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.machine}, {self.suite} {self.number}{', realistic' if self.realistic else ''}"

    @property
    def mechanism(self) -> str:
        """Name of the mechanism."""
        return declared(self.machine).mechanism_name

    def rng(self, purpose: int) -> np.random.Generator:
        """Return the source of the draws for a purpose."""
        key = zlib.crc32(f"changed, {self.machine} {self.suite}".encode())
        return np.random.default_rng([self.seed, key, self.number, purpose])


@dataclass(frozen=True)
class Visit:
    """The poses of a campaign.

    Attributes
    ----------
    points : array, shape (N, d)
        Where the machine stood.
    stated : array, shape (N, d)
        What the file says.
    alike : tuple of int or None
        For each pose, the number of that in the first campaign which it repeats.
    """

    points: np.ndarray
    stated: np.ndarray
    alike: tuple[int | None, ...]


@dataclass(frozen=True)
class Campaign:
    """One campaign: the text of its file, and what is true of the rows."""

    text: str
    visit: Visit = field(compare=False)
    rows: tuple[Identified, ...] = field(compare=False)

    @property
    def errors(self) -> dict[Key, float]:
        """Standard deviations of ln f of the modes that were found."""
        return {(row.pose, row.mode): row.sigma / row.frequency for row in self.rows}


@dataclass(frozen=True)
class Pair:
    """What was measured of a case, and what is true.

    Attributes
    ----------
    trusted, later : Campaign
    robot : Robot
        The true machine of both campaigns, without the change.
    faults : tuple of Fault
        The change with its values: one fault, one on each axis, or none.
    drives : float
        Factor of the stiffness of all drives in the second campaign: their temperature.
    sigmas : tuple of two floats
        Standard deviations of ln f in both campaigns.
    change : float
        Root mean square of the changes of ln f that the change makes, over all modes at the second campaign's poses.
    strength : float
        Root of the sum of squares of these changes in standard deviations of the difference of the campaigns, over
        the modes that both found at the same pose.
    """

    trusted: Campaign
    later: Campaign
    robot: Robot = field(compare=False)
    faults: tuple[Fault, ...]
    drives: float
    sigmas: tuple[float, float]
    change: float
    strength: float


def measured(case: PairCase) -> Pair:
    """Draw, size and measure the campaigns of a case.

    Raises
    ------
    UnreachedError
        If no change that was drawn can be large enough.
    """
    machine = _Machine(case)
    faults = machine.changed_parts()
    modes = machine.modes(faults)
    later = machine.found_later(modes)
    return Pair(
        trusted=machine.trusted,
        later=later,
        robot=machine.robot,
        faults=faults,
        drives=machine.drives,
        sigmas=machine.sigmas,
        change=machine.mean(modes),
        strength=machine.strength(modes, later),
    )


def written_to(case: PairCase, folder: Path) -> Pair:
    """Write a case as ``robot.toml``, ``trusted.csv`` and ``later.csv`` into a folder; return what is true."""
    pair = measured(case)
    folder.mkdir(parents=True, exist_ok=True)
    texts = {
        "robot.toml": robot_text(case.machine),
        "trusted.csv": pair.trusted.text,
        "later.csv": pair.later.text,
    }
    for name, text in texts.items():
        (folder / name).write_text(text, encoding="utf-8")
    return pair


def robot_text(machine: str) -> str:
    """Return the text of the file that declares a machine."""
    if machine in PRINTERS:
        return with_free_motors(ROBOTS / EVERY[machine].file)
    return text_of(machine)


# The true machine --------------------------------------------------------------------------------------------


class _Machine(TrueMachine):
    """The true machine of a case in its second campaign, and its first one."""

    def __init__(self, case: PairCase) -> None:
        rng, usual = case.rng(OF_TRUTH), declared(case.machine)
        robot = with_values(usual, drawn_values(usual, rng))
        robot = replace(robot, parameters=deviating(robot.parameters, WRONG, rng))
        factor = rng.uniform(*SIGMAS)
        self.case = case
        self.sigmas = (SIGMA, SIGMA * (float(factor) if case.realistic else 1.0))
        first = _first_points(case)
        self.visit = _second_visit(case, first)
        super().__init__(robot, self.visit.points, 1.0 + TEMPERATURE * float(rng.standard_normal()))
        before = TrueMachine(robot, first)
        #: Band of an ideal laboratory, and what realistic ones are drawn from.
        self._scope = before.span
        self.trusted = self._campaign(_same_again(first), before.base, 0)

    # What is changed ------------------------------------------------------------------------------------------

    def changed_parts(self) -> tuple[Fault, ...]:
        """Return the change of the size that is asked for."""
        case, rng = self.case, self.case.rng(OF_CHANGE)
        if case.suite == UNCHANGED:
            return ()
        for _ in range(DRAWS):
            change = change_drawn(case.mechanism, self.robot.parameters, case.kind, self.span, rng)
            size = self._size_of(change, float(rng.uniform()))
            if size:
                return change.of_size(size)
        raise UnreachedError(f"{case.label}: no {case.kind} changes the frequencies enough")

    def _size_of(self, change: Change, share: float) -> float:
        """Return the size of a change, so far along the ranges of sizes; 0 if it cannot be as large.

        Where all axes changed alike, what counts is what another temperature cannot do, in a clear change, too.
        """
        clear, alike = self.case.suite == OF_CLEAR, len(change.parts) > 1

        def part(size: float) -> float:
            modes, parts = self.modes(change.of_size(size)), []
            if clear:
                parts.append(self.mean(modes) / _along(CLEAR, share))
            if not clear or alike:
                strength = self.strength(modes, self.found_later(modes), beyond_temperature=alike)
                parts.append(strength / _along(FAINT, share))
            return min(parts)

        return sized(change.sized_by, 1.0, part, self.largest(change.parts[0]))

    def mean(self, modes: Sequence[TrueModes]) -> float:
        """Return the root mean square of the changes of ln f."""
        return float(np.sqrt(np.mean(np.square(list(self.changes(modes).values())))))

    def strength(
        self, modes: Sequence[TrueModes], later: Campaign, *, beyond_temperature: bool = False
    ) -> float:
        """Return the root of the sum of squares of the changes of ln f, in standard deviations of the difference.

        Parameters
        ----------
        modes : sequence of TrueModes
            Of the changed machine.
        later : Campaign
            What was found of them.
        beyond_temperature : bool
            Count only what another temperature cannot do, within its standard deviation.
        """
        partners, before, after = self.partners(modes), self.trusted.errors, later.errors
        both: dict[Key, float] = {}
        for (pose, mode), (other, _) in partners.items():
            same = self.visit.alike[pose]
            if same is not None and (same, mode) in before and (pose, other) in after:
                both[pose, mode] = float(np.hypot(before[same, mode], after[pose, other]))
        apart = np.array([partners[key][1] / error for key, error in both.items()])
        if beyond_temperature and len(apart):
            rates = np.array([self._by_temperature[key][1] / error for key, error in both.items()])
            # Least squares with the prior of the temperature.
            amount = rates @ apart / (rates @ rates + 1.0)
            return float(np.hypot(np.linalg.norm(apart - amount * rates), amount))
        return float(np.linalg.norm(apart))

    @cached_property
    def _by_temperature(self) -> Mapping[Key, tuple[int, float]]:
        """Changes of ln f by a standard deviation of the temperature."""
        warmer = TrueMachine(self.robot, self.points, self.drives * (1.0 + TEMPERATURE))
        return self.partners(warmer.base)

    # What is measured -----------------------------------------------------------------------------------------

    def found_later(self, modes: Sequence[TrueModes]) -> Campaign:
        """Return the second campaign on a machine with these modes."""
        return self._campaign(self.visit, modes, 1)

    def _campaign(self, visit: Visit, modes: Sequence[TrueModes], number: int) -> Campaign:
        case = self.case
        test = ModalTest(
            case.machine, visit.stated, _sensors(case)[number], case.realistic, self.sigmas[number]
        )
        rows, text = found(test, modes, self._scope, case.rng(OF_LABORATORIES[number]))
        return Campaign(text, visit, tuple(rows))


def _along(sizes: tuple[float, float], share: float) -> float:
    low, high = sizes
    return float(low * (high / low) ** share)


# The campaigns -----------------------------------------------------------------------------------------------


def _first_points(case: PairCase) -> np.ndarray:
    """Return the poses of the first campaign; for a machine with six legs drawn in its box."""
    points = EVERY[case.machine].points
    return _in_box(case, len(points), case.rng(OF_POSES)) if case.machine in SIX_LEGGED else points


def _in_box(case: PairCase, count: int, rng: np.random.Generator) -> np.ndarray:
    """Draw poses in the box of a machine's usual ones."""
    points = EVERY[case.machine].points
    return np.round(rng.uniform(points.min(axis=0), points.max(axis=0), (count, points.shape[1])), 4)


def _same_again(points: np.ndarray) -> Visit:
    return Visit(points, points, tuple(range(len(points))))


def _second_visit(case: PairCase, points: np.ndarray) -> Visit:
    """Return the poses of the second campaign: in a realistic one some are other ones, in another order.

    Repeated poses are met with errors; in every second campaign the file states where the machine stood, in the
    others where it should have stood.
    """
    if not case.realistic:
        return _same_again(points)
    rng = case.rng(OF_VISIT)
    left_out, added = rng.integers(OTHER_POSES[0], OTHER_POSES[1] + 1, 2)
    kept = rng.permutation(len(points))[int(left_out) :]
    errors = REPEATED * rng.standard_normal((len(kept), points.shape[1]))
    errors[:, 3:] /= LEVER
    new = _in_box(case, int(added), rng)
    stood = points[kept] + errors
    says = stood if rng.random() < 1 / 2 else points[kept]
    alike: tuple[int | None, ...] = (*(int(i) for i in kept), *(None for _ in new))
    return Visit(np.vstack([stood, new]), np.vstack([says, new]), alike)


def _sensors(case: PairCase) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the sensors of both campaigns; in a realistic second one they are other ones.

    The platform of a machine with six legs, or its legs or carriages, have sensors.  Of other machines all sensors
    are there the first time, and the second time more than half of them.
    """
    shapes = EVERY[case.machine].shapes
    if case.machine in SIX_LEGGED:
        on_legs = tuple(name for name in shapes if name not in PLATFORM)
        first, second = (PLATFORM, on_legs) if case.number % 2 else (on_legs, PLATFORM)
        return first, second if case.realistic else first
    if not case.realistic or len(shapes) <= 2:
        return shapes, shapes
    some = sorted(case.rng(OF_SENSORS).choice(len(shapes), len(shapes) // 2 + 1, replace=False))
    return shapes, tuple(shapes[int(i)] for i in some)
