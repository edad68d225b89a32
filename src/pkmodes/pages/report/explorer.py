"""The interactive map of a report: the data that the program of the page needs."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import DISPLAY_UNITS
from pkmodes.pages.plots.labels import typeset
from pkmodes.pages.plots.plane import UPRIGHT_RATIO, abscissa_and_ordinate, colour_limits
from pkmodes.pages.plots.style import figure_style
from pkmodes.pages.report.blocks import Explorer, Slider
from pkmodes.pages.report.formatting import clean, group_thousands, shorten
from pkmodes.pages.report.map_values import DECIMALS, MAX_FREQUENCY, MapValues, pack_map
from pkmodes.pages.view.page_data import script_json

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model
    from pkmodes.machine.maps.poses import PoseGrid

#: Number of colours in the scale on the page.
COLOUR_COUNT = 128
LIST_DIMENSION = "pose"


def interactive_map(
    model: Model,
    dataset: xarray.Dataset,
    units: Any,
    *,
    has_machine_view: bool,
    plane: PoseGrid | None = None,
) -> Explorer | None:
    """Return the interactive map; None unless there are several poses to choose from.

    - model: the robot as declared
    - dataset: from `pkmodes.Model.map`
    - units: unit of each axis as shown, with the factor from SI
    - has_machine_view: whether the page has a view of the machine, which follows
    - plane: that of the figures of the page: the map opens there, with the same axes
    """
    if not dataset["valid"].any():
        return None
    components = [component.name for component in model.mechanism.pose]
    dims = [str(dim) for dim in dataset["frequency"].dims[:-1]]
    pose_dims = [dim for dim in dims if dim == LIST_DIMENSION or dim in components]
    if all(dataset.sizes[dim] == 1 for dim in pose_dims):
        return None
    packed_map = pack_map(dataset)
    page_map = packed_map.dataset
    axes = [_axis_data(dim, page_map[dim], units.get(dim, ("", 1.0)), components) for dim in dims]
    modes = [int(mode) for mode in page_map["mode"].values]
    data = {
        "modes": modes,
        "axes": axes,
        "components": [_component_data(component, page_map) for component in model.mechanism.pose],
        "list": [page_map[name].values.tolist() for name in components]
        if LIST_DIMENSION in pose_dims
        else None,
        "limits": [
            colour_limits(page_map["frequency"].values[..., i]) for i in range(page_map.sizes["mode"])
        ],
        "section": None if plane is None else _plane_data(model, plane),
        "longer": UPRIGHT_RATIO,
        "colours": _colour_scale(),
        "decimals": DECIMALS,
        "largest": MAX_FREQUENCY,
        "packed": packed_map.packed,
    }
    sliders = [
        Slider(axis_index, axis["name"], axis["unit"], len(axis["labels"]))
        for axis_index, axis in reversed(list(enumerate(axes)))
        if len(axis["labels"]) > 1
    ]
    varying = [name for name in components if name in pose_dims and page_map.sizes[name] > 1]
    planes = [(a, b) for i, a in enumerate(varying) for b in varying[i + 1 :]]
    return Explorer(
        script_json(data),
        modes,
        sliders,
        planes if len(planes) > 1 else [],
        note=_coverage_note(packed_map, dataset),
        has_machine_view=has_machine_view,
        has_several_robots=any(axis["kind"] == "robot" and len(axis["labels"]) > 1 for axis in axes),
    )


def _plane_data(model: Model, plane: PoseGrid) -> dict[str, Any]:
    """Return the two components of a plane as figures draw them, across and upright, and the others' values [SI]."""
    varying = {name: values for name, values in plane.axes.items() if len(values) > 1}
    if len(varying) != 2:
        return {"sides": [], "at": {}}
    units = {component.name: component.unit for component in model.mechanism.pose}
    fixed = {name: float(values[0]) for name, values in plane.axes.items() if name not in varying}
    return {"sides": list(abscissa_and_ordinate(varying, units)), "at": fixed}


def _axis_data(
    name: str, values: xarray.DataArray, unit_and_factor: tuple[str, float], components: Sequence[str]
) -> Any:
    if values.dtype.kind not in "fiu" or name == LIST_DIMENSION:
        labels = [shorten(str(value)) for value in values.values]
    elif name in components:
        digits = _decimals_for_step(values.values * unit_and_factor[1])
        labels = [typeset(f"{value:.{digits}f}") for value in values.values * unit_and_factor[1] + 0.0]
    else:
        labels = [typeset(f"{value:.6g}") for value in values.values * unit_and_factor[1]]
    kind = "list" if name == LIST_DIMENSION else "pose" if name in components else "robot"
    title = {LIST_DIMENSION: "pose", "sample": "sampled robot"}.get(name, clean(name))
    numbers = values.values.tolist() if kind == "pose" else []
    return {"name": title, "unit": unit_and_factor[0], "kind": kind, "labels": labels, "values": numbers}


def _component_data(component: Any, page_map: xarray.Dataset) -> dict[str, Any]:
    unit, factor = DISPLAY_UNITS[component.unit]
    digits = _decimals_for_step(np.atleast_1d(page_map[component.name].values) * factor)
    return {"name": clean(component.name), "unit": unit, "factor": factor, "decimals": digits}


def _decimals_for_step(values: NDArray[np.float64]) -> int:
    """Return decimals that show a hundredth of the smallest step of values, between 1 and 6."""
    steps = np.diff(np.unique(values))
    steps = steps[steps > 1e-9 * np.abs(values).max(initial=1.0)]
    return min(max(math.ceil(1.0 - math.log10(steps.min())), 1), 6) if len(steps) else 1


def _colour_scale() -> list[str]:
    """Return the colours of the figures' scale, the lowest first."""
    import matplotlib
    from matplotlib.colors import to_hex

    with figure_style():
        scale = matplotlib.colormaps[matplotlib.rcParams["image.cmap"]]
    return [to_hex(scale(i / (COLOUR_COUNT - 1))) for i in range(COLOUR_COUNT)]


def _coverage_note(packed_map: MapValues, dataset: xarray.Dataset) -> str:
    """Return which poses of the map the page holds."""
    page_count, map_count = (group_thousands(part["valid"].size) for part in (packed_map.dataset, dataset))
    if not packed_map.thinned:
        return f"This page holds all {map_count} poses of the map."
    steps_in_words = []
    for dim, step in packed_map.steps.items():
        if step > 1:
            ending = "th" if 10 <= step % 100 <= 20 else {1: "st", 2: "nd", 3: "rd"}.get(step % 10, "th")
            steps_in_words.append(f"every {step}{ending} value of {clean(dim)}")
    return f"This page holds {page_count} of the {map_count} poses of the map: {', '.join(steps_in_words)}."
