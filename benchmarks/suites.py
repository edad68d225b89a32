"""The suites on which the diagnosis is measured: cases on the virtual test rig, how they are run and judged.

The rig is MuJoCo's physics and shares no code with the model.  In every case the true values of the uncertain
parameters are drawn from their priors, so that the robot is not the one that its file declares.  Everything is
fixed by seeds; the sizes of causes are those of `sizes`.
"""

from __future__ import annotations

import csv
import io
import itertools
import time
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

import numpy as np

from pkmodes.closing import loop
from pkmodes.closing.suspects import PREFIX
from pkmodes.diagnosis.diagnose import split
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.robot.effects import CATALOGUE
from rig import POSES, ROBOTS, measure_modes, read
from sizes import EFFECT_SIZES, OUTSIDE_SIZES, PAIR_SIZES, TARGETS, WRONG_SIZES
from strengths import (
    MODES,
    PLANS,
    SEED,
    SHAPES,
    SIGMA,
    Truth,
    measurements,
    pairs,
    signal,
    strangers,
    with_effect,
    with_outside,
    with_wrong,
)

ROBOT_NAMES = tuple(ROBOTS)

#: Robots that lack nothing: 5 % of them are ten.
NOTHING_MISSING = 210
#: One case in so many has no shapes measured.
WITHOUT_SHAPES = 5

#: Candidates that are the truth by another name, whatever is measured: a class that holds one of them is right.
#: Only the product gear_ratio^2 * motor.inertia enters the modes, and it is an inertia on the driven pulley; and a
#: belt of another width is a change of the stiffness of each axis that it runs on.
SAME: dict[str, tuple[str, ...]] = {
    "gearbox_inertia": ("parameter:motor.gear_ratio",),
    "parameter:motor.gear_ratio": ("gearbox_inertia",),
    "parameter:belt.width": ("axis_belt_stiffness",),
    "parameter:axis.2.belt.width": ("axis_belt_stiffness",),
}

#: Errors of the experimenter in the special cases: a common error and a drift of the size of the noise and more, an
#: outlier of 25 standard deviations, and half of what few accelerometers would show missing.
COMMON, DRIFT, OUTLIER, MISSING, BLANK = 0.004, 0.001, 0.05, 0.15, 0.5


@dataclass(frozen=True)
class Case:
    """A robot on the rig, and how it is measured.

    Attributes
    ----------
    suite, number
        Which case it is.
    plan : str
        Poses.
    truth : Truth
        What the robot lacks or has wrong; the nuisance parameters are drawn in addition.
    names : tuple of str
        Candidates that should be named: none where nothing is missing, or nothing in the catalogue fits.
    kind : str
        What tables call it.
    shapes : tuple of str
        Shape components that are measured.
    options : mapping
        Of `rig_measurements.measure_modes`.
    edit : str
        What happens to the rows of the file, see `edited`.
    seed : int
        Of everything that is drawn, with suite and number.
    """

    suite: str
    number: int
    plan: str
    truth: Truth
    names: tuple[str, ...] = ()
    kind: str = ""
    shapes: tuple[str, ...] = SHAPES
    options: Mapping[str, float] = field(default_factory=dict)
    edit: str = ""
    seed: int = SEED

    @property
    def label(self) -> str:
        """Name for reports."""
        return f"{self.suite} {self.number}"


# The cases ---------------------------------------------------------------------------------------------------


def nothing_missing() -> Iterator[Case]:
    """Robots that lack nothing."""
    for n in range(NOTHING_MISSING):
        yield _case("nothing missing", n, Truth(ROBOT_NAMES[n % 3]), n // 3, kind="nothing")


def one_effect() -> Iterator[Case]:
    """Every effect on every robot in three strengths."""
    places = itertools.product(enumerate(CATALOGUE), enumerate(ROBOT_NAMES), range(len(TARGETS)))
    for n, ((e, effect), (r, robot), s) in enumerate(places):
        truth = with_effect(robot, effect, EFFECT_SIZES[robot][effect][s])
        yield _case("one effect", n, truth, e + r + s, (effect,), effect)


def wrong_parameter() -> Iterator[Case]:
    """Declared values that are wrong."""
    places = [(path, robot) for robot in ROBOT_NAMES for path in WRONG_SIZES[robot]]
    for n, (path, robot) in enumerate(places):
        name = f"{PREFIX}{path}"
        truth = with_wrong(robot, path, WRONG_SIZES[robot][path])
        yield _case("wrong parameter", n, truth, n, (name,), name)


def two_effects() -> Iterator[Case]:
    """Two effects at once."""
    for n, ((robot, plan, names, _), sizes) in enumerate(zip(pairs(), PAIR_SIZES, strict=True)):
        values: dict[str, float] = {}
        for effect, size in zip(names, sizes, strict=True):
            values |= with_effect(robot, effect, size).effects
        yield _case("two effects", n, Truth(robot, values), PLANS.index(plan), names, " + ".join(names))


def outside() -> Iterator[Case]:
    """Causes that the catalogue does not have."""
    for n, ((kind, robot, plan, _), size) in enumerate(zip(strangers(), OUTSIDE_SIZES, strict=True)):
        truth = with_outside(robot, kind, size)
        yield _case("outside the catalogue", n, truth, PLANS.index(plan), kind=kind)


def special() -> Iterator[Case]:
    """What experimenters do, and what lies at the border of the catalogue: reported on its own."""
    variants: list[tuple[str, int, int, dict[str, object]]] = [
        # kind, cases that lack nothing, cases with one plain effect, how they differ
        ("sigma stated as half", 6, 3, {"options": {"sigma_scale": 0.5}}),
        ("sigma stated as double", 3, 3, {"options": {"sigma_scale": 2.0}}),
        ("error common to a pose", 6, 3, {"options": {"common": COMMON}}),
        ("frequencies drift", 3, 0, {"options": {"drift": DRIFT}}),
        ("modes not found", 3, 6, {"options": {"missing": MISSING}}),
        ("one gross outlier", 6, 3, {"edit": "outlier"}),
        ("modes numbered anew", 0, 3, {"edit": "numbers"}),
        ("half of the shapes blank", 0, 6, {"edit": "blanks"}),
        ("no shapes", 0, 6, {"shapes": ()}),
    ]
    plain = ("gearbox_compliance", "belt_mass", "axis_belt_stiffness", "clamp_compliance", "link_compliance")
    n = 0
    for kind, without, with_one, changes in variants:
        for k in range(without + with_one):
            robot, effect = ROBOT_NAMES[k % 3], plain[k % len(plain)]
            truth, names = Truth(robot), ()
            if k >= without:
                truth, names = with_effect(robot, effect, EFFECT_SIZES[robot][effect][-1]), (effect,)
            yield replace(_case("special", n, truth, k, names, kind), **{"shapes": SHAPES, **changes})
            n += 1
    for robot in ROBOT_NAMES:  # equals a payload and lighter carriages: both, in the catalogue's words
        names = "payload", f"{PREFIX}carriage.mass"
        yield replace(_case("special", n, with_outside(robot, "rod_taper", 0.9), n, names, "rods tapered"))
        n += 1


SUITES: dict[str, Callable[[], Iterator[Case]]] = {
    "nothing missing": nothing_missing,
    "one effect": one_effect,
    "wrong parameter": wrong_parameter,
    "two effects": two_effects,
    "outside the catalogue": outside,
    "special": special,
}


def _case(
    suite: str, number: int, truth: Truth, plan: int, names: tuple[str, ...] = (), kind: str = ""
) -> Case:
    shapes = () if number % WITHOUT_SHAPES == WITHOUT_SHAPES - 1 else SHAPES
    return Case(suite, number, PLANS[plan % len(PLANS)], truth, names, kind, shapes)


# How they are measured -----------------------------------------------------------------------------------------


def measured(case: Case) -> str:
    """Text of the file of a case's measurements."""
    rng = np.random.default_rng([case.seed, list(SUITES).index(case.suite), case.number])
    uncertain = {path: q for path, q in read(case.truth.robot).quantities.items() if q.sigma}
    drawn = {path: q.value + q.sigma * rng.standard_normal() for path, q in uncertain.items()}
    truth = replace(case.truth, values={**drawn, **case.truth.values})
    points = POSES[truth.robot][case.plan]
    options = {"sigma": SIGMA, "modes": MODES, "shapes": case.shapes, **case.options}
    text = measure_modes(truth.modes(points), points, rng=rng, **options)
    return edited(text, case.edit, rng) if case.edit else text


def edited(text: str, edit: str, rng: np.random.Generator) -> str:
    """Change the rows of a file: a gross error in a row that is fitted, another numbering, or blanks for shapes."""
    comment, _, table = text.partition("\n")
    rows = list(csv.DictReader(io.StringIO(table)))
    if edit == "outlier":
        fitted = fitted_poses(text)
        row = rows[rng.choice([i for i, r in enumerate(rows) if r["pose"] in fitted])]
        row["frequency"] = f"{float(row['frequency']) * (1.0 + OUTLIER):.9g}"
    for i, row in enumerate(rows):
        if edit == "numbers":
            row["mode"] = str(len(rows) - i)
        for name in [key for key in row if key.startswith("shape:")]:
            if edit == "blanks" and rng.random() < BLANK:
                row[name] = ""
    found = io.StringIO()
    found.write(f"{comment}\n")
    writer = csv.DictWriter(found, list(rows[0]), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)
    return found.getvalue()


def fitted_poses(text: str) -> list[str]:
    """Labels of the poses that a diagnosis fits."""
    data = measurements(text)
    return [data.labels[i] for i in split(data, None)[0]]


# How they are judged -------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Outcome:
    """What became of a case; what is not described is the diagnosis's own.

    Attributes
    ----------
    state : str
        ``adequate``; ``abstained`` (ambiguous, unexplained, insufficient_data); of what was found: ``named`` (each
        cause in a class of its own), ``partly`` (nothing wrong, but not every cause), ``wrong`` (a class without
        any of the causes).
    classes : tuple of tuple of str
        What was found, or the survivors.
    values : tuple of (name, found, sigma, true)
        Parameters of the causes that were named.
    renamed : bool
        Whether a class counts as right by `SAME` only.
    signal : float
        What was predicted; see `strengths`.
    beyond : tuple of float
        Of two effects: the signal that each gives beyond the other.
    """

    case: Case
    state: str
    verdict: str
    classes: tuple[tuple[str, ...], ...]
    values: tuple[tuple[str, float, float, float], ...]
    renamed: bool
    signal: float
    beyond: tuple[float, ...]
    seconds: float
    reason: str
    scatter: float
    outliers: int
    poses: int


def run(case: Case) -> Outcome:
    """Measure, diagnose and judge a case."""
    text = measured(case)
    data, robot = measurements(text), read(case.truth.robot)
    start = time.perf_counter()
    found = loop.diagnose(robot, data)
    seconds = time.perf_counter() - start
    truth = case.truth
    if "drift" in case.options:
        truth = replace(truth, outside={"thermal_drift": case.options["drift"]})
    lacking = bool(truth.effects or truth.values or truth.outside)
    return Outcome(
        case=case,
        state=judged(case.names, found),
        verdict=found.verdict,
        classes=tuple(f.members for f in found.effects) or found.survivors,
        values=tuple(values(case, found)),
        renamed=judged(case.names, found) != judged(case.names, found, same={}),
        signal=signal(truth, case.plan, holdout=found.held_out_poses) if lacking else 0.0,
        beyond=tuple(
            signal(truth, case.plan, holdout=found.held_out_poses, beside=other)
            for other in (case.names[::-1] if case.suite == "two effects" else ())
        ),
        seconds=seconds,
        reason=found.reason,
        scatter=found.scatter,
        outliers=len(found.outliers),
        poses=len(data.labels),
    )


def failed(case: Case, reason: str) -> Outcome:
    """The outcome of a case that broke the diagnosis."""
    return Outcome(case, "failed", "", (), (), False, float("inf"), (), 0.0, reason, 0.0, 0, 0)


def judged(names: tuple[str, ...], found: Diagnosis, same: Mapping[str, tuple[str, ...]] = SAME) -> str:
    """The state of an outcome."""
    if found.verdict != "effect_found":
        return "adequate" if found.verdict == "adequate" else "abstained"
    truths = [{name, *same.get(name, ())} for name in names]
    classes = [set(finding.members) for finding in found.effects]
    if any(not any(truth & members for truth in truths) for members in classes):
        return "wrong"
    for order in itertools.permutations(classes, len(truths)):
        if all(truth & members for truth, members in zip(truths, order, strict=True)):
            return "named"
    return "partly"


def values(case: Case, found: Diagnosis) -> Iterator[tuple[str, float, float, float]]:
    """Parameters of the causes that were named: what was found, its standard deviation, and the truth."""
    true = {f"effects.{name}": value for name, value in case.truth.effects.items()} | dict(case.truth.values)
    for finding in found.effects:
        for name in case.names:
            for value in finding.alternatives.get(name, ()):
                if value.name in true:
                    yield value.name, value.value, value.sigma, true[value.name]
