"""Measure the diagnosis on the virtual test rig: run the suites and tabulate the outcomes.

    python -m studies.diagnosis --seed 20261211 --out docs/diagnosis-measured.md         # `make suites`
    python -m studies.diagnosis --only "two effects" --limit 6           # a few cases, tables on stdout

`suites` defines the cases, `judging` how they are judged, `requirements` the requirements.
"""

from __future__ import annotations

import itertools
import json
import os
import platform
import statistics
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, replace
from pathlib import Path

from studies import hard_suites
from studies.buildings import Building
from studies.cases import Case
from studies.judging import MEASUREMENT, CaseOutcome, run
from studies.motors import DRIVES, shows, words
from studies.requirements import CLEAR, headed, requirements
from studies.running import Pool, parallel_command_line, publish, run_all
from studies.sizes import KINDS
from studies.strengths import SEED
from studies.suites import SUITES
from studies.tables import confusion, count, grouped, in_words, listed, table

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


def main() -> None:
    """Run the chosen suites, and write their page."""
    parser = parallel_command_line("Measure the diagnosis on the virtual test rig.", SEED)
    parser.add_argument("--cases", type=Path, help="JSON file for the outcome of every case")
    parser.add_argument("--only", choices=SUITES, action="append", help="suite to run; may be repeated")
    parser.add_argument(
        "--drives", choices=DRIVES, action="append", help="what the motors do; by default all three in turn"
    )
    parser.add_argument("--limit", type=int, help="largest number of cases per suite, spread evenly")
    arguments = parser.parse_args()
    pool = Pool.of(arguments)
    start = time.perf_counter()
    cases = [
        replace(case, seed=arguments.seed)
        for drives in arguments.drives or DRIVES
        for case in _chosen(arguments.only, arguments.limit, drives)
    ]
    outcomes = run_all(run, cases, pool, _said, CaseOutcome)
    if arguments.cases:
        text = json.dumps([asdict(outcome) for outcome in outcomes], indent=1)
        arguments.cases.write_text(text + "\n", encoding="utf-8")
    publish(_page(outcomes, time.perf_counter() - start, pool), arguments.out)


# Cases -------------------------------------------------------------------------------------------------------


def _chosen(only: Sequence[str] | None, limit: int | None, drives: str) -> Iterable[Case]:
    for suite in only or SUITES:
        cases = list(_driven(drives, SUITES[suite]()))
        number = min(limit or len(cases), len(cases))
        yield from (cases[(2 * k + 1) * len(cases) // (2 * number)] for k in range(number))


def _driven(drives: str, cases: Iterable[Case]) -> Iterator[Case]:
    """Yield the cases of robots whose motors do this in the test and that it shows; free also those of buildings."""
    for case in cases:
        truth = case.truth
        if isinstance(truth, Building):
            if drives == "free":
                yield case
        elif shows(drives, (*case.names, case.kind)):
            yield replace(case, truth=replace(truth, drives=drives))


def _said(o: CaseOutcome) -> str:
    return f"{o.case.label} ({o.case.kind}): {o.state} {in_words(o)} [{o.seconds:.1f} s]"


# Tables ------------------------------------------------------------------------------------------------------


def _page(outcomes: list[CaseOutcome], seconds: float, pool: Pool) -> list[str]:
    regular = [o for o in outcomes if o.case.suite != "special"]
    by_suite = {suite: [o for o in outcomes if o.case.suite == suite] for suite in SUITES}
    single = by_suite["one effect"] + by_suite["wrong parameter"]
    real = [o for suite in REALISTIC for o in by_suite[suite]]
    shown = {suite: group for suite, group in by_suite.items() if group and suite != "special"}
    hard = [o for suite in HARD for o in by_suite[suite] if suite != "modes missed"]
    where = "" if pool.scheduler else f" on {_machine()}"
    return [
        "# The diagnosis, measured",
        "",
        "Written by `make suites`; do not edit. In `tests/studies/`, `suites.py` and `hard_suites.py`",
        "define the cases and their seeds, `strengths.py` how the sizes of the causes were chosen, `requirements.py`",
        "the requirements.",
        "The physics of the rig is MuJoCo's and shares no code with the model. There are three robots, three plans",
        "of twelve poses, and six modes with 0.2 % noise. Shapes are measured at `x_1..3` and `p_x..z` with 2 %",
        "noise, except in every fifth case. The true values of the uncertain parameters are drawn from their",
        "priors in every case.",
        "",
        "In the *realistic* suites and those with few rows, missed modes and outliers, a laboratory is drawn for",
        "each case (`pkmodes_rig.laboratory`). 15 % of the modes are missed, more of them at nodes; none are found",
        "outside a band, which the file states in half of the cases; four to eight modes are found per pose. One",
        "case in five has three of the six sensors, another one no shapes; shape noise is 1 to 5 % and stated,",
        "partly stated or not stated. Standard deviations differ from row to row and, in one case in four, are all",
        "wrong by a common factor with a standard deviation of 15 %. Specimens include frames of three to five",
        "storeys.",
        "",
        "*Named*: `effect_found`, with each cause in a separate class. *Partly*: `effect_found` without a wrong",
        "class, but not with every cause. *Wrong*: `effect_found` with a class that contains none of the causes.",
        "*Abstained*: `ambiguous`, `unexplained` or `insufficient_data`. *Predicted signal*: the residual that the",
        "cause leaves when the declared model, uncertain values included, is fitted to the rig's modes without",
        "noise, in standard deviations; missed modes are left out. Intervals are 95 % Clopper-Pearson intervals.",
        "",
        f"Seed {outcomes[0].case.seed}. The diagnosis was developed with the seeds {SEEN}; any other seed is a",
        "fresh draw of noise and true values (`--seed`).",
        "",
        "Every suite is run with motors free, with motors held, and mixed: held at every second pose. Frames have no",
        "motors, and nothing at a motor shows while it is held: such causes are left out there.",
        "",
        *itertools.chain.from_iterable(_requirements(drives, outcomes) for drives in DRIVES),
        f"{sum(o.renamed for o in regular)} cases count as named only by an equivalent name of their cause"
        " (`SAME` in `judging.py`).",
        "",
        "Of the causes outside the catalogue, `one_gearbox` is one of the single-joint compliances that a diagnosis",
        "examines but never claims (docs/explanation/diagnosis.md, remote candidates); the other kinds are not.",
        "",
        "## Outcomes by suite",
        "",
        *confusion(grouped(itertools.chain.from_iterable(shown.values()), _suite), "suite"),
        "",
        "## Outcomes by cause",
        "",
        *confusion(grouped(single + by_suite["outside the catalogue"], _cause), "cause"),
        "",
        "The same with missed modes.",
        "",
        *confusion(grouped(real + by_suite["outside the catalogue, realistic"], _cause), "cause"),
        "",
        "## Power against predicted signal",
        "",
        "One effect and wrong parameters together.",
        "",
        *_power(single),
        "",
        "The same with missed modes: the realistic versions of these suites, and *modes missed*.",
        "",
        *_power(real),
        "",
        "## Two effects",
        "",
        "The signal of each effect beyond the other is the residual of both when only the other effect and the",
        "uncertain values are fitted: where it is small, one effect looks like the two.",
        "",
        *_pairs(by_suite["two effects"]),
        "",
        "The same with missed modes.",
        "",
        *_pairs(by_suite["two effects, realistic"]),
        "",
        "## Few rows, shapes, outliers, mistakes",
        "",
        *confusion(grouped(hard, _kind), "case"),
        "",
        "## Special cases",
        "",
        *_special(by_suite["special"]),
        "",
        "## Confident and wrong",
        "",
        *_listed([o for o in regular if o.state in ("wrong", "failed")]),
        "",
        "## Clear causes that were not named",
        "",
        *_listed([o for o in single + real if o.signal > CLEAR and o.state not in ("named", "wrong")]),
        "",
        "## Time",
        "",
        *_times(by_suite),
        "",
        f"All {len(outcomes)} cases in {seconds / 60:.0f} min with {pool}{where}.",
    ]


def _requirements(drives: str, outcomes: Sequence[CaseOutcome]) -> list[str]:
    """Return the section of the requirements for tests with these drives; nothing if there were none."""
    some = [o for o in outcomes if o.case.drives == drives]
    if not some:
        return []
    by_suite = {suite: [o for o in some if o.case.suite == suite] for suite in SUITES}
    return [
        f"## Requirements, motors {drives}",
        "",
        *headed("suite", requirements(by_suite)),
        "",
    ]


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


def _power(outcomes: list[CaseOutcome]) -> list[str]:
    states, rows = ("named", "abstained", "adequate", "wrong"), []
    for low, high in itertools.pairwise(BINS):
        last = high == BINS[-1]  # with the infinite signals of failures
        group = [o for o in outcomes if low <= o.signal and (last or o.signal < high)]
        parts = [f"{count(group, s) / len(group):.0%}".replace("%", " %") if group else "" for s in states]
        rows.append((f"over {low:g}" if last else f"{low:g} to {high:g}", str(len(group)), *parts))
    return table(("signal", "cases", *states), rows)


def _pairs(outcomes: list[CaseOutcome]) -> list[str]:
    rows = [
        (
            *(str(o.case.number), _where(o), o.case.kind, ", ".join(f"{b:.3g}" for b in o.beyond)),
            *(o.state, in_words(o)),
        )
        for o in outcomes
    ]
    return table(("case", "robot, plan", "effects", "each beyond the other", "state", "classes"), rows)


def _special(outcomes: list[CaseOutcome]) -> list[str]:
    groups = grouped(outcomes, _special_kind)
    lines = confusion(groups, "case")
    remarks = [" set aside, shared error |", "---|"]
    for group in groups.values():
        scatter = statistics.median(o.scatter for o in group)
        remarks.append(f" {sum(o.outliers for o in group)} rows, {100 * scatter:.2g} % |")
    return [line + remark for line, remark in zip(lines, remarks, strict=True)]


def _listed(outcomes: list[CaseOutcome]) -> list[str]:
    rows = [
        (o.case.label, _where(o), o.case.kind, f"{o.signal:.3g}", o.verdict, in_words(o)) for o in outcomes
    ]
    return listed(("case", "robot, plan", "truth", "signal", "verdict", "classes"), rows)


def _where(outcome: CaseOutcome) -> str:
    case = outcome.case
    shapes = outcome.laboratory.shapes if outcome.laboratory else case.shapes
    return f"{case.truth.machine}, {case.plan}{'' if shapes else ', no shapes'}"


def _times(by_suite: dict[str, list[CaseOutcome]]) -> list[str]:
    seconds = {suite: [o.seconds for o in group] for suite, group in by_suite.items() if group}
    rows = [(name, f"{statistics.median(s):.1f} s", f"{max(s):.1f} s") for name, s in seconds.items()]
    return table(("suite", "median", "longest"), rows)


def _machine() -> str:
    return f"{os.cpu_count()} cores, {platform.machine()}, Python {platform.python_version()}"


if __name__ == "__main__":
    main()
