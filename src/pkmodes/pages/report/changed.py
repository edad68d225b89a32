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
from pkmodes.pages.report.action import action, doubt
from pkmodes.pages.report.beyond import beyond
from pkmodes.pages.report.blocks import Cell, Column, Facts, Paragraph, Section, Summary, Table
from pkmodes.pages.report.formatting import (
    clean,
    hertz,
    label,
    number,
    plural,
    pointer,
    prose,
    sentence,
    three_digits,
)
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.page import page
from pkmodes.pages.report.places import picture
from pkmodes.pages.report.sections import glossary, view_section
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table

if TYPE_CHECKING:
    from pkmodes.loop.diagnosis.verdict.verdicts import Colour

#: Sections that are unfolded when the page opens.
OPEN = ("changes", "causes", "beyond", "place", "errors")
#: Prefix of values that differ from day to day, and the number of standard deviations from which that is reported.
DAY, CLEARLY = "day.", 3.0
#: Most rows in the table of all modes of both states, and of those that changed most, which is unfolded.
MOST, FIRST = 300, 12
#: Colours by whether anything changed.
TONES: dict[bool | None, Colour] = {True: "found", False: "good", None: "plain"}


def change_headline(result: Change, setting: ReportSetting) -> str:
    """Return what changed since the trusted state, as a title."""
    trusted = result.states[0]
    if result.by_state:
        return clean("; ".join(f"{name}: {change.what}" for name, change in result.by_state.items()))
    if result.changed is None:
        return clean(f"The data do not tell whether anything changed since {trusted}")
    if result.changed is False:
        # Such as "all belts are 1.2 % stiffer".
        day = "; ".join(
            reword(f"{parameter.name} from {parameter.before:g} to {parameter.after:g}", *result.states[:2])
            for parameter in result.refitted
            if parameter.name.startswith(DAY) and abs(parameter.after) > CLEARLY * parameter.sigma
        )
        return clean(
            f"Nothing changed since {trusted} beyond the errors of both{f', but {day}' if day else ''}"
        )
    if not result.explained:
        return clean(f"Something changed since {trusted}, and the data do not tell what")
    changed = f"hanged since {trusted}: {_best(result, setting)}"
    return clean(f"Doubtful ({share}): c{changed}" if (share := doubt(result)) else f"C{changed}")


def _best(result: Change, setting: ReportSetting) -> str:
    """Return the best explanation with its size, and how many others act alike."""
    if len(result.effects) > 1:
        return result.what.removeprefix("change ").removeprefix("found: ")
    if result.effects:
        finding, values = result.effects[0], result.corrected
    else:
        assert result.beyond is not None
        assert result.beyond.found is not None
        finding, values = result.beyond.found.finding, result.beyond.found.corrected
    member = finding.member(finding.name)
    sizes = [_size(value, values, setting) for value in finding.alternatives[finding.name]]
    words = sizes[0] if sizes and sizes[0].startswith("the ") else ", ".join([member.words, *sizes])
    if len(sizes) > 1 and finding.alone is not None:
        words = member.words  # it has the size of the one joint that changed
    alternatives = len(finding.members) - 1
    return (
        f"{words}, or {plural(alternatives, 'other')} that {'acts' if alternatives == 1 else 'act'} alike"
        if alternatives
        else words
    )


def _size(value: Value, values: Sequence[Corrected], setting: ReportSetting) -> str:
    """Return the change of a declared value in per cent, or the size of what was not there before."""
    before = next((parameter.declared for parameter in values if parameter.name == value.name), 0.0)
    if before and (words := setting.words(value.name)):
        change = round_to_sigma(100.0 * (value.value / before - 1.0), 100.0 * abs(value.sigma / before))
        return f"the {words}, by {change} %"
    return f"{value.rounded} {value.unit}".removesuffix(" 1")


def changes_summary(result: Change, setting: ReportSetting) -> Summary:
    """Return the header of the page."""
    relative = [change for change, _ in _changes(result) if change is not None]
    rms = (sum(change**2 for change in relative) / len(relative)) ** 0.5 if relative else None
    facts = [
        ("states", Cell(clean(" \u2192 ".join(result.states)), len(result.states))),
        ("modes compared", _count(sum(counterpart is not None for counterpart in result.counterparts))),
        ("without a counterpart", _count(sum(counterpart is None for counterpart in result.counterparts))),
        ("rms change [%]", numbers.percent(rms)),
        ("error of the model in both [%]", numbers.percent(result.model_error, pointer("model_error"))),
    ]
    last = result.after or result.refit or result.before
    term = None if result.beyond is None or result.effects else result.beyond.found
    if term is not None:
        last = term.errors[term.finding.name]
    if last is not None and not result.by_state:
        facts.append(("final chi\u00b2 per degree of freedom", three_digits(last.chi2_per_dof)))
    return Summary(
        subject=setting.title(row.drives for row in result.rows),
        kind="What changed",
        verdict="" if result.by_state or term is not None else result.verdict,
        headline=prose(change_headline(result, setting)),
        reason=prose(sentence(result.reason)),
        tone=AMBIGUOUS.colour if doubt(result) else TONES[result.changed],
        notes=[prose(sentence(note)) for note in result.notes],
        action=None if result.by_state else what_to_do(result, setting),
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
        head=setting.head,
    )


def what_to_do(result: Change, setting: ReportSetting) -> Facts:
    """Return what to inspect, what it does, how sure that is, and what to measure next, in the words of a change."""
    trusted, later = result.states

    def said(cell: Cell) -> Cell:
        return replace(cell, text=reword(cell.text, trusted, later), plain=reword(cell.plain, trusted, later))

    facts = action(result, setting)
    return Facts([(name, [said(cell) for cell in cells]) for name, cells in facts.entries])


def _count(number: int) -> Cell:
    return Cell(str(number), number)


def _changes(result: Change) -> list[tuple[float | None, float | None]]:
    """Return the relative change of each mode, and in standard deviations of the difference."""
    differences: list[tuple[float | None, float | None]] = []
    for row, before in zip(result.rows, result.counterparts, strict=True):
        if before is None:
            differences.append((None, None))
            continue
        change = row.measured / before.measured - 1.0
        differences.append((change, change * row.measured / row.sigma))
    return differences


def changes(result: Change, max_rows: int | None = MOST, where: str = ": --all prints every mode") -> Table:
    """Return the modes of both states side by side, the largest changes in standard deviations first.

    - max_rows: number of rows; None for all
    - where: the end of the sentence on rows that are left out
    """
    differences = _changes(result)
    chosen = sorted(
        range(len(differences)), key=lambda i: (differences[i][1] is None, -abs(differences[i][1] or 0.0))
    )[:max_rows]
    trusted, *later = result.states
    rows = []
    for i in chosen:
        row, before, (relative, sigmas) = result.rows[i], result.counterparts[i], differences[i]
        rows.append(
            [
                label(row.pose),
                number(None if before is None else before.line, ".0f", pointer("rows", i, "trusted_line")),
                hertz(None if before is None else before.measured, pointer("rows", i, "trusted_hz")),
                number(row.line, ".0f", pointer("rows", i, "line")),
                hertz(row.measured, pointer("rows", i, "frequency_hz")),
                number(relative, "+.2f", scale=100.0),
                number(sigmas, "+.1f"),
                number(_explained(row), "+.2f", scale=100.0),
            ]
        )
    columns = [
        Column("pose", numbers=False),
        *[Column("line"), Column("f [Hz]")] * 2,
        Column("[%]"),
        Column("[\u03c3]"),
        Column("[%]"),
    ]
    later_title = later[0] if len(later) == 1 else "later"
    groups = [("", 1), (clean(trusted), 2), (clean(later_title), 2), ("change", 2), ("explained", 1)]
    if all(_explained(row) is None for row in result.rows):
        rows, columns, groups = [row[:-1] for row in rows], columns[:-1], groups[:-1]
    omitted = len(differences) - len(chosen)
    note = f"{plural(omitted, 'mode')} changed less{where}." if omitted else ""
    caption = "Modes of both states: standard deviations are those of the difference."
    return table(caption, columns, rows, groups, note)


def _explained(row: Row) -> float | None:
    """Return the relative change of a frequency that the explanation accounts for; None without one."""
    return None if row.after is None or not row.before else row.after / row.before - 1.0


def change_page(result: Change, evidence: PlottedEvidence, setting: ReportSetting) -> str:
    """Return the page of what changed as HTML."""
    title = "What remains" if result.survivors else "What changed"
    terms = beyond(result, setting)
    where = [] if result.by_state else picture(result, evidence, setting)
    states = [
        Section(
            f"state-{k}",
            clean(f"{name}: {change.what}"),
            [
                Paragraph(prose(sentence(change.reason))),
                *explanations.causes(change, setting),
                *beyond(change, setting),
                changes(change),
            ],
        )
        for k, (name, change) in enumerate(result.by_state.items(), start=1)
    ]
    rows_title = "All measured modes beside the model"
    every = [Section("pairs", "All modes before and after", [changes(result)])]
    if len(result.rows) <= FIRST or states:
        every = []
    first = changes(result, FIRST if every else MOST, ", or have no counterpart: all are in a section below")
    sections = [
        Section("changes", "Before and after, mode by mode", [first]),
        *([Section("causes", title, causes)] if (causes := explanations.causes(result, setting)) else []),
        *([Section("beyond", "One thing at one place", terms)] if terms else []),
        *([Section("place", "Where it is", where)] if where else []),
        Section("errors", "Error before and after", numbers.errors(result)),
        *every,
        *(states or figures.sections(evidence)),
        Section("candidates", "What may have changed", explanations.candidate_blocks(result)),
        Section("values", "Values before and after", numbers.fitted_value_tables(result, setting)),
        *view_section(setting.view),
        *([] if states else [Section("rows", rows_title, [mode_table(result, evidence, setting)])]),
        glossary(diagnosed=True),
        setting.origin(evidence),
    ]
    unfolded = {*OPEN} - ({"errors"} if terms else set())  # which the section on one thing begins with, too
    return page(
        changes_summary(result, setting),
        [replace(section, folded=section.name not in unfolded) for section in sections],
    )
