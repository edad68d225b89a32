"""The tornado chart of a robot at a pose: the quantities on which its frequencies depend most."""

from __future__ import annotations

from typing import TYPE_CHECKING

from numpy.typing import ArrayLike

from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.support.extras import require
from pkmodes.core.support.motors import motors_in_words
from pkmodes.loop.sensitivity.changes import PERCENT, Changes, changes_at
from pkmodes.pages.figures.pictures import Picture
from pkmodes.pages.plots.tornado import MAX_BARS, tornado

if TYPE_CHECKING:
    from pkmodes.core.model import Model

TITLES = {
    "percent": "What one per cent of each quantity does",
    "sigma": "What one standard deviation of each value does",
}


def tornado_picture(
    model: Model, pose: ArrayLike, *, by: str = PERCENT, drives: str | None = None
) -> Picture:
    """Draw what a change of each quantity does to each frequency of vibration at a pose.

    Parameters
    ----------
    model : Model
        The robot.
    pose : array_like, shape (d,)
        In SI units.
    by : {"percent", "sigma"}
        Each quantity changes by one per cent of its value, or by the standard deviation that the robot file states.
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Returns
    -------
    Picture
        In a notebook it shows itself.

    Raises
    ------
    PkmodesError
        If `by` is neither word, or the robot file states no standard deviation.
    PoseError
        If the pose cannot be evaluated.
    MissingExtraError
        If matplotlib is not installed.
    """
    require("tornado charts", "plot", "matplotlib")
    drives = model.robot.resolve_drives(drives)
    pose_point = model.modes(pose, fields=["frequencies"], drives=drives).poses
    changes = changes_at(model, pose_point, drives, by)
    pose_text, motor_text = (
        format_pose(model.mechanism, pose_point, "g"),
        motors_in_words(model.robot, drives),
    )
    text = f"{describe_changes(changes)} {model.robot.name} at {pose_text}, {motor_text}."
    return Picture("tornado", TITLES[by], text, tornado(changes))


def describe_changes(changes: Changes) -> str:
    """Return how to read the chart, for its caption."""
    step = (
        "one per cent of each quantity" if changes.by == PERCENT else "one standard deviation of each value"
    )
    text = (
        f"The change of each frequency for {step}, to first order, the largest on top: filled bars for more of "
        f"it, open bars for less; at most {MAX_BARS} in a panel."
    )
    if changes.combined is not None:
        text += " The grey bar is the standard deviation of the frequency from all values together."
    return text
