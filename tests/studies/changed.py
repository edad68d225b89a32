"""Suite of pairs of campaigns of one machine, on all mechanisms: what changed?  Define, run and tabulate the cases.

    python -m studies.changed --seed 20290105 --out docs/results/changed                    # `make suites`

`changed_cases` has how the pairs are drawn, sized and measured, `changed_judging` how they are judged.

Nine robots of seven mechanisms are measured twice, at twelve poses, with free motors.  The robot file is wrong both
times alike: the true values of its uncertain parameters are drawn from their priors, and beyond that each mass,
inertia and stiffness of the machine, of each axis by itself, is wrong by up to 3 % (`WRONG`).  The second time all
drives (belts, reducers, legs) have another temperature: the stiffness of all of them is multiplied by one factor,
whose standard deviation is 1 % (`TEMPERATURE`).  That is not what is asked for.

In the suites *clear* and *sigmas* one thing changed: a fault at a random place as in `one_place`, the drive of one
axis that is softer, a mass on what the machine carries, or a cause common to all axes: all drives softer, or the same
joint of all axes yields.  A *clear* change is in the range `CLEAR` of the frequencies (root mean square over all
modes and poses).  In the suite *sigmas*, the changes of all modes that both campaigns found at the same pose are in
the range `FAINT` of standard deviations of the difference of the campaigns (root of the sum of squares).  What
changed on all axes alike is as large as that in both suites, beyond what another temperature can do within its
standard deviation: nothing else tells the two apart.

An *ideal* laboratory finds all modes, with noise of `SIGMA` and shapes at all sensors with 2 %.  Every second pair is
*realistic*: each campaign by itself misses modes at random and at nodes, cuts the band, has no or few shapes, and
states errors that are wrong in one case of four; the second one has other sensors and another noise; one to three
poses of the first are missing, and others are new.  Poses are repeated in another order, and with errors of 0.1 mm,
which every second file knows.

An answer is *named* if the class that was found, of at most `MEMBERS` members, holds what changed, or what is the
same to any measurement.  It is *wrong* if it names something without, *unchanged* if it says that nothing changed,
and *abstained* otherwise.

The requirements were fixed before any case was run.
"""

from __future__ import annotations

import argparse
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import replace
from itertools import chain, zip_longest

import numpy as np

from pkmodes_rig.one_place.changes import kinds_of_changes
from pkmodes_rig.one_place.faults import same_term
from studies.changed_cases import OF_CLEAR, OF_SIGMAS, UNCHANGED, PairCase
from studies.changed_judging import PairOutcome, run
from studies.one_place import MACHINES
from studies.one_place_cases import declared
from studies.one_place_judging import UNREACHED
from studies.requirements import RIGHT, Row, covered, errors, headed, line, wrong
from studies.suite import Suite
from studies.tables import Table, Tables, confusion, count, grouped, in_words, stacked

#: Pairs with one thing changed, and with nothing changed, by mechanism; those with six legs are slow.
CHANGED = {
    "linear_delta": 35,
    "rotary_delta": 24,
    "hexapod": 12,
    "hexaglide": 13,
    "corexy": 24,
    "cartesian": 21,
    "bed_slinger": 21,
}
SAME = {
    "linear_delta": 12,
    "rotary_delta": 8,
    "hexapod": 4,
    "hexaglide": 4,
    "corexy": 8,
    "cartesian": 7,
    "bed_slinger": 7,
}
#: Requirements: smallest fraction of the outcomes that should be so, and largest.
NAMED, SAID, VALUES, WRONG_NAMES = 0.80, 0.95, 0.95, 0.02
SEEN = "5, 6, 7, 20290101 and 20290103"
#: All states of an outcome, in the order of the columns.
STATES = ("named", "wrong", "abstained", "unchanged", "failed")
#: Lower ends of the groups of strengths.
STRENGTHS = (0, 6, 9, 14, 25)
#: Seed of the order in which some pairs are chosen.
ORDER = 12


def cases(seed: int = 1) -> tuple[PairCase, ...]:
    """Return the cases of all suites; every second one is realistic, of each kind of change alike.

    Kinds and machines follow each other; the suites and the laboratories of a kind alternate from turn to turn.
    """
    return tuple(replace(case, seed=seed) for case in _cases())


def pair(suite: str, number: int, seed: int) -> PairCase:
    """Return one case by its suite, its number there, and its seed."""
    return next(case for case in cases(seed) if (case.suite, case.number) == (suite, number))


def some_pairs(seed: int, count: int) -> tuple[PairCase, ...]:
    """Return a sample of the cases: more pairs begin with the same ones.

    The mechanisms take turns; within each, changes and no changes are mixed.
    """
    rng, every = np.random.default_rng(ORDER), cases(seed)
    mixed = []
    for mechanism in MACHINES:
        own = [case for case in every if case.mechanism == mechanism]
        mixed.append([own[int(i)] for i in rng.permutation(len(own))])
    turns = chain.from_iterable(zip_longest(*mixed))
    return tuple(case for case in turns if case is not None)[:count]


def _cases() -> Iterator[PairCase]:
    numbers: Counter[str] = Counter()
    for mechanism, machines in MACHINES.items():
        kinds = kinds_of_changes(mechanism, declared(machines[0]).parameters)
        for n in range(CHANGED[mechanism]):
            turn, place = divmod(n, len(kinds))
            suite, realistic = (OF_CLEAR, OF_SIGMAS)[(turn + place) % 2], (turn + place) // 2 % 2 == 1
            machine = machines[(turn + place) % len(machines)]
            yield PairCase(suite, numbers[suite], machine, kinds[place], realistic)
            numbers[suite] += 1
        for n in range(SAME[mechanism]):
            machine = machines[n // 2 % len(machines)]
            yield PairCase(UNCHANGED, numbers[UNCHANGED], machine, realistic=n % 2 == 1)
            numbers[UNCHANGED] += 1


class Changed(Suite[PairCase, PairOutcome]):
    """Pairs of campaigns between which one thing changed, or nothing."""

    description = "Measure what is said of two campaigns of one machine."
    run, failed = staticmethod(run), PairOutcome

    def options(self, parser: argparse.ArgumentParser) -> None:
        parser.add_argument("--pairs", type=int, help="run a sample of so many pairs")

    def cases(self, arguments: argparse.Namespace) -> Iterable[PairCase]:
        if arguments.pairs is None:
            return cases(arguments.seed)
        return some_pairs(arguments.seed, arguments.pairs)

    def line(self, outcome: PairOutcome) -> str:
        case = f"{outcome.case.label} ({_truth(outcome)}), {outcome.strength:.2g} sigma"
        what = f"{case}: {outcome.state} {outcome.by} {in_words(outcome)}"
        return f"{what} [{outcome.seconds:.1f} s] {outcome.reason}"

    def facts(self, outcomes: Sequence[PairOutcome]) -> dict[str, object]:
        silent = _silent(outcomes)
        return {
            "developed with the seeds": SEEN,
            "cases of the suites": len(cases()),
            "none large enough": count(outcomes, UNREACHED),
            "changes that were not named": len(silent),
            "what changed is among what remains": sum(map(_remains, silent)),
        }

    def tables(self, outcomes: Sequence[PairOutcome]) -> Tables:
        outcomes = [o for o in outcomes if o.state != UNREACHED]
        by_strength = sorted((o for o in outcomes if o.case.kind), key=lambda o: o.strength)
        return {
            "requirements": headed(_requirements(outcomes)),
            "outcomes": stacked(
                "by",
                {
                    "mechanism and suite": _confusion(
                        outcomes, lambda o: f"{o.case.mechanism}, {o.case.suite}"
                    ),
                    "what changed": _confusion(outcomes, lambda o: o.case.kind or "nothing"),
                    "laboratory": _confusion(outcomes, lambda o: f"{o.case.suite}, {_laboratory(o)}"),
                    "strength [sigma]": _confusion(by_strength, _strength),
                    "rule that decided": _confusion(sorted(outcomes, key=lambda o: o.rule), lambda o: o.rule),
                    "changes that were not named": _confusion(
                        _silent(outcomes), lambda o: f"{o.case.mechanism}: {o.case.kind}"
                    ),
                },
            ),
            "cases": _listed(outcomes),
        }


def _silent(outcomes: Sequence[PairOutcome]) -> list[PairOutcome]:
    return [o for o in outcomes if o.case.kind and o.state in ("abstained", "unchanged")]


# Tables ------------------------------------------------------------------------------------------------------


def _confusion(outcomes: Iterable[PairOutcome], key: Callable[[PairOutcome], str]) -> Table:
    return confusion(grouped(outcomes, key), STATES)


def _requirements(outcomes: Sequence[PairOutcome]) -> Iterator[Row]:
    some = [o for o in outcomes if o.case.kind]
    what = f"named >= {100 * NAMED:g} %"
    yield line("all changes", what, count(some, "named"), len(some), NAMED)
    for suite in (OF_CLEAR, OF_SIGMAS):
        of_suite = [o for o in some if o.case.suite == suite]
        yield line(suite, what, count(of_suite, "named"), len(of_suite), NAMED)
    yield wrong("all", outcomes, WRONG_NAMES)
    none = [o for o in outcomes if not o.case.kind]
    yield line("nothing changed", f"said so >= {100 * SAID:g} %", count(none, "unchanged"), len(none), SAID)
    away = errors(outcomes)
    yield covered("all", away)
    right = sum(error <= RIGHT for error in away)
    yield line("all", f"value within 3 sigma >= {100 * VALUES:g} %", right, len(away), VALUES)


def _laboratory(o: PairOutcome) -> str:
    return "realistic" if o.case.realistic else "ideal"


def _strength(o: PairOutcome) -> str:
    low = next((low for low in STRENGTHS[::-1] if o.strength >= low), 0)
    above = [high for high in STRENGTHS if high > low]
    return f"{low} to {above[0]}" if above else f"{low} and more"


def _remains(o: PairOutcome) -> bool:
    return any(same_term(member, name) for members in o.classes for member in members for name in o.names)


def _truth(o: PairOutcome) -> str:
    """Return what changed; of a cause common to all axes its kind."""
    return o.truth[0] if len(o.truth) == 1 else o.case.kind or "nothing"


def _listed(outcomes: Sequence[PairOutcome]) -> Table:
    head = (
        *("pair", "truth", "change [%]", "sigmas", "drives [%]", "rows", "later rows", "state", "classes"),
        "rule",
    )
    rows = [
        (
            *(o.case.label, _truth(o), f"{100 * o.change:.2g}", f"{o.strength:.3g}"),
            *(f"{100 * (o.drives - 1):+.1f}", *o.rows, f"{o.state} {o.by}".strip(), in_words(o), o.rule),
        )
        for o in outcomes
    ]
    return Table.of(head, rows)


main = Changed().main

if __name__ == "__main__":
    main()
