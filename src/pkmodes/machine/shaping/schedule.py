"""A schedule: for each setting of a machine, such as each payload, the fixed shaper that suits its poses.

A firmware has one shaper at a time, and cannot see a payload; but a print grows with its layers, so that the lines of
a schedule can be placed at their layers.  Each shaper serves until halfway to the next setting.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import Constraint, check_argument, is_number
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.numbers import plain
from pkmodes.core.model import Model
from pkmodes.core.support.ordering import joined, listed
from pkmodes.core.support.progress import report_progress
from pkmodes.machine.shaping.choice import choose, relative, relative_at_pose, shaped_by
from pkmodes.machine.shaping.firmware import FIRMWARE_TITLES
from pkmodes.machine.shaping.results import Choice, Schedule, Step
from pkmodes.machine.shaping.ringing import Ringing, at_settings
from pkmodes.machine.shaping.settings import Setting
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]
#: Maximum number of settings named in a note.
MAX_SETTINGS_NAMED = 4


def _are_heights(value: Any) -> bool:
    pair = isinstance(value, Sequence | np.ndarray) and not isinstance(value, str) and len(value) == 2
    return pair and all(map(is_number, value)) and 0.0 <= value[0] < value[1] < np.inf


HEIGHTS = Constraint("two heights in m, the lower one first", _are_heights)


def schedule_of(
    model: Model,
    poses: ArrayLike,
    overall_choice: Choice,
    kinds: Iterable[str] | None,
    tick: float,
    height: Sequence[float] | None,
    axis: str = "",
) -> Schedule:
    """Choose a fixed shaper for each setting, by the rule of the choice for all of them.

    - model: the evaluator of the robot
    - poses: poses of the choice, (..., d)
    - overall_choice: choice for all settings
    - kinds: kinds of the choice
    - tick: tick of the choice [s]
    - height: layer heights of the first and of the last value [m], between which the parameter grows evenly
    - axis: axis of the choice, where it is for one of several independent axes

    Raises PkmodesError if no shaper is long or short enough at a setting.
    """
    ringing = overall_choice.ringing
    parameter = varying(ringing.settings)
    choices = []
    for i, setting in enumerate(ringing.settings):
        report_progress(f"setting {i + 1} of {len(ringing.settings)}: {setting}")
        limits: Any = {
            "left": overall_choice.left,
            "length": overall_choice.length,
            "firmware": overall_choice.firmware,
        }
        try:
            choices.append(choose(ringing.only(i), kinds, tick=tick, follow=False, **limits))
        except PkmodesError as error:
            raise type(error)(f"at {setting}: {error.what}", error.where, error.remedy) from None
    best = [choice.best.shaper for choice in choices]
    scheduled = each_setting(best, ringing)
    serves, ends = _between(model, poses, ringing, parameter, best, axis)
    heights = []  # of the layers between which each shaper serves
    if serves and height is not None:
        values, layers = (serves[0][0], serves[-1][1]), tuple(map(float, height))
        heights = [
            (float(np.interp(a, values, layers)), float(np.interp(b, values, layers))) for a, b in serves
        ]
    fixed_shaper = overall_choice.best.shaper
    steps = [
        Step(
            setting,
            choice,
            float(shaped_by(fixed_shaper, choice.ringing).max() / choice.unshaped.worst),
            serves[i] if serves else None,
            ends[i] if ends else None,
            heights[i] if heights else None,
        )
        for i, (setting, choice) in enumerate(zip(ringing.settings, choices, strict=True))
    ]
    shaped = shaped_by(scheduled, ringing)
    left, left_at_pose = relative(scheduled, ringing, shaped), relative_at_pose(scheduled, ringing, shaped)
    return Schedule(tuple(steps), parameter, left, left_at_pose, axis)


def varying(settings: Sequence[Setting]) -> str | None:
    """Return the path of the only parameter that has several values; None if there is not exactly one."""
    paths = settings[0].values if settings else ()
    several = [path for path in paths if len({setting.values[path] for setting in settings}) > 1]
    return several[0] if len(several) == 1 else None


def check_heights(height: Any, parameter: str | None) -> None:
    """Refuse anything but the heights of the first and the last value of a single parameter.

    Raises PkmodesError.
    """
    check_argument(height, HEIGHTS, "height", "for example: (0.0, 0.2)")
    if parameter is None:
        problem = (
            "layer heights belong to one parameter that takes several values, but there is not exactly one"
        )
        raise PkmodesError(problem, "height", "give several values to one parameter, such as a payload")


def each_setting(shapers: Sequence[Shaper], ringing: Ringing) -> Shaper:
    """Return the shaper of each operating point, (N, n): shorter ones get impulses of nothing at their end."""
    count = max(shaper.delays.shape[-1] for shaper in shapers)
    padding = [(0, count - shaper.delays.shape[-1]) for shaper in shapers]
    pairs = list(zip(shapers, padding, strict=True))
    amplitudes = np.array([np.pad(shaper.amplitudes, pad) for shaper, pad in pairs])
    delays = np.array([np.pad(shaper.delays, pad, mode="edge") for shaper, pad in pairs])
    return Shaper(amplitudes[ringing.setting], delays[ringing.setting])


def _between(
    model: Model, poses: ArrayLike, ringing: Ringing, parameter: str | None, best: Sequence[Shaper], axis: str
) -> tuple[list[tuple[float, float]], list[float]]:
    """Return the values between which each shaper serves, and the most that it leaves halfway to its neighbours.

    Both are empty where several parameters vary.
    """
    if parameter is None:
        return [], []
    values = [setting.values[parameter] for setting in ringing.settings]
    halfway = [0.5 * (low + high) for low, high in pairwise(values)]
    first = ringing.settings[0]
    halfway_ringing = at_settings(
        model,
        poses,
        ringing.counted,
        [Setting({**first.values, parameter: value}, first.units) for value in halfway],
        ringing.drives,
    )
    if axis:
        halfway_ringing = halfway_ringing.by_axis()[axis]
    ends = [0.0] * len(values)
    for k in range(len(halfway)):
        setting_ringing = halfway_ringing.only(k)
        for i in (k, k + 1):
            ends[i] = max(
                ends[i], float(shaped_by(best[i], setting_ringing).max() / setting_ringing.unshaped.max())
            )
    return list(pairwise([values[0], *halfway, values[-1]])), ends


def notes_of(schedule: Schedule) -> list[str]:
    """Return notes on the schedule for the reader."""
    notes, limit = [], f"{plain(100 * schedule.steps[0].choice.left, 3)} %"
    poor = [str(step.setting) for step in schedule.steps if not step.good]
    of_axis = f" of {schedule.axis}" if schedule.axis else ""
    if poor:
        notes.append(
            f"at {listed(poor, MAX_SETTINGS_NAMED, '; ')} no fixed shaper{of_axis} leaves at most {limit} of the "
            "largest vibration: the best one is scheduled"
        )
    ends = max((step.at_ends for step in schedule.steps if step.at_ends is not None), default=0.0)
    if ends > max(schedule.steps[0].choice.left, *(step.best.left.worst for step in schedule.steps)):
        notes.append(
            f"halfway between two settings the schedule{of_axis} leaves up to {plain(100 * ends, 2)} %: "
            "give more values"
        )
    shapers = {FIRMWARE_TITLES[name]: schedule.shapers_in(name) for name in FIRMWARE_TITLES}
    if schedule.axis and (unserved := [title for title, kinds in shapers.items() if kinds is None]):
        notes.append(
            f"no schedule{of_axis} for {joined(unserved)}: it has no shaper for {schedule.axis} by itself"
        )
    titles = [
        title
        for name, title in FIRMWARE_TITLES.items()
        if shapers[title] is not None and schedule.differs_in(name)
    ]
    if titles and schedule.steps[0].choice.firmware is None:
        notes.append(
            f"{joined(titles)} lack{'s' if len(titles) == 1 else ''} a shaper of the schedule{of_axis}: lines have "
            "the best shapers that there are instead; --firmware NAME schedules only shapers that this firmware has"
        )
    if schedule.steps[0].heights is not None:
        notes.append(
            f"the heights are those of a print with which {schedule.parameter} grows evenly, such as one with the "
            "same cross-section in every layer"
        )
    return notes
