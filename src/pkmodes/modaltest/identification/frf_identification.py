"""Modes from frequency response functions.

Poles of many model orders (`lscf`), clusters of them (`clusters`), and a fit by maximum likelihood to the lines
around each group of clusters (`frf_refinement`), which decides what is a mode and gives its uncertainty.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.clusters import count_orders, pole_clusters, usable_poles
from pkmodes.modaltest.identification.estimates import Estimate, Mode, Stabilisation
from pkmodes.modaltest.identification.frf_added import add_requested_modes
from pkmodes.modaltest.identification.frf_covariance import (
    Uncertainty,
    common_sigma,
    component_sigmas,
    determined_components,
)
from pkmodes.modaltest.identification.frf_estimates import remove_window_damping
from pkmodes.modaltest.identification.frf_lines import FrequencyLines, select_lines, tone_mask
from pkmodes.modaltest.identification.frf_model_errors import add_model_error, drop_model_errors
from pkmodes.modaltest.identification.frf_refinement import energy_threshold, refine
from pkmodes.modaltest.identification.frf_search import append_poles, find_hidden_poles
from pkmodes.modaltest.identification.frf_skirts import (
    NARROW_HALF_WIDTH,
    ToneLine,
    distinct_tones,
    find_tone_lines,
)
from pkmodes.modaltest.identification.lscf import OrderPoles, lscf
from pkmodes.modaltest.identification.modes import IdentifiedModes
from pkmodes.modaltest.identification.requested_modes import NO_EDITS, RequestedModes, nearest_frequency
from pkmodes.modaltest.identification.residues import fit_residual_terms, lsfd

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Poles of the highest order, and number of orders up to it: about three times as many poles as a machine has modes
#: in a band, as residual terms, noise and the hammer's spectrum take poles too.
MAX_POLES, ORDER_COUNT = 60, 20
#: Maximum number of searches of the residual; each finds the modes not hidden by stronger ones.
MAX_SEARCHES = 4
#: Maximum number of passes that find and leave out tones; several are needed because a strong tone hides weaker ones.
MAX_TONE_PASSES = 4
#: Modes outside the band by up to this fraction of its width are fitted too, but not reported.
BAND_MARGIN = 0.04
#: Minimum half bandwidth of a mode, in line spacings; a narrower pole is a single frequency line, too narrow for the
#: lines to resolve.
MIN_HALF_WIDTH_LINES = 0.1
#: Minimum half bandwidth, in line spacings, of a mode near a tone; a tone has zero bandwidth.
MIN_HALF_WIDTH_LINES_AT_TONE = 0.3
#: Reason for not adding a requested mode whose fit shows that it is not a mode.
NOT_A_MODE = "its fit leaves the band, has no positive damping, or is a line without bandwidth"


def identify_frf(
    frequencies: Array,
    H: Complex,
    *,
    band: tuple[float, float],
    derivative_order: int,
    coherence: Array | None = None,
    averages: int | None = None,
    window_time_constant: float | None = None,
    tones: Sequence[float] = (),
    edits: RequestedModes = NO_EDITS,
) -> Estimate:
    """Identify the modes in a band.

    - frequencies: ascending, (F,) [Hz]
    - H: sensors may have different units, (F, S, R).  Columns that were not measured are NaN.
    - band: [Hz]
    - derivative_order: 0 for displacement, 1 for velocity, 2 for acceleration
    - coherence: (F, S, R)
    - averages: number of averages of the coherence: with it, the coherence gives the variance of the noise; without
      it, the coherence gives only the noise's relative size at each line
    - window_time_constant: time constant of an exponential window of the responses [s]
    - tones: spectral lines at these frequencies and their multiples are not modes [Hz]
    - edits: modes that the user adds or strikes out

    Raises MeasurementError if the band holds too few lines, or no function is complete.
    """
    in_range = (frequencies >= band[0]) & (frequencies <= band[1]) & (frequencies > 0.0)
    frequencies_in_band, H_in_band = frequencies[in_range], H[in_range]
    coherence_in_band = None if coherence is None else coherence[in_range]
    margin = BAND_MARGIN * (band[1] - band[0])
    low, high = band[0] - margin, band[1] + margin
    found_tones: list[ToneLine] = []
    for tone_pass in range(MAX_TONE_PASSES + 1):
        data, scale = select_lines(
            frequencies_in_band,
            H_in_band,
            coherence_in_band,
            averages,
            window_time_constant,
            tones,
            [tone.frequency for tone in found_tones],
        )
        poles_by_order = _find_poles_by_order(data)
        initial_modes = _candidates(poles_by_order, data, low, high)
        modes, uncertainty = _add_hidden_modes(
            data, *refine(data, initial_modes, low, high), low, high, derivative_order
        )
        if tone_pass == MAX_TONE_PASSES:
            break
        new_tones = [
            tone
            for tone in find_tone_lines(data, modes)
            if nearest_frequency(edits.add, tone.frequency) is None
        ]
        if not new_tones:
            break
        found_tones += new_tones
    modes, uncertainty, model_error, spurious = drop_model_errors(data, modes, uncertainty, low, high)

    def to_mode(modes: IdentifiedModes, uncertainty: Uncertainty, mode_index: int) -> Mode:
        found_in = count_orders(poles_by_order, modes.poles[mode_index]), len(poles_by_order)
        return _to_mode(
            modes,
            add_model_error(modes, uncertainty, model_error),
            mode_index,
            scale,
            window_time_constant,
            found_in,
        )

    with_requested = add_requested_modes(data, modes, uncertainty, edits)
    in_band = _mode_mask(with_requested.modes, data, band, window_time_constant, tones)
    requested_indices = [i for i in with_requested.added if isinstance(i, int)]
    found_indices = np.setdiff1d(np.flatnonzero(in_band), requested_indices)
    step = float(np.median(np.diff(frequencies_in_band)))
    # A drifting tone leaves narrow poles without a shape beside the lines that are left out.
    is_wide = with_requested.modes.half_widths[found_indices] > NARROW_HALF_WIDTH * step
    found_modes = [
        to_mode(with_requested.modes, with_requested.uncertainty, int(mode_index))
        for mode_index in found_indices
    ]
    reported_modes = [
        mode
        for mode, is_wide_mode in zip(found_modes, is_wide, strict=True)
        if is_wide_mode or np.isfinite(mode.shape).any()
    ]
    # Modes that the user strikes out are reported too: they are struck out later, from the modes of all files.
    struck_indices = np.flatnonzero(
        with_requested.struck_mask & _mode_mask(modes, data, band, window_time_constant, tones)
    )
    reported_modes += [to_mode(modes, uncertainty, int(mode_index)) for mode_index in struck_indices]
    added = tuple(
        i
        if isinstance(i, str)
        else to_mode(with_requested.modes, with_requested.uncertainty, i)
        if in_band[i]
        else NOT_A_MODE
        for i in with_requested.added
    )
    spurious_frequencies = tuple(
        frequency
        for frequency in spurious
        if band[0] <= frequency <= band[1] and nearest_frequency(edits.add, frequency) is None
    )
    return Estimate(
        modes=tuple(sorted(reported_modes, key=lambda mode: mode.frequency)),
        stabilisation=_stabilisation(poles_by_order, band),
        frequencies=frequencies_in_band,
        measured=H_in_band,
        synthesised=_response(data, with_requested.modes, derivative_order, frequencies_in_band)
        * scale[:, None],
        added=added,
        tones=distinct_tones(found_tones, step),
        model_error=model_error,
        spurious_frequencies=spurious_frequencies,
    )


def _find_poles_by_order(data: FrequencyLines) -> list[OrderPoles]:
    """Return the poles of each model order, from the sensors with all references.

    If no sensor has all, they are from every function as if of a single reference.
    """
    measured_mask = data.measured
    complete = np.logical_and.reduce(measured_mask, axis=1)
    if complete.any():
        values, variance = data.H[:, complete], data.variance[:, complete]
    else:
        values, variance = data.H[:, measured_mask][..., None], data.variance[:, measured_mask][..., None]
    R = values.shape[2]
    max_order = min(MAX_POLES // R, max(len(data.frequencies) // (3 * R), 2))
    orders = np.unique(np.round(np.linspace(max(2, max_order // 8), max_order, ORDER_COUNT)).astype(int))
    weights = 1.0 / np.sqrt(variance.mean(axis=2))
    return lscf(data.frequencies, values, weights / weights.max(), [int(n) for n in orders])


def _candidates(
    poles_by_order: list[OrderPoles], data: FrequencyLines, low: float, high: float
) -> IdentifiedModes:
    """Return the clusters as a starting point.

    Participations are 1 if a cluster has another number of them than there are references.
    """
    clusters = pole_clusters(poles_by_order, low, high)
    R, N = data.H.shape[2], len(clusters)
    poles = np.array([cluster.pole for cluster in clusters], complex)
    sizes_match = all(cluster.participation.size == R for cluster in clusters)
    participations = np.array(
        [cluster.participation if sizes_match else np.ones(R) for cluster in clusters], complex
    ).reshape(N, R)
    shape_fit = lsfd(data.frequencies, data.H, data.weights(), poles, participations, 0)
    return IdentifiedModes(poles, np.nan_to_num(shape_fit.shapes), participations)


def _add_hidden_modes(
    data: FrequencyLines,
    modes: IdentifiedModes,
    uncertainty: Uncertainty,
    low: float,
    high: float,
    derivative_order: int,
) -> tuple[IdentifiedModes, Uncertainty]:
    """Return the modes plus those that a search finds in the residual of their fit."""
    for _ in range(MAX_SEARCHES):
        fit = _response(data, modes, derivative_order, data.frequencies)
        poles = find_hidden_poles(data, fit, energy_threshold(data))
        if not len(poles):
            break
        with_hidden, new_uncertainty = refine(
            data, append_poles(modes, poles, data.frequencies, data.H - fit), low, high
        )
        if len(with_hidden.poles) <= len(modes.poles):
            break
        modes, uncertainty = with_hidden, new_uncertainty
    return modes, uncertainty


def _response(
    data: FrequencyLines, modes: IdentifiedModes, derivative_order: int, frequencies: Array
) -> Complex:
    """Return the response of the modes and residual terms at frequencies [Hz], in the units of `data`, (F, S, R)."""
    displacement = replace(modes, shapes=modes.shapes / modes.poles[:, None] ** derivative_order)
    with_residuals = fit_residual_terms(
        data.frequencies, data.H, data.weights(), displacement, derivative_order
    )
    return with_residuals.response(frequencies)


def _mode_mask(
    modes: IdentifiedModes,
    data: FrequencyLines,
    band: tuple[float, float],
    window_time_constant: float | None,
    tones: Sequence[float],
) -> NDArray[np.bool_]:
    poles = remove_window_damping(modes.poles, window_time_constant)
    frequency = np.abs(poles) / (2.0 * math.pi)
    at_tone = tone_mask(frequency, tones, 2.0 * data.step) & (
        modes.half_widths < MIN_HALF_WIDTH_LINES_AT_TONE * data.step
    )
    unresolved = modes.half_widths < MIN_HALF_WIDTH_LINES * data.step
    return np.asarray(
        (frequency >= band[0]) & (frequency <= band[1]) & (poles.real < 0.0) & ~at_tone & ~unresolved
    )


def _to_mode(
    modes: IdentifiedModes,
    uncertainty: Uncertainty,
    mode_index: int,
    scale: Array,
    window_time_constant: float | None,
    found_in: tuple[int, int],
) -> Mode:
    """Return one of the modes, in the units of the functions."""
    pole = complex(remove_window_damping(modes.poles[mode_index], window_time_constant))
    shape = modes.shapes[mode_index] * scale
    covariance = scale[:, None] * uncertainty.shapes[mode_index] * scale
    determined = determined_components(shape, covariance)
    sigmas = component_sigmas(shape[determined], covariance[np.ix_(determined, determined)])
    largest = int(np.argmax(np.where(determined, np.abs(shape), 0.0)))
    return Mode(
        pole=pole,
        shape=np.where(determined, shape, complex(np.nan, np.nan)),
        sigma_frequency=float(uncertainty.poles[mode_index, 1]) / (2.0 * math.pi),
        sigma_damping=float(uncertainty.poles[mode_index, 0]) / abs(pole),
        sigma_shape=common_sigma(sigmas) if determined.any() else math.nan,
        found_in=found_in,
        participation=modes.participation[mode_index],
        sigma_scale=math.sqrt(max(covariance[largest, largest].real, 0.0) / 2.0) / abs(shape[largest])
        if determined.any()
        else math.nan,
    )


def _stabilisation(poles_by_order: list[OrderPoles], band: tuple[float, float]) -> Stabilisation:
    orders = np.array([model.order for model in poles_by_order], np.int64)
    poles = tuple(model.poles[usable_poles(model.poles, *band)] for model in poles_by_order)
    return Stabilisation(orders, tuple(order_poles[np.argsort(order_poles.imag)] for order_poles in poles))
