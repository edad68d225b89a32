"""Two measurements of one machine: their modes paired pose by pose, and what changed by more than its errors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray
from scipy.special import chdtrc

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import number_or_none
from pkmodes.core.support.mac import MIN_MAC_OF_PAIR, mac_of_each, rotation_weights
from pkmodes.loop.measured.comparison import Changed, MeasurementsCompared, ModePair
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.positions import is_same_position
from pkmodes.loop.measured.same_modes import close_groups, pair_same_modes
from pkmodes.loop.measured.shape_changes import (
    AlignedShapes,
    PlaceChange,
    ShapeChange,
    align_shapes,
    shape_change,
)
from pkmodes.loop.measured.significance import (
    ADDITIONAL_LEVEL,
    CommonChange,
    common_and_own,
    holm,
    holm_threshold,
    two_sided,
)
from pkmodes.loop.measured.strain_energy import StrainEnergyChange, strain_energy_changes
from pkmodes.loop.measured.trust import (
    MIN_MAC,
    cautions_of,
    close_to_another,
    notes_on_poses,
    notes_on_shapes,
)

Array = NDArray[np.float64]
#: Rows of a mode in both files, and the MAC of its shapes.
RowPair = tuple[int, int, float | None]


def compare_measurements(first: Measurements, second: Measurements) -> MeasurementsCompared:
    """Compare two measurements of one machine, such as before and after a repair.

    Modes at one pose are paired so that frequencies and, where both have them, shapes agree best overall.

    - first, second: with poses at the same positions or with the same labels, or with a single pose each

    Raises MeasurementError if they have the same rows, no pose in common, or poses of different components, or if
    the motors were in different states at a common pose.
    """
    pose_pairs = list(_common_poses(first, second))
    if _row_contents(first) == _row_contents(second):
        problem = f"expected two measurements, found the same rows as in {first.source}"
        raise MeasurementError(problem, second.source, "give the file of the second campaign")
    rows: list[RowPair] = []
    for pose, second_pose in pose_pairs:
        rows += paired_rows(
            first, second, np.flatnonzero(first.pose == pose), np.flatnonzero(second.pose == second_pose)
        )
    rows.sort(key=lambda row: row[:2])
    shapes, energies = _compare_shapes(first, second, rows)
    pairs, common_change = _mode_pairs(first, second, rows, shapes)
    relative = np.array([pair.relative for pair in pairs])
    chi2 = float(sum(pair.sigmas**2 for pair in pairs))
    p_value = float(chdtrc(len(pairs), chi2)) if pairs else None
    return MeasurementsCompared(
        first=first.source,
        second=second.source,
        pairs=pairs,
        first_unpaired=_unpaired_lines(first, [a for a, _, _ in rows]),
        second_unpaired=_unpaired_lines(second, [b for _, b, _ in rows]),
        median_relative=float(np.median(relative)) if pairs else None,
        rms_relative=float(np.sqrt(np.mean(relative**2))) if pairs else None,
        chi2=chi2,
        p_value=p_value,
        poses=len(pose_pairs),
        changed=_kind_of_change(pairs, common_change, p_value),
        common=common_change,
        strain_energy=energies,
        notes=[*notes_on_poses(first, second, pose_pairs), *notes_on_shapes(pairs, energies)],
    )


def _row_contents(data: Measurements) -> list[str]:
    """Return the content of each row, in an order that does not depend on the file."""
    columns = {f"shape:{name}": data.shapes[:, k] for k, name in enumerate(data.channels)}
    columns |= {**data.numbers, "sigma_shape": data.shape_sigma}
    stated_columns = {name: column for name, column in sorted(columns.items()) if not np.isnan(column).all()}
    return sorted(
        repr((data.labels[pose], [(name, float(column[row])) for name, column in stated_columns.items()]))
        for row, pose in enumerate(data.pose)
    )


def _mode_pairs(
    first: Measurements, second: Measurements, rows: Sequence[RowPair], shapes: Sequence[ShapeChange | None]
) -> tuple[list[ModePair], CommonChange | None]:
    """Return the modes of both with their changes, and what these have in common."""
    a, b = np.array([row[0] for row in rows], dtype=int), np.array([row[1] for row in rows], dtype=int)
    before, after = first.frequency[a], second.frequency[b]
    sigma, sigma_after = first.sigma[a], second.sigma[b]
    sigma_of_difference = np.hypot(sigma, sigma_after)
    sigmas = (after - before) / sigma_of_difference
    differs, threshold = holm(two_sided(sigmas)), holm_threshold(len(rows))
    common_change, own_changes = common_and_own(
        np.log(after / before), np.hypot(sigma / before, sigma_after / after)
    )
    # Without a common change, every significant change of a frequency is the mode's own.
    is_common_change = common_change is not None and common_change.differs
    return [
        ModePair(
            pose=first.labels[first.pose[i]],
            second_pose=second.labels[second.pose[j]],
            first_line=int(first.lines[i]),
            second_line=int(second.lines[j]),
            first=float(before[k]),
            second=float(after[k]),
            first_sigma=float(sigma[k]),
            second_sigma=float(sigma_after[k]),
            relative=float(after[k] / before[k] - 1.0),
            sigmas=float(sigmas[k]),
            mac=mac_of_pair,
            differs=bool(differs[k]),
            mode=first.mode[i],
            noticeable=float(threshold * sigma_of_difference[k] / before[k]),
            beyond_common=number_or_none(own_changes.relative[k]),
            beyond_common_sigmas=number_or_none(own_changes.sigmas[k]),
            own_change=bool(own_changes.is_clear[k] if is_common_change else differs[k]),
            shape=shape,
            cautions=cautions_of(
                close_to_another(first, i) or close_to_another(second, j),
                mac_of_pair,
                bool(differs[k]),
                shape,
            ),
        )
        for k, ((i, j, mac_of_pair), shape) in enumerate(zip(rows, shapes, strict=True))
    ], common_change


def _kind_of_change(pairs: Sequence[ModePair], common: CommonChange | None, p_value: float | None) -> Changed:
    """Return what the frequencies show."""
    if p_value is None:
        return "no_pairs"
    single = any(pair.own_change for pair in pairs)
    if common is not None and common.differs:
        return "common_and_single" if single else "common"
    if single:
        return "single"
    return "together" if p_value <= ADDITIONAL_LEVEL else "nothing"


def _compare_shapes(
    first: Measurements, second: Measurements, rows: Sequence[RowPair]
) -> tuple[list[ShapeChange | None], list[StrainEnergyChange]]:
    """Return each pair's change of shape, and the changes of strain energy; the significant ones are marked."""
    # Pose coordinates mean a machine, whose numbered joints are in parallel, not in a line.
    in_series = not (first.points.any() or second.points.any())
    modes = [align_shapes(first, second, i, j) for i, j, _ in rows]
    changes = [None if mode is None else shape_change(mode, in_series) for mode in modes]
    shapes_by_pose: dict[int, list[tuple[int, AlignedShapes]]] = {}
    for (i, j, mac_of_pair), mode in zip(rows, modes, strict=True):
        well_separated = not (close_to_another(first, i) or close_to_another(second, j))
        if (
            in_series
            and mode is not None
            and well_separated
            and mac_of_pair is not None
            and mac_of_pair >= MIN_MAC
        ):
            shapes_by_pose.setdefault(int(first.pose[i]), []).append((int(first.lines[i]), mode))
    energies = []
    for pose, of_pose in shapes_by_pose.items():
        # A shape without errors would leave the index without a standard deviation.
        shapes_with_sigmas = [entry for entry in of_pose if np.isfinite(entry[1].sigmas).all()] or of_pose
        energies += strain_energy_changes(first.labels[pose], *zip(*shapes_with_sigmas, strict=True))
    return _mark_significant(changes, energies)


def _mark_significant(
    changes: Sequence[ShapeChange | None], energies: Sequence[StrainEnergyChange]
) -> tuple[list[ShapeChange | None], list[StrainEnergyChange]]:
    """Return the changes with the significant ones marked, tested over all channels of all shapes together."""
    shapes = [change for change in changes if change is not None]
    channels = [channel for shape in shapes for channel in (*shape.components, *shape.curvatures)]
    sigmas = [channel.sigmas for channel in channels] + [energy.sigmas for energy in energies]
    # One result for each change with a standard deviation.  The replacements below take them in the order of
    # `sigmas`: shape by shape the components and then the curvatures, and the energies last.
    significant = iter(holm(two_sided(np.array([z for z in sigmas if z is not None]))).tolist())

    def marked(channels: list[PlaceChange]) -> list[PlaceChange]:
        return [
            channel if channel.sigmas is None else msgspec.structs.replace(channel, differs=next(significant))
            for channel in channels
        ]

    return [
        change
        and msgspec.structs.replace(
            change, components=marked(change.components), curvatures=marked(change.curvatures)
        )
        for change in changes
    ], [
        energy if energy.sigmas is None else msgspec.structs.replace(energy, differs=next(significant))
        for energy in energies
    ]


def _common_poses(first: Measurements, second: Measurements) -> Iterator[tuple[int, int]]:
    """Yield the poses that both have: those at one position or with the same label, or the only pose of each."""
    is_single = len(first.labels) == len(second.labels) == 1
    pose_pairs = [(0, 0)] if is_single else _pair_poses(first, second)
    if not pose_pairs:
        problem = f"expected poses of {first.source}, such as {first.labels[0]}, found {second.labels[0]}"
        raise MeasurementError(
            problem, f"{second.source}: pose", "give the poses of both files the same labels"
        )
    if first.points.any() and second.points.any() and first.components != second.components:
        expected, actual = (", ".join(data.components) for data in (first, second))
        problem = f"expected poses given by {expected}, as in {first.source}, found {actual}"
        raise MeasurementError(problem, f"{second.source}: pose", "compare two measurements of one machine")
    for first_pose, second_pose in pose_pairs:
        expected, actual = first.drives[first_pose], second.drives[second_pose]
        if expected != actual:
            problem = f"expected motors {expected}, as in {first.source}, found {actual}"
            where = f"{second.source}: pose {second.labels[second_pose]}"
            raise MeasurementError(problem, where, "compare measurements with the motors in the same state")
        yield first_pose, second_pose


def _pair_poses(first: Measurements, second: Measurements) -> list[tuple[int, int]]:
    """Return the pairs of poses with the same label, or at the same position where the labels are of other positions.

    Two campaigns may use the same labels for other positions: where one position has two labels, labels pair nothing.
    """
    by_label = {
        i: second.labels.index(label) for i, label in enumerate(first.labels) if label in second.labels
    }
    if first.components != second.components or not (first.points.any() and second.points.any()):
        return [*by_label.items()]
    at_same_position = is_same_position(first, second).T
    pairs = {i: j for i, j in by_label.items() if at_same_position[i, j]}
    for i in range(len(first.labels)):
        conditions = first.drives[i], first.load(i)
        unpaired = [
            j
            for j in np.flatnonzero(at_same_position[i]).tolist()
            if (second.drives[j], second.load(j)) == conditions and j not in pairs.values()
        ]
        if i not in pairs and len(unpaired) == 1:
            pairs[i] = unpaired[0]
    if all(by_label.get(i) == j for i, j in pairs.items()):  # else the labels mean other positions
        pairs |= by_label
    return sorted(pairs.items())


def paired_rows(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], second_rows: NDArray[np.intp]
) -> list[RowPair]:
    """Return pairs of rows at one pose with the MAC of each, so that frequencies and shapes agree best overall.

    Rows that differ in frequency or shape by more than one mode can are no pair.

    - rows, second_rows: rows of the pose in the first and in the second measurement
    """
    log_difference = np.abs(np.log(second.frequency[second_rows][None, :] / first.frequency[rows][:, None]))
    macs = _mac_matrix(first, second, rows, second_rows)
    groups = close_groups(np.log(first.frequency[rows]), first.sigma[rows] / first.frequency[rows])
    pairs = pair_same_modes(log_difference, macs, groups, MIN_MAC_OF_PAIR)
    return [(int(rows[i]), int(second_rows[k]), mac) for i, k, mac in pairs]


def _mac_matrix(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], second_rows: NDArray[np.intp]
) -> Array:
    """Return the MAC between all rows of both, NaN where they share fewer than two components."""
    common = [name for name in first.channels if name in second.channels]
    if len(common) < 2:
        return np.full((len(rows), len(second_rows)), np.nan)
    a = first.shapes[rows][:, [first.channels.index(name) for name in common]]
    b = second.shapes[second_rows][:, [second.channels.index(name) for name in common]]
    weights = rotation_weights(common, np.vstack([a, b]))
    return mac_of_each(a * weights, b * weights)


def _unpaired_lines(data: Measurements, rows_with_partner: list[int]) -> list[int]:
    """Return the lines of the rows without a partner."""
    return [int(line) for line in np.delete(data.lines, rows_with_partner)]
