r"""Residuals of measured mode shapes, independent of their scale and of mixing between close modes.

The residual of a measured shape s of any scale with respect to a shape :math:`\phi` of the model is

.. math:: r = s - \phi \, (\phi^T s) / (\phi^T \phi), \qquad dr = -\frac{\phi^T s}{\phi^T \phi} P d\phi ,

where P projects out :math:`\phi` (variable projection; Kaufman, BIT 15, 1975).  Modes whose measured frequencies
nearly agree are projected out together.  Components are relative to the largest of their row, so their standard
deviation is the stated ``sigma_shape``.  If none is stated, the scatter is that of the best explanation, and metres
and radians are scaled by the motion of their channels in the declared model.
"""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import subspace_basis
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.match.pairing import Pairing, close_rows, tile_indices, unpaired_close_modes
from pkmodes.loop.diagnosis.match.shape_errors import shape_errors
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.measured.measurements import Measurements


class _ModeSpaces(NamedTuple):
    """Rows compared with several modes each; bases of the modes, their amplitudes in the row, and their numbers."""

    rows: NDArray[np.intp]
    basis: Array
    amplitudes: Array
    modes: NDArray[np.intp]


class ShapeRows:
    """Measured shapes as data of a fit, a `ComparedQuantity`.

    - columns: indices of the measured channels among the model's, (C,)
    - units: units of the measured channels, length C
    - motion: motion of each channel in the declared model, see `support.mac.channel_motion`, (S, C)
    - shape_scatter: standard deviation of the components of rows without a stated one

    Its attributes:
    - known: rows with a usable shape, (R,)
    - stated: rows with a stated standard deviation, (R,)
    - count: degrees of freedom of each shape, (R,): its components less one for each mode that it is compared with
    - sigma: standard deviations of the components, (R, C)
    """

    def __init__(
        self,
        data: Measurements,
        columns: NDArray[np.intp],
        units: Sequence[str],
        motion: Array,
        shape_scatter: float,
        criteria: Criteria,
    ) -> None:
        self._columns, self._pose, self._setups = columns, data.pose, len(data.labels)
        measured = np.isfinite(data.shapes)
        self.stated = np.isfinite(data.shape_sigma) & measured.any(axis=1)
        weights = np.where(self.stated[:, None], 1.0, _scales(units, motion))
        self._weights = np.where(measured, weights, 0.0)
        shapes = np.where(measured, data.shapes, 0.0) * self._weights
        largest = np.abs(shapes).max(axis=1, initial=0.0, keepdims=True)
        self._shapes = shapes / np.where(largest > 0.0, largest, 1.0)
        components = (self._weights > 0.0).sum(axis=1)
        self.known = (components >= 2) & (largest[:, 0] > 0.0)
        self._shapes[~self.known] = 0.0
        self.count = np.where(self.known, components - 1, 0)
        row_sigma = np.where(self.stated, shape_errors(data, criteria), shape_scatter)
        self.sigma = np.broadcast_to(row_sigma[:, None], data.shapes.shape)
        self._close = criteria.pairing.close
        # Rows that are compared with the modes of several rows at once.
        compared_rows = close_rows(data, criteria)
        mode_counts = (compared_rows >= 0).sum(axis=1)
        # As many modes as components explain any shape: such a row carries no information.
        uninformative = (mode_counts > 1) & ~(self.known & (mode_counts <= self.count))
        self.known[uninformative], self.count[uninformative], self._shapes[uninformative] = False, 0, 0.0
        self._close_rows = np.where(uninformative[:, None], -1, compared_rows)
        self._close_rows[:, 0] = compared_rows[:, 0]
        self.count -= np.where(uninformative, 0, mode_counts - 1)

    def tiled(self, count: int) -> ShapeRows:
        """Return the same for predictions of `count` times the setups."""
        copies, rows = copy.copy(self), len(self._shapes)
        copies._pose = tile_indices(self._pose, count, self._setups)
        copies._close_rows = tile_indices(self._close_rows, count, rows)
        copies._shapes = np.tile(self._shapes, (count, 1))
        copies._weights = np.tile(self._weights, (count, 1))
        copies.sigma, copies.known = np.tile(self.sigma, (count, 1)), np.tile(self.known, count)
        copies.stated, copies.count = np.tile(self.stated, count), np.tile(self.count, count)
        return copies

    @property
    def shape_rates(self) -> bool:
        """Whether any shape was measured, whose derivatives need those of the shapes of the model."""
        return self._shapes.size > 0

    def residual(self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]) -> Array:
        """Return the residuals with respect to the shapes of the partners, (R, C)."""
        if not self._shapes.size:
            return self._shapes
        return self._project(prediction, pairing, used_row_mask)[0]

    def rates(self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]) -> Array:
        """Return the derivatives of what the model predicts, the measured shape less the residual, (R, C, T)."""
        if prediction.shape_rates is None or not self._shapes.size:
            return np.zeros((*self._shapes.shape, prediction.rates.shape[-1]))
        _, phi, amplitude, (space_rows, basis, amplitudes, modes) = self._project(
            prediction, pairing, used_row_mask
        )
        row_modes = self._pose, np.maximum(pairing.partner, 0)
        changes = prediction.shape_rates[row_modes][:, self._columns] * self._weights[..., None]
        size = np.maximum((phi**2).sum(axis=1), 1e-300)
        inside = np.einsum("rc,rct->rt", phi, changes) / size[:, None]
        derivatives = amplitude[:, None, None] * (changes - phi[..., None] * inside[:, None])
        if len(space_rows):
            member_rates = prediction.shape_rates[self._pose[space_rows][:, None], modes][:, :, self._columns]
            change = (
                np.einsum("bg,bgct->bct", amplitudes, member_rates) * self._weights[space_rows][..., None]
            )
            derivatives[space_rows] = change - np.swapaxes(basis, -1, -2) @ (basis @ change)
        return np.asarray(
            np.where((self.known & used_row_mask & (pairing.partner >= 0))[:, None, None], derivatives, 0.0)
        )

    def _project(
        self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]
    ) -> tuple[Array, Array, Array, _ModeSpaces]:
        """Return residuals, the partners' shapes in the rows' weighting, their amplitude in each row, and spaces."""
        partner = np.maximum(pairing.partner, 0)
        phi = prediction.shapes[self._pose, partner][:, self._columns] * self._weights
        phi = np.where((pairing.partner >= 0)[:, None], phi, 0.0)
        amplitude = (phi * self._shapes).sum(axis=1) / np.maximum((phi**2).sum(axis=1), 1e-300)
        residual = self._shapes - phi * amplitude[:, None]
        spaces = self._spaces(prediction, pairing, used_row_mask)
        rows, basis = spaces.rows, spaces.basis
        if len(rows):
            projection = (np.swapaxes(basis, -1, -2) @ (basis @ self._shapes[rows][..., None]))[..., 0]
            residual[rows] = self._shapes[rows] - projection
        return np.where((self.known & used_row_mask)[:, None], residual, 0.0), phi, amplitude, spaces

    def _spaces(
        self, prediction: Prediction, pairing: Pairing, used_row_mask: NDArray[np.bool_]
    ) -> _ModeSpaces:
        partner = np.where(used_row_mask, pairing.partner, -1)
        unpaired_modes = unpaired_close_modes(prediction, partner, self._pose, self._close)
        has_several_modes = (
            (self._close_rows[:, 1:] >= 0).any(axis=1) | (unpaired_modes >= 0).any(axis=1)
        ) & self.known
        rows = np.flatnonzero(has_several_modes & (partner >= 0))
        close_rows = self._close_rows[rows]
        measured = np.where(close_rows >= 0, partner[close_rows], -1)
        # With as many modes as components, the residual is zero.
        modes = np.hstack([measured, unpaired_modes[rows]])
        is_mode, modes = modes >= 0, np.maximum(modes, 0)
        shapes = prediction.shapes[self._pose[rows][:, None], modes][..., self._columns]
        basis, coefficients = subspace_basis(shapes * self._weights[rows][:, None] * is_mode[..., None])
        amplitudes = ((basis @ self._shapes[rows][..., None])[..., 0, None] * coefficients).sum(axis=1)
        return _ModeSpaces(rows, basis, amplitudes, modes)


def _scales(units: Sequence[str], motion: Array) -> Array:
    """Return the reciprocal rms motion of the channels of each unit over all setups, (C,); 0 if they do not move."""
    scales = np.zeros(len(units))
    for unit in set(units):
        channels = [i for i, unit_of_channel in enumerate(units) if unit_of_channel == unit]
        size = float(np.sqrt(np.mean(motion[:, channels] ** 2)))
        scales[channels] = 1.0 / size if size > 0.0 else 0.0
    return scales
