"""Modes of frequency response functions that the user requests: fitted from a frequency, beside those found.

The fit is that of `frf_refinement`, started at the frequency with several dampings and at what stands out near it; of
those that stand out most, the nearest is taken.  Its energy must exceed what noise alone produces within the reach of
the fit: far fewer places than a search tries, so that modes can be added which the search leaves out.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.asked import (
    REACH,
    RequestedModes,
    nearest_frequency,
    struck,
    within_reach,
)
from pkmodes.modaltest.identification.clusters import HIGHEST_DAMPING
from pkmodes.modaltest.identification.frf_covariance import Uncertainty
from pkmodes.modaltest.identification.frf_lines import FrequencyLines
from pkmodes.modaltest.identification.frf_refinement import copies, group_fit, groups, settled, significant
from pkmodes.modaltest.identification.frf_search import hidden, with_poles
from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Damping ratios at which the fit starts.
RATIOS = (0.03, 0.01, 0.003)
#: Probability that noise alone produces a mode within the reach of the fit.
FALSE_ALARM = 0.05
#: Least energy relative to the strongest mode within the reach: weaker ones may be noise beside it.
STRONG = 0.5
#: Fits that end closer than this fraction of their half bandwidth are the same.
SAME = 0.1


@dataclass(frozen=True, eq=False)
class WithAdded:
    """Modes fitted together with those requested.

    - added: for each requested frequency, the index of its mode, or why there is none
    - struck: which of the original modes are struck out, and not among these, (N,)
    """

    modes: IdentifiedModes
    bounds: Uncertainty
    added: tuple[int | str, ...]
    struck: NDArray[np.bool_]


def with_added(
    data: FrequencyLines, modes: IdentifiedModes, bounds: Uncertainty, edits: RequestedModes
) -> WithAdded:
    """Return modes (N) with those that the user requests; each replaces a mode within 1 % of it."""
    if not edits.add:
        return WithAdded(modes, bounds, (), np.zeros(len(modes.poles), bool))
    out = struck(modes.frequencies, edits)
    now, owner = modes.only(~out), np.full(int((~out).sum()), -1)
    reasons: dict[int, str] = {}
    for i, target in enumerate(edits.add):
        outcome = _added(data, now, owner, target)
        if isinstance(outcome, str):
            reasons[i] = outcome
        else:
            now, kept = outcome
            owner = np.append(owner[kept], i)
    if (owner >= 0).any():
        now, bounds = settled(data, now)
    else:
        now, bounds, owner, out = modes, bounds, np.full(len(modes.poles), -1), np.zeros(len(out), bool)
    places = tuple(
        reasons[i] if i in reasons else int(np.flatnonzero(owner == i)[0]) for i in range(len(edits.add))
    )
    return WithAdded(now, bounds, places, out)


def _added(
    data: FrequencyLines, modes: IdentifiedModes, owner: NDArray[np.int64], target: float
) -> tuple[IdentifiedModes, NDArray[np.bool_]] | str:
    """Return modes with one more, the last, and which of the former remain; or why there is none."""
    reported = owner < 0
    replaced = nearest_frequency(np.where(reported, modes.frequencies, np.inf), target)
    kept = np.ones(len(modes.poles), bool)
    if replaced is not None:
        kept[replaced] = False
    base = modes.only(kept)
    ends: list[float] = []
    accepted: list[tuple[float, IdentifiedModes, NDArray[np.bool_]]] = []
    for trial in _trials(data, base, target):
        again, remaining = trial, kept.copy()
        for k in range(len(again.poles) - 1):
            if copies(again, k, len(again.poles) - 1):  # it has become a reported mode, and replaces it
                remaining[np.flatnonzero(kept)[k]] = False
        if not reported[~remaining].all():
            return "its fit converges to another mode that is added"
        if remaining.sum() < kept.sum():
            again = _with(data, modes.only(remaining), trial.poles[-1])
        final, bounds = settled(data, again)
        frequency = float(final.frequencies[-1])
        ends.append(frequency)
        strength = float(bounds.strength[-1])
        if (
            _possible(final.poles[-1])
            and within_reach(frequency, target)
            and strength > _threshold(data, target)
        ):
            accepted.append((strength, final, remaining))
    if not ends:
        return "no fit converges within 3 % of it"
    if not accepted:
        return f"what is fitted there, at {ends[0]:.4g} Hz, is no more than the noise"
    strongest = max(strength for strength, _, _ in accepted)
    return next(
        (final, remaining) for strength, final, remaining in accepted if strength >= STRONG * strongest
    )


def _trials(data: FrequencyLines, base: IdentifiedModes, target: float) -> Iterator[IdentifiedModes]:
    """Yield the modes with one fitted near a frequency, the nearest first."""
    trials: list[IdentifiedModes] = []
    for pole in _starts(data, base, target):
        trial = _with(data, base, pole)
        new = trial.poles[-1]
        inside = _possible(new) and within_reach(float(trial.frequencies[-1]), target)
        if inside and not any(abs(new - earlier.poles[-1]) < SAME * abs(new.real) for earlier in trials):
            trials.append(trial)
    yield from sorted(trials, key=lambda trial: abs(abs(trial.poles[-1]) - 2.0 * math.pi * target))


def _starts(data: FrequencyLines, base: IdentifiedModes, target: float) -> list[complex]:
    """Return starting poles of a fit: at the frequency, and where the residual stands out near it."""
    starts = [2.0 * math.pi * target * complex(-ratio, math.sqrt(1.0 - ratio**2)) for ratio in RATIOS]
    near = np.abs(data.frequencies / target - 1.0) <= 2.0 * REACH
    inside = slice(*np.flatnonzero(near)[[0, -1]]) if near.any() else slice(0, 0)
    if len(data.frequencies[inside]) < 3:
        return starts
    hidden_poles = hidden(data, base.response(data.frequencies), _threshold(data, target)).tolist()
    return starts + [pole for pole in hidden_poles if within_reach(abs(pole) / (2.0 * math.pi), target)]


def _with(data: FrequencyLines, base: IdentifiedModes, pole: complex) -> IdentifiedModes:
    """Return modes with one more, the last, fitted from a pole together with those that overlap it."""
    remainder = data.H - base.response(data.frequencies)  # each fit projects out the smooth part
    modes = with_poles(base, np.array([pole]), data.frequencies, remainder)
    last = len(modes.poles) - 1
    members = next(group for group in groups(modes.poles) if last in group)
    fit = group_fit(data, modes, members).fit
    poles, shapes, parts = modes.poles.copy(), modes.shapes.copy(), modes.participation.copy()
    poles[members], shapes[members], parts[members] = fit.poles, fit.shapes, fit.participation
    return IdentifiedModes(poles, shapes, parts)


def _threshold(data: FrequencyLines, target: float) -> float:
    """Return the energy over noise that noise alone exceeds with probability `FALSE_ALARM` near a frequency."""
    lines = int((np.abs(data.frequencies / target - 1.0) <= REACH).sum())
    return significant(data, FALSE_ALARM, max(lines, 1))


def _possible(pole: complex) -> bool:
    return bool(0.0 < -pole.real < HIGHEST_DAMPING * abs(pole))
