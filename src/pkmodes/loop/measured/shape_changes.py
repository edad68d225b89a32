"""How the shape of a mode changed between two measurements, channel by channel, with its standard deviation.

The scale and sign of a shape are arbitrary, so the second is first scaled to the first by least squares; what is then
left is the change.  A change at one place therefore slightly affects all other channels.  Where channels are a series
of sensors along a line, the second difference of the change is the change of curvature, which a local loss of
stiffness raises at its place (Pandey, Biswas and Samman, J. Sound Vib. 145, 1991, 321-332), but which also has
sqrt(6) times the noise.
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
#: Smallest number of channels for a change of shape: with two, a single number, the MAC, describes it.
MIN_CHANNELS = 3
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
class AlignedShapes:
    """The shapes of one mode in two files, at the C channels that both have.

    - channels: length C
    - first, second: the first relative to its largest component, and the second scaled to it, (C,)
    - sigmas: standard deviation of the components of each, NaN where not stated
    - covariance: covariance of second - first, (C, C)
    """

    channels: tuple[str, ...]
    first: Array
    second: Array
    sigmas: tuple[float, float]
    covariance: Array


def align_shapes(
    first: Measurements, second: Measurements, row: int, second_row: int
) -> AlignedShapes | None:
    """Return the shapes of a pair at the channels of both; None where they have no shape at three or more.

    - row, second_row: row of the mode in each measurement
    """
    names = [name for name in first.channels if name in second.channels]
    a = first.shapes[row, [first.channels.index(name) for name in names]]
    b = second.shapes[second_row, [second.channels.index(name) for name in names]]
    measured = np.isfinite(a) & np.isfinite(b)
    a, b = a[measured], b[measured]
    if measured.sum() < MIN_CHANNELS or not (a.any() and b.any()):
        return None
    # The shapes are relative to the largest common component of the first, but sigma_shape to the largest of its row.
    scale = np.abs(a).max()
    a = a / scale
    factor = a @ b / (b @ b)
    sigma_first = first.shape_sigma[row] * np.nanmax(np.abs(first.shapes[row])) / scale
    sigma_second = second.shape_sigma[second_row] * np.nanmax(np.abs(second.shapes[second_row]))
    return AlignedShapes(
        channels=tuple(name for name, used in zip(names, measured, strict=True) if used),
        first=a,
        second=factor * b,
        sigmas=(float(sigma_first), float(abs(factor) * sigma_second)),
        covariance=change_covariance(a, b, sigma_first, sigma_second),
    )


def change_covariance(first: Array, second: Array, sigma: float, second_sigma: float) -> Array:
    """Return the covariance of the change of a shape, with the second scaled to the first by least squares.

    To first order in the errors, plus the leading second-order term, the only one that is left for a component that
    makes up nearly the whole shape.

    - first, second: not zero, (C,)
    - sigma, second_sigma: standard deviations of the components of each, independent of each other

    Returns (C, C), of ``factor * second - first``, in the units of the first.
    """
    squared_norm, identity = second @ second, np.eye(len(first))
    factor = first @ second / squared_norm
    jacobian_first = np.outer(second, second) / squared_norm - identity
    jacobian_second = factor * identity + np.outer(second, first - 2.0 * factor * second) / squared_norm
    linear = (
        sigma**2 * jacobian_first @ jacobian_first.T + second_sigma**2 * jacobian_second @ jacobian_second.T
    )
    # The residual is orthogonal to the second shape, which its errors g rotate; along that shape it is -g (g - e),
    # with e the errors of the first.
    transverse_count, rotation_variance = len(first) - 1, (factor * second_sigma) ** 2
    second_order = (
        transverse_count**2 + 2.0 * transverse_count
    ) * rotation_variance**2 + transverse_count * sigma**2 * rotation_variance
    return np.asarray(linear + second_order / (first @ first) ** 2 * np.outer(first, first))


def shape_change(shapes: AlignedShapes, in_series: bool) -> ShapeChange:
    """Return the change of a shape at each channel, and of its curvature along series of channels.

    - in_series: whether numbered channels are taken as a series along a line
    """
    change = shapes.second - shapes.first
    chi2 = float(change @ change) / (shapes.sigmas[0] ** 2 + shapes.sigmas[1] ** 2)
    has_stated_errors = bool(np.isfinite(chi2))
    curvatures = []
    for members in series_of(shapes.channels) if in_series else []:
        weights = np.zeros((len(members) - 2, len(change)))
        for i, weight in enumerate(weights):
            weight[members[i : i + 3]] = SECOND_DIFFERENCE
        curvatures += _changes_at_channels(
            [shapes.channels[k] for k in members[1:-1]],
            weights @ shapes.first,
            weights @ shapes.second,
            weights @ shapes.covariance @ weights.T,
        )
    return ShapeChange(
        chi2=chi2 if has_stated_errors else None,
        p_value=float(chdtrc(len(change) - 1, chi2)) if has_stated_errors else None,
        components=_changes_at_channels(shapes.channels, shapes.first, shapes.second, shapes.covariance),
        curvatures=curvatures,
    )


def _changes_at_channels(
    channels: Sequence[str], first: Array, second: Array, covariance: Array
) -> list[PlaceChange]:
    """Return the changes at some channels."""
    standard_deviations = np.sqrt(np.diag(covariance))
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
        for channel, a, b, sigma in zip(channels, first, second, standard_deviations, strict=True)
    ]
