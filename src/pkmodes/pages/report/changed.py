"""What changed between states: the header, the table mode by mode, and the page."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING

from pkmodes.core.base.numbers import round_to_sigma
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.states.words import reword
from pkmodes.loop.diagnosis.verdict.findings import Corrected, Value
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.loop.diagnosis.verdict.verdicts import AMBIGUOUS
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report import explanations, figures, numbers
from pkmodes.pages.report.action import recommended_action
from pkmodes.pages.report.beyond import beyond_blocks
from pkmodes.pages.report.blocks import Cell, Column, Facts, Paragraph, Section, Summary, Table
from pkmodes.pages.report.certainty import claim_condition, doubtful_probability, is_claim_in_doubt
from pkmodes.pages.report.formatting import (
    clean,
    frequency_cell,
    label_cell,
    number_cell,
    plural,
    pointer,
    three_digit_cell,
    to_sentence,
    typeset_sentences,
)
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.page import page
from pkmodes.pages.report.places import place_pictures
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.sections import glossary_section, view_section
from pkmodes.pages.report.tables import compact_table

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour

#: Sections that are unfolded when the page opens.
UNFOLDED_SECTIONS = ("changes", "causes", "beyond", "place", "errors")
#: Prefix of values that differ from day to day, and the number of standard deviations from which that is reported.
DAY_PREFIX, MIN_DAY_SIGMAS = "day.", 3.0
#: Maximum numbers of rows: of the table of all modes, and of the table of the largest changes, which is
#: shown unfolded.
MAX_ROWS, MAX_LARGEST_CHANGES = 300, 12
#: Colours by whether anything changed.
TONE_BY_CHANGE: dict[bool | None, Colour] = {True: "found", False: "good", None: "plain"}


def change_headline(result: Change, context: ReportContext) -> str:
    """Return what changed since the trusted state, as a title."""
    trusted = result.states[0]
    if result.by_state:
        return clean("; ".join(f"{name}: {change.what}" for name, change in result.by_state.items()))
    if result.changed is None:
        return clean(f"The data do not tell whether anything changed since {trusted}")
    if result.changed is False:
        # Such as "all belts are 1.2 % stiffer".
        day_changes = "; ".join(
            reword(f"{parameter.name} from {parameter.before:g} to {parameter.after:g}", *result.states[:2])
            for parameter in result.refitted
            if parameter.name.startswith(DAY_PREFIX)
            and abs(parameter.after) > MIN_DAY_SIGMAS * parameter.sigma
        )
        exception = f", but {day_changes}" if day_changes else ""
        return clean(f"Nothing changed since {trusted} beyond the errors of both{exception}")
    if not result.explained:
        return clean(f"Something changed since {trusted}, and the data do not tell what")
    explanation = _best_explanation(result, context)
    if probability := doubtful_probability(result):
        return clean(f"Doubtful ({probability}): changed since {trusted}: {explanation}")
    condition = f"; {clause}" if (clause := claim_condition(result)) else ""
    return clean(f"Changed since {trusted}: {explanation}{condition}")


def _best_explanation(result: Change, context: ReportContext) -> str:
    """Return the best explanation with its size, and how many others act alike."""
    if len(result.effects) > 1:
        return result.what.removeprefix("change ").removeprefix("found: ")
    if result.effects:
        finding, corrected_values = result.effects[0], result.corrected
    else:
        assert result.beyond is not None
        assert result.beyond.found is not None
        finding, corrected_values = result.beyond.found.finding, result.beyond.found.corrected
    member = finding.member(finding.name)
    sizes = [_size_in_words(value, corrected_values, context) for value in finding.alternatives[finding.name]]
    words = sizes[0] if sizes and sizes[0].startswith("the ") else ", ".join([member.words, *sizes])
    if len(sizes) > 1 and finding.alone is not None:
        words = member.words  # the words already state the size for the joint that changed
    alternatives = len(finding.members) - 1
    if not alternatives:
        return words
    others = "one other change that acts" if alternatives == 1 else f"{alternatives} other changes that act"
    return f"{words}, or {others} alike"


def _size_in_words(value: Value, corrected_values: Sequence[Corrected], context: ReportContext) -> str:
    """Return the change of a declared value in per cent, or the size of what was not there before."""
    before = next((parameter.declared for parameter in corrected_values if parameter.name == value.name), 0.0)
    if before and (words := context.meaning(value.name)):
        change = round_to_sigma(100.0 * (value.value / before - 1.0), 100.0 * abs(value.sigma / before))
        return f"the {words}, by {change} %"
    return f"{value.rounded} {value.unit}".removesuffix(" 1")


def change_summary(result: Change, context: ReportContext) -> Summary:
    """Return the header of the page."""
    relative = [change for change, _ in _relative_changes(result) if change is not None]
    rms = (sum(change**2 for change in relative) / len(relative)) ** 0.5 if relative else None
    facts = [
        ("states", Cell(clean(" \u2192 ".join(result.states)), len(result.states))),
        ("modes compared", _count_cell(sum(counterpart is not None for counterpart in result.counterparts))),
        (
            "without a counterpart",
            _count_cell(sum(counterpart is None for counterpart in result.counterparts)),
        ),
        ("rms change [%]", numbers.percent_cell(rms)),
        (
            "model error common to both states [%]",
            numbers.percent_cell(result.model_error, pointer("model_error")),
        ),
    ]
    last_error = result.after or result.refit or result.before
    found_term = None if result.beyond is None or result.effects else result.beyond.found
    if found_term is not None:
        last_error = found_term.errors[found_term.finding.name]
    if last_error is not None and not result.by_state:
        chi2 = three_digit_cell(last_error.chi2_per_dof)
        facts.append(("final chi\u00b2 per degree of freedom of all fitted modes", chi2))
    return Summary(
        subject=context.title(row.drives for row in result.rows),
        kind="What changed",
        verdict="" if result.by_state or found_term is not None else result.verdict,
        headline=typeset_sentences(change_headline(result, context)),
        reason=typeset_sentences(to_sentence(result.reason)),
        tone=AMBIGUOUS.colour if is_claim_in_doubt(result) else TONE_BY_CHANGE[result.changed],
        notes=[typeset_sentences(to_sentence(note)) for note in result.notes],
        action=None if result.by_state else action_after_change(result, context),
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
        head=context.head,
    )


def action_after_change(result: Change, context: ReportContext) -> Facts:
    """Return the recommended action, worded for a change between two states.

    What to inspect, its effect, how certain that is, and what to measure next.
    """
    trusted, later = result.states

    def reword_cell(cell: Cell) -> Cell:
        return replace(
            cell, text=reword(cell.text, trusted, later), plain_text=reword(cell.plain_text, trusted, later)
        )

    facts = recommended_action(result, context)
    return Facts([(name, [reword_cell(cell) for cell in cells]) for name, cells in facts.entries])


def _count_cell(count: int) -> Cell:
    return Cell(str(count), count)


def _relative_changes(result: Change) -> list[tuple[float | None, float | None]]:
    """Return the relative change of each mode, and in standard deviations of the difference."""
    differences: list[tuple[float | None, float | None]] = []
    for row, counterpart in zip(result.rows, result.counterparts, strict=True):
        if counterpart is None:
            differences.append((None, None))
            continue
        change = row.measured / counterpart.measured - 1.0
        differences.append((change, change * row.measured / row.sigma))
    return differences


def mode_changes_table(
    result: Change, max_rows: int | None = MAX_ROWS, omission_remark: str = ": --all prints every mode"
) -> Table:
    """Return the modes of both states side by side, the largest changes in standard deviations first.

    - max_rows: number of rows; None for all
    - omission_remark: end of the sentence on modes that are left out
    """
    differences = _relative_changes(result)
    row_indices = sorted(
        range(len(differences)), key=lambda i: (differences[i][1] is None, -abs(differences[i][1] or 0.0))
    )[:max_rows]
    trusted, *later = result.states
    rows = []
    for i in row_indices:
        row, counterpart, (relative, sigmas) = result.rows[i], result.counterparts[i], differences[i]
        rows.append(
            [
                label_cell(row.pose),
                number_cell(
                    None if counterpart is None else counterpart.line,
                    ".0f",
                    pointer("rows", i, "trusted_line"),
                ),
                frequency_cell(
                    None if counterpart is None else counterpart.measured, pointer("rows", i, "trusted_hz")
                ),
                number_cell(row.line, ".0f", pointer("rows", i, "line")),
                frequency_cell(row.measured, pointer("rows", i, "frequency_hz")),
                number_cell(relative, "+.2f", scale=100.0),
                number_cell(sigmas, "+.1f"),
                number_cell(_explained_change(row), "+.2f", scale=100.0),
            ]
        )
    columns = [
        Column("pose", numeric=False),
        *[Column("line"), Column("f [Hz]")] * 2,
        Column("[%]"),
        Column("[\u03c3]"),
        Column("[%]"),
    ]
    later_title = later[0] if len(later) == 1 else "later"
    groups = [("", 1), (clean(trusted), 2), (clean(later_title), 2), ("change", 2), ("explained", 1)]
    if all(_explained_change(row) is None for row in result.rows):
        rows, columns, groups = [row[:-1] for row in rows], columns[:-1], groups[:-1]
    omitted = len(differences) - len(row_indices)
    note = f"{plural(omitted, 'mode')} changed less{omission_remark}." if omitted else ""
    caption = "Modes of both states: standard deviations are those of the difference."
    return compact_table(caption, columns, rows, groups, note)


def _explained_change(row: Row) -> float | None:
    """Return the relative change of a frequency that the explanation accounts for; None without one."""
    return None if row.after is None or not row.before else row.after / row.before - 1.0


def change_page(result: Change, evidence: PlottedEvidence, context: ReportContext) -> str:
    """Return the page of what changed as HTML."""
    title = "What remains" if result.survivors else "What changed"
    place_blocks = [] if result.by_state else place_pictures(result, evidence, context)
    state_sections = [
        Section(
            f"state-{k}",
            clean(f"{name}: {change.what}"),
            [
                Paragraph(typeset_sentences(to_sentence(change.reason))),
                *explanations.cause_blocks(change, context),
                *beyond_blocks(change, context),
                mode_changes_table(change),
            ],
        )
        for k, (name, change) in enumerate(result.by_state.items(), start=1)
    ]
    rows_title = "All measured modes beside the model"
    term_blocks = beyond_blocks(result, context)
    largest_changes, all_changes = mode_changes_table(result), list[Section]()
    if len(result.rows) > MAX_LARGEST_CHANGES and not state_sections:
        remark = ", or have no counterpart: all are in a section below"
        largest_changes = mode_changes_table(result, MAX_LARGEST_CHANGES, remark)
        all_changes = [Section("pairs", "All modes before and after", [mode_changes_table(result)])]
    sections = [
        Section("changes", "Before and after, mode by mode", [largest_changes]),
        *(
            [Section("causes", title, causes)]
            if (causes := explanations.cause_blocks(result, context))
            else []
        ),
        *([Section("beyond", "One thing at one place", term_blocks)] if term_blocks else []),
        *([Section("place", "Where it is", place_blocks)] if place_blocks else []),
        Section("errors", "Error before and after", numbers.error_blocks(result)),
        *all_changes,
        *(state_sections or figures.figure_sections(evidence)),
        Section("candidates", "What may have changed", explanations.candidate_blocks(result)),
        Section("values", "Values before and after", numbers.fitted_value_tables(result, context)),
        *view_section(context.view),
        *([] if state_sections else [Section("rows", rows_title, [mode_table(result, evidence, context)])]),
        glossary_section(is_diagnosis=True),
        context.origin(evidence),
    ]
    # The section 'beyond' begins with the same errors, so 'errors' stays folded.
    unfolded_sections = {*UNFOLDED_SECTIONS} - ({"errors"} if term_blocks else set())
    return page(
        change_summary(result, context),
        [replace(section, folded=section.html_id not in unfolded_sections) for section in sections],
    )
