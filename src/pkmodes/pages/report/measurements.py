"""Two measurements compared, in numbers: what changed, and which modes by more than their errors."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING

from pkmodes.core.base.numbers import p_text, plain
from pkmodes.core.support.mac import MIN_MAC_OF_PAIR
from pkmodes.loop.measured.comparison import MeasurementsCompared, ModePair
from pkmodes.loop.measured.same_modes import MAX_LOG_DIFFERENCE
from pkmodes.loop.measured.significance import MIN_COMMON_SIGMAS, SIGNIFICANCE_LEVEL, CommonChange
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import (
    MISSING,
    number_cell,
    p_value_cell,
    plural,
    pointer,
    shorten,
    three_digit_cell,
)
from pkmodes.pages.report.measured_shapes import mode_name, place_sentences, sigmas_in_words
from pkmodes.pages.report.numbers import percent_cell
from pkmodes.pages.report.tables import compact_table

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour

#: Maximum number of modes named in a headline.
MAX_MODES_NAMED = 3
#: Share of the modes with a change of their own above which a common factor is not the story.
MAX_OWN_SHARE = 0.25
#: Largest change of a frequency at which two modes are paired [%].
MAX_CHANGE = 100.0 * math.expm1(MAX_LOG_DIFFERENCE)
ONE_PLACE_NOTE = (
    "One place that changed, such as one belt, moves each mode by another amount: pkmodes changed, with the robot "
    "file, looks for it."
)
COMMON_FACTOR_NOTE = (
    "Modes change in this way where stiffness or mass changes everywhere in proportion, as with the temperature "
    "or the tension of all belts, and where the clock of one test is wrong."
)


def measurements_summary(result: MeasurementsCompared) -> Summary:
    """Return whether the measurements differ, and by how much."""
    headline, reason, tone = _assess_differences(result)
    pair_count, common = len(result.pairs), result.common
    facts = [
        ("median change [%]", percent_cell(result.median_relative, pointer("median_relative"))),
        ("rms change [%]", percent_cell(result.rms_relative, pointer("rms_relative"))),
        ("chi\u00b2 per pair", three_digit_cell(result.chi2 / pair_count if pair_count else None)),
        (
            "common change [%]",
            percent_cell(common.relative if common else None, pointer("common", "relative")),
        ),
        ("p-value", p_value_cell(result.p_value, pointer("p_value"))),
        ("pairs", Cell(str(pair_count), pair_count)),
        ("poses", Cell(str(result.poses), result.poses, pointer("poses"))),
        ("only in the first", Cell(str(len(result.first_unpaired)), len(result.first_unpaired))),
        ("only in the second", Cell(str(len(result.second_unpaired)), len(result.second_unpaired))),
    ]
    return Summary(
        subject=f"{shorten(result.first)} and {shorten(result.second)}",
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        notes=result.notes,
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
    )


def _assess_differences(result: MeasurementsCompared) -> tuple[str, str, Colour]:
    """Return what the differences mean."""
    if result.changed == "no_pairs":
        return (
            "No mode has a partner",
            f"No mode of the first measurement has one of the second within {MAX_CHANGE:.0f} % in frequency (and "
            f"with a MAC of at least {MIN_MAC_OF_PAIR:g}, where shapes are known).",
            "bad",
        )
    pair_count = len(result.pairs)
    unpaired = len(result.first_unpaired) + len(result.second_unpaired)
    unpaired_note = f"; {plural(unpaired, 'mode')} without a partner" if unpaired else ""
    common = result.common
    changed_pairs = sorted(
        (pair for pair in result.pairs if pair.own_change),
        key=lambda pair: -abs(_single_change(result, pair)[1]),
    )
    changes_in_words = ", ".join(
        f"{mode_name(pair)} by {_change_in_words(*_single_change(result, pair))}"
        for pair in changed_pairs[:MAX_MODES_NAMED]
    )
    changes_in_words += (
        f" and {len(changed_pairs) - MAX_MODES_NAMED} more" if len(changed_pairs) > MAX_MODES_NAMED else ""
    )
    common_text = "" if common is None else _change_in_words(common.relative, common.sigmas)
    reasons = []
    tone: Colour = "open"
    match result.changed:
        case "single":
            headline = f"{len(changed_pairs)} of {plural(pair_count, 'mode')} changed: {changes_in_words}"
            reasons.append(_no_common_change_note(common))
        case "common":
            headline = f"{_modes_that_share(common, pair_count)} changed by one factor: {common_text}"
            reasons += [_beyond_common_note(common), COMMON_FACTOR_NOTE]
        case "common_and_single":
            if len(changed_pairs) > MAX_OWN_SHARE * pair_count:
                changes = [pair.relative for pair in changed_pairs]
                headline = (
                    f"{len(changed_pairs)} of {plural(pair_count, 'mode')} changed, each by a factor of its own "
                    f"({_change_in_words(min(changes))} to {_change_in_words(max(changes))}), most of all "
                    f"{_named_change(_largest_change(changed_pairs))}"
                )
                reasons += [_common_to_the_others_note(common, pair_count), ONE_PLACE_NOTE]
            else:
                headline = (
                    f"{_modes_that_share(common, pair_count)} changed by one factor, {common_text}; beyond it "
                    f"{changes_in_words}"
                )
                reasons.append(COMMON_FACTOR_NOTE)
        case "together":
            headline = "All modes together changed by more than the errors"
            reasons.append("No single one did.")
        case _:
            headline, tone = "No mode changed by more than the errors", "good"
            reasons.append(_noticeable_changes_note(result))
    reasons += [*place_sentences(result), "The stated errors are taken as independent."]
    return headline + unpaired_note, " ".join(reason for reason in reasons if reason), tone


def _largest_change(pairs: Sequence[ModePair]) -> ModePair:
    """Return the pair whose frequency changed most."""
    return max(pairs, key=lambda pair: abs(pair.relative))


def _single_change(result: MeasurementsCompared, pair: ModePair) -> tuple[float, float]:
    """Return the relative change of one mode, less the common change if both kinds were found, and that in sigmas."""
    if result.changed == "common_and_single":
        return pair.beyond_common or 0.0, pair.beyond_common_sigmas or 0.0
    return pair.relative, pair.sigmas


def _change_in_words(relative: float | None, sigmas: float | None = None) -> str:
    """Return a change in per cent, and its standard deviations if given."""
    change = 100.0 * (relative or 0.0)
    text = f"{'-' if change < 0.0 else '+'}{plain(abs(change), 3)} %"
    return text if sigmas is None else f"{text} ({sigmas_in_words(sigmas)})"


def _named_change(pair: ModePair) -> str:
    return f"{mode_name(pair)} by {_change_in_words(pair.relative, pair.sigmas)}"


def _common_to_the_others_note(common: CommonChange | None, count: int) -> str:
    """Return by how much the modes changed that agree with one another."""
    if common is None:
        return ""
    change = _change_in_words(common.relative, common.sigmas)
    return f"{common.pairs} of the {count} modes agree with a common change of {change}."


def _modes_that_share(common: CommonChange | None, count: int) -> str:
    """Return how many modes share a change."""
    shared_count = count if common is None else common.pairs
    if shared_count == count:
        return "Both modes" if count == 2 else f"All {count} modes"
    return f"{shared_count} of {count} modes"


def _no_common_change_note(common: CommonChange | None) -> str:
    """Return that no change is shared, and what limits this statement."""
    if common is None:
        return ""
    if common.relative is None:
        p = p_text(common.residual_p_value)
        return f"No change is common to most of them: their factors differ (p-value {p})."
    modes_text = (
        f"the {common.pairs} modes that agree"
        if common.residual_p_value <= SIGNIFICANCE_LEVEL
        else "all modes"
    )
    return (
        f"No common change is significant: the mean over {modes_text} is "
        f"{_change_in_words(common.relative, common.sigmas)}."
    )


def _beyond_common_note(common: CommonChange | None) -> str:
    """Return whether single modes differ from the change that all share."""
    if common is None:
        return ""
    p = p_text(common.residual_p_value)
    if common.residual_p_value > SIGNIFICANCE_LEVEL:
        return f"The remaining changes of the modes are within the errors (p-value {p})."
    return f"What remains is more than the errors for all modes together (p-value {p}), but not for any single mode."


def _noticeable_changes_note(result: MeasurementsCompared) -> str:
    """Return which changes would have been found."""
    smallest, largest = (extreme(result.pairs, key=lambda pair: pair.noticeable) for extreme in (min, max))
    text = f"Smallest detectable change: {plain(100.0 * smallest.noticeable, 2)} %"
    if largest is not smallest:
        text += f" ({mode_name(smallest)}) to {plain(100.0 * largest.noticeable, 2)} % ({mode_name(largest)})"
    text += " for a single mode"
    if result.common is not None and result.common.sigma is not None:
        text += f", or {plain(100.0 * MIN_COMMON_SIGMAS * result.common.sigma, 2)} % for a change common to all modes"
    return f"{text}."


def mode_pair_tables(result: MeasurementsCompared, max_rows: int | None) -> list[Table]:
    """Return the pairs: the largest changes in standard deviations first, up to `max_rows`, or all in order."""
    order = sorted(range(len(result.pairs)), key=lambda i: -abs(result.pairs[i].sigmas))
    pair_indices = list(range(len(result.pairs))) if max_rows is None else order[:max_rows]
    has_common_change = result.common is not None and result.common.differs
    rows = []
    for i in pair_indices:
        pair = result.pairs[i]
        pair_pointer = pointer("pairs", i)
        pose_label = pair.pose if pair.pose == pair.second_pose else f"{pair.pose}, {pair.second_pose}"
        rows.append(
            [
                Cell(shorten(pose_label)),
                number_cell(pair.first_line, ".0f", pair_pointer + pointer("first_line")),
                number_cell(pair.first, ".3f", pair_pointer + pointer("first")),
                three_digit_cell(pair.first_sigma, pair_pointer + pointer("first_sigma")),
                number_cell(pair.second_line, ".0f", pair_pointer + pointer("second_line")),
                number_cell(pair.second, ".3f", pair_pointer + pointer("second")),
                three_digit_cell(pair.second_sigma, pair_pointer + pointer("second_sigma")),
                number_cell(pair.relative, "+.2f", pair_pointer + pointer("relative"), scale=100.0),
                number_cell(pair.sigmas, "+.1f", pair_pointer + pointer("sigmas")),
                Cell("yes" if pair.differs else MISSING),
                *(_beyond_common_cells(pair, pair_pointer) if has_common_change else []),
                number_cell(pair.mac, ".3f", pair_pointer + pointer("mac")),
            ]
        )
    if not rows:
        return []
    measurement_columns = [Column("line"), Column("f [Hz]"), Column("sigma [Hz]")]
    change_columns = [Column("[%]"), Column("[\u03c3]"), Column("significant", numeric=False)]
    beyond_columns = change_columns if has_common_change else []
    columns = [
        Column("pose", numeric=False),
        *measurement_columns,
        *measurement_columns,
        *change_columns,
        *beyond_columns,
        Column("MAC"),
    ]
    groups = [("", 1), ("first", 3), ("second", 3), ("change", 3)]
    groups += [("beyond the common change", 3)] if has_common_change else []
    groups += [("", 1)]
    caption = "Modes of both measurements; changes are second minus first."
    if all(pair.mac is None for pair in result.pairs):
        rows, columns, groups = [row[:-1] for row in rows], columns[:-1], groups[:-1]
    omitted = len(result.pairs) - len(pair_indices)
    note = f"{plural(omitted, 'pair')} that changed less: --all prints every pair." if omitted else ""
    return [compact_table(caption, columns, rows, groups, note)]


def _beyond_common_cells(pair: ModePair, pair_pointer: str) -> list[Cell]:
    """Return the cells of a change beyond the common one."""
    return [
        number_cell(pair.beyond_common, "+.2f", pair_pointer + pointer("beyond_common"), scale=100.0),
        number_cell(pair.beyond_common_sigmas, "+.1f", pair_pointer + pointer("beyond_common_sigmas")),
        Cell("yes" if pair.own_change else MISSING),
    ]
