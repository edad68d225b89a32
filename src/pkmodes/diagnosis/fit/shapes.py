r"""Residuals of measured mode shapes: what no scale, and no mixture of close modes, explains.

A measured shape s, any scale, against a shape :math:`\phi` of the model leaves

.. math:: r = s - \phi \, (\phi^T s) / (\phi^T \phi), \qquad dr = -\frac{\phi^T s}{\phi^T \phi} P d\phi ,

with P the projection off :math:`\phi` (variable projection; Kaufman, BIT 15, 1975).  Modes whose measured frequencies
nearly agree are projected off together.  Components are relative to the row's largest, so that their standard
deviation is the stated ``sigma_shape``; where none is stated, each channel is first measured by what it moves in the
declared model, and the scatter is that of the best explanation.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.match.mac import ALIKE
from pkmodes.diagnosis.match.pairing import Pairing
from pkmodes.diagnosis.problem import Array, Prediction
from pkmodes.measured.measurements import Measurements


class ShapeRows:
    """Measured shapes as data of a fit.

    Parameters
    ----------
    data : Measurements
    columns : ndarray of int, shape (C,)
        Where the measured channels are among the model's.
    moves : ndarray, shape (S, C)
        How much each channel moves in the declared model, see `match.mac.channel_motion`.
    scatter : float
        Standard deviation of the components of rows without a stated one.
    criteria : Criteria

    Attributes
    ----------
    known : ndarray of bool, shape (R,)
        Rows of which a shape is known.
    stated : ndarray of bool, shape (R,)
        Rows with a stated standard deviation.
    count : ndarray of int, shape (R,)
        Values that each shape adds to the data: its components less the scales of the modes that it is compared with.
    sigma : ndarray, shape (R, C)
        Standard deviations of the components.
    """

    def __init__(
        self,
        data: Measurements,
        columns: NDArray[np.intp],
        moves: Array,
        scatter: float,
        criteria: Criteria,
    ) -> None:
        self._columns, self._pose = columns, data.pose
        measured = np.isfinite(data.shapes)
        self.stated = np.isfinite(data.shape_sigma) & measured.any(axis=1)
        moving = moves[data.pose] if len(columns) else np.zeros(data.shapes.shape)
        weights = np.where(
            self.stated[:, None], 1.0, np.where(moving > 0.0, 1.0 / np.where(moving > 0.0, moving, 1.0), 0.0)
        )
        self._weights = np.where(measured, weights, 0.0)
        shapes = np.where(measured, data.shapes, 0.0) * self._weights
        largest = np.abs(shapes).max(axis=1, initial=0.0, keepdims=True)
        self._shapes = shapes / np.where(largest > 0.0, largest, 1.0)
        components = (self._weights > 0.0).sum(axis=1)
        self.known = (components >= 2) & (largest[:, 0] > 0.0)
        self._shapes[~self.known] = 0.0
        self.count = np.where(self.known, components - 1, 0)
        each = np.where(self.stated, data.shape_sigma, scatter)
        self.sigma = np.broadcast_to(each[:, None], data.shapes.shape)
        log = np.log(data.frequency)
        self._mates = {
            int(i): np.flatnonzero((data.pose == data.pose[i]) & (np.abs(log - log[i]) < criteria.mixed))
            for i in _crowded(data, log, criteria.mixed)
        }
        self._alone = self.count.copy()
        for i, mates in self._mates.items():
            if len(mates) <= self._alone[i]:
                self.count[i] = self._alone[i] + 1 - len(mates)

    @property
    def size(self) -> int:
        """Number of components, R times C."""
        return self._shapes.size

    def residual(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """What the shapes of the partners do not explain, (R, C)."""
        return self._projected(prediction, pairing, used)[0]

    def rates(self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]) -> Array:
        """Derivatives of the residual with respect to the parameters that were asked for, (R, C, T)."""
        if prediction.shape_rates is None or not self._shapes.size:
            return np.zeros((*self._shapes.shape, prediction.rates.shape[-1]))
        _, phi, along = self._projected(prediction, pairing, used)
        take = self._pose, np.maximum(pairing.partner, 0)
        changes = prediction.shape_rates[take][:, self._columns] * self._weights[..., None]
        size = np.maximum((phi**2).sum(axis=1), 1e-300)
        inside = np.einsum("rc,rct->rt", phi, changes) / size[:, None]
        found = -along[:, None, None] * (changes - phi[..., None] * inside[:, None])
        for i, mates in self._together(pairing, used):
            basis, share = self._space(prediction, pairing, i, mates)
            modes = pairing.partner[mates]
            moved = prediction.shape_rates[self._pose[i], modes][:, self._columns]
            change = np.tensordot(share, moved * self._weights[i][:, None], axes=1)
            found[i] = -(change - basis @ (basis.T @ change))
        return np.asarray(np.where((self.known & used & (pairing.partner >= 0))[:, None, None], found, 0.0))

    def degrees(self, used: NDArray[np.bool_]) -> int:
        """Values that the shapes of the rows in use add to the data."""
        return int(self.count[used].sum())

    def mac(self, residual: Array) -> Array:
        """Modal assurance criterion of each row by its residual; NaN where no shape is known, (R,)."""
        whole = (self._shapes**2).sum(axis=1)
        with np.errstate(invalid="ignore", divide="ignore"):
            return np.asarray(np.where(self.known, 1.0 - (residual**2).sum(axis=1) / whole, np.nan))

    def _projected(
        self, prediction: Prediction, pairing: Pairing, used: NDArray[np.bool_]
    ) -> tuple[Array, Array, Array]:
        """Residuals, shapes of the partners in the scale of the rows, and how much of them is in each row."""
        if not self._shapes.size:
            return self._shapes, self._shapes, np.zeros(len(self._shapes))
        partner = np.maximum(pairing.partner, 0)
        phi = prediction.shapes[self._pose, partner][:, self._columns] * self._weights
        phi = np.where((pairing.partner >= 0)[:, None], phi, 0.0)
        along = (phi * self._shapes).sum(axis=1) / np.maximum((phi**2).sum(axis=1), 1e-300)
        found = self._shapes - phi * along[:, None]
        for i, mates in self._together(pairing, used):
            basis, _ = self._space(prediction, pairing, i, mates)
            found[i] = self._shapes[i] - basis @ (basis.T @ self._shapes[i])
        return np.where((self.known & used)[:, None], found, 0.0), phi, along

    def _together(self, pairing: Pairing, used: NDArray[np.bool_]) -> list[tuple[int, NDArray[np.intp]]]:
        """Rows that are compared with several modes at once, and the rows of these modes."""
        found = []
        for i, rows in self._mates.items():
            mates = rows[used[rows] & (pairing.partner[rows] >= 0)]
            if self.known[i] and used[i] and pairing.partner[i] >= 0 and 1 < len(mates) <= self._alone[i]:
                found.append((i, mates))
        return found

    def _space(
        self, prediction: Prediction, pairing: Pairing, i: int, mates: NDArray[np.intp]
    ) -> tuple[Array, Array]:
        """Orthonormal basis of the partners' space at the sensors of a row, and its coordinates in them."""
        shapes = prediction.shapes[self._pose[i], pairing.partner[mates]][:, self._columns] * self._weights[i]
        # By singular values: where the sensors see two modes alike, they span one direction.
        u, s, vt = np.linalg.svd(shapes.T, full_matrices=False)
        kept = s > ALIKE * s[0] if s[0] > 0.0 else np.zeros(len(s), dtype=bool)
        u, s, vt = u[:, kept], s[kept], vt[kept]
        share: Array = vt.T @ ((u.T @ self._shapes[i]) / s)
        return u, share


def _crowded(data: Measurements, log: Array, mixed: float) -> NDArray[np.intp]:
    """Rows with another row of their setup nearby."""
    order = np.lexsort((log, data.pose))
    near = (np.diff(log[order]) < mixed) & (np.diff(data.pose[order]) == 0)
    return np.unique(np.concatenate([order[:-1][near], order[1:][near]]))
