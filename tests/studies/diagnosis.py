"""The suites of the linear delta: run them, and tabulate the outcomes.

    python -m studies.diagnosis --seed 20261211 --out docs/results/diagnosis             # `make suites`
    python -m studies.diagnosis --only "two effects" --every 6           # a few cases, tables on the terminal

`suites` and `hard_suites` define the cases, `strengths` how the sizes of the causes were chosen, `judging` how the
outcomes are judged, `requirements` what is required.

Three robots are measured in three plans of twelve poses, six modes each, with 0.2 % noise.  Shapes are measured at
`x_1..3` and `p_x..z` with 2 % noise, except in every fifth case.  The true values of the uncertain parameters are
drawn from their priors in every case.  Every suite is run with motors free, held, and mixed: held at every second
pose.  Frames have no motors, and nothing at a motor shows while it is held: such causes are left out there.

In the *realistic* suites and those with few rows, missed modes and outliers, a laboratory is drawn for each case
(`pkmodes_rig.laboratory`).  15 % of the modes are missed, more of them at nodes; none are found outside a band, which
the file states in half of the cases; four to eight modes are found per pose.  One case in five has three of the six
sensors, another one no shapes; shape noise is 1 to 5 % and stated, partly stated or not stated.  Standard deviations
differ from row to row and, in one case in four, are all wrong by a common factor with a standard deviation of 15 %.
Specimens include frames of three to five storeys.

The predicted signal of a cause is the residual that it leaves when the declared model, uncertain values included, is
fitted to the rig's modes without noise, in standard deviations; missed modes are left out.  Of two effects, the
signal of each beyond the other is the residual of both when only the other and the uncertain values are fitted.

Of the causes outside the catalogue, `one_gearbox` is one of the single-joint compliances that a diagnosis examines
but never claims; the other kinds are not.
"""

from __future__ import annotations

import argparse
import itertools
import statistics
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace

from studies import hard_suites
from studies.buildings import Building
from studies.cases import Case
from studies.judging import MEASUREMENT, CaseOutcome, run
from studies.motors import DRIVES, shows, words
from studies.requirements import CLEAR, headed, requirements
from studies.sizes import KINDS
from studies.strengths import SEED
from studies.suite import Suite
from studies.suites import SUITES
from studies.tables import Table, Tables, confusion, count, grouped, in_words, stacked

#: Seeds used during the development of the diagnosis.
SEEN = (
    f"{SEED}, 101 to 120, 7001, 7002, 7011 to 7013, 20261121, 20261122, 20261130, 20261201, 20261202, 20261203,"
    " 20261204 and 20261211"
)
#: Suites with single causes and realistic measurements, and suites of difficult measurements.
REALISTIC = ("one effect, realistic", "wrong parameter, realistic", "modes missed")
HARD = tuple(hard_suites.SUITES)
#: Edges of the bins of predicted signal.
BINS = (0.0, 2.0, 4.0, 6.0, 10.0, 20.0, float("inf"))
#: Whether all modes of the cases of a table were found.
FOUND, MISSED = "found", "some missed"


class Diagnosis(Suite[Case, CaseOutcome]):
    """All suites of the linear delta and of frames, with motors free, held and mixed."""

    description = "Measure the diagnosis on the virtual test rig."
    seed = SEED
    run, failed = staticmethod(run), CaseOutcome

    def cases(self, arguments: argparse.Namespace) -> Iterator[Case]:
        for drives in DRIVES:
            for suite in SUITES.values():
                yield from (replace(case, seed=arguments.seed) for case in _driven(drives, suite()))

    def line(self, outcome: CaseOutcome) -> str:
        what = f"{outcome.case.label} ({outcome.case.kind}): {outcome.state} {in_words(outcome)}"
        return f"{what} [{outcome.seconds:.1f} s]"

    def facts(self, outcomes: Sequence[CaseOutcome]) -> dict[str, object]:
        renamed = sum(o.renamed for o in outcomes if o.case.suite != "special")
        return {"developed with the seeds": SEEN, "named only by an equivalent name": renamed}

    def tables(self, outcomes: Sequence[CaseOutcome]) -> Tables:
        by_suite = {suite: [o for o in outcomes if o.case.suite == suite] for suite in SUITES}
        single = by_suite["one effect"] + by_suite["wrong parameter"]
        real = [o for suite in REALISTIC for o in by_suite[suite]]
        regular = [o for suite in SUITES if suite != "special" for o in by_suite[suite]]
        hard = [o for suite in HARD for o in by_suite[suite] if suite != "modes missed"]
        outside = by_suite["outside the catalogue"], by_suite["outside the catalogue, realistic"]
        named = [o for o in single + real if o.signal > CLEAR and o.state not in ("named", "wrong")]
        return {
            "requirements": stacked(
                "motors",
                {
                    drives: _requirements([o for o in outcomes if o.case.drives == drives])
                    for drives in DRIVES
                },
            ),
            "outcomes": stacked(
                "by",
                {
                    "suite": confusion(grouped(regular, _suite)),
                    "cause": confusion(grouped(single + outside[0], _cause)),
                    "cause, modes missed": confusion(grouped(real + outside[1], _cause)),
                    "kind of difficult case": confusion(grouped(hard, _kind)),
                    "special case": confusion(grouped(by_suite["special"], _special_kind)),
                },
            ),
            "power": stacked("modes", {FOUND: _power(single), MISSED: _power(real)}),
            "pairs": stacked(
                "modes",
                {
                    FOUND: _pairs(by_suite["two effects"]),
                    MISSED: _pairs(by_suite["two effects, realistic"]),
                },
            ),
            "special": _special(by_suite["special"]),
            "cases": stacked(
                "list",
                {
                    "confident and wrong": _listed([o for o in regular if o.state in ("wrong", "failed")]),
                    "clear causes that were not named": _listed(named),
                },
            ),
            "times": _times(by_suite),
        }


def _driven(drives: str, cases: Iterable[Case]) -> Iterator[Case]:
    """Yield the cases of robots whose motors do this in the test and that it shows; free also those of buildings."""
    for case in cases:
        truth = case.truth
        if isinstance(truth, Building):
            if drives == "free":
                yield case
        elif shows(drives, (*case.names, case.kind)):
            yield replace(case, truth=replace(truth, drives=drives))


# Tables ------------------------------------------------------------------------------------------------------


def _requirements(outcomes: Sequence[CaseOutcome]) -> Table:
    return headed(requirements({suite: [o for o in outcomes if o.case.suite == suite] for suite in SUITES}))


def _cause(o: CaseOutcome) -> str:
    return f"(outside) {o.case.kind}" if o.case.kind in KINDS else o.case.kind


def _suite(o: CaseOutcome) -> str:
    return f"{o.case.suite}{words(o.case.drives)}"


def _kind(o: CaseOutcome) -> str:
    """Return the kind of case of an outcome of the hard suites."""
    case = o.case
    frames = isinstance(case.truth, Building)
    kind = f"{case.kind}; {case.plan}" if case.suite == "shapes decide" else _lacking(case)
    if case.suite in ("few rows", "outliers among few"):
        kind = f"{'frames' if frames else 'robots'}; {kind}"
    elif case.suite == "units and wiring":
        kind = f"{case.kind}; {kind}"
    return f"{case.suite}: {kind}"


def _special_kind(o: CaseOutcome) -> str:
    lacking = ("nothing missing", "one effect", "two causes")[len(o.case.names)]
    return f"{o.case.kind}; {lacking}"


def _lacking(case: Case) -> str:
    """Describe what the model of a specimen lacks."""
    causes = [name for name in case.names if not name.startswith(MEASUREMENT)]
    truth = case.truth
    return "one cause" if causes else "outside" if truth.outside else "nothing missing"


def _power(outcomes: Sequence[CaseOutcome]) -> Table:
    states, rows = ("named", "abstained", "adequate", "wrong"), []
    for low, high in itertools.pairwise(BINS):
        last = high == BINS[-1]  # with the infinite signals of failures
        group = [o for o in outcomes if low <= o.signal and (last or o.signal < high)]
        parts = [f"{100 * count(group, s) / len(group):.0f}" if group else "" for s in states]
        rows.append((f"over {low:g}" if last else f"{low:g} to {high:g}", len(group), *parts))
    return Table.of(("signal", "cases", *(f"{state} [%]" for state in states)), rows)


def _pairs(outcomes: Sequence[CaseOutcome]) -> Table:
    rows = [
        (
            *(o.case.number, o.case.drives, _where(o), o.case.kind),
            *(", ".join(f"{b:.3g}" for b in o.beyond), o.state, in_words(o)),
        )
        for o in outcomes
    ]
    head = ("case", "motors", "robot, plan", "effects", "each beyond the other", "state", "classes")
    return Table.of(head, rows)


def _special(outcomes: Sequence[CaseOutcome]) -> Table:
    rows = []
    for name, group in grouped(outcomes, _special_kind).items():
        scatter = statistics.median(o.scatter for o in group)
        rows.append((name, sum(o.outliers for o in group), f"{100 * scatter:.2g}"))
    return Table.of(("group", "rows set aside", "shared error [%]"), rows)


def _listed(outcomes: Sequence[CaseOutcome]) -> Table:
    rows = [
        (o.case.label, _where(o), o.case.kind, f"{o.signal:.3g}", o.verdict, in_words(o)) for o in outcomes
    ]
    return Table.of(("case", "robot, plan", "truth", "signal", "verdict", "classes"), rows)


def _where(outcome: CaseOutcome) -> str:
    case = outcome.case
    shapes = outcome.laboratory.shapes if outcome.laboratory else case.shapes
    return f"{case.truth.machine}, {case.plan}{'' if shapes else ', no shapes'}"


def _times(by_suite: dict[str, list[CaseOutcome]]) -> Table:
    seconds = {suite: [o.seconds for o in group] for suite, group in by_suite.items() if group}
    rows = [(name, f"{statistics.median(s):.1f}", f"{max(s):.1f}") for name, s in seconds.items()]
    return Table.of(("suite", "median [s]", "longest [s]"), rows)


main = Diagnosis().main

if __name__ == "__main__":
    main()
