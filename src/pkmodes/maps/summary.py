"""The summary of a map: between which frequencies each mode lies, and how many poses could be evaluated."""

from __future__ import annotations

import itertools
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.maps.fields import chunks_of
from pkmodes.maps.quantiles import quantiles
from pkmodes.maps.variants import SAMPLE

if TYPE_CHECKING:
    import xarray

#: Shares of the poses below the frequencies that stand for a mode: at the edge of a workspace a spring may become so
#: short that the extremes say nothing about the rest.
SHARES = {"quantile_2_hz": 0.02, "median_hz": 0.5, "quantile_98_hz": 0.98}
#: Number of poses below which 2 % of them are less than one.
FEW = 50
#: A frequency is written with decimals up to this one [Hz], and a highest one is far above the others from this
#: multiple of the 98 % quantile on.
LARGE, FAR = 1e5, 10.0


def summary_of(dataset: xarray.Dataset, file: str | None) -> dict[str, Any]:
    """Return the summary with the documented JSON keys (docs/json.md).

    Parameters
    ----------
    dataset : xarray.Dataset
        From `pkmodes.Model.map`; it is read part by part.
    file : str, optional
        Its file.
    """
    leading = [str(dim) for dim in dataset["condition"].dims]
    numbers = dataset["mode"].values.tolist()
    lowest: list[Any] = [None] * len(numbers)
    highest: list[Any] = [None] * len(numbers)
    reasons: Counter[str] = Counter()
    valid = 0
    for start, part in _parts(dataset[["frequency", "valid", "reason"]], leading):
        valid += int(part["valid"].values.sum())
        reasons.update(part["reason"].values[~part["valid"].values].tolist())
        frequency = part["frequency"].values
        for i in range(len(numbers)):
            values = frequency[..., i]
            if np.isnan(values).all():
                continue
            for extremes, place, better in (
                (lowest, np.nanargmin(values), np.less),
                (highest, np.nanargmax(values), np.greater),
            ):
                at = np.unravel_index(place, values.shape)
                if extremes[i] is None or better(values[at], extremes[i][0]):
                    extremes[i] = float(values[at]), [a + int(b) for a, b in zip(start, at, strict=True)]
    rows = quantiles(lambda: _frequencies(dataset, leading), list(SHARES.values())).tolist()
    return {
        "robot": dataset.attrs["robot"],
        "file": file,
        "dimensions": {str(name): int(size) for name, size in dataset.sizes.items()},
        "ranges": {dim: _range(dataset[dim].values) for dim in _as_read(leading)},
        "poses": int(np.prod([dataset.sizes[dim] for dim in leading])),
        "valid": valid,
        "reasons": dict(sorted(reasons.items())),
        "rigid_modes": int(dataset.attrs["rigid_modes"]),
        "drives": str(dataset.attrs["drives"]),
        "tracked": "rank" in dataset,
        "modes": [
            {
                "mode": number,
                **_end("minimum", low, dataset),
                **_end("maximum", high, dataset),
                **{key: None if low is None else value for key, value in zip(SHARES, row, strict=True)},
            }
            for number, low, high, row in zip(numbers, lowest, highest, rows, strict=True)
        ],
    }


def shown_hertz(value: float | None) -> str:
    """Return a frequency as a table shows it: with three decimals, or with a power of ten."""
    if value is None:
        return "-"
    if abs(value) < LARGE:
        return f"{value:.3f}"
    digits, _, power = f"{value:.2e}".partition("e")
    return f"{digits}e{int(power)}"


def quantiles_in_words(content: dict[str, Any]) -> str:
    """Return what the quantiles of a summary are: of few poses, 2 % are less than one."""
    count = content["valid"]
    if count >= FEW:
        return "At 96 % of the poses a frequency lies between its 2 % and its 98 % quantile"
    poses = "pose" if count == 1 else "poses"
    return f"Quantiles of each frequency over {count} {poses}, interpolated between its values there"


def remark_on(content: dict[str, Any]) -> str:
    """Return a sentence on highest frequencies that say nothing about the rest of a map; empty if there are none."""
    far = [
        str(row["mode"])
        for row in content["modes"]
        if row["maximum_hz"] is not None and row["maximum_hz"] > FAR * abs(row["quantile_98_hz"])
    ]
    if not far:
        return ""
    several = len(far) > 1
    modes = f"modes {', '.join(far[:-1])} and {far[-1]}" if several else f"mode {far[0]}"
    return (
        f"The highest {'frequencies' if several else 'frequency'} of {modes} {'are' if several else 'is'} more than "
        f"ten times the 98 % quantile: usually at a pose where a spring, such as a belt span, has almost no length."
    )


def _as_read(leading: list[str]) -> list[str]:
    """Return the axes of a map as people read them: swept parameters, then x, y, z, which a dataset has reversed."""
    pose = [dim for dim in leading if "." not in dim and dim != SAMPLE]
    return [*(dim for dim in leading if dim not in pose), *reversed(pose)]


def _parts(dataset: xarray.Dataset, leading: list[str]) -> Iterator[tuple[list[int], xarray.Dataset]]:
    """Yield the first place of each part of a dataset along its leading axes, and the part."""
    shape = tuple(dataset.sizes[dim] for dim in leading)
    sizes = chunks_of(shape, len(shape))
    for start in itertools.product(*(range(0, n, size) for n, size in zip(shape, sizes, strict=True))):
        part = {dim: slice(a, a + size) for dim, a, size in zip(leading, start, sizes, strict=True)}
        yield list(start), dataset.isel(part).load()


def _frequencies(dataset: xarray.Dataset, leading: list[str]) -> Iterator[NDArray[Any]]:
    """Yield the frequencies of each part, (poses, modes)."""
    for _, part in _parts(dataset[["frequency"]], leading):
        frequency = part["frequency"].transpose(..., "mode").values
        yield frequency.reshape(-1, frequency.shape[-1])


def _end(name: str, extreme: tuple[float, list[int]] | None, dataset: xarray.Dataset) -> dict[str, Any]:
    if extreme is None:
        return {f"{name}_hz": None, f"{name}_at": None}
    value, at = extreme
    one = dataset["condition"][tuple(at)]
    return {
        f"{name}_hz": value,
        f"{name}_at": {str(key): coordinate.values.item() for key, coordinate in one.coords.items()},
    }


def _range(values: NDArray[Any]) -> list[Any]:
    """Return the lowest and highest value along an axis, of labels the first and last."""
    if values.dtype.kind in "fiu":
        return [values.min().item(), values.max().item()]
    return [values[0].item(), values[-1].item()]
