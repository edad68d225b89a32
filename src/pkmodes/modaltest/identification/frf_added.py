"""Modes of frequency response functions that the user requests: fitted from a frequency, beside those found.

The fit is that of `frf_refinement`, started at the frequency with several damping ratios and at the peaks of the
residual near it; of the strongest results, the nearest is taken.  Its energy must exceed what noise alone produces
within the reach of the fit.  These are far fewer lines than a search covers, so that modes can be added which the
search leaves out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.clusters import HIGHEST_DAMPING
from pkmodes.modaltest.identification.frf_covariance import Uncertainty
from pkmodes.modaltest.identification.frf_lines import FrequencyLines
from pkmodes.modaltest.identification.frf_refinement import (
    are_copies,
    energy_threshold,
    fit_group,
    fit_until_settled,
    group_overlapping,
)
from pkmodes.modaltest.identification.frf_search import append_poles, find_hidden_poles
from pkmodes.modaltest.identification.modes import IdentifiedModes
from pkmodes.modaltest.identification.requested_modes import (
    MAX_SHIFT,
    RequestedModes,
    near_request,
    nearest_frequency,
    struck_mask,
)

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Damping ratios at which the fit starts.
STARTING_DAMPINGS = (0.03, 0.01, 0.003)
#: Probability that noise alone produces a mode within the reach of the fit.
FALSE_ALARM = 0.05
#: Minimum energy relative to the strongest mode within the reach: weaker ones may be noise beside it.
MIN_RELATIVE_ENERGY = 0.5
#: Fits that end closer than this fraction of their half bandwidth are the same.
SAME_FIT_DISTANCE = 0.1


@dataclass(frozen=True, eq=False)
class ModesWithRequested:
    """Modes fitted together with those requested.

    - added: for each requested frequency, the index of its mode, or why there is none
    - struck_mask: which of the original modes are struck out, and not among these, (N,)
    """

    modes: IdentifiedModes
    uncertainty: Uncertainty
    added: tuple[int | str, ...]
    struck_mask: NDArray[np.bool_]


def add_requested_modes(
    data: FrequencyLines, modes: IdentifiedModes, uncertainty: Uncertainty, edits: RequestedModes
) -> ModesWithRequested:
    """Return modes (N) with those that the user requests; each replaces a mode within 1 % of it."""
    if not edits.add:
        return ModesWithRequested(modes, uncertainty, (), np.zeros(len(modes.poles), bool))
    struck = struck_mask(modes.frequencies, edits)
    current, request_index = modes.select(~struck), np.full(int((~struck).sum()), -1)
    reasons: dict[int, str] = {}
    for i, target in enumerate(edits.add):
        outcome = _add_requested_mode(data, current, request_index, target)
        if isinstance(outcome, str):
            reasons[i] = outcome
        else:
            current, kept_mask = outcome
            request_index = np.append(request_index[kept_mask], i)
    if (request_index >= 0).any():
        current, uncertainty = fit_until_settled(data, current)
    else:
        current, uncertainty, request_index, struck = (
            modes,
            uncertainty,
            np.full(len(modes.poles), -1),
            np.zeros(len(struck), bool),
        )
    mode_indices = tuple(
        reasons[i] if i in reasons else int(np.flatnonzero(request_index == i)[0])
        for i in range(len(edits.add))
    )
    return ModesWithRequested(current, uncertainty, mode_indices, struck)


def _add_requested_mode(
    data: FrequencyLines, modes: IdentifiedModes, request_index: NDArray[np.int64], target: float
) -> tuple[IdentifiedModes, NDArray[np.bool_]] | str:
    """Return modes with one more, the last, and which of the former remain; or why there is none."""
    reported = request_index < 0
    replaced_index = nearest_frequency(np.where(reported, modes.frequencies, np.inf), target)
    kept_mask = np.ones(len(modes.poles), bool)
    if replaced_index is not None:
        kept_mask[replaced_index] = False
    base = modes.select(kept_mask)
    fitted_frequencies: list[float] = []
    accepted: list[tuple[float, IdentifiedModes, NDArray[np.bool_]]] = []
    for trial in _trial_fits(data, base, target):
        candidate, remaining = trial, kept_mask.copy()
        for k in range(len(candidate.poles) - 1):
            # A fit that has become a copy of a reported mode replaces it.
            if are_copies(candidate, k, len(candidate.poles) - 1):
                remaining[np.flatnonzero(kept_mask)[k]] = False
        if not reported[~remaining].all():
            return "its fit converges to another mode that is added"
        if remaining.sum() < kept_mask.sum():
            candidate = _add_fitted_mode(data, modes.select(remaining), trial.poles[-1])
        fitted, uncertainty = fit_until_settled(data, candidate)
        frequency = float(fitted.frequencies[-1])
        fitted_frequencies.append(frequency)
        strength = float(uncertainty.strength[-1])
        if (
            _is_plausible(fitted.poles[-1])
            and near_request(frequency, target)
            and strength > _threshold(data, target)
        ):
            accepted.append((strength, fitted, remaining))
    if not fitted_frequencies:
        return "no fit converges within 3 % of it"
    if not accepted:
        return f"what is fitted there, at {fitted_frequencies[0]:.4g} Hz, is no more than the noise"
    strongest = max(strength for strength, _, _ in accepted)
    return next(
        (fitted, remaining)
        for strength, fitted, remaining in accepted
        if strength >= MIN_RELATIVE_ENERGY * strongest
    )


def _trial_fits(data: FrequencyLines, base: IdentifiedModes, target: float) -> Iterator[IdentifiedModes]:
    """Yield the modes with one fitted near a frequency, the nearest first.

    Fits start at the frequency, and where the residual stands out near it.
    """
    starts = [
        2.0 * math.pi * target * complex(-ratio, math.sqrt(1.0 - ratio**2)) for ratio in STARTING_DAMPINGS
    ]
    is_near = np.abs(data.frequencies / target - 1.0) <= 2.0 * MAX_SHIFT
    line_range = slice(*np.flatnonzero(is_near)[[0, -1]]) if is_near.any() else slice(0, 0)
    if len(data.frequencies[line_range]) >= 3:
        hidden_poles = find_hidden_poles(data, base.response(data.frequencies), _threshold(data, target))
        starts += [
            pole for pole in hidden_poles.tolist() if near_request(abs(pole) / (2.0 * math.pi), target)
        ]
    trials: list[IdentifiedModes] = []
    for pole in starts:
        trial = _add_fitted_mode(data, base, pole)
        new = trial.poles[-1]
        valid = _is_plausible(new) and near_request(float(trial.frequencies[-1]), target)
        if valid and not any(
            abs(new - earlier.poles[-1]) < SAME_FIT_DISTANCE * abs(new.real) for earlier in trials
        ):
            trials.append(trial)
    yield from sorted(trials, key=lambda trial: abs(abs(trial.poles[-1]) - 2.0 * math.pi * target))


def _add_fitted_mode(data: FrequencyLines, base: IdentifiedModes, pole: complex) -> IdentifiedModes:
    """Return modes with one more, the last, fitted from a pole together with those that overlap it."""
    remainder = data.H - base.response(data.frequencies)  # each fit projects out the smooth part
    modes = append_poles(base, np.array([pole]), data.frequencies, remainder)
    last = len(modes.poles) - 1
    members = next(group for group in group_overlapping(modes.poles) if last in group)
    fit = fit_group(data, modes, members).fit
    poles, shapes, participations = modes.poles.copy(), modes.shapes.copy(), modes.participation.copy()
    poles[members], shapes[members], participations[members] = fit.poles, fit.shapes, fit.participation
    return IdentifiedModes(poles, shapes, participations)


def _threshold(data: FrequencyLines, target: float) -> float:
    """Return the energy over noise that noise alone exceeds with probability `FALSE_ALARM` near a frequency."""
    lines = int((np.abs(data.frequencies / target - 1.0) <= MAX_SHIFT).sum())
    return energy_threshold(data, FALSE_ALARM, max(lines, 1))


def _is_plausible(pole: complex) -> bool:
    return bool(0.0 < -pole.real < HIGHEST_DAMPING * abs(pole))
