"""Two measurements compared, in numbers: what changed, and which modes by more than their errors."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.measured.compared import MeasurementsCompared
from pkmodes.report.blocks import Cell, Column, Summary, Table
from pkmodes.report.formatting import NOTHING, number, p_value, plural, pointer, shortened, three_digits
from pkmodes.report.numbers import percent
from pkmodes.report.tables import table

if TYPE_CHECKING:
    from pkmodes.diagnosis.verdict.verdicts import Colour


def summary(result: MeasurementsCompared) -> Summary:
    """Return whether the measurements differ, and by how much."""
    headline, reason, tone = _judged(result)
    pairs = len(result.pairs)
    facts = [
        ("median change [%]", percent(result.median_relative, pointer("median_relative"))),
        ("rms change [%]", percent(result.rms_relative, pointer("rms_relative"))),
        ("chi\u00b2 per pair", three_digits(result.chi2 / pairs if pairs else None)),
        ("p-value", p_value(result.p_value, pointer("p_value"))),
        ("pairs", Cell(str(pairs), pairs)),
        ("poses", Cell(str(result.poses), result.poses, pointer("poses"))),
        ("only in the first", Cell(str(len(result.first_unpaired)), len(result.first_unpaired))),
        ("only in the second", Cell(str(len(result.second_unpaired)), len(result.second_unpaired))),
    ]
    return Summary(
        subject=f"{shortened(result.first)} and {shortened(result.second)}",
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
    )


def _judged(result: MeasurementsCompared) -> tuple[str, str, Colour]:
    """Return what the differences mean."""
    p = result.p_value
    if p is None:
        return "No mode has a partner", "No frequency of one is within 25 % of one of the other.", "bad"
    alone = len(result.first_unpaired) + len(result.second_unpaired)
    others = f"; {plural(alone, 'mode')} without a partner" if alone else ""
    differing = [pair for pair in result.pairs if pair.differs]
    if differing:
        most = max(differing, key=lambda pair: abs(pair.sigmas))
        headline = (
            f"{plural(len(differing), 'mode')} of {len(result.pairs)} changed by more than the errors{others}"
        )
        reason = (
            f"Most clearly that at {most.first:.5g} Hz, {shortened(most.pose)}: {100.0 * most.relative:+.2f} %,"
            f" {abs(most.sigmas):.1f} standard deviations. The stated errors are taken as independent."
        )
        return headline, reason, "open"
    if p <= Criteria().gate.level:
        headline = f"All modes together changed by more than the errors{others}"
        return headline, "No single one did. The stated errors are taken as independent.", "open"
    return (
        f"The changes are within the measurement errors{others}",
        "The stated errors are taken as independent.",
        "good",
    )


def changes(result: MeasurementsCompared, most: int | None) -> list[Table]:
    """Return the pairs, those that changed most in standard deviations first, at most so many; all in their order."""
    order = sorted(range(len(result.pairs)), key=lambda i: -abs(result.pairs[i].sigmas))
    shown = list(range(len(result.pairs))) if most is None else order[:most]
    rows = []
    for i in shown:
        pair = result.pairs[i]
        at = pointer("pairs", i)
        label = pair.pose if pair.pose == pair.second_pose else f"{pair.pose}, {pair.second_pose}"
        rows.append(
            [
                Cell(shortened(label)),
                number(pair.first_line, ".0f", at + pointer("first_line")),
                number(pair.first, ".3f", at + pointer("first")),
                three_digits(pair.first_sigma, at + pointer("first_sigma")),
                number(pair.second_line, ".0f", at + pointer("second_line")),
                number(pair.second, ".3f", at + pointer("second")),
                three_digits(pair.second_sigma, at + pointer("second_sigma")),
                number(pair.relative, "+.2f", at + pointer("relative"), scale=100.0),
                number(pair.sigmas, "+.1f", at + pointer("sigmas")),
                Cell("yes" if pair.differs else NOTHING),
                number(pair.mac, ".3f", at + pointer("mac")),
            ]
        )
    if not rows:
        return []
    of_each = [Column("line"), Column("f [Hz]"), Column("sigma [Hz]")]
    of_change = [Column("[%]"), Column("[\u03c3]"), Column("clear", numbers=False)]
    columns = [Column("pose", numbers=False), *of_each, *of_each, *of_change, Column("MAC")]
    groups = [("", 1), ("first", 3), ("second", 3), ("change", 3), ("", 1)]
    caption = "Modes of both measurements; changes are second minus first."
    if all(pair.mac is None for pair in result.pairs):
        rows, columns, groups = [row[:-1] for row in rows], columns[:-1], groups[:-1]
    left = len(result.pairs) - len(shown)
    note = f"{plural(left, 'pair')} that changed less: --all prints every pair." if left else ""
    return [table(caption, columns, rows, groups, note)]
