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
    NOTHING,
    clean,
    figures,
    hertz,
    plural,
    pointer,
    prose,
    sentence,
    shortened,
    three_digits,
    uncertain_cell,
    unit,
    unit_cell,
)
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.stability import CHANGES
from pkmodes.pages.report.tables import table

#: Key of the damping in the JSON.
TOP = "damping"
#: Most rows on the page.
MOST = 300
#: Columns of the damping ratios of the model: JSON key and title.
RATIOS = {"damping_before": "as declared [%]", "damping_after": "as diagnosed [%]"}


def damping(result: Diagnosis, setting: ReportSetting) -> list[Block]:
    """Return what the damping shows, and the ratios of all modes; empty if damping was not measured."""
    damping_result = result.damping
    if not damping_result.measured:
        return []
    stability: list[Block] = []
    if changes := with_other_errors(damping_result):
        stability = [Paragraph(sentence(clean(changes)))]
    elif damping_result.stability:
        stability = [
            Paragraph("That is the same with \u03c3 halved or doubled, and with priors twice as wide.")
        ]
    blocks: list[Block] = [
        Paragraph(
            f"Verdict on the damping: {damping_result.verdict}. {prose(sentence(damping_result.reason))}"
        ),
        *explanations.causes(damping_result, setting, TOP),
        *refitted(damping_result, setting),
        *stability,
        *factors(result),
        *(
            [Listing([prose(sentence(note)) for note in damping_result.notes])]
            if damping_result.notes
            else []
        ),
    ]
    rows = [(i, row) for i, row in enumerate(result.rows) if row.damping is not None]
    if rows:
        blocks.append(_ratios(rows))
    if damping_result.candidates:
        blocks.append(_candidates(damping_result))
    return blocks


def with_other_errors(damping_result: Damping) -> str:
    """Return how the verdict on the damping changes with other errors or priors; empty if it does not."""
    claimed = {name for effect in damping_result.effects for name in effect.members}
    outcomes: dict[str, list[str]] = {}
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
        outcomes.setdefault(outcome, []).append(CHANGES.get(entry.change, entry.change))
    return "; ".join(f"with {joined(changes, 'or')}, {outcome}" for outcome, changes in outcomes.items())


def refitted(damping_result: Damping, setting: ReportSetting) -> list[Paragraph | Facts]:
    """Return the uncertain losses, fitted within their priors."""
    entries = []
    for value in damping_result.refitted:
        at = pointer(TOP, "refitted", value.name)
        after = uncertain_cell(value.after, value.sigma, at + pointer("after"), at + pointer("sigma"))
        before = figures(value.before, 6, at + pointer("before"))
        words, path = setting.words(value.name), clean(value.name)
        title = f"{words} ({path})" if words else path
        entries.append((title, [after, unit_cell(value.unit), Cell("instead of"), before]))
    return [Paragraph("Uncertain losses, refitted within their priors:"), Facts(entries)] if entries else []


def factors(result: Diagnosis) -> list[Paragraph]:
    """Return how far the damping ratios of the model are from the measured ones, and with which errors."""
    damping_result = result.damping
    if not damping_result.fitted:
        return []
    named = {
        "as declared": damping_result.before,
        "as diagnosed": damping_result.after,
        "at the held-out poses": damping_result.held_out,
    }
    parts = [f"{plain(factor, 3)} {name}" for name, factor in named.items() if factor is not None]
    errors = [
        row.sigma_damping_used / row.damping
        for row in result.rows
        if row.damping_used and row.damping and row.sigma_damping_used is not None
    ]
    spread = f" with a \u03c3 of {100.0 * median(errors):.0f} % (median)" if errors else ""
    compared = f"; rms factor between model and measurement: {', '.join(parts)}" if parts else ""
    undamped = " The model as declared has no damping: it predicts no ratios to compare these with."
    text = f"{plural(damping_result.fitted, 'ratio')} fitted{spread}{compared}."
    return [Paragraph(text + (undamped if damping_result.before is None else ""))]


def _ratios(rows: list[tuple[int, Row]]) -> Table:
    """Return every measured ratio beside those of the model."""
    note, cells = "", []
    for i, row in rows[:MOST]:
        at = pointer("rows", i)
        measured = three_digits(row.damping, at + pointer("damping"), scale=100.0)
        if row.damping is not None and row.sigma_damping_used is not None:
            places = at + pointer("damping"), at + pointer("sigma_damping_used")
            measured = uncertain_cell(row.damping, row.sigma_damping_used, *places, scale=100.0)
        cells.append(
            [
                Cell(shortened(row.pose)),
                Cell(str(row.line), row.line, at + pointer("line")),
                hertz(row.measured, at + pointer("frequency_hz")),
                measured,
                three_digits(row.sigma_damping, at + pointer("sigma_damping"), scale=100.0),
                *(
                    three_digits(getattr(row, parameter_key), at + pointer(parameter_key), scale=100.0)
                    for parameter_key in RATIOS
                ),
                Cell(row.damping_remark or ""),
            ]
        )
    if len(rows) > MOST:
        note = f"The table has the first {MOST} of {len(rows)} ratios. All are in the output of --json, under rows."
    columns = [Column("pose", False), Column("line"), Column("f [Hz]"), Column("measured [%]")]
    columns += [Column("stated \u03c3 [%]"), *(Column(title) for title in RATIOS.values())]
    columns.append(Column("remark", False))
    caption = (
        "Damping ratios: measured, and those of the model, whose frequencies are the final ones. The \u03c3 of a "
        "measured ratio is the one with which it was compared: the stated one, with at least 10 % for the difference "
        "between tests of one machine, what the shape of its mode leaves open, and a scatter that the verdict allows "
        "for."
    )
    return table(caption, columns, cells, note=note)


def _candidates(damping_result: Damping) -> Table:
    """Return the losses that were tested, and how large each may still be.

    There is no p-value: for a loss alone it differs from that of a loss found along with others.
    """
    rows = []
    for k, candidate in enumerate(damping_result.candidates):
        name, limit = next(
            ((n, limit) for n, limit in damping_result.limits.items() if limit.candidate == candidate.name),
            ("", None),
        )
        visible = next(iter(candidate.visible_from), None)
        of_visible = (
            pointer(TOP, "candidates", k, "visible_from", parameter_key(visible), "value") if visible else ""
        )
        size = None if limit is None else limit.value
        of_limit = pointer(TOP, "limits", name, *(() if size is None else ("value",))) if limit else ""
        rows.append(
            [
                Cell.named(clean(candidate.sentence), clean(candidate.name)),
                Cell(explanations.standing(damping_result, candidate.name)),
                figures(
                    visible.value if visible and candidate.detectable else None,
                    2,
                    of_visible if candidate.detectable else "",
                ),
                figures(size, 2, of_limit) if limit else Cell(""),
                Cell(unit(visible.unit if visible else limit.unit if limit else "1")),
                Cell("yes" if candidate.detectable else "no"),
            ]
        )
    columns = [Column("loss", False), Column("standing", False), Column("visible from")]
    columns += [Column("limit (95\u00a0%)"), Column("unit", False), Column("detectable", False)]
    caption = (
        "Losses. Visible from: the smallest change that these ratios would probably show (5 \u03c3). Limit: how far "
        f"the value may still be from the declared one at 95 %; {NOTHING} where nothing bounds it."
    )
    return table(caption, columns, rows)
