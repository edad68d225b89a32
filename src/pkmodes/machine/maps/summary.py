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
from pkmodes.machine.maps.left_out import MEDIANS, near_singular, ordinary, parts, unstable, with_medians
from pkmodes.machine.maps.quantiles import quantiles
from pkmodes.machine.maps.variants import SAMPLE

if TYPE_CHECKING:
    import xarray

#: Quantiles over the poses that characterise the frequency of a mode: at the edge of a workspace a spring may become
#: so short that the extremes are not representative.
SHARES = {"quantile_2_hz": 0.02, "median_hz": 0.5, "quantile_98_hz": 0.98}
#: Number of poses below which 2 % of them are less than one.
FEW = 50


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
            description="Poses at which an eigenvalue is negative: the machine moves away instead of vibrating."
        ),
    ]
    reasons: Annotated[dict[str, int], Meta(description="How many could not, by the code of the reason.")]
    rigid_modes: Annotated[
        int, Meta(description="Rigid-body modes of the robot as declared, which are left out.")
    ]
    drives: Drives
    tracked: Annotated[bool, Meta(description="Whether modes are numbered by their shapes.")]
    modes: Annotated[list[ExtremesDocument], Meta(description="The vibration modes.")]


def summary_of(dataset: xarray.Dataset, file: str | None) -> MapSummary:
    """Return the summary of a map.

    - dataset: from `pkmodes.Model.map`; it is read part by part
    """
    leading = [str(dim) for dim in dataset["condition"].dims]
    numbers = dataset["mode"].values.tolist()
    lowest: list[Any] = [None] * len(numbers)
    highest: list[Any] = [None] * len(numbers)
    nearest: Any = None
    fastest: Any = None
    reasons: Counter[str] = Counter()
    valid = close = falling = counted = 0
    dataset = with_medians(dataset)
    for start, part in parts(dataset[["frequency", "condition", "valid", "reason", *MEDIANS]], leading):
        valid += int(part["valid"].values.sum())
        reasons.update(part["reason"].values[~part["valid"].values].tolist())
        frequency = part["frequency"].transpose(*leading, "mode").values
        near, moves = near_singular(part).values, unstable(part).values
        close += int((near > 1.0).sum())
        falling += int(moves.sum())
        nearest = _better(nearest, np.where(near > 1.0, near, np.nan), start, highest=True)
        bottom = np.where(moves, np.nanmin(np.where(np.isnan(frequency), np.inf, frequency), axis=-1), np.nan)
        fastest = _better(fastest, bottom, start, highest=False)
        counts = (near <= 1.0) & ~moves
        counted += int(counts.sum())
        kept = np.where(counts[..., None], frequency, np.nan)
        for i in range(len(numbers)):
            lowest[i] = _better(lowest[i], kept[..., i], start, highest=False)
            highest[i] = _better(highest[i], kept[..., i], start, highest=True)

    def ordinary_frequencies() -> Iterator[NDArray[Any]]:
        for _, part in parts(dataset[["frequency", "condition", *MEDIANS]], leading):
            frequency = part["frequency"].where(ordinary(part)).transpose(*leading, "mode").values
            yield frequency.reshape(-1, frequency.shape[-1])

    rows = quantiles(ordinary_frequencies, list(SHARES.values())).tolist()
    return MapSummary(
        robot=dataset.attrs["robot"],
        file=file,
        dimensions={str(name): int(size) for name, size in dataset.sizes.items()},
        ranges=_ranges(dataset, leading),
        poses=int(np.prod([dataset.sizes[dim] for dim in leading])),
        valid=valid,
        counted=counted,
        near_singular=LeftOutDocument(close, _at(nearest, dataset)),
        unstable=LeftOutDocument(falling, _at(fastest, dataset)),
        reasons=dict(sorted(reasons.items())),
        rigid_modes=int(dataset.attrs["rigid_modes"]),
        drives=cast("Drives", str(dataset.attrs["drives"])),
        tracked="rank" in dataset,
        modes=[
            ExtremesDocument(
                number,
                *_end(low, dataset),
                *_end(high, dataset),
                **{key: None if low is None else value for key, value in zip(SHARES, row, strict=True)},
            )
            for number, low, high, row in zip(numbers, lowest, highest, rows, strict=True)
        ],
    )


def quantiles_in_words(content: dict[str, Any]) -> str:
    """Return what the quantiles of a summary are: of few poses, 2 % are less than one."""
    count = content["counted"]
    if count >= FEW:
        return "At 96 % of the poses a frequency lies between its 2 % and its 98 % quantile"
    poses = "pose" if count == 1 else "poses"
    return f"Quantiles of each frequency over {count} {poses}, interpolated between its values there"


def _ranges(dataset: xarray.Dataset, leading: list[str]) -> dict[str, list[Any]]:
    """Return the lowest and highest value along each axis of a map; of labels the first and last.

    As people read them: swept parameters, then x, y, z, which a dataset has reversed.
    """
    pose = [dim for dim in leading if "." not in dim and dim != SAMPLE]
    ranges: dict[str, list[Any]] = {}
    for dim in (*(dim for dim in leading if dim not in pose), *reversed(pose)):
        values = dataset[dim].values
        labels = values.dtype.kind not in "fiu"
        ends = (values[0], values[-1]) if labels else (values.min(), values.max())
        ranges[dim] = [end.item() for end in ends]
    return ranges


def _better(extreme: Any, values: NDArray[Any], start: list[int], *, highest: bool) -> Any:
    """Return the more extreme of an extreme with its place, if any, and that of a part; NaN stands for no value."""
    if np.isnan(values).all():
        return extreme
    at = np.unravel_index(np.nanargmax(values) if highest else np.nanargmin(values), values.shape)
    value = float(values[at])
    if extreme is not None and (value <= extreme[0] if highest else value >= extreme[0]):
        return extreme
    return value, [a + int(b) for a, b in zip(start, at, strict=True)]


def _end(
    extreme: tuple[float, list[int]] | None, dataset: xarray.Dataset
) -> tuple[float | None, dict[str, Any] | None]:
    """Return an extreme frequency and where it is."""
    return None if extreme is None else extreme[0], _at(extreme, dataset)


def _at(extreme: tuple[float, list[int]] | None, dataset: xarray.Dataset) -> dict[str, Any] | None:
    if extreme is None:
        return None
    condition = dataset["condition"][tuple(extreme[1])]
    return {str(key): coordinate.values.item() for key, coordinate in condition.coords.items()}
