"""The numbers of a diagnosis: errors of the stages, and values before and after."""

from __future__ import annotations

import numpy as np

from pkmodes.core.support.ordering import listed, sorted_labels
from pkmodes.loop.diagnosis.verdict.findings import NOTICEABLE, Corrected
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, parameter_key
from pkmodes.pages.plots import correlations as dependence
from pkmodes.pages.plots import scores
from pkmodes.pages.report.blocks import Cell, Column, Paragraph, Picture, Table
from pkmodes.pages.report.formatting import (
    clean,
    figures,
    number,
    plural,
    pointer,
    read_in,
    three_digits,
    uncertain_cell,
    unit_cell,
)
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.tables import table

#: What a measured mode without a partner counts as, as in the glossary.
REACH = "a factor of 1.8"


def errors(result: Diagnosis) -> list[Table | Paragraph]:
    """Return the errors of the stages, over fitted and held-out rows."""
    stages, rows = result.errors, []
    for name, (title, error) in stages.items():
        at, strong = ("error", name), name == [*stages][-1]
        held = error.held_out_rms_relative
        rows.append(
            [
                Cell(title, strong=strong),
                percent(error.rms_relative, pointer(*at, "rms_relative"), strong),
                percent(held, pointer(*at, "held_out_rms_relative"), strong),
                three_digits(error.chi2_per_dof, pointer(*at, "chi2_per_dof"), strong=strong),
            ]
        )
    columns = [Column("model", False), Column("rms [%]"), Column("held out [%]")]
    columns.append(Column("chi\u00b2 per dof"))
    if not result.held_out_poses:
        rows, columns = [[*row[:2], row[3]] for row in rows], [*columns[:2], columns[3]]
    caption = "Errors of the model: rms of model / measurement \u2212 1, and chi\u00b2 per degree of freedom."
    blocks: list[Table | Paragraph] = [Table(caption, columns, rows)]
    blocks += _without_partner(result)
    if result.held_out_poses:
        labels = sorted_labels(result.held_out_poses)
        about, why = "Held out of every choice and fit: ", ". The error there is that of a prediction."
        whole, named = (listed(texts, 20) for texts in (labels, list(map(clean, labels))))
        blocks.append(Paragraph(f"{about}{named}{why}", plain=f"{about}{whole}{why}"))
    return blocks


def _without_partner(result: Diagnosis) -> list[Paragraph]:
    """Return how fitted modes without a partner count in chi-square; empty where every one has a partner."""
    fitted = [row for row in result.rows if not (row.held_out or row.outlier)]
    for name, (title, _) in result.errors.items():
        if count := sum(getattr(row, name) is None for row in fitted):
            have, each = ("mode has", "it") if count == 1 else ("modes have", "each")
            stage = title.partition(": ")[2] or title
            return [
                Paragraph(
                    f"{count} fitted {have} no partner in the model ({stage}): {each} counts in chi\u00b2 as a "
                    f"difference by {REACH}, and not in the rms."
                )
            ]
    return []


def percent(relative: float | None, at: str = "", strong: bool = False) -> Cell:
    """Return a relative error in per cent."""
    form = ".3f" if relative is None or abs(relative) < 0.1 else ".1f"
    return number(relative, form, at, scale=100.0, strong=strong)


def fitted_value_tables(result: Diagnosis, setting: ReportSetting) -> list[Table | Paragraph]:
    """Return the fitted values, with what was declared about them."""
    corrected = _corrected(result)
    if not corrected:
        return [Paragraph("No value was uncertain, and none was fitted.")]
    widened = any(value.saved_sigma > NOTICEABLE * value.sigma for value in corrected)
    rows = []
    for value in corrected:  # its numbers are in the JSON under refitted, or with the cause
        before, after, sigma, saved = "", "", "", ""
        role, prior = "fitted", value.prior_sigma
        if any(refitted.name == value.name for refitted in result.refitted):
            role = "uncertain"
            before, after, sigma, saved = (
                pointer("refitted", value.name, name) for name in ("before", "after", "sigma", "saved_sigma")
            )
        for i, effect in enumerate(result.effects):
            if any(parameter.name == value.name for parameter in effect.parameters):
                role, at = "cause", ("effects", i, "parameters", parameter_key(value))
                after, sigma, saved = (pointer(*at, name) for name in ("value", "sigma", "saved_sigma"))
        unit, scale = read_in(value.unit, value.declared, value.value)
        rows.append(
            [
                Cell.named(setting.words(value.name), clean(value.name.removeprefix("effects."))),
                Cell(f"{role}, at a bound" if value.at_bound else role),
                figures(value.declared, 6, before, scale=scale),
                uncertain_cell(value.value, value.saved_sigma, after, saved, scale=scale, fit=value.sigma),
                figures(value.sigma, 2, sigma, scale=scale),
                unit_cell(unit),
                figures(prior, 2, scale=scale),
                number((value.value - value.declared) / prior if prior else None, "+.1f"),
            ]
        )
    columns = [Column("value", False), Column("role", False, page_only=True), Column("before")]
    columns += [
        Column("after"),
        Column("\u03c3 of fit", page_only=not widened),
        Column("unit", False),
        Column("prior \u03c3", page_only=True),
        Column("moved [prior\u00a0\u03c3]", page_only=True),
    ]
    caption = "Fitted values: as declared, and after the fit with their standard deviations."
    if widened:
        caption = (
            "Fitted values: as declared, and after the fit with their standard deviations, which include what a "
            "candidate that these data do not show could have done to the value; beside them those of the fit alone."
        )
    return [table(caption, columns, rows)]


def _corrected(result: Diagnosis) -> list[Corrected]:
    of_losses = {value.name for value in result.damping.refitted}  # the damping says more of them
    return [value for value in result.corrected if value.name not in of_losses]


def pulls(result: Diagnosis, setting: ReportSetting) -> list[Picture]:
    """Return the figure of how far the fit moved each uncertain value; empty if none has a prior."""
    corrected = _corrected(result)
    figure = scores.pulls(corrected, setting.words)
    if figure is None:
        return []
    total = sum(bool(v.prior_sigma) for v in corrected)
    count = plural(total, "value")
    which = f" (the {scores.MOST} that moved most of {total})" if total > scores.MOST else ""
    return [
        Picture.of(
            figure,
            "Movement of the uncertain values",
            f"{count} with a prior, and how far each moved.",
            f"How far the fit moved each uncertain value{which}, in standard deviations of its prior; the bars are "
            "the standard deviations of the table. Beyond 3 the declared value or its sigma is wrong, or the value "
            "makes up for a cause; a bar as wide as the shaded prior means that the data say nothing about it.",
        )
    ]


def correlations(result: Diagnosis) -> list[Picture]:
    """Return the figures of the correlations of the fitted values; empty for fewer than two values."""
    kept, correlation = _corrected(result), np.array(result.correlation)
    if len(correlation) != len(result.corrected):
        return []
    places = [k for k, value in enumerate(result.corrected) if value in kept]
    rates = correlation[np.ix_(places, places)] if places else correlation
    figure, parts = dependence.matrix(kept, rates), dependence.ellipses(kept, rates)
    pairs, drawn = len(dependence.notable(kept, rates)), dependence.drawn_pairs(kept, rates)
    alike = (
        "" if len(drawn) == pairs else "Pairs of one kind, such as two legs, are in the table above alone. "
    )
    if figure is None:
        return []
    shown = f" (the first {dependence.MOST} of {len(kept)})" if len(kept) > dependence.MOST else ""
    strong = (
        f"{plural(pairs, 'pair')} with a correlation of {dependence.NOTABLE:.2f} or more"
        if pairs
        else f"No pair has a correlation of {dependence.NOTABLE:.2f} or more"
    )
    pictures = [
        Picture.of(
            figure,
            "Correlation of the fitted values",
            f"Correlation of each pair of the fitted values. {strong}.",
            f"Correlation of the fitted values{shown}, by the fit and the priors. Near +1 or \u22121 the data "
            "determine a combination of two values far better than either: a better value of one then moves the "
            f"other. {strong}.",
        )
    ]
    if parts is not None:
        which = (
            f" (the {dependence.PAIRS} strongest of {len(drawn)})" if len(drawn) > dependence.PAIRS else ""
        )
        count = min(len(drawn), dependence.PAIRS)
        pictures.append(
            Picture.of(
                parts,
                "Error ellipses",
                f"Ellipses of 68 and 95 % about the fitted values of {plural(count, 'pair')}.",
                f"Error ellipses of pairs with a strong correlation{which}: deviations from the fitted values, in "
                f"per cent of these, or in the unit of a value near 0. {alike}The true pair is within an ellipse "
                "with the probability that it names, if errors are normal and nothing else is missing: the standard "
                "deviations are those of the fit alone. A cross, if there is one, is the declared pair.",
            )
        )
    return pictures
