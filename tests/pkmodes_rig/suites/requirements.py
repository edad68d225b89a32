"""Requirements on the results of the suites.

These are the requirements that the diagnosis was built for.  They are not changed to suit a result; each line says
whether its requirement is met.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence

from scipy import stats

from pkmodes_rig import ORDERS
from pkmodes_rig.suites.hard_suites import ADDING, UNDECIDED
from pkmodes_rig.suites.judging import NOTED, Outcome, mentioned, noticeable, right_wiring

#: Predicted signal above which a cause must be found.
CLEAR = 6.0
#: An estimate counts as right within this many standard deviations; half width of a 95 % interval.
RIGHT, INTERVAL = 3.0, 1.959964
#: A claim must not contradict the shapes: no MAC below the first if another explanation has all above the second.
MAC_CLAIMED, MAC_OTHER = 0.90, 0.98

FIVE = ("nothing missing", "one effect", "wrong parameter", "two effects", "outside the catalogue")


def requirements(by_suite: Mapping[str, Sequence[Outcome]]) -> list[str]:
    """Return the lines of the table; suites that were not run have none."""
    lines: list[str] = []
    for suffix, together in (("", "all five"), (", realistic", "all five, realistic")):
        suites = {name: by_suite[f"{name}{suffix}"] for name in FIVE}
        for name, outcomes in suites.items():
            if outcomes:
                lines += _basic(name, f"{name}{suffix}", outcomes)
        everything = [o for outcomes in suites.values() for o in outcomes]
        if everything:
            lines += _together(together, everything)
    for suite, rule in HARD.items():
        if by_suite[suite]:
            lines += rule(suite, by_suite[suite])
    if by_suite["units and wiring"]:
        lines += _right_wiring(by_suite)
    if by_suite["wrong drives"]:
        lines += _wrongly_noted(by_suite)
    return lines


def count(outcomes: Iterable[Outcome], state: str) -> int:
    """Count the outcomes with a state."""
    return Counter(o.state for o in outcomes)[state]


def _basic(name: str, suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    """Yield the lines of the five suites first published, and of their realistic versions."""
    number = len(outcomes)
    if name == "nothing missing":
        yield line(suite, "not adequate <= 5 %", number - count(outcomes, "adequate"), number, most=0.05)
    elif name == "two effects":
        yield line(suite, "both named >= 70 %", count(outcomes, "named"), number, least=0.70)
        yield line(suite, "wrong cause claimed <= 5 %", count(outcomes, "wrong"), number, most=0.05)
    elif name == "outside the catalogue":
        yield line(suite, "abstained >= 90 %", count(outcomes, "abstained"), number, least=0.90)
    else:
        clear = [o for o in outcomes if o.signal > CLEAR]
        named = [o for o in clear if o.state == "named"]
        what = f"signal > {CLEAR:g}"
        yield line(suite, f"{what}: named >= 95 %", len(named), len(clear), least=0.95)
        right = sum(map(_right, named))
        yield line(suite, f"{what}: value within 3 sigma >= 95 %", right, len(named), least=0.95)


def _together(name: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    wrong = count(outcomes, "wrong")
    yield line(name, "confident and wrong <= 2 %", wrong, len(outcomes), most=0.02)
    values = [abs(estimate - true) / sigma for o in outcomes for _, estimate, sigma, true in o.values]
    inside = sum(v <= INTERVAL for v in values)
    yield line(name, "95 % intervals cover 90-99 %", inside, len(values), 0.90, 0.99)


def _few_rows(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    yield line(suite, "confident and wrong: none", count(outcomes, "wrong"), len(outcomes), most=0.0)


def _modes_missed(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
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
    yield line(suite, "confident and wrong <= 2 %", count(outcomes, "wrong"), len(outcomes), most=0.02)


def _shapes_decide(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    yield line(suite, "confident and wrong <= 2 %", count(outcomes, "wrong"), len(outcomes), most=0.02)
    against = [o for o in outcomes if o.mac and o.mac[0] < MAC_CLAIMED and o.mac[1] > MAC_OTHER]
    what = f"claimed with a MAC < {MAC_CLAIMED:g} although the truth has all > {MAC_OTHER:g}: none"
    yield line(suite, what, len(against), len(outcomes), most=0.0)


def _outliers(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    what = "wrong, or rows set aside without redundancy <= 2 %"
    yield line(suite, what, count(outcomes, "wrong"), len(outcomes), most=0.02)


def _mistakes(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    yield line(
        suite, "physical cause claimed: none", sum(o.physical for o in outcomes), len(outcomes), most=0.0
    )
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


def _wrong_drives(suite: str, outcomes: Sequence[Outcome]) -> Iterator[str]:
    yield line(
        suite, "physical cause claimed: none", sum(o.physical for o in outcomes), len(outcomes), most=0.0
    )
    told = sum(bool(o.noted) for o in outcomes)
    yield line(suite, "what the motors did noted >= 90 %", told, len(outcomes), least=0.90)


def _wrongly_noted(by_suite: Mapping[str, Sequence[Outcome]]) -> Iterator[str]:
    """Yield the line of all files that say what the motors did."""
    right = [o for outcomes in by_suite.values() for o in outcomes if noticeable(o.case) != "drives"]
    called = sum(mentioned("drives", o.notes) for o in right)
    yield line("all suites", "right drives called wrong <= 1 %", called, len(right), most=0.01)


def _right_wiring(by_suite: Mapping[str, Sequence[Outcome]]) -> Iterator[str]:
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


def line(suite: str, what: str, count: int, of: int, least: float = 0.0, most: float = 1.0) -> str:
    """Return a line of the table: how often, with its 95 % interval, and whether that is within the bounds."""
    if not of:
        return f"| {suite} | {what} | no cases | | |"
    low = stats.beta.ppf(0.025, count, of - count + 1) if count else 0.0
    high = stats.beta.ppf(0.975, count + 1, of - count) if count < of else 1.0
    met = "met" if least <= count / of <= most else "**NOT MET**"
    share = f"{count} of {of}: {100 * count / of:.1f} %"
    return f"| {suite} | {what} | {share} | {100 * low:.1f}-{100 * high:.1f} % | {met} |"


def _right(outcome: Outcome) -> bool:
    return all(abs(estimate - true) <= RIGHT * sigma for _, estimate, sigma, true in outcome.values)
