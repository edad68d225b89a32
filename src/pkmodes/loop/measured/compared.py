"""Two measurements of one machine: their modes paired pose by pose, and what changed by more than its errors."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

import msgspec
import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.special import chdtrc

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.support.mac import mac, normalised
from pkmodes.loop.measured.comparison import Changed, MeasurementsCompared, ModePair
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.shape_changes import Aligned, PlaceChange, ShapeChange, aligned, shape_change
from pkmodes.loop.measured.significance import (
    BESIDE,
    CommonChange,
    common_and_own,
    first_refused,
    holm,
    two_sided,
)
from pkmodes.loop.measured.strain_energy import StrainEnergyChange, strain_energy_changes
from pkmodes.loop.measured.trust import (
    LEAST_MAC,
    cautions_of,
    close_to_another,
    notes_on_poses,
    notes_on_shapes,
)

Array = NDArray[np.float64]
#: Rows of a mode in both files, and the MAC of its shapes.
Rows = tuple[int, int, float | None]
#: Largest relative difference between the frequencies of one mode, and the difference that costs as much as shapes
#: with a MAC of 0.
FARTHEST, ALIKE = 0.25, 0.1


def compare_measurements(first: Measurements, second: Measurements) -> MeasurementsCompared:
    """Compare two measurements of one machine, such as before and after a repair.

    Modes at one pose are paired so that frequencies and, where both have them, shapes agree best in all.

    - first, second: at poses of the same labels, or of one position each under any label

    Raises MeasurementError if they have the same rows, no pose in common, other components of a pose, or the motors
    did another thing there.
    """
    places = list(_common(first, second))
    if _content(first) == _content(second):
        problem = f"expected two measurements, found the same rows as in {first.source}"
        raise MeasurementError(problem, second.source, "give the file of the second campaign")
    rows: list[Rows] = []
    for pose, second_pose in places:
        rows += paired_rows(
            first, second, np.flatnonzero(first.pose == pose), np.flatnonzero(second.pose == second_pose)
        )
    rows.sort(key=lambda row: row[:2])
    shapes, energies = _shapes_compared(first, second, rows)
    pairs, common = _pairs(first, second, rows, shapes)
    relative = np.array([pair.relative for pair in pairs])
    total = float(sum(pair.sigmas**2 for pair in pairs))
    p_value = float(chdtrc(len(pairs), total)) if pairs else None
    return MeasurementsCompared(
        first=first.source,
        second=second.source,
        pairs=pairs,
        first_unpaired=_unpaired_lines(first, [a for a, _, _ in rows]),
        second_unpaired=_unpaired_lines(second, [b for _, b, _ in rows]),
        median_relative=float(np.median(relative)) if pairs else None,
        rms_relative=float(np.sqrt(np.mean(relative**2))) if pairs else None,
        chi2=total,
        p_value=p_value,
        poses=len(places),
        changed=_changed(pairs, common, p_value),
        common=common,
        strain_energy=energies,
        notes=[*notes_on_poses(first, second, places), *notes_on_shapes(pairs, energies)],
    )


def _content(data: Measurements) -> list[str]:
    """Return the content of each row, in an order that does not depend on the file."""
    columns = {f"shape:{name}": data.shapes[:, k] for k, name in enumerate(data.channels)}
    columns |= {**data.numbers, "sigma_shape": data.shape_sigma}
    stated = {name: column for name, column in sorted(columns.items()) if not np.isnan(column).all()}
    return sorted(
        repr((data.labels[pose], [(name, float(column[row])) for name, column in stated.items()]))
        for row, pose in enumerate(data.pose)
    )


def _pairs(
    first: Measurements, second: Measurements, rows: Sequence[Rows], shapes: Sequence[ShapeChange | None]
) -> tuple[list[ModePair], CommonChange | None]:
    """Return the modes of both with their changes, and what these have in common."""
    a, b = np.array([row[0] for row in rows], dtype=int), np.array([row[1] for row in rows], dtype=int)
    before, after = first.frequency[a], second.frequency[b]
    sigma, sigma_after = first.sigma[a], second.sigma[b]
    spread = np.hypot(sigma, sigma_after)
    sigmas = (after - before) / spread
    differs, least = holm(two_sided(sigmas)), first_refused(len(rows))
    common, own_changes = common_and_own(
        np.log(after / before), np.hypot(sigma / before, sigma_after / after)
    )
    shared = common is not None and common.differs
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
            mac=alike,
            differs=bool(differs[k]),
            mode=first.mode[i],
            noticeable=float(least * spread[k] / before[k]),
            beyond_common=_number_or_none(own_changes.relative[k]),
            beyond_common_sigmas=_number_or_none(own_changes.sigmas[k]),
            own_change=bool(own_changes.clear[k] if shared else differs[k]),
            shape=shape,
            cautions=cautions_of(
                close_to_another(first, i) or close_to_another(second, j), alike, bool(differs[k]), shape
            ),
        )
        for k, ((i, j, alike), shape) in enumerate(zip(rows, shapes, strict=True))
    ], common


def _number_or_none(number: float) -> float | None:
    """Return a number, or None for NaN."""
    return float(number) if np.isfinite(number) else None


def _changed(pairs: Sequence[ModePair], common: CommonChange | None, p_value: float | None) -> Changed:
    """Return what the frequencies show."""
    if p_value is None:
        return "no_pairs"
    single = any(pair.own_change for pair in pairs)
    if common is not None and common.differs:
        return "common_and_single" if single else "common"
    if single:
        return "single"
    return "together" if p_value <= BESIDE else "nothing"


def _shapes_compared(
    first: Measurements, second: Measurements, rows: Sequence[Rows]
) -> tuple[list[ShapeChange | None], list[StrainEnergyChange]]:
    """Return the change of each pair's shape, and of the strain energy at each pose, with what of these is clear."""
    # Where positions are given, it is a machine: its numbered joints stand beside each other.
    chain = not (first.points.any() or second.points.any())
    modes = [aligned(first, second, i, j) for i, j, _ in rows]
    changes = [None if mode is None else shape_change(mode, chain) for mode in modes]
    usable: dict[int, list[tuple[int, Aligned]]] = {}
    for (i, j, alike), mode in zip(rows, modes, strict=True):
        apart = not (close_to_another(first, i) or close_to_another(second, j))
        if chain and mode is not None and apart and alike is not None and alike >= LEAST_MAC:
            usable.setdefault(int(first.pose[i]), []).append((int(first.lines[i]), mode))
    energies = []
    for pose, of_pose in usable.items():
        stated = [entry for entry in of_pose if np.isfinite(entry[1].errors).all()] or of_pose
        energies += strain_energy_changes(first.labels[pose], *zip(*stated, strict=True))
    return _clear(changes, energies)


def _clear(
    changes: Sequence[ShapeChange | None], energies: Sequence[StrainEnergyChange]
) -> tuple[list[ShapeChange | None], list[StrainEnergyChange]]:
    """Return the changes with what differs, all places of all shapes taken together."""
    shapes = [change for change in changes if change is not None]
    places = [place for shape in shapes for place in (*shape.components, *shape.curvatures)]
    sigmas = [place.sigmas for place in places] + [energy.sigmas for energy in energies]
    clear = iter(holm(two_sided(np.array([z for z in sigmas if z is not None]))).tolist())

    def marked(places: list[PlaceChange]) -> list[PlaceChange]:
        return [
            place if place.sigmas is None else msgspec.structs.replace(place, differs=next(clear))
            for place in places
        ]

    return [
        change
        and msgspec.structs.replace(
            change, components=marked(change.components), curvatures=marked(change.curvatures)
        )
        for change in changes
    ], [
        energy if energy.sigmas is None else msgspec.structs.replace(energy, differs=next(clear))
        for energy in energies
    ]


def _common(first: Measurements, second: Measurements) -> Iterator[tuple[int, int]]:
    """Yield the poses that both have: those with the same label, or the only pose of each."""
    if len(first.labels) == len(second.labels) == 1:
        places = [(0, 0)]
    else:
        places = [
            (i, second.labels.index(label)) for i, label in enumerate(first.labels) if label in second.labels
        ]
    if not places:
        problem = f"expected poses of {first.source}, such as {first.labels[0]}, found {second.labels[0]}"
        raise MeasurementError(
            problem, f"{second.source}: pose", "give the poses of both files the same labels"
        )
    if first.points.any() and second.points.any() and first.components != second.components:
        expected, actual = (", ".join(data.components) for data in (first, second))
        problem = f"expected poses given by {expected}, as in {first.source}, found {actual}"
        raise MeasurementError(problem, f"{second.source}: pose", "compare two measurements of one machine")
    for first_pose, second_pose in places:
        expected, actual = first.drives[first_pose], second.drives[second_pose]
        if expected != actual:
            problem = f"expected motors {expected}, as in {first.source}, found {actual}"
            where = f"{second.source}: pose {second.labels[second_pose]}"
            raise MeasurementError(problem, where, "compare measurements with the motors in the same state")
        yield first_pose, second_pose


def paired_rows(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], second_rows: NDArray[np.intp]
) -> list[Rows]:
    """Return pairs of rows at one pose with the MAC of each, so that frequencies and shapes agree best in all.

    - rows, second_rows: of the pose, in the first and in the second measurement
    """
    apart = np.abs(np.log(second.frequency[second_rows][None, :] / first.frequency[rows][:, None]))
    alike = _alike(first, second, rows, second_rows)
    cost = apart / ALIKE + np.where(np.isfinite(alike), 1.0 - alike, 0.0)
    far = apart > FARTHEST
    chosen = zip(*linear_sum_assignment(np.where(far, 1e6, cost)), strict=True)
    return [
        (int(rows[i]), int(second_rows[j]), float(alike[i, j]) if np.isfinite(alike[i, j]) else None)
        for i, j in chosen
        if not far[i, j]
    ]


def _alike(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], second_rows: NDArray[np.intp]
) -> Array:
    """Return the MAC between all rows of both, NaN where they share fewer than two components."""
    common = [name for name in first.channels if name in second.channels]
    macs = np.full((len(rows), len(second_rows)), np.nan)
    if len(common) < 2:
        return macs
    a = first.shapes[rows][:, [first.channels.index(name) for name in common]]
    b = second.shapes[second_rows][:, [second.channels.index(name) for name in common]]
    for j, shape in enumerate(b):
        shared = np.isfinite(a) & np.isfinite(shape)
        first_shapes = normalised(np.where(shared, a, np.nan))
        macs[:, j] = mac(first_shapes, normalised(shape)[None, :], shared)[:, 0]
    return macs


def _unpaired_lines(data: Measurements, paired: list[int]) -> list[int]:
    """Return the lines of the rows without a partner."""
    return [int(line) for line in np.delete(data.lines, paired)]
