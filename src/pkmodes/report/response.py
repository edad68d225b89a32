"""The report of ``pkmodes response``: frequency responses at a pose, measured ones over those of the model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.version import VERSION
from pkmodes.figures.response_channels import DrawnChannels
from pkmodes.mechanism.poses import placed
from pkmodes.plots.labels import MINUS
from pkmodes.plots.responses import responses
from pkmodes.plots.style import styled
from pkmodes.report.blocks import Block, Cell, Column, Facts, Picture, Section, Summary
from pkmodes.report.formatting import clean, figures, hertz, number, plural, pointer, uncertain, unit
from pkmodes.report.origin import files_of
from pkmodes.report.page import need_report, page
from pkmodes.report.sources import Source, known_sources
from pkmodes.report.tables import table
from pkmodes.response.measured import MeasuredResponse
from pkmodes.robot.report_fields import head_of
from pkmodes.sensitivity.spread import spread_of

if TYPE_CHECKING:
    from pkmodes.model.model import Model
    from pkmodes.response.frequency_response import FrequencyResponse

#: Channels in one figure: two by two.
TOGETHER = 4
UNDAMPED = (
    "The robot file has no damping: a resonance has no height of its own, and its peak is as high as the nearest "
    "frequency lets it be. Add [damping] ratio."
)


def response_report(
    model: Model,
    response: FrequencyResponse,
    measured: MeasuredResponse | None = None,
    sources: Sequence[Source] | None = None,
) -> str:
    """Return the report of frequency responses at one pose.

    Parameters
    ----------
    model : Model
        The robot.
    response : FrequencyResponse
        From `pkmodes.Model.frf`.
    measured : MeasuredResponse, optional
        From `pkmodes.figures.read_response`.
    sources : sequence of Source, optional
        The input files as they were read; by default the robot file as it is now.

    Returns
    -------
    str
        HTML that needs no other file and no network.

    Raises
    ------
    PkmodesError
        As `pkmodes.figures.response_picture`.
    MissingExtraError
        If the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    drawn = DrawnChannels.of(response, measured)
    entries = [*files_of(sources), ("mechanism", [Cell(clean(model.mechanism.title))])]
    entries.append(("pkmodes", [Cell(VERSION)]))
    sections = [
        Section("responses", "Frequency responses", [*_pictures(drawn), _largest(drawn)]),
        Section("modes", "Modes of the model", [_modes(model, response)]),
        Section("origin", "Data and versions", [Facts(entries)]),
    ]
    return page(_summary(model, response, drawn), sections)


def _summary(model: Model, response: FrequencyResponse, drawn: DrawnChannels) -> Summary:
    at = placed(model.mechanism, response.poses[response.one(())], "g").replace("-", MINUS)
    name = next(iter(drawn.model))
    output, _, into = name.partition("/")
    peak = _peak(drawn.frequencies, drawn.model[name])
    headline = f"{clean(output)} responds most to {clean(into)} at {drawn.frequencies[peak]:.1f} Hz"
    if drawn.measured is not None:
        f, values = drawn.measured[0], drawn.measured[1][name]
        headline += f", measured at {f[_within(drawn, values)]:.1f} Hz"
    first, last = (float(drawn.frequencies[i]) for i in (0, -1))
    facts = [
        ("channels", Cell(str(len(drawn.model)), len(drawn.model))),
        ("frequencies", Cell(f"{first:g} to {last:g} Hz")),
    ]
    if drawn.measured is not None:
        count = len(drawn.measured[1])
        facts.append(("of the channels measured", Cell(str(count), count)))
    reason = f"{response.quantity.capitalize()} at {at}, motors {response.drives}."
    notes = [] if model.robot.dissipates else [UNDAMPED]
    if drawn.silent:
        notes.append(f"No response in {clean(', '.join(drawn.silent), None)}.")
    return Summary(
        subject=clean(model.robot.name),
        kind="Frequency responses",
        verdict="",
        headline=headline,
        reason=reason,
        tone="plain",
        notes=notes,
        facts=facts,
        head=head_of(model.robot.report),
    )


def _peak(f: NDArray[Any], values: NDArray[Any], ends: tuple[float, float] = (0.0, np.inf)) -> int:
    """Return the place of the largest response between two frequencies."""
    return int(np.where((f >= ends[0]) & (f <= ends[1]), np.abs(values), -1.0).argmax())


def _within(drawn: DrawnChannels, values: NDArray[Any]) -> int:
    """Return the place of the largest measured response among the frequencies of the model."""
    assert drawn.measured is not None
    return _peak(drawn.measured[0], values, (float(drawn.frequencies[0]), float(drawn.frequencies[-1])))


def _pictures(drawn: DrawnChannels) -> list[Block]:
    """Return magnitude and phase of every channel, in as many figures as fit pages."""
    names, blocks = list(drawn.model), list[Block]()
    for start in range(0, len(names), TOGETHER):
        chosen = names[start : start + TOGETHER]
        with styled():
            figure = responses(
                drawn.frequencies, {name: drawn.model[name] for name in chosen}, drawn.units, drawn.measured
            )
        shown = ", ".join(clean(name) for name in chosen)
        title = "Responses" if len(names) <= TOGETHER else f"Responses, {start + 1} to {start + len(chosen)}"
        caption = f"Magnitude and phase of {shown}; a phase of \u221290\u00b0 lags behind."
        if drawn.measured is not None and not drawn.measured[1].keys().isdisjoint(chosen):
            caption += " Broad lines are measured, thin ones the model."
        blocks.append(Picture.of(figure, title, f"Magnitude and phase of {shown}.", caption))
    return blocks


def _largest(drawn: DrawnChannels) -> Block:
    """Return the table of the largest response in each channel."""
    over = drawn.measured
    groups = [("", 2), ("model", 3), *([("measured", 3)] if over is not None else [])]
    titles = [Column("channel", False), Column("unit", False)]
    titles += [Column(title) for _ in groups[1:] for title in ("largest", "at [Hz]", "phase [\u00b0]")]
    rows = []
    for name, values in drawn.model.items():
        peak = _peak(drawn.frequencies, values)
        row = [Cell(clean(name)), Cell(unit(drawn.units[name]))]
        row += _cells(drawn.frequencies, values, peak, pointer("frequencies_hz", peak))
        if over is not None and name in over[1]:
            row += _cells(over[0], over[1][name], _within(drawn, over[1][name]))
        elif over is not None:
            row += [number(None)] * 3
        rows.append(row)
    return table("The largest response in each channel.", titles, rows, groups)


def _cells(f: NDArray[Any], values: NDArray[Any], peak: int, at: str = "") -> list[Cell]:
    value = complex(values[peak])
    return [
        figures(abs(value), 4),
        number(float(f[peak]), ".2f", at),
        number(float(np.degrees(np.angle(value))), ".0f"),
    ]


def _modes(model: Model, response: FrequencyResponse) -> Block:
    """Return the vibration modes at the pose: frequency, damping, and the direction of the platform."""
    pose = response.poses[response.one(())]
    modes = model.modes(pose, drives=response.drives)
    sigmas, rigid = spread_of(model.dynamics, pose, response.drives), modes.rigid_modes
    columns = [Column("mode"), Column("f [Hz]"), Column("damping [%]")]
    columns += [Column(f"p_{name}") for name in model.mechanism.directions]
    rows = []
    for i in range(rigid, len(modes.frequencies)):
        f, direction = float(modes.frequencies[i]), modes.platform_shapes[i]
        direction = direction / max(float(np.linalg.norm(direction)), np.finfo(float).tiny)
        sigma = 0.0 if sigmas is None else float(sigmas[i])
        rows.append(
            [
                Cell(str(i + 1 - rigid)),
                uncertain(f, sigma) if sigma > 0.0 else hertz(f),
                number(float(modes.damping_ratios[i]), ".3g", scale=100.0),
                *(number(float(part) + 0.0, ".3f") for part in direction),
            ]
        )
    caption = (
        f"{plural(len(rows), 'vibration mode')} at this pose: undamped natural frequency, damping ratio, and the "
        "direction in which the platform moves."
    )
    return table(caption, columns, rows)
