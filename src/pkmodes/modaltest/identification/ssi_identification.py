"""Modes of responses alone: ambient records, decays and sweeps.

The band is treated in overlapping parts (`ssi_bands`).  In each, covariance-driven subspace identification (`ssi`)
gives poles and shapes of all model orders, clusters of these give candidates (`clusters`), and the power on the lines
around each decides whether it is a mode (`ssi_selection`) and what its frequency and damping are (`ssi_likelihood`).
The shape and its standard deviation are those of the subspace identification (`ssi_uncertainty`).  A mode that two
overlapping parts find is kept once, and each is fitted again beside those of all parts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.ordering import joined
from pkmodes.modaltest.identification.asked import NOTHING, RequestedModes, nearest_frequency, replaced
from pkmodes.modaltest.identification.estimates import Estimate, Mode, Stabilisation, complex_mac
from pkmodes.modaltest.identification.ssi_bands import PreparedRecord, parts, prepared, usable_pieces
from pkmodes.modaltest.identification.ssi_lines import lines_among
from pkmodes.modaltest.identification.ssi_parts import FIRST, ORDERS, PartMode, Wanted, modes_of_part
from pkmodes.modaltest.identification.ssi_selection import Refined, refined
from pkmodes.modaltest.identification.ssi_uncertainty import sigma
from pkmodes.modaltest.identification.sweeps import at_end_of_line
from pkmodes.modaltest.identification.tones import Tone, find_tones, tones_alone, without_tones

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Factor on standard deviations for what the peak fit and the choice of an order ignore: calibrated on simulated
#: records of 40 s, in which 2 sigma without it cover 90 to 93 %.
ALLOWANCE = 1.15
#: Shapes of model orders with sigmas below this multiple of the least one are compared too: their differences, such
#: as how much of a strong neighbour's shape is in that of a weak mode, show in no single order.
AS_SURE = 2.0
#: Message about a record that holds only tones.
NOTHING_ELSE = (
    "besides tones the record holds only the rounding of its numbers, in which no mode can be found"
)
#: Standard deviations of the logarithm of a rate are capped here.
MOST_RELATIVE = 3.0
#: Averaged lines that are drawn.
DRAWN = 400
#: Decay rate times record length below which a mode at a tone is a remainder of its subtraction.
REST = 12.0


def identify_responses(
    t_step: float,
    signals: Array | Sequence[Array],
    *,
    band: tuple[float, float],
    tones: Sequence[float] = (),
    edits: RequestedModes = NOTHING,
) -> tuple[Estimate, tuple[str, ...]]:
    """Identify modes from responses without a force.

    - t_step: in s
    - signals: responses, or pieces of one record between gaps, (N, S) or a sequence of these
    - band: where modes are wanted [Hz]
    - tones: frequencies of lines that are not modes, as are their multiples [Hz]
    - edits: modes that the user adds

    Returns, in this order:
    - the estimate, whose functions are the spectral densities of the responses, (F, S, 1)
    - messages about findings other than modes

    Raises MeasurementError if the band is not below the Nyquist frequency, or the record is too short for it.
    """
    pieces = (
        [np.asarray(signals, float)] if isinstance(signals, np.ndarray) else [np.asarray(p) for p in signals]
    )
    pieces = usable_pieces(t_step, pieces, band)
    found_tones = find_tones(t_step, pieces, band, tones)
    without = without_tones(t_step, pieces, found_tones, band)
    only_tones = tones_alone(t_step, pieces, without, found_tones, band)
    found_tones = found_tones if only_tones is None else only_tones
    record = prepared(t_step, without)
    part_modes: list[PartMode] = []
    poles: list[list[Complex]] = [[np.zeros(0, complex)] for _ in ORDERS]
    requested: Wanted = {} if only_tones is None else dict.fromkeys(edits.add, NOTHING_ELSE)
    for part in parts(*band, 0.5 / t_step, record.seconds) if only_tones is None else ():
        modes_found, part_requested = modes_of_part(record, part, poles, edits)
        part_modes += modes_found
        requested = part_requested | requested
    kept = [
        part_mode
        for part_mode in beside_all(record, distinct_modes(part_modes))
        if not rest_of_tone(part_mode.mode, found_tones, record)
    ]
    narrow = lines_among(record.plain, [part_mode.mode for part_mode in kept], found_tones)
    kept = [part_mode for i, part_mode in enumerate(kept) if i not in narrow]
    longest = max(record.plain, key=lambda piece: len(piece.frequencies))
    swept = [part_mode for part_mode in kept if at_end_of_line(longest, t_step, part_mode.mode)]
    kept = [part_mode for part_mode in kept if part_mode not in swept]
    kept, requested = with_wanted(record, kept, requested, found_tones, edits)
    modes = tuple(
        _mode(record, part_mode) for part_mode in kept if band[0] <= part_mode.mode.undamped <= band[1]
    )
    listed = [requested.get(f, "it is outside the band") for f in edits.add]
    added = tuple(
        candidate if isinstance(candidate, str) else _mode(record, candidate) for candidate in listed
    )
    all_modes = (*modes, *(candidate for candidate in added if isinstance(candidate, Mode)))
    stabilisation = Stabilisation(
        np.array(ORDERS), tuple(np.concatenate(order_poles) for order_poles in poles)
    )
    unasked = [line for line in narrow.values() if nearest_frequency(edits.add, line.frequency) is None]
    found_tones = sorted((*found_tones, *unasked), key=lambda tone: tone.frequency)
    lines = tuple(tone.frequency for tone in found_tones if band[0] <= tone.frequency <= band[1])
    estimate = Estimate(modes, stabilisation, *_drawn(record, all_modes, band), added, lines)
    messages = _sentences(found_tones, all_modes, record.seconds)
    if swept:
        at = ", ".join(f"{part_mode.mode.undamped:.4g}" for part_mode in swept)
        messages = (
            *messages,
            f"at {at} Hz a line begins, ends, turns back or stands still, as in a sweep: no mode can be identified "
            "there",
        )
    return estimate, messages if only_tones is None else (*messages, NOTHING_ELSE)


def _mode(record: PreparedRecord, part_mode: PartMode) -> Mode:
    mode, pole = part_mode.mode, part_mode.mode.pole
    tried = []
    for k, of in enumerate(part_mode.orders):
        i = int(np.argmin(np.abs(part_mode.part.pole(of.values) - pole)))
        tried.append(
            (
                sigma(record.plain, part_mode.part, part_mode.references, FIRST, of, i, record.scales).shape,
                k,
                i,
            )
        )
    of_shape, k, i = min(tried)
    as_sure = [
        part_mode.orders[n].shapes[:, j] * record.scales for s, n, j in tried if s < AS_SURE * of_shape
    ]
    of_shape = math.hypot(of_shape, apart(part_mode.orders[k].shapes[:, i] * record.scales, as_sure))
    # |pole| by the damped frequency and the logarithm of the rate, and the damping ratio by these
    omega = abs(pole)
    by = np.array([2 * math.pi * pole.imag, pole.real**2]) / omega
    of_damping = np.array([0.0, mode.rate / omega]) - mode.rate / omega**2 * by
    frequency = ALLOWANCE * math.sqrt(max(float(by @ mode.covariance @ by), 0.0)) / (2 * math.pi)
    # the estimate of a rate is nearly log-normal: use its upper side, as a low estimate would also claim a low sigma
    relative = math.sqrt(max(float(of_damping @ mode.covariance @ of_damping), 0.0)) * omega / mode.rate
    damping = ALLOWANCE * mode.rate / omega * math.expm1(min(relative, MOST_RELATIVE))
    shape = np.where(record.scales > 0.0, part_mode.orders[k].shapes[:, i] * record.scales, np.nan)
    return Mode(pole, shape, frequency, damping, ALLOWANCE * of_shape, (part_mode.order_count, len(ORDERS)))


def apart(shape: Complex, other_shapes: Sequence[Complex]) -> float:
    """Return the distance of other shapes (S,) from one, rms of the real parts relative to its largest component."""
    largest = int(np.argmax(np.abs(shape)))
    unit = np.delete(shape / shape[largest], largest)
    differences = [
        (np.delete(other_shape / other_shape[largest], largest) - unit).real for other_shape in other_shapes
    ]
    return math.sqrt(float(np.mean(np.square(differences)))) if unit.size else 0.0


def _sentences(tones: Sequence[Tone], modes: Sequence[Mode], seconds: float) -> tuple[str, ...]:
    sentences = [tone.sentence for tone in tones]
    for mode in modes:
        for tone in tones:
            if abs(mode.frequency - tone.frequency) < max(2.0 * mode.damping * mode.frequency, 2.0 / seconds):
                sentences.append(
                    f"the mode at {mode.frequency:.4g} Hz is beside the tone at {tone.frequency:.4g} Hz"
                )
    doubtful = [f"{mode.frequency:.4g}" for mode in modes if mode.damping < 2.0 * mode.sigma_damping]
    if doubtful:
        modes_are = "the modes at {} Hz are" if len(doubtful) > 1 else "the mode at {} Hz is"
        why = "damping is within two standard deviations of 0; a longer record would tell"
        sentences.append(f"{modes_are.format(joined(doubtful))} doubtful: {why}")
    return tuple(sentences)


def distinct_modes(part_modes: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes by frequency; of a mode that two overlapping parts found, keep the more central one."""
    kept: list[PartMode] = []
    for candidate in sorted(part_modes, key=_eccentricity):
        f, rate = candidate.mode.frequency, candidate.mode.rate
        for kept_mode in kept:
            if kept_mode.part is candidate.part:
                continue
            apart = 2 * math.pi * abs(f - kept_mode.mode.frequency) / (rate + kept_mode.mode.rate)
            if apart < 0.5 or (apart < 2.0 and complex_mac(candidate.mode.shape, kept_mode.mode.shape) > 0.8):
                break
        else:
            if candidate.part.low <= f <= candidate.part.high or _eccentricity(candidate) < 1.3:
                kept.append(candidate)
    return sorted(kept, key=lambda part_mode: part_mode.mode.frequency)


def beside_all(record: PreparedRecord, part_modes: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes refitted beside those of all parts of the band."""
    again = list(part_modes)
    for part_mode in sorted(part_modes, key=lambda part_mode: part_mode.mode.gain):
        again.remove(part_mode)
        mode = refined(
            part_mode.mode,
            [neighbour.mode for neighbour in again],
            record.plain,
            (part_mode.part.start, part_mode.part.stop),
        )
        if mode is not None:
            again.append(replace(part_mode, mode=mode))
    return sorted(again, key=lambda part_mode: part_mode.mode.frequency)


def with_wanted(
    record: PreparedRecord,
    part_modes: Sequence[PartMode],
    requested: Wanted,
    tones: Sequence[Tone],
    edits: RequestedModes,
) -> tuple[list[PartMode], Wanted]:
    """Return the modes that requested ones do not replace, and the requested ones without remainders of tones."""
    kept, outcomes = list(part_modes), dict(requested)
    for frequency, candidate in requested.items():
        if isinstance(candidate, str):
            continue
        if rest_of_tone(candidate.mode, tones, record):
            outcomes[frequency] = "what is fitted there is the remainder of a tone"
            continue
        before = replaced([part_mode.mode.undamped for part_mode in kept], edits, candidate.mode.undamped)
        if before is not None:
            del kept[before]
    return kept, outcomes


def rest_of_tone(mode: Refined, tones: Sequence[Tone], record: PreparedRecord) -> bool:
    """Return whether a mode is as narrow as a line and at a tone: a remainder of its subtraction."""
    near = any(abs(mode.frequency - tone.frequency) * record.seconds < 3.0 for tone in tones)
    return near and mode.rate * record.seconds < REST


def _eccentricity(part_mode: PartMode) -> float:
    middle, half = (
        0.5 * (part_mode.part.low + part_mode.part.high),
        0.5 * (part_mode.part.high - part_mode.part.low),
    )
    return abs(part_mode.mode.frequency - middle) / half


def _drawn(
    record: PreparedRecord, modes: Sequence[Mode], band: tuple[float, float]
) -> tuple[Array, Complex, Complex]:
    """Return averaged spectral densities of the responses in the band, and the modes' share of them."""
    piece = max(record.plain, key=lambda piece: len(piece.frequencies))
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
