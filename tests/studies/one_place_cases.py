"""Cases of one fault at one place: the machines, and how their faults are drawn, sized and measured.

A fault is sized on the rig alone: by how much it changes the frequencies beyond what the uncertain values of the
robot file can do, each within its stated uncertainty.  No model and no diagnosis takes part.
"""

from __future__ import annotations

import zlib
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property, partial
from typing import Any

import numpy as np

from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.sensitivity.paths import resolve
from pkmodes_rig import Identified, Laboratory, TrueModes, drawn_values, identified, written
from pkmodes_rig.one_place import Fault, modes_of
from pkmodes_rig.one_place.draws import Drawn, drawn, kinds_of
from pkmodes_rig.one_place.laws import Setting, modes_by_law
from studies.clear_cases import LEAST, LEVER, MODES, TRIALS
from studies.specimens import (
    MACHINES,
    PLATFORM,
    ROBOTS,
    SIX_LEGGED,
    Kind,
    robot_of,
    spread,
)
from studies.true_machines import LARGEST, TrueMachine, sized, with_values

#: Standard deviation of ln f, and of shapes relative to their largest component in an ideal laboratory.
SIGMA, SHAPE_NOISE = 0.0015, 0.02
#: Band of an ideal laboratory: lowest frequency [Hz], and highest relative to the highest of the machine.
BAND = (2.0, 1.25)
#: Sizes.  Of a clear fault, the root mean square of the relative changes of all frequencies; of a faint one, the root
#: of their sum of squares in stated standard deviations.
CLEAR, FAINT = (0.007, 0.013), (9.0, 14.0)
#: How many faults are drawn until one at its place can be as large as asked.
DRAWS = 40
#: What tells the draws of a case apart.
OF_POSES, OF_TRUTH, OF_FAULT, OF_LABORATORY = range(4)

#: Printers of which the other suites have no rig.
PRINTERS = {
    "cartesian": Kind(
        "cartesian-printer.toml",
        partial(modes_of, "cartesian"),
        2,
        ("x", "y"),
        ("x", "y", "p_x", "p_y"),
        spread(12, (0.0, 0.0), (0.3, 0.3)),
    ),
    "bed_slinger": Kind(
        "bed-slinger.toml",
        partial(modes_of, "bed_slinger"),
        2,
        ("x", "y"),
        ("x", "y"),
        spread(12, (0.0, 0.0), (0.25, 0.21)),
    ),
}
EVERY = MACHINES | PRINTERS
#: Smallest and largest number of modes at a pose.
NUMBERS = MODES | {"cartesian": (2, 4), "bed_slinger": (2, 4)}


@dataclass(frozen=True)
class PlaceCase:
    """A machine with one fault at one place, a law that no term has, or nothing.

    Attributes
    ----------
    suite : str
        ``clear``, ``faint``, ``outside the grammar`` or ``complete``.
    number : int
        Within suite and machine.
    machine : str
        One of `EVERY`.
    kind : str
        One of `draws.KINDS`, or of `laws.LAWS`; empty for a complete machine.
    realistic : bool
        Whether the laboratory misses modes, cuts the band, and states errors that are not quite right.
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
        key = zlib.crc32(f"one place, {self.machine} {self.suite}".encode())
        return np.random.default_rng([self.seed, key, self.number, purpose])

    @property
    def points(self) -> np.ndarray:
        """Poses at which it is measured; for a machine with six legs drawn in its box."""
        points = EVERY[self.machine].points
        if self.machine not in SIX_LEGGED:
            return points
        low, high = points.min(axis=0), points.max(axis=0)
        return np.round(self.rng(OF_POSES).uniform(low, high, points.shape), 4)

    @property
    def sensors(self) -> tuple[str, ...]:
        """Sensors of the laboratory; for a machine with six legs on the platform, or on the legs or carriages."""
        shapes = EVERY[self.machine].shapes
        if self.machine not in SIX_LEGGED:
            return shapes
        return PLATFORM if self.number % 2 else tuple(name for name in shapes if name not in PLATFORM)


@cache
def declared(machine: str) -> Robot:
    """Return the declared robot."""
    if machine not in PRINTERS:
        return robot_of(machine)
    return replace(read_robot(ROBOTS / EVERY[machine].file), drives="free")


class UnreachedError(Exception):
    """No fault that was drawn for a case changes the frequencies as much as it should."""


@dataclass(frozen=True)
class Measured:
    """What was measured of a case, and what is true.

    Attributes
    ----------
    faults : tuple of Fault
        With their values: one, two where two are hidden, or none.
    size : float
        Of the fault or law.
    change : float
        Root mean square of the relative changes of the frequencies that were found, of those with a partner.
    rows : int
        Number of measured modes.
    text : str
        The file.
    """

    faults: tuple[Fault, ...]
    size: float
    change: float
    rows: int
    text: str


def measured(case: PlaceCase) -> Measured:
    """Draw, size and measure what a case hides.

    Raises
    ------
    UnreachedError
        If no fault that was drawn can be large enough.
    """
    machine = _Machine(case)
    faults, size, modes = machine.hidden()
    test = ModalTest(case.machine, case.points, case.sensors, case.realistic)
    rows, text = found(test, modes, machine.span, case.rng(OF_LABORATORY))
    change = machine.changes(modes)
    each = [change[key] for row in rows if (key := (row.pose, row.mode)) in change]
    return Measured(faults, size, float(np.sqrt(np.mean(np.square(each)))) if each else 0.0, len(rows), text)


class _Machine(TrueMachine):
    """The true machine of a case, with the values that its uncertain parameters happen to have."""

    def __init__(self, case: PlaceCase) -> None:
        self.case, self.declared = case, declared(case.machine)
        values = drawn_values(self.declared, case.rng(OF_TRUTH))
        super().__init__(with_values(self.declared, values), case.points)

    # What is hidden -------------------------------------------------------------------------------------------

    def hidden(self) -> tuple[tuple[Fault, ...], float, list[TrueModes]]:
        """Return the faults of the size that is asked for, the size, and the modes."""
        case, rng = self.case, self.case.rng(OF_FAULT)
        if case.suite == "complete":
            return (), 0.0, self.base
        low, high = FAINT if case.suite == "faint" else CLEAR
        target = float(np.exp(rng.uniform(np.log(low), np.log(high))))
        for _ in range(DRAWS):
            if case.suite == "outside the grammar" and case.kind != "two faults":
                draw = int(rng.integers(2**31))
                q, mechanism = self.robot.parameters, case.mechanism
                follows = partial(
                    modes_by_law, case.kind, Setting(mechanism, q, self.points, self.frame, draw)
                )
                size = self._sized("law", target, follows)
                if size:
                    return (), size, follows(size)
                continue
            some = self._drawn(rng)
            places = [place for one in some for place in one.fault.places]
            if len(set(places)) < len(places):
                continue
            sizes = [self._size_of(one, target) for one in some]
            if all(sizes):
                faults = tuple(one.of_size(size) for one, size in zip(some, sizes, strict=True))
                return faults, sizes[0], self.modes(faults)
        raise UnreachedError(f"{case.label}: no {case.kind} changes the frequencies by {target:.3g}")

    def _drawn(self, rng: np.random.Generator) -> list[Drawn]:
        mechanism, q = self.case.mechanism, self.robot.parameters
        kinds = [self.case.kind]
        if self.case.kind == "two faults":
            kinds = [str(kind) for kind in rng.choice(kinds_of(mechanism, q), 2, replace=False)]
        return [drawn(mechanism, q, kind, self.span, rng) for kind in kinds]

    def _size_of(self, one: Drawn, target: float) -> float:
        return self._sized(
            one.sized_by, target, lambda size: self.modes([one.of_size(size)]), self.largest(one)
        )

    def _sized(
        self, what: str, target: float, modes: Callable[[float], list[TrueModes]], most: float = LARGEST
    ) -> float:
        return sized(what, target, lambda size: self.strength(modes(size)), most)

    # Sizes ----------------------------------------------------------------------------------------------------

    def strength(self, modes: Sequence[TrueModes]) -> float:
        """Return how much modes differ from those of the machine without a fault: see `CLEAR` and `FAINT`.

        The uncertain values are fitted within their uncertainties, linearly.
        """
        changes = self.partners(modes)
        keys = [key for key in self._rates if key in changes]
        if not keys:
            return 0.0
        apart = np.array([changes[key][1] for key in keys]) / SIGMA
        rates = np.array([self._rates[key] for key in keys]) / SIGMA
        count = rates.shape[1]
        rows = np.vstack([rates, np.eye(count)])
        left = np.concatenate([apart, np.zeros(count)])
        if count:
            left = left - rows @ np.linalg.lstsq(rows, left, rcond=None)[0]
        total = float(np.linalg.norm(left))
        return total if self.case.suite == "faint" else total * SIGMA / float(np.sqrt(len(keys)))

    @cached_property
    def _rates(self) -> dict[tuple[int, int], np.ndarray]:
        """Changes of ln f by a standard deviation of each uncertain value, by pose and mode without fault."""
        sigmas = {path: q.sigma for path, q in self.declared.quantities.items() if q.sigma}
        every = []
        for path, sigma in sigmas.items():
            value = resolve(self.robot, path).value + sigma
            every.append(self.partners(self.modes((), with_values(self.robot, {path: value}))))
        least = {i: modes.rigid for i, modes in enumerate(self.base)}
        keys = [(i, k) for i, modes in enumerate(self.base) for k in range(least[i], len(modes.frequencies))]
        return {key: np.array([one[key][1] for one in every]) for key in keys}


@dataclass(frozen=True)
class ModalTest:
    """How the modes of a machine are measured.

    Attributes
    ----------
    machine : str
        One of `EVERY`.
    points : array, shape (N, d)
        Poses that the file states.
    sensors : tuple of str
    realistic : bool
        See `PlaceCase`.
    sigma : float
        Standard deviation of ln f.
    """

    machine: str
    points: np.ndarray
    sensors: tuple[str, ...]
    realistic: bool = False
    sigma: float = SIGMA


def found(
    test: ModalTest, modes: Sequence[TrueModes], span: tuple[float, float], rng: np.random.Generator
) -> tuple[list[Identified], str]:
    """Return the modes that a laboratory finds, and the text of their file.

    Parameters
    ----------
    test : ModalTest
    modes : sequence of TrueModes
        At each pose.
    span : tuple of two floats
        Lowest and highest frequency of the machine's vibrations [Hz].
    rng : numpy.random.Generator
    """
    kind = EVERY[test.machine]
    lever = LEVER if test.machine in SIX_LEGGED else 0.0
    shapes, band, stated = test.sensors, (BAND[0], float(f"{BAND[1] * span[1]:.3g}")), False
    options: dict[str, Any] = {"sigma": test.sigma, "modes": (99, 99), "shapes": shapes, "band": band}
    options |= {"shape_noise": SHAPE_NOISE, "sensors": test.sensors}
    for _ in range(TRIALS):
        if test.realistic:
            numbers = NUMBERS[declared(test.machine).mechanism_name]
            laboratory = replace(Laboratory.drawn(rng, span, test.sensors, modes=numbers), sigma=test.sigma)
            options = laboratory.options()
            stated, shapes, band = (
                bool(options.pop("band_stated")),
                laboratory.shapes,
                laboratory.band or band,
            )
        # A mode that does not move any of few sensors has no shape there, and is missed.
        with np.errstate(invalid="ignore"):
            rows = identified(modes, rng=rng, base_rigid=kind.rigid, lever=lever, **options)
        if len(rows) >= LEAST:
            break
    text = written(
        rows,
        list(test.points),
        shapes,
        band=band if stated else None,
        sigma_shape=options.get("sigma_shape", "absent") != "absent",
        components=kind.components,
        drives=["free"] * len(modes),
    )
    return rows, text
