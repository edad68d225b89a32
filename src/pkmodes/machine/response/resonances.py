"""Resonances of frequency responses: which modes show in which channels, independently of the frequencies chosen."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.solve.backends import AUTO
from pkmodes.loop.sensitivity.spread import spread_of
from pkmodes.machine.response.channels import Index
from pkmodes.machine.response.drawn_channels import DrawnChannels
from pkmodes.machine.response.frequency_response import FrequencyResponse, responses
from pkmodes.machine.response.linearised import LinearisedRobot

Array = NDArray[np.float64]
#: Relative offset from a mode's frequency at which its response is read if it is undamped (its peak is infinite).
#: So close to the peak, modes compare as with equal small damping.
UNDAMPED_OFFSET = 1e-4
#: A mode shows if the response falls on both sides: PEAK_WIDTHS damping ratios away, but at least MIN_PEAK_WIDTH
#: (relative).
PEAK_WIDTHS, MIN_PEAK_WIDTH = 2.0, 1e-3


@dataclass(frozen=True)
class Resonance:
    """A mode that shows as a resonance of a channel.

    - channel: ``OUTPUT/INPUT``
    - mode: its number among the vibration modes, 1 for the lowest
    - frequency: undamped natural frequency [Hz]
    - magnitude: magnitude of the response at this frequency, or at `UNDAMPED_OFFSET` from it if the mode is undamped
    - frequency_sigma: standard deviation of the frequency [Hz], propagated from those in the robot file; None if
      it states none, or none of them changes this frequency
    """

    channel: str
    mode: int
    frequency: float
    magnitude: float
    frequency_sigma: float | None = None


def _modes_in_range(
    response: FrequencyResponse, index: Index = ()
) -> tuple[Array, Array, NDArray[np.intp], int]:
    """Return frequency [Hz], damping ratio and number of each vibration mode in the frequency range of a response.

    The last one is the number of rigid modes below them.
    """
    where = response.one(index)
    modes = response.request.model.modes(response.poses[where], drives=response.drives)
    f = modes.frequencies[modes.rigid_modes :]
    inside = (f >= response.frequencies.min()) & (f <= response.frequencies.max()) & (f > 0.0)
    numbers = np.flatnonzero(inside)
    ratios = modes.damping_ratios[modes.rigid_modes :][inside]
    return f[inside], ratios, numbers + 1, modes.rigid_modes


def strongest_resonance(
    response: FrequencyResponse, channels: Collection[str], index: Index = ()
) -> Resonance | None:
    """Return the strongest resonance of some channels with one unit; None where no mode shows in any.

    - response: from `pkmodes.Model.frf`
    - channels: ``OUTPUT/INPUT`` of the response
    - index: index of the pose
    """
    f, ratios, numbers, rigid_modes = _modes_in_range(response, index)
    if not len(f):
        return None
    damped = ratios > 0.0
    peaks = np.where(damped, f, f * (1.0 + UNDAMPED_OFFSET))
    width = np.maximum(PEAK_WIDTHS * ratios, MIN_PEAK_WIDTH)
    request, point = response.request, response.poses[response.one(index)]
    linearised = LinearisedRobot(request.model, point[None], response.drives, AUTO)
    frequencies = np.stack([peaks, f * (1.0 - width), f * (1.0 + width)])
    magnitudes, below, above = (
        np.abs(responses(linearised, request.inputs, request.outputs, omega, response.quantity)[0])
        for omega in 2.0 * np.pi * np.maximum(frequencies, 0.0)
    )
    strongest: Resonance | None = None
    for o, output in enumerate(response.outputs):
        for i, input_name in enumerate(response.inputs):
            name = f"{output}/{input_name}"
            if name not in channels:
                continue
            magnitude = magnitudes[:, o, i]
            shows = (magnitude > below[:, o, i]) & (magnitude > above[:, o, i])
            if not shows.any():
                continue
            k = int(np.where(shows, magnitude, -1.0).argmax())
            if strongest is None or magnitude[k] > strongest.magnitude:
                strongest = Resonance(name, int(numbers[k]), float(f[k]), float(magnitude[k]))
    if strongest is None:
        return None
    sigmas = spread_of(request.model, point, response.drives)
    sigma = 0.0 if sigmas is None else float(sigmas[rigid_modes + strongest.mode - 1])
    return replace(strongest, frequency_sigma=sigma or None)


def strongest_drawn_resonance(response: FrequencyResponse, drawn: DrawnChannels) -> Resonance | None:
    """Return the strongest resonance among the measured channels that share the first one's unit.

    It is that among all channels that share it if none is measured.
    """
    measured = {} if drawn.measured is None else drawn.measured.responses
    names = [name for name in drawn.model if name in measured] or list(drawn.model)
    unit_of_first = drawn.units[names[0]]
    return strongest_resonance(response, [name for name in names if drawn.units[name] == unit_of_first])
