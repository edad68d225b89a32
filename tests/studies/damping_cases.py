"""Cases of damping on the virtual test rig: what dissipates, how it is measured, and how a diagnosis is judged.

The true ratios come from `pkmodes_rig.dissipation`.  The experimenter states a standard deviation of 5, 10 or 20 % or
none, and in every second case the ratios scatter by another 10 %, as repeated tests do.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
from msgspec import structs

from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.losses import RATIO
from pkmodes_rig import Identified, TrueModes, drawn_values, drives_of, identified
from pkmodes_rig.dissipation import coulomb_ratios, damping_ratios
from pkmodes_rig.measurements import LOWEST_FREQUENCY
from studies.judging import judged, same_of
from studies.running import Outcome
from studies.specimens import MACHINES, SIGMA, SIX_LEGGED, Specimen, robot_of
from studies.strengths import signal

#: Poses of a test, and the fewest and the most modes at each.
POSES, MODES = 8, (3, 8)
#: Range of the median damping ratio that the losses in question cause.
RATIOS = 0.004, 0.03
#: Stated relative standard deviations of the ratios; none is stated for the last, which scatter by half of 30 %.
STATED = (0.05, 0.1, 0.2, None)
BLANK, HIDDEN = 0.15, 0.1
#: What any test resolves.
RESOLVED = 1e-4
#: Range of the scatter of the ratios of a machine from mode to mode, the same at all poses: the standard deviation of
#: their logarithm.
BY_MODE = 0.2, 0.4
#: Modes that a loss damps by less than this part of the largest ratio do not count in the median, and no ratio is
#: larger than this.
NOTHING, LARGEST = 1e-6, 0.15
#: A ratio that the robot file declares, and which is there.
DECLARED = 0.01
#: Candidates by what dissipates.
NAMES = {"ratio": RATIO, "rails": "rail_friction", "drives": "drive_friction"}
#: How the amplitudes of the modes follow from the test.
AMPLITUDES = ("hammer", "equal displacement", "equal velocity", "drawn")
#: Impact direction of the hammer, before it is cut to the dimension of the platform.
HAMMER = np.array([0.48, 0.6, 0.64])
#: Payload of every fourth specimen, which the frequencies have to show [kg].
PAYLOADS = {"published": 0.3, "tower": 0.08, "asymmetric": 0.25, "rotary_delta": 0.1, "corexy": 0.06}
#: What the damping adds to a row.
OF_DAMPING = [name for name in Row.__struct_fields__ if "damping" in name]
#: Cases of each kind on each machine.
EACH = 6


@dataclass(frozen=True)
class Kind:
    """What dissipates.

    Attributes
    ----------
    losses : mapping of str to float
        Their shares of the median ratio.
    names : tuple of str
        Keys of `NAMES`, or ``springs``, that should be named.
    declared : bool
        Whether the file declares a damping ratio, which is there in addition.
    amplitudes : str
        Of `AMPLITUDES`, for Coulomb friction.
    scattered : bool
        Whether the ratios of the modes scatter by `BY_MODE`, and no error is stated.
    """

    losses: Mapping[str, float] = field(default_factory=dict)
    names: tuple[str, ...] = ()
    declared: bool = False
    amplitudes: str = ""
    scattered: bool = False


KINDS = {
    "nothing missing": Kind(declared=True),
    "common ratio, not declared": Kind({"ratio": 1.0}, ("ratio",)),
    "springs": Kind({"springs": 1.0}, ("springs",)),
    "rails": Kind({"rails": 1.0}, ("rails",)),
    "drives": Kind({"drives": 1.0}, ("drives",)),
    "rails beside a declared ratio": Kind({"rails": 1.0}, ("rails",), declared=True),
    "drives beside a declared ratio": Kind({"drives": 1.0}, ("drives",), declared=True),
    "springs and rails": Kind({"springs": 0.5, "rails": 0.5}, ("springs", "rails")),
    **{f"Coulomb, {name}": Kind(amplitudes=name) for name in AMPLITUDES},
    **{
        f"Coulomb beside a common ratio, {name}": Kind({"ratio": 0.5}, amplitudes=name) for name in AMPLITUDES
    },
    "Coulomb beside a declared ratio, hammer": Kind(declared=True, amplitudes="hammer"),
    "one rail": Kind({"one_rail": 1.0}),
    "proportional to mass": Kind({"mass": 1.0}),
    "each mode its own": Kind({"own": 1.0}),
    "nothing missing, scatter by mode": Kind(declared=True, scattered=True),
    "common ratio, not declared, scatter by mode": Kind({"ratio": 1.0}, ("ratio",), scattered=True),
}


@dataclass(frozen=True)
class Case:
    """A specimen with its damping, and how it is measured."""

    kind: str
    machine: str
    drives: str
    number: int
    seed: int

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.machine}, {self.kind} {self.number}, motors {self.drives}"

    @property
    def effects(self) -> dict[str, float]:
        """What the frequencies have to show: every fourth specimen has a payload."""
        return {"payload.mass": PAYLOADS[self.machine]} if self.number % 4 == 3 else {}


@dataclass(frozen=True)
class DampingOutcome(Outcome[Case]):
    """What was said of a case: `state`, `classes` and `reason` of the damping, `verdict` and `rule` of the whole.

    `signal` is that of the payload, in the frequencies.

    Attributes
    ----------
    of_damping : str
        The verdict on the damping.
    away : tuple of float
        Errors of the claimed sizes, in their standard deviations.
    ratios : int
        Number of damping ratios that took part.
    unchanged : bool or None
        Whether all that is said of frequencies and shapes is the same without the damping; None where that was not
        tried.
    of_frequencies : tuple of str and tuple
        State and classes of the whole.
    """

    of_damping: str = ""
    away: tuple[float, ...] = ()
    ratios: int = 0
    unchanged: bool | None = None
    of_frequencies: tuple[str, tuple[tuple[str, ...], ...]] = ("", ())

    @property
    def what(self) -> Kind:
        """What dissipates."""
        return KINDS[self.case.kind]


def cases(seed: int) -> Iterator[Case]:
    """Yield all cases that make sense: no rails at a rotary delta, no friction of drives that are held."""
    n = 0
    for kind, what in KINDS.items():
        for machine in (name for name in MACHINES if name not in SIX_LEGGED):
            for k in range(EACH):
                drives = ("free", "held", "mixed")[k % 3]
                n += 1
                on_rails = bool(what.amplitudes) or any("rail" in loss for loss in what.losses)
                if (on_rails and machine == "rotary_delta") or ("drives" in what.losses and drives == "held"):
                    continue
                yield Case(kind, machine, drives, n, seed)


def run(case: Case) -> DampingOutcome:
    """Measure and diagnose a case."""
    rng = np.random.default_rng([case.seed, 91, case.number])
    what, declared = KINDS[case.kind], robot_of(case.machine)
    specimen = Specimen(case.machine, case.effects, drawn_values(declared, rng), drives=case.drives)
    points = MACHINES[case.machine].points[:POSES]
    modes = specimen.modes(points)
    true, truth = _true_ratios(case, what, specimen, declared, points, modes, rng)
    rows, data = _measured(
        case, points, modes, true, rng, None if what.scattered else STATED[case.number % len(STATED)]
    )
    robot = declared.with_values({"damping.ratio": DECLARED}) if what.declared else declared
    start = time.perf_counter()
    found = updating.diagnose(robot, data, terms=False)
    outcome = _judged(case, what, truth, found, time.perf_counter() - start)
    if case.effects:
        of_cause = replace(specimen, values={})
        predicted = signal(of_cause, points, holdout=found.held_out_poses, rows=rows)
        outcome = replace(outcome, signal=predicted)
    if not what.scattered:
        return outcome
    blank = np.full(len(data.damping), np.nan)
    numbers = {**data.numbers, "damping": blank, "damping_sigma": blank}
    without = updating.diagnose(robot, replace(data, numbers=numbers), terms=False)
    return replace(outcome, unchanged=_of_frequencies(found) == _of_frequencies(without))


def _of_frequencies(found: Diagnosis) -> dict[str, object]:
    """Return all that is said of frequencies and shapes."""
    rows = [{**structs.asdict(row), **dict.fromkeys(OF_DAMPING)} for row in found.rows]
    return {**found.as_json(), "damping": None, "rows": rows}


def _true_ratios(
    case: Case,
    what: Kind,
    specimen: Specimen,
    declared: Robot,
    points: np.ndarray,
    modes: Sequence[TrueModes],
    rng: np.random.Generator,
) -> tuple[list[np.ndarray], dict[str, float]]:
    """Return the ratios of all modes at each pose, and the size of each loss.

    Sizes are chosen so that the median ratio over the modes that a loss damps is drawn from `RATIOS`.
    """
    built, name = specimen.built().parameters, declared.mechanism_name
    size = float(np.exp(rng.uniform(*np.log(RATIOS))))
    flexible = [m.frequencies > LOWEST_FREQUENCY for m in modes]
    total = [np.full(len(m.frequencies), DECLARED if what.declared else 0.0) for m in modes]
    sizes = {}

    def add(each: list[np.ndarray], share: float) -> float:
        ratios = np.concatenate([one[some] for one, some in zip(each, flexible, strict=True)])
        typical = float(np.median(ratios[ratios > NOTHING * ratios.max()]))
        factor = min(size * share / typical, LARGEST / float(ratios.max()))
        for one, more in zip(total, each, strict=True):
            one += factor * more
        return factor

    for loss, share in what.losses.items():
        if loss == "own":
            levels = np.exp(rng.normal(0.0, 0.7, max(len(m.frequencies) for m in modes)))
            add([levels[: len(m.frequencies)] for m in modes], share)
            continue
        each = [damping_ratios(name, built, p, m, {loss: 1.0}) for p, m in zip(points, modes, strict=True)]
        sizes[loss] = add(each, share)
    if what.amplitudes:
        drawn = np.exp(rng.normal(0.0, 0.7, max(len(m.frequencies) for m in modes)))
        add([coulomb_ratios(name, m, 1.0, _amplitudes(what.amplitudes, m, drawn)) for m in modes], 1.0)
    if what.scattered:
        levels = np.exp(rng.uniform(*BY_MODE) * rng.standard_normal(max(len(m.frequencies) for m in modes)))
        return [one * levels[: len(one)] for one in total], {}  # no loss has that size
    return total, sizes


def _amplitudes(law: str, modes: TrueModes, drawn: np.ndarray) -> np.ndarray:
    """Return the amplitude of each mode in a test, up to a common factor."""
    platform = np.array([modes.shapes[name] for name in ("p_x", "p_y", "p_z") if name in modes.shapes])
    omega = 2 * np.pi * np.maximum(np.abs(modes.frequencies), 1.0)
    if law == "hammer":  # an impulse at the platform
        return np.abs(HAMMER[: len(platform)] @ platform) / omega + 1e-9
    moved = np.abs(platform).max(axis=0) + 1e-9
    return {
        "equal displacement": 1.0 / moved,
        "equal velocity": 1.0 / (moved * omega),
        "drawn": drawn[: len(omega)] / moved,
    }[law]


def _measured(
    case: Case,
    points: np.ndarray,
    modes: Sequence[TrueModes],
    true: Sequence[np.ndarray],
    rng: np.random.Generator,
    stated: float | None,
) -> tuple[list[Identified], Measurements]:
    """Return the modes found, and what the experimenter measures of them."""
    kind = MACHINES[case.machine]
    rows: list[Identified] = identified(
        modes, rng=rng, sigma=SIGMA, modes=MODES, missing=0.1, sensors=(), base_rigid=kind.rigid
    )
    scatter = np.hypot(BLANK if stated is None else stated, HIDDEN if case.number % 2 else 0.0)
    ratios = np.array([true[row.pose][row.mode] for row in rows]) * np.exp(
        rng.normal(0.0, scatter, len(rows))
    )
    ratios = np.clip(ratios + RESOLVED * rng.standard_normal(len(rows)), 0.0, 0.9)
    sigma = np.hypot((stated or 0.0) * ratios, RESOLVED)
    did = drives_of(modes)
    return rows, Measurements.from_rows(
        [f"P{row.pose + 1}" for row in rows],
        [row.frequency for row in rows],
        [row.stated for row in rows],
        points=[points[row.pose] for row in rows],
        damping=ratios,
        damping_sigma=None if stated is None else sigma,
        drives=[did[row.pose] for row in rows],
        components=dict.fromkeys(kind.components, "m"),
    )


def _judged(
    case: Case, what: Kind, truth: Mapping[str, float], found: Diagnosis, seconds: float
) -> DampingOutcome:
    """Judge what was said of the damping; causes of the frequencies are judged by the other suites."""
    springs = "reducer_loss" if case.machine == "rotary_delta" else "belt_loss"
    names = {loss: NAMES.get(loss, springs) for loss in what.names}
    claimed = found.damping.effects
    classes = tuple(effect.members for effect in claimed)
    right = [any(name in members for name in names.values()) for members in classes]
    named = [any(name in members for members in classes) for name in names.values()]
    if classes and not all(right):
        state = "wrong"
    elif classes:
        state = "named" if all(named) else "partly"
    elif found.damping.verdict == ADEQUATE.word:
        state = "adequate"
    else:
        state = "abstained"
        classes = found.damping.survivors
    away = tuple(
        abs(value.value - truth[loss]) / value.sigma
        for loss, name in names.items()
        for effect in claimed
        for value in effect.alternatives.get(name, ())
        if loss in truth
    )
    of = found.damping
    return DampingOutcome(
        case,
        state,
        found.verdict,
        classes,
        seconds=seconds,
        reason=of.reason,
        of_damping=of.verdict,
        away=away,
        ratios=of.fitted,
        rule=found.rule,
        of_frequencies=(
            judged(tuple(name.partition(".")[0] for name in case.effects), found, same_of(case.machine)),
            tuple(effect.members for effect in found.effects) or found.survivors,
        ),
    )
