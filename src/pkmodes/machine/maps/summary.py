"""The summary of a map: between which frequencies each mode lies, and how many poses could be evaluated."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, Any, cast

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.core.base.drives import Drives
from pkmodes.core.support.documents import Document
from pkmodes.machine.maps.left_out import (
    MEDIAN_CONDITION,
    MEDIAN_FREQUENCY,
    loaded_parts,
    representative_mask,
    singularity_ratio,
    unstable_mask,
    with_medians,
)
from pkmodes.machine.maps.quantiles import quantiles
from pkmodes.machine.maps.variants import SAMPLE

if TYPE_CHECKING:
    import xarray

#: Quantiles over the poses that characterise the frequency of a mode: at the edge of a workspace a spring may become
#: so short that the extremes are not representative.
QUANTILES = {"quantile_2_hz": 0.02, "median_hz": 0.5, "quantile_98_hz": 0.98}
#: Minimum number of poses of which 2 % are at least one.
MIN_POSES_FOR_2_PERCENT = 50


class ExtremesDocument(Document, frozen=True):
    """Between which values a frequency lies, and where it is lowest and highest."""

    mode: Annotated[int, Meta(description="Number of the mode: 1 is the first vibration mode.")]
    minimum_hz: Annotated[
        float | None,
        Meta(description="Its lowest frequency [Hz]; null where it has none at any counted pose."),
    ]
    minimum_at: Annotated[
        dict[str, float | str] | None,
        Meta(description="Where: the value of each coordinate of the map, in SI units."),
    ]
    maximum_hz: Annotated[float | None, Meta(description="Its highest frequency [Hz].")]
    maximum_at: Annotated[dict[str, float | str] | None, Meta(description="Where.")]
    quantile_2_hz: Annotated[
        float | None, Meta(description="The frequency below which it is at 2 % of the poses [Hz].")
    ]
    median_hz: Annotated[
        float | None, Meta(description="The frequency below which it is at half of the poses [Hz].")
    ]
    quantile_98_hz: Annotated[
        float | None, Meta(description="The frequency below which it is at 98 % of the poses [Hz].")
    ]
    sigma_hz: Annotated[
        float | None,
        Meta(
            description="Its standard deviation from those that the robot file states, the median over some of the "
            "poses [Hz]; null where the file states none, and where the map has samples."
        ),
    ]


class LeftOutDocument(Document, frozen=True):
    """Poses that the numbers of the modes leave out."""

    poses: Annotated[int, Meta(description="How many there are.")]
    at: Annotated[
        dict[str, float | str] | None,
        Meta(
            description="Where it is worst: the value of each coordinate of the map; null where there are none."
        ),
    ]


class MapSummary(Document, frozen=True):
    """The summary of a map."""

    robot: Annotated[str, Meta(description="Name of the robot.")]
    file: Annotated[str | None, Meta(description="The file of the map as given, null without one.")]
    dimensions: Annotated[
        dict[str, int], Meta(description="Length of each dimension of the dataset, by name.")
    ]
    ranges: Annotated[
        dict[str, Annotated[list[float | str], Meta(min_length=2, max_length=2)]],
        Meta(
            description="First and last value along each dimension of the poses and of the swept parameters, in SI "
            "units."
        ),
    ]
    poses: Annotated[
        int, Meta(description="Number of poses, of all robots of a sweep or of samples together.")
    ]
    valid: Annotated[int, Meta(description="How many of them could be evaluated.")]
    counted: Annotated[
        int,
        Meta(
            description="How many of these the numbers of modes are from: those neither near-singular nor unstable."
        ),
    ]
    near_singular: Annotated[
        LeftOutDocument,
        Meta(
            description="Poses at which the condition number of the platform Jacobian is above 100 and 10 times its "
            "median over the map, or a frequency above 10 times its median."
        ),
    ]
    unstable: Annotated[
        LeftOutDocument,
        Meta(
            description="Poses at which an eigenvalue is negative: the machine diverges instead of vibrating."
        ),
    ]
    reasons: Annotated[dict[str, int], Meta(description="How many could not, by the code of the reason.")]
    rigid_modes: Annotated[
        int, Meta(description="Rigid-body modes of the robot as declared, which are left out.")
    ]
    drives: Drives
    tracked: Annotated[bool, Meta(description="Whether modes are numbered by their shapes.")]
    modes: Annotated[list[ExtremesDocument], Meta(description="The vibration modes.")]


def summary_of(
    dataset: xarray.Dataset, file: str | None, sigmas: NDArray[np.float64] | None = None
) -> MapSummary:
    """Return the summary of a map.

    - dataset: from `pkmodes.Model.map`; it is read part by part
    - sigmas: of each mode, from `typical_spread`, (m,) [Hz]
    """
    leading = [str(dim) for dim in dataset["condition"].dims]
    mode_numbers = dataset["mode"].values.tolist()
    lowest: list[Any] = [None] * len(mode_numbers)
    highest: list[Any] = [None] * len(mode_numbers)
    most_singular: Any = None
    most_unstable: Any = None
    reasons: Counter[str] = Counter()
    valid_count = near_singular_count = unstable_count = representative_count = 0
    dataset = with_medians(dataset)
    for origin, part in loaded_parts(
        dataset[["frequency", "condition", "valid", "reason", MEDIAN_FREQUENCY, MEDIAN_CONDITION]], leading
    ):
        valid_count += int(part["valid"].values.sum())
        reasons.update(part["reason"].values[~part["valid"].values].tolist())
        frequency = part["frequency"].transpose(*leading, "mode").values
        singularity, unstable_poses = singularity_ratio(part).values, unstable_mask(part).values
        near_singular_count += int((singularity > 1.0).sum())
        unstable_count += int(unstable_poses.sum())
        most_singular = _update_extreme(
            most_singular, np.where(singularity > 1.0, singularity, np.nan), origin, highest=True
        )
        lowest_unstable = np.where(
            unstable_poses, np.nanmin(np.where(np.isnan(frequency), np.inf, frequency), axis=-1), np.nan
        )
        most_unstable = _update_extreme(most_unstable, lowest_unstable, origin, highest=False)
        representative_poses = (singularity <= 1.0) & ~unstable_poses
        representative_count += int(representative_poses.sum())
        representative_frequency = np.where(representative_poses[..., None], frequency, np.nan)
        for i in range(len(mode_numbers)):
            lowest[i] = _update_extreme(lowest[i], representative_frequency[..., i], origin, highest=False)
            highest[i] = _update_extreme(highest[i], representative_frequency[..., i], origin, highest=True)

    def representative_frequencies() -> Iterator[NDArray[Any]]:
        for _, part in loaded_parts(
            dataset[["frequency", "condition", MEDIAN_FREQUENCY, MEDIAN_CONDITION]], leading
        ):
            frequency = part["frequency"].where(representative_mask(part)).transpose(*leading, "mode").values
            yield frequency.reshape(-1, frequency.shape[-1])

    rows = quantiles(representative_frequencies, list(QUANTILES.values())).tolist()
    return MapSummary(
        robot=dataset.attrs["robot"],
        file=file,
        dimensions={str(name): int(size) for name, size in dataset.sizes.items()},
        ranges=_ranges(dataset, leading),
        poses=int(np.prod([dataset.sizes[dim] for dim in leading])),
        valid=valid_count,
        counted=representative_count,
        near_singular=LeftOutDocument(near_singular_count, _pose_at(most_singular, dataset)),
        unstable=LeftOutDocument(unstable_count, _pose_at(most_unstable, dataset)),
        reasons=dict(sorted(reasons.items())),
        rigid_modes=int(dataset.attrs["rigid_modes"]),
        drives=cast("Drives", str(dataset.attrs["drives"])),
        tracked="rank" in dataset,
        modes=[
            ExtremesDocument(
                number,
                *_value_and_pose(low, dataset),
                *_value_and_pose(high, dataset),
                **{key: None if low is None else value for key, value in zip(QUANTILES, row, strict=True)},
                sigma_hz=None if low is None or not np.isfinite(sigma) else float(sigma),
            )
            for number, low, high, row, sigma in zip(
                *(mode_numbers, lowest, highest, rows),
                np.full(len(mode_numbers), np.nan) if sigmas is None else sigmas,
                strict=True,
            )
        ],
    )


def quantiles_sentence(content: dict[str, Any]) -> str:
    """Return the explanation of the quantiles of a summary; with few poses, 2 % of them are less than one."""
    count = content["counted"]
    if count >= MIN_POSES_FOR_2_PERCENT:
        return "At 96 % of the poses a frequency lies between its 2 % and its 98 % quantile"
    poses = "pose" if count == 1 else "poses"
    return f"Quantiles of each frequency over {count} {poses}, interpolated between its values there"


def _ranges(dataset: xarray.Dataset, leading: list[str]) -> dict[str, list[Any]]:
    """Return the lowest and highest value along each axis of a map; of labels the first and last.

    In the order in which people read them: swept parameters, then x, y, z, which are reversed in a dataset.
    """
    pose_dims = [dim for dim in leading if "." not in dim and dim != SAMPLE]
    ranges: dict[str, list[Any]] = {}
    for dim in (*(dim for dim in leading if dim not in pose_dims), *reversed(pose_dims)):
        values = dataset[dim].values
        labels = values.dtype.kind not in "fiu"
        ends = (values[0], values[-1]) if labels else (values.min(), values.max())
        ranges[dim] = [end.item() for end in ends]
    return ranges


def _update_extreme(extreme: Any, values: NDArray[Any], origin: list[int], *, highest: bool) -> Any:
    """Return an extreme value so far and its index, or those of a part of the map if they are more extreme.

    - extreme: value and index, None if there is none so far
    - values: values of the part; NaN where there is none
    - origin: index of the first value of the part
    """
    if np.isnan(values).all():
        return extreme
    index = np.unravel_index(np.nanargmax(values) if highest else np.nanargmin(values), values.shape)
    value = float(values[index])
    if extreme is not None and (value <= extreme[0] if highest else value >= extreme[0]):
        return extreme
    return value, [a + int(b) for a, b in zip(origin, index, strict=True)]


def _value_and_pose(
    extreme: tuple[float, list[int]] | None, dataset: xarray.Dataset
) -> tuple[float | None, dict[str, Any] | None]:
    """Return an extreme frequency and where it is."""
    return None if extreme is None else extreme[0], _pose_at(extreme, dataset)


def _pose_at(extreme: tuple[float, list[int]] | None, dataset: xarray.Dataset) -> dict[str, Any] | None:
    if extreme is None:
        return None
    condition = dataset["condition"][tuple(extreme[1])]
    return {str(key): coordinate.values.item() for key, coordinate in condition.coords.items()}
