"""Report of a single change at one place, beyond the catalogue: its classes, and the errors before and after."""

from __future__ import annotations

from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.terms import Beyond
from pkmodes.pages.report.blocks import Cell, Column, Paragraph, Table
from pkmodes.pages.report.formatting import (
    clean,
    display_unit,
    p_value_cell,
    pointer,
    three_digit_cell,
    to_sentence,
    typeset_sentences,
    uncertain_cell,
    unit_text,
)
from pkmodes.pages.report.numbers import percent_cell
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.tables import compact_table


def beyond_blocks(result: Diagnosis, context: ReportContext) -> list[Paragraph | Table]:
    """Return what terms explain; empty if none was tried."""
    terms = result.beyond
    if terms is None:
        return []
    blocks: list[Paragraph | Table] = [
        Paragraph(typeset_sentences(to_sentence(terms.reason)), plain_text=to_sentence(terms.reason))
    ]
    if terms.classes:
        blocks += [_class_table(terms, context), _error_table(result, terms)]
    return blocks


def _class_table(terms: Beyond, context: ReportContext) -> Table:
    """Return the explanations that remain with their values, a row for each parameter."""
    rows = []
    for class_index, term_class in enumerate(terms.classes):
        class_pointer = pointer("beyond", "classes", class_index)
        for member_index, name in enumerate(term_class.finding.members):
            member = term_class.finding.member(name)
            for value in term_class.finding.alternatives[name]:
                quantity = term_class.quantity(name, value)
                value_pointer = class_pointer + pointer("members", member_index, "parameters", quantity)
                shown_unit, scale = display_unit(value.unit, value.value)
                rows.append(
                    [
                        Cell(str(class_index + 1), class_index + 1),
                        Cell.named(clean(member.words), clean(name)),
                        Cell(context.meaning(value.name) or clean(quantity)),
                        uncertain_cell(
                            value.value,
                            value.sigma,
                            value_pointer + pointer("value"),
                            value_pointer + pointer("sigma"),
                            scale=scale,
                        ),
                        Cell(unit_text(shown_unit)),
                        Cell(typeset_sentences(f"no: {member.implausible}") if member.implausible else "yes"),
                        p_value_cell(term_class.finding.p_value, class_pointer + pointer("p_value")),
                        three_digit_cell(term_class.probability, class_pointer + pointer("probability")),
                    ]
                )
    columns = [Column("class"), Column("explanation", False), Column("parameter", False), Column("value")]
    columns += [Column("unit", False), Column("plausible", False), Column("p-value"), Column("probability")]
    return compact_table(
        "One thing at one place, beyond the catalogue: what remains.  These data cannot tell the members of a class "
        "from one another; the p-value accounts for all that was tried, and the probability for all that leaves only "
        "noise.",
        columns,
        rows,
    )


def _error_table(result: Diagnosis, terms: Beyond) -> Table:
    """Return the errors with the best of the catalogue, and with each term."""
    stages: list[tuple[str, Error | None, str]] = []
    if terms.catalogue is not None:
        name, error = terms.catalogue
        stages.append((f"with the best of the catalogue, {clean(name)}", error, ""))
    for class_index, term_class in enumerate(terms.classes):
        for member_index, name in enumerate(term_class.finding.members):
            error_pointer = pointer("beyond", "classes", class_index, "members", member_index, "error")
            stages.append(
                (
                    f"with {clean(term_class.finding.member(name).words)}",
                    term_class.errors[name],
                    error_pointer,
                )
            )
    rows = [
        [
            Cell(title),
            percent_cell(error.rms_relative, _sub_pointer(error_pointer, "rms_relative")),
            percent_cell(error.held_out_rms_relative, _sub_pointer(error_pointer, "held_out_rms_relative")),
            three_digit_cell(error.chi2_per_dof, _sub_pointer(error_pointer, "chi2_per_dof")),
        ]
        for title, error, error_pointer in stages
        if error is not None
    ]
    columns = [Column("model", False), Column("rms [%]"), Column("held out [%]")]
    columns.append(Column("chi\u00b2 per dof"))
    if not result.held_out_poses:
        rows, columns = [[*row[:2], row[3]] for row in rows], [*columns[:2], columns[3]]
    return Table("Errors of the model with each explanation.", columns, rows)


def _sub_pointer(parent: str, key: str) -> str:
    return parent + pointer(key) if parent else ""
