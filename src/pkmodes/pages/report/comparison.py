"""A comparison with measurements in numbers: whether the differences are noise, and those of each mode."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import (
    number_cell,
    p_value_cell,
    plural,
    pointer,
    three_digit_cell,
    typeset_sentences,
)
from pkmodes.pages.report.numbers import percent_cell
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.tables import compact_table
from pkmodes.pages.report.unmatched import kinds_in_words

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour


def comparison_summary(result: Comparison, context: ReportContext) -> Summary:
    """Return what the differences mean, and how large they are."""
    headline, reason, tone = assess_differences(result)
    mode_count, pose_count = len(result.rows), len({row.pose for row in result.rows})
    facts = [
        ("rms difference [%]", percent_cell(result.rms_relative, pointer("rms_relative"))),
        (
            f"chi\u00b2 per degree of freedom of {_paired_modes(result)}",
            three_digit_cell(result.chi2_per_dof, pointer("chi2_per_dof")),
        ),
        ("p-value", p_value_cell(result.p_value, pointer("p_value"))),
        ("measured modes", Cell(str(mode_count), mode_count)),
        ("poses", Cell(str(pose_count), pose_count)),
        ("unmatched", Cell(str(len(result.unpaired)), len(result.unpaired), pointer("unpaired"))),
    ]
    return Summary(
        subject=context.title(row.drives for row in result.rows),
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        notes=[typeset_sentences(note) for note in result.notes],
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
        head=context.head,
    )


def assess_differences(result: Comparison) -> tuple[str, str, Colour]:
    """Return what the differences mean, from their p-value at the level of the diagnosis."""
    p = result.p_value
    if p is None:
        return (
            "No measured mode has a partner",
            f"Unmatched: {kinds_in_words(result.unpaired)}.",
            "bad",
        )
    unmatched_note = (
        f"; {plural(len(result.unpaired), 'measured mode')} without a partner" if result.unpaired else ""
    )
    left_out = (
        f" The rms, chi\u00b2 and p are of {_paired_modes(result)}. Left out: {kinds_in_words(result.unpaired)}."
        if result.unpaired
        else ""
    )
    if p > Criteria().gate.level:
        headline = "The differences are within the measurement errors"
        modes = _paired_modes(result) if result.unpaired else "the measured modes"
        reason = f"Nothing was fitted: the declared model predicts {modes} as well as they were measured.{left_out}"
        return headline + unmatched_note, reason, "open" if result.unpaired else "good"
    headline = "The differences are larger than the measurement errors"
    reason = (
        "Nothing was fitted. The declared model differs from the measurements by more than their stated errors: "
        f"pkmodes diagnose looks for the cause.{left_out}"
    )
    return headline + unmatched_note, reason, "open"


def _paired_modes(result: Comparison) -> str:
    """Return what rms, chi-square and the p-value are of."""
    count = len(result.rows) - len(result.unpaired)
    return "the paired mode" if count == 1 else f"the {count} paired modes"


def mode_difference_tables(result: Comparison) -> list[Table]:
    """Return the deviation of each mode of the model from its measurements; empty if none has a partner."""
    rows = []
    for partner in sorted({row.partner for row in result.rows if row.partner is not None}):
        mode_rows = [row for row in result.rows if row.partner == partner]
        differences = np.array([row.residual for row in mode_rows], dtype=float)
        largest = mode_rows[int(np.argmax(np.abs(differences)))]
        row_pointer = pointer("rows", result.rows.index(largest))
        rows.append(
            [
                Cell(str(partner - result.rigid)),
                number_cell(len(mode_rows), ".0f"),
                number_cell(float(np.median(differences)), "+.2f", scale=100.0),
                number_cell(float(np.sqrt(np.mean(differences**2))), ".2f", scale=100.0),
                number_cell(largest.residual, "+.2f", row_pointer + pointer("residual"), scale=100.0),
                number_cell(largest.sigmas, "+.1f", row_pointer + pointer("sigmas")),
                Cell(str(largest.line), largest.line, row_pointer + pointer("line")),
                _median_cell(row.damping for row in mode_rows),
                _median_cell(row.predicted_damping for row in mode_rows),
            ]
        )
    if not rows:
        return []
    columns = [Column("mode"), Column("times measured"), Column("median [%]"), Column("rms [%]")]
    columns += [
        Column("[%]"),
        Column("[\u03c3]"),
        Column("line"),
        Column("measured [%]"),
        Column("model [%]"),
    ]
    groups = [("", 2), ("difference", 2), ("the largest one", 3), ("damping", 2)]
    if all(row.damping is None for row in result.rows):
        rows, columns, groups = [row[:-2] for row in rows], columns[:-2], groups[:-1]
    caption = "Each mode of the model: model minus measurement over all that was measured of it"
    caption += "." if len(groups) < 4 else "; damping ratios are medians."
    return [compact_table(caption, columns, rows, groups)]


def _median_cell(ratios: Iterable[float | None]) -> Cell:
    """Return the median of the damping ratios that are known, in per cent."""
    available = [ratio for ratio in ratios if ratio is not None]
    return number_cell(float(np.median(available)) if available else None, ".3g", scale=100.0)
