"""Modes of one part of the band: poles of all model orders, their clusters, and those that have a peak.

A mode that the user requests is fitted to the spectra around a frequency, beside those found.  The poles of all model
orders near the frequency give shapes, each of which separates the power of a mode from that of its neighbours; the
fit is that of `ssi_selection`.  As it is tried at a few places instead of over the whole band, it needs less evidence
than a mode found by a search.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.clusters import PoleCluster, count_orders, pole_clusters, usable_poles
from pkmodes.modaltest.identification.lscf import OrderPoles
from pkmodes.modaltest.identification.requested_modes import (
    MAX_SHIFT,
    NO_EDITS,
    RequestedModes,
    index_to_replace,
    near_request,
    struck_mask,
)
from pkmodes.modaltest.identification.ssi import OrderModes, modes_of_order, subspace
from pkmodes.modaltest.identification.ssi_bands import (
    BandPart,
    PreparedRecord,
    SpectralLines,
    correlations,
    zero_lag_correlations,
)
from pkmodes.modaltest.identification.ssi_selection import RefinedMode, refine, starting_mode

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Model orders of a part of the band.
ORDERS = tuple(range(1, 15))
#: Block rows, and the first lag, in samples of the analytic signal.
BLOCKS, FIRST_LAG = 20, 1
#: Model orders tried for a shape: the one with the least standard deviation is taken.
SHAPE_TRIALS = 4
#: Maximum number of references, combinations of the responses.
MAX_REFERENCES = 6
#: Log-likelihood ratio above which a peak is more than a bump of noise: as in `ssi_selection`, but for about ten
#: places instead of about a hundred.
SIGNIFICANT = 9.0
#: Fits that end closer than this fraction of their half bandwidth are the same.
SAME_FIT_DISTANCE = 0.1


@dataclass(frozen=True, eq=False)
class PartMode:
    """A mode, the part of the band in which it was found, and its subspace identification."""

    mode: RefinedMode
    part: BandPart
    orders: tuple[OrderModes, ...]
    references: Array
    order_count: int


#: Requested modes, by the frequency that the user gives [Hz]; or why there is none.
RequestOutcomes = dict[float, PartMode | str]


def modes_of_part(
    record: PreparedRecord,
    part: BandPart,
    poles: list[list[Complex]],
    edits: RequestedModes = NO_EDITS,
) -> tuple[list[PartMode], RequestOutcomes]:
    """Return the modes of a part of the band, and those requested in it; add its poles to those of each order."""
    power = zero_lag_correlations(record.padded, part)
    levels = np.sqrt(np.maximum(np.diag(power).real, 1e-300))
    _, directions = np.linalg.eigh((power / np.outer(levels, levels)).real)
    references = directions[:, ::-1][:, :MAX_REFERENCES] / levels[:, None]
    blocks = min(BLOCKS, int(0.25 * part.rate * record.seconds))
    lags = np.arange(FIRST_LAG, FIRST_LAG + 2 * blocks)
    space = subspace(
        correlations(record.padded, part, references, lags) / levels[:, None], blocks, ORDERS[-1]
    )
    orders = [modes_of_order(space, n) for n in ORDERS if n <= space.left.shape[1]]
    poles_by_order = []
    for k, model in enumerate(orders):
        s = part.pole(model.values)
        poles_by_order.append(
            OrderPoles(s, (model.shapes * levels[:, None]).T, np.ones((len(s), 1), complex), ORDERS[k])
        )
        in_part = (s.imag >= 2 * math.pi * part.low) & (s.imag < 2 * math.pi * part.high)
        poles[k].append(s[in_part & (s.real < 0.0)])
    margins = 0.5 * (part.low - part.start), 0.5 * (part.stop - part.high)
    clusters = pole_clusters(poles_by_order, part.low - margins[0], part.high + margins[1])

    def part_mode(mode: RefinedMode, pole: complex, count: int) -> PartMode:
        distances = [np.abs(model.poles - pole).min() for model in poles_by_order]
        nearest = tuple(_rescale(orders[k], levels) for k in np.argsort(distances)[:SHAPE_TRIALS])
        return PartMode(mode, part, nearest, references, count)

    selected = _select_modes(record, part, clusters)
    modes = [mode for mode, _ in selected]
    requested: RequestOutcomes = {}
    for frequency in edits.add:
        if part.low <= frequency <= part.high:
            outcome = fit_requested(
                poles_by_order, modes, edits, record.unpadded, (part.start, part.stop), frequency
            )
            if isinstance(outcome, str):
                requested[frequency] = outcome
            else:
                requested[frequency] = part_mode(
                    outcome, outcome.pole, count_orders(poles_by_order, outcome.pole)
                )
    return [part_mode(mode, candidate.pole, candidate.order_count) for mode, candidate in selected], requested


def _rescale(order_modes: OrderModes, levels: Array) -> OrderModes:
    """Return an order with its responses in the scale of the lines."""
    blocks = order_modes.rows.shape[1] // len(levels)
    return OrderModes(
        order_modes.values,
        order_modes.shapes * levels[:, None],
        order_modes.rows / np.tile(levels, blocks),
        order_modes.columns,
    )


def _select_modes(
    record: PreparedRecord, part: BandPart, clusters: Sequence[PoleCluster]
) -> list[tuple[RefinedMode, PoleCluster]]:
    """Return the candidates that are modes: the strongest are tried first, then each is fitted beside the others."""
    ends = part.start, part.stop
    strength = [_strength(record, candidate) for candidate in clusters]
    accepted: list[tuple[RefinedMode, PoleCluster]] = []
    for k in np.argsort(strength)[::-1]:
        candidate = clusters[k]
        mode = refine(
            starting_mode(candidate.pole, candidate.shape),
            [neighbour for neighbour, _ in accepted],
            record.unpadded,
            ends,
        )
        if mode is not None:
            accepted.append((mode, candidate))
    # the least certain first: a second description of a mode is dropped before the mode is fitted beside it
    for pair in sorted(accepted, key=lambda pair: pair[0].log_likelihood_ratio):
        accepted.remove(pair)
        refitted = refine(pair[0], [neighbour for neighbour, _ in accepted], record.unpadded, ends)
        if refitted is not None:
            accepted.append((refitted, pair[1]))
    return accepted


def _strength(record: PreparedRecord, candidate: PoleCluster) -> float:
    """Return the mean power of the lines within the bandwidth of a candidate, along its shape."""
    f, width = (
        candidate.pole.imag / (2 * math.pi),
        max(-candidate.pole.real / (2 * math.pi), 1.0 / record.seconds),
    )
    weights = candidate.shape.conj() / np.linalg.norm(candidate.shape)
    zero_lag_correlations = []
    for piece in record.unpadded:
        line_range = slice(*np.searchsorted(piece.frequencies, [f - width, f + width]))
        zero_lag_correlations.append((np.abs(piece.values[line_range] @ weights) ** 2).sum() * piece.step)
    return float(sum(zero_lag_correlations)) / width


def fit_requested(
    poles_by_order: Sequence[OrderPoles],
    modes: Sequence[RefinedMode],
    edits: RequestedModes,
    lines: Sequence[SpectralLines],
    ends: tuple[float, float],
    target: float,
) -> RefinedMode | str:
    """Return the mode fitted from a frequency [Hz], or why there is none.

    - modes: modes found; those struck out, and the one that it replaces, are not fitted beside it
    - lines: lines of pieces without padding
    - ends: ends of the range of lines that may be used [Hz]
    """
    f = np.array([mode.undamped for mode in modes])
    struck, replaced_index = struck_mask(f, edits), index_to_replace(f, edits, target)
    neighbours = [mode for i, mode in enumerate(modes) if not struck[i] and i != replaced_index]
    candidates = [
        starting_mode(complex(model.poles[k]), model.shapes[k])
        for model in poles_by_order
        for k in np.flatnonzero(
            usable_poles(model.poles, (1.0 - MAX_SHIFT) * target, (1.0 + MAX_SHIFT) * target)
        )
    ]
    if not candidates:
        return "no model order has a pole within 3 % of it"
    fits: list[RefinedMode] = []
    for candidate in candidates:
        mode = refine(candidate, neighbours, lines, ends, SIGNIFICANT)
        if mode is not None and near_request(mode.undamped, target):
            fits.append(mode)
    if not fits:
        return "no fit to the spectra converges within 3 % of it to a peak above the noise"
    first = min(fits, key=lambda fit: abs(fit.frequency - target))
    max_distance = SAME_FIT_DISTANCE * first.rate / (2.0 * math.pi)
    return max(
        (fit for fit in fits if abs(fit.frequency - first.frequency) < max_distance),
        key=lambda fit: fit.log_likelihood_ratio,
    )
