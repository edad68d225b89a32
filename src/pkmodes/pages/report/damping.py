"""What the damping adds to the verdict, and measured damping beside that of the model."""

from __future__ import annotations

from statistics import median

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.verdict.result import Damping, Diagnosis, parameter_key
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.diagnosis.verdict.verdicts import ADEQUATE, EFFECT_FOUND
from pkmodes.pages.report import explanations
from pkmodes.pages.report.blocks import Block, Cell, Column, Facts, Listing, Paragraph, Table
from pkmodes.pages.report.formatting import (
    MISSING,
    clean,
    frequency_cell,
    plural,
    pointer,
    rounded_cell,
    shorten,
    three_digit_cell,
    to_sentence,
    typeset_sentences,
    uncertain_cell,
    unit_cell,
    unit_text,
)
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.stability import CHANGE_TITLES
from pkmodes.pages.report.tables import compact_table

#: Key of the damping in the JSON.
JSON_KEY = "damping"
#: Maximum number of rows on the page.
MAX_ROWS = 300
#: Columns of the damping ratios of the model: JSON key and title.
MODEL_RATIOS = {"damping_before": "as declared [%]", "damping_after": "as diagnosed [%]"}


def damping_blocks(result: Diagnosis, context: ReportContext) -> list[Block]:
    """Return what the damping shows, and the ratios of all modes; empty if damping was not measured."""
    damping_result = result.damping
    if not damping_result.measured:
        return []
    stability_blocks: list[Block] = []
    if changes := stability_clause(damping_result):
        stability_blocks = [Paragraph(to_sentence(clean(changes)))]
    elif damping_result.stability:
        stability_blocks = [
            Paragraph("That is the same with \u03c3 halved or doubled, and with priors twice as wide.")
        ]
    blocks: list[Block] = [
        Paragraph(
            f"Verdict on the damping: {damping_result.verdict}. "
            f"{typeset_sentences(to_sentence(damping_result.reason))}"
        ),
        *explanations.cause_blocks(damping_result, context, JSON_KEY),
        *refitted_loss_blocks(damping_result, context),
        *stability_blocks,
        *ratio_error_paragraphs(result),
        *(
            [Listing([typeset_sentences(to_sentence(note)) for note in damping_result.notes])]
            if damping_result.notes
            else []
        ),
    ]
    rows = [(i, row) for i, row in enumerate(result.rows) if row.damping is not None]
    if rows:
        blocks.append(_ratio_table(rows))
    if damping_result.candidates:
        blocks.append(_loss_table(damping_result))
    return blocks


def stability_clause(damping_result: Damping) -> str:
    """Return how the verdict on the damping changes with other errors or priors; empty if it does not."""
    claimed = {name for effect in damping_result.effects for name in effect.members}
    changes_by_outcome: dict[str, list[str]] = {}
    for entry in damping_result.stability:
        if entry.verdict == damping_result.verdict and {*entry.effects} <= claimed:
            continue
        names = joined(entry.effects)
        if entry.verdict == ADEQUATE.word:
            outcome = "no cause is needed"
        elif entry.verdict == EFFECT_FOUND.word and names:
            outcome = f"{names} would be claimed"
        else:
            outcome = f"the verdict is {entry.verdict}{f' ({names})' if names else ''}"
        changes_by_outcome.setdefault(outcome, []).append(CHANGE_TITLES.get(entry.change, entry.change))
    clauses = [f"with {joined(changes, 'or')}, {outcome}" for outcome, changes in changes_by_outcome.items()]
    return "; ".join(clauses)


def refitted_loss_blocks(damping_result: Damping, context: ReportContext) -> list[Paragraph | Facts]:
    """Return the uncertain losses, fitted within their priors."""
    entries = []
    for value in damping_result.refitted:
        value_pointer = pointer(JSON_KEY, "refitted", value.name)
        after = uncertain_cell(
            value.after, value.sigma, value_pointer + pointer("after"), value_pointer + pointer("sigma")
        )
        before = rounded_cell(value.before, 6, value_pointer + pointer("before"))
        words, path = context.meaning(value.name), clean(value.name)
        title = f"{words} ({path})" if words else path
        entries.append((title, [after, unit_cell(value.unit), Cell("instead of"), before]))
    return [Paragraph("Uncertain losses, refitted within their priors:"), Facts(entries)] if entries else []


def ratio_error_paragraphs(result: Diagnosis) -> list[Paragraph]:
    """Return how far the damping ratios of the model are from the measured ones, and with which errors."""
    damping_result = result.damping
    if not damping_result.fitted:
        return []
    error_factors = {
        "as declared": damping_result.before,
        "as diagnosed": damping_result.after,
        "at the held-out poses": damping_result.held_out,
    }
    factor_texts = [
        f"{plain(factor, 3)} {name}" for name, factor in error_factors.items() if factor is not None
    ]
    relative_sigmas = [
        row.sigma_damping_used / row.damping
        for row in result.rows
        if row.damping_used and row.damping and row.sigma_damping_used is not None
    ]
    sigma_clause = (
        f" with a \u03c3 of {100.0 * median(relative_sigmas):.0f} % (median)" if relative_sigmas else ""
    )
    factor_clause = (
        f"; rms factor between model and measurement: {', '.join(factor_texts)}" if factor_texts else ""
    )
    undamped_note = " The model as declared has no damping: it predicts no ratios to compare these with."
    text = f"{plural(damping_result.fitted, 'ratio')} fitted{sigma_clause}{factor_clause}."
    return [Paragraph(text + (undamped_note if damping_result.before is None else ""))]


def _ratio_table(rows: list[tuple[int, Row]]) -> Table:
    """Return every measured ratio beside those of the model."""
    note, table_rows = "", []
    for i, row in rows[:MAX_ROWS]:
        row_pointer = pointer("rows", i)
        measured = three_digit_cell(row.damping, row_pointer + pointer("damping"), scale=100.0)
        if row.damping is not None and row.sigma_damping_used is not None:
            ratio_pointers = row_pointer + pointer("damping"), row_pointer + pointer("sigma_damping_used")
            measured = uncertain_cell(row.damping, row.sigma_damping_used, *ratio_pointers, scale=100.0)
        table_rows.append(
            [
                Cell(shorten(row.pose)),
                Cell(str(row.line), row.line, row_pointer + pointer("line")),
                frequency_cell(row.measured, row_pointer + pointer("frequency_hz")),
                measured,
                three_digit_cell(row.sigma_damping, row_pointer + pointer("sigma_damping"), scale=100.0),
                *(
                    three_digit_cell(getattr(row, key), row_pointer + pointer(key), scale=100.0)
                    for key in MODEL_RATIOS
                ),
                Cell(row.damping_remark or ""),
            ]
        )
    if len(rows) > MAX_ROWS:
        note = (
            f"The table has the first {MAX_ROWS} of {len(rows)} ratios. All are in the output of --json, "
            "under rows."
        )
    columns = [Column("pose", False), Column("line"), Column("f [Hz]"), Column("measured [%]")]
    columns += [Column("stated \u03c3 [%]"), *(Column(title) for title in MODEL_RATIOS.values())]
    columns.append(Column("remark", False))
    caption = (
        "Damping ratios: measured, and those of the model, whose frequencies are the final ones. The \u03c3 of a "
        "measured ratio is the one with which it was compared: the stated one, with at least 10 % for the difference "
        "between tests of one machine, what the shape of its mode leaves open, and a scatter that the verdict allows "
        "for."
    )
    return compact_table(caption, columns, table_rows, note=note)


def _loss_table(damping_result: Damping) -> Table:
    """Return the losses that were tested, and how large each may still be.

    There is no p-value: for a loss alone it differs from that of a loss found along with others.
    """
    rows = []
    for candidate_index, candidate in enumerate(damping_result.candidates):
        name, limit = next(
            (
                (limit_name, limit)
                for limit_name, limit in damping_result.limits.items()
                if limit.candidate == candidate.name
            ),
            ("", None),
        )
        visible = next(iter(candidate.visible_from), None)
        visible_pointer = (
            pointer(JSON_KEY, "candidates", candidate_index, "visible_from", parameter_key(visible), "value")
            if visible
            else ""
        )
        limit_value = None if limit is None else limit.value
        limit_pointer = (
            pointer(JSON_KEY, "limits", name, *(() if limit_value is None else ("value",))) if limit else ""
        )
        rows.append(
            [
                Cell.named(clean(candidate.sentence), clean(candidate.name)),
                Cell(explanations.candidate_outcome(damping_result, candidate.name)),
                rounded_cell(
                    visible.value if visible and candidate.detectable else None,
                    2,
                    visible_pointer if candidate.detectable else "",
                ),
                rounded_cell(limit_value, 2, limit_pointer) if limit else Cell(""),
                Cell(unit_text(visible.unit if visible else limit.unit if limit else "1")),
                Cell("yes" if candidate.detectable else "no"),
            ]
        )
    columns = [Column("loss", False), Column("standing", False), Column("visible from")]
    columns += [Column("limit (95\u00a0%)"), Column("unit", False), Column("detectable", False)]
    caption = (
        "Losses. Visible from: the smallest change that these ratios would probably show (5 \u03c3). Limit: how far "
        f"the value may still be from the declared one at 95 %; {MISSING} where nothing bounds it."
    )
    return compact_table(caption, columns, rows)
