"""The report of a comparison: nothing is fitted, so there is no verdict, only whether the differences are noise."""

from __future__ import annotations

from pkmodes.diagnosis.compare import Comparison
from pkmodes.diagnosis.criteria import Criteria
from pkmodes.plots.evidence import Evidence
from pkmodes.report import figures
from pkmodes.report.blocks import Cell, Section, Summary, Tone
from pkmodes.report.formatting import p_value, plural, pointer, prose, three_digits
from pkmodes.report.glossary import glossary
from pkmodes.report.mode_table import mode_table
from pkmodes.report.numbers import percent
from pkmodes.report.origin import view_section
from pkmodes.report.page import page
from pkmodes.report.setting import Setting


def comparison_page(result: Comparison, evidence: Evidence, setting: Setting) -> str:
    """Return the report of a comparison as HTML."""
    where = figures.pose_figures(evidence)
    sections = [
        Section("modes", "Measurement and model", figures.mode_figures(evidence)),
        *([Section("poses", "Differences against the pose", where)] if where else []),
        Section("shapes", "Mode shapes", figures.shape_figures(evidence)),
        *view_section(setting.view),
        Section("rows", "All measured modes", [mode_table(result, evidence, setting)]),
        glossary(diagnosed=False),
        setting.origin(evidence),
    ]
    return page(_summary(result, setting), sections)


def _summary(result: Comparison, setting: Setting) -> Summary:
    headline, reason, tone = _judged(result)
    count = len(result.rows)
    facts = [
        ("rms difference [%]", percent(result.rms_relative, pointer("rms_relative"))),
        ("chi\u00b2 per degree of freedom", three_digits(result.chi2_per_dof, pointer("chi2_per_dof"))),
        ("p-value", p_value(result.p_value, pointer("p_value"))),
        ("measured modes", Cell(str(count), count)),
        ("of them unmatched", Cell(str(len(result.unpaired)), len(result.unpaired), pointer("unpaired"))),
    ]
    return Summary(
        subject=setting.title(row.drives for row in result.rows),
        kind="Comparison",
        headline=headline,
        reason=reason,
        tone=tone,
        notes=[prose(note) for note in result.notes],
        facts=[(name, cell) for name, cell in facts if cell.value is not None],
        head=setting.head,
    )


def _judged(result: Comparison) -> tuple[str, str, Tone]:
    """Return what the differences mean, from their p-value at the level of the diagnosis."""
    p = result.p_value
    if p is None:
        return (
            "No measured mode has a partner",
            "The model has no mode near any of the measured frequencies.",
            "bad",
        )
    unmatched = (
        f" {plural(len(result.unpaired), 'measured mode')} without a partner in the model."
        if result.unpaired
        else ""
    )
    if p > Criteria().gate.level:
        headline = "The differences are within the measurement errors"
        reason = "Nothing was fitted: the declared model predicts the measured modes as well as they were measured."
        return headline, reason + unmatched, "open" if result.unpaired else "good"
    headline = "The differences are larger than the measurement errors"
    reason = (
        "Nothing was fitted. The declared model differs from the measurements by more than their stated errors: "
        "pkmodes diagnose looks for the cause."
    )
    return headline, reason + unmatched, "open"
