"""Mode pairing: measured modes are paired with modes of the model by frequency, and by shape if measured.

Each setup is an assignment problem: measured modes are assigned one-to-one to modes of the model with the least sum
of distances.  The distance is the squared logarithm of the frequency ratio plus, if there are shapes, a multiple of
one minus the modal assurance criterion (`support.mac`), less the part that the errors of the shape explain: within
its errors a shape does not show to which of two modes it belongs.
"""

from __future__ import annotations

import copy
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import linear_sum_assignment

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.mac import (
    MIN_MAC_OF_PAIR,
    channel_motion,
    channel_weights,
    explained_difference,
    mac,
    normalised,
    subspace_mac,
)
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.match.pairs import pairs_of_setups
from pkmodes.loop.diagnosis.match.shape_errors import shape_errors
from pkmodes.loop.diagnosis.problem import Array, Index, Prediction
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY


@dataclass(frozen=True)
class Pairing:
    """Partners of the R measured modes.

    - partner: mode of the model in the row's setup, counted from 0, rigid ones included, (R,); -1 if unmatched
    - mac: MAC with the partner, or with the subspace of the partners of close modes, (R,); NaN without shapes
    """

    partner: Index
    mac: Array

    def limited_to(self, prediction: Prediction) -> Pairing:
        """Return the pairing for a prediction that may lack a mode that a cause adds: its row is unmatched there."""
        exists = self.partner < prediction.eigenvalues.shape[1]
        return self if exists.all() else Pairing(np.where(exists, self.partner, -1), self.mac)


class _Shapes(NamedTuple):
    """Shapes of rows (S, r, C) and modes (S, m, C) in the same weighting.

    With the measured components of the rows and their standard deviations, 0 where not measured, (S, r, C).
    """

    rows: Array
    model: Array
    measured: NDArray[np.bool_]
    errors: Array

    def single_macs(self) -> Array:
        """Return the MAC of each row with each mode of its setup, (S, r, m)."""
        return mac(self.rows, self.model, self.measured)

    def in_subspace(self, setup: Index, row: Index, members: NDArray[np.bool_]) -> Array:
        """Return the MAC of some rows, each with the subspace of some modes of its setup, (B, m)."""
        return subspace_mac(self.rows[setup, row], self.model[setup], members, self.measured[setup, row])


class Pairer:
    """Pairs the rows of one set of measurements with predictions.

    - channels: the model's channels, which include those of the measurements
    - reference: prediction of the declared model: the motion of its channels sets their weights for all models that
      are compared.  By default each prediction sets its own weights.

    Its attributes:
    - columns: indices of the measured channels among the model's, (C,)
    - motion: motion of these channels in the reference, (S, C)
    - pose: setup of each row, (R,)
    """

    def __init__(
        self,
        data: Measurements,
        channels: tuple[str, ...],
        reference: Prediction | None = None,
        criteria: Criteria | None = None,
    ) -> None:
        self._criteria = criteria or Criteria()
        self._log, self.pose = FREQUENCY.transformed(data), data.pose
        for name in data.channels:
            if name not in channels:
                problem = f"the model has no channel {shown(name)} for the measured shapes"
                raise PkmodesError(problem, data.source, f"channels are: {', '.join(channels)}")
        self.columns = np.array([channels.index(name) for name in data.channels], dtype=np.intp)
        setups = len(data.labels)
        self.motion = np.zeros((setups, len(self.columns)))
        if reference is not None and len(self.columns):
            self.motion = channel_motion(reference.shapes[..., self.columns])
        # Rows of each setup side by side, padded to the largest number of rows.
        order = np.argsort(data.pose, kind="stable")
        start = np.searchsorted(data.pose[order], np.arange(setups))
        column = np.empty(len(order), dtype=np.intp)
        column[order] = np.arange(len(order)) - start[data.pose[order]]
        self._row = np.full((setups, int(column.max(initial=-1)) + 1), -1, dtype=np.intp)
        self._row[data.pose, column] = np.arange(len(order))
        self._column = column
        padded = np.where((self._row >= 0)[..., None], data.shapes[self._row], np.nan)
        self._normalised, self._measured = normalised(padded), np.isfinite(padded)
        self._errors = shape_errors(data, self._criteria)[self._row]
        self._close_rows = close_rows(data, self._criteria)

    def tiled(self, count: int) -> Pairer:
        """Return a pairer for predictions of `count` times the setups, each paired with the same rows."""
        copies, (setups, rows) = copy.copy(self), (len(self._row), len(self._log))
        copies._log = np.tile(self._log, count)
        copies._normalised, copies._measured = (
            np.tile(array, (count, 1, 1)) for array in (self._normalised, self._measured)
        )
        copies._errors = np.tile(self._errors, (count, 1))
        copies._column, copies.motion = np.tile(self._column, count), np.tile(self.motion, (count, 1))
        copies.pose, copies._row = (
            tile_indices(self.pose, count, setups),
            tile_indices(self._row, count, rows),
        )
        copies._close_rows = tile_indices(self._close_rows, count, rows)
        return copies

    def pair(
        self, prediction: Prediction, used_row_mask: NDArray[np.bool_], *, compare: bool = True
    ) -> Pairing:
        """Pair the used rows; the others get no partner.

        - used_row_mask: (R,)
        - compare: whether to compute the MAC with the partners, which takes time
        """
        c, rigid = self._criteria, prediction.rigid
        log_frequencies = prediction.log_frequencies[:, rigid:]
        row = self._row
        is_present = (row >= 0) & used_row_mask[row]
        shapes = self._shapes(prediction) if len(self.columns) else None
        with np.errstate(invalid="ignore"):
            distance = np.abs(self._log[row][..., None] - log_frequencies[:, None])
            is_close_to_next = np.diff(log_frequencies, axis=1) < c.pairing.close
        cost = distance**2
        if shapes is not None:
            single_macs = shapes.single_macs()
            macs = self._macs_in_groups(prediction, shapes, single_macs)
            shape_distance = _shape_distance(macs, self._explained(shapes)[..., None])
            cost = cost + c.pairing.shape_weight**2 * np.where(np.isnan(macs), 0.0, shape_distance)
        # The assignment may take a mode that is too far away, which is then no partner.  Its cost is constant:
        # otherwise a mode that the model lacks would shift the others.
        cost = np.where(distance <= c.pairing.reach, cost, c.pairing.reach**2 + c.pairing.shape_weight**2)
        partner = _assign(cost, is_present, np.isfinite(log_frequencies))
        entries = np.arange(len(row))[:, None], np.arange(row.shape[1]), np.maximum(partner, 0)
        with np.errstate(invalid="ignore"):
            partner = np.where(distance[entries] <= c.pairing.reach, partner, -1)
        if is_close_to_next.any():
            partner = _reorder_close_modes(partner, self._log[row], is_close_to_next)
        partners = np.full(len(self._log), -1, dtype=np.intp)
        is_paired = partner >= 0
        partners[row[is_paired]] = partner[is_paired] + rigid
        partner_macs = np.full(len(self._log), np.nan)
        if compare and shapes is not None:
            unpaired_modes = unpaired_close_modes(prediction, partners, self.pose, c.pairing.close)
            unpaired_modes = np.where(unpaired_modes >= 0, unpaired_modes - rigid, -1)
            partner_macs = self._macs_of_partners(partners - rigid, unpaired_modes, single_macs, shapes)
        return Pairing(partners, partner_macs)

    def told(self, prediction: Prediction, pairing: Pairing) -> tuple[Array, NDArray[np.bool_]]:
        """Return what is told of the partners of a fit, which keeps them: with other shapes they are no pairs.

        Without such a partner, no step of a fit could bring its shape and the measured one together.

        - pairing: of the same prediction

        Returns, in this order:
        - MAC with the partner, (R,); where it is low, with the subspace of the partner and the modes close to it,
          since the smallest error rotates their shapes into each other
        - whether the partner has another shape, (R,)
        """
        if not len(self.columns):
            return pairing.mac, np.zeros(len(self._log), dtype=bool)
        shapes = self._shapes(prediction)
        macs, explained = (
            self._macs_in_groups(prediction, shapes, shapes.single_macs()),
            self._explained(shapes),
        )
        entry = self.pose, self._column
        in_group = macs[(*entry, np.maximum(pairing.partner - prediction.rigid, 0))]

        def is_low(mac: Array) -> NDArray[np.bool_]:  # False without a shape
            return np.asarray(1.0 - _shape_distance(mac, explained[entry]) < MIN_MAC_OF_PAIR)

        told_mac = np.where(is_low(pairing.mac), np.fmax(pairing.mac, in_group), pairing.mac)
        return told_mac, is_low(told_mac) & (pairing.partner >= 0)

    def macs(self, prediction: Prediction) -> Array:
        """Return the MAC of each row with each elastic mode of its setup, (R, m); NaN without a shape."""
        if not len(self.columns):
            return np.full((len(self._log), prediction.shapes.shape[1] - prediction.rigid), np.nan)
        return self._shapes(prediction).single_macs()[self.pose, self._column]

    def differences(self, prediction: Prediction, pairing: Pairing) -> Array:
        """Return measured minus model in ln f, (R,); an unmatched mode counts as the reach of the pairing."""
        reach = self._criteria.pairing.reach
        partner_logs = prediction.log_frequencies[self.pose, np.maximum(pairing.partner, 0)]
        differences = np.clip(FREQUENCY.residual(self._log, partner_logs), -reach, reach)
        return np.asarray(np.where(pairing.partner >= 0, differences, reach))

    def _shapes(self, prediction: Prediction) -> _Shapes:
        """Return the shapes of the rows and modes of each setup, in units of each channel's motion."""
        model = prediction.shapes[..., self.columns]
        weights = channel_weights(model, self.motion)
        rows = self._normalised * weights
        # A stated error is relative to the largest component; the scatter used otherwise, to the largest in units of
        # each channel's motion.
        stated_errors = self._errors[..., None] * weights
        scatter = self._criteria.shapes.scatter * np.abs(rows).max(axis=-1, keepdims=True)
        errors = np.where(np.isnan(stated_errors), scatter, stated_errors) * self._measured
        return _Shapes(rows, model[:, prediction.rigid :] * weights, self._measured, errors)

    def _explained(self, shapes: _Shapes) -> Array:
        """Return the part of 1 - MAC that the errors of each row's shape explain, (S, r)."""
        c = self._criteria
        explained = explained_difference(shapes.rows, shapes.errors, c.pairing.shape_sigmas)
        return np.minimum(explained, 1.0 - c.shapes.good_mac)

    def _macs_in_groups(self, prediction: Prediction, shapes: _Shapes, single_macs: Array) -> Array:
        """Return the MAC of each row with each mode of the model, or with the subspace of the modes close to it."""
        log_frequencies = prediction.log_frequencies[:, prediction.rigid :]
        with np.errstate(invalid="ignore"):
            is_close_to_next = np.diff(log_frequencies, axis=1) < self._criteria.pairing.close
        setups = np.flatnonzero(is_close_to_next.any(axis=1))
        if not len(setups):
            return single_macs
        with np.errstate(invalid="ignore"):
            is_close = (
                np.abs(log_frequencies[setups][:, :, None] - log_frequencies[setups][:, None, :])
                < self._criteria.pairing.close
            )
        setup_index, mode = np.nonzero(is_close.sum(axis=-1) > 1)
        # Every row of a setup with a known shape, with every mode that has close neighbours.
        entry, column = np.nonzero(np.isfinite(single_macs[setups[setup_index], :, mode]))
        if not len(entry):
            return single_macs
        setup_index, mode = setup_index[entry], mode[entry]
        macs = single_macs.copy()
        subspace_macs = shapes.in_subspace(setups[setup_index], column, is_close[setup_index, mode])
        entries = setups[setup_index], column, mode
        macs[entries] = np.where(np.isnan(subspace_macs), macs[entries], subspace_macs)
        return macs

    def _macs_of_partners(
        self, partner: Index, unpaired_modes: Index, single_macs: Array, shapes: _Shapes
    ) -> Array:
        """Return the MAC of each row with its partner, or with the subspace of the partners and modes close to it."""
        pose, column = self.pose, self._column
        is_paired = partner >= 0
        macs = np.where(is_paired, single_macs[pose, column, np.maximum(partner, 0)], np.nan)
        has_close_modes = (self._close_rows[:, 1:] >= 0).any(axis=1) | (unpaired_modes >= 0).any(axis=1)
        crowded_rows = np.flatnonzero(is_paired & has_close_modes)
        if len(crowded_rows):
            rows = self._close_rows[crowded_rows]
            members = np.zeros((len(crowded_rows), shapes.model.shape[1]), dtype=bool)
            entry, member = np.nonzero((rows >= 0) & is_paired[rows])
            members[entry, partner[rows[entry, member]]] = True
            entry, member = np.nonzero(unpaired_modes[crowded_rows] >= 0)
            members[entry, unpaired_modes[crowded_rows][entry, member]] = True
            subspace_macs = shapes.in_subspace(pose[crowded_rows], column[crowded_rows], members)
            macs[crowded_rows] = np.where(members.sum(axis=1) > 1, subspace_macs, macs[crowded_rows])
        return macs


def _shape_distance(macs: Array, explained: Array) -> Array:
    """Return 1 - MAC less the part that the errors explain, from 0 for the same shape to 1."""
    return np.asarray(np.maximum(1.0 - macs - explained, 0.0) / (1.0 - explained))


def tile_indices(indices: Index, count: int, size: int) -> Index:
    """Return the indices of `count` copies of `size` items, the first copy first; -1 is kept."""
    copies = np.arange(count).reshape(-1, *[1] * indices.ndim) * size
    shifted = np.where(indices >= 0, indices + copies, indices)
    return np.asarray(shifted.reshape(-1, *indices.shape[1:]))


def close_rows(data: Measurements, criteria: Criteria) -> Index:
    """Return the rows whose shapes are compared as one subspace with that of each row.

    Their frequencies are close enough for the shapes to mix, or differ by less than their errors.

    Returns (R, g): the row itself first, then the others, padded with -1.
    """
    log, sigma = FREQUENCY.transformed(data), FREQUENCY.transformed_sigma(data)
    limits, pose = criteria.pairing, data.pose
    order = np.lexsort((log, pose))
    close_pairs: list[tuple[Index, Index]] = []
    involved_rows: Index = np.empty(0, dtype=np.intp)
    for a, b in pairs_of_setups(pose, order):
        log_differences = np.abs(log[a] - log[b])
        if not (
            log_differences < limits.most_mixed
        ).any():  # in the order of frequencies, later pairs are farther apart
            break
        errors = limits.mixed_sigmas * np.hypot(sigma[a], sigma[b])
        is_close = log_differences < np.clip(errors, limits.mixed, limits.most_mixed)
        if not close_pairs:
            involved_rows = np.union1d(a[is_close], b[is_close])
        close_pairs += [(a[is_close], b[is_close]), (b[is_close], a[is_close])]
    rows, partners = (
        np.concatenate([pair[side] for pair in close_pairs] or [involved_rows]) for side in (0, 1)
    )
    is_involved = np.isin(rows, involved_rows)
    rows, partners = rows[is_involved], partners[is_involved]
    order_of_pairs = np.lexsort((partners, rows))
    rows, partners = rows[order_of_pairs], partners[order_of_pairs]
    counts = np.bincount(rows, minlength=len(log))
    padded = np.full((len(log), 1 + int(counts.max(initial=0))), -1, dtype=np.intp)
    padded[:, 0] = np.arange(len(log))
    padded[rows, 1 + np.arange(len(rows)) - (np.cumsum(counts) - counts)[rows]] = partners
    return padded


def unpaired_close_modes(
    prediction: Prediction, partner: Index, pose: Index, max_log_difference: float
) -> Index:
    """Return the unpaired modes that nearly coincide with a row's partner.

    A measured mode may be any mixture of the two, so its pairing with one of them is arbitrary.

    - partner, pose: (R,)
    - max_log_difference: largest difference of the logarithms of their frequencies

    Returns (R, 4): mode numbers, counted from 0, rigid ones included; padded with -1.
    """
    log_frequencies = prediction.log_frequencies
    is_paired_mode = np.zeros(log_frequencies.shape, dtype=bool)
    is_paired_row = partner >= 0
    is_paired_mode[pose[is_paired_row], partner[is_paired_row]] = True
    candidates = np.maximum(partner, 0)[:, None] + np.array([-2, -1, 1, 2])
    exists = (
        (candidates >= prediction.rigid) & (candidates < log_frequencies.shape[1]) & is_paired_row[:, None]
    )
    candidates = np.where(exists, candidates, 0)
    partner_logs = log_frequencies[pose, np.maximum(partner, 0)][:, None]
    with np.errstate(invalid="ignore"):
        is_close = np.abs(log_frequencies[pose[:, None], candidates] - partner_logs) < max_log_difference
    return np.where(exists & is_close & ~is_paired_mode[pose[:, None], candidates], candidates, -1)


def _assign(cost: Array, is_present: NDArray[np.bool_], is_available: NDArray[np.bool_]) -> Index:
    """Assign the rows of each setup one-to-one to modes (S, r) with the least sum of costs; -1 for unassigned rows.

    - cost: (S, r, m)
    - is_present: rows to assign, (S, r)
    - is_available: modes available, (S, m)
    """
    cost = np.where(is_available[:, None], cost, np.inf)
    best: Index = cost.argmin(axis=2)
    best[~(is_present & is_available.any(axis=1, keepdims=True))] = -1
    # If every row can have its best mode, the sum is least.
    ordered = np.sort(best, axis=1)
    contested = ((np.diff(ordered, axis=1) == 0) & (ordered[:, 1:] >= 0)).any(axis=1)
    for setup in np.flatnonzero(contested):
        rows, modes = np.flatnonzero(is_present[setup]), np.flatnonzero(is_available[setup])
        i, k = linear_sum_assignment(cost[setup][np.ix_(rows, modes)])
        best[setup] = -1
        best[setup, rows[i]] = modes[k]
    return best


def _reorder_close_modes(partner: Index, measured: Array, is_close_to_next: NDArray[np.bool_]) -> Index:
    """Reorder the partners (S, r) in each group of close modes by the measured frequencies."""
    group = np.concatenate(
        [np.zeros((len(is_close_to_next), 1), dtype=np.intp), np.cumsum(~is_close_to_next, axis=1)], axis=1
    )
    row_group = np.where(partner >= 0, np.take_along_axis(group, np.maximum(partner, 0), axis=1), -1)
    # Groups ascend with the modes, so rows sorted by group and frequency get the partners in ascending order.
    ordered = np.empty_like(partner)
    np.put_along_axis(ordered, np.lexsort((measured, row_group), axis=-1), np.sort(partner, axis=1), axis=1)
    return ordered
