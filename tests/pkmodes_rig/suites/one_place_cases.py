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
from scipy.optimize import linear_sum_assignment

from pkmodes.core.robot.reading import read_robot
from pkmodes.core.robot.robot import Robot
from pkmodes.sensitivity.paths import moved, resolve
from pkmodes_rig import Identified, Laboratory, TrueModes, drawn_values, identified, written
from pkmodes_rig.one_place import Fault, modes_of
from pkmodes_rig.one_place.draws import Drawn, drawn, kinds_of
from pkmodes_rig.one_place.laws import Setting, modes_by_law
from pkmodes_rig.suites.clear_cases import LEAST, LEVER, MODES, TRIALS
from pkmodes_rig.suites.specimens import (
    MACHINES,
    PLATFORM,
    ROBOTS,
    SIX_LEGGED,
    Kind,
    robot_of,
    spread,
)

#: Standard deviation of ln f, and of shapes relative to their largest component in an ideal laboratory.
SIGMA, SHAPE_NOISE = 0.0015, 0.02
#: Band of an ideal laboratory: lowest frequency [Hz], and highest relative to the highest of the machine.
BAND = (2.0, 1.25)
#: Sizes.  Of a clear fault, the root mean square of the relative changes of all frequencies; of a faint one, the root
#: of their sum of squares in stated standard deviations.
CLEAR, FAINT = (0.007, 0.013), (9.0, 14.0)
#: Largest number of steps of the search for a size, how near it comes, and how many faults are drawn until one at its
#: place can be as large as that.
STEPS, WITHIN, DRAWS = 40, 1.05, 40
#: Where the search for a size begins, by what is sized; largest sizes: beyond them it would be another machine.
STARTS = {"mass": 1e-3, "inertia": 1e-7, "stiffness": 1e2, "compliance": 1e-9, "change": 1e-3, "law": 1e-4}
MOST = {"change": 0.5}
LARGEST = 1e9
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
    return read_robot(ROBOTS / EVERY[machine].file) if machine in PRINTERS else robot_of(machine)


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
    rows, text = found(case, modes, machine.span)
    change = machine.changes(modes)
    each = [change[key] for row in rows if (key := (row.pose, row.mode)) in change]
    return Measured(faults, size, float(np.sqrt(np.mean(np.square(each)))) if each else 0.0, len(rows), text)


class _Machine:
    """The true machine of a case, with the values that its uncertain parameters happen to have."""

    def __init__(self, case: PlaceCase) -> None:
        self.case, self.declared = case, declared(case.machine)
        values = drawn_values(self.declared, case.rng(OF_TRUTH))
        self.points = case.points
        self.robot = _changed(self.declared, values)
        self.frame = float(self.declared.constants.get("frame_compliance.mass", 50.0))
        self.base = self.modes(())

    def modes(self, faults: Sequence[Fault], robot: Robot | None = None) -> list[TrueModes]:
        """Return the modes at all poses; a value of one axis is changed in the robot."""
        robot = robot or self.robot
        for fault in faults:
            if fault.form == "parameter":
                (path,) = fault.places
                robot = _changed(robot, {path: resolve(robot, path).value * (1 + fault.values["change"])})
        q = robot.parameters
        return [modes_of(self.case.mechanism, q, p, faults, frame=self.frame) for p in self.points]

    @cached_property
    def span(self) -> tuple[float, float]:
        """Lowest and highest frequency of its vibrations [Hz]."""
        each = [modes.frequencies[modes.rigid :] for modes in self.base]
        return float(min(one[0] for one in each)), float(max(one[-1] for one in each))

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
                setting = Setting(mechanism, q, self.points, self.frame, draw)
                follows = partial(modes_by_law, case.kind, setting)
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
        heavy = one.sized_by == "mass" and not one.fault.places[0].startswith("motor")
        most = self._heaviest if heavy else MOST.get(one.sized_by, LARGEST)
        return self._sized(one.sized_by, target, lambda size: self.modes([one.of_size(size)]), most)

    # Sizes ----------------------------------------------------------------------------------------------------

    def _sized(
        self,
        what: str,
        target: float,
        modes: Callable[[float], list[TrueModes]],
        most: float = LARGEST,
    ) -> float:
        """Find the size with a change within `WITHIN` of the target; 0 if there is none."""
        low, high, size = 0.0, 0.0, STARTS[what]
        for _ in range(STEPS):
            try:
                value = self.strength(modes(size))
            except (ValueError, np.linalg.LinAlgError):  # beyond what the links can reach
                value = np.inf
            if target / WITHIN <= value <= target * WITHIN:
                return size
            if value < target:
                low = size
                factor = min(max(target / max(value, 1e-12), 1.2), 30.0)
                size = min(size * factor, most) if not high else (low * high) ** 0.5
            else:
                high = size
                size = (low * high) ** 0.5 if low else size / 30.0
            if low >= most or (high and low and high / low < 1.01):
                break
        return 0.0

    @property
    def _heaviest(self) -> float:
        """The largest extra mass: that of the platform or tool head."""
        q = self.robot.parameters
        return float(q.toolhead_mass if hasattr(q, "toolhead_mass") else q.platform_mass)

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
            every.append(self.partners(self.modes((), _changed(self.robot, {path: value}))))
        least = {i: modes.rigid for i, modes in enumerate(self.base)}
        keys = [(i, k) for i, modes in enumerate(self.base) for k in range(least[i], len(modes.frequencies))]
        return {key: np.array([one[key][1] for one in every]) for key in keys}

    def partners(self, modes: Sequence[TrueModes]) -> dict[tuple[int, int], tuple[int, float]]:
        """Pair modes by their shapes with those of the machine without a fault.

        Returns
        -------
        dict
            By pose and mode without fault: the mode, and the change of ln f.
        """
        found_pairs = {}
        for pose, (plain, one) in enumerate(zip(self.base, modes, strict=True)):
            before, after = (np.array([m.shapes[name] for name in plain.coordinates]) for m in (plain, one))
            first = plain.rigid
            moving = plain.mass_matrix @ after
            # Without the fault a mode has size 1: an added one may look like another, but not be as large.
            size = np.sqrt(np.maximum(np.sum(after * moving, axis=0), 1e-30))
            likeness = np.abs(before[:, first:].T @ moving) / size * np.minimum(size, 1 / size)
            for i, k in zip(*linear_sum_assignment(-likeness), strict=True):
                if one.frequencies[k] > 0:
                    change = np.log(one.frequencies[k] / plain.frequencies[first + i])
                    found_pairs[pose, first + int(i)] = (int(k), float(change))
        return found_pairs

    def changes(self, modes: Sequence[TrueModes]) -> dict[tuple[int, int], float]:
        """Return the changes of ln f by pose and mode, for the modes that have a partner without the fault."""
        return {(pose, k): change for (pose, _), (k, change) in self.partners(modes).items()}


def _changed(robot: Robot, values: dict[str, float]) -> Robot:
    paths = [(resolve(robot, path), value) for path, value in values.items()]
    return moved(robot, [(path, value - path.value) for path, value in paths])


def found(
    case: PlaceCase, modes: Sequence[TrueModes], span: tuple[float, float]
) -> tuple[list[Identified], str]:
    """Return the modes that a laboratory finds, and the text of their file."""
    kind, rng = EVERY[case.machine], case.rng(OF_LABORATORY)
    lever = LEVER if case.machine in SIX_LEGGED else 0.0
    shapes, band, stated = case.sensors, (BAND[0], float(f"{BAND[1] * span[1]:.3g}")), False
    options: dict[str, Any] = {"sigma": SIGMA, "modes": (99, 99), "shapes": shapes, "band": band}
    options |= {"shape_noise": SHAPE_NOISE, "sensors": case.sensors}
    for _ in range(TRIALS):
        if case.realistic:
            drawn_one = Laboratory.drawn(rng, span, case.sensors, modes=NUMBERS[case.mechanism])
            laboratory = replace(drawn_one, sigma=SIGMA)
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
        list(case.points),
        shapes,
        band=band if stated else None,
        sigma_shape=options.get("sigma_shape", "absent") != "absent",
        components=kind.components,
        drives=["free"] * len(modes),
    )
    return rows, text
