"""Measure the limits of what a diagnosis does not find, and the saved standard deviations, on the virtual test rig.

    python -m studies.limits --seed 20261213 --out docs/results/limits                   # `make suites`

Each case has one cause of the catalogue or one wrong declared value, too small to be found: its predicted signal is
drawn evenly between nothing and the hidden size of the other suites, three standard deviations and a little more.
The true values of the uncertain parameters are drawn from their priors.  Half of the cases have shapes, a quarter a
realistic laboratory with missed modes and a band.  A limit covers if the true size is not above it; an interval
covers if it contains the true value.  Limits at a physical bound cover more often than stated: a size of nearly
nothing always lies below its limit.
"""

from __future__ import annotations

import argparse
import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

import numpy as np

from pkmodes import updating
from pkmodes.loop.updating.candidates import PREFIX
from pkmodes_rig import SENSORS, drawn_values
from studies.cases import ROBOT_NAMES, Case, tried
from studies.requirements import INTERVAL, Row, headed, line
from studies.sizes import EFFECT_SIZES, TARGETS, WRONG_SIZES, WRONG_TARGETS
from studies.specimens import Specimen, measurements, robot_of, with_effect, with_wrong
from studies.strengths import CATALOGUE, PLANS, SEED
from studies.suite import Suite
from studies.tables import Table, Tables

SUITE = "hidden causes"
#: Seeds used during development.
SEEN = f"{SEED}, 1 to 20 and 20261206"
#: Cases of each effect and of each wrong value, on each robot that has them.
EACH_EFFECT, EACH_VALUE = 3, 2
#: Verdicts that are counted.
VERDICTS = ("adequate", "effect_found", "ambiguous", "unexplained", "insufficient_data")
#: Largest predicted signal [sigma].
LARGEST = 4.0


@dataclass(frozen=True)
class Hidden:
    """A case: what is hidden, and how large it is.

    Attributes
    ----------
    case : Case
    sizes : dict of str to float
        True deviation from the declared value by the key of the limit.
    values : dict of str to float
        True values of the uncertain parameters.
    """

    case: Case
    sizes: dict[str, float]
    values: dict[str, float]


@dataclass(frozen=True)
class Shown:
    """What a diagnosis said of a case.

    Attributes
    ----------
    limits : tuple of (float, float or None)
        True size and limit of each parameter of the hidden cause; empty if a class with it is claimed.
    intervals : tuple of (float, float, float)
        Distance of the true from the refitted value, its standard deviation, and the saved one.
    """

    kind: str
    robot: str
    verdict: str
    limits: tuple[tuple[float, float | None], ...]
    intervals: tuple[tuple[float, float, float], ...]
    seconds: float


def cases(seed: int) -> Iterator[Hidden]:
    """Yield all cases."""
    n = 0
    for robot in ROBOT_NAMES:
        effects = [(effect, EFFECT_SIZES[robot][effect][0] / TARGETS[0]) for effect in CATALOGUE]
        # The signal of a wrong value grows with it.
        wrong = [
            (path, size / WRONG_TARGETS[k % len(WRONG_TARGETS)])
            for k, (path, size) in enumerate(WRONG_SIZES[robot].items())
        ]
        kinds = [(kind, unit, True) for kind, unit in effects] * EACH_EFFECT
        kinds += [(kind, unit, False) for kind, unit in wrong] * EACH_VALUE
        for kind, unit, is_effect in kinds:
            yield _hidden(robot, kind, unit, is_effect, n, seed)
            n += 1


def _hidden(robot: str, kind: str, unit: float, is_effect: bool, n: int, seed: int) -> Hidden:
    rng = np.random.default_rng([seed, 77, n])
    size = float(rng.uniform(0.0, LARGEST) * unit)
    values = drawn_values(robot_of(robot), rng)
    if is_effect:
        truth = with_effect(robot, kind, size)
        sizes = {name: abs(value) for name, value in truth.effects.items()}
        name = kind
    else:
        truth, name = with_wrong(robot, kind, size), f"{PREFIX}{kind}"
        sizes = {kind: abs(size)}
    truth = replace(truth, values={**values, **truth.values})
    plan, shapes = PLANS[n % len(PLANS)], SENSORS if n % 2 else ()
    case = Case(SUITE, n, plan, truth, (name,), kind, shapes, seed=seed, realistic=n % 4 == 3)
    return Hidden(case, sizes, values)


def run(hidden: Hidden) -> Shown:
    """Measure and diagnose a case."""
    case, start = hidden.case, time.perf_counter()
    assert isinstance(case.truth, Specimen)
    robot = robot_of(case.truth.machine)
    found = updating.diagnose(robot, measurements(tried(case).text), terms=False)
    limits = tuple(
        (size, found.limits[name].value) for name, size in hidden.sizes.items() if name in found.limits
    )
    refitted = [value for value in found.corrected if value.name in hidden.values]
    intervals = tuple(
        (abs(hidden.values[value.name] - value.value), value.sigma, value.saved_sigma)
        for value in (refitted if found.verdict == "adequate" else ())
    )
    return Shown(case.kind, case.truth.machine, found.verdict, limits, intervals, time.perf_counter() - start)


def rows(outcomes: Sequence[Shown]) -> Iterator[Row]:
    """Yield the rows of the requirements; they were fixed before the suite was run."""
    bounded = [(size, limit) for o in outcomes for size, limit in o.limits if limit is not None]
    covered = sum(size <= limit for size, limit in bounded)
    yield line(SUITE, "95 % limits cover 90-99 %", covered, len(bounded), 0.90, 0.99)
    intervals = [one for o in outcomes for one in o.intervals]
    saved = sum(away <= INTERVAL * sigma for away, _, sigma in intervals)
    yield line(
        SUITE, "adequate: 95 % intervals of saved values cover >= 95 %", saved, len(intervals), least=0.95
    )


class Limits(Suite[Hidden, Shown]):
    """Causes of the linear delta that are too small to be found."""

    description = "Measure the limits on the virtual test rig."
    run = staticmethod(run)

    def cases(self, arguments: argparse.Namespace) -> Iterator[Hidden]:
        return cases(arguments.seed)

    def label(self, case: Hidden) -> str:
        return case.case.label

    def line(self, outcome: Shown) -> str:
        what = f"{outcome.robot} {outcome.kind}: {outcome.verdict} {outcome.limits}"
        return f"{what} [{outcome.seconds:.1f} s]"

    def facts(self, outcomes: Sequence[Shown]) -> dict[str, object]:
        verdicts = Counter(o.verdict for o in outcomes)
        limits = [limit for o in outcomes for _, limit in o.limits]
        intervals = [one for o in outcomes for one in o.intervals]
        wider = sorted(saved / sigma for _, sigma, saved in intervals)
        return {
            "developed with the seeds": SEEN,
            "largest signal": f"{LARGEST:g}",
            **{verdict: verdicts[verdict] for verdict in VERDICTS},
            "limits": len(limits),
            "null": limits.count(None),
            "intervals of the fit alone": len(intervals),
            "of these covering": sum(away <= INTERVAL * sigma for away, sigma, _ in intervals),
            "saved sigma / sigma of the fit, median": f"{wider[len(wider) // 2]:.3g}" if wider else "",
        }

    def tables(self, outcomes: Sequence[Shown]) -> Tables:
        return {"requirements": headed(rows(outcomes)), "hidden": _table(outcomes)}


def _table(outcomes: Sequence[Shown]) -> Table:
    """Return what became of each hidden cause."""
    cells = []
    for kind in dict.fromkeys(o.kind for o in outcomes):
        some = [o for o in outcomes if o.kind == kind]
        limits = [one for o in some for one in o.limits]
        bounded = [(size, limit) for size, limit in limits if limit is not None]
        covered = sum(size <= limit for size, limit in bounded)
        claimed = sum(not o.limits for o in some)
        cells.append((kind, len(some), claimed, len(bounded), covered, len(limits) - len(bounded)))
    return Table.of(("hidden", "cases", "claimed", "limits", "covered", "null"), cells)


main = Limits().main

if __name__ == "__main__":
    main()
