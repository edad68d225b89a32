"""The report of ``pkmodes response``: frequency responses at a pose, measured ones over those of the model."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base import numbers
from pkmodes.core.base.numbers import round_to_sigma
from pkmodes.core.mechanism.length import lengths_of, unit_vector_headings, unit_vectors
from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.support.motors import motors_in_words
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.response.drawn_channels import DrawnChannels, most_responsive
from pkmodes.machine.response.measured import MeasuredResponse
from pkmodes.machine.response.resonances import Resonance, strongest_drawn_resonance
from pkmodes.pages.plots.labels import MINUS, PLUS_MINUS
from pkmodes.pages.plots.responses import responses
from pkmodes.pages.report.blocks import Block, Cell, Column, Picture, Section, Summary, Table
from pkmodes.pages.report.formatting import (
    clean,
    frequency_cell,
    number_cell,
    plural,
    pointer,
    shorten,
    three_digit_cell,
    to_sentence,
    uncertain_cell,
    unit_cell,
    unit_text,
)
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sources import Source, known_sources
from pkmodes.pages.report.tables import compact_table

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.core.robot.robot import Robot
    from pkmodes.machine.response.frequency_response import FrequencyResponse

#: A measured peak belongs to a mode of the model if their frequencies differ by no more than this factor.
NEAR = 1.25
#: Channels in one figure, two by two.
CHANNELS_PER_FIGURE = 4
UNDAMPED_NOTE = (
    "The robot file has no damping: a resonance has no height of its own, and its peak depends only on how near "
    "the nearest frequency is. Add [damping] ratio."
)


def response_report(
    model: Model,
    response: FrequencyResponse,
    measured: MeasuredResponse | None = None,
    sources: Sequence[Source] | None = None,
    before: FrequencyResponse | None = None,
) -> str:
    """Return the report of frequency responses at one pose.

    - model: the robot
    - response: from `pkmodes.Model.frf`
    - measured: from `pkmodes.figures.read_response`
    - sources: the input files as they were read; by default the robot file as it is now
    - before: of the robot before a correction: the same channels at the same pose and frequencies

    Returns HTML that needs no other file and no network.
    Raises PkmodesError as `pkmodes.figures.response_picture` does.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    drawn = DrawnChannels.of(response, measured, before=before)
    sections = [
        Section(
            "responses", "Frequency responses", [*_response_figures(drawn), largest_responses_table(drawn)]
        ),
        Section("modes", "Modes of the model", [_modes_table(model, response)]),
        origin_section(sources, model.mechanism),
    ]
    return page(response_summary(model, response, drawn), sections)


def response_summary(model: Model, response: FrequencyResponse, drawn: DrawnChannels) -> Summary:
    """Return the strongest resonance of the channels of one unit, or which channel responds most without any."""
    pose_text = format_pose(model.mechanism, response.poses[response.one(())], "g").replace("-", MINUS)
    measured = {} if drawn.measured is None else drawn.measured.responses
    compared = {name: values for name, values in drawn.model.items() if name in measured} or drawn.model
    has_several_frequencies = len(drawn.frequencies) > 1
    first, last = (float(drawn.frequencies[i]) for i in (0, -1))
    resonance = strongest_drawn_resonance(response, drawn) if has_several_frequencies else None
    name = most_responsive(compared, drawn.units) if resonance is None else resonance.channel
    output_port, _, input_port = name.partition("/")
    strongest_text = f"{clean(output_port)} responds most to {clean(input_port)}"
    if resonance is not None:
        frequency_text = _resonance_in_words(resonance)
        mode_text = f"in mode {resonance.mode}, at {frequency_text}"
        headline = f"{clean(output_port)} resonates most with {clean(input_port)} {mode_text}"
        if drawn.measured is not None and name in measured:
            index = _measured_peak_near(drawn, measured[name], resonance.frequency)
            if index is not None:
                headline += f", measured at {numbers.format_frequency(drawn.measured.frequencies[index])} Hz"
    elif has_several_frequencies:
        peak = numbers.format_frequency(drawn.frequencies[int(np.abs(drawn.model[name]).argmax())])
        headline = f"No resonance from {first:g} to {last:g} Hz: {strongest_text} at {peak} Hz"
    else:
        headline = f"At {first:g} Hz {strongest_text}"
    facts = [
        ("channels", Cell(str(len(drawn.model)), len(drawn.model))),
        ("frequencies", Cell(f"{first:g} to {last:g} Hz"))
        if has_several_frequencies
        else ("frequency", Cell(f"{first:g} Hz")),
    ]
    if resonance is not None:
        facts.append(
            (f"mode {resonance.mode}", hertz_with_unit_cell(resonance.frequency, "resonance", "frequency_hz"))
        )
    if drawn.measured is not None:
        count = len(drawn.measured.responses)
        facts.append(("of the channels measured", Cell(str(count), count)))
    reason = (
        f"{response.quantity.capitalize()} at {pose_text}, {motors_in_words(model.robot, response.drives)}."
    )
    if len(drawn.model) > 1:
        channels_text = "measured channels" if measured else "channels"
        symbol = unit_text(drawn.units[name])
        channel_group = f"{channels_text} in {symbol}" if symbol else f"dimensionless {channels_text}"
        strongest = "the largest response" if resonance is None else "the strongest resonance"
        reason += f" Of the {channel_group} this one has {strongest}."
    if meanings := [
        f"{clean(port)} is {words}"
        for port in (output_port, input_port)
        if (words := _port_meaning(port, model.mechanism))
    ]:
        reason += f" Here {', '.join(meanings)}."
    return Summary(
        subject=f"{shorten(model.robot.name)}, {motors_in_words(model.robot, response.drives)}",
        kind="Frequency responses",
        headline=headline,
        reason=reason,
        notes=[*_notes(model.robot, drawn)],
        facts=facts,
        head=head_of(model.robot.report),
    )


def _resonance_in_words(resonance: Resonance) -> str:
    """Return the frequency of a resonance, with its standard deviation where the robot file states any."""
    if resonance.frequency_sigma is None:
        return f"{numbers.format_frequency(resonance.frequency)} Hz"
    rounded = round_to_sigma(resonance.frequency, resonance.frequency_sigma)
    return f"{rounded.value} {PLUS_MINUS} {rounded.sigma} Hz (from the standard deviations in the robot file)"


def hertz_with_unit_cell(frequency: float, *json_keys: str) -> Cell:
    """Return a frequency with its unit.

    - json_keys: its place in the JSON
    """
    return Cell(f"{numbers.format_frequency(frequency)} Hz", frequency, pointer(*json_keys))


def _notes(robot: Robot, drawn: DrawnChannels) -> Iterator[str]:
    """Yield notes on the responses."""
    if not robot.dissipates:
        yield UNDAMPED_NOTE
    yield from (to_sentence(clean(note)) for note in drawn.notes)
    if drawn.prescribed:
        verb = "is" if len(drawn.prescribed) == 1 else "are"
        yield f"{clean(', '.join(drawn.prescribed))} {verb} left out: the motion is prescribed."
    if drawn.silent:
        yield f"No response in {clean(', '.join(drawn.silent))}."


def _port_meaning(port: str, mechanism: Mechanism) -> str:
    """Return what an input or output is; empty if its name says so, or it has no description."""
    kind, _, suffix = port.partition("_")
    if kind in ("p", "r", "force", "moment") and suffix not in ("x", "y", "z"):
        return ""  # a direction that the user named
    motion, effort = ("length", "force") if mechanism.drives[0].unit == "N" else ("angle", "torque")
    body = mechanism.moving_body(suffix if kind in ("p", "force") else "")
    return {
        "p": f"the motion of the {body} along {suffix}",
        "r": f"the rotation of the {body} about {suffix}",
        "force": f"a force on the {body} along {suffix}",
        "moment": f"a moment on the {body} about {suffix}",
        "motor": f"the {motion} of motor {suffix}",
        "torque": f"the {effort} of motor {suffix}",
    }.get(kind, "")


def _largest_measured_index(drawn: DrawnChannels, values: NDArray[Any]) -> int | None:
    """Return the index of the largest measured response within the frequency range of the model; None without any."""
    assert drawn.measured is not None
    frequencies = drawn.measured.frequencies
    inside = (frequencies >= drawn.frequencies[0]) & (frequencies <= drawn.frequencies[-1])
    return int(np.where(inside, np.abs(values), -1.0).argmax()) if inside.any() else None


def _measured_peak_near(drawn: DrawnChannels, values: NDArray[Any], frequency: float) -> int | None:
    """Return the index of the largest measured response around a mode [Hz]; None where none of them is a peak."""
    assert drawn.measured is not None
    frequencies, size = drawn.measured.frequencies, np.abs(values)
    is_near = (
        (frequencies >= frequency / NEAR)
        & (frequencies <= frequency * NEAR)
        & (frequencies >= drawn.frequencies[0])
    )
    is_near &= frequencies <= drawn.frequencies[-1]
    if not is_near.any():
        return None
    peak = int(np.where(is_near, size, -1.0).argmax())
    return peak if size[peak] >= size[max(peak - 1, 0) : peak + 2].max() else None


def _response_figures(drawn: DrawnChannels) -> list[Block]:
    """Return magnitude and phase of every channel, divided into figures that fit on pages."""
    names, blocks = list(drawn.model), list[Block]()
    for start in range(0, len(names), CHANNELS_PER_FIGURE):
        chosen = names[start : start + CHANNELS_PER_FIGURE]
        drawing = responses(
            drawn.frequencies,
            {name: drawn.model[name] for name in chosen},
            drawn.units,
            drawn.measured,
            before=drawn.before,
        )
        shown = ", ".join(clean(name) for name in chosen)
        title = (
            "Responses"
            if len(names) <= CHANNELS_PER_FIGURE
            else f"Responses, {start + 1} to {start + len(chosen)}"
        )
        caption = f"Magnitude and phase of {shown}; a phase of \u221290\u00b0 lags behind."
        if drawn.measured is not None and not drawn.measured.responses.keys().isdisjoint(chosen):
            caption += " Broad lines are measured, thin ones the model."
        if drawn.before is not None:
            caption += " Dashed lines are the machine as it was described before."
        blocks.append(Picture.from_drawing(drawing, title, f"Magnitude and phase of {shown}.", caption))
    return blocks


def largest_responses_table(drawn: DrawnChannels) -> Table:
    """Return the table of the first and the largest response in each channel."""
    measured, frequencies = drawn.measured, drawn.frequencies
    has_several_frequencies = len(frequencies) > 1
    peaks = [Column(title) for title in ("largest", "at [Hz]", "phase [\u00b0]")]
    model_columns = [Column("first"), *peaks] if has_several_frequencies else [Column("magnitude"), peaks[-1]]
    titles = [Column("channel", False), Column("unit", False), *model_columns]
    groups: list[tuple[str, int]] = []
    if measured is not None:
        titles += peaks
        groups = [("", 2), ("model", len(model_columns)), ("measured", 3)]
    rows = []
    for name, values in drawn.model.items():
        peak = _largest_peak(np.abs(values))
        row = [Cell(clean(name)), unit_cell(drawn.units[name])]
        cells = _peak_cells(frequencies, values, peak, pointer("frequencies_hz", peak))
        row += [_four_digits(abs(values[0])), *cells] if has_several_frequencies else [cells[0], cells[-1]]
        if measured is not None:
            index = (
                _largest_measured_index(drawn, measured.responses[name])
                if name in measured.responses
                else None
            )
            if index is None:
                row += [number_cell(None)] * 3
            else:
                row += _peak_cells(measured.frequencies, measured.responses[name], index)
        rows.append(row)
    caption = (
        f"Magnitudes at the first of {len(frequencies)} frequencies from {frequencies[0]:g} to "
        f"{frequencies[-1]:g} Hz, and the largest of each channel with its phase; where that is the first, the "
        "largest peak after it"
        if has_several_frequencies
        else f"Magnitude and phase at {frequencies[0]:g} Hz"
    )
    return compact_table(f"{caption}, for exp(+i\u03c9t).", titles, rows, groups)


def _largest_peak(magnitudes: NDArray[np.float64]) -> int:
    """Return the index of the largest magnitude, or of the largest peak where that is the first.

    Towards low frequencies a machine with free motors moves as a rigid body, by more than at any resonance.
    """
    largest = int(magnitudes.argmax())
    is_peak = np.zeros(len(magnitudes), dtype=bool)
    is_peak[1:-1] = (magnitudes[1:-1] >= magnitudes[:-2]) & (magnitudes[1:-1] > magnitudes[2:])
    if largest or not is_peak.any():
        return largest
    return int(np.where(is_peak, magnitudes, -1.0).argmax())


def _peak_cells(
    frequencies: NDArray[Any], values: NDArray[Any], peak: int, json_pointer: str = ""
) -> list[Cell]:
    value = complex(values[peak])
    return [
        _four_digits(abs(value)),
        frequency_cell(float(frequencies[peak]), json_pointer),
        number_cell(float(np.degrees(np.angle(value))), ".0f"),
    ]


def _four_digits(value: float) -> Cell:
    """Return a magnitude with four significant digits, trailing zeros included, so that columns align."""
    return number_cell(value, "#.4g" if 1e-3 <= value < 999.9 else ".3e")


def _modes_table(model: Model, response: FrequencyResponse) -> Block:
    """Return the vibration modes at the pose: frequency, damping, and the direction of the platform."""
    pose = response.poses[response.one(())]
    modes = model.modes(pose, drives=response.drives)
    sigmas, rigid = spread_of(model, pose, response.drives), modes.rigid_modes
    columns = [Column("mode"), Column("f [Hz]"), Column("damping [%]")]
    columns += map(Column, unit_vector_headings(model.mechanism))
    directions = unit_vectors(modes.platform_shapes, lengths_of(model.mechanism, model.robot.parameters))
    rows = []
    for i in range(rigid, len(modes.frequencies)):
        frequency = float(modes.frequencies[i])
        sigma = 0.0 if sigmas is None else float(sigmas[i])
        rows.append(
            [
                Cell(str(i + 1 - rigid)),
                uncertain_cell(frequency, sigma) if sigma > 0.0 else frequency_cell(frequency),
                three_digit_cell(float(modes.damping_ratios[i]), scale=100.0),
                *(number_cell(float(part) + 0.0, ".3f") for part in directions[i]),
            ]
        )
    caption = (
        f"{plural(len(rows), 'vibration mode')} at this pose: undamped natural frequency, damping ratio, and the "
        f"direction in which the {model.mechanism.body_moves()}."
    )
    if model.mechanism.rotations:
        caption += f" Rotations are times L = {model.characteristic_length:.4g} m."
    return compact_table(caption, columns, rows)
