"""The numbers of a diagnosis: errors of the stages, and values before and after."""

from __future__ import annotations

import numpy as np

from pkmodes.core.support.ordering import listed, sorted_labels
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.findings import MIN_NOTICEABLE_RATIO, Corrected
from pkmodes.loop.diagnosis.verdict.result import Diagnosis, parameter_key
from pkmodes.loop.diagnosis.verdict.rows import Error
from pkmodes.pages.plots import correlations as dependence
from pkmodes.pages.plots import scores
from pkmodes.pages.plots.evidence import CHANGED, WITH_TERM
from pkmodes.pages.report.blocks import Cell, Column, Paragraph, Picture, Table
from pkmodes.pages.report.certainty import claimed_term_class
from pkmodes.pages.report.formatting import (
    clean,
    display_unit,
    number_cell,
    plural,
    pointer,
    rounded_cell,
    three_digit_cell,
    uncertain_cell,
    unit_cell,
)
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.tables import compact_table
from pkmodes.pages.report.unmatched import counting_in_words


def error_blocks(result: Diagnosis) -> list[Table | Paragraph]:
    """Return the errors of the stages, over fitted and held-out rows."""
    stages = [(title, error, pointer("error", name)) for name, (title, error) in result.errors.items()]
    if (found := error_with_term(result)) is not None:
        title = CHANGED if isinstance(result, Change) else f"after: {WITH_TERM} beyond the catalogue"
        stages.append((title, *found))
    rows = []
    for title, error, error_pointer in stages:
        is_last, held_out_rms = error is stages[-1][1], error.held_out_rms_relative
        rows.append(
            [
                Cell(title, strong=is_last),
                percent_cell(error.rms_relative, error_pointer + pointer("rms_relative"), is_last),
                percent_cell(held_out_rms, error_pointer + pointer("held_out_rms_relative"), is_last),
                three_digit_cell(error.chi2_per_dof, error_pointer + pointer("chi2_per_dof"), strong=is_last),
            ]
        )
    columns = [Column("model", False), Column("rms [%]"), Column("held out [%]")]
    columns.append(Column("chi\u00b2 per dof"))
    if not result.held_out_poses:
        rows, columns = [[*row[:2], row[3]] for row in rows], [*columns[:2], columns[3]]
    caption = (
        "Errors of the model: rms of model / measurement \u2212 1 of the modes that have a partner, and chi\u00b2 "
        "per degree of freedom of all fitted modes."
    )
    blocks: list[Table | Paragraph] = [Table(caption, columns, rows)]
    blocks += _unpaired_paragraphs(result)
    if result.held_out_poses:
        labels = sorted_labels(result.held_out_poses)
        intro, ending = "Held out of every choice and fit: ", ". The error there is that of a prediction."
        full_labels, shown_labels = (listed(texts, 20) for texts in (labels, list(map(clean, labels))))
        blocks.append(Paragraph(f"{intro}{shown_labels}{ending}", plain_text=f"{intro}{full_labels}{ending}"))
    return blocks


def error_with_term(result: Diagnosis) -> tuple[Error, str] | None:
    """Return the errors with what was found beyond the catalogue, and their place in the JSON; None without it."""
    term_class = claimed_term_class(result)
    if term_class is None:
        return None
    name = term_class.finding.name
    member_index = [*term_class.finding.members].index(name)
    return term_class.errors[name], pointer("beyond", "classes", 0, "members", member_index, "error")


def _unpaired_paragraphs(result: Diagnosis) -> list[Paragraph]:
    """Return how fitted modes without a partner count in chi-square; empty where every one has a partner."""
    is_fitted = np.array([not (row.held_out or row.outlier) for row in result.rows])
    for name, (title, _) in result.errors.items():
        is_unmatched = is_fitted & [getattr(row, name) is None for row in result.rows]
        if is_unmatched.any():
            predicted = None if result.stages is None else getattr(result.stages, name)
            nearest = (
                [row.nearest is not None for row in result.rows]
                if predicted is None
                else np.isfinite(predicted.nearest_frequency)
            )
            counts = int(is_unmatched.sum()), int((is_unmatched & nearest).sum())
            return [Paragraph(counting_in_words(*counts, title.partition(": ")[2] or title))]
    return []


def percent_cell(relative: float | None, json_pointer: str = "", strong: bool = False) -> Cell:
    """Return a relative error in per cent."""
    form = ".3f" if relative is None or abs(relative) < 0.1 else ".1f"
    return number_cell(relative, form, json_pointer, scale=100.0, strong=strong)


def fitted_value_tables(result: Diagnosis, context: ReportContext) -> list[Table | Paragraph]:
    """Return the fitted values, with what was declared about them."""
    corrected = _corrected_values(result)
    if not corrected:
        return [Paragraph("No value was uncertain, and none was fitted.")]
    term_class = claimed_term_class(result)
    term_values = set() if term_class is None else {value.name for value in term_class.finding.parameters}
    has_widened = any(value.saved_sigma > MIN_NOTICEABLE_RATIO * value.sigma for value in corrected)
    rows = []
    for value in corrected:  # its numbers are in the JSON under refitted, or with the cause
        before, after, sigma, saved = "", "", "", ""
        role, prior = "fitted", value.prior_sigma
        if any(refitted.name == value.name for refitted in result.refitted):
            role = "uncertain"
            before, after, sigma, saved = (
                pointer("refitted", value.name, key) for key in ("before", "after", "sigma", "saved_sigma")
            )
        for i, effect in enumerate(result.effects):
            if any(parameter.name == value.name for parameter in effect.parameters):
                role, cause_keys = "cause", ("effects", i, "parameters", parameter_key(value))
                after, sigma, saved = (pointer(*cause_keys, key) for key in ("value", "sigma", "saved_sigma"))
        if term_class is not None:  # whose fit gives these values; the JSON has those of the fit without it
            after, sigma, saved = "", "", ""
            role = "cause" if value.name in term_values else role
        unit, scale = display_unit(value.unit, value.declared, value.value)
        rows.append(
            [
                Cell.named(context.meaning(value.name), clean(value.name.removeprefix("effects."))),
                Cell(f"{role}, at a bound" if value.at_bound else role),
                rounded_cell(value.declared, 6, before, scale=scale),
                uncertain_cell(
                    value.value, value.saved_sigma, after, saved, scale=scale, fit_sigma=value.sigma
                ),
                rounded_cell(value.sigma, 2, sigma, scale=scale),
                unit_cell(unit),
                rounded_cell(prior, 2, scale=scale),
                number_cell((value.value - value.declared) / prior if prior else None, "+.1f"),
            ]
        )
    columns = [Column("value", False), Column("role", False, page_only=True), Column("before")]
    columns += [
        Column("after"),
        Column("\u03c3 of fit", page_only=not has_widened),
        Column("unit", False),
        Column("prior \u03c3", page_only=True),
        Column("moved [prior\u00a0\u03c3]", page_only=True),
    ]
    caption = "Fitted values: as declared, and after the fit with their standard deviations."
    if has_widened:
        caption = (
            "Fitted values: as declared, and after the fit with their standard deviations, which allow for "
            "candidates that these data do not show; beside them those of the fit alone."
        )
    return [compact_table(caption, columns, rows)]


def _corrected_values(result: Diagnosis) -> list[Corrected]:
    """Return the values of the last fit: with what was found beyond the catalogue if that is the cause."""
    if (term_class := claimed_term_class(result)) is not None:
        return [*term_class.corrected]
    loss_names = {value.name for value in result.damping.refitted}  # the damping says more of them
    return [value for value in result.corrected if value.name not in loss_names]


def pull_pictures(result: Diagnosis, context: ReportContext) -> list[Picture]:
    """Return the figure of how far the fit moved each uncertain value; empty if none has a prior."""
    corrected = _corrected_values(result)
    figure = scores.shifts_from_prior(corrected, context.meaning)
    if figure is None:
        return []
    total = sum(bool(value.prior_sigma) for value in corrected)
    values_text = plural(total, "value")
    selection_note = f" (the {scores.MAX_ROWS} that moved most of {total})" if total > scores.MAX_ROWS else ""
    return [
        Picture.from_drawing(
            figure,
            "Movement of the uncertain values",
            f"{values_text} with a prior, and how far each moved.",
            f"How far the fit moved each uncertain value{selection_note}, in standard deviations of its prior; the "
            "bars are the standard deviations of the table. Beyond 3 the declared value or its sigma is wrong, or "
            "the value makes up for a cause; a bar as wide as the shaded prior means that the data say nothing "
            "about it, and a wider one that something these data do not show may have moved it.",
        )
    ]


def correlation_pictures(result: Diagnosis) -> list[Picture]:
    """Return the figures of the correlations of the fitted values; empty for fewer than two values."""
    values, correlation = _corrected_values(result), np.array(result.correlation)
    if len(correlation) != len(result.corrected) or claimed_term_class(result) is not None:
        return []  # a fit with a term keeps none
    indices = [k for k, corrected_value in enumerate(result.corrected) if corrected_value in values]
    matrix = correlation[np.ix_(indices, indices)] if indices else correlation
    figure, ellipses = (
        dependence.correlation_matrix(values, matrix),
        dependence.error_ellipses(values, matrix),
    )
    pair_count, drawn_pairs = (
        len(dependence.notable_pairs(values, matrix)),
        dependence.drawn_pairs(values, matrix),
    )
    same_kind_note = (
        ""
        if len(drawn_pairs) == pair_count
        else "Pairs of one kind, such as two legs, are in the table above alone. "
    )
    if figure is None:
        return []
    selection_note = (
        f" (the first {dependence.MAX_VALUES} of {len(values)})"
        if len(values) > dependence.MAX_VALUES
        else ""
    )
    pairs_text = (
        f"{plural(pair_count, 'pair')} with a correlation of {dependence.NOTABLE_CORRELATION:.2f} or more"
        if pair_count
        else f"No pair has a correlation of {dependence.NOTABLE_CORRELATION:.2f} or more"
    )
    pictures = [
        Picture.from_drawing(
            figure,
            "Correlation of the fitted values",
            f"Correlation of each pair of the fitted values. {pairs_text}.",
            f"Correlation of the fitted values{selection_note}, by the fit and the priors. Near +1 or \u22121 "
            "the data determine a combination of two values far better than either: a better value of one "
            f"then moves the other. {pairs_text}.",
        )
    ]
    if ellipses is not None:
        ellipses_note = (
            f" (the {dependence.MAX_PAIRS} strongest of {len(drawn_pairs)})"
            if len(drawn_pairs) > dependence.MAX_PAIRS
            else ""
        )
        count = min(len(drawn_pairs), dependence.MAX_PAIRS)
        pictures.append(
            Picture.from_drawing(
                ellipses,
                "Error ellipses",
                f"Ellipses of 68 and 95 % about the fitted values of {plural(count, 'pair')}.",
                f"Error ellipses of pairs with a strong correlation{ellipses_note}: deviations from the fitted "
                f"values, in per cent of these, or in the unit of a value near 0. {same_kind_note}The true pair is "
                "within an ellipse with the probability that it names, if errors are normal and nothing else is "
                "missing: the standard deviations are those of the fit alone. A cross, if there is one, is the "
                "declared pair.",
            )
        )
    return pictures
