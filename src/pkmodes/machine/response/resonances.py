"""Resonances of frequency responses: which modes show in which channels, independently of the frequencies chosen."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.solve.backends import AUTO
from pkmodes.machine.response.channels import Index
from pkmodes.machine.response.drawn_channels import DrawnChannels
from pkmodes.machine.response.frequency_response import FrequencyResponse, responses
from pkmodes.machine.response.linearised import LinearisedRobot

Array = NDArray[np.float64]
#: Relative distance from the frequency of a mode at which its resonance is judged: without damping it has no height,
#: and so near by, the responses of several modes compare as they would with equal small damping.
BESIDE = 1e-4
#: A mode shows where the response falls on both sides, at this distance in damping ratios, and at least this one.
WIDTHS, LEAST_WIDTH = 2.0, 1e-3


@dataclass(frozen=True)
class Resonance:
    """A mode that shows as a resonance of a channel.

    - channel: ``OUTPUT/INPUT``
    - mode: its number among the vibration modes, 1 for the lowest
    - frequency: undamped natural frequency [Hz]
    - size: magnitude of the response there, or so near by that it compares with others if the mode is undamped
    """

    channel: str
    mode: int
    frequency: float
    size: float


def modes_within(response: FrequencyResponse, index: Index = ()) -> tuple[Array, Array, NDArray[np.intp]]:
    """Return frequency [Hz], damping ratio and number of each vibration mode within the frequencies of a response."""
    where = response.one(index)
    modes = response.request.model.modes(response.poses[where], drives=response.drives)
    f = modes.frequencies[modes.rigid_modes :]
    inside = (f >= response.frequencies.min()) & (f <= response.frequencies.max()) & (f > 0.0)
    numbers = np.flatnonzero(inside)
    return f[inside], modes.damping_ratios[modes.rigid_modes :][inside], numbers + 1


def strongest_resonance(
    response: FrequencyResponse, channels: Collection[str], index: Index = ()
) -> Resonance | None:
    """Return the strongest resonance of some channels with one unit; None where no mode shows in any.

    - response: from `pkmodes.Model.frf`
    - channels: ``OUTPUT/INPUT`` of the response
    - index: of the pose
    """
    f, ratios, numbers = modes_within(response, index)
    if not len(f):
        return None
    damped = ratios > 0.0
    peaks = np.where(damped, f, f * (1.0 + BESIDE))
    width = np.maximum(WIDTHS * ratios, LEAST_WIDTH)
    request, point = response.request, response.poses[response.one(index)]
    linearised = LinearisedRobot(request.model, point[None], response.drives, AUTO)
    places = np.stack([peaks, f * (1.0 - width), f * (1.0 + width)])
    sizes, below, above = (
        np.abs(responses(linearised, request.inputs, request.outputs, omega, response.quantity)[0])
        for omega in 2.0 * np.pi * np.maximum(places, 0.0)
    )
    strongest: Resonance | None = None
    for o, output in enumerate(response.outputs):
        for i, into in enumerate(response.inputs):
            name = f"{output}/{into}"
            if name not in channels:
                continue
            size = sizes[:, o, i]
            shows = (size > below[:, o, i]) & (size > above[:, o, i])
            if not shows.any():
                continue
            k = int(np.where(shows, size, -1.0).argmax())
            if strongest is None or size[k] > strongest.size:
                strongest = Resonance(name, int(numbers[k]), float(f[k]), float(size[k]))
    return strongest


def resonance_of(response: FrequencyResponse, drawn: DrawnChannels) -> Resonance | None:
    """Return the strongest resonance of the measured channels, or of all, with the unit of the first of them."""
    measured = {} if drawn.measured is None else drawn.measured.responses
    names = [name for name in drawn.model if name in measured] or list(drawn.model)
    unit_of_first = drawn.units[names[0]]
    return strongest_resonance(response, [name for name in names if drawn.units[name] == unit_of_first])
