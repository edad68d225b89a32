"""The dataset of a map, with CF attributes."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

import pkmodes
from pkmodes.errors import MissingExtraError
from pkmodes.evaluation import evaluation
from pkmodes.maps.evaluating import Layout
from pkmodes.maps.places import LIST, Grid, Places
from pkmodes.maps.tracking import EVENTS, Tracked
from pkmodes.maps.variables import COORDINATE, DIRECTION, DRIVE, FIRST, MODE, variables
from pkmodes.maps.variants import SAMPLE, Variants
from pkmodes.poses import codes_of, reasons
from pkmodes.robot.corrections import changeable
from pkmodes.robot.robot import Robot
from pkmodes.robot.text import text_of

if TYPE_CHECKING:
    import xarray

Array = NDArray[Any]
CONVENTIONS = "CF-1.11"
#: Poses whose reasons are converted to text together.
CHUNK = 1_000_000
INSTALL = "install it: pip install 'pkmodes[map]'"


def dataset_of(
    robot: Robot,
    places: Places,
    variants: Variants,
    layout: Layout,
    arrays: Mapping[str, Array],
    tracked: Tracked | None = None,
) -> xarray.Dataset:
    """Return the dataset of a map.

    Parameters
    ----------
    robot : Robot
        As declared.
    places : Grid or Poses
    variants : Variants
    layout : Layout
    arrays : mapping of str to ndarray, shape (rows, ...)
        The fields of `pkmodes.maps.evaluating.tails`.
    tracked : Tracked, optional
        Modes by shape instead of by rank.

    Raises
    ------
    MissingExtraError
        If xarray is not installed.
    """
    kind = robot.kind
    normal = places.normal(kind.directions)
    leading = (*variants.dims, *places.dims)
    shape = (*variants.shape, *places.shape)
    fields = dict(arrays if tracked is None else tracked.arrays)
    codes = fields.pop("code")
    fields["valid"] = codes == 0
    fields["reason"] = _reasons(codes, np.array(codes_of(kind)))
    coordinates = layout.coordinates if layout.shapes else kind.independent
    if layout.shapes:
        fields["joint_position"] = _spread(fields["joint_position"], kind.independent, coordinates)
    known = variables(kind, normal, layout.shapes, tracked is not None)
    data = {
        v.name: (
            (*leading, *v.dims),
            fields[v.name].reshape(*shape, *fields[v.name].shape[1:]),
            {**v.attributes, **_meanings(robot, v.name)},
        )
        for v in known
    }
    found: xarray.Dataset = imported().Dataset(
        data,
        coords={**_coordinates(robot, places, variants), **_labels(robot, layout, coordinates)},
        attrs=_attributes(robot),
    )
    return found


def _reasons(codes: Array, known: Array) -> Any:
    """Return the reasons as text; of a map on disk when they are needed, because they take more room than codes."""
    if not isinstance(codes, np.memmap):
        return known[codes]
    from dask.array import from_array, map_blocks

    return map_blocks(known.__getitem__, from_array(codes, chunks=CHUNK), dtype=known.dtype)


def imported() -> Any:
    """Import xarray.

    Raises
    ------
    MissingExtraError
    """
    try:
        import xarray
    except ModuleNotFoundError as error:
        raise MissingExtraError(f"maps need {error.name}, which is not installed", "map", INSTALL) from None
    return xarray


def _spread(values: Array, names: tuple[str, ...], every: tuple[str, ...]) -> Array:
    """Return values of some coordinates among all of them; the others are NaN."""
    found = np.full((len(values), len(every)), np.nan)
    found[:, [every.index(name) for name in names]] = values
    return found


def _meanings(robot: Robot, name: str) -> dict[str, Any]:
    if name == "reason":
        return dict(reasons(robot.kind))
    if name == "tracking":
        masks = np.array(list(EVENTS.values()), dtype=np.int8)
        return {"flag_masks": masks, "flag_meanings": " ".join(EVENTS)}
    return {}


def _coordinates(robot: Robot, places: Places, variants: Variants) -> dict[str, Any]:
    """Return the coordinates along the leading axes."""
    units = changeable(robot)
    found: dict[str, Any] = {
        path: (path, values, {"units": units.get(path, "1"), "long_name": f"parameter {path}"})
        for path, values in variants.swept.items()
    }
    if variants.samples is not None:
        numbers = np.arange(1, variants.samples + 1)
        found[SAMPLE] = (SAMPLE, numbers, {"units": "1", "long_name": "number of the sampled robot"})
        for path, values in variants.drawn.items():
            attributes = {"units": units.get(path, "1"), "long_name": f"parameter {path}, drawn"}
            found[path] = (SAMPLE, values, attributes)
    about = {c.name: {"units": c.unit, "long_name": c.description} for c in robot.kind.pose}
    if isinstance(places, Grid):
        found |= {name: (name, places.axes[name], about[name]) for name in places.dims}
    else:
        found |= {name: (LIST, places.table[:, i], about[name]) for i, name in enumerate(places.names)}
        labels = np.array(places.labels) if places.labels else np.arange(len(places.table))
        found[LIST] = (LIST, labels, {"units": "1", "long_name": "pose"})
    return found


def _labels(robot: Robot, layout: Layout, coordinates: tuple[str, ...]) -> dict[str, Any]:
    """Return the coordinates along the axes after the poses."""
    kind = robot.kind
    numbers = np.arange(FIRST, FIRST + layout.modes)
    return {
        MODE: (MODE, numbers, {"units": "1", "long_name": "vibration mode, rigid-body modes left out"}),
        DIRECTION: (DIRECTION, np.array(kind.directions), _named("direction of the platform's motion")),
        COORDINATE: (COORDINATE, np.array(coordinates), _named("generalised coordinate")),
        DRIVE: (DRIVE, np.array([d.name for d in kind.drives]), _named("drive")),
    }


def _named(what: str) -> dict[str, str]:
    return {"units": "1", "long_name": what}


def _attributes(robot: Robot) -> dict[str, Any]:
    return {
        "Conventions": CONVENTIONS,
        "title": f"natural frequencies and mode shapes of {robot.name}",
        "source": f"pkmodes {pkmodes.__version__}",
        "robot": robot.name,
        "mechanism": robot.mechanism,
        "robot_file": text_of(robot),
        "robot_file_name": Path(robot.source).name,
        "version": pkmodes.__version__,
        "rigid_modes": evaluation(robot).rigid_modes,
    }
