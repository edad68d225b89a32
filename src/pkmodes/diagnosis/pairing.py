"""Which measured mode is which mode of the model: by frequency, and by shape where shapes were measured.

Each setup is one assignment problem: measured modes go one-to-one to modes of the model so that the sum of
their distances is least.  The distance adds the squared logarithm of the ratio of the frequencies and, where
there are shapes, one minus the modal assurance criterion (`pkmodes.diagnosis.likeness`).
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.diagnosis.likeness import Likeness, MeasuredShapes, channel_motion
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
#: Measured modes closer than this are compared as one space, that of their partners: an error of some 0.2 % of their
#: frequencies already turns their shapes by several per cent.  The measured frequencies decide, not the model's: a
#: hypothesis must not be judged more mildly because it brings two modes together.
MIXED = 0.03


@dataclass(frozen=True)
class Pairing:
    """Partners of the R measured modes.

    Attributes
    ----------
    partner : ndarray of int, shape (R,)
        Mode of the model in the row's setup, counted from 0 with the rigid ones; -1 where there is none.
    mac : ndarray, shape (R,)
        Modal assurance criterion with the partner (or the space of the partners of close modes); NaN without shapes.
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
    reference : Prediction, optional
        Of the declared model: what its channels move weights them for all models that are to be compared.  By
        default every prediction's own.
    """

    def __init__(
        self, data: Measurements, channels: tuple[str, ...], reference: Prediction | None = None
    ) -> None:
        self._log = np.log(data.frequency)
        self._rows = [np.flatnonzero(data.pose == i) for i in range(len(data.labels))]
        self._columns = _columns(data, channels)
        self._shapes = [MeasuredShapes(data.shapes[rows]) for rows in self._rows]
        self._moves = np.zeros((len(self._rows), len(self._columns)))
        if reference is not None:
            self._moves = channel_motion(reference.shapes[..., self._columns])
        measured = np.isfinite(data.shapes).sum(axis=1)
        self.shape_components = int(np.maximum(measured - 1, 0).sum())

    def pair(self, prediction: Prediction, used: NDArray[np.bool_], *, compare: bool = True) -> Pairing:
        """Pair the rows in use; the others are left without a partner.

        Parameters
        ----------
        prediction : Prediction
        used : ndarray of bool, shape (R,)
        compare : bool, optional
            Whether the shapes of partners are compared for the result; without, it takes less time.
        """
        partner = np.full(len(self._log), -1, dtype=np.intp)
        mac = np.full(len(self._log), np.nan)
        logs = prediction.log_frequencies
        for setup, rows in enumerate(self._rows):
            modes = np.arange(prediction.rigid, logs.shape[1])
            modes = modes[np.isfinite(logs[setup, modes])]
            kept = used[rows]
            if not kept.any() or not len(modes):
                continue
            frequencies = logs[setup, modes]
            shapes = prediction.shapes[setup][:, self._columns]
            likeness = Likeness(self._shapes[setup], shapes, modes, self._moves[setup])
            close = _grouped(likeness, frequencies)[kept]
            rows = rows[kept]
            measured = self._log[self._rows[setup]]
            distance = np.abs(self._log[rows, None] - frequencies)
            missing = np.where(np.isnan(close), 0.0, 1.0 - close)
            cost = distance**2 + SHAPE_WEIGHT**2 * missing
            # A mode that is too far away may still be taken by the assignment; it is no partner then.  What that
            # costs is always the same: otherwise a mode that the model lacks would push the others along.
            cost = np.where(distance <= REACH, cost, REACH**2 + SHAPE_WEIGHT**2)
            assigned = zip(*linear_sum_assignment(cost), strict=True)
            pairs = [(int(i), int(k)) for i, k in assigned if distance[i, k] <= REACH]
            for i, k in _in_order(pairs, self._log[rows], frequencies):
                partner[rows[i]] = modes[k]
            if compare:
                mac[rows] = _compared(likeness, partner[self._rows[setup]], modes, measured)[kept]
        return Pairing(partner, mac)


def _grouped(likeness: Likeness, logs: Array) -> Array:
    """MAC of each row with each mode of the model, or with the modes that are close to it together."""
    if (np.diff(logs) >= CLOSE).all():
        return likeness.alone
    found, near = likeness.alone.copy(), np.abs(logs[:, None] - logs) < CLOSE
    for k in np.flatnonzero(near.sum(axis=1) > 1):
        inside = likeness.together(near[k])
        found[:, k] = np.where(np.isnan(inside), found[:, k], inside)
    return found


def _compared(likeness: Likeness, partner: Index, modes: Index, logs: Array) -> Array:
    """MAC of each row with its partner, or with the partners of all rows close to it together."""
    found = np.full(len(partner), np.nan)
    for i in np.flatnonzero(partner >= 0):
        mates = partner[(np.abs(logs - logs[i]) < MIXED) & (partner >= 0)]
        inside = likeness.together(np.isin(modes, mates))[i] if len(mates) > 1 else np.nan
        found[i] = likeness.alone[i, np.searchsorted(modes, partner[i])] if np.isnan(inside) else inside
    return found


def _in_order(pairs: list[tuple[int, int]], measured: Array, model: Array) -> list[tuple[int, int]]:
    """Pairs with the partners of each group of close modes in the order of their frequencies."""
    apart = np.diff(model) >= CLOSE
    if apart.all():
        return pairs
    group, found = np.concatenate([[0], np.cumsum(apart)]), []
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
