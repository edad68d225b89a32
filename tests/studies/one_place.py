"""Suites of one fault at one place, on all mechanisms: define the cases, run them and tabulate the outcomes.

    python -m studies.one_place --seed 20280301 --out docs/results/one-place                # `make suites`

`one_place_cases` has how the cases are drawn, sized and measured, `one_place_judging` how they are judged.  The rig
is `pkmodes_rig.one_place`: MuJoCo moves the bodies of the machines with closed loops, and springs, masses and
resonators act on what it moves.

Nine robots of seven mechanisms are measured at twelve poses with free motors.  An *ideal* laboratory finds all modes
up to 1.25 times the highest of the machine, with noise of `SIGMA` and shapes at all sensors with 2 %.  Every second
one is *realistic*, as in `clear_suites`, with this noise.  True values of uncertain parameters are drawn from their
priors.

Each fault is at a random place; one that cannot be as large as asked is drawn again.  A *clear* one changes the
frequencies by the range `CLEAR` (root mean square over all modes and poses: five to nine stated standard deviations),
beyond what the uncertain values can do within their uncertainties.  Of a *faint* one, the changes of all modes
together are in the range `FAINT` of stated standard deviations (root of the sum of squares), as in the suites of the
catalogue.  The laws that no term has are as large as clear faults.

A mass of a body has its weight; a link's is a uniform rod's.  Springs are relaxed at the pose; those between bodies
join two that slide, two that rotate, or the platform and another body.  The bearing of a pulley yields along the
belt, with no mass or one of 0.3 carriages or tool heads; a rail yields across itself, a base joint in any direction,
with the body's own mass.  A resonator slides on its body, along a direction of the base frame or the body's own, and
rides along in the others.

An answer is *named* if the class that was found, of at most `MEMBERS` terms, holds the true one, or one that is the
same to any measurement: a mass on the platform is a payload, a mass of a link a larger declared one.  It is named,
too, if each class that the catalogue claims holds such a one.  Of two faults, the class that holds one is *partly*
right.  All else is *wrong* where something is claimed, *adequate*, or silent (*abstained*).

The requirements were fixed before any case was run.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace

from pkmodes_rig.one_place.draws import kinds_of
from pkmodes_rig.one_place.laws import LAWS, laws_of
from pkmodes_rig.robots import ROBOTS
from studies.one_place_cases import PlaceCase, declared
from studies.one_place_judging import UNREACHED, PlaceOutcome, run
from studies.requirements import RIGHT, Row, covered, errors, headed, line, wrong
from studies.suite import Suite
from studies.tables import Table, Tables, confusion, count, grouped, in_words, stacked

#: Robots of each mechanism.
MACHINES = {
    "linear_delta": tuple(ROBOTS),
    "rotary_delta": ("rotary_delta",),
    "hexapod": ("hexapod",),
    "hexaglide": ("hexaglide",),
    "corexy": ("corexy",),
    "cartesian": ("cartesian",),
    "bed_slinger": ("bed_slinger",),
}
#: Cases of each kind of fault, or law, and complete machines, by suite and mechanism.
CASES = {
    "clear": dict.fromkeys(MACHINES, 8) | {"linear_delta": 20, "corexy": 5, "cartesian": 3, "bed_slinger": 3},
    "faint": dict.fromkeys(MACHINES, 1) | {"linear_delta": 4},
    "outside the grammar": dict.fromkeys(MACHINES, 1) | {"linear_delta": 4, "hexapod": 2},
    "complete": dict.fromkeys(MACHINES, 6) | {"linear_delta": 12},
}
#: Requirements: smallest fraction of the outcomes that should be so.
NAMED, NAMED_OTHERS, SILENT, COMPLETE, VALUES = 0.80, 0.70, 0.90, 0.95, 0.95
WRONG = 0.02
#: The kinds of faults of a complete machine.
NOTHING: tuple[str, ...] = ("",)
SEEN = "5, 7, 20271231, 20280103 and 20280201"


def cases() -> Iterator[PlaceCase]:
    """Yield the cases of all suites; every second one has a realistic laboratory."""
    for suite, counts in CASES.items():
        for name, machines in MACHINES.items():
            robot, kinds = declared(machines[0]), NOTHING
            if suite in ("clear", "faint"):
                kinds = kinds_of(name, robot.parameters)
            elif suite == "outside the grammar":
                kinds = laws_of(name)
            for n in range(counts[name] * len(kinds)):
                turn, place = divmod(n, len(kinds))
                machine = machines[(place + turn) % len(machines)]
                yield PlaceCase(suite, n, machine, kinds[place], realistic=(place + turn) % 2 == 1)


class OnePlace(Suite[PlaceCase, PlaceOutcome]):
    """Faults at one place that are no effects of the catalogue, laws that no term has, and complete machines."""

    description = "Measure the diagnosis of one fault at one place."
    run, failed = staticmethod(run), PlaceOutcome

    def cases(self, arguments: argparse.Namespace) -> Iterator[PlaceCase]:
        return (replace(case, seed=arguments.seed) for case in cases())

    def line(self, outcome: PlaceOutcome) -> str:
        case = f"{outcome.case.label} ({_truth(outcome)}), {100 * outcome.change:.2g} %"
        what = f"{case}: {outcome.state} {outcome.by} {outcome.status} {in_words(outcome)}"
        return f"{what} [{outcome.seconds:.1f} s] {outcome.reason}"

    def facts(self, outcomes: Sequence[PlaceOutcome]) -> dict[str, object]:
        return {
            "developed with the seeds": SEEN,
            "cases of the suites": sum(1 for _ in cases()),
            "none large enough": count(outcomes, UNREACHED),
            "true term among several that remain": sum(_remains(o) for o in outcomes if _is_fault(o)),
        }

    def tables(self, outcomes: Sequence[PlaceOutcome]) -> Tables:
        outcomes = [o for o in outcomes if o.state != UNREACHED]
        faults = [o for o in outcomes if _is_fault(o)]
        laws = [o for o in outcomes if o.case.suite == "outside the grammar"]
        complete = [o for o in outcomes if o.case.suite == "complete"]
        by_rule = dict(sorted(grouped(outcomes, lambda o: f"{o.rule}, {o.case.suite}").items()))
        silent = [o for o in faults if o.state in ("abstained", "adequate", "partly")]
        return {
            "requirements": headed(_requirements(outcomes)),
            "outcomes": stacked(
                "by",
                {
                    "mechanism and kind": confusion(
                        grouped(faults, lambda o: f"{o.case.mechanism}, {o.case.suite}: {o.case.kind}")
                    ),
                    "kind": confusion(grouped(faults, lambda o: f"{o.case.suite}: {o.case.kind}")),
                    "laboratory": confusion(grouped(faults, _laboratory)),
                    "rule that decided": confusion(by_rule),
                    "law": confusion(grouped(laws, lambda o: o.case.kind)),
                    "mechanism, complete": confusion(grouped(complete, lambda o: o.case.mechanism)),
                },
            ),
            "laws": Table.of(("law", "what it is, with its size"), LAWS.items()),
            "cases": stacked(
                "list",
                {
                    "confident and wrong": _listed([o for o in outcomes if o.state in ("wrong", "failed")]),
                    "faults that were not named": _listed(silent),
                },
            ),
        }


# Tables ------------------------------------------------------------------------------------------------------


def _requirements(outcomes: Sequence[PlaceOutcome]) -> Iterator[Row]:
    for name in MACHINES:
        group = [o for o in outcomes if o.case.mechanism == name]
        least = NAMED if name == "linear_delta" else NAMED_OTHERS
        for suite in ("clear", "faint"):
            some = [o for o in group if o.case.suite == suite]
            yield line(
                f"{name}, {suite}", f"named >= {100 * least:g} %", count(some, "named"), len(some), least
            )
        laws = [o for o in group if o.case.suite == "outside the grammar"]
        silent = count(laws, "abstained")
        yield line(f"{name}, outside the grammar", f"silent >= {100 * SILENT:g} %", silent, len(laws), SILENT)
        complete = [o for o in group if o.case.suite == "complete"]
        what = f"adequate >= {100 * COMPLETE:g} %"
        yield line(f"{name}, complete", what, count(complete, "adequate"), len(complete), COMPLETE)
    yield wrong("all", outcomes, WRONG)
    away = errors(outcomes)
    yield covered("all", away)
    right = sum(one <= RIGHT for one in away)
    yield line("all", f"value within 3 sigma >= {100 * VALUES:g} %", right, len(away), VALUES)


def _is_fault(o: PlaceOutcome) -> bool:
    return o.case.suite in ("clear", "faint")


def _laboratory(o: PlaceOutcome) -> str:
    return f"{o.case.mechanism}, {o.case.suite}, {'realistic' if o.case.realistic else 'ideal'}"


def _remains(o: PlaceOutcome) -> bool:
    return o.state == "abstained" and any(term in members for term in o.truth for members in o.classes)


def _truth(o: PlaceOutcome) -> str:
    return " + ".join(o.truth) or o.case.kind or "nothing"


def _listed(outcomes: Sequence[PlaceOutcome]) -> Table:
    head = ("case", "truth", "change [%]", "rows", "verdict", "terms", "classes")
    rows = [
        (
            *(o.case.label, _truth(o), f"{100 * o.change:.2g}", o.rows, o.verdict or o.state),
            *(o.status, in_words(o)),
        )
        for o in outcomes
    ]
    return Table.of(head, rows)


main = OnePlace().main

if __name__ == "__main__":
    main()
