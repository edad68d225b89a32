"""Shapers for a robot: compared over poses, and over settings such as payloads."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from numpy.typing import ArrayLike

from pkmodes.core.model import Model
from pkmodes.machine.shaping.choice import NONE_GOOD_ENOUGH, TICK, choices_by_axis, choose, kinds_for
from pkmodes.machine.shaping.results import GOOD_ENOUGH_SHARE, Choice
from pkmodes.machine.shaping.ringing import evaluate_ringing
from pkmodes.machine.shaping.schedule import check_heights, notes_of, schedule_of, varying


def shapers_over(
    model: Model,
    poses: ArrayLike,
    kinds: Sequence[str] | None = None,
    *,
    modes: int | None = None,
    left: float = GOOD_ENOUGH_SHARE,
    length: float | None = None,
    tick: float = TICK,
    firmware: str | None = None,
    settings: Mapping[str, Any] | None = None,
    height: Sequence[float] | None = None,
    drives: str | None = None,
) -> Choice:
    """Compare shapers over poses: the best fixed one of each kind, and those that follow the pose.

    Where parameters take several values in use, as a payload does, poses times settings count, and a schedule has the
    best fixed shaper of each setting.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (..., d)
        Such as a grid over the workspace; those that cannot be evaluated, or at which a mode does not oscillate,
        are left out.
    kinds : str or sequence of str, optional
        By default all for one mode, and products of zv up to the number of modes.
    modes : int, optional
        The lowest modes that count; by default three.
    left : float
        Share of the largest vibration that a fixed shaper may leave to be good enough.
    length : float, optional
        Longest duration of a shaper [s].
    tick : float
        Time between two commands of the controller [s]; shapers shorter than two ticks are left out.
    firmware : {"klipper", "marlin", "reprapfirmware"}, optional
        Compare shapers as its current version makes them, and recommend one that it has.  Older ones are
        ``"klipper-2025-09"``, ``"klipper-2025-08"``, ``"marlin-2025-09"`` and ``"reprapfirmware-3.5"``.
    settings : mapping of str to array_like, optional
        Values of parameters in SI units by path, such as ``{"effects.payload.mass": [0.0, 0.5, 1.0]}``; every
        combination counts.
    height : sequence of two float, optional
        Layer heights of the lowest and of the highest value [m], between which the one parameter with several values
        grows evenly.
    drives : {"free", "held"}, optional
        What the motors do: by default they give way on the springs that the robot file has for them
        (``[effects.servo_stiffness]``), "free", and are held without any.

    Returns
    -------
    Choice
        ``candidates``, and ``recommended``: the index of the shortest fixed shaper that is good enough, else of
        that whose largest remaining vibration is smallest.  At no pose those that follow it leave more than fixed
        ones.
        ``schedule``, with several settings: the shaper of each, chosen by the same rule over its poses.
        ``by_axis``, where the axes are independent, as those of a bed slinger: the choice for each axis, with a
        schedule if its frequencies change with the settings.

    Raises
    ------
    PkmodesError
        If an argument is invalid, no fixed shaper is long or short enough, or the firmware has none of them; or if
        motors that nothing holds are to be free.
    RobotFileError
        If a robot file with a setting would be rejected.
    PoseError
        If no pose can be evaluated.
    """
    ringing = evaluate_ringing(model, poses, modes, settings, drives)
    if height is not None:
        check_heights(height, varying(ringing.settings))
    if kinds is not None and not isinstance(kinds, str):
        kinds = tuple(kinds)
    overall_choice = choose(ringing, kinds, left=left, length=length, tick=tick, firmware=firmware)
    by_axis = choices_by_axis(overall_choice, kinds, tick)
    if len(ringing.settings) > 1:
        schedule = schedule_of(model, poses, overall_choice, kinds, tick, height)
        for axis, choice in by_axis.items():
            if choice.ringing.changes_with_settings:
                usable = kinds_for(choice.ringing, kinds)
                scheduled = schedule_of(model, poses, choice, usable, tick, height, axis)
                by_axis[axis] = replace(choice, schedule=scheduled)
        overall_choice = replace(overall_choice, schedule=schedule)
    notes = list(overall_choice.notes)
    if by_axis:  # one shaper for all axes is not what is recommended
        notes = [note for note in notes if not note.startswith(NONE_GOOD_ENOUGH)]
        notes += [
            f"on {axis} {note}"
            for axis, axis_choice in by_axis.items()
            for note in axis_choice.notes
            if note.startswith(NONE_GOOD_ENOUGH)
        ]
    overall_choice = replace(overall_choice, by_axis=by_axis)
    for axis_choice in overall_choice.parts.values():
        if axis_choice.schedule is not None:
            notes += notes_of(axis_choice.schedule)
    return replace(overall_choice, notes=tuple(notes))
