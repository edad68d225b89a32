"""Suites of one fault at one place, on all mechanisms: define the cases, run them and tabulate the outcomes.

    python -m studies.one_place --seed 20280301 --out docs/one-place-measured.md            # `make suites`

The requirements were fixed before any case was run.
"""

from __future__ import annotations

import time
from collections.abc import Iterator, Sequence
from dataclasses import replace

from pkmodes_rig.one_place.draws import kinds_of
from pkmodes_rig.one_place.laws import LAWS, laws_of
from pkmodes_rig.robots import ROBOTS
from studies.one_place_cases import CLEAR, FAINT, SIGMA, PlaceCase, declared
from studies.one_place_judging import MEMBERS, UNREACHED, PlaceOutcome, run
from studies.requirements import RIGHT, covered, errors, headed, line, wrong
from studies.running import Pool, parallel_command_line, publish, run_all
from studies.tables import confusion, count, grouped, in_words, listed, table, times

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


# Running -----------------------------------------------------------------------------------------------------


def main() -> None:
    """Run the suites and write their page."""
    parser = parallel_command_line("Measure the diagnosis of one fault at one place.")
    parser.add_argument("--only", default="", help="part of the label of the cases to run")
    parser.add_argument("--every", type=int, default=1, help="run one case in this many")
    arguments = parser.parse_args()
    pool = Pool.of(arguments)
    start = time.perf_counter()
    chosen = [replace(case, seed=arguments.seed) for case in cases() if arguments.only in case.label]
    outcomes = run_all(run, chosen[:: arguments.every], pool, _said, PlaceOutcome)
    publish(page(outcomes, time.perf_counter() - start, pool), arguments.out)


def _said(o: PlaceOutcome) -> str:
    what = f"{o.case.label} ({_truth(o)}), {100 * o.change:.2g} %: {o.state} {o.by} {o.status} {in_words(o)}"
    return f"{what} [{o.seconds:.1f} s] {o.reason}"


# Tables ------------------------------------------------------------------------------------------------------


def page(outcomes: Sequence[PlaceOutcome], seconds: float, pool: Pool) -> list[str]:
    """Return the lines of the page."""
    every, outcomes = outcomes, [o for o in outcomes if o.state != UNREACHED]
    faults = [o for o in outcomes if o.case.suite in ("clear", "faint")]
    laws = [o for o in outcomes if o.case.suite == "outside the grammar"]
    return [
        "# One fault at one place, measured",
        "",
        "Written by `make suites`; do not edit. `tests/studies/one_place.py` defines the cases and the",
        "requirements, `one_place_cases.py` how they are drawn, sized and measured, `one_place_judging.py` how they",
        "are judged. The rig (`tests/pkmodes_rig/one_place/`) shares no code with the model: MuJoCo moves the bodies",
        "of the machines with closed loops, and springs, masses and resonators act on what it moves.",
        "",
        *_ABOUT,
        "",
        *([f"Seed {outcomes[0].case.seed}."] if outcomes else []),
        f"The suites were tried with the seeds {SEEN}.",
        *_left_out(every),
        "",
        "## Requirements",
        "",
        *headed("mechanism, suite", _requirements(outcomes)),
        "",
        "## Faults by mechanism and kind",
        "",
        *confusion(grouped(faults, lambda o: f"{o.case.mechanism}, {o.case.suite}: {o.case.kind}"), "fault"),
        "",
        "## Faults by kind",
        "",
        *confusion(grouped(faults, lambda o: f"{o.case.suite}: {o.case.kind}"), "kind"),
        "",
        "## Faults by laboratory",
        "",
        *confusion(grouped(faults, _laboratory), "laboratory"),
        "",
        "## What decided",
        "",
        "The rule that decided: one of docs/explanation/beyond.md, or of docs/explanation/diagnosis.md where no "
        "terms were tried.",
        "",
        *confusion(_by_rule(outcomes), "rule"),
        "",
        "## Laws that no term has",
        "",
        *table(["law", "what it is, with its size"], [[law, LAWS[law]] for law in LAWS]),
        "",
        *confusion(grouped(laws, lambda o: o.case.kind), "law"),
        "",
        "## Complete machines",
        "",
        *confusion(grouped((o for o in outcomes if o.case.suite == "complete"), _mechanism), "mechanism"),
        "",
        "## Confident and wrong",
        "",
        *_listed([o for o in outcomes if o.state in ("wrong", "failed")]),
        "",
        "## Faults that were not named",
        "",
        f"In {sum(map(_remains, faults))} of these cases the true term is among several that remain.",
        "",
        *_listed([o for o in faults if o.state in ("abstained", "adequate", "partly")]),
        "",
        "## Time",
        "",
        *_time(outcomes, seconds, pool),
    ]


def _by_rule(outcomes: Sequence[PlaceOutcome]) -> dict[str, list[PlaceOutcome]]:
    """Group outcomes by the rule that decided and the suite, in the order of their names."""
    return dict(sorted(grouped(outcomes, lambda o: f"`{o.rule}`, {o.case.suite}").items()))


def _time(outcomes: Sequence[PlaceOutcome], seconds: float, pool: Pool) -> list[str]:
    if not outcomes:
        return ["No case was run."]
    each = f"{times([o.seconds for o in outcomes])} a diagnosis"
    every = f"all {len(outcomes)} cases in {seconds / 60:.0f} min with {pool}"
    return [f"{each}; {every}. Times are of the wall clock and grow with what else the machine does."]


_ABOUT = (
    "Nine robots of seven mechanisms are measured at twelve poses with free motors. An *ideal* laboratory finds all",
    f"modes up to 1.25 times the highest of the machine, with {100 * SIGMA:.2g} % noise and shapes at all sensors",
    "with 2 %. Every second one is *realistic*, as in docs/clear-causes-measured.md, with this noise. True values of",
    "uncertain parameters are drawn from their priors.",
    "",
    "Each fault is at a random place; one that cannot be as large as asked is drawn again. A *clear* one changes the",
    f"frequencies by {100 * CLEAR[0]:.2g} to {100 * CLEAR[1]:.2g} % (root mean square over all modes and poses: five",
    "to nine stated standard deviations), beyond what the uncertain values can do within their uncertainties. Of a",
    f"*faint* one, the changes of all modes together are {FAINT[0]:g} to {FAINT[1]:g} stated standard deviations",
    "(root of the sum of squares), as in the suites of the catalogue. The laws that no term has are as large as",
    "clear faults.",
    "",
    "A mass of a body has its weight; a link's is a uniform rod's. Springs are relaxed at the pose; those between",
    "bodies join two that slide, two that rotate, or the platform and another body. The bearing of a pulley yields",
    "along the belt, with no mass or one of 0.3 carriages or tool heads; a rail yields across itself, a base joint",
    "in any direction, with the body's own mass. A resonator slides on its body, along a direction of the base frame",
    "or the body's own, and rides along in the others.",
    "",
    f"An answer is *named* if the class that was found, of at most {MEMBERS} terms, holds the true one, or one that",
    "is the same to any measurement: a mass on the platform is a payload, a mass of a link a larger declared one.",
    "Which ones are the same is written by hand in `one_place_judging.py`. It is named, too, if each class that the",
    "catalogue claims holds such a one. Of two faults, the class that holds one is *partly* right. All else is",
    "*wrong* where something is claimed, *adequate*, or silent (*abstained*).",
)


def _requirements(outcomes: Sequence[PlaceOutcome]) -> Iterator[str]:
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


def _left_out(outcomes: Sequence[PlaceOutcome]) -> list[str]:
    """Say how many cases were not run, and in how many no fault can be as large as asked."""
    every, ran, unreached = sum(1 for _ in cases()), len(outcomes), count(outcomes, UNREACHED)
    lines = ["", f"**Not every case was run**: {ran} of {every}."] if ran < every else []
    some = (
        f"In {unreached} of {ran} cases no fault of that kind was large enough at any place that was drawn."
    )
    return [*lines, "", some] if unreached else lines


def _mechanism(o: PlaceOutcome) -> str:
    return o.case.mechanism


def _laboratory(o: PlaceOutcome) -> str:
    return f"{o.case.mechanism}, {o.case.suite}, {'realistic' if o.case.realistic else 'ideal'}"


def _remains(o: PlaceOutcome) -> bool:
    return o.state == "abstained" and any(term in members for term in o.truth for members in o.classes)


def _truth(o: PlaceOutcome) -> str:
    return " + ".join(o.truth) or o.case.kind or "nothing"


def _listed(outcomes: Sequence[PlaceOutcome]) -> list[str]:
    head = ("case", "truth", "change", "rows", "verdict", "terms", "classes")
    rows = [
        (
            *(o.case.label, _truth(o), f"{100 * o.change:.2g} %", str(o.rows), o.verdict or o.state),
            *(o.status, in_words(o)),
        )
        for o in outcomes
    ]
    return listed(head, rows)


if __name__ == "__main__":
    main()
