"""The table of all measured modes with the model beside them."""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.compare import ComparedRow, Comparison
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.measured.quantities import FREQUENCY
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import hertz, label, number, plural, pointer
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table

#: Most rows on the page; beyond that, only those that differ most.
MOST = 300
#: Keys of the measured columns in the JSON of a diagnosis and of a comparison.
MEASURED = {Diagnosis: ("frequency_hz", "sigma_hz"), Comparison: ("measured", "sigma")}


def mode_table(
    result: Diagnosis | Comparison,
    evidence: PlottedEvidence,
    setting: ReportSetting,
    max_rows: int = MOST,
    *,
    paired: bool = False,
) -> Table:
    """Return all measured modes in the order of their poses, or the worst first if there are more than `max_rows`.

    - paired: whether only modes with a partner count as the worst: the others are reported elsewhere
    """
    rows: list[Row | ComparedRow] = [*result.rows]
    chosen, note = _chosen(evidence, max_rows, paired)
    has_names = any(row.mode for row in rows)
    shapes = any(row.mac is not None for row in rows)
    loads = any(row.load for row in rows)
    mixed = len({row.drives for row in rows}) > 1
    remarks = [_remark(row, evidence, i) for i, row in enumerate(rows)]
    columns = [
        Column(evidence.setup_noun, numbers=False),
        *([Column("motors", numbers=False)] if mixed else []),
    ]
    columns += [Column("line")]
    columns += [Column("own", numbers=False)] if has_names else []
    columns += [Column("mode"), Column(FREQUENCY.value.heading), Column(FREQUENCY.sigma.heading)]
    groups = [("", 3 + mixed + has_names), ("measured", 2)]
    for stage in evidence.stages:
        columns += [Column(FREQUENCY.value.heading), Column("diff. [%]"), Column("diff. [\u03c3]")]
        groups.append((f"model {stage.title}", 3))
    damped = any(isinstance(row, ComparedRow) and row.damping is not None for row in rows)
    if damped:
        columns += [Column("measured [%]"), Column("\u03c3 [%]"), Column("model [%]")]
        groups.append(("damping ratio", 3))
    columns += [Column("MAC")] if shapes else []
    columns += [Column("remark", numbers=False)] if any(remarks) else []
    columns += [Column("set", numbers=False)] if loads else []
    rest = shapes + any(remarks) + loads
    groups += [("", rest)] if rest else []
    lines = []
    for i in chosen:
        row = rows[i]
        cells = [label(row.pose), *([Cell(row.drives or "")] if mixed else [])]
        cells += [Cell(str(row.line), row.line, pointer("rows", i, "line"))]
        cells += [label(row.mode)] if has_names else []
        cells += _numbers(result, evidence, i)
        if damped and isinstance(row, ComparedRow):
            keys = ("damping", "sigma_damping", "predicted_damping")
            cells += [number(getattr(row, key), ".3g", pointer("rows", i, key), scale=100.0) for key in keys]
        cells += [number(row.mac, ".3f", pointer("rows", i, "mac"))] if shapes else []
        cells += [Cell(remarks[i])] if any(remarks) else []
        cells += [setting.load(row.load)] if loads else []
        lines.append(cells)
    caption = (
        "Measured modes and the model; differences are model minus measurement. Line: of the measurement file"
    )
    caption += "; own: the name of the mode there." if has_names else "."
    return table(caption, columns, lines, groups, note, heads=2 + mixed)


def _chosen(evidence: PlottedEvidence, max_rows: int, paired: bool) -> tuple[list[int], str]:
    """Return the rows of the table, by pose and frequency or the worst first, and a note on those omitted."""
    order: list[int] = np.lexsort((evidence.measured, evidence.setup_indices)).tolist()
    if len(order) <= max_rows:
        return order, ""
    if evidence.stages:  # by their difference at the last stage, unmatched ones first
        away = np.abs(evidence.last_stage.predicted.normalised_differences)
        order = np.argsort(-np.where(np.isnan(away), np.inf, away), kind="stable").tolist()
        with_partner = [i for i in order if evidence.last_stage.paired[i]]
        order = with_partner if paired and with_partner else order
    chosen = order[:max_rows]
    which = "measured mode that differs" if len(chosen) == 1 else f"{len(chosen)} measured modes that differ"
    note = f"The table has the {which} most from the model{', the worst first' if len(chosen) > 1 else ''}. All {plural(len(evidence.measured), 'mode')} are in the output of --json, under rows."
    return chosen, note


def _numbers(result: Diagnosis | Comparison, evidence: PlottedEvidence, i: int) -> list[Cell]:
    """Return the mode, the measured frequency, and the model at each stage of one row."""
    row = result.rows[i]
    mode = int(evidence.mode_numbers()[i]) if evidence.stages else 0
    frequency, sigma = MEASURED[Diagnosis if isinstance(result, Diagnosis) else Comparison]
    cells = [
        Cell(str(mode) if mode else "none"),
        hertz(row.measured, pointer("rows", i, frequency)),
        hertz(row.sigma, pointer("rows", i, sigma)),
    ]
    for stage in evidence.stages:
        if isinstance(row, ComparedRow):
            cells.append(hertz(row.predicted, pointer("rows", i, "predicted")))
            cells.append(number(row.residual, "+.2f", pointer("rows", i, "residual"), scale=100.0))
            cells.append(number(row.sigmas, "+.1f", pointer("rows", i, "sigmas")))
        else:
            cells.append(hertz(getattr(row, stage.key), pointer("rows", i, f"{stage.key}_hz")))
            cells.append(number(float(evidence.difference(stage)[i]), "+.2f", scale=100.0))
            cells.append(number(float(stage.predicted.normalised_differences[i]), "+.1f"))
    return cells


def _remark(row: Row | ComparedRow, evidence: PlottedEvidence, i: int) -> str:
    words = []
    if isinstance(row, Row):
        words += ["held out"] * row.held_out + ["set aside"] * row.outlier
    elif row.shape_differs:
        words.append("damping of another shape")
    if evidence.stages and not evidence.last_stage.paired[i]:
        words.append("unmatched")
    return ", ".join(words)
