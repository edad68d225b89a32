"""Suites of the diagnosis of the hexapod and the hexaglide: define the cases, run them and tabulate the outcomes.

    python -m studies.six_legged_suites --seed 20271217 --out docs/results/six-legs         # `make suites`

Cases are sized, measured and judged as those of the other mechanisms (`clear_cases`), at twelve poses of their own,
drawn for each case in a box of positions and rotations, by a laboratory as unkind as theirs.  The rig is
`pkmodes_rig.six_legged`: MuJoCo gives inertia, weight and motion of the turning platform, springs and belts are rows
of the contract.  The masses of platforms (1 %), the stiffnesses of legs or belts (2 %) and the inertias of motors (2
%) are uncertain; their true values are drawn from these priors.  Every second case has sensors on the platform, where
rotations are measured by displacements over 100 mm, the others on the legs or carriages.  Motors are held in every
second round of the causes that they show then.  The pairing of modes was developed on cases of other seeds.  The
requirements were fixed before any case was run.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator, Sequence
from dataclasses import replace

from studies import clear_suites
from studies.clear_cases import ClearCase, ClearOutcome, run
from studies.clear_suites import causes, listed
from studies.motors import shows
from studies.requirements import Row, covered, errors, headed, line, wrong
from studies.specimens import SIX_LEGGED, effects_of
from studies.suite import Suite
from studies.tables import Tables, confusion, count, grouped, stacked

#: Cases of each suite, and the range of the signals of their causes.
CASES = {"one effect": 40, "nothing missing": 10, "outside the catalogue": 10}
TARGETS = {"one effect": (9.0, 14.0), "nothing missing": (0.0, 0.0), "outside the catalogue": (9.0, 50.0)}
#: Causes outside the catalogue.
OUTSIDE = {
    "hexapod": ("tuned_absorber", "directional_cable", "one_servo", "leg_hose"),
    "hexaglide": (
        *("tuned_absorber", "directional_cable", "one_servo", "leg_hose"),
        *("one_gearbox", "one_link"),
    ),
}
#: Requirements: smallest fraction of the outcomes that should be so, by suite.
LEAST = {
    "one effect": ("named", 0.95),
    "nothing missing": ("adequate", 0.95),
    "outside the catalogue": ("abstained", 0.92),
}
WRONG = 0.01


def cases() -> Iterator[ClearCase]:
    """Yield the cases of all suites; motors are held in every second case whose cause they show."""
    for machine in SIX_LEGGED:
        kinds_of = {"one effect": effects_of(machine), "outside the catalogue": OUTSIDE[machine]}
        for suite, number in CASES.items():
            kinds = kinds_of.get(suite, ())
            for n in range(number):
                turn = n // len(kinds) if kinds else n
                chosen = (kinds[n % len(kinds)],) if kinds else ()
                case = ClearCase(suite, n, machine, chosen, TARGETS[suite])
                held = turn % 2 == 1 and shows("held", chosen)
                outside = suite == "outside the catalogue"
                yield replace(case, outside=outside, drives="held" if held else "free")


class SixLegs(Suite[ClearCase, ClearOutcome]):
    """Clear causes of the hexapod and the hexaglide, and complete ones."""

    description = "Measure the diagnosis of machines with six legs."
    run, failed = staticmethod(run), ClearOutcome

    def cases(self, arguments: argparse.Namespace) -> Iterator[ClearCase]:
        return (replace(case, seed=arguments.seed) for case in cases())

    def line(self, outcome: ClearOutcome) -> str:
        return clear_suites.outcome_line(outcome)

    def facts(self, outcomes: Sequence[ClearOutcome]) -> dict[str, object]:
        return {"cases of the suites": sum(1 for _ in cases())}

    def tables(self, outcomes: Sequence[ClearOutcome]) -> Tables:
        missed = [o for o in outcomes if o.case.names and o.state != "named"]
        false = [o for o in outcomes if o.case.suite == "nothing missing" and o.state != "adequate"]
        outside = [o for o in outcomes if o.case.outside and o.state == "adequate"]
        return {
            "requirements": headed(_requirements(outcomes)),
            "outcomes": stacked(
                "by",
                {
                    "suite": confusion(grouped(outcomes, _suite)),
                    "cause": confusion(grouped((o for o in outcomes if o.case.kinds), _cause)),
                },
            ),
            "cases": stacked(
                "list",
                {
                    "confident and wrong": listed([o for o in outcomes if o.state in ("wrong", "failed")]),
                    "causes that were not named": listed(missed),
                    "nothing missing, but not adequate": listed(false),
                    "causes outside the catalogue that were missed": listed(outside),
                },
            ),
        }


# Tables ------------------------------------------------------------------------------------------------------


def _requirements(outcomes: Sequence[ClearOutcome]) -> Iterator[Row]:
    for name in SIX_LEGGED:
        group = [o for o in outcomes if o.case.machine == name]
        for suite, (state, least) in LEAST.items():
            some = [o for o in group if o.case.suite == suite]
            if some:
                what = f"{state} >= {100 * least:g} %"
                yield line(f"{name}, {suite}", what, count(some, state), len(some), least=least)
        if group:
            yield wrong(f"{name}, all", group, WRONG)
            yield covered(f"{name}, all", errors(group))


def _suite(o: ClearOutcome) -> str:
    return f"{o.case.machine}, {o.case.suite}, motors {o.case.drives}"


def _cause(o: ClearOutcome) -> str:
    return f"{o.case.machine}, {o.case.suite}: {causes(o)}"


main = SixLegs().main

if __name__ == "__main__":
    main()
