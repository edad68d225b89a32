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

from pkmodes.modaltest.identification.asked import (
    NOTHING,
    REACH,
    RequestedModes,
    replaced,
    struck,
    within_reach,
)
from pkmodes.modaltest.identification.clusters import PoleCluster, orders_with, pole_clusters, usable_poles
from pkmodes.modaltest.identification.lscf import OrderPoles
from pkmodes.modaltest.identification.ssi import Order, order, subspace
from pkmodes.modaltest.identification.ssi_bands import (
    BandPart,
    PreparedRecord,
    SpectralLines,
    correlations,
    powers,
)
from pkmodes.modaltest.identification.ssi_selection import Refined, refined, start

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Model orders of a part of the band.
ORDERS = tuple(range(1, 15))
#: Block rows, and the first lag, in samples of the analytic signal.
BLOCKS, FIRST = 20, 1
#: Model orders tried for a shape: the one with the least standard deviation is taken.
SHAPES = 4
#: Most references, combinations of the responses.
REFERENCES = 6
#: Log-likelihood ratio above which a peak is more than a bump of noise: as in `ssi_selection`, but for about ten
#: places instead of about a hundred.
SIGNIFICANT = 9.0
#: Fits that end closer than this fraction of their half bandwidth are the same.
SAME = 0.1


@dataclass(frozen=True, eq=False)
class PartMode:
    """A mode, the part of the band in which it was found, and its subspace identification."""

    mode: Refined
    part: BandPart
    orders: tuple[Order, ...]
    references: Array
    order_count: int


#: Requested modes, by the frequency that the user gives [Hz]; or why there is none.
Wanted = dict[float, PartMode | str]


def modes_of_part(
    record: PreparedRecord,
    part: BandPart,
    poles: list[list[Complex]],
    edits: RequestedModes = NOTHING,
) -> tuple[list[PartMode], Wanted]:
    """Return the modes of a part of the band, and those requested in it; add its poles to those of each order."""
    power = powers(record.padded, part)
    levels = np.sqrt(np.maximum(np.diag(power).real, 1e-300))
    _, directions = np.linalg.eigh((power / np.outer(levels, levels)).real)
    references = directions[:, ::-1][:, :REFERENCES] / levels[:, None]
    blocks = min(BLOCKS, int(0.25 * part.rate * record.seconds))
    lags = np.arange(FIRST, FIRST + 2 * blocks)
    range_of = subspace(
        correlations(record.padded, part, references, lags) / levels[:, None], blocks, ORDERS[-1]
    )
    orders = [order(range_of, n) for n in ORDERS if n <= range_of.left.shape[1]]
    by_order = []
    for k, model in enumerate(orders):
        s = part.pole(model.values)
        by_order.append(
            OrderPoles(s, (model.shapes * levels[:, None]).T, np.ones((len(s), 1), complex), ORDERS[k])
        )
        inside = (s.imag >= 2 * math.pi * part.low) & (s.imag < 2 * math.pi * part.high)
        poles[k].append(s[inside & (s.real < 0.0)])
    margin = 0.5 * (part.low - part.start), 0.5 * (part.stop - part.high)
    chosen = pole_clusters(by_order, part.low - margin[0], part.high + margin[1])

    def part_mode(mode: Refined, pole: complex, count: int) -> PartMode:
        away = [np.abs(model.poles - pole).min() for model in by_order]
        nearest = tuple(_rescaled(orders[k], levels) for k in np.argsort(away)[:SHAPES])
        return PartMode(mode, part, nearest, references, count)

    selected = _selected(record, part, chosen)
    modes = [mode for mode, _ in selected]
    requested: Wanted = {}
    for frequency in edits.add:
        if part.low <= frequency <= part.high:
            outcome = added(by_order, modes, edits, record.plain, (part.start, part.stop), frequency)
            if isinstance(outcome, str):
                requested[frequency] = outcome
            else:
                requested[frequency] = part_mode(outcome, outcome.pole, orders_with(by_order, outcome.pole))
    return [part_mode(mode, candidate.pole, candidate.order_count) for mode, candidate in selected], requested


def _rescaled(of: Order, levels: Array) -> Order:
    """Return an order with its responses in the scale of the lines."""
    blocks = of.rows.shape[1] // len(levels)
    return Order(of.values, of.shapes * levels[:, None], of.rows / np.tile(levels, blocks), of.columns)


def _selected(
    record: PreparedRecord, part: BandPart, chosen: Sequence[PoleCluster]
) -> list[tuple[Refined, PoleCluster]]:
    """Return the candidates that are modes: the strongest are tried first, then each is fitted beside the others."""
    ends = part.start, part.stop
    strength = [_strength(record, candidate) for candidate in chosen]
    kept: list[tuple[Refined, PoleCluster]] = []
    for k in np.argsort(strength)[::-1]:
        candidate = chosen[k]
        mode = refined(
            start(candidate.pole, candidate.shape), [kept_mode for kept_mode, _ in kept], record.plain, ends
        )
        if mode is not None:
            kept.append((mode, candidate))
    # the least certain first: a second description of a mode is dropped before the mode is fitted beside it
    for pair in sorted(kept, key=lambda pair: pair[0].gain):
        kept.remove(pair)
        again = refined(pair[0], [kept_mode for kept_mode, _ in kept], record.plain, ends)
        if again is not None:
            kept.append((again, pair[1]))
    return kept


def _strength(record: PreparedRecord, candidate: PoleCluster) -> float:
    """Return the mean power of the lines within the bandwidth of a candidate, along its shape."""
    f, width = (
        candidate.pole.imag / (2 * math.pi),
        max(-candidate.pole.real / (2 * math.pi), 1.0 / record.seconds),
    )
    along = candidate.shape.conj() / np.linalg.norm(candidate.shape)
    powers = []
    for piece in record.plain:
        inside = slice(*np.searchsorted(piece.frequencies, [f - width, f + width]))
        powers.append((np.abs(piece.values[inside] @ along) ** 2).sum() * piece.step)
    return float(sum(powers)) / width


def added(
    by_order: Sequence[OrderPoles],
    modes: Sequence[Refined],
    edits: RequestedModes,
    lines: Sequence[SpectralLines],
    ends: tuple[float, float],
    target: float,
) -> Refined | str:
    """Return the mode fitted from a frequency [Hz], or why there is none.

    - modes: those found; those struck out, and the one that it replaces, are not fitted beside it
    - lines: of pieces without padding
    - ends: of the lines that may be used [Hz]
    """
    f = np.array([mode.undamped for mode in modes])
    gone, before = struck(f, edits), replaced(f, edits, target)
    neighbours = [mode for i, mode in enumerate(modes) if not gone[i] and i != before]
    near = [
        start(complex(model.poles[k]), model.shapes[k])
        for model in by_order
        for k in np.flatnonzero(usable_poles(model.poles, (1.0 - REACH) * target, (1.0 + REACH) * target))
    ]
    if not near:
        return "no model order has a pole within 3 % of it"
    fits: list[Refined] = []
    for candidate in near:
        mode = refined(candidate, neighbours, lines, ends, SIGNIFICANT)
        if mode is not None and within_reach(mode.undamped, target):
            fits.append(mode)
    if not fits:
        return "no fit to the spectra converges within 3 % of it to a peak above the noise"
    first = min(fits, key=lambda fit: abs(fit.frequency - target))
    same = SAME * first.rate / (2.0 * math.pi)
    return max((fit for fit in fits if abs(fit.frequency - first.frequency) < same), key=lambda fit: fit.gain)
