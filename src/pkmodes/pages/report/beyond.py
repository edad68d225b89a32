"""Report of a single change at one place, beyond the catalogue: its classes, and the errors before and after."""

from __future__ import annotations

from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.loop.diagnosis.verdict.terms import Beyond
from pkmodes.pages.report.blocks import Cell, Column, Paragraph, Table
from pkmodes.pages.report.formatting import (
    clean,
    p_value,
    pointer,
    prose,
    read_in,
    sentence,
    three_digits,
    uncertain_cell,
    unit,
)
from pkmodes.pages.report.numbers import percent
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table


def beyond(result: Diagnosis, setting: ReportSetting) -> list[Paragraph | Table]:
    """Return what terms explain; empty if none was tried."""
    terms = result.beyond
    if terms is None:
        return []
    blocks: list[Paragraph | Table] = [Paragraph(prose(sentence(terms.reason)), plain=sentence(terms.reason))]
    if terms.classes:
        blocks += [_classes(terms, setting), _errors(result, terms)]
    return blocks


def _classes(terms: Beyond, setting: ReportSetting) -> Table:
    """Return the explanations that remain with their values, a row for each parameter."""
    rows = []
    for k, group in enumerate(terms.classes):
        at = pointer("beyond", "classes", k)
        for i, name in enumerate(group.finding.members):
            member = group.finding.member(name)
            for value in group.finding.alternatives[name]:
                quantity = group.quantity(name, value)
                of_value = at + pointer("members", i, "parameters", quantity)
                read, scale = read_in(value.unit, value.value)
                rows.append(
                    [
                        Cell(str(k + 1), k + 1),
                        Cell.named(clean(member.words), clean(name)),
                        Cell(setting.words(value.name) or clean(quantity)),
                        uncertain_cell(
                            value.value,
                            value.sigma,
                            of_value + pointer("value"),
                            of_value + pointer("sigma"),
                            scale=scale,
                        ),
                        Cell(unit(read)),
                        Cell(prose(f"no: {member.implausible}") if member.implausible else "yes"),
                        p_value(group.finding.p_value, at + pointer("p_value")),
                        three_digits(group.probability, at + pointer("probability")),
                    ]
                )
    columns = [Column("class"), Column("explanation", False), Column("parameter", False), Column("value")]
    columns += [Column("unit", False), Column("plausible", False), Column("p-value"), Column("probability")]
    return table(
        "One thing at one place, beyond the catalogue: what remains.  These data cannot tell the members of a class "
        "from one another; the p-value accounts for all that was tried, and the probability for all that leaves only "
        "noise.",
        columns,
        rows,
    )


def _errors(result: Diagnosis, terms: Beyond) -> Table:
    """Return the errors before, after the refit, with the best of the catalogue, and with each term."""
    titles = {"before": "as declared", "refit": "uncertain values refitted"}
    if isinstance(result, Change):
        titles |= {key: title for key, (title, _) in result.errors.items()}
    stages: list[tuple[str, Error | None, str]] = [
        (titles["before"], result.before, pointer("error", "before")),
        (titles["refit"], result.refit, pointer("error", "refit")),
    ]
    if terms.catalogue is not None:
        name, error = terms.catalogue
        stages.append((f"with the best of the catalogue, {clean(name)}", error, ""))
    for k, group in enumerate(terms.classes):
        for i, name in enumerate(group.finding.members):
            at = pointer("beyond", "classes", k, "members", i, "error")
            stages.append((f"with {clean(group.finding.member(name).words)}", group.errors[name], at))
    rows = [
        [
            Cell(title),
            percent(error.rms_relative, _in(at, "rms_relative")),
            percent(error.held_out_rms_relative, _in(at, "held_out_rms_relative")),
            three_digits(error.chi2_per_dof, _in(at, "chi2_per_dof")),
        ]
        for title, error, at in stages
        if error is not None
    ]
    columns = [Column("model", False), Column("rms [%]"), Column("held out [%]")]
    columns.append(Column("chi\u00b2 per dof"))
    if not result.held_out_poses:
        rows, columns = [[*row[:2], row[3]] for row in rows], [*columns[:2], columns[3]]
    return Table("Errors before, and with what remains.", columns, rows)


def _in(at: str, key: str) -> str:
    return at + pointer(key) if at else ""
