"""The picture of frequency responses at a pose, measured ones over those of the model, and which of them it has."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import placed
from pkmodes.figures.pictures import Picture
from pkmodes.plots.responses import MOST, responses
from pkmodes.response.channels import Index, without_response
from pkmodes.response.frequency_response import FrequencyResponse
from pkmodes.response.measured import MeasuredResponse
from pkmodes.support.extras import require
from pkmodes.support.motors import motors_in_words

Array = NDArray[Any]


@dataclass(frozen=True, eq=False)
class DrawnChannels:
    """Responses at a pose by channel, ``OUTPUT/INPUT``.

    Attributes
    ----------
    frequencies : ndarray, shape (F,)
        Of the model [Hz].
    model : mapping of str to ndarray, complex128, shape (F,)
        In the order in which they are drawn.
    units : mapping of str to str
        Of the magnitudes.
    measured : tuple of ndarray and mapping, or None
        Frequencies, and responses by channel.
    silent : tuple of str
        Channels without a response, which are left out.
    prescribed : tuple of str
        Channels from a prescribed motion to itself, which are left out.
    text : str
        What is drawn: quantity, robot, pose, and what the motors do.
    """

    frequencies: Array
    model: Mapping[str, Array]
    units: Mapping[str, str]
    measured: tuple[Array, Mapping[str, Array]] | None
    silent: tuple[str, ...]
    prescribed: tuple[str, ...]
    text: str

    @classmethod
    def of(
        cls, response: FrequencyResponse, measured: MeasuredResponse | None = None, index: Index = ()
    ) -> DrawnChannels:
        """Choose the channels of a response.

        Raises
        ------
        PkmodesError
            If the index selects no pose, no measured channel is one of the response, or the table states that it is
            of something else.
        """
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
        over_names = () if over is None else tuple(over[1])
        prescribed = [f"{one}/{one}" for one in response.outputs if one in response.inputs]
        prescribed = [name for name in prescribed if name not in over_names]
        if len(prescribed) + len(silent) < len(model):
            model = {name: values for name, values in model.items() if name not in prescribed}
        else:
            prescribed = []
        if len(silent) < len(model):
            model = {name: values for name, values in model.items() if name not in silent}
        else:
            silent = []
        at = placed(response.robot.mechanism, response.poses[where], "g")
        also = "" if over is None else ", with measured responses"
        quantity = response.quantity.capitalize()
        doing = motors_in_words(response.robot, response.drives)
        text = f"{quantity} of {response.robot.name} at {at}, {doing}{also}."
        if silent:
            text += f" No response in {', '.join(silent)}."
        return cls(response.frequencies, model, units, over, tuple(silent), tuple(prescribed), text)


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
    found = DrawnChannels.of(response, measured, index)
    text = found.text
    if len(found.model) > MOST:
        text += f" The first {MOST} of {len(found.model)} channels: choose others by inputs and outputs."
    drawn = responses(found.frequencies, found.model, found.units, found.measured, text)
    return Picture("response", "Frequency responses", text, drawn)
