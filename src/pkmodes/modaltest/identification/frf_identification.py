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
#: Most searches of the residual; each finds all modes that no stronger one hides.
MAX_SEARCHES = 4
#: Most passes in which tones are found and left out: a strong one hides others.
MAX_TONE_PASSES = 4
#: Modes outside the band by up to this fraction of its width are fitted too, but not reported.
MARGIN = 0.04
#: Least half bandwidth, in line spacings, of a resonance near a tone; a tone has none.
MIN_HALF_WIDTH_AT_TONE = 0.3
#: Reason for not adding a requested mode whose fit shows that it is not a mode.
NOT_A_MODE = "its fit leaves the band, has no positive damping, or is a line without bandwidth"
#: Half bandwidth, in line spacings, below which a pole is a single line and no resonance that the lines resolve.
MIN_HALF_WIDTH = 0.1


def identify_frf(
    frequencies: Array,
    H: Complex,
    *,
    band: tuple[float, float],
    power: int,
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
    - power: 0 for displacement, 1 for velocity, 2 for acceleration
    - coherence: (F, S, R)
    - averages: number of averages of the coherence: with it, the coherence gives the variance of the noise; otherwise
      only its course over the lines
    - window_time_constant: time constant of an exponential window of the responses [s]
    - tones: lines at these frequencies and their multiples are not modes [Hz]
    - edits: modes that the user adds

    Raises MeasurementError if the band holds too few lines, or no function is complete.
    """
    in_range = (frequencies >= band[0]) & (frequencies <= band[1]) & (frequencies > 0.0)
    f, measured = frequencies[in_range], H[in_range]
    coherence_in_band = None if coherence is None else coherence[in_range]
    margin = MARGIN * (band[1] - band[0])
    low, high = band[0] - margin, band[1] + margin
    lines: list[ToneLine] = []
    for last_pass in (False,) * MAX_TONE_PASSES + (True,):
        data, scale = select_lines(
            f,
            measured,
            coherence_in_band,
            averages,
            window_time_constant,
            tones,
            [line.frequency for line in lines],
        )
        by_order = _poles_by_order(data)
        start = _candidates(by_order, data, low, high)
        modes, bounds = _add_hidden_modes(data, *refine(data, start, low, high), low, high, power)
        new_tones = [
            line
            for line in ([] if last_pass else find_tone_lines(data, modes))
            if nearest_frequency(edits.add, line.frequency) is None
        ]
        if not new_tones:
            break
        lines += new_tones
    modes, bounds, error, spurious = drop_model_errors(data, modes, bounds, low, high)

    def to_mode(modes: IdentifiedModes, bounds: Uncertainty, m: int) -> Mode:
        found_in = count_orders(by_order, modes.poles[m]), len(by_order)
        return _to_mode(
            modes, add_model_error(modes, bounds, error), m, scale, window_time_constant, found_in
        )

    extended = add_requested_modes(data, modes, bounds, edits)
    in_band = _mode_mask(extended.modes, data, band, window_time_constant, tones)
    added_indices = [i for i in extended.added if isinstance(i, int)]
    reported = np.setdiff1d(np.flatnonzero(in_band), added_indices)
    struck_modes = np.flatnonzero(
        extended.struck_mask & _mode_mask(modes, data, band, window_time_constant, tones)
    )
    step = float(np.median(np.diff(f)))
    reported_modes = [to_mode(extended.modes, extended.bounds, int(m)) for m in reported]
    is_wide = extended.modes.half_widths[reported] > NARROW_HALF_WIDTH * step
    # A drifting tone leaves narrow poles without a shape beside the lines that are left out.
    reported_modes = [
        candidate
        for candidate, resolved in zip(reported_modes, is_wide, strict=True)
        if resolved or np.isfinite(candidate.shape).any()
    ]
    reported_modes += [to_mode(modes, bounds, int(m)) for m in struck_modes]
    return Estimate(
        modes=tuple(sorted(reported_modes, key=lambda candidate: candidate.frequency)),
        stabilisation=_stabilisation(by_order, band),
        frequencies=f,
        measured=measured,
        synthesised=_response(data, extended.modes, power, f) * scale[:, None],
        added=tuple(
            i
            if isinstance(i, str)
            else to_mode(extended.modes, extended.bounds, i)
            if in_band[i]
            else NOT_A_MODE
            for i in extended.added
        ),
        tones=distinct_tones(lines, step),
        model_error=error,
        spurious_frequencies=tuple(
            frequency
            for frequency in spurious
            if band[0] <= frequency <= band[1] and nearest_frequency(edits.add, frequency) is None
        ),
    )


def _poles_by_order(data: FrequencyLines) -> list[OrderPoles]:
    """Return poles from all complete sensors; if there are none, from all functions as of a single reference."""
    measured = data.measured
    complete = np.logical_and.reduce(measured, axis=1)
    if complete.any():
        values, variance = data.H[:, complete], data.variance[:, complete]
    else:
        values, variance = data.H[:, measured][..., None], data.variance[:, measured][..., None]
    R = values.shape[2]
    max_order = min(MAX_POLES // R, max(len(data.frequencies) // (3 * R), 2))
    orders = np.unique(np.round(np.linspace(max(2, max_order // 8), max_order, ORDER_COUNT)).astype(int))
    weights = 1.0 / np.sqrt(variance.mean(axis=2))
    return lscf(data.frequencies, values, weights / weights.max(), [int(n) for n in orders])


def _candidates(by_order: list[OrderPoles], data: FrequencyLines, low: float, high: float) -> IdentifiedModes:
    """Return the clusters as a starting point, with participations of 1 if theirs do not match the references."""
    clusters = pole_clusters(by_order, low, high)
    R, N = data.H.shape[2], len(clusters)
    poles = np.array([cluster.pole for cluster in clusters], complex)
    sizes_match = all(cluster.participation.size == R for cluster in clusters)
    participations = np.array(
        [cluster.participation if sizes_match else np.ones(R) for cluster in clusters], complex
    ).reshape(N, R)
    first_fit = lsfd(data.frequencies, data.H, data.weights(), poles, participations, 0)
    return IdentifiedModes(poles, np.nan_to_num(first_fit.shapes), participations)


def _add_hidden_modes(
    data: FrequencyLines, modes: IdentifiedModes, bounds: Uncertainty, low: float, high: float, power: int
) -> tuple[IdentifiedModes, Uncertainty]:
    """Return the modes with those that a search finds in their residual."""
    for _ in range(MAX_SEARCHES):
        fit = _response(data, modes, power, data.frequencies)
        poles = find_hidden_poles(data, fit, energy_threshold(data))
        if not len(poles):
            break
        extended, more_bounds = refine(
            data, append_poles(modes, poles, data.frequencies, data.H - fit), low, high
        )
        if len(extended.poles) <= len(modes.poles):
            break
        modes, bounds = extended, more_bounds
    return modes, bounds


def _response(data: FrequencyLines, modes: IdentifiedModes, power: int, frequencies: Array) -> Complex:
    """Return the modes with residual terms, in the units of `data`, (F, S, R), at frequencies [Hz]."""
    displacement = replace(modes, shapes=modes.shapes / modes.poles[:, None] ** power)
    with_residuals = fit_residual_terms(data.frequencies, data.H, data.weights(), displacement, power)
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
        modes.half_widths < MIN_HALF_WIDTH_AT_TONE * data.step
    )
    unresolved = modes.half_widths < MIN_HALF_WIDTH * data.step
    return np.asarray(
        (frequency >= band[0]) & (frequency <= band[1]) & (poles.real < 0.0) & ~at_tone & ~unresolved
    )


def _to_mode(
    modes: IdentifiedModes,
    bounds: Uncertainty,
    m: int,
    scale: Array,
    window_time_constant: float | None,
    found_in: tuple[int, int],
) -> Mode:
    """Return one of the modes, in the units of the functions."""
    pole = complex(remove_window_damping(modes.poles[m], window_time_constant))
    shape, covariance = modes.shapes[m] * scale, scale[:, None] * bounds.shapes[m] * scale
    resolved = determined_components(shape, covariance)
    sigmas = component_sigmas(shape[resolved], covariance[np.ix_(resolved, resolved)])
    largest = int(np.argmax(np.where(resolved, np.abs(shape), 0.0)))
    return Mode(
        pole=pole,
        shape=np.where(resolved, shape, complex(np.nan, np.nan)),
        sigma_frequency=float(bounds.poles[m, 1]) / (2.0 * math.pi),
        sigma_damping=float(bounds.poles[m, 0]) / abs(pole),
        sigma_shape=common_sigma(sigmas) if resolved.any() else math.nan,
        found_in=found_in,
        participation=modes.participation[m],
        sigma_scale=math.sqrt(max(covariance[largest, largest].real, 0.0) / 2.0) / abs(shape[largest])
        if resolved.any()
        else math.nan,
    )


def _stabilisation(by_order: list[OrderPoles], band: tuple[float, float]) -> Stabilisation:
    orders = np.array([model.order for model in by_order], np.int64)
    poles = tuple(model.poles[usable_poles(model.poles, *band)] for model in by_order)
    return Stabilisation(orders, tuple(order_poles[np.argsort(order_poles.imag)] for order_poles in poles))
