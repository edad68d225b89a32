"""Modes of responses alone: ambient records, decays and sweeps.

The band is treated in overlapping parts (`ssi_bands`).  In each, covariance-driven subspace identification (`ssi`)
gives poles and shapes of all model orders, clusters of these give candidates (`clusters`), and the power on the lines
around each decides whether it is a mode (`ssi_selection`) and what its frequency and damping are (`ssi_likelihood`).
The shape and its standard deviation are those of the subspace identification (`ssi_uncertainty`).  A mode that two
overlapping parts find is kept once, and each is fitted again together with the modes of all parts.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.ordering import joined
from pkmodes.modaltest.identification.estimates import Estimate, Mode, Stabilisation, complex_mac
from pkmodes.modaltest.identification.requested_modes import (
    NO_EDITS,
    RequestedModes,
    index_to_replace,
    nearest_frequency,
)
from pkmodes.modaltest.identification.ssi_bands import (
    PreparedRecord,
    prepare_record,
    split_band,
    usable_pieces,
)
from pkmodes.modaltest.identification.ssi_lines import find_line_modes
from pkmodes.modaltest.identification.ssi_parts import (
    FIRST_LAG,
    ORDERS,
    PartMode,
    RequestOutcomes,
    modes_of_part,
)
from pkmodes.modaltest.identification.ssi_selection import RefinedMode, refine
from pkmodes.modaltest.identification.ssi_uncertainty import mode_sigmas
from pkmodes.modaltest.identification.sweeps import is_at_line_end
from pkmodes.modaltest.identification.tones import Tone, find_only_tones, find_tones, subtract_tones

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Factor on standard deviations for what the peak fit and the choice of an order ignore: calibrated on simulated
#: records of 40 s, in which 2 sigma without it cover 90 to 93 %.
ALLOWANCE = 1.15
#: Shapes of model orders with sigmas below this multiple of the least one are compared too: their differences, such
#: as how much of a strong neighbour's shape is in that of a weak mode, show in no single order.
SIMILAR_SIGMA_RATIO = 2.0
#: Message about a record that holds only tones.
ONLY_TONES = "besides tones the record holds only the rounding of its numbers, in which no mode can be found"
#: Standard deviations of the logarithm of a rate are capped here.
MAX_LOG_RATE_SIGMA = 3.0
#: Averaged lines that are drawn.
MAX_DRAWN_LINES = 400
#: Decay rate times record length below which a mode at a tone is a remainder of its subtraction.
MAX_REMAINDER_DECAYS = 12.0


def identify_responses(
    t_step: float,
    signals: Array | Sequence[Array],
    *,
    band: tuple[float, float],
    tones: Sequence[float] = (),
    edits: RequestedModes = NO_EDITS,
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
    cleaned = subtract_tones(t_step, pieces, found_tones, band)
    only_tones = find_only_tones(t_step, pieces, cleaned, found_tones, band)
    found_tones = found_tones if only_tones is None else only_tones
    record = prepare_record(t_step, cleaned)
    part_modes: list[PartMode] = []
    poles: list[list[Complex]] = [[np.zeros(0, complex)] for _ in ORDERS]
    requested: RequestOutcomes = {} if only_tones is None else dict.fromkeys(edits.add, ONLY_TONES)
    for part in split_band(*band, 0.5 / t_step, record.seconds) if only_tones is None else ():
        modes_found, part_requested = modes_of_part(record, part, poles, edits)
        part_modes += modes_found
        requested = part_requested | requested
    accepted = [
        part_mode
        for part_mode in refit_beside_neighbours(record, distinct_modes(part_modes))
        if not is_tone_remainder(part_mode.mode, found_tones, record)
    ]
    line_modes = find_line_modes(record.unpadded, [part_mode.mode for part_mode in accepted], found_tones)
    accepted = [part_mode for i, part_mode in enumerate(accepted) if i not in line_modes]
    longest_piece = max(record.unpadded, key=lambda piece: len(piece.frequencies))
    sweep_ends = [
        part_mode for part_mode in accepted if is_at_line_end(longest_piece, t_step, part_mode.mode)
    ]
    accepted = [part_mode for part_mode in accepted if part_mode not in sweep_ends]
    accepted, requested = apply_requests(record, accepted, requested, found_tones, edits)
    modes = tuple(
        _to_mode(record, part_mode) for part_mode in accepted if band[0] <= part_mode.mode.undamped <= band[1]
    )
    outcomes = [requested.get(f, "it is outside the band") for f in edits.add]
    added = tuple(
        candidate if isinstance(candidate, str) else _to_mode(record, candidate) for candidate in outcomes
    )
    all_modes = (*modes, *(candidate for candidate in added if isinstance(candidate, Mode)))
    stabilisation = Stabilisation(
        np.array(ORDERS), tuple(np.concatenate(order_poles) for order_poles in poles)
    )
    unrequested = [
        line for line in line_modes.values() if nearest_frequency(edits.add, line.frequency) is None
    ]
    found_tones = sorted((*found_tones, *unrequested), key=lambda tone: tone.frequency)
    lines = tuple(tone.frequency for tone in found_tones if band[0] <= tone.frequency <= band[1])
    estimate = Estimate(modes, stabilisation, *_averaged_spectra(record, all_modes, band), added, lines)
    messages = _tone_messages(found_tones, all_modes, record.seconds)
    if sweep_ends:
        listed_frequencies = ", ".join(f"{part_mode.mode.undamped:.4g}" for part_mode in sweep_ends)
        messages = (
            *messages,
            f"at {listed_frequencies} Hz a line begins, ends, turns back or stands still, as in a sweep: no mode can "
            "be identified there",
        )
    return estimate, messages if only_tones is None else (*messages, ONLY_TONES)


def _to_mode(record: PreparedRecord, part_mode: PartMode) -> Mode:
    mode, pole = part_mode.mode, part_mode.mode.pole
    trials = []
    for k, order_modes in enumerate(part_mode.orders):
        i = int(np.argmin(np.abs(part_mode.part.pole(order_modes.values) - pole)))
        trials.append(
            (
                mode_sigmas(
                    record.unpadded,
                    part_mode.part,
                    part_mode.references,
                    FIRST_LAG,
                    order_modes,
                    i,
                    record.scales,
                ).shape,
                k,
                i,
            )
        )
    sigma_shape, k, i = min(trials)
    similar_shapes = [
        part_mode.orders[n].shapes[:, j] * record.scales
        for s, n, j in trials
        if s < SIMILAR_SIGMA_RATIO * sigma_shape
    ]
    sigma_shape = math.hypot(
        sigma_shape, shape_distance(part_mode.orders[k].shapes[:, i] * record.scales, similar_shapes)
    )
    # |pole| by the damped frequency and the logarithm of the rate, and the damping ratio by these
    omega = abs(pole)
    frequency_gradient = np.array([2 * math.pi * pole.imag, pole.real**2]) / omega
    damping_gradient = np.array([0.0, mode.rate / omega]) - mode.rate / omega**2 * frequency_gradient
    frequency = (
        ALLOWANCE
        * math.sqrt(max(float(frequency_gradient @ mode.covariance @ frequency_gradient), 0.0))
        / (2 * math.pi)
    )
    # the estimate of a rate is nearly log-normal: use its upper side, as a low estimate would also claim a low sigma
    relative_sigma = (
        math.sqrt(max(float(damping_gradient @ mode.covariance @ damping_gradient), 0.0)) * omega / mode.rate
    )
    damping = ALLOWANCE * mode.rate / omega * math.expm1(min(relative_sigma, MAX_LOG_RATE_SIGMA))
    shape = np.where(record.scales > 0.0, part_mode.orders[k].shapes[:, i] * record.scales, np.nan)
    return Mode(
        pole, shape, frequency, damping, ALLOWANCE * sigma_shape, (part_mode.order_count, len(ORDERS))
    )


def shape_distance(shape: Complex, other_shapes: Sequence[Complex]) -> float:
    """Return the distance of other shapes (S,) from one, rms of the real parts relative to its largest component."""
    largest = int(np.argmax(np.abs(shape)))
    unit = np.delete(shape / shape[largest], largest)
    differences = [
        (np.delete(other_shape / other_shape[largest], largest) - unit).real for other_shape in other_shapes
    ]
    return math.sqrt(float(np.mean(np.square(differences)))) if unit.size else 0.0


def _tone_messages(tones: Sequence[Tone], modes: Sequence[Mode], seconds: float) -> tuple[str, ...]:
    messages = [tone.message for tone in tones]
    for mode in modes:
        for tone in tones:
            if abs(mode.frequency - tone.frequency) < max(2.0 * mode.damping * mode.frequency, 2.0 / seconds):
                messages.append(
                    f"the mode at {mode.frequency:.4g} Hz is beside the tone at {tone.frequency:.4g} Hz"
                )
    doubtful = [f"{mode.frequency:.4g}" for mode in modes if mode.damping < 2.0 * mode.sigma_damping]
    if doubtful:
        modes_are = "the modes at {} Hz are" if len(doubtful) > 1 else "the mode at {} Hz is"
        reason = "damping is within two standard deviations of 0; a longer record would tell"
        messages.append(f"{modes_are.format(joined(doubtful))} doubtful: {reason}")
    return tuple(messages)


def distinct_modes(part_modes: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes by frequency; of a mode that two overlapping parts found, keep the more central one."""
    kept: list[PartMode] = []
    for candidate in sorted(part_modes, key=_eccentricity):
        f, rate = candidate.mode.frequency, candidate.mode.rate
        for kept_mode in kept:
            if kept_mode.part is candidate.part:
                continue
            distance = 2 * math.pi * abs(f - kept_mode.mode.frequency) / (rate + kept_mode.mode.rate)
            if distance < 0.5 or (
                distance < 2.0 and complex_mac(candidate.mode.shape, kept_mode.mode.shape) > 0.8
            ):
                break
        else:
            if candidate.part.low <= f <= candidate.part.high or _eccentricity(candidate) < 1.3:
                kept.append(candidate)
    return sorted(kept, key=lambda part_mode: part_mode.mode.frequency)


def refit_beside_neighbours(record: PreparedRecord, part_modes: Sequence[PartMode]) -> list[PartMode]:
    """Return the modes refitted beside those of all parts of the band."""
    refitted = list(part_modes)
    for part_mode in sorted(part_modes, key=lambda part_mode: part_mode.mode.log_likelihood_ratio):
        refitted.remove(part_mode)
        mode = refine(
            part_mode.mode,
            [neighbour.mode for neighbour in refitted],
            record.unpadded,
            (part_mode.part.start, part_mode.part.stop),
        )
        if mode is not None:
            refitted.append(replace(part_mode, mode=mode))
    return sorted(refitted, key=lambda part_mode: part_mode.mode.frequency)


def apply_requests(
    record: PreparedRecord,
    part_modes: Sequence[PartMode],
    requested: RequestOutcomes,
    tones: Sequence[Tone],
    edits: RequestedModes,
) -> tuple[list[PartMode], RequestOutcomes]:
    """Return the modes that requested ones do not replace, and the requested ones without remainders of tones."""
    accepted, outcomes = list(part_modes), dict(requested)
    for frequency, candidate in requested.items():
        if isinstance(candidate, str):
            continue
        if is_tone_remainder(candidate.mode, tones, record):
            outcomes[frequency] = "what is fitted there is the remainder of a tone"
            continue
        replaced_index = index_to_replace(
            [part_mode.mode.undamped for part_mode in accepted], edits, candidate.mode.undamped
        )
        if replaced_index is not None:
            del accepted[replaced_index]
    return accepted, outcomes


def is_tone_remainder(mode: RefinedMode, tones: Sequence[Tone], record: PreparedRecord) -> bool:
    """Return whether a mode is as narrow as a line and at a tone: a remainder of its subtraction."""
    at_tone = any(abs(mode.frequency - tone.frequency) * record.seconds < 3.0 for tone in tones)
    return at_tone and mode.rate * record.seconds < MAX_REMAINDER_DECAYS


def _eccentricity(part_mode: PartMode) -> float:
    middle, half = (
        0.5 * (part_mode.part.low + part_mode.part.high),
        0.5 * (part_mode.part.high - part_mode.part.low),
    )
    return abs(part_mode.mode.frequency - middle) / half


def _averaged_spectra(
    record: PreparedRecord, modes: Sequence[Mode], band: tuple[float, float]
) -> tuple[Array, Complex, Complex]:
    """Return averaged spectral densities of the responses in the band, and the modes' share of them."""
    piece = max(record.unpadded, key=lambda piece: len(piece.frequencies))
    line_range = slice(*np.searchsorted(piece.frequencies, band))
    f, power = (
        piece.frequencies[line_range],
        np.abs(piece.values[line_range]) ** 2 * record.scales**2 * piece.step,
    )
    group = max(len(f) // MAX_DRAWN_LINES, 1)
    rows = len(f) // group * group
    f = f[:rows].reshape(-1, group).mean(axis=1)
    power = power[:rows].reshape(len(f), group, -1).mean(axis=1)
    peaks = np.array([1.0 / np.abs(2j * math.pi * f - mode.pole) ** 2 for mode in modes]).reshape(
        len(modes), len(f)
    )
    nearest_lines = [int(np.argmin(np.abs(f - mode.frequency))) for mode in modes]
    heights = np.array([power[k] / peaks[j, k] for j, k in enumerate(nearest_lines)])
    heights = heights.reshape(len(modes), power.shape[1])
    return f, power[:, :, None].astype(complex), (peaks.T @ heights)[:, :, None].astype(complex)
