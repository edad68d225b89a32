r"""Shapes of a later state without the errors that the model's shapes have in the trusted state.

A shape of the later state, :math:`\psi_b`, differs from that of the trusted one, :math:`\psi_a`, by what changed.
Both in the scale of the mode of the model, :math:`\phi`, the shape that is compared with the model is

.. math:: \phi + s_b \psi_b - s_a \psi_a

with the modal scale factors s of least squares (Allemang, Sound and Vibration 37(8), 2003), each channel in units of
its motion.
"""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.states.counterparts import Index, common_channels
from pkmodes.loop.measured.measurements import Measurements

#: Below this MAC with the mode of the model a shape has no scale.
LEAST_MAC = 0.3


def shapes_without_errors(
    trusted: Measurements, later: Measurements, counterpart: Index, modes: Array, weights: Array
) -> tuple[Array, Array]:
    """Return the shapes of a later state without the errors of the model's shapes, and their standard deviations.

    They have the components that both states have, and none if a scale is unknown.  Rows without a counterpart stay
    as they are.

    - counterpart: row of the trusted state with the same mode at the same setup, (R,); -1 where there is none
    - modes: shape of the mode of the model, at the channels of the later state, (R, C); NaN where a row has none
    - weights: factors by which the channels of the later state are comparable, (C,)

    Returns shapes and sigma, (R, C) and (R,).
    """
    shapes, sigma = later.shapes.copy(), later.shape_sigma.copy()
    mine, later_columns = common_channels(trusted, later)
    for row in np.flatnonzero(counterpart >= 0):
        before, after = trusted.shapes[counterpart[row]][mine], later.shapes[row][later_columns]
        shape, w = modes[row][later_columns], weights[later_columns]
        shapes[row] = np.nan
        common = np.isfinite(before) & np.isfinite(after) & np.isfinite(shape)
        if common.sum() < 2:
            continue
        scales = [
            _scale(w[common] * shape[common], w[common] * measured[common]) for measured in (after, before)
        ]
        if None in scales:
            continue
        a, b = (float(scale or 0.0) for scale in scales)
        compared = np.where(common, shape + a * after - b * before, np.nan)
        shapes[row, later_columns] = compared
        largest = np.nanmax(np.abs(w * compared))
        spread = np.hypot(
            a * later.shape_sigma[row] * np.nanmax(np.abs(w * after)[common]),
            b * trusted.shape_sigma[counterpart[row]] * np.nanmax(np.abs(w * before)[common]),
        )
        sigma[row] = min(spread / largest, 0.99) if largest > 0.0 else np.nan
    return shapes, sigma


def _scale(model: Array, measured: Array) -> float | None:
    """Return the factor that brings a measured shape closest to that of a mode; None if they are not alike."""
    length, along = float(measured @ measured), float(measured @ model)
    if length <= 0.0 or along**2 <= LEAST_MAC * length * float(model @ model):
        return None
    return along / length
