"""Poses of a map that are not representative: near-singular ones, and those at which the machine is unstable.

Near a singular pose the equations still have a solution, but it tells of the singularity: a belt span of almost no
length is a spring of almost any stiffness, and a link near its singular direction gives way to any force.  At an
unstable pose the machine moves away instead of vibrating.  Such poses keep their values in the dataset; what
summarises a map is taken from the others, and they are counted.
"""

from __future__ import annotations

import itertools
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.machine.maps.dataset import chunks_of
from pkmodes.machine.maps.quantiles import quantiles
from pkmodes.machine.maps.variants import SAMPLE

if TYPE_CHECKING:
    import xarray

#: A pose is near-singular where the condition number of the platform Jacobian is above `CONDITION` and `FACTOR` times
#: its median over the poses of the robot, or where a frequency is above `FACTOR` times its median.
CONDITION, FACTOR = 100.0, 10.0
#: A negative frequency is more than rounding if it is at least this fraction of the highest one at its pose: its
#: eigenvalue is then 1e-12 of the highest.
ROUNDING = 1e-6
MEDIANS = "median_frequency", "median_condition"
RULE = (
    f"the condition number of the platform Jacobian is above {CONDITION:g} and {FACTOR:g} times its median, or a "
    f"frequency above {FACTOR:g} times its median, as where a spring, such as a belt span, has almost no length"
)


def with_medians(dataset: xarray.Dataset) -> xarray.Dataset:
    """Return a map with the medians by which its poses are judged, those of each robot of a sweep or of samples.

    - dataset: from `pkmodes.Model.map`; it is read part by part.  Without condition numbers only its frequencies
      count.
    """
    if "condition" not in dataset:
        dataset = dataset.assign(condition=abs(dataset["frequency"].isel(mode=0, drop=True)).clip(1.0, 1.0))
    robots = [str(dim) for dim in dataset["condition"].dims if "." in str(dim) or dim == SAMPLE]
    poses = [str(dim) for dim in dataset["condition"].dims if dim not in robots]
    sizes = [dataset.sizes[dim] for dim in robots]
    modes = dataset.sizes["mode"]

    def rows() -> Iterator[NDArray[np.float64]]:
        for _, part in parts(dataset[["frequency", "condition"]], poses):
            frequency = part["frequency"].transpose(*poses, *robots, "mode").values
            condition = part["condition"].transpose(*poses, *robots).values[..., None]
            columns = np.concatenate([frequency, condition], axis=-1)
            yield columns.reshape(-1, int(np.prod(sizes)) * (modes + 1))

    middle = quantiles(rows, [0.5]).reshape(*sizes, modes + 1)
    medians = {
        MEDIANS[0]: ((*robots, "mode"), middle[..., :-1]),
        MEDIANS[1]: (tuple(robots), middle[..., -1]),
    }
    return dataset.assign(medians)


def near_singular(part: xarray.Dataset) -> xarray.DataArray:
    """Return how near poses of a map from `with_medians`, or of a part, are to the bound: near-singular above 1."""
    frequency = (part["frequency"] / (FACTOR * abs(part[MEDIANS[0]]))).max("mode")
    bound = (FACTOR * part[MEDIANS[1]]).clip(min=CONDITION)
    condition = part["condition"] / bound
    return frequency.where(frequency >= condition, condition).transpose(*part["condition"].dims)


def unstable(part: xarray.Dataset) -> xarray.DataArray:
    """Return at which poses of a map an eigenvalue is negative, by more than rounding."""
    lowest, size = part["frequency"].min("mode"), abs(part["frequency"]).max("mode")
    return (lowest < -ROUNDING * size).transpose(*(dim for dim in part["frequency"].dims if dim != "mode"))


def ordinary(part: xarray.Dataset) -> xarray.DataArray:
    """Return which poses of a map from `with_medians`, or of a part, are neither."""
    return (near_singular(part) <= 1.0) & ~unstable(part)


def shown(dataset: xarray.Dataset) -> xarray.Dataset:
    """Return a map for drawing, with NaN for the frequencies of the poses that are not representative."""
    return dataset.assign(frequency=dataset["frequency"].where(ordinary(with_medians(dataset))))


def left_out_in_words(dataset: xarray.Dataset) -> str:
    """Return how many poses of a map `shown` leaves out, for a caption; empty if none."""
    judged = with_medians(dataset)
    near, moving = int((near_singular(judged) > 1.0).sum()), int(unstable(judged).sum())
    exclusions = [f"{near:,} near-singular"] if near else []
    exclusions += [f"{moving:,} unstable"] if moving else []
    poses = "pose" if near + moving == 1 else "poses"
    blank = "; where the machine is unstable the panels are blank" if moving else ""
    return f" Ranges and triangles leave out {' and '.join(exclusions)} {poses}{blank}." if exclusions else ""


def parts(dataset: xarray.Dataset, leading: list[str]) -> Iterator[tuple[list[int], xarray.Dataset]]:
    """Yield the first place of each part of a dataset along some axes, and the part, loaded."""
    shape = tuple(dataset.sizes[dim] for dim in leading)
    sizes = chunks_of(shape, len(shape))
    for start in itertools.product(*(range(0, n, size) for n, size in zip(shape, sizes, strict=True))):
        part = {dim: slice(a, a + size) for dim, a, size in zip(leading, start, sizes, strict=True)}
        yield list(start), dataset.isel(part).load()


def sentences(content: dict[str, Any], units: dict[str, tuple[str, float]]) -> list[str]:
    """Return what is left out of the numbers of a summary, and where it is worst.

    - content: of the summary, as JSON has it
    - units: units of the map's axes as shown, with the factors from SI
    """
    lines = []
    for key, is_, why, extreme in (
        ("near_singular", "near-singular", RULE, "the farthest"),
        (
            "unstable",
            "unstable",
            "the machine moves away instead of vibrating, and the map gives the rate as a negative frequency",
            "the fastest",
        ),
    ):
        count, at = content[key]["poses"], content[key]["at"]
        if count:
            poses = "pose is" if count == 1 else "poses are"
            names = dict.fromkeys([*(name for name in content["ranges"] if name in at), *at])
            places = []
            for name in names:
                unit, factor = units.get(name, ("", 1.0))
                label = isinstance(at[name], str)
                places.append(
                    f"{name} {at[name]}" if label else f"{name} = {factor * at[name]:.4g} {unit}".rstrip()
                )
            position = "at" if count == 1 else f"{extreme} at"
            lines.append(
                f"{count:,} {poses} {is_} and not in these numbers: {why}; {position} {', '.join(places)}."
            )
    return lines
