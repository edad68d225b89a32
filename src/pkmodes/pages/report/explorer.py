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
from pkmodes.pages.report.formatting import clean, shortened, thousands
from pkmodes.pages.report.map_values import DECIMALS, LARGEST, MapValues, values_of
from pkmodes.pages.view.page_data import script_json

if TYPE_CHECKING:
    import xarray

    from pkmodes.core.model import Model
    from pkmodes.machine.maps.poses import PoseGrid

#: Number of colours in the scale on the page.
COLOURS = 128
LIST = "pose"


def explorer_of(
    model: Model, dataset: xarray.Dataset, units: Any, *, machine: bool, plane: PoseGrid | None = None
) -> Explorer | None:
    """Return the interactive map; None unless there are several poses to choose from.

    - model: the robot as declared
    - dataset: from `pkmodes.Model.map`
    - units: unit of each axis as shown, with the factor from SI
    - machine: whether the page has a view of the machine, which follows
    - plane: that of the figures of the page: the map opens there, with the same axes
    """
    if not dataset["valid"].any():
        return None
    components = [component.name for component in model.mechanism.pose]
    dims = [str(dim) for dim in dataset["frequency"].dims[:-1]]
    places = [dim for dim in dims if dim == LIST or dim in components]
    if all(dataset.sizes[dim] == 1 for dim in places):
        return None
    values = values_of(dataset)
    part = values.dataset
    axes = [_axis(dim, part[dim], units.get(dim, ("", 1.0)), components) for dim in dims]
    modes = [int(mode) for mode in part["mode"].values]
    data = {
        "modes": modes,
        "axes": axes,
        "components": [_component(component, part) for component in model.mechanism.pose],
        "list": [part[name].values.tolist() for name in components] if LIST in places else None,
        "limits": [colour_limits(part["frequency"].values[..., i]) for i in range(part.sizes["mode"])],
        "section": None if plane is None else _section(model, plane),
        "longer": UPRIGHT_RATIO,
        "colours": _colours(),
        "decimals": DECIMALS,
        "largest": LARGEST,
        "packed": values.packed,
    }
    sliders = [
        Slider(k, axis["name"], axis["unit"], len(axis["labels"]))
        for k, axis in reversed(list(enumerate(axes)))
        if len(axis["labels"]) > 1
    ]
    several = [name for name in components if name in places and part.sizes[name] > 1]
    planes = [(a, b) for i, a in enumerate(several) for b in several[i + 1 :]]
    return Explorer(
        script_json(data),
        modes,
        sliders,
        planes if len(planes) > 1 else [],
        note=_note(values, dataset),
        machine=machine,
        varied=any(axis["kind"] == "robot" and len(axis["labels"]) > 1 for axis in axes),
    )


def _section(model: Model, plane: PoseGrid) -> dict[str, Any]:
    """Return the two components of a plane as figures draw them, across and upright, and the others' values [SI]."""
    several = {name: values for name, values in plane.axes.items() if len(values) > 1}
    if len(several) != 2:
        return {"sides": [], "at": {}}
    units = {component.name: component.unit for component in model.mechanism.pose}
    at = {name: float(values[0]) for name, values in plane.axes.items() if name not in several}
    return {"sides": list(abscissa_and_ordinate(several, units)), "at": at}


def _axis(name: str, values: xarray.DataArray, shown: tuple[str, float], components: Sequence[str]) -> Any:
    if values.dtype.kind not in "fiu" or name == LIST:
        labels = [shortened(str(value)) for value in values.values]
    elif name in components:
        digits = _digits(values.values * shown[1])
        labels = [typeset(f"{value:.{digits}f}") for value in values.values * shown[1] + 0.0]
    else:
        labels = [typeset(f"{value:.6g}") for value in values.values * shown[1]]
    kind = "list" if name == LIST else "pose" if name in components else "robot"
    title = {LIST: "pose", "sample": "sampled robot"}.get(name, clean(name))
    numbers = values.values.tolist() if kind == "pose" else []
    return {"name": title, "unit": shown[0], "kind": kind, "labels": labels, "values": numbers}


def _component(component: Any, part: xarray.Dataset) -> dict[str, Any]:
    unit, factor = DISPLAY_UNITS[component.unit]
    digits = _digits(np.atleast_1d(part[component.name].values) * factor)
    return {"name": clean(component.name), "unit": unit, "factor": factor, "decimals": digits}


def _digits(values: NDArray[np.float64]) -> int:
    """Return decimals that show a hundredth of the smallest step of values, between 1 and 6."""
    steps = np.diff(np.unique(values))
    steps = steps[steps > 1e-9 * np.abs(values).max(initial=1.0)]
    return min(max(math.ceil(1.0 - math.log10(steps.min())), 1), 6) if len(steps) else 1


def _colours() -> list[str]:
    """Return the colours of the figures' scale, the lowest first."""
    import matplotlib
    from matplotlib.colors import to_hex

    with figure_style():
        scale = matplotlib.colormaps[matplotlib.rcParams["image.cmap"]]
    return [to_hex(scale(i / (COLOURS - 1))) for i in range(COLOURS)]


def _note(values: MapValues, dataset: xarray.Dataset) -> str:
    """Return which poses of the map the page holds."""
    held, total = (thousands(part["valid"].size) for part in (values.dataset, dataset))
    if not values.thinned:
        return f"This page holds all {total} poses of the map."
    kept = []
    for dim, step in values.steps.items():
        if step > 1:
            ending = "th" if 10 <= step % 100 <= 20 else {1: "st", 2: "nd", 3: "rd"}.get(step % 10, "th")
            kept.append(f"every {step}{ending} value of {clean(dim)}")
    return f"This page holds {held} of the {total} poses of the map: {', '.join(kept)}."
