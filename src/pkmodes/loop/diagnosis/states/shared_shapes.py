r"""Shapes of a later state, corrected for the model errors seen in the trusted state.

A shape of the later state, :math:`\psi_b`, differs from that of the trusted one, :math:`\psi_a`, by what changed.
With both scaled to the model's mode :math:`\phi`, the shape compared with the model is

.. math:: \phi + s_b \psi_b - s_a \psi_a

with the modal scale factors s of least squares (Allemang, Sound and Vibration 37(8), 2003), each channel in units of
its motion.
"""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.states.counterparts import Index, common_channels
from pkmodes.loop.measured.measurements import Measurements

#: Minimum MAC with the model's mode for a shape to be scaled to it.
MIN_MAC = 0.3
#: Largest standard deviation of a shape, relative to its largest component: it stays below one.
MAX_SIGMA = 0.99


def corrected_shapes(
    trusted: Measurements, later: Measurements, trusted_rows: Index, model_shapes: Array, weights: Array
) -> tuple[Array, Array]:
    """Return the corrected shapes of a later state, and their standard deviations.

    Only components measured in both states are finite; if a scale is unknown, all are NaN.  Rows without a
    counterpart stay as they are.

    - trusted_rows: row of the trusted state with the same mode at the same setup, (R,); -1 where there is none
    - model_shapes: mode shapes of the model at the channels of the later state, (R, C); NaN where a row has none
    - weights: factors by which the channels of the later state are comparable, (C,)

    Returns shapes and sigma, (R, C) and (R,).
    """
    shapes, sigma = later.shapes.copy(), later.shape_sigma.copy()
    trusted_columns, later_columns = common_channels(trusted, later)
    for row in np.flatnonzero(trusted_rows >= 0):
        before, after = trusted.shapes[trusted_rows[row]][trusted_columns], later.shapes[row][later_columns]
        model_shape, channel_weights = model_shapes[row][later_columns], weights[later_columns]
        shapes[row] = np.nan
        is_common = np.isfinite(before) & np.isfinite(after) & np.isfinite(model_shape)
        if is_common.sum() < 2:
            continue
        scales = [
            _scale(
                channel_weights[is_common] * model_shape[is_common],
                channel_weights[is_common] * measured[is_common],
            )
            for measured in (after, before)
        ]
        if None in scales:
            continue
        later_scale, trusted_scale = (float(scale or 0.0) for scale in scales)
        compared_shape = np.where(
            is_common, model_shape + later_scale * after - trusted_scale * before, np.nan
        )
        shapes[row, later_columns] = compared_shape
        max_component = np.nanmax(np.abs(channel_weights * compared_shape))
        spread = np.hypot(
            later_scale * later.shape_sigma[row] * np.nanmax(np.abs(channel_weights * after)[is_common]),
            trusted_scale
            * trusted.shape_sigma[trusted_rows[row]]
            * np.nanmax(np.abs(channel_weights * before)[is_common]),
        )
        sigma[row] = min(spread / max_component, MAX_SIGMA) if max_component > 0.0 else np.nan
    return shapes, sigma


def _scale(model: Array, measured: Array) -> float | None:
    """Return the factor that brings a measured shape closest to that of a mode; None if they are not alike."""
    length, along = float(measured @ measured), float(measured @ model)
    if length <= 0.0 or along**2 <= MIN_MAC * length * float(model @ model):
        return None
    return along / length
