"""A comparison with measurements in numbers: whether the differences are noise, and those of each mode."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.pages.report.blocks import Cell, Column, Summary, Table
from pkmodes.pages.report.formatting import number, p_value, plural, pointer, prose, three_digits
from pkmodes.pages.report.numbers import percent
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour


def comparison_summary(result: Comparison, setting: ReportSetting) -> Summary:
    """Return what the differences mean, and how large they are."""
    headline, reason, tone = judged(result)
    count, places = len(result.rows), len({row.pose for row in result.rows})
    facts = [
        ("rms difference [%]", percent(result.rms_relative, pointer("rms_relative"))),
        ("chi\u00b2 per degree of freedom", three_digits(result.chi2_per_dof, pointer("chi2_per_dof"))),
        ("p-value", p_value(result.p_value, pointer("p_value"))),
        ("measured modes", Cell(str(count), count)),
        ("poses", Cell(str(places), places)),
        ("unmatched", Cell(str(len(result.unpaired)), len(result.unpaired), pointer("unpaired"))),
    ]
    return Summary(
        subject=setting.title(row.drives for row in result.rows),
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        notes=[prose(note) for note in result.notes],
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
        head=setting.head,
    )


def judged(result: Comparison) -> tuple[str, str, Colour]:
    """Return what the differences mean, from their p-value at the level of the diagnosis."""
    p = result.p_value
    if p is None:
        return (
            "No measured mode has a partner",
            "The model has no mode near any of the measured frequencies.",
            "bad",
        )
    unmatched = (
        f"; {plural(len(result.unpaired), 'measured mode')} without a partner" if result.unpaired else ""
    )
    if p > Criteria().gate.level:
        headline = "The differences are within the measurement errors"
        reason = "Nothing was fitted: the declared model predicts the measured modes as well as they were measured."
        return headline + unmatched, reason, "open" if result.unpaired else "good"
    headline = "The differences are larger than the measurement errors"
    reason = (
        "Nothing was fitted. The declared model differs from the measurements by more than their stated errors: "
        "pkmodes diagnose looks for the cause."
    )
    return headline + unmatched, reason, "open"


def by_mode(result: Comparison) -> list[Table]:
    """Return the deviation of each mode of the model from its measurements; empty if none has a partner."""
    rows = []
    for partner in sorted({row.partner for row in result.rows if row.partner is not None}):
        mine = [row for row in result.rows if row.partner == partner]
        differences = np.array([row.residual for row in mine], dtype=float)
        largest = mine[int(np.argmax(np.abs(differences)))]
        place = pointer("rows", result.rows.index(largest))
        rows.append(
            [
                Cell(str(partner - result.rigid)),
                number(len(mine), ".0f"),
                number(float(np.median(differences)), "+.2f", scale=100.0),
                number(float(np.sqrt(np.mean(differences**2))), ".2f", scale=100.0),
                number(largest.residual, "+.2f", place + pointer("residual"), scale=100.0),
                number(largest.sigmas, "+.1f", place + pointer("sigmas")),
                Cell(str(largest.line), largest.line, place + pointer("line")),
                _median(row.damping for row in mine),
                _median(row.predicted_damping for row in mine),
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
    return [table(caption, columns, rows, groups)]


def _median(ratios: Iterable[float | None]) -> Cell:
    """Return the median of the damping ratios that are known, in per cent."""
    available = [ratio for ratio in ratios if ratio is not None]
    return number(float(np.median(available)) if available else None, ".3g", scale=100.0)
