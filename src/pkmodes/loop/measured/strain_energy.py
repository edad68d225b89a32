"""Where along a series of channels the share of the strain energy changed: the damage index of Stubbs and Kim.

Without a model, the energy of what lies between two neighbours is taken as the square of their relative motion, as in
a chain of like springs: a storey, or a part of a belt or a bar.  Where stiffness is lost, the share of the energy of
most modes grows.  The index (Stubbs, Kim and Farrar, Proc. 13th IMAC, 1995, 210-218) compares the shares F of n
modes,

    beta = sum (F_second + 1) / sum (F_first + 1),

where the 1, the share of the whole, keeps places that hardly move from dividing by nothing.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.core.support.documents import Document, Number, Size
from pkmodes.loop.measured.series import series_of
from pkmodes.loop.measured.shape_changes import AlignedShapes

Array = NDArray[np.float64]
#: A mode contributes to the index if its relative motions exceed their errors by this factor (root mean square).
MIN_SIGNAL_TO_NOISE = 3.0


class StrainEnergyChange(Document, frozen=True):
    """The damage index between two neighbours of a series of channels."""

    pose: Annotated[str, Meta(description="Label of the pose in the first file.")]
    channels: Annotated[list[str], Meta(description="The two neighbours.")]
    lines: Annotated[
        list[Number], Meta(description="Modes from which it is computed: lines of the first file.")
    ]
    first: Annotated[
        Size, Meta(description="Mean share of the strain energy of the series in the first file.")
    ]
    second: Annotated[Size, Meta(description="In the second file.")]
    index: Annotated[
        Size,
        Meta(description="Damage index: above 1 where the share grew, as it does where stiffness is lost."),
    ]
    sigma: Annotated[
        Size | None,
        Meta(description="Standard deviation of it; null without sigma_shape of all these modes."),
    ]
    sigmas: Annotated[float | None, Meta(description="index - 1 in standard deviations.")]
    differs: Annotated[
        bool,
        Meta(
            description="Whether it is not 1, at the level of 1 % of all places of all shapes together (Holm)."
        ),
    ]


def strain_energy_changes(
    pose: str, lines: Sequence[int], shapes: Sequence[AlignedShapes]
) -> list[StrainEnergyChange]:
    """Return the damage indices at a pose, of each series of channels.

    - pose: label of the pose
    - lines: lines of the n modes in the first file
    - shapes: their shapes in both files
    """
    modes_by_series: dict[tuple[str, ...], list[tuple[int, Array, Array, tuple[float, float]]]] = {}
    for line, mode in zip(lines, shapes, strict=True):
        for members in series_of(mode.channels):
            first, second = mode.first[members], mode.second[members]
            pairs = ((first, mode.sigmas[0]), (second, mode.sigmas[1]))
            if all(_exceeds_errors(motion, error) for motion, error in pairs):
                names = tuple(mode.channels[k] for k in members)
                modes_by_series.setdefault(names, []).append((line, first, second, mode.sigmas))
    return [
        change
        for names, modes in modes_by_series.items()
        for change in _changes_of_series(pose, names, modes)
    ]


def most_changed(changes: Sequence[StrainEnergyChange]) -> StrainEnergyChange | None:
    """Return the place whose index is clearly not 1, and farthest from it; None without any.

    The shares of a series add up, so that a change at one place changes those of all others: the largest change is
    returned, not the most certain one.
    """
    clear_changes = [change for change in changes if change.differs]
    return max(clear_changes, key=lambda change: abs(np.log(change.index)), default=None)


def _exceeds_errors(motion: Array, error: float) -> bool:
    """Return whether neighbours move relative to each other, by more than the errors where these are known."""
    mean_square = float(np.mean(np.diff(motion) ** 2))
    min_mean_square = 0.0 if np.isnan(error) else 2.0 * (MIN_SIGNAL_TO_NOISE * error) ** 2
    return mean_square > min_mean_square


def _changes_of_series(
    pose: str, names: Sequence[str], modes: Sequence[tuple[int, Array, Array, tuple[float, float]]]
) -> list[StrainEnergyChange]:
    """Return the damage indices along one series."""
    first_shares = [energy_shares(first, errors[0]) for _, first, _, errors in modes]
    second_shares = [energy_shares(second, errors[1]) for _, _, second, errors in modes]
    first_sum = np.sum([share for share, _ in first_shares], axis=0)
    second_sum = np.sum([share for share, _ in second_shares], axis=0)
    count = len(modes)
    index = (second_sum + count) / (first_sum + count)
    first_variance = np.sum([variance for _, variance in first_shares], axis=0)
    second_variance = np.sum([variance for _, variance in second_shares], axis=0)
    sigma = np.sqrt(second_variance + index**2 * first_variance) / (first_sum + count)
    return [
        StrainEnergyChange(
            pose=pose,
            channels=[names[j], names[j + 1]],
            lines=[line for line, *_ in modes],
            first=float(first_sum[j] / count),
            second=float(second_sum[j] / count),
            index=float(index[j]),
            sigma=float(sigma[j]) if np.isfinite(sigma[j]) else None,
            sigmas=float((index[j] - 1.0) / sigma[j]) if np.isfinite(sigma[j]) else None,
            differs=False,  # until all places are judged together
        )
        for j in range(len(names) - 1)
    ]


def energy_shares(motion: Array, error: float) -> tuple[Array, Array]:
    """Return the share of each pair of neighbours in the squares of all relative motions, and its variance.

    - motion: motion of a series of channels, (n,)
    - error: standard deviation of each component, independent of the others

    Returns shares and variances, (n - 1,), to first order in the error, with the leading term of second order, the
    only one for two neighbours that move alike.
    """
    differences = np.diff(np.eye(len(motion)), axis=0)
    relative = differences @ motion
    total = relative @ relative
    shares = relative**2 / total
    slopes = 2.0 * (relative[:, None] * differences - np.outer(shares, relative @ differences)) / total
    variance = 2.0 * error**2  # of a relative motion
    return shares, (error**2) * (slopes**2).sum(axis=1) + 3.0 * (variance / total) ** 2
