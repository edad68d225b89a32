"""When changed shapes of two measurements may not be taken as the place of a change."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.loop.measured.comparison import Caution, ModePair
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.shape_changes import MIN_CHANNELS, ShapeChange
from pkmodes.loop.measured.significance import SIGNIFICANCE_LEVEL
from pkmodes.loop.measured.strain_energy import StrainEnergyChange

#: Relative distance of frequencies below which any change may mix two modes.
CLOSE_FREQUENCIES = 0.03
#: Shapes with a smaller MAC may belong to different modes.
MIN_MAC = 0.9
#: Cautions with which a change of shape does not show a place; the others mean that no change can be seen.
CAUTIONS_WITHOUT_PLACE: frozenset[Caution] = frozenset({"close_modes", "low_mac"})
#: Meanings of the cautions.
SENTENCES: dict[Caution, str] = {
    "no_sigma_shape": "not both files give sigma_shape, so it is unknown whether the shape changed by more than its "
    "errors.",
    "close_modes": f"another mode is within {100.0 * CLOSE_FREQUENCIES:.0f} %; any change mixes the two, so their "
    "shapes do not show its place.",
    "low_mac": f"the MAC is below {MIN_MAC}; it may be another mode, and its shape does not show a place.",
    "same_shape": "the frequency changed, but not the shape by more than its errors: stiffness or mass changed in "
    "proportion everywhere, or by too little for these errors to show where.",
}
#: Largest number of lines named in a note.
MAX_LINES_NAMED = 8


def close_to_another(data: Measurements, row: int) -> bool:
    """Return whether another mode at the pose of a row is closer than `CLOSE_FREQUENCIES`."""
    neighbours = (data.pose == data.pose[row]) & (np.arange(len(data.pose)) != row)
    return bool((np.abs(np.log(data.frequency[neighbours] / data.frequency[row])) < CLOSE_FREQUENCIES).any())


def cautions_of(
    has_close_mode: bool, mac: float | None, differs: bool, shape: ShapeChange | None
) -> list[Caution]:
    """Return why the shape of a pair does not show where something changed.

    - has_close_mode: whether another mode is close in one of the files
    - differs: whether the frequency changed
    """
    cautions: list[Caution] = []
    if shape is None:
        cautions.append("few_channels")
    elif shape.p_value is None:
        cautions.append("no_sigma_shape")
    if has_close_mode:
        cautions.append("close_modes")
    if mac is not None and mac < MIN_MAC:
        cautions.append("low_mac")
    if differs and shape is not None and shape.p_value is not None:
        places = [*shape.components, *shape.curvatures]
        if not (shape.p_value <= SIGNIFICANCE_LEVEL or any(place.differs for place in places)):
            cautions.append("same_shape")
    return cautions


def notes_on_shapes(pairs: Sequence[ModePair], energies: Sequence[StrainEnergyChange]) -> list[str]:
    """Return when the shapes may not be trusted, in sentences."""
    notes = []
    if pairs and all(pair.shape is None for pair in pairs):
        notes.append(
            f"No mode has a shape at {MIN_CHANNELS} or more channels of both files: shapes do not show where "
            "anything changed."
        )
    elif lines := _line_list(pairs, "few_channels"):
        notes.append(f"{lines}: no shape at {MIN_CHANNELS} or more channels of both files.")
    notes += [
        f"{lines}: {why}" for caution, why in SENTENCES.items() if (lines := _line_list(pairs, caution))
    ]
    trusted = [
        pair.shape for pair in pairs if pair.shape and not CAUTIONS_WITHOUT_PLACE.intersection(pair.cautions)
    ]
    curvature_differs = any(place.differs for shape in trusted for place in shape.curvatures)
    if curvature_differs or any(energy.differs for energy in energies):
        notes.append(
            "Numbered channels are taken as a series along a line, in the order of their numbers and at equal "
            "distances; if they are not, curvature and strain energy mean nothing. If a mass changed, strain energy "
            "moves too, and the place is not that of the mass."
        )
    if curvature_differs:
        notes.append(
            "A curvature has about 2.4 times (the root of 6) the noise of a component: trust it only where it is "
            "clear."
        )
    return notes


def _line_list(pairs: Sequence[ModePair], caution: str) -> str:
    """Return the lines of the first file with a caution in words; empty without any."""
    lines = [str(pair.first_line) for pair in pairs if caution in pair.cautions]
    if not lines:
        return ""
    shown = ", ".join(lines[:MAX_LINES_NAMED]) + (
        f" and {len(lines) - MAX_LINES_NAMED} more" if len(lines) > MAX_LINES_NAMED else ""
    )
    return f"{'Line' if len(lines) == 1 else 'Lines'} {shown} of the first file"


def notes_on_poses(
    first: Measurements, second: Measurements, pose_pairs: Sequence[tuple[int, int]]
) -> list[str]:
    """Return the poses at which the two measurements were made in different conditions, in sentences."""
    notes = []
    loaded_labels = [first.labels[i] for i, j in pose_pairs if first.load(i) != second.load(j)]
    if loaded_labels:
        notes.append(
            f"Pose {loaded_labels[0]}{_and_others(loaded_labels)}: columns set: differ; the changes include the "
            "effect of the other load."
        )
    renamed = [(first.labels[i], second.labels[j]) for i, j in pose_pairs if len(pose_pairs) > 1]
    renamed = [(label, other) for label, other in renamed if label != other]
    if renamed:
        label, other = renamed[0]
        notes.append(
            f"Pose {label} of the first file is paired with {other} of the second"
            f"{f', and {len(renamed) - 1} more in this way' if len(renamed) > 1 else ''}: they are at the same "
            "position under different labels."
        )
    moved_labels = [first.labels[i] for i, j in pose_pairs if _positions_differ(first, second, i, j)]
    if moved_labels:
        notes.append(
            f"Pose {moved_labels[0]}{_and_others(moved_labels)}: the positions differ; the changes include the "
            "effect of the other position."
        )
    return notes


def _and_others(labels: Sequence[str]) -> str:
    return f" and {len(labels) - 1} more" if len(labels) > 1 else ""


def _positions_differ(first: Measurements, second: Measurements, pose: int, second_pose: int) -> bool:
    """Return whether both give a position and these differ by more than their errors."""
    a, b = first.points[pose], second.points[second_pose]
    if not (first.points.any() and second.points.any()):
        return False
    errors = np.hypot(first.point_sigma[pose], second.point_sigma[second_pose])
    return bool((np.abs(b - a) > 3.0 * errors + 1e-6).any())
