"""The picture of frequency responses at a pose, measured and of the model."""

from __future__ import annotations

from pkmodes.core.support.extras import require
from pkmodes.machine.response.channels import Index
from pkmodes.machine.response.drawn_channels import DrawnChannels
from pkmodes.machine.response.frequency_response import FrequencyResponse
from pkmodes.machine.response.measured import MeasuredResponse
from pkmodes.pages.figures.pictures import Picture
from pkmodes.pages.plots.responses import MAX_CHANNELS, responses


def response_picture(
    response: FrequencyResponse,
    measured: MeasuredResponse | None = None,
    index: Index = (),
    before: FrequencyResponse | None = None,
) -> Picture:
    """Draw the responses at a pose.

    Parameters
    ----------
    response : FrequencyResponse
        From `pkmodes.Model.frf`.
    measured : MeasuredResponse, optional
        From `read_response`; channels that the model's response lacks are left out.
    index : tuple of int or int
        Of the pose; not needed for a single one.
    before : FrequencyResponse, optional
        Of the robot before a correction: the same channels at the same poses and frequencies.

    Returns
    -------
    Picture
        In a notebook it shows itself.

    Raises
    ------
    PkmodesError
        If the index selects no pose, no measured channel is one of the response, or the table states that it is of
        something else.
    MissingExtraError
        If matplotlib is not installed.
    """
    require("pictures of responses", "plot", "matplotlib")
    channels = DrawnChannels.of(response, measured, index, before)
    text = channels.text
    if len(channels.model) > MAX_CHANNELS:
        text += f" The first {MAX_CHANNELS} of {len(channels.model)} channels: choose others by inputs and outputs."
    drawing = responses(
        channels.frequencies, channels.model, channels.units, channels.measured, text, channels.before
    )
    return Picture("response", "Frequency responses", text, drawing)
