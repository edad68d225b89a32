"""Requirements on the results of the suites.

These are the requirements that the diagnosis was built for.  They are not changed to suit a result; each line says
whether its requirement is met.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any

from scipy import stats

from pkmodes_rig import ORDERS
from studies.hard_suites import ADDING, UNDECIDED
from studies.judging import NOTED, CaseOutcome, mentioned, noticeable, right_wiring
from studies.running import Outcome
from studies.tables import Table, count

#: Predicted signal above which a cause must be found.
CLEAR = 6.0
#: An estimate counts as right within this many standard deviations; half width of a 95 % interval.
RIGHT, INTERVAL = 3.0, 1.959964
#: A claim must not contradict the shapes: no MAC below the first if another explanation has all above the second.
MAC_CLAIMED, MAC_OTHER = 0.90, 0.98

#: A row of the table of requirements; see `HEAD`.
Row = tuple[str, ...]
FIVE = ("nothing missing", "one effect", "wrong parameter", "two effects", "outside the catalogue")


def requirements(by_suite: Mapping[str, Sequence[CaseOutcome]]) -> list[Row]:
    """Return the rows of the table; suites that were not run have none."""
    lines: list[Row] = []
    for suffix, together in (("", "all five"), (", realistic", "all five, realistic")):
        suites = {name: by_suite[f"{name}{suffix}"] for name in FIVE}
        for name, outcomes in suites.items():
            if outcomes:
                lines += basic(name, f"{name}{suffix}", outcomes)
        everything = [o for outcomes in suites.values() for o in outcomes]
        if everything:
            lines += [wrong(together, everything), covered(together, errors(everything))]
    for suite, rule in HARD.items():
        if by_suite[suite]:
            lines += rule(suite, by_suite[suite])
    if by_suite["units and wiring"]:
        lines += _right_wiring(by_suite)
    if by_suite["wrong drives"]:
        lines += _wrongly_noted(by_suite)
    return lines


def basic(suite: str, title: str, outcomes: Sequence[Outcome[Any]]) -> Iterator[Row]:
    """Yield the lines of one of the `FIVE` suites, or of cases like it."""
    number = len(outcomes)
    if suite == "nothing missing":
        yield line(title, "not adequate <= 5 %", number - count(outcomes, "adequate"), number, most=0.05)
    elif suite == "two effects":
        yield line(title, "both named >= 70 %", count(outcomes, "named"), number, least=0.70)
        yield line(title, "wrong cause claimed <= 5 %", count(outcomes, "wrong"), number, most=0.05)
    elif suite == "outside the catalogue":
        yield line(title, "abstained >= 90 %", count(outcomes, "abstained"), number, least=0.90)
    else:
        clear = [o for o in outcomes if o.signal > CLEAR]
        named = [o for o in clear if o.state == "named"]
        what = f"signal > {CLEAR:g}"
        yield line(title, f"{what}: named >= 95 %", len(named), len(clear), least=0.95)
        right = sum(all(away <= RIGHT for away in errors([o])) for o in named)
        yield line(title, f"{what}: value within 3 sigma >= 95 %", right, len(named), least=0.95)


def wrong(title: str, outcomes: Sequence[Outcome[Any]], most: float = 0.02) -> Row:
    """Return the row of wrong claims."""
    what = f"confident and wrong <= {100 * most:g} %"
    return line(title, what, count(outcomes, "wrong"), len(outcomes), most=most)


def covered(title: str, away: Sequence[float]) -> Row:
    """Return the row of the intervals of values, by their errors in standard deviations."""
    inside = sum(one <= INTERVAL for one in away)
    return line(title, "95 % intervals cover 90-99 %", inside, len(away), 0.90, 0.99)


def errors(outcomes: Iterable[Outcome[Any]]) -> list[float]:
    """Return the errors of all values that were named, in their standard deviations."""
    return [abs(estimate - true) / sigma for o in outcomes for _, estimate, sigma, true in o.values]


def _few_rows(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    yield line(suite, "confident and wrong: none", count(outcomes, "wrong"), len(outcomes), most=0.0)


def _modes_missed(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    clear = [o for o in outcomes if o.signal > CLEAR]
    adding = [o for o in clear if o.case.kind in ADDING]
    what = f"signal > {CLEAR:g}"
    yield line(suite, f"{what}: named >= 95 %", count(clear, "named"), len(clear), least=0.95)
    yield line(
        suite,
        f"{what}, effects that add modes: named >= 95 %",
        count(adding, "named"),
        len(adding),
        least=0.95,
    )
    yield wrong(suite, outcomes)


def _shapes_decide(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    yield wrong(suite, outcomes)
    against = [o for o in outcomes if o.mac and o.mac[0] < MAC_CLAIMED and o.mac[1] > MAC_OTHER]
    what = f"claimed with a MAC < {MAC_CLAIMED:g} although the truth has all > {MAC_OTHER:g}: none"
    yield line(suite, what, len(against), len(outcomes), most=0.0)


def _outliers(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    what = "wrong, or rows set aside without redundancy <= 2 %"
    yield line(suite, what, count(outcomes, "wrong"), len(outcomes), most=0.02)


def _claimed(suite: str, outcomes: Sequence[CaseOutcome]) -> Row:
    physical = sum(o.physical for o in outcomes)
    return line(suite, "physical cause claimed: none", physical, len(outcomes), most=0.0)


def _mistakes(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    yield _claimed(suite, outcomes)
    for kind, what in (
        ("unit", "unit or factor noted >= 90 %"),
        ("channels", "exchanged channels noted >= 90 %"),
        ("sigma", "sigma far too large noted >= 90 %"),
    ):
        told = [o for o in outcomes if NOTED.get(o.case.mistake) == kind]
        yield line(suite, what, sum(bool(o.noted) for o in told), len(told), least=0.90)
    orders = [o for o in outcomes if o.case.mistake in ORDERS]
    decided = [o for o in orders if o.case.kind != UNDECIDED]
    named = sum(bool(o.rewired) for o in decided)
    yield line(suite, "signed order of a triaxial sensor named >= 90 %", named, len(decided), least=0.90)
    yield line(suite, "another order named: none", sum(o.misnamed for o in orders), len(orders), most=0.0)


def _wrong_drives(suite: str, outcomes: Sequence[CaseOutcome]) -> Iterator[Row]:
    yield _claimed(suite, outcomes)
    told = sum(bool(o.noted) for o in outcomes)
    yield line(suite, "what the motors did noted >= 90 %", told, len(outcomes), least=0.90)


def _wrongly_noted(by_suite: Mapping[str, Sequence[CaseOutcome]]) -> Iterator[Row]:
    """Yield the line of all files that say what the motors did."""
    right = [o for outcomes in by_suite.values() for o in outcomes if noticeable(o.case) != "drives"]
    called = sum(mentioned("drives", o.notes) for o in right)
    yield line("all suites", "right drives called wrong <= 1 %", called, len(right), most=0.01)


def _right_wiring(by_suite: Mapping[str, Sequence[CaseOutcome]]) -> Iterator[Row]:
    """Yield the line of all files whose sensors are wired as they say."""
    right = [o for outcomes in by_suite.values() for o in outcomes if right_wiring(o.case)]
    if right:
        called = sum(bool(o.rewired) for o in right)
        yield line("all suites", "right wiring called wrong <= 1 %", called, len(right), most=0.01)


#: Requirements of the other suites, each fixed before its suite was run.
HARD = {
    "few rows": _few_rows,
    "modes missed": _modes_missed,
    "shapes decide": _shapes_decide,
    "outliers among few": _outliers,
    "units and wiring": _mistakes,
    "wrong drives": _wrong_drives,
}


#: Columns of the table of requirements.
HEAD = ("group", "requirement", "number", "cases", "rate [%]", "low [%]", "high [%]", "met")
MET, NOT_MET = "met", "NOT MET"


def headed(lines: Iterable[Row]) -> Table:
    """Return the table of these rows."""
    return Table.of(HEAD, lines)


def line(group: str, what: str, number: int, of: int, least: float = 0.0, most: float = 1.0) -> Row:
    """Return a row of the table: how often, with its 95 % interval, and whether that is within the bounds."""
    if not of:
        return group, what, "0", "0", "", "", "", ""
    low = stats.beta.ppf(0.025, number, of - number + 1) if number else 0.0
    high = stats.beta.ppf(0.975, number + 1, of - number) if number < of else 1.0
    met = MET if least <= number / of <= most else NOT_MET
    return (
        group,
        what,
        str(number),
        str(of),
        *(f"{100 * share:.1f}" for share in (number / of, low, high)),
        met,
    )
