"""The figures of measured modes, with captions for readers and descriptions for those who do not see them."""

from __future__ import annotations

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.pages.plots import differences
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.mac_matrices import mac_matrices, worst_setup
from pkmodes.pages.plots.setup_frequencies import setup_frequencies
from pkmodes.pages.report.blocks import Block, Paragraph, Picture, Section
from pkmodes.pages.report.formatting import plural, shorten


def figure_sections(evidence: PlottedEvidence) -> list[Section]:
    """Return the sections of the figures: mode by mode, pose by pose, and the shapes."""
    first, *further = mode_figures(evidence)
    further += pose_figures(evidence)
    place = evidence.setup_noun
    return [
        Section("modes", "Measurement and model", [first]),
        *([Section("poses", f"{place.capitalize()} by {place}", further)] if further else []),
        Section("shapes", "Mode shapes", shape_figures(evidence)),
    ]


def mode_figures(evidence: PlottedEvidence) -> list[Block]:
    """Return the measured modes beside the model: what differs by mode and by pose, then all frequencies."""
    if not evidence.stages:
        return [Paragraph("The result has no predictions to show.")]
    modes_text = plural(len(evidence.measured), "measured mode")
    poses_text = plural(len(evidence.labels), evidence.setup_noun)
    has_one_stage = len(evidence.stages) == 1
    overview = Picture.from_drawing(
        setup_frequencies(evidence),
        f"Frequencies at each {evidence.setup_noun}",
        f"{modes_text} at {poses_text}, with the modes of the model as lines. {_unmatched_note(evidence)}",
        f"Frequencies at each {evidence.setup_noun}: marks are measured, lines are the modes of the model. A "
        "line without a mark is a mode that was not measured. "
        f"{_band_note(evidence)}{_unmatched_note(evidence)}",
    )
    if not any(stage.paired.any() for stage in evidence.stages):
        return [
            overview,
            Paragraph("No measured mode has a partner in the model, so there are no differences."),
        ]
    blocks: list[Block] = [
        Picture.from_drawing(
            differences.by_mode(evidence),
            "Differences by mode",
            f"Model divided by measurement, minus 1, for each mode of the model. {_rms_by_stage(evidence)}",
            f"Differences by mode: model / measurement \u2212 1. Each mark is one {evidence.setup_noun}, the bar is "
            "their "
            "median. A bar away from 0 is what the model gets wrong everywhere; scatter about it is noise or "
            f"depends "
            f"on the {evidence.setup_noun}.{'' if has_one_stage else ' Both panels have the same scale.'}"
            f"{_marks_note(evidence)}",
        )
    ]
    blocks.append(
        Picture.from_drawing(
            differences.by_setup(evidence),
            f"Differences by {evidence.setup_noun}",
            f"Differences in standard deviations of the measurement at {poses_text}. {_largest_by_stage(evidence)}",
            f"Differences by {evidence.setup_noun}, in standard deviations \u03c3 of the measurement. In the "
            "shaded band, \u00b12 \u03c3, the difference may be "
            f"noise.{'' if has_one_stage else ' The scales of the panels differ.'}",
        )
    )
    return [*blocks, overview]


def pose_figures(evidence: PlottedEvidence) -> list[Block]:
    """Return the residual against the components of the pose; empty if the poses are unknown."""
    figure = differences.against_pose(evidence) if _has_partners(evidence) else None
    if figure is None:
        return []
    names = ", ".join(evidence.components[k] for k in differences.varying_components(evidence))
    return [
        Picture.from_drawing(
            figure,
            "Differences against the pose",
            f"Differences in standard deviations against the pose components {names}. {_largest_by_stage(evidence)}",
            f"Differences against {names}. A slope or a curve means that what is missing depends on the "
            "position; without one, look for a cause that acts everywhere.",
        )
    ]


def shape_figures(evidence: PlottedEvidence) -> list[Block]:
    """Return the MAC matrices, or a sentence where no shapes were measured."""
    figure = mac_matrices(evidence) if _has_partners(evidence) else None
    if figure is None:
        return [Paragraph("No mode shapes were measured, or none belongs to a mode of the model.")]
    mac = evidence.last_stage.predicted.partner_mac
    lowest_mac = f"{np.nanmin(mac):.3f}"
    worst_pose = worst_setup(evidence)
    pose_label = "" if worst_pose is None else shorten(evidence.labels[worst_pose])
    return [
        Picture.from_drawing(
            figure,
            "MAC matrices",
            "Modal assurance criterion of measured shapes and modes of the model. The lowest of a pair is "
            f"{lowest_mac}, at {evidence.setup_noun} {pose_label}.",
            "MAC matrices: 1 is the same shape, 0 a shape with nothing in common. Light cells on the diagonal alone "
            "mean that every measured shape is that of its mode; a light cell beside it, that the measured points "
            "hardly tell the two modes apart, or that they changed places. Rows are the measured modes, numbered as "
            f"their partners. Bottom: the {evidence.setup_noun} with the lowest MAC of a pair, {lowest_mac}.",
        )
    ]


def _band_note(evidence: PlottedEvidence) -> str:
    """Return the explanation of the bands; empty without any."""
    if evidence.frequency_sigma is None or not (evidence.frequency_sigma > 0.0).any():
        return ""
    later_stages_note = (
        " Fitted stages have none: the measurements determine their values better."
        if len(evidence.stages) > 1
        else ""
    )
    return (
        "The bands are one standard deviation on either side of the model as declared, to first order from those "
        f"of the values in the robot file.{later_stages_note} "
    )


def _has_partners(evidence: PlottedEvidence) -> bool:
    return any(stage.paired.any() for stage in evidence.stages)


def _marks_note(evidence: PlottedEvidence) -> str:
    """Return what the marks mean where there is more than one kind."""
    kinds = ["filled dots were fitted"]
    if (evidence.held_out & ~evidence.outlier).any():
        kinds.append("open diamonds are held out")
    if evidence.outlier.any():
        kinds.append("purple crosses were set aside")
    return f" {', '.join(kinds).capitalize()}." if len(kinds) > 1 else ""


def _unmatched_note(evidence: PlottedEvidence) -> str:
    count = int((~evidence.last_stage.paired).sum())
    return (
        f"{plural(count, 'measured mode')} without a partner in the model."
        if count
        else "Every measured mode has a partner."
    )


def _rms_by_stage(evidence: PlottedEvidence) -> str:
    stage_texts = []
    for stage in evidence.stages:
        relative_differences = evidence.difference(stage)[stage.paired & ~evidence.outlier]
        if len(relative_differences):
            stage_texts.append(
                f"{stage.title}: rms {plain(100 * np.sqrt(np.mean(relative_differences**2)), 2)} %"
            )
    return "; ".join(stage_texts)


def _largest_by_stage(evidence: PlottedEvidence) -> str:
    stage_texts = []
    for stage in evidence.stages:
        if stage.paired.any():
            largest = typeset(plain(np.nanmax(np.abs(stage.predicted.normalised_differences)), 2))
            stage_texts.append(f"largest {stage.title}: {largest} standard deviations")
    return "; ".join(stage_texts)
