"""The channels of a response at a pose that are drawn and tabulated, with measured responses beside them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.support.motors import motors_in_words
from pkmodes.machine.response.channels import Index
from pkmodes.machine.response.frequency_response import FrequencyResponse
from pkmodes.machine.response.measured import MeasuredResponse

Array = NDArray[Any]
#: A response below this fraction of the largest one of the same unit is rounding.
SILENT_SHARE = 1e-10


class MeasuredCurves(NamedTuple):
    """Measured responses at M frequencies.

    - frequencies: (M,) [Hz]
    - responses: by channel, each (M,)
    """

    frequencies: Array
    responses: Mapping[str, Array]


@dataclass(frozen=True, eq=False)
class DrawnChannels:
    """Responses at a pose by channel, ``OUTPUT/INPUT``.

    - frequencies: frequencies of the model, (F,) [Hz]
    - model: in the order in which they are drawn, each (F,)
    - units: units of the magnitudes
    - measured: the measured responses
    - silent: channels without a response, which are left out
    - prescribed: channels from a prescribed motion to itself, which are left out
    - text: what is drawn: quantity, robot, pose, and what the motors do
    - before: responses of another robot, such as the one before a correction, by channel, each (F,)
    - notes: what was assumed of the measured responses
    """

    frequencies: Array
    model: Mapping[str, Array]
    units: Mapping[str, str]
    measured: MeasuredCurves | None
    silent: tuple[str, ...]
    prescribed: tuple[str, ...]
    text: str
    before: Mapping[str, Array] | None = None
    notes: tuple[str, ...] = ()

    @classmethod
    def of(
        cls,
        response: FrequencyResponse,
        measured: MeasuredResponse | None = None,
        index: Index = (),
        before: FrequencyResponse | None = None,
    ) -> DrawnChannels:
        """Choose the channels of a response.

        - before: responses of another robot: the same channels at the same poses and frequencies

        Raises PkmodesError if the index selects no pose, no measured channel is one of the response, or the table
        states that it is of something else.
        """
        pose_index = response.one(index)
        values = response.values[pose_index]
        model, units, before_responses = {}, {}, {}
        for o, output in enumerate(response.outputs):
            for i, input_name in enumerate(response.inputs):
                name = f"{output}/{input_name}"
                model[name], units[name] = values[:, o, i], response.units[o][i]
                if before is not None:
                    before_responses[name] = before.values[pose_index][:, o, i]
        if measured is not None:
            expected = {"quantity": response.quantity, "drives": response.drives}
            measured.check(expected | {f"unit {name}": unit for name, unit in units.items()})
        curves = (
            None if measured is None else MeasuredCurves(measured.frequencies, measured.among(list(model)))
        )
        silent = without_response(model, units)
        if curves is not None:  # these first: the number of drawn channels is limited
            model = {**{name: model[name] for name in curves.responses}, **model}
            silent = [name for name in silent if name not in curves.responses]
        measured_names = () if curves is None else tuple(curves.responses)
        prescribed = [f"{port}/{port}" for port in response.outputs if port in response.inputs]
        prescribed = [name for name in prescribed if name not in measured_names]
        if len(prescribed) + len(silent) < len(model):
            model = {name: values for name, values in model.items() if name not in prescribed}
        else:
            prescribed = []
        if len(silent) < len(model):
            model = {name: values for name, values in model.items() if name not in silent}
        else:
            silent = []
        pose_text = format_pose(response.robot.mechanism, response.poses[pose_index], "g")
        additions = "" if curves is None else ", with measured responses"
        additions += "" if before is None else f", before: {before.robot.name}"
        quantity = response.quantity.capitalize()
        motor_state = motors_in_words(response.robot, response.drives)
        text = f"{quantity} of {response.robot.name} at {pose_text}, {motor_state}{additions}."
        if silent:
            text += f" No response in {', '.join(silent)}."
        return cls(
            response.frequencies,
            model,
            units,
            curves,
            tuple(silent),
            tuple(prescribed),
            text,
            before_responses or None,
            () if measured is None else measured.notes,
        )


def without_response(model: Mapping[str, NDArray[Any]], units: Mapping[str, str]) -> list[str]:
    """Return the channels that show only rounding, compared with the others of the same unit.

    - model: responses by channel, each (F,)
    - units: units of the channels
    """
    largest: dict[str, float] = {}
    for name, values in model.items():
        largest[units[name]] = max(largest.get(units[name], 0.0), float(np.abs(values).max()))
    return [
        name for name, values in model.items() if np.abs(values).max() <= SILENT_SHARE * largest[units[name]]
    ]


def most_responsive(model: Mapping[str, NDArray[Any]], units: Mapping[str, str]) -> str:
    """Return the channel with the largest response among those of the unit of the first one."""
    unit = units[next(iter(model))]
    return max(
        (name for name in model if units[name] == unit), key=lambda name: float(np.abs(model[name]).max())
    )
