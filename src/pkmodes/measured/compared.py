"""Two measurements of one machine: their modes paired pose by pose, and what changed by more than its errors."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment
from scipy.stats import chi2, norm

from pkmodes.core.base.errors import MeasurementError
from pkmodes.measured.measurements import Measurements
from pkmodes.support.documents import Count, Document, Number, Probability, Size
from pkmodes.support.mac import mac, normalised

Array = NDArray[np.float64]
#: Largest relative difference of the frequencies of one mode, and how much of it counts as much as shapes without
#: anything in common.
FARTHEST, ALIKE = 0.25, 0.1
#: Level at which a mode differs, all pairs together.
LEVEL = 0.01


class ModePair(Document, frozen=True):
    """A mode in both measurements."""

    pose: Annotated[str, Meta(description="Label of its pose in the first file.")]
    second_pose: Annotated[str, Meta(description="Label in the second file.")]
    first_line: Annotated[Number, Meta(description="Its line in the first file.")]
    second_line: Annotated[Number, Meta(description="Its line in the second file.")]
    first: Annotated[Size, Meta(description="Frequency [Hz].")]
    second: Annotated[Size, Meta(description="Frequency [Hz].")]
    first_sigma: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    second_sigma: Annotated[Size, Meta(description="Its standard deviation [Hz].")]
    relative: Annotated[float, Meta(description="second / first - 1.")]
    sigmas: Annotated[float, Meta(description="second - first, in standard deviations of the difference.")]
    mac: Annotated[float | None, Meta(description="Modal assurance criterion; null without shapes in both.")]
    differs: Annotated[
        bool,
        Meta(description="Whether it differs at the level of 1 % of all pairs together (Holm's procedure)."),
    ]


class MeasurementsCompared(Document, frozen=True):
    """Two measurement files, compared."""

    first: Annotated[str, Meta(description="The first file.")]
    second: Annotated[str, Meta(description="The second file.")]
    pairs: Annotated[list[ModePair], Meta(description="In the order of the first file.")]
    first_unpaired: Annotated[list[Number], Meta(description="Lines of the first file without a partner.")]
    second_unpaired: Annotated[list[Number], Meta(description="Lines of the second file without a partner.")]
    median_relative: Annotated[
        float | None, Meta(description="Median of second / first - 1; null without pairs.")
    ]
    rms_relative: Annotated[Size | None, Meta(description="Root mean square of it.")]
    chi2: Annotated[Size, Meta(description="Sum of the squares of sigmas.")]
    p_value: Annotated[
        Probability | None,
        Meta(description="Of chi2 if nothing differs and the stated errors are independent."),
    ]
    poses: Annotated[Count, Meta(description="Poses of the first file with a partner.")]


def compare_measurements(first: Measurements, second: Measurements) -> MeasurementsCompared:
    """Compare two measurements of one machine, such as before and after a repair.

    Modes at one pose are paired so that frequencies and, where both have them, shapes agree best in all.

    Parameters
    ----------
    first, second : Measurements
        At poses of the same labels, or of one position each under any label.

    Raises
    ------
    MeasurementError
        If they have no pose in common, or the motors did another thing there.
    """
    places = list(_common(first, second))
    found: list[tuple[int, int, float | None]] = []
    for one, other in places:
        found += paired_rows(
            first, second, np.flatnonzero(first.pose == one), np.flatnonzero(second.pose == other)
        )
    found.sort()
    differences = [
        (second.frequency[b] - first.frequency[a]) / np.hypot(first.sigma[a], second.sigma[b])
        for a, b, _ in found
    ]
    significant = _holm(2.0 * norm.sf(np.abs(differences)))
    pairs = [
        ModePair(
            pose=first.labels[first.pose[a]],
            second_pose=second.labels[second.pose[b]],
            first_line=int(first.lines[a]),
            second_line=int(second.lines[b]),
            first=float(first.frequency[a]),
            second=float(second.frequency[b]),
            first_sigma=float(first.sigma[a]),
            second_sigma=float(second.sigma[b]),
            relative=float(second.frequency[b] / first.frequency[a] - 1.0),
            sigmas=float(z),
            mac=alike,
            differs=bool(differs),
        )
        for (a, b, alike), z, differs in zip(found, differences, significant, strict=True)
    ]
    relative = np.array([pair.relative for pair in pairs])
    total = float(np.sum(np.square(differences)))
    return MeasurementsCompared(
        first=first.source,
        second=second.source,
        pairs=pairs,
        first_unpaired=_others(first, [a for a, _, _ in found]),
        second_unpaired=_others(second, [b for _, b, _ in found]),
        median_relative=float(np.median(relative)) if pairs else None,
        rms_relative=float(np.sqrt(np.mean(relative**2))) if pairs else None,
        chi2=total,
        p_value=float(chi2.sf(total, len(pairs))) if pairs else None,
        poses=len(places),
    )


def _common(first: Measurements, second: Measurements) -> Iterator[tuple[int, int]]:
    """Yield the poses that both have: of one label, or the only one of each."""
    if len(first.labels) == len(second.labels) == 1:
        places = [(0, 0)]
    else:
        places = [
            (i, second.labels.index(label)) for i, label in enumerate(first.labels) if label in second.labels
        ]
    if not places:
        what = f"expected poses of {first.source}, such as {first.labels[0]}, found {second.labels[0]}"
        raise MeasurementError(what, f"{second.source}: pose", "give the poses of both files the same labels")
    for one, other in places:
        if first.drives[one] != second.drives[other]:
            what = f"expected motors {first.drives[one]}, as in {first.source}, found {second.drives[other]}"
            where = f"{second.source}: pose {second.labels[other]}"
            raise MeasurementError(what, where, "compare measurements with the motors in the same state")
        yield one, other


def paired_rows(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], others: NDArray[np.intp]
) -> list[tuple[int, int, float | None]]:
    """Return pairs of rows at one pose with the MAC of each, so that frequencies and shapes agree best in all.

    Parameters
    ----------
    rows, others : ndarray of int
        Of the pose, in the first and in the second measurement.
    """
    apart = np.abs(np.log(second.frequency[others][None, :] / first.frequency[rows][:, None]))
    alike = _alike(first, second, rows, others)
    cost = apart / ALIKE + np.where(np.isfinite(alike), 1.0 - alike, 0.0)
    far = apart > FARTHEST
    chosen = zip(*linear_sum_assignment(np.where(far, 1e6, cost)), strict=True)
    return [
        (int(rows[i]), int(others[j]), float(alike[i, j]) if np.isfinite(alike[i, j]) else None)
        for i, j in chosen
        if not far[i, j]
    ]


def _alike(
    first: Measurements, second: Measurements, rows: NDArray[np.intp], others: NDArray[np.intp]
) -> Array:
    """Return the MAC of each row with each other, NaN where fewer than two components are in both."""
    common = [name for name in first.channels if name in second.channels]
    found = np.full((len(rows), len(others)), np.nan)
    if len(common) < 2:
        return found
    a = first.shapes[rows][:, [first.channels.index(name) for name in common]]
    b = second.shapes[others][:, [second.channels.index(name) for name in common]]
    for j, shape in enumerate(b):
        known = np.isfinite(a) & np.isfinite(shape)
        one = normalised(np.where(known, a, np.nan))
        found[:, j] = mac(one, normalised(shape)[None, :], known)[:, 0]
    return found


def _holm(p: Array) -> NDArray[np.bool_]:
    """Return which of several hypotheses are refused at `LEVEL` together (Holm, Scand. J. Statist. 6, 1979)."""
    order = np.argsort(p)
    passed = p[order] <= LEVEL / np.arange(len(p), 0, -1)
    found = np.zeros(len(p), dtype=bool)
    found[order] = np.logical_and.accumulate(passed)
    return found


def _others(data: Measurements, paired: list[int]) -> list[int]:
    """Return the lines of the rows without a partner."""
    return [int(line) for line in np.delete(data.lines, paired)]
