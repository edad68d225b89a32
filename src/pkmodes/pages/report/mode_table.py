"""The table of all measured modes with the model beside them."""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.compare import ComparedRow, Comparison
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.measured.quantities import FREQUENCY
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import frequency_cell, label_cell, number_cell, plural, pointer
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.tables import compact_table
from pkmodes.pages.report.unmatched import OTHER_SHAPE, nearest_in_words

#: Maximum number of rows on the page; beyond that, only those that differ most.
MAX_ROWS = 300
#: Keys of the measured columns in the JSON of a diagnosis and of a comparison.
MEASURED_KEYS = {Diagnosis: ("frequency_hz", "sigma_hz"), Comparison: ("measured", "sigma")}


def mode_table(
    result: Diagnosis | Comparison,
    evidence: PlottedEvidence,
    context: ReportContext,
    max_rows: int = MAX_ROWS,
    *,
    paired_only: bool = False,
) -> Table:
    """Return all measured modes in the order of their poses, or the worst first if there are more than `max_rows`.

    - paired_only: whether only modes with a partner count as the worst: the others are reported elsewhere
    """
    rows: list[Row | ComparedRow] = [*result.rows]
    row_indices, note = _choose_rows(evidence, max_rows, paired_only)
    has_names = any(row.mode for row in rows)
    has_macs = any(row.mac is not None for row in rows)
    has_loads = any(row.load for row in rows)
    has_several_drives = len({row.drives for row in rows}) > 1
    remarks = [_remark(row, evidence, i) for i, row in enumerate(rows)]
    has_remarks = any(remark.text for remark in remarks)
    columns = [
        Column(evidence.setup_noun, numeric=False),
        *([Column("motors", numeric=False)] if has_several_drives else []),
    ]
    columns += [Column("line")]
    columns += [Column("own", numeric=False)] if has_names else []
    columns += [Column("mode"), Column(FREQUENCY.value.heading), Column(FREQUENCY.sigma.heading)]
    groups = [("", 3 + has_several_drives + has_names), ("measured", 2)]
    for stage in evidence.stages:
        columns += [Column(FREQUENCY.value.heading), Column("diff. [%]"), Column("diff. [\u03c3]")]
        groups.append((f"model {stage.title}", 3))
    has_damping = any(isinstance(row, ComparedRow) and row.damping is not None for row in rows)
    if has_damping:
        columns += [Column("measured [%]"), Column("\u03c3 [%]"), Column("model [%]")]
        groups.append(("damping ratio", 3))
    columns += [Column("MAC")] if has_macs else []
    columns += [Column("remark", numeric=False)] if has_remarks else []
    columns += [Column("set", numeric=False)] if has_loads else []
    ungrouped_count = has_macs + has_remarks + has_loads
    groups += [("", ungrouped_count)] if ungrouped_count else []
    table_rows = []
    for i in row_indices:
        row = rows[i]
        cells = [label_cell(row.pose), *([Cell(row.drives or "")] if has_several_drives else [])]
        cells += [Cell(str(row.line), row.line, pointer("rows", i, "line"))]
        cells += [label_cell(row.mode)] if has_names else []
        cells += _frequency_cells(result, evidence, i)
        if has_damping and isinstance(row, ComparedRow):
            keys = ("damping", "sigma_damping", "predicted_damping")
            cells += [
                number_cell(getattr(row, key), ".3g", pointer("rows", i, key), scale=100.0) for key in keys
            ]
        cells += [number_cell(row.mac, ".3f", pointer("rows", i, "mac"))] if has_macs else []
        cells += [remarks[i]] if has_remarks else []
        cells += [context.load_cell(row.load)] if has_loads else []
        table_rows.append(cells)
    caption = (
        "Measured modes and the model; differences are model minus measurement. Line: of the measurement file"
    )
    caption += "; own: the name of the mode there." if has_names else "."
    if any(rows[i].nearest is not None for i in row_indices):
        caption += f" An unmatched mode with a MAC: the nearest mode of the model has {OTHER_SHAPE}."
    return compact_table(caption, columns, table_rows, groups, note, key_columns=2 + has_several_drives)


def _choose_rows(evidence: PlottedEvidence, max_rows: int, paired_only: bool) -> tuple[list[int], str]:
    """Return the rows of the table, by pose and frequency or the worst first, and a note on those omitted."""
    order: list[int] = np.lexsort((evidence.measured, evidence.setup_indices)).tolist()
    if len(order) <= max_rows:
        return order, ""
    if evidence.stages:  # by their difference at the last stage, unmatched ones first
        deviations = np.abs(evidence.last_stage.predicted.normalised_differences)
        order = np.argsort(-np.where(np.isnan(deviations), np.inf, deviations), kind="stable").tolist()
        with_partner = [i for i in order if evidence.last_stage.paired[i]]
        order = with_partner if paired_only and with_partner else order
    row_indices = order[:max_rows]
    modes_text = (
        "measured mode that differs"
        if len(row_indices) == 1
        else f"{len(row_indices)} measured modes that differ"
    )
    note = (
        f"The table has the {modes_text} most from the "
        f"model{', the worst first' if len(row_indices) > 1 else ''}. All "
        f"{plural(len(evidence.measured), 'mode')} are in the output of --json, under rows."
    )
    return row_indices, note


def _frequency_cells(result: Diagnosis | Comparison, evidence: PlottedEvidence, i: int) -> list[Cell]:
    """Return the mode, the measured frequency, and the model at each stage of one row."""
    row = result.rows[i]
    mode = int(evidence.mode_numbers()[i]) if evidence.stages else 0
    frequency_key, sigma_key = MEASURED_KEYS[Diagnosis if isinstance(result, Diagnosis) else Comparison]
    cells = [
        Cell(str(mode) if mode else "none"),
        frequency_cell(row.measured, pointer("rows", i, frequency_key)),
        frequency_cell(row.sigma, pointer("rows", i, sigma_key)),
    ]
    for stage in evidence.stages:
        if isinstance(row, ComparedRow):
            cells.append(frequency_cell(row.predicted, pointer("rows", i, "predicted")))
            cells.append(number_cell(row.residual, "+.2f", pointer("rows", i, "residual"), scale=100.0))
            cells.append(number_cell(row.sigmas, "+.1f", pointer("rows", i, "sigmas")))
        else:
            cells.append(frequency_cell(getattr(row, stage.key), pointer("rows", i, f"{stage.key}_hz")))
            cells.append(number_cell(float(evidence.difference(stage)[i]), "+.2f", scale=100.0))
            cells.append(number_cell(float(stage.predicted.normalised_differences[i]), "+.1f"))
    return cells


def _remark(row: Row | ComparedRow, evidence: PlottedEvidence, i: int) -> Cell:
    words, nearest, nearest_mac = [], "", ""
    if isinstance(row, Row):
        words += ["held out"] * row.held_out + ["set aside"] * row.outlier
    elif row.shape_differs:
        words.append("damping of another shape")
    if evidence.stages and not evidence.last_stage.paired[i]:
        words.append("unmatched")
        if reason := nearest_in_words(row):
            nearest, nearest_mac = f": {reason}", f": MAC {row.nearest_mac:.3f}"
    text = ", ".join(words)
    return Cell(text + nearest, plain_text=text + nearest_mac)
