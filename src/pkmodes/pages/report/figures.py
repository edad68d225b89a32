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
from pkmodes.pages.report.formatting import plural, shortened


def sections(evidence: PlottedEvidence) -> list[Section]:
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
    count = plural(len(evidence.measured), "measured mode")
    where = plural(len(evidence.labels), evidence.setup_noun)
    single = len(evidence.stages) == 1
    overview = Picture.of(
        setup_frequencies(evidence),
        f"Frequencies at each {evidence.setup_noun}",
        f"{count} at {where}, with the modes of the model as lines. {_unmatched(evidence)}",
        f"Frequencies at each {evidence.setup_noun}: marks are measured, lines are the modes of the model. A line without a mark is a mode that was not measured. {_spread(evidence)}{_unmatched(evidence)}",
    )
    if not any(stage.paired.any() for stage in evidence.stages):
        return [
            overview,
            Paragraph("No measured mode has a partner in the model, so there are no differences."),
        ]
    blocks: list[Block] = [
        Picture.of(
            differences.by_mode(evidence),
            "Differences by mode",
            f"Model divided by measurement, minus 1, for each mode of the model. {_rms(evidence)}",
            f"Differences by mode: model / measurement \u2212 1. Each mark is one {evidence.setup_noun}, the bar is "
            "their median. A bar away from 0 is what the model gets wrong everywhere; scatter about it is noise or "
            f"depends on the {evidence.setup_noun}.{'' if single else ' Both panels have the same scale.'}"
            f"{_marks(evidence)}",
        )
    ]
    blocks.append(
        Picture.of(
            differences.by_setup(evidence),
            f"Differences by {evidence.setup_noun}",
            f"Differences in standard deviations of the measurement at {where}. {_largest(evidence)}",
            f"Differences by {evidence.setup_noun}, in standard deviations \u03c3 of the measurement. In the shaded band, \u00b12 \u03c3, the difference may be noise.{'' if single else ' The scales of the panels differ.'}",
        )
    )
    return [*blocks, overview]


def pose_figures(evidence: PlottedEvidence) -> list[Block]:
    """Return the residual against the components of the pose; empty if the poses are unknown."""
    figure = differences.against_pose(evidence) if _paired(evidence) else None
    if figure is None:
        return []
    names = ", ".join(evidence.components[k] for k in differences.varying_components(evidence))
    return [
        Picture.of(
            figure,
            "Differences against the pose",
            f"Differences in standard deviations against the pose components {names}. {_largest(evidence)}",
            f"Differences against {names}. A slope or a curve means that what is missing depends on the position; without one, look for a cause that acts everywhere.",
        )
    ]


def shape_figures(evidence: PlottedEvidence) -> list[Block]:
    """Return the MAC matrices, or a sentence where no shapes were measured."""
    figure = mac_matrices(evidence) if _paired(evidence) else None
    if figure is None:
        return [Paragraph("No mode shapes were measured, or none belongs to a mode of the model.")]
    mac = evidence.last_stage.predicted.partner_mac
    lowest = f"{np.nanmin(mac):.3f}"
    worst = worst_setup(evidence)
    label = "" if worst is None else shortened(evidence.labels[worst])
    return [
        Picture.of(
            figure,
            "MAC matrices",
            f"Modal assurance criterion of measured shapes and modes of the model. The lowest of a pair is {lowest}, at {evidence.setup_noun} {label}.",
            "MAC matrices: 1 is the same shape, 0 a shape with nothing in common. Light cells on the diagonal alone "
            "mean that every measured shape is that of its mode; a light cell beside it, that the measured points "
            "hardly tell the two modes apart, or that they changed places. Rows are the measured modes, numbered as "
            f"their partners. Bottom: the {evidence.setup_noun} with the lowest MAC of a pair, {lowest}.",
        )
    ]


def _spread(evidence: PlottedEvidence) -> str:
    """Return the explanation of the bands; empty without any."""
    if evidence.spread is None or not (evidence.spread > 0.0).any():
        return ""
    later = (
        " Later stages have none: the measurements determine their values better."
        if len(evidence.stages) > 1
        else ""
    )
    return f"The bands are one standard deviation on either side of the model as declared, to first order from those of the values in the robot file.{later} "


def _paired(evidence: PlottedEvidence) -> bool:
    return any(stage.paired.any() for stage in evidence.stages)


def _marks(evidence: PlottedEvidence) -> str:
    """Return what the marks mean where there is more than one kind."""
    kinds = ["filled dots were fitted"]
    if (evidence.held_out & ~evidence.outlier).any():
        kinds.append("open diamonds are held out")
    if evidence.outlier.any():
        kinds.append("purple crosses were set aside")
    return f" {', '.join(kinds).capitalize()}." if len(kinds) > 1 else ""


def _unmatched(evidence: PlottedEvidence) -> str:
    count = int((~evidence.last_stage.paired).sum())
    return (
        f"{plural(count, 'measured mode')} without a partner in the model."
        if count
        else "Every measured mode has a partner."
    )


def _rms(evidence: PlottedEvidence) -> str:
    parts = []
    for stage in evidence.stages:
        fitted = evidence.difference(stage)[stage.paired & ~evidence.outlier]
        if len(fitted):
            parts.append(f"{stage.title}: rms {plain(100 * np.sqrt(np.mean(fitted**2)), 2)} %")
    return "; ".join(parts)


def _largest(evidence: PlottedEvidence) -> str:
    parts = []
    for stage in evidence.stages:
        if stage.paired.any():
            away = typeset(plain(np.nanmax(np.abs(stage.predicted.normalised_differences)), 2))
            parts.append(f"largest {stage.title}: {away} standard deviations")
    return "; ".join(parts)
