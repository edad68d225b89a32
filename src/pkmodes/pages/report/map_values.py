"""The frequencies of a map as a page holds them: rounded, thinned where there are many, and packed."""

from __future__ import annotations

import zlib
from base64 import b64encode
from collections.abc import Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
#: Decimals of the frequencies [Hz], as in the tables of a report.
DECIMALS = 3
#: Cap on the stored frequencies [Hz]: near a singular pose they grow without bound.
MAX_FREQUENCY = 1e6
#: Maximum number of frequencies, and of packed characters, on one page.
MAX_FREQUENCIES, MAX_PACKED_LENGTH = 1_000_000, 1_600_000


@dataclass(frozen=True, eq=False)
class MapValues:
    """The frequencies of a map, packed.

    - dataset: the map, thinned
    - steps: for each axis, the step between the values that were kept
    - packed: Base64 of a zlib stream, from `pack_frequencies`
    """

    dataset: xarray.Dataset
    steps: Mapping[str, int]
    packed: str

    @property
    def thinned(self) -> bool:
        """Whether poses or robots of the map were left out."""
        return any(step > 1 for step in self.steps.values())


def pack_map(
    dataset: xarray.Dataset, max_values: int = MAX_FREQUENCIES, max_length: int = MAX_PACKED_LENGTH
) -> MapValues:
    """Return the frequencies of a map for a page.

    - dataset: from `pkmodes.Model.map`
    - max_values, max_length: limits of the frequencies and of the packed characters; a larger map is thinned along
      its longest axes
    """
    dims = [str(dim) for dim in dataset["frequency"].dims[:-1]]
    sizes = {dim: dataset.sizes[dim] for dim in dims}
    while True:
        steps = _choose_steps(sizes, max(max_values // dataset.sizes["mode"], 1))
        thinned = dataset[["frequency", "valid"]].isel(
            {dim: slice(None, None, step) for dim, step in steps.items()}
        )
        thinned = thinned.load()
        packed = pack_frequencies(np.moveaxis(thinned["frequency"].values, -1, 0))
        if len(packed) <= max_length or thinned["frequency"].size <= dataset.sizes["mode"]:
            return MapValues(thinned, steps, packed)
        max_values = thinned["frequency"].size // 2


def _choose_steps(sizes: Mapping[str, int], max_poses: int) -> dict[str, int]:
    """Return for each axis the step between the values to keep, so that at most `max_poses` poses remain."""
    steps = dict.fromkeys(sizes, 1)

    def kept_sizes() -> dict[str, int]:
        return {dim: -(-size // steps[dim]) for dim, size in sizes.items()}

    while np.prod(list(kept_sizes().values())) > max_poses:
        sizes_left = kept_sizes()
        steps[max(sizes_left, key=lambda dim: sizes_left[dim])] += 1
    return steps


def pack_frequencies(frequency: Array) -> str:
    """Return frequencies [Hz] of any shape as text.

    The values are whole numbers of 10**-`DECIMALS` Hz; each is its difference from the value before it along the last
    axis, the sign in the last bit; the bytes of the numbers are in four planes, the lowest bytes first.  Before them
    are the bits that mark missing values, each of which repeats the value before it.
    """
    missing = ~np.isfinite(frequency)
    bounded = np.clip(np.where(missing, 0.0, frequency), -MAX_FREQUENCY, MAX_FREQUENCY)
    scaled = np.rint(bounded * 10**DECIMALS).astype(np.int32)
    last_valid = np.where(missing, 0, np.arange(frequency.shape[-1]))
    filled = np.take_along_axis(scaled, np.maximum.accumulate(last_valid, axis=-1), axis=-1)
    differences = np.diff(filled, axis=-1, prepend=np.int32(0))
    numbers = ((differences << 1) ^ (differences >> 31)).astype("<u4").reshape(-1)
    byte_planes = numbers.view(np.uint8).reshape(-1, 4).T
    raw = np.packbits(missing.reshape(-1)).tobytes() + byte_planes.tobytes()
    return b64encode(zlib.compress(raw, 9)).decode("ascii")
