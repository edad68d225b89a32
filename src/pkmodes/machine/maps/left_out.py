"""Poses of a map that are not representative: near-singular ones, and those at which the machine is unstable.

Near a singular pose the equations still have a solution, but it describes the singularity: a belt span of almost no
length is a spring of almost any stiffness, and a link near its singular direction gives way to any force.  At an
unstable pose the machine diverges instead of vibrating.  Such poses keep their values in the dataset; summaries of
a map leave them out and state how many there are.
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

#: A pose is near-singular where the condition number of the platform Jacobian is above `CONDITION_LIMIT` and
#: `MEDIAN_FACTOR` times its median over the poses of the robot, or where a frequency is above `MEDIAN_FACTOR` times
#: its median.
CONDITION_LIMIT, MEDIAN_FACTOR = 100.0, 10.0
#: A negative frequency counts as rounding up to this fraction of the highest frequency of its pose (1e-12 in
#: eigenvalues).
ROUNDING_FRACTION = 1e-6
#: Variables added by `with_medians`.
MEDIAN_FREQUENCY, MEDIAN_CONDITION = "median_frequency", "median_condition"
NEAR_SINGULAR_RULE = (
    f"the condition number of the platform Jacobian is above {CONDITION_LIMIT:g} and {MEDIAN_FACTOR:g} times its "
    f"median, or a frequency above {MEDIAN_FACTOR:g} times its median, as where a spring, such as a belt span, has "
    "almost no length"
)


def with_medians(dataset: xarray.Dataset) -> xarray.Dataset:
    """Add to a map the medians by which poses are judged near-singular, for each robot of a sweep or of samples.

    - dataset: from `pkmodes.Model.map`; it is read part by part.  Without condition numbers only its frequencies
      decide.
    """
    if "condition" not in dataset:
        # 1 wherever there is a frequency, NaN elsewhere.
        dataset = dataset.assign(condition=abs(dataset["frequency"].isel(mode=0, drop=True)).clip(1.0, 1.0))
    robot_dims = [str(dim) for dim in dataset["condition"].dims if "." in str(dim) or dim == SAMPLE]
    pose_dims = [str(dim) for dim in dataset["condition"].dims if dim not in robot_dims]
    robot_sizes = [dataset.sizes[dim] for dim in robot_dims]
    modes = dataset.sizes["mode"]

    def rows() -> Iterator[NDArray[np.float64]]:
        for _, part in loaded_parts(dataset[["frequency", "condition"]], pose_dims):
            frequency = part["frequency"].transpose(*pose_dims, *robot_dims, "mode").values
            condition = part["condition"].transpose(*pose_dims, *robot_dims).values[..., None]
            columns = np.concatenate([frequency, condition], axis=-1)
            yield columns.reshape(-1, int(np.prod(robot_sizes)) * (modes + 1))

    median_values = quantiles(rows, [0.5]).reshape(*robot_sizes, modes + 1)
    medians = {
        MEDIAN_FREQUENCY: ((*robot_dims, "mode"), median_values[..., :-1]),
        MEDIAN_CONDITION: (tuple(robot_dims), median_values[..., -1]),
    }
    return dataset.assign(medians)


def singularity_ratio(part: xarray.Dataset) -> xarray.DataArray:
    """Return how far each pose is from the near-singular limit, as a ratio; above 1 it is near-singular.

    - part: map from `with_medians`, or a part of it
    """
    frequency = (part["frequency"] / (MEDIAN_FACTOR * abs(part[MEDIAN_FREQUENCY]))).max("mode")
    bound = (MEDIAN_FACTOR * part[MEDIAN_CONDITION]).clip(min=CONDITION_LIMIT)
    condition = part["condition"] / bound
    return frequency.where(frequency >= condition, condition).transpose(*part["condition"].dims)


def unstable_mask(part: xarray.Dataset) -> xarray.DataArray:
    """Return the poses of a map at which an eigenvalue is negative by more than rounding."""
    lowest, largest = part["frequency"].min("mode"), abs(part["frequency"]).max("mode")
    return (lowest < -ROUNDING_FRACTION * largest).transpose(
        *(dim for dim in part["frequency"].dims if dim != "mode")
    )


def representative_mask(part: xarray.Dataset) -> xarray.DataArray:
    """Return the poses of a map from `with_medians`, or of a part, that are neither near-singular nor unstable."""
    return (singularity_ratio(part) <= 1.0) & ~unstable_mask(part)


def without_unrepresentative(dataset: xarray.Dataset) -> xarray.Dataset:
    """Return a map for drawing, with NaN for the frequencies at poses that are not representative."""
    return dataset.assign(frequency=dataset["frequency"].where(representative_mask(with_medians(dataset))))


def exclusion_caption(dataset: xarray.Dataset) -> str:
    """Return how many poses of a map `without_unrepresentative` leaves out, for a caption; empty if none."""
    map_with_medians = with_medians(dataset)
    near_singular_count, unstable_count = (
        int((singularity_ratio(map_with_medians) > 1.0).sum()),
        int(unstable_mask(map_with_medians).sum()),
    )
    exclusions = [f"{near_singular_count:,} near-singular"] if near_singular_count else []
    exclusions += [f"{unstable_count:,} unstable"] if unstable_count else []
    poses = "pose" if near_singular_count + unstable_count == 1 else "poses"
    blank = "; where the machine is unstable the panels are blank" if unstable_count else ""
    return f" Ranges and triangles leave out {' and '.join(exclusions)} {poses}{blank}." if exclusions else ""


def loaded_parts(dataset: xarray.Dataset, dims: list[str]) -> Iterator[tuple[list[int], xarray.Dataset]]:
    """Yield the parts of a dataset along some dimensions, loaded, each with the index of its first pose."""
    shape = tuple(dataset.sizes[dim] for dim in dims)
    sizes = chunks_of(shape, len(shape))
    for origin in itertools.product(
        *(range(0, length, size) for length, size in zip(shape, sizes, strict=True))
    ):
        selection = {
            dim: slice(start, start + size) for dim, start, size in zip(dims, origin, sizes, strict=True)
        }
        yield list(origin), dataset.isel(selection).load()


def exclusion_sentences(content: dict[str, Any], units: dict[str, tuple[str, float]]) -> list[str]:
    """Return sentences on the poses that the numbers of a summary leave out, and on the worst of them.

    - content: the summary, as in JSON
    - units: display units of the map's axes, with the factors from SI units
    """
    lines = []
    for key, adjective, reason, superlative in (
        ("near_singular", "near-singular", NEAR_SINGULAR_RULE, "the farthest"),
        (
            "unstable",
            "unstable",
            "the machine diverges instead of vibrating, and the map gives the rate as a negative frequency",
            "the fastest",
        ),
    ):
        count, pose = content[key]["poses"], content[key]["at"]
        if count:
            poses = "pose is" if count == 1 else "poses are"
            names = dict.fromkeys([*(name for name in content["ranges"] if name in pose), *pose])
            coordinates = []
            for name in names:
                unit, factor = units.get(name, ("", 1.0))
                label = isinstance(pose[name], str)
                coordinates.append(
                    f"{name} {pose[name]}" if label else f"{name} = {factor * pose[name]:.4g} {unit}".rstrip()
                )
            position = "at" if count == 1 else f"{superlative} at"
            lines.append(
                f"{count:,} {poses} {adjective} and not in these numbers: {reason}; "
                f"{position} {', '.join(coordinates)}."
            )
    return lines
