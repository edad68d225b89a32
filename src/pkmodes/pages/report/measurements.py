"""Two measurements compared, in numbers: what changed, and which modes by more than their errors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pkmodes.core.base.numbers import p_text, plain
from pkmodes.loop.measured.comparison import MeasurementsCompared, ModePair
from pkmodes.loop.measured.significance import MIN_COMMON_SIGMAS, SIGNIFICANCE_LEVEL, CommonChange
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import NOTHING, number, p_value, plural, pointer, shortened, three_digits
from pkmodes.pages.report.measured_shapes import deviations_in_words, mode_name, where
from pkmodes.pages.report.numbers import percent
from pkmodes.pages.report.tables import table

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour

#: Most modes named in a headline.
NAMED = 3
FACTOR = (
    "Modes change in this way where stiffness or mass changes everywhere in proportion, as with the temperature or "
    "the tension of all belts, and where the clock of one test is wrong."
)


def measurements_summary(result: MeasurementsCompared) -> Summary:
    """Return whether the measurements differ, and by how much."""
    headline, reason, tone = _judged(result)
    pairs, common = len(result.pairs), result.common
    facts = [
        ("median change [%]", percent(result.median_relative, pointer("median_relative"))),
        ("rms change [%]", percent(result.rms_relative, pointer("rms_relative"))),
        ("chi\u00b2 per pair", three_digits(result.chi2 / pairs if pairs else None)),
        ("common change [%]", percent(common.relative if common else None, pointer("common", "relative"))),
        ("p-value", p_value(result.p_value, pointer("p_value"))),
        ("pairs", Cell(str(pairs), pairs)),
        ("poses", Cell(str(result.poses), result.poses, pointer("poses"))),
        ("only in the first", Cell(str(len(result.first_unpaired)), len(result.first_unpaired))),
        ("only in the second", Cell(str(len(result.second_unpaired)), len(result.second_unpaired))),
    ]
    return Summary(
        subject=f"{shortened(result.first)} and {shortened(result.second)}",
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        notes=result.notes,
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
    )


def _judged(result: MeasurementsCompared) -> tuple[str, str, Colour]:
    """Return what the differences mean."""
    if result.changed == "no_pairs":
        return (
            "No mode has a partner",
            "No mode of one is within 25 % of any of the other, with a MAC of 0.5 where shapes are known.",
            "bad",
        )
    count = len(result.pairs)
    unpaired = len(result.first_unpaired) + len(result.second_unpaired)
    unpaired_note = f"; {plural(unpaired, 'mode')} without a partner" if unpaired else ""
    common = result.common
    changed = sorted(
        (pair for pair in result.pairs if pair.own_change),
        key=lambda pair: -abs(_single_change(result, pair)[1]),
    )
    named = ", ".join(
        f"{mode_name(pair)} by {_change(*_single_change(result, pair))}" for pair in changed[:NAMED]
    )
    named += f" and {len(changed) - NAMED} more" if len(changed) > NAMED else ""
    shared = "" if common is None else _change(common.relative, common.sigmas)
    reasons = []
    tone: Colour = "open"
    match result.changed:
        case "single":
            headline = f"{len(changed)} of {plural(count, 'mode')} changed: {named}"
            reasons.append(_nothing_common(common))
        case "common":
            headline = f"{_sharing(common, count)} changed by one factor: {shared}"
            reasons += [_left_of_single(common), FACTOR]
        case "common_and_single":
            headline = f"{_sharing(common, count)} changed by one factor, {shared}; beyond it {named}"
            reasons.append(FACTOR)
        case "together":
            headline = "All modes together changed by more than the errors"
            reasons.append("No single one did.")
        case _:
            headline, tone = "No mode changed by more than the errors", "good"
            reasons.append(_noticeable(result))
    reasons += [*where(result), "The stated errors are taken as independent."]
    return headline + unpaired_note, " ".join(reason for reason in reasons if reason), tone


def _single_change(result: MeasurementsCompared, pair: ModePair) -> tuple[float, float]:
    """Return the change of a mode by itself: beyond the common one, where there is one; and in sigmas."""
    if result.changed == "common_and_single":
        return pair.beyond_common or 0.0, pair.beyond_common_sigmas or 0.0
    return pair.relative, pair.sigmas


def _change(relative: float | None, sigmas: float | None) -> str:
    """Return a change in per cent and its standard deviations."""
    change = 100.0 * (relative or 0.0)
    return f"{'-' if change < 0.0 else '+'}{plain(abs(change), 3)} % ({deviations_in_words(sigmas)})"


def _sharing(common: CommonChange | None, count: int) -> str:
    """Return how many modes share a change."""
    shared = count if common is None else common.pairs
    if shared == count:
        return "Both modes" if count == 2 else f"All {count} modes"
    return f"{shared} of {count} modes"


def _nothing_common(common: CommonChange | None) -> str:
    """Return that no change is shared, and what limits this statement."""
    if common is None:
        return ""
    if common.relative is None:
        p = p_text(common.residual_p_value)
        return f"No change is common to most of them: their factors differ (p-value {p})."
    whose = f"the {common.pairs} that agree" if common.residual_p_value <= SIGNIFICANCE_LEVEL else "all"
    return f"No change is common to all modes: that of {whose} is {_change(common.relative, common.sigmas)}."


def _left_of_single(common: CommonChange | None) -> str:
    """Return whether single modes differ from the change that all share."""
    if common is None:
        return ""
    p = p_text(common.residual_p_value)
    if common.residual_p_value > SIGNIFICANCE_LEVEL:
        return f"What single modes did beyond it is within the errors (p-value {p})."
    return f"What remains is more than the errors for all modes together (p-value {p}), but not for any single mode."


def _noticeable(result: MeasurementsCompared) -> str:
    """Return which changes would have been found."""
    smallest, largest = (choose(result.pairs, key=lambda pair: pair.noticeable) for choose in (min, max))
    text = f"Changes that would have counted: of a single mode by {plain(100.0 * smallest.noticeable, 2)} %"
    if largest is not smallest:
        text += f" ({mode_name(smallest)}) to {plain(100.0 * largest.noticeable, 2)} % ({mode_name(largest)})"
    if result.common is not None and result.common.sigma is not None:
        text += f", or of all modes by {plain(100.0 * MIN_COMMON_SIGMAS * result.common.sigma, 2)} %"
    return f"{text}."


def changes(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the pairs: the largest changes in standard deviations first, up to `max_rows`, or all in order."""
    order = sorted(range(len(result.pairs)), key=lambda i: -abs(result.pairs[i].sigmas))
    shown = list(range(len(result.pairs))) if max_rows is None else order[:max_rows]
    shared = result.common is not None and result.common.differs
    rows = []
    for i in shown:
        pair = result.pairs[i]
        at = pointer("pairs", i)
        label = pair.pose if pair.pose == pair.second_pose else f"{pair.pose}, {pair.second_pose}"
        rows.append(
            [
                Cell(shortened(label)),
                number(pair.first_line, ".0f", at + pointer("first_line")),
                number(pair.first, ".3f", at + pointer("first")),
                three_digits(pair.first_sigma, at + pointer("first_sigma")),
                number(pair.second_line, ".0f", at + pointer("second_line")),
                number(pair.second, ".3f", at + pointer("second")),
                three_digits(pair.second_sigma, at + pointer("second_sigma")),
                number(pair.relative, "+.2f", at + pointer("relative"), scale=100.0),
                number(pair.sigmas, "+.1f", at + pointer("sigmas")),
                Cell("yes" if pair.differs else NOTHING),
                *(_beyond(pair, at) if shared else []),
                number(pair.mac, ".3f", at + pointer("mac")),
            ]
        )
    if not rows:
        return []
    of_each = [Column("line"), Column("f [Hz]"), Column("sigma [Hz]")]
    of_change = [Column("[%]"), Column("[\u03c3]"), Column("clear", numbers=False)]
    of_beyond = of_change if shared else []
    columns = [Column("pose", numbers=False), *of_each, *of_each, *of_change, *of_beyond, Column("MAC")]
    groups = [("", 1), ("first", 3), ("second", 3), ("change", 3)]
    groups += [("beyond the common", 3)] if shared else []
    groups += [("", 1)]
    caption = "Modes of both measurements; changes are second minus first."
    if all(pair.mac is None for pair in result.pairs):
        rows, columns, groups = [row[:-1] for row in rows], columns[:-1], groups[:-1]
    omitted = len(result.pairs) - len(shown)
    note = f"{plural(omitted, 'pair')} that changed less: --all prints every pair." if omitted else ""
    return [table(caption, columns, rows, groups, note)]


def _beyond(pair: ModePair, at: str) -> list[Cell]:
    """Return the cells of a change beyond the common one."""
    return [
        number(pair.beyond_common, "+.2f", at + pointer("beyond_common"), scale=100.0),
        number(pair.beyond_common_sigmas, "+.1f", at + pointer("beyond_common_sigmas")),
        Cell("yes" if pair.own_change else NOTHING),
    ]
