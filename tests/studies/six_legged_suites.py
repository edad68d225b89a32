"""Suites of the diagnosis of the hexapod and the hexaglide: define the cases, run them and tabulate the outcomes.

    python -m studies.six_legged_suites --seed 20271217 --out docs/six-legs-measured.md    # `make suites`

Cases are sized, measured and judged as those of the other mechanisms (`clear_cases`), at twelve poses of their own.
The requirements were fixed before any case was run.
"""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace

from studies.clear_cases import ClearCase, ClearOutcome, run
from studies.motors import shows
from studies.requirements import covered, errors, headed, line, wrong
from studies.running import Pool, parallel_command_line, publish, run_all
from studies.specimens import SIX_LEGGED, effects_of
from studies.tables import confusion, count, grouped, in_words, listed, times

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


# Running -----------------------------------------------------------------------------------------------------


def main() -> None:
    """Run the suites and write their page."""
    parser = parallel_command_line("Measure the diagnosis of machines with six legs.")
    parser.add_argument("--only", default="", help="part of the label of the cases to run")
    parser.add_argument("--every", type=int, default=1, help="run one case in this many")
    arguments = parser.parse_args()
    pool = Pool.of(arguments)
    start = time.perf_counter()
    chosen = [replace(case, seed=arguments.seed) for case in cases() if arguments.only in case.label]
    outcomes = run_all(run, chosen[:: arguments.every], pool, _said, ClearOutcome)
    publish(_page(outcomes, time.perf_counter() - start, pool), arguments.out)


def _said(o: ClearOutcome) -> str:
    what = f"{o.case.label} ({_causes(o)}), {o.signal:.3g}: {o.state} {in_words(o)}"
    return f"{what} [{o.seconds:.1f} s] {o.reason}"


# Tables ------------------------------------------------------------------------------------------------------


def _page(outcomes: Sequence[ClearOutcome], seconds: float, pool: Pool) -> list[str]:
    missed = [o for o in outcomes if o.case.names and o.state != "named"]
    false = [o for o in outcomes if o.case.suite == "nothing missing" and o.state != "adequate"]
    outside = [o for o in outcomes if o.case.outside and o.state == "adequate"]
    return [
        "# The diagnosis of machines with six legs, measured",
        "",
        "Written by `make suites`; do not edit. `tests/studies/six_legged_suites.py` defines the cases",
        "and the requirements, `clear_cases.py` how they are sized, measured and judged; terms are those of",
        "docs/diagnosis-measured.md. The rig (`tests/pkmodes_rig/six_legged.py`) shares no code with the model:",
        "MuJoCo gives inertia, weight and motion of the turning platform, springs and belts are rows of the",
        "contract.",
        "",
        "`robots/hexapod.toml` and `robots/hexaglide.toml` are measured at twelve poses, drawn for each case in a",
        "box of positions and rotations, by a laboratory of its own, which is as unkind as in",
        "docs/clear-causes-measured.md. The masses of platforms (1 %), the stiffnesses of legs or belts (2 %) and",
        "the inertias of motors (2 %) are uncertain; their true values are drawn from these priors. Every second",
        "case has sensors on the platform, where rotations are measured by displacements over 100 mm, the others on",
        "the legs or carriages. Motors are held in every second round of the causes that they show then.",
        "",
        f"Seed {outcomes[0].case.seed}.  The pairing of modes was developed on cases of other seeds.",
        *_left_out(outcomes),
        "",
        "## Requirements",
        "",
        *headed("mechanism, suite", _requirements(outcomes)),
        "",
        "## Outcomes by suite",
        "",
        *confusion(grouped(outcomes, _suite), "suite"),
        "",
        "## Outcomes by cause",
        "",
        *confusion(grouped((o for o in outcomes if o.case.kinds), _cause), "cause"),
        "",
        "## Confident and wrong",
        "",
        "A hose along a leg has the same effect as a stiffer leg if the motor is held, and nearly the same on modes",
        "in which the motor hardly moves.  The claim that the legs are not equally stiff is then correct in effect,",
        "but is counted as wrong.",
        "",
        *_listed([o for o in outcomes if o.state in ("wrong", "failed")]),
        "",
        "## Causes that were not named",
        "",
        *_listed(missed),
        "",
        "## Nothing missing, but not adequate",
        "",
        *_listed(false),
        "",
        "## Causes outside the catalogue that were missed",
        "",
        *_listed(outside),
        "",
        "## Time",
        "",
        f"{times([o.seconds for o in outcomes])} a diagnosis; all {len(outcomes)} cases in"
        f" {seconds / 60:.0f} min with {pool}. Times are of the wall clock and grow with what else the machine does.",
    ]


def _requirements(outcomes: Sequence[ClearOutcome]) -> Iterator[str]:
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


def _left_out(outcomes: Sequence[ClearOutcome]) -> list[str]:
    """Say how many cases were not run, by machine and suite."""
    ran = Counter((o.case.machine, o.case.suite) for o in outcomes)
    every = Counter((case.machine, case.suite) for case in cases())
    left = [f"{m}, {s}: {n - ran[m, s]} of {n}" for (m, s), n in every.items() if ran[m, s] < n]
    return ["", f"**Not every case was run.** Left out: {'; '.join(left)}."] if left else []


def _suite(o: ClearOutcome) -> str:
    return f"{o.case.machine}, {o.case.suite}, motors {o.case.drives}"


def _cause(o: ClearOutcome) -> str:
    return f"{o.case.machine}, {o.case.suite}: {_causes(o)}"


def _causes(o: ClearOutcome) -> str:
    return " + ".join(o.case.kinds) or "nothing"


def _listed(outcomes: Sequence[ClearOutcome]) -> list[str]:
    head = ("case", "truth", "signal", "rows", "verdict", "classes")
    rows = [
        (o.case.label, _causes(o), f"{o.signal:.3g}", str(o.rows), o.verdict or o.state, in_words(o))
        for o in outcomes
    ]
    return listed(head, rows)


if __name__ == "__main__":
    main()
