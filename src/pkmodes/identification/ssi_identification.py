"""Modes of responses alone: ambient records, decays and sweeps.

The band is treated in overlapping parts (`ssi_bands`).  In each, covariance-driven subspace identification (`ssi`)
gives poles and shapes of all model orders, clusters of these give candidates (`clusters`), and the power on the lines
around each decides whether it is a mode (`ssi_selection`) and what its frequency and damping are (`ssi_likelihood`).
The shape and its standard deviation are those of the subspace identification (`ssi_uncertainty`).
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import MeasurementError
from pkmodes.identification.asked import NOTHING, Asked, replaced
from pkmodes.identification.clusters import Candidate, candidates
from pkmodes.identification.estimates import Estimate, Mode, Stabilisation, alike
from pkmodes.identification.lscf import OrderPoles
from pkmodes.identification.ssi import Order, order, subspace
from pkmodes.identification.ssi_added import added, orders_with
from pkmodes.identification.ssi_bands import Lines, Part, correlations, lines, parts
from pkmodes.identification.ssi_selection import Refined, refined, start
from pkmodes.identification.ssi_uncertainty import sigma
from pkmodes.identification.tones import Tone, find_tones, without_tones

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Model orders of a part of the band.
ORDERS = tuple(range(1, 15))
#: Block rows, and the first lag, in samples of the analytic signal.
BLOCKS, FIRST = 20, 1
#: Model orders that are tried for a shape: that of the least standard deviation is taken.
SHAPES = 4
#: Rate of decay times length of record below which a mode at a tone is what its subtraction left.
REST = 12.0
#: Factor on standard deviations for what the peaks and the choice of an order leave out: measured on simulated
#: records of 40 s, where 2 sigma without it cover 90 to 93 %.
ALLOWANCE = 1.15
#: No standard deviation of the logarithm of a rate above this is told from it.
MOST_RELATIVE = 3.0
#: Most references, combinations of the responses.
REFERENCES = 6
#: Periods of the lower end of the band that a piece of a record has at least.
FEWEST_PERIODS = 8.0
#: Lines averaged for what is drawn.
DRAWN = 400


@dataclass(frozen=True, eq=False)
class _Record:
    """A record prepared for identification: its sensors relative to their rms, its lines padded and not."""

    padded: list[Lines]
    plain: list[Lines]
    scales: Array
    seconds: float


@dataclass(frozen=True, eq=False)
class _Found:
    """A mode, where it was found, and what its subspace identification says."""

    mode: Refined
    part: Part
    orders: tuple[Order, ...]
    references: Array
    found: int


def identify_responses(
    t_step: float,
    signals: Array | Sequence[Array],
    *,
    band: tuple[float, float],
    tones: Sequence[float] = (),
    asked: Asked = NOTHING,
) -> tuple[Estimate, tuple[str, ...]]:
    """Identify modes from responses without a force.

    Parameters
    ----------
    t_step : float
        In s.
    signals : ndarray, shape (N, S), or a sequence of these
        Responses, or pieces of one record between gaps.
    band : tuple of float
        Where modes are wanted [Hz].
    tones : sequence of float
        Frequencies of lines that are no modes, as are their multiples [Hz].
    asked : Asked
        Modes that the user adds.

    Returns
    -------
    Estimate
        Its functions are the spectral densities of the responses, (F, S, 1).
    tuple of str
        Sentences on what was found besides modes.

    Raises
    ------
    MeasurementError
        If the band is not below the Nyquist frequency, or the record is too short for it.
    """
    pieces = (
        [np.asarray(signals, float)] if isinstance(signals, np.ndarray) else [np.asarray(p) for p in signals]
    )
    pieces = _checked(t_step, pieces, band)
    found_tones = find_tones(t_step, pieces, band, tones)
    record = _prepared(t_step, without_tones(t_step, pieces, found_tones, band))
    found: list[_Found] = []
    poles: list[list[Complex]] = [[] for _ in ORDERS]
    further: dict[float, _Found | str] = {}
    for part in parts(*band, 0.5 / t_step, record.seconds):
        found += _of_part(record, part, poles, asked, further)
    kept = [
        one
        for one in _beside_all(record, _distinct(found))
        if not _rest_of_tone(one.mode, found_tones, record)
    ]
    if further:
        kept, further = _with_added(record, kept, further, found_tones, asked)
    modes = tuple(
        _mode(record, one) for one in kept if band[0] <= abs(one.mode.pole) / (2 * math.pi) <= band[1]
    )
    wanted = [further.get(f, "it is outside the band") for f in asked.add]
    more = tuple(one if isinstance(one, str) else _mode(record, one) for one in wanted)
    stabilisation = Stabilisation(np.array(ORDERS), tuple(np.concatenate(some) for some in poles))
    every = (*modes, *(one for one in more if isinstance(one, Mode)))
    lines = tuple(tone.frequency for tone in found_tones if band[0] <= tone.frequency <= band[1])
    estimate = Estimate(modes, stabilisation, *_drawn(record, every, band), more, lines)
    return estimate, _sentences(found_tones, every, record.seconds)


def _checked(t_step: float, pieces: list[Array], band: tuple[float, float]) -> list[Array]:
    if band[1] >= 0.5 / t_step:
        raise MeasurementError(
            f"the band ends at {band[1]:g} Hz, the Nyquist frequency is {0.5 / t_step:g} Hz",
            "band",
            "end it below",
        )
    usable = [piece for piece in pieces if len(piece) * t_step * band[0] >= FEWEST_PERIODS]
    if not usable:
        raise MeasurementError(
            f"a record without gaps is shorter than eight periods of {band[0]:g} Hz",
            "band",
            "record for longer, or start the band higher",
        )
    return usable


def _prepared(t_step: float, pieces: list[Array]) -> _Record:
    total = sum(len(piece) for piece in pieces)
    centred = [piece - piece.mean(axis=0) for piece in pieces]
    scales = np.sqrt(sum(((piece**2).sum(axis=0) for piece in centred), np.zeros(pieces[0].shape[1])) / total)
    alive = np.where(scales > 0.0, scales, np.inf)
    scaled = [piece / alive for piece in centred]
    longest = max(len(piece) for piece in scaled)
    return _Record(lines(scaled, t_step, 2 * longest), lines(scaled, t_step), scales, longest * t_step)


def _of_part(
    record: _Record,
    part: Part,
    poles: list[list[Complex]],
    asked: Asked,
    further: dict[float, _Found | str],
) -> list[_Found]:
    """Return the modes of a part of the band, and add its poles to those of each order, and the modes asked for."""
    S = len(record.scales)
    everything = np.eye(S)
    power = correlations(record.padded, part, everything, np.zeros(1, np.int64))[0]
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
    for k, one in enumerate(orders):
        s = part.pole(one.values)
        by_order.append(
            OrderPoles(ORDERS[k], s, (one.shapes * levels[:, None]).T, np.ones((len(s), 1), complex))
        )
        inside = (s.imag >= 2 * math.pi * part.low) & (s.imag < 2 * math.pi * part.high)
        poles[k].append(s[inside & (s.real < 0.0)])
    margin = 0.5 * (part.low - part.start), 0.5 * (part.stop - part.high)
    chosen = candidates(by_order, part.low - margin[0], part.high + margin[1])

    def found(mode: Refined, pole: complex, count: int) -> _Found:
        near = tuple(_rescaled(orders[k], levels) for k in _near(by_order, pole))
        return _Found(mode, part, near, references, count)

    selected = _selected(record, part, chosen)
    modes = [mode for mode, _ in selected]
    for wanted in asked.add:
        if part.low <= wanted < part.high or (wanted == part.high and wanted not in further):
            more = added(by_order, modes, asked, record.plain, (part.start, part.stop), wanted)
            further[wanted] = (
                more if isinstance(more, str) else found(more, more.pole, orders_with(by_order, more))
            )
    return [found(mode, one.pole, one.found) for mode, one in selected]


def _with_added(
    record: _Record,
    found: Sequence[_Found],
    further: dict[float, _Found | str],
    tones: Sequence[Tone],
    asked: Asked,
) -> tuple[list[_Found], dict[float, _Found | str]]:
    """Return the modes found that those added do not replace, and these without what is left of a tone."""
    kept, more = list(found), dict(further)
    for wanted, one in further.items():
        if isinstance(one, str):
            continue
        if _rest_of_tone(one.mode, tones, record):
            more[wanted] = "what is fitted there is left of a tone"
            continue
        before = replaced(
            [abs(each.mode.pole) / (2 * math.pi) for each in kept], asked, abs(one.mode.pole) / (2 * math.pi)
        )
        if before is not None:
            del kept[before]
    return kept, more


def _rescaled(of: Order, levels: Array) -> Order:
    """Return an order whose responses are in the scale of the lines."""
    blocks = of.rows.shape[1] // len(levels)
    return Order(of.values, of.shapes * levels[:, None], of.rows / np.tile(levels, blocks), of.columns)


def _near(by_order: Sequence[OrderPoles], pole: complex) -> list[int]:
    """Return the orders that have a pole nearest to one."""
    nearness = [np.abs(one.poles - pole).min() for one in by_order]
    return [int(k) for k in np.argsort(nearness)[:SHAPES]]


def _selected(record: _Record, part: Part, chosen: Sequence[Candidate]) -> list[tuple[Refined, Candidate]]:
    """Return the candidates that are modes: the strongest are tried first, then each is fitted beside the others."""
    ends = part.start, part.stop
    strength = [_strength(record, one) for one in chosen]
    kept: list[tuple[Refined, Candidate]] = []
    for k in np.argsort(strength)[::-1]:
        one = chosen[k]
        mode = refined(start(one.pole, one.shape), [other for other, _ in kept], record.plain, ends)
        if mode is not None:
            kept.append((mode, one))
    # the least certain first: what describes a mode a second time goes before the mode is fitted beside it
    for pair in sorted(kept, key=lambda pair: pair[0].gain):
        kept.remove(pair)
        again = refined(pair[0], [other for other, _ in kept], record.plain, ends)
        if again is not None:
            kept.append((again, pair[1]))
    return kept


def _strength(record: _Record, one: Candidate) -> float:
    """Return the mean power of the lines within the bandwidth of a candidate, along its shape."""
    f, width = one.pole.imag / (2 * math.pi), max(-one.pole.real / (2 * math.pi), 1.0 / record.seconds)
    along = one.shape.conj() / np.linalg.norm(one.shape)
    powers = []
    for piece in record.plain:
        inside = slice(*np.searchsorted(piece.frequencies, [f - width, f + width]))
        powers.append((np.abs(piece.values[inside] @ along) ** 2).sum() * piece.step)
    return float(sum(powers)) / width


def _distinct(found: Sequence[_Found]) -> list[_Found]:
    """Return the modes by frequency, one of those that two overlapping parts found: the more central one."""
    kept: list[_Found] = []
    for one in sorted(found, key=_eccentricity):
        f, rate = one.mode.frequency, one.mode.rate
        for other in kept:
            if other.part is one.part:
                continue
            apart = 2 * math.pi * abs(f - other.mode.frequency) / (rate + other.mode.rate)
            near = 2 * math.pi * abs(f - other.mode.frequency) < 0.5 * (rate + other.mode.rate)
            if near or (apart < 2.0 and alike(one.mode.shape, other.mode.shape) > 0.8):
                break
        else:
            if one.part.low <= f <= one.part.high or _eccentricity(one) < 1.3:
                kept.append(one)
    return sorted(kept, key=lambda one: one.mode.frequency)


def _rest_of_tone(mode: Refined, found: Sequence[Tone], record: _Record) -> bool:
    """Return whether a mode is as narrow as lines and at a tone: what its subtraction left."""
    near = any(abs(mode.frequency - tone.frequency) * record.seconds < 3.0 for tone in found)
    return near and mode.rate * record.seconds < REST


def _beside_all(record: _Record, found: Sequence[_Found]) -> list[_Found]:
    """Return the modes fitted again beside those of all parts of the band."""
    again = list(found)
    for one in sorted(found, key=lambda one: one.mode.gain):
        again.remove(one)
        mode = refined(
            one.mode, [other.mode for other in again], record.plain, (one.part.start, one.part.stop)
        )
        if mode is not None:
            again.append(replace(one, mode=mode))
    return sorted(again, key=lambda one: one.mode.frequency)


def _eccentricity(one: _Found) -> float:
    middle, half = 0.5 * (one.part.low + one.part.high), 0.5 * (one.part.high - one.part.low)
    return abs(one.mode.frequency - middle) / half


def _mode(record: _Record, one: _Found) -> Mode:
    mode, pole = one.mode, one.mode.pole
    tried = []
    for k, of in enumerate(one.orders):
        i = int(np.argmin(np.abs(one.part.pole(of.values) - pole)))
        tried.append((sigma(record.plain, one.part, one.references, FIRST, of, i, record.scales).shape, k, i))
    of_shape, k, i = min(tried)
    # |pole| by the damped frequency and the logarithm of the rate, and the damping ratio by these
    omega = abs(pole)
    by = np.array([2 * math.pi * pole.imag, pole.real**2]) / omega
    of_damping = np.array([0.0, mode.rate / omega]) - mode.rate / omega**2 * by
    frequency = ALLOWANCE * math.sqrt(max(float(by @ mode.covariance @ by), 0.0)) / (2 * math.pi)
    # the estimate of a rate is nearly log-normal: its upper side, as a low estimate would also claim a low sigma
    relative = math.sqrt(max(float(of_damping @ mode.covariance @ of_damping), 0.0)) * omega / mode.rate
    damping = ALLOWANCE * mode.rate / omega * math.expm1(min(relative, MOST_RELATIVE))
    shape = np.where(record.scales > 0.0, one.orders[k].shapes[:, i] * record.scales, np.nan)
    return Mode(pole, shape, frequency, damping, ALLOWANCE * of_shape, (one.found, len(ORDERS)))


def _drawn(
    record: _Record, modes: Sequence[Mode], band: tuple[float, float]
) -> tuple[Array, Complex, Complex]:
    """Return averaged spectral densities of the responses in the band, and the modes' share of them."""
    piece = max(record.plain, key=lambda one: len(one.frequencies))
    inside = slice(*np.searchsorted(piece.frequencies, band))
    f, power = piece.frequencies[inside], np.abs(piece.values[inside]) ** 2 * record.scales**2 * piece.step
    group = max(len(f) // DRAWN, 1)
    rows = len(f) // group * group
    f = f[:rows].reshape(-1, group).mean(axis=1)
    power = power[:rows].reshape(len(f), group, -1).mean(axis=1)
    peaks = np.array([1.0 / np.abs(2j * math.pi * f - mode.pole) ** 2 for mode in modes]).reshape(
        len(modes), len(f)
    )
    at = [int(np.argmin(np.abs(f - mode.frequency))) for mode in modes]
    heights = np.array([power[k] / peaks[j, k] for j, k in enumerate(at)])
    heights = heights.reshape(len(modes), power.shape[1])
    return f, power[:, :, None].astype(complex), (peaks.T @ heights)[:, :, None].astype(complex)


def _sentences(found: Sequence[Tone], modes: Sequence[Mode], seconds: float) -> tuple[str, ...]:
    said = [tone.sentence for tone in found]
    for mode in modes:
        for tone in found:
            if abs(mode.frequency - tone.frequency) < max(2.0 * mode.damping * mode.frequency, 2.0 / seconds):
                said.append(
                    f"the mode at {mode.frequency:.4g} Hz is beside the tone at {tone.frequency:.4g} Hz"
                )
    return tuple(said)
