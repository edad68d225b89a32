"""Frequencies against a swept parameter or along a list of poses, and their scatter over sampled robots."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import SHOWN
from pkmodes.plots.labels import short
from pkmodes.plots.style import BLUE, GREY, PALETTE, VERMILLION, figure

if TYPE_CHECKING:
    import xarray
    from matplotlib.figure import Figure

Array = NDArray[Any]
#: Names of poses written at most under an axis.
LABELS = 24
#: Values below which 2 % of them are less than one: the band then shows all of them.
FEW = 50
#: Quantiles at the edges of a band of many values, and of few.
INNER, ALL = (0.02, 0.5, 0.98), (0.0, 0.5, 1.0)


def against(dataset: xarray.Dataset, path: str, spread: Array | None = None) -> Figure:
    """Draw the frequency of each mode against one axis of a map: median and range over everything else.

    The band leaves out the lowest and the highest 2 % of many values, as the table of a map does: a few poses at the
    edge of the workspace would hide everything else.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map.
    path : str
        The axis: a swept parameter, in SI units, or a component of the pose, in the units of figures.
    spread : ndarray, shape (values, modes), optional
        Standard deviations of the frequencies along the axis [Hz], as a band; for a map without other axes.
    """
    order = np.argsort(dataset[path].values, kind="stable")
    dataset = dataset.isel({path: order})
    unit, factor = dataset[path].attrs["units"], 1.0
    if "." not in path:  # a component of the pose
        unit, factor = SHOWN[unit]
    values = dataset[path].values * factor
    frequency = _flat(dataset, path)
    shares = ALL if frequency.shape[1] < FEW else INNER
    modes = frequency.shape[-1]
    columns = min(modes, 3)
    drawn = figure(1.75 * -(-modes // columns) + 0.2)
    panels = drawn.subplots(-(-modes // columns), columns, squeeze=False, sharex=True)
    for mode, axes in enumerate(panels.flat):
        if mode >= modes:
            axes.set_axis_off()
            continue
        low, middle, high = _quantiles(frequency[..., mode], shares)
        if spread is not None:
            low, high = middle - spread[order, mode], middle + spread[order, mode]
        axes.fill_between(values, low, high, color=BLUE, alpha=0.18, linewidth=0)
        axes.plot(values, middle, color=BLUE, marker="o" if len(values) <= 15 else None)
        axes.set_title(f"mode {mode + 1}")
        if mode % columns == 0:
            axes.set_ylabel("f [Hz]")
        if mode + columns >= modes:
            axes.set_xlabel(f"{path} [{unit}]")
            axes.tick_params(labelbottom=True)
    return drawn


def along(dataset: xarray.Dataset, spread: Array | None = None) -> Figure:
    """Draw the frequencies along a list of poses.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map with the dimension ``pose``.
    spread : ndarray, shape (poses, modes), optional
        Standard deviations of the frequencies [Hz], as bands.
    """
    every = _flat(dataset, "pose")
    frequency = np.stack(
        [_quantiles(every[..., mode], (0.5,))[0] for mode in range(every.shape[-1])], axis=-1
    )
    labels = [short(label) for label in dataset["pose"].values]
    drawn = figure(3.0)
    axes = drawn.add_subplot()
    for mode in range(frequency.shape[-1]):
        colour = PALETTE[mode % len(PALETTE)]
        style = "-" if mode < len(PALETTE) else "--"
        marker = "o" if len(labels) <= 60 else None
        if spread is not None:
            low, high = (frequency[:, mode] + side * spread[:, mode] for side in (-1.0, 1.0))
            axes.fill_between(range(len(labels)), low, high, color=colour, alpha=0.18, linewidth=0)
        axes.plot(frequency[:, mode], style, color=colour, marker=marker, label=f"mode {mode + 1}")
    step = max(1, -(-len(labels) // LABELS))
    axes.set_xticks(range(0, len(labels), step), labels[::step], rotation=90 if len(labels) > 10 else 0)
    axes.set_xlabel("pose")
    axes.set_ylabel("f [Hz]")
    drawn.legend(loc="outside right upper")
    return drawn


def scatter(dataset: xarray.Dataset) -> Figure:
    """Draw by how much the frequencies of sampled robots differ from the median robot at the same pose.

    Parameters
    ----------
    dataset : xarray.Dataset
        A map with the dimension ``sample``.
    """
    frequency = _flat(dataset, "sample")
    modes = frequency.shape[-1]
    middle = [_quantiles(frequency[..., mode].T, (0.5,))[0] for mode in range(modes)]
    relative = 100.0 * (frequency / np.stack(middle, axis=-1) - 1.0)
    drawn = figure(2.6)
    axes = drawn.add_subplot()
    axes.axhline(0.0, color=GREY, linewidth=0.8)
    for mode in range(modes):
        values = relative[..., mode][np.isfinite(relative[..., mode])]
        if not len(values):
            continue
        ends, quarter, middle, three, top = np.quantile(values, [0.025, 0.25, 0.5, 0.75, 0.975])
        axes.plot([mode + 1] * 2, [ends, top], color=BLUE, linewidth=1.2)
        axes.plot([mode + 1] * 2, [quarter, three], color=BLUE, linewidth=7, solid_capstyle="butt")
        axes.plot(mode + 1, middle, "o", color=VERMILLION)
    axes.set_xticks(range(1, modes + 1))
    axes.set_xlim(0.5, modes + 0.5)
    axes.set_xlabel("mode")
    axes.set_ylabel("f / median at the pose \u2212 1 [%]")
    return drawn


def _flat(dataset: xarray.Dataset, dim: str) -> Array:
    """Return the frequencies as (values of a dimension, everything else, modes)."""
    frequencies = dataset["frequency"].transpose(dim, ..., "mode").values
    return frequencies.reshape(frequencies.shape[0], -1, frequencies.shape[-1])


def _quantiles(values: Array, shares: tuple[float, ...]) -> Array:
    """Return quantiles along the second axis, NaN where no pose can be evaluated."""
    quantiles = np.full((len(shares), len(values)), np.nan)
    some = np.isfinite(values).any(axis=1)
    if some.any():
        quantiles[:, some] = np.nanquantile(values[some], shares, axis=1)
    return quantiles
