"""How the shape of a mode changed between two measurements, channel by channel, with its standard deviation.

A shape has any scale and sign, so the second is first scaled to the first by least squares; what is then left is the
change.  A change at one place thus moves, by a little, what all other channels show.  Where channels are a series of
sensors along a line, the second difference of the change is that of the curvature, which a local loss of stiffness
raises at its place (Pandey, Biswas and Samman, J. Sound Vib. 145, 1991, 321-332), but which also has sqrt(6) times
the noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray
from scipy.special import chdtrc

from pkmodes.core.support.documents import Document, Probability, Size
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.series import series_of

Array = NDArray[np.float64]
#: Fewest channels at which a change of shape is looked for: with two, a single number, the MAC, describes it.
FEWEST_CHANNELS = 3
#: Second difference over three neighbours.
SECOND_DIFFERENCE = np.array([1.0, -2.0, 1.0])


class PlaceChange(Document, frozen=True):
    """The change of a shape, or of its curvature, at one channel."""

    channel: Annotated[str, Meta(description="The channel; of a curvature, that in the middle.")]
    first: Annotated[float, Meta(description="In the first file, relative to its largest common component.")]
    second: Annotated[float, Meta(description="In the second file, scaled to the first by least squares.")]
    change: Annotated[float, Meta(description="second - first.")]
    sigma: Annotated[
        Size | None,
        Meta(description="Standard deviation of it; null without sigma_shape in both."),
    ]
    sigmas: Annotated[float | None, Meta(description="The change in standard deviations.")]
    differs: Annotated[
        bool,
        Meta(
            description="Whether it is one at the level of 1 % of all places of all shapes together (Holm)."
        ),
    ]


class ShapeChange(Document, frozen=True):
    """The change of the shape of a mode."""

    chi2: Annotated[Size | None, Meta(description="Of the whole shape; null without sigma_shape in both.")]
    p_value: Annotated[Probability | None, Meta(description="Of chi2 if the shape did not change.")]
    components: Annotated[list[PlaceChange], Meta(description="Of each channel that both files have.")]
    curvatures: Annotated[
        list[PlaceChange],
        Meta(description="Second differences along channels numbered in a series; empty without such."),
    ]


@dataclass(frozen=True)
class Aligned:
    """The shapes of one mode in two files, at the C channels that both have.

    - channels: length C
    - first, second: the first relative to its largest component, and the second scaled to it, (C,)
    - errors: standard deviation of the components of each, NaN where not stated
    - covariance: that of second - first, (C, C)
    """

    channels: tuple[str, ...]
    first: Array
    second: Array
    errors: tuple[float, float]
    covariance: Array


def aligned(first: Measurements, second: Measurements, row: int, second_row: int) -> Aligned | None:
    """Return the shapes of a pair at the channels of both; None where they have no shape at three or more.

    - row, second_row: of the mode in each
    """
    names = [name for name in first.channels if name in second.channels]
    a = first.shapes[row, [first.channels.index(name) for name in names]]
    b = second.shapes[second_row, [second.channels.index(name) for name in names]]
    measured = np.isfinite(a) & np.isfinite(b)
    a, b = a[measured], b[measured]
    if measured.sum() < FEWEST_CHANNELS or not (a.any() and b.any()):
        return None
    scale = np.abs(a).max()
    a = a / scale
    factor = a @ b / (b @ b)
    of_first = first.shape_sigma[row] * np.nanmax(np.abs(first.shapes[row])) / scale
    of_second = second.shape_sigma[second_row] * np.nanmax(np.abs(second.shapes[second_row]))
    return Aligned(
        channels=tuple(name for name, used in zip(names, measured, strict=True) if used),
        first=a,
        second=factor * b,
        errors=(float(of_first), float(abs(factor) * of_second)),
        covariance=change_covariance(a, b, of_first, of_second),
    )


def change_covariance(first: Array, second: Array, sigma: float, second_sigma: float) -> Array:
    """Return the covariance of what is left of two shapes, the second scaled to the first by least squares.

    To first order in the errors, with the leading term of second order, which is all that a component has which
    holds nearly the whole shape.

    - first, second: not zero, (C,)
    - sigma, second_sigma: standard deviations of the components of each, independent of each other

    Returns (C, C), of ``factor * second - first``, in the units of the first.
    """
    size, unit = second @ second, np.eye(len(first))
    factor = first @ second / size
    by_first = np.outer(second, second) / size - unit
    by_second = factor * unit + np.outer(second, first - 2.0 * factor * second) / size
    linear = sigma**2 * by_first @ by_first.T + second_sigma**2 * by_second @ by_second.T
    # What is left is across the second shape, which its errors g turn: along itself it is -g (g - e), e of the first.
    across, turned = len(first) - 1, (factor * second_sigma) ** 2
    square = (across**2 + 2.0 * across) * turned**2 + across * sigma**2 * turned
    return np.asarray(linear + square / (first @ first) ** 2 * np.outer(first, first))


def shape_change(shapes: Aligned, chain: bool) -> ShapeChange:
    """Return the change of a shape at each channel, and of its curvature along series of channels.

    - chain: whether numbered channels are taken as a series along a line
    """
    change = shapes.second - shapes.first
    total = float(change @ change) / (shapes.errors[0] ** 2 + shapes.errors[1] ** 2)
    stated = bool(np.isfinite(total))
    curvatures = []
    for members in series_of(shapes.channels) if chain else []:
        weights = np.zeros((len(members) - 2, len(change)))
        for i, weight in enumerate(weights):
            weight[members[i : i + 3]] = SECOND_DIFFERENCE
        curvatures += _places_changed(
            [shapes.channels[k] for k in members[1:-1]],
            weights @ shapes.first,
            weights @ shapes.second,
            weights @ shapes.covariance @ weights.T,
        )
    return ShapeChange(
        chi2=total if stated else None,
        p_value=float(chdtrc(len(change) - 1, total)) if stated else None,
        components=_places_changed(shapes.channels, shapes.first, shapes.second, shapes.covariance),
        curvatures=curvatures,
    )


def _places_changed(
    channels: Sequence[str], first: Array, second: Array, covariance: Array
) -> list[PlaceChange]:
    """Return the changes at some channels."""
    sigmas = np.sqrt(np.diag(covariance))
    return [
        PlaceChange(
            channel=channel,
            first=float(a),
            second=float(b),
            change=float(b - a),
            sigma=float(sigma) if np.isfinite(sigma) else None,
            sigmas=float((b - a) / sigma) if np.isfinite(sigma) else None,
            differs=False,  # until all places are judged together
        )
        for channel, a, b, sigma in zip(channels, first, second, sigmas, strict=True)
    ]
