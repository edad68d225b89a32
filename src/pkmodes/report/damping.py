"""Measured damping beside that of the model, before and after the diagnosis."""

from __future__ import annotations

from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.rows import Row
from pkmodes.report.blocks import Block, Cell, Column, Paragraph
from pkmodes.report.formatting import clean, hertz, plural, pointer, prose, three_digits, uncertain
from pkmodes.report.tables import table

#: Most rows on the page.
MOST = 300
#: Columns of the ratios of the model: key in the JSON and title.
RATIOS = {"damping_before": "as declared [%]", "damping_after": "as diagnosed [%]"}


def damping(result: Diagnosis) -> list[Block]:
    """Return what the damping says, and the ratios of all modes; nothing where damping was not diagnosed."""
    found = result.damping
    if found is None:
        return []
    text = f"{found.sentence[:1].upper()}{found.sentence[1:]}."
    blocks: list[Block] = [Paragraph(prose(text)), *_factors(result)]
    rows = [(i, row) for i, row in enumerate(result.rows) if row.damping is not None]
    note = ""
    if len(rows) > MOST:
        note = f"The table has the first {MOST} of {len(rows)} ratios. All are in the output of --json, under rows."
    columns = [Column("pose", False), Column("line"), Column("f [Hz]"), Column("measured [%]")]
    columns += [*(Column(title) for title in RATIOS.values()), Column("remark", False)]
    caption = "Damping ratios: measured, and those of the model, whose frequencies are the final ones."
    blocks.append(table(caption, columns, [_row(i, row) for i, row in rows[:MOST]], note=note))
    return blocks


def _factors(result: Diagnosis) -> list[Block]:
    """Return how far the model is from the measured ratios."""
    found = result.damping
    assert found is not None
    factors = {
        "as declared": found.before,
        "as diagnosed": found.after,
        "at the held-out poses": found.held_out,
    }
    parts = [f"{factor:.3g} {name}" for name, factor in factors.items() if factor is not None]
    if not parts:
        return []
    count = plural(found.fitted, "fitted ratio")
    return [Paragraph(f"Root mean square factor between model and measurement, {count}: {', '.join(parts)}.")]


def _row(i: int, row: Row) -> list[Cell]:
    measured = three_digits(row.damping, pointer("rows", i, "damping"), scale=100.0)
    if row.damping is not None and row.sigma_damping is not None:
        places = [pointer("rows", i, key) for key in ("damping", "sigma_damping")]
        measured = uncertain(row.damping, row.sigma_damping, *places, scale=100.0)
    ratios = [three_digits(getattr(row, key), pointer("rows", i, key), scale=100.0) for key in RATIOS]
    remark = "" if row.damping_used else "held out" if row.held_out else "not used"
    return [
        Cell(clean(row.pose)),
        Cell(str(row.line), row.line, pointer("rows", i, "line")),
        hertz(row.measured, pointer("rows", i, "frequency_hz")),
        measured,
        *ratios,
        Cell(remark),
    ]
