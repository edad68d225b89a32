"""The summary of a map: where each frequency is lowest and highest, and how many poses could be evaluated."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    import xarray

#: Poses whose extremes are searched together.
CHUNK = 1_000_000


def summary_of(dataset: xarray.Dataset, file: str | None) -> dict[str, Any]:
    """Return the summary with the documented JSON keys (docs/json.md).

    Parameters
    ----------
    dataset : xarray.Dataset
        From `pkmodes.Model.map`.
    file : str, optional
        Its file.
    """
    codes, counts = np.unique(dataset["reason"].values.astype(str), return_counts=True)
    reasons = {code: int(count) for code, count in zip(codes.tolist(), counts.tolist(), strict=True) if code}
    frequency = dataset["frequency"]
    leading = [str(dim) for dim in frequency.dims if dim != "mode"]
    return {
        "robot": dataset.attrs["robot"],
        "file": file,
        "dimensions": {str(name): int(size) for name, size in dataset.sizes.items()},
        "ranges": {dim: [_plain(dataset[dim].values[0]), _plain(dataset[dim].values[-1])] for dim in leading},
        "poses": int(np.prod([dataset.sizes[dim] for dim in leading])),
        "valid": int(dataset["valid"].sum()),
        "reasons": reasons,
        "rigid_modes": int(dataset.attrs["rigid_modes"]),
        "modes": [
            {"mode": int(mode), **_extremes(frequency.sel(mode=mode), leading)}
            for mode in dataset["mode"].values
        ],
    }


def _extremes(frequency: xarray.DataArray, leading: list[str]) -> dict[str, Any]:
    values = frequency.values.reshape(-1)
    if np.isnan(values).all():
        return {"minimum_hz": None, "maximum_hz": None, "minimum_at": None, "maximum_at": None}
    found: dict[str, Any] = {}
    for name, place in (("minimum", int(np.nanargmin(values))), ("maximum", int(np.nanargmax(values)))):
        at = np.unravel_index(place, frequency.shape)
        one = frequency[dict(zip(leading, at, strict=True))]
        found[f"{name}_hz"] = float(values[place])
        found[f"{name}_at"] = {
            str(key): _plain(value.values.item()) for key, value in one.coords.items() if key != "mode"
        }
    return found


def _plain(value: Any) -> Any:
    return value.item() if isinstance(value, np.generic) else value
