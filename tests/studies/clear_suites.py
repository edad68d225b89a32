"""Suites of clear causes on all mechanisms alike: define the cases, run them and tabulate the outcomes.

    python -m studies.clear_suites --seed 20261207 --out docs/results/clear-causes          # `make suites`

Five robots of three mechanisms are measured at twelve poses, each case by a laboratory of its own: 15 % of the modes
are missed, more of them at nodes; a band may cut some off; few sensors in one case of five, none in another one;
shape noise of 1 to 5 %, stated, partly stated or not; errors that differ from row to row and, in one case in four,
are all wrong by a common factor (15 %).  The true values of the uncertain parameters are drawn from their priors.
Each cause is sized so that the modes found have a signal in the range of `TARGETS`, in standard deviations.  Causes
that tie the robot to ground are sized without the modes that only then can be measured; a cause that adds a mode is
1.5 times as large as where that mode is first seen.  `clear_cases` has how cases are sized, measured and judged.

The requirements were fixed before any case was run.
"""

from __future__ import annotations

import argparse
import itertools
from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from pkmodes_rig import ROBOTS
from studies import mechanism_suites, sizes
from studies.clear_cases import ClearCase, ClearOutcome, run, splits
from studies.requirements import RIGHT, Row, covered, errors, headed, line, wrong
from studies.running import Pool, run_all
from studies.specimens import effects_of
from studies.suite import Suite
from studies.tables import Table, Tables, confusion, count, grouped, in_words, stacked

#: Robots of each mechanism.
MACHINES = {"linear_delta": tuple(ROBOTS), "rotary_delta": ("rotary_delta",), "corexy": ("corexy",)}
#: Cases of each suite and mechanism, and those that are diagnosed with each pose held out.
CASES, SPLIT = 40, 6
#: Range of the signals of one effect, of each of two effects, and of a cause outside the catalogue.
TARGETS = {"one effect": (9.0, 14.0), "two effects": (10.0, 25.0), "outside the catalogue": (9.0, 50.0)}
#: Causes outside the catalogue; a soft end of one run of a CoreXY is left out: another free length is equivalent.
OUTSIDE = {"linear_delta": sizes.KINDS} | {
    name: tuple(kind for kind in kinds if kind != "one_run")
    for name, kinds in mechanism_suites.OUTSIDE.items()
}
#: Requirements: smallest fraction of the outcomes that should be so, by suite.
LEAST = {
    "one effect": ("named", 0.95),
    "two effects": ("named", 0.70),
    "outside the catalogue": ("abstained", 0.92),
}
WRONG = 0.01
SEEN = "1 to 9"


def cases() -> Iterator[ClearCase]:
    """Yield the cases of all suites."""
    for name, machines in MACHINES.items():
        effects = effects_of(name)
        pairs = list(itertools.combinations(effects, 2))
        drawn = np.random.default_rng(0).permutation(len(pairs))
        for n in range(CASES):
            machine = machines[n % len(machines)]
            # Every robot meets every effect.
            yield _case("one effect", n, machine, (effects[(n + n // len(effects)) % len(effects)],))
            yield _case("two effects", n, machine, pairs[drawn[n % len(pairs)]])
            kinds = OUTSIDE[name]
            kind = kinds[(n + n // len(kinds)) % len(kinds)]
            yield replace(_case("outside the catalogue", n, machine, (kind,)), outside=True)


def _case(suite: str, n: int, machine: str, kinds: tuple[str, ...]) -> ClearCase:
    return ClearCase(suite, n, machine, kinds, TARGETS[suite])


def split_cases() -> Iterator[ClearCase]:
    """Yield the cases that are diagnosed with each pose held out, evenly spread."""
    for suite in ("one effect", "outside the catalogue"):
        for name in MACHINES:
            some = [case for case in cases() if case.suite == suite and case.mechanism == name]
            yield from (some[(2 * k + 1) * len(some) // (2 * SPLIT)] for k in range(SPLIT))


class ClearCauses(Suite[ClearCase, ClearOutcome]):
    """Clear causes of the linear delta, the rotary delta and the CoreXY, and splits of some of them.

    Parameters
    ----------
    split : sequence of sequence of ClearOutcome
        Of each case that is diagnosed once for each pose, with that pose alone held out: the outcomes.
    """

    description = "Measure the diagnosis of clear causes on all mechanisms."
    run, failed = staticmethod(run), ClearOutcome

    def __init__(self, split: Sequence[Sequence[ClearOutcome]] = ()) -> None:
        self._split = split

    def options(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument("--no-splits", action="store_true", help="leave out the splits")

    def cases(self, arguments: argparse.Namespace) -> Iterator[ClearCase]:
        return (replace(case, seed=arguments.seed) for case in cases())

    def line(self, outcome: ClearOutcome) -> str:
        return outcome_line(outcome)

    def after(self, outcomes: Sequence[ClearOutcome], arguments: argparse.Namespace, pool: Pool) -> None:
        again = [] if arguments.no_splits else list(split_cases())
        again = [replace(case, seed=arguments.seed) for case in again if arguments.only in case.label]
        chosen = again[:: arguments.every]
        self._split = run_all(
            splits, chosen, pool, lambda some: "\n".join(map(outcome_line, some)), _failed_split
        )

    def facts(self, outcomes: Sequence[ClearOutcome]) -> dict[str, object]:
        missed = _missed(outcomes)
        return {
            "developed with the seeds": SEEN,
            "splits": sum(map(len, self._split)),
            "not named": len(missed),
            "not named, but among several that remain": sum(map(_remains, missed)),
        }

    def tables(self, outcomes: Sequence[ClearOutcome]) -> Tables:
        splits_of = {f"{some[0].case.label}: {causes(some[0])}": some for some in self._split}
        outside = [o for o in outcomes if o.case.outside and o.state == "adequate"]
        return {
            "requirements": headed([*_requirements(outcomes), *_requirements_of_splits(self._split)]),
            "outcomes": stacked(
                "by",
                {"suite": confusion(grouped(outcomes, _suite)), "splits of a case": confusion(splits_of)},
            ),
            "cases": stacked(
                "list",
                {
                    "confident and wrong": listed([o for o in outcomes if o.state in ("wrong", "failed")]),
                    "causes that were not named": listed(_missed(outcomes)),
                    "causes outside the catalogue that were missed": listed(outside),
                },
            ),
        }


def _failed_split(*arguments: Any, **options: Any) -> list[ClearOutcome]:
    return [ClearOutcome(*arguments, **options)]


def outcome_line(o: ClearOutcome) -> str:
    """Return an outcome in a line, for the terminal."""
    what = f"{o.case.label} ({causes(o)}), {o.signal:.3g}: {o.state} {in_words(o)}"
    return f"{what} [{o.seconds:.1f} s] {o.reason}"


# Tables ------------------------------------------------------------------------------------------------------


def _missed(outcomes: Sequence[ClearOutcome]) -> list[ClearOutcome]:
    return [o for o in outcomes if o.case.names and o.state != "named"]


def _requirements(outcomes: Sequence[ClearOutcome]) -> Iterator[Row]:
    for name in MACHINES:
        group = [o for o in outcomes if o.case.mechanism == name]
        for suite, (state, least) in LEAST.items():
            some = [o for o in group if o.case.suite == suite]
            what = f"{state} >= {100 * least:g} %"
            yield line(f"{name}, {suite}", what, count(some, state), len(some), least=least)
        yield wrong(f"{name}, all", group, WRONG)
        away = errors(group)
        yield covered(f"{name}, all", away)
        right = sum(one <= RIGHT for one in away)
        yield line(f"{name}, all", "value within 3 sigma >= 95 %", right, len(away), least=0.95)


def _requirements_of_splits(split: Sequence[Sequence[ClearOutcome]]) -> Iterator[Row]:
    yield wrong("splits", [o for some in split for o in some], WRONG)
    what = "cases in which two splits claim different causes: none"
    yield line("splits", what, sum(map(_contradict, split)), len(split), most=0.0)


def _contradict(outcomes: Sequence[ClearOutcome]) -> bool:
    """Return whether two splits claim causes that are not in one class."""
    claims = [o.classes for o in outcomes if o.verdict == "effect_found"]
    return any(
        not all(any(set(a) & set(b) for b in other) for a in one)
        for one, other in itertools.permutations(claims, 2)
    )


def _remains(o: ClearOutcome) -> bool:
    """Return whether the true causes, and no others, are one of several explanations that remain."""
    members = itertools.chain.from_iterable(o.classes)
    return o.verdict == "ambiguous" and any(set(m.split(" + ")) == set(o.case.names) for m in members)


def _suite(o: ClearOutcome) -> str:
    return f"{o.case.mechanism}, {o.case.suite}"


def causes(o: ClearOutcome) -> str:
    """Return the causes of a case."""
    return " + ".join(o.case.kinds) or "nothing"


def listed(outcomes: Sequence[ClearOutcome]) -> Table:
    """Return cases, with what was found of them."""
    head = ("case", "truth", "signal", "rows", "verdict", "classes")
    rows = [
        (o.case.label, causes(o), f"{o.signal:.3g}", o.rows, o.verdict or o.state, in_words(o))
        for o in outcomes
    ]
    return Table.of(head, rows)


main = ClearCauses().main

if __name__ == "__main__":
    main()
