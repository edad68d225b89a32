"""Which measured mode is which mode of the model: by frequency, and by shape where shapes were measured.

Each setup is one assignment problem: measured modes go one-to-one to modes of the model so that the sum of
their distances is least.  The distance adds the squared logarithm of the ratio of the frequencies and, where
there are shapes, one minus the modal assurance criterion (`match.mac`).
"""

from __future__ import annotations

import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.match.mac import channel_motion, mac, space, weighted
from pkmodes.diagnosis.problem import Prediction
from pkmodes.errors import PkmodesError, shown
from pkmodes.measured.measurements import Measurements

Array = NDArray[np.float64]
Index = NDArray[np.intp]


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
    criteria : Criteria, optional

    Attributes
    ----------
    columns : ndarray of int, shape (C,)
        Where the measured channels are among the model's.
    moves : ndarray, shape (S, C)
        What they move in the reference.
    pose : ndarray of int, shape (R,)
        Setup of each row.
    """

    def __init__(
        self,
        data: Measurements,
        channels: tuple[str, ...],
        reference: Prediction | None = None,
        criteria: Criteria | None = None,
    ) -> None:
        self._criteria = criteria or Criteria()
        self._shape, self._log, self.pose = data.shapes, np.log(data.frequency), data.pose
        self.columns = _columns(data, channels)
        setups = len(data.labels)
        self.moves = np.zeros((setups, len(self.columns)))
        if reference is not None and len(self.columns):
            self.moves = channel_motion(reference.shapes[..., self.columns])
        # Rows of each setup side by side, as many places as the fullest setup has rows.
        order = np.argsort(data.pose, kind="stable")
        start = np.searchsorted(data.pose[order], np.arange(setups))
        place = np.empty(len(order), dtype=np.intp)
        place[order] = np.arange(len(order)) - start[data.pose[order]]
        self._row = np.full((setups, int(place.max(initial=-1)) + 1), -1, dtype=np.intp)
        self._row[data.pose, place] = np.arange(len(order))
        self._place = place
        self._mates = neighbours(data, self._criteria)

    def tiled(self, count: int) -> Pairer:
        """The same for predictions of so many times the setups, each to be paired with the same rows."""
        found, (setups, rows) = copy.copy(self), (len(self._row), len(self._log))
        found._shape, found._log = np.tile(self._shape, (count, 1)), np.tile(self._log, count)
        found._place, found.moves = np.tile(self._place, count), np.tile(self.moves, (count, 1))
        found.pose, found._row = tiled(self.pose, count, setups), tiled(self._row, count, rows)
        found._mates = tiled(self._mates, count, rows)
        return found

    def pair(self, prediction: Prediction, used: NDArray[np.bool_], *, compare: bool = True) -> Pairing:
        """Pair the rows in use; the others are left without a partner.

        Parameters
        ----------
        prediction : Prediction
        used : ndarray of bool, shape (R,)
        compare : bool, optional
            Whether the shapes of partners are compared for the result; without, it takes less time.
        """
        c, rigid = self._criteria, prediction.rigid
        logs = prediction.log_frequencies[:, rigid:]
        row = self._row
        present = (row >= 0) & used[row]
        shapes, model, measured = self._shapes(prediction)
        alone = mac(shapes, model, measured) if len(self.columns) else None
        with np.errstate(invalid="ignore"):
            distance = np.abs(self._log[row][..., None] - logs[:, None])
            close = np.diff(logs, axis=1) < c.close
        likeness = None if alone is None else self._grouped(alone, shapes, model, measured, logs, close)
        cost = distance**2
        if likeness is not None:
            cost = cost + c.shape_weight**2 * np.where(np.isnan(likeness), 0.0, 1.0 - likeness)
        # A mode that is too far away may still be taken by the assignment; it is no partner then.  What that
        # costs is always the same: otherwise a mode that the model lacks would push the others along.
        cost = np.where(distance <= c.reach, cost, c.reach**2 + c.shape_weight**2)
        partner = _assigned(cost, present, np.isfinite(logs))
        at = np.arange(len(row))[:, None], np.arange(row.shape[1]), np.maximum(partner, 0)
        with np.errstate(invalid="ignore"):
            partner = np.where(distance[at] <= c.reach, partner, -1)
        if close.any():
            partner = _in_order(partner, self._log[row], close)
        found = np.full(len(self._log), -1, dtype=np.intp)
        taken = partner >= 0
        found[row[taken]] = partner[taken] + rigid
        values = np.full(len(self._log), np.nan)
        if compare and alone is not None:
            beside = unmeasured_neighbours(prediction, found, self.pose, c.close)
            beside = np.where(beside >= 0, beside - rigid, -1)
            values = self._compared(found - rigid, beside, alone, shapes, model, measured)
        return Pairing(found, values)

    def differences(self, prediction: Prediction, pairing: Pairing) -> Array:
        """Measured minus model in ln f, (R,); a mode that the model lacks counts with the reach of the pairing."""
        reach = self._criteria.reach
        logs = prediction.log_frequencies[self.pose, np.maximum(pairing.partner, 0)]
        return np.asarray(np.where(pairing.partner >= 0, np.clip(self._log - logs, -reach, reach), reach))

    def _shapes(self, prediction: Prediction) -> tuple[Array, Array, NDArray[np.bool_]]:
        """Shapes of the rows of each setup, and of its modes, in units of what each channel moves."""
        row = self._row
        padded = np.where((row >= 0)[..., None], self._shape[row], np.nan)
        model = prediction.shapes[..., self.columns]
        shapes, model = weighted(padded, model, np.where(self.moves > 0.0, self.moves, channel_motion(model)))
        return shapes, model[:, prediction.rigid :], np.isfinite(padded)

    def _grouped(
        self,
        alone: Array,
        shapes: Array,
        model: Array,
        measured: NDArray[np.bool_],
        logs: Array,
        close: NDArray[np.bool_],
    ) -> Array:
        """MAC of each row with each mode of the model, or with the modes that are close to it together."""
        setups = np.flatnonzero(close.any(axis=1))
        if not len(setups):
            return alone
        with np.errstate(invalid="ignore"):
            near = np.abs(logs[setups][:, :, None] - logs[setups][:, None, :]) < self._criteria.close
        which, k = np.nonzero(near.sum(axis=-1) > 1)
        # Every row of a setup with every mode that is not alone, where the shape is known.
        entry, place = np.nonzero(np.isfinite(alone[setups[which], :, k]))
        if not len(entry):
            return alone
        which, k = which[entry], k[entry]
        found = alone.copy()
        inside = _in_space(
            shapes[setups[which], place],
            model[setups[which]],
            near[which, k],
            measured[setups[which], place],
        )
        at = setups[which], place, k
        found[at] = np.where(np.isnan(inside), found[at], inside)
        return found

    def _compared(
        self,
        partner: Index,
        beside: Index,
        alone: Array,
        shapes: Array,
        model: Array,
        measured: NDArray[np.bool_],
    ) -> Array:
        """MAC of each row with its partner, or with the partners of all rows close to it, and modes beside it."""
        pose, place = self.pose, self._place
        paired = partner >= 0
        found = np.where(paired, alone[pose, place, np.maximum(partner, 0)], np.nan)
        crowded = (self._mates[:, 1:] >= 0).any(axis=1) | (beside >= 0).any(axis=1)
        i = np.flatnonzero(paired & crowded)
        if len(i):
            rows = self._mates[i]
            members = np.zeros((len(i), model.shape[1]), dtype=bool)
            entry, column = np.nonzero((rows >= 0) & paired[rows])
            members[entry, partner[rows[entry, column]]] = True
            entry, column = np.nonzero(beside[i] >= 0)
            members[entry, beside[i][entry, column]] = True
            inside = _in_space(
                shapes[pose[i], place[i]], model[pose[i]], members, measured[pose[i], place[i]]
            )
            found[i] = np.where(members.sum(axis=1) > 1, inside, found[i])
        return found


def tiled(numbers: Index, count: int, size: int) -> Index:
    """Numbers of several copies of so many things, those of the first copy first; -1 stays what it is."""
    copies = np.arange(count).reshape(-1, *[1] * numbers.ndim) * size
    found = np.where(numbers >= 0, numbers + copies, numbers)
    return np.asarray(found.reshape(-1, *numbers.shape[1:]))


def neighbours(data: Measurements, criteria: Criteria) -> Index:
    """Rows whose shapes are compared as one space with that of each row, because they are so near it.

    They are within what turns shapes into each other, or within the errors of their frequencies.

    Parameters
    ----------
    data : Measurements
    criteria : Criteria

    Returns
    -------
    ndarray of int, shape (R, g)
        The row itself first, then the others; -1 where there are fewer.
    """
    log, sigma = np.log(data.frequency), data.sigma / data.frequency

    def near(a: Index | int, b: Index) -> NDArray[np.bool_]:
        errors = criteria.mixed_sigmas * np.hypot(sigma[a], sigma[b])
        apart = np.abs(log[a] - log[b])
        within = apart < np.clip(errors, criteria.mixed, criteria.most_mixed)
        return np.asarray((data.pose[a] == data.pose[b]) & within)

    order = np.lexsort((log, data.pose))
    beside = near(order[:-1], order[1:])
    everything = np.arange(len(log))
    mates = {
        i: np.flatnonzero(near(i, everything) & (everything != i))
        for i in np.union1d(order[:-1][beside], order[1:][beside]).tolist()
    }
    found = np.full((len(log), 1 + max(map(len, mates.values()), default=0)), -1, dtype=np.intp)
    found[:, 0] = everything
    for i, others in mates.items():
        found[i, 1 : 1 + len(others)] = others
    return found


def unmeasured_neighbours(prediction: Prediction, partner: Index, pose: Index, close: float) -> Index:
    """Modes that nearly coincide with a row's partner and are the partner of no row.

    A measured mode may be any mixture of the two: which one it is paired with means nothing.

    Parameters
    ----------
    prediction : Prediction
    partner, pose : ndarray of int, shape (R,)
    close : float
        Largest difference of the logarithms of their frequencies.

    Returns
    -------
    ndarray of int, shape (R, 4)
        Counted from 0 with the rigid ones; -1 where there is none.
    """
    logs = prediction.log_frequencies
    taken = np.zeros(logs.shape, dtype=bool)
    paired = partner >= 0
    taken[pose[paired], partner[paired]] = True
    beside = np.maximum(partner, 0)[:, None] + np.array([-2, -1, 1, 2])
    inside = (beside >= prediction.rigid) & (beside < logs.shape[1]) & paired[:, None]
    beside = np.where(inside, beside, 0)
    own = logs[pose, np.maximum(partner, 0)][:, None]
    with np.errstate(invalid="ignore"):
        near = np.abs(logs[pose[:, None], beside] - own) < close
    return np.where(inside & near & ~taken[pose[:, None], beside], beside, -1)


def _in_space(shapes: Array, model: Array, members: NDArray[np.bool_], measured: NDArray[np.bool_]) -> Array:
    """Part of each shape (B, C) that lies in the space of some modes (B, m, C); NaN where any shape would."""
    most = int(members.sum(axis=1).max(initial=1))
    order = np.argsort(~members, axis=1, kind="stable")[:, :most]
    batch = np.arange(len(shapes))[:, None]
    some = model[batch, order] * measured[:, None] * members[batch, order][..., None]
    basis, _ = space(some)
    lengths = (shapes**2).sum(axis=-1)
    told = (measured.sum(axis=-1) > members.sum(axis=-1)) & (measured.sum(axis=-1) >= 2) & (lengths > 0.0)
    along = ((basis @ shapes[..., None]) ** 2).sum(axis=(-1, -2))
    return np.where(told, along / np.where(lengths > 0.0, lengths, 1.0), np.nan)


def _assigned(cost: Array, present: NDArray[np.bool_], known: NDArray[np.bool_]) -> Index:
    """Modes (S, r) that the rows of each setup go to, one to one, at the least sum of costs; -1 for those without.

    Parameters
    ----------
    cost : ndarray, shape (S, r, m)
    present : ndarray of bool, shape (S, r)
        Rows that take part.
    known : ndarray of bool, shape (S, m)
        Modes that take part.
    """
    cost = np.where(known[:, None], cost, np.inf)
    best: Index = cost.argmin(axis=2)
    best[~(present & known.any(axis=1, keepdims=True))] = -1
    # Where every row has its best, the sum is least.
    ordered = np.sort(best, axis=1)
    contested = ((np.diff(ordered, axis=1) == 0) & (ordered[:, 1:] >= 0)).any(axis=1)
    for setup in np.flatnonzero(contested):
        rows, modes = np.flatnonzero(present[setup]), np.flatnonzero(known[setup])
        i, k = linear_sum_assignment(cost[setup][np.ix_(rows, modes)])
        best[setup] = -1
        best[setup, rows[i]] = modes[k]
    return best


def _in_order(partner: Index, measured: Array, close: NDArray[np.bool_]) -> Index:
    """Partners (S, r), those of the rows in each group of close modes in the order of the measured frequencies."""
    group = np.concatenate([np.zeros((len(close), 1), dtype=np.intp), np.cumsum(~close, axis=1)], axis=1)
    of_row = np.where(partner >= 0, np.take_along_axis(group, np.maximum(partner, 0), axis=1), -1)
    # Groups ascend with the modes: rows by group and frequency get the partners as they ascend.
    found = np.empty_like(partner)
    np.put_along_axis(found, np.lexsort((measured, of_row), axis=-1), np.sort(partner, axis=1), axis=1)
    return found


def _columns(data: Measurements, channels: tuple[str, ...]) -> Index:
    """Where the measured channels are among the model's."""
    for name in data.channels:
        if name not in channels:
            what = f"the model has no channel {shown(name)} for the measured shapes"
            raise PkmodesError(what, data.source, f"channels are: {', '.join(channels)}")
    return np.array([channels.index(name) for name in data.channels], dtype=np.intp)
