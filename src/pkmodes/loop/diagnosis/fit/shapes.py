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
from pkmodes.loop.diagnosis.match.pairing import Pairing, neighbours, tiled, unmeasured_neighbours
from pkmodes.loop.diagnosis.match.shape_errors import shape_errors
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.measured.measurements import Measurements


class _Spaces(NamedTuple):
    """The rows compared with several modes, the modes' bases and amplitudes in the row, and the modes."""

    rows: NDArray[np.intp]
    basis: Array
    share: Array
    modes: NDArray[np.intp]


class ShapeRows:
    """Measured shapes as data of a fit, a `ComparedQuantity`.

    - columns: indices of the measured channels among the model's, (C,)
    - units: units of the measured channels, length C
    - moves: motion of each channel in the declared model, see `support.mac.channel_motion`, (S, C)
    - scatter: standard deviation of the components of rows without a stated one

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
        moves: Array,
        scatter: float,
        criteria: Criteria,
    ) -> None:
        self._columns, self._pose, self._setups = columns, data.pose, len(data.labels)
        measured = np.isfinite(data.shapes)
        self.stated = np.isfinite(data.shape_sigma) & measured.any(axis=1)
        weights = np.where(self.stated[:, None], 1.0, _scales(units, moves))
        self._weights = np.where(measured, weights, 0.0)
        shapes = np.where(measured, data.shapes, 0.0) * self._weights
        largest = np.abs(shapes).max(axis=1, initial=0.0, keepdims=True)
        self._shapes = shapes / np.where(largest > 0.0, largest, 1.0)
        components = (self._weights > 0.0).sum(axis=1)
        self.known = (components >= 2) & (largest[:, 0] > 0.0)
        self._shapes[~self.known] = 0.0
        self.count = np.where(self.known, components - 1, 0)
        by_row = np.where(self.stated, shape_errors(data, criteria), scatter)
        self.sigma = np.broadcast_to(by_row[:, None], data.shapes.shape)
        self._close = criteria.pairing.close
        # Rows that are compared with the modes of several rows at once.
        mates = neighbours(data, criteria)
        several = (mates >= 0).sum(axis=1)
        # As many modes as components explain any shape: such a row carries no information.
        silent = (several > 1) & ~(self.known & (several <= self.count))
        self.known[silent], self.count[silent], self._shapes[silent] = False, 0, 0.0
        self._mates = np.where(silent[:, None], -1, mates)
        self._mates[:, 0] = mates[:, 0]
        self.count -= np.where(silent, 0, several - 1)

    def tiled(self, count: int) -> ShapeRows:
        """Return the same for predictions of `count` times the setups."""
        copies, rows = copy.copy(self), len(self._shapes)
        copies._pose = tiled(self._pose, count, self._setups)
        copies._mates = tiled(self._mates, count, rows)
        copies._shapes = np.tile(self._shapes, (count, 1))
        copies._weights = np.tile(self._weights, (count, 1))
        copies.sigma, copies.known = np.tile(self.sigma, (count, 1)), np.tile(self.known, count)
        copies.stated, copies.count = np.tile(self.stated, count), np.tile(self.count, count)
        return copies

    @property
    def shape_rates(self) -> bool:
        """Whether any shape was measured, whose derivatives need those of the shapes of the model."""
        return self._shapes.size > 0

    def residual(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Return the residuals with respect to the shapes of the partners, (R, C)."""
        if not self._shapes.size:
            return self._shapes
        return self._projected(prediction, pairing, used)[0]

    def rates(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Return the derivatives of what the model predicts, the measured shape less the residual, (R, C, T)."""
        if prediction.shape_rates is None or not self._shapes.size:
            return np.zeros((*self._shapes.shape, prediction.rates.shape[-1]))
        _, phi, along, (i, basis, share, modes) = self._projected(prediction, pairing, used)
        take = self._pose, np.maximum(pairing.partner, 0)
        changes = prediction.shape_rates[take][:, self._columns] * self._weights[..., None]
        size = np.maximum((phi**2).sum(axis=1), 1e-300)
        inside = np.einsum("rc,rct->rt", phi, changes) / size[:, None]
        derivatives = along[:, None, None] * (changes - phi[..., None] * inside[:, None])
        if len(i):
            moved = prediction.shape_rates[self._pose[i][:, None], modes][:, :, self._columns]
            change = np.einsum("bg,bgct->bct", share, moved) * self._weights[i][..., None]
            derivatives[i] = change - np.swapaxes(basis, -1, -2) @ (basis @ change)
        return np.asarray(
            np.where((self.known & used & (pairing.partner >= 0))[:, None, None], derivatives, 0.0)
        )

    def _projected(
        self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]
    ) -> tuple[Array, Array, Array, _Spaces]:
        """Return residuals, the partners' shapes in the rows' weighting, their amplitude in each row, and spaces."""
        partner = np.maximum(pairing.partner, 0)
        phi = prediction.shapes[self._pose, partner][:, self._columns] * self._weights
        phi = np.where((pairing.partner >= 0)[:, None], phi, 0.0)
        along = (phi * self._shapes).sum(axis=1) / np.maximum((phi**2).sum(axis=1), 1e-300)
        residual = self._shapes - phi * along[:, None]
        spaces = self._spaces(prediction, pairing, used)
        i, basis = spaces.rows, spaces.basis
        if len(i):
            inside = (np.swapaxes(basis, -1, -2) @ (basis @ self._shapes[i][..., None]))[..., 0]
            residual[i] = self._shapes[i] - inside
        return np.where((self.known & used)[:, None], residual, 0.0), phi, along, spaces

    def _spaces(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> _Spaces:
        partner = np.where(used, pairing.partner, -1)
        beside = unmeasured_neighbours(prediction, partner, self._pose, self._close)
        several = ((self._mates[:, 1:] >= 0).any(axis=1) | (beside >= 0).any(axis=1)) & self.known
        i = np.flatnonzero(several & (partner >= 0))
        mates = self._mates[i]
        measured = np.where(mates >= 0, partner[mates], -1)
        modes = np.hstack([measured, beside[i]])  # if as many as the components, the residual is zero
        present, modes = modes >= 0, np.maximum(modes, 0)
        shapes = prediction.shapes[self._pose[i][:, None], modes][..., self._columns]
        basis, back = subspace_basis(shapes * self._weights[i][:, None] * present[..., None])
        share = ((basis @ self._shapes[i][..., None])[..., 0, None] * back).sum(axis=1)
        return _Spaces(i, basis, share, modes)


def _scales(units: Sequence[str], moves: Array) -> Array:
    """Return the reciprocal rms motion of the channels of each unit over all setups, (C,); 0 if they do not move."""
    scales = np.zeros(len(units))
    for unit in set(units):
        channels = [i for i, unit_of_channel in enumerate(units) if unit_of_channel == unit]
        size = float(np.sqrt(np.mean(moves[:, channels] ** 2)))
        scales[channels] = 1.0 / size if size > 0.0 else 0.0
    return scales
