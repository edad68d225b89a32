"""Figures of what shapers leave: over the workspace, and where frequencies differ from those of the model."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.pages.plots import shapers
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.report.blocks import Paragraph, Picture
from pkmodes.pages.report.formatting import clean
from pkmodes.pages.report.shaper_curves import MAX_CURVES

if TYPE_CHECKING:
    from pkmodes.core.model import Model
    from pkmodes.machine.shaping.results import Candidate, Choice

#: Relative errors of the frequencies in the figure of their errors.
FREQUENCY_ERRORS = np.linspace(-0.2, 0.2, 81)
#: Maximum number of poses at which shapers are evaluated over the frequency error.
MAX_POSES = 400
#: Poses whose components differ by less than this lie in one layer [SI].
LAYER_TOLERANCE = 1e-9
#: Where less than this is left everywhere [%], a map would have a single colour.
MIN_DRAWN_PERCENT = 0.05
#: Smallest number of poses in a layer, relative to that in a layer of a regular grid.
MIN_LAYER_SHARE = 0.3


def workspace_picture(model: Model, choice: Choice, axis: str = "") -> Picture | Paragraph:
    """Return what the compared shapers leave over the workspace; of a single pose, a sentence."""
    ringing, components = choice.ringing, model.mechanism.pose
    worst = choice.best.left
    pose_indices = np.arange(len(ringing.poses))
    if worst.setting is not None:
        setting_index = ringing.settings.index(worst.setting)
        pose_indices, ringing = np.flatnonzero(ringing.setting == setting_index), ringing.only(setting_index)
    varying = [i for i in range(len(components)) if np.ptp(ringing.poses[:, i]) > LAYER_TOLERANCE]
    shares = {
        name: 100.0 * candidate.left_at[pose_indices] * ringing.unshaped / choice.unshaped.worst
        for name, candidate in _compared_shapers(choice).items()
    }
    if not varying:
        share = ", ".join(
            f"{name}: {percent_or_nothing(values[0] / 100.0)}" for name, values in shares.items()
        )
        return Paragraph(f"There is only one pose. Left of the vibration there{_axis_phrase(axis)}: {share}.")
    vanishing = [name for name, values in shares.items() if values.max() < MIN_DRAWN_PERCENT]
    shares = {name: values for name, values in shares.items() if name not in vanishing} or shares
    component_names = [components[i].name for i in varying]
    units = [DISPLAY_UNITS[components[i].unit] for i in varying]
    caption = f"Vibration that is left{_axis_phrase(axis)}, in per cent of the largest one without a shaper"
    if len(choice.ringing.settings) > 1:
        caption += f", at {clean(worst.setting)}, where the recommended shaper leaves most"
    move_note = ". A shaper that follows the pose is judged at rest; a move adds to it."
    if vanishing and len(shares) < len(_compared_shapers(choice)):
        vanishing_names = " and ".join(vanishing).replace(",", "")
        move_note = f". At rest, {vanishing_names} leaves nothing anywhere; a move adds to it."
    if len(varying) == 1:
        drawing = shapers.along_line(ringing.poses[:, varying[0]], component_names[0], units[0], shares)
    else:
        in_layer, layer_position = _layer_through(ringing.poses, worst.pose, varying[2:])
        for i, value in layer_position.items():
            unit, factor = DISPLAY_UNITS[components[i].unit]
            caption += f", at {components[i].name} = {typeset(f'{value * factor:.4g}')} {unit}"
        caption += ", where the recommended shaper leaves most" if layer_position else ""
        drawing = shapers.over_plane(
            ringing.poses[in_layer][:, varying[:2]],
            component_names,
            units,
            {name: share[in_layer] for name, share in shares.items()},
        )
    return Picture.from_drawing(
        drawing, f"Left over the workspace{_axis_phrase(axis)}", caption + move_note, caption + move_note
    )


def frequency_error_picture(choice: Choice, axis: str = "") -> Picture:
    """Return what the compared shapers leave where all frequencies differ from those of the model by one share."""
    ringing = choice.ringing
    sample = np.unique(np.linspace(0, len(ringing.poses) - 1, MAX_POSES).astype(int))
    frequencies, ratios = ringing.frequencies[sample], ringing.damping_ratios[sample]
    weights = ringing.weights[sample]
    unshaped_rms = np.sqrt(np.mean(np.sum(weights**2, axis=1)))
    fixed = sorted(
        (candidate for candidate in choice.candidates if not candidate.follows_pose),
        key=lambda candidate: candidate.left.worst,
    )
    drawn_shapers = {
        **_compared_shapers(choice),
        **{f"{candidate.kind}, fixed": candidate for candidate in fixed[:MAX_CURVES]},
    }
    remaining = {}
    for name, candidate in list(drawn_shapers.items())[:MAX_CURVES]:
        impulses = candidate.shaper
        if candidate.follows_pose:
            impulses = type(impulses)(impulses.amplitudes[sample], impulses.delays[sample])
        mode_residuals = np.array(
            [residual(impulses, frequencies * (1.0 + error), ratios) for error in FREQUENCY_ERRORS]
        )
        remaining[name] = (
            100.0 * np.sqrt(np.mean(np.sum((weights * mode_residuals) ** 2, axis=2), axis=1)) / unshaped_rms
        )
    caption = (
        f"Root mean square over the {ringing.points_are} of the vibration{_axis_phrase(axis)} that is left if all "
        "frequencies differ from those of the model by the same share. Belts that are 10 % stiffer raise them by "
        "5 %."
    )
    spread = None if ringing.spread is None else float(ringing.spread.mean())
    if spread is not None:
        caption += " The band is the mean standard deviation of the frequencies."
    title = f"Against frequency error{_axis_phrase(axis)}"
    return Picture.from_drawing(
        shapers.against_error(FREQUENCY_ERRORS, remaining, spread), title, caption, caption
    )


def _compared_shapers(choice: Choice) -> dict[str, Candidate]:
    """Return the recommended shaper, and the best one that follows the pose."""
    best = choice.best
    compared = {f"{best.kind}, fixed": best}
    following = [candidate for candidate in choice.candidates if candidate.follows_pose]
    if following:
        follower = min(following, key=lambda candidate: (round(candidate.left.worst, 6), candidate.duration))
        compared[f"{follower.kind}, of the {choice.ringing.point_is}"] = follower
    return compared


def _layer_through(
    poses: NDArray[np.float64], pose: NDArray[np.float64], normals: Sequence[int]
) -> tuple[NDArray[np.bool_], dict[int, float]]:
    """Return the poses in the layer through one of them, and its place; all poses where they form no layers."""
    in_layer = np.asarray((np.abs(poses[:, normals] - pose[normals]) < LAYER_TOLERANCE).all(axis=1))
    if in_layer.sum() < MIN_LAYER_SHARE * len(poses) ** (2.0 / (2 + len(normals))):
        return np.ones(len(poses), dtype=bool), {}
    return in_layer, {i: float(pose[i]) for i in normals}


def _axis_phrase(axis: str) -> str:
    """Return the axis that something is for, in words; empty for all."""
    return f" along {axis}" if axis else ""


def percent_or_nothing(share: float) -> str:
    """Return a share of the vibration in per cent; "nothing" below a millionth."""
    return f"{plain(100.0 * share, 3)} %" if share >= 1e-6 else "nothing"
