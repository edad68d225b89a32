"""Which measured mode is which mode of the model: by frequency, and by shape where shapes were measured.

Each setup is one assignment problem: measured modes go one-to-one to modes of the model so that the sum of
their distances is least.  The distance adds the squared logarithm of the ratio of the frequencies and, where
there are shapes, one minus the modal assurance criterion (MAC; Allemang, Sound and Vibration 37(8), 2003).
Modes of the model whose frequencies nearly agree may be any combination of each other, so shapes are compared
with the space that they span.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.diagnosis.problem import Prediction
from pkmodes.errors import PkmodesError, shown
from pkmodes.measured.measurements import Measurements

Array = NDArray[np.float64]
Index = NDArray[np.intp]

#: Ratio of frequencies, as a logarithm, beyond which a measured mode is no mode of the model.
REACH = 0.6
#: A shape that does not agree at all counts like this difference of the logarithms of the frequencies.
SHAPE_WEIGHT = 0.25
#: Modes of the model closer than this fraction are one group: their shapes turn into each other with the least error,
#: so that their measured partners are told apart by the order of the frequencies alone.
CLOSE = 0.01
#: Modes closer than this are compared with measured shapes as one space: an error of some 0.2 % of their
#: frequencies already turns their shapes by several per cent.
MIXED = 0.03
#: Modes whose measured components differ by less than this fraction are seen alike.
ALIKE = 1e-6


@dataclass(frozen=True)
class Pairing:
    """Partners of the R measured modes.

    Attributes
    ----------
    partner : ndarray of int, shape (R,)
        Mode of the model in the row's setup, counted from 0 with the rigid ones; -1 where there is none.
    mac : ndarray, shape (R,)
        Modal assurance criterion with the partner (or the space of modes close to it); NaN without shapes.
    """

    partner: Index
    mac: Array


class Pairer:
    """Pairs the rows of one set of measurements with predictions.

    Parameters
    ----------
    data : Measurements
    channels : tuple of str
        The model's channels; those of the measurements are among them.
    """

    def __init__(self, data: Measurements, channels: tuple[str, ...]) -> None:
        self._log = np.log(data.frequency)
        self._rows = [np.flatnonzero(data.pose == i) for i in range(len(data.labels))]
        self._columns = _columns(data, channels)
        self._measured = np.isfinite(data.shapes)
        shapes = np.where(self._measured, data.shapes, 0.0)
        largest = np.max(np.abs(shapes), axis=1, initial=0.0, keepdims=True)
        self._shapes = shapes / np.where(largest > 0.0, largest, 1.0)
        self.shape_components = int(np.maximum(self._measured.sum(axis=1) - 1, 0).sum())

    def pair(self, prediction: Prediction, used: NDArray[np.bool_]) -> Pairing:
        """Pair the rows in use; the others are left without a partner."""
        partner = np.full(len(self._log), -1, dtype=np.intp)
        mac = np.full(len(self._log), np.nan)
        logs = prediction.log_frequencies
        for setup, rows in enumerate(self._rows):
            rows = rows[used[rows]]
            modes = np.arange(prediction.rigid, logs.shape[1])
            modes = modes[np.isfinite(logs[setup, modes])]
            if not len(rows) or not len(modes):
                continue
            distance = np.abs(self._log[rows, None] - logs[setup, modes])
            shapes = prediction.shapes[setup]
            likeness = self._likeness(rows, shapes, modes, logs[setup, modes], CLOSE)
            missing = np.where(np.isnan(likeness), 0.0, 1.0 - likeness)
            cost = distance**2 + SHAPE_WEIGHT**2 * missing
            # A mode that is too far away may still be taken by the assignment; it is no partner then.  What that
            # costs is always the same: otherwise a mode that the model lacks would push the others along.
            cost = np.where(distance <= REACH, cost, REACH**2 + SHAPE_WEIGHT**2)
            assigned = zip(*linear_sum_assignment(cost), strict=True)
            pairs = [(int(i), int(k)) for i, k in assigned if distance[i, k] <= REACH]
            likeness = self._likeness(rows, shapes, modes, logs[setup, modes], MIXED)
            for i, k in _in_order(pairs, self._log[rows], logs[setup, modes]):
                partner[rows[i]], mac[rows[i]] = modes[k], likeness[i, k]
        return Pairing(partner, mac)

    def _likeness(self, rows: Index, shapes: Array, modes: Index, logs: Array, close: float) -> Array:
        """MAC of each measured row with each mode, or with the modes close to it together; NaN without shape."""
        found = np.full((len(rows), len(modes)), np.nan)
        if not len(self._columns):
            return found
        # Metres beside radians: a channel counts by how much it moves in all modes together, which for
        # mass-normalised shapes is the inverse of its effective mass.
        moves = np.sqrt(np.nansum(shapes[:, self._columns] ** 2, axis=0))
        weights = np.where(moves > 0.0, 1.0 / np.where(moves > 0.0, moves, 1.0), 0.0)
        model = shapes[modes][:, self._columns] * weights
        seen, measured = self._measured[rows], self._shapes[rows] * weights
        lengths = (measured**2).sum(axis=1)
        told = (seen.sum(axis=1) >= 2) & (lengths > 0.0)
        sizes = seen.astype(float) @ (model**2).T
        with np.errstate(divide="ignore", invalid="ignore"):
            along = (measured @ model.T) ** 2 / (sizes * lengths[:, None])
        found[told] = np.where(sizes > 0.0, along, 0.0)[told]
        near = np.abs(logs[:, None] - logs) < close
        for k in np.flatnonzero(near.sum(axis=1) > 1):
            for mask in np.unique(seen[told], axis=0):
                if mask.sum() > near[k].sum():  # otherwise any shape would be in the space
                    # By singular values: where the sensors see two modes alike, they span one direction.
                    basis, size, _ = np.linalg.svd(model[near[k]][:, mask].T, full_matrices=False)
                    basis = basis[:, size > ALIKE * size[0]]
                    alike = np.flatnonzero(told & (seen == mask).all(axis=1))
                    inside = ((measured[alike][:, mask] @ basis) ** 2).sum(axis=1)
                    found[alike, k] = inside / lengths[alike]
        return found


def _in_order(pairs: list[tuple[int, int]], measured: Array, model: Array) -> list[tuple[int, int]]:
    """Pairs with the partners of each group of close modes in the order of their frequencies."""
    group = np.concatenate([[0], np.cumsum(np.diff(model) >= CLOSE)])
    found = []
    for number in np.unique(group[[k for _, k in pairs]]) if pairs else []:
        members = [(i, k) for i, k in pairs if group[k] == number]
        rows = sorted((i for i, _ in members), key=lambda i: float(measured[i]))
        found += list(zip(rows, sorted(k for _, k in members), strict=True))
    return found


def _columns(data: Measurements, channels: tuple[str, ...]) -> Index:
    """Where the measured channels are among the model's."""
    for name in data.channels:
        if name not in channels:
            what = f"the model has no channel {shown(name)} for the measured shapes"
            raise PkmodesError(what, data.source, f"channels are: {', '.join(channels)}")
    return np.array([channels.index(name) for name in data.channels], dtype=np.intp)
