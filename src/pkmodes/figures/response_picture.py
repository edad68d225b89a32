"""The picture of frequency responses at a pose, measured ones over those of the model."""

from __future__ import annotations

from pkmodes.base.extras import require
from pkmodes.figures.pictures import Picture
from pkmodes.mechanism.poses import placed
from pkmodes.plots.responses import MOST, responses, without_response
from pkmodes.plots.style import styled
from pkmodes.response.channels import Index
from pkmodes.response.frequency_response import FrequencyResponse
from pkmodes.response.measured import MeasuredResponse


def response_picture(
    response: FrequencyResponse, measured: MeasuredResponse | None = None, index: Index = ()
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
    where = response.one(index)
    values = response.values[where]
    model, units = {}, {}
    for o, output in enumerate(response.outputs):
        for i, into in enumerate(response.inputs):
            name = f"{output}/{into}"
            model[name], units[name] = values[:, o, i], response.units[o][i]
    if measured is not None:
        stated = {"quantity": response.quantity, "drives": response.drives}
        measured.check(stated | {f"unit {name}": unit for name, unit in units.items()})
    over = None if measured is None else (measured.frequencies, measured.among(list(model)))
    silent = without_response(model, units)
    if over is not None:  # these first: only so many are drawn
        model = {**{name: model[name] for name in over[1]}, **model}
        silent = [name for name in silent if name not in over[1]]
    if len(silent) < len(model):
        model = {name: values for name, values in model.items() if name not in silent}
    else:
        silent = []
    at = placed(response.robot.mechanism, response.poses[where], "g")
    also = "" if over is None else ", with measured responses"
    text = (
        f"{response.quantity.capitalize()} of {response.robot.name} at {at}, motors {response.drives}{also}."
    )
    if len(model) > MOST:
        text += f" The first {MOST} of {len(model)} channels: choose others by inputs and outputs."
    if silent:
        text += f" No response in {', '.join(silent)}."
    with styled():
        drawn = responses(response.frequencies, model, units, over, text)
    return Picture("response", "Frequency responses", text, drawn)
