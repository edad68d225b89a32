"""Setups of a record: other excitations, hammer points or sensor places at one pose.

Frequencies and damping are common to all setups.  Shapes are joined by the sensors that they share; those that share
none by the references they share, of which their residues are accelerations per force: so a sensor that stays joins
the points of a hammer that roves.

Where the frequencies of a mode differ by more than the standard deviations of both setups, the machine has warmed or
settled between: it had both, whatever their weights.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.campaign.averaging import Mean, grouped_means, mean_shape
from pkmodes.campaign.found import Found
from pkmodes.campaign.levels import widest

#: Standard deviations of a difference above which setups differ.
SURE = 2.0


def joined(setups: Mapping[str, Sequence[Mean]], repeatability: float = 0.0) -> tuple[list[Mean], list[str]]:
    """Return the modes of all setups of a record, and sentences on those that differ or could not be joined.

    The mean over setups is weighted by their variances.  Where setups differ by more than these tell, their spread
    counts instead; and half their difference where it is more than two of its standard deviations, which include the
    relative `repeatability`.
    """
    if len(setups) == 1:
        return list(next(iter(setups.values()))), []
    names, listed = list(setups), list(setups.values())
    means, notes, moved = [], list[str](), list[tuple[float, float]]()
    for group in grouped_means(listed):
        members = [group[i] for i in sorted(group)]
        ends = _differing(members, repeatability)
        mean, apart = _together(members, ends)
        moved += [ends] if ends else []
        if apart:
            which = ", ".join(names[i] for i in sorted(group))
            notes.append(
                f"the shapes of the mode at {mean.mode.frequency:.4g} Hz share no sensor in the setups {which}, nor "
                "a reference with a name: only the one with most sensors is kept"
            )
        means.append(mean)
    if moved:
        each = ", ".join(f"{low:.5g} to {high:.5g}" for low, high in moved)
        notes.append(
            f"the setups {', '.join(names)} differ by more than their standard deviations, as of a machine that "
            f"warms or settles, in the modes at {each} Hz: each is one row, with half the difference in sigma"
        )
    return means, notes


def _differing(members: Sequence[Mean], repeatability: float) -> tuple[float, float] | None:
    """Return the lowest and the highest frequency of a mode [Hz] if their errors do not explain the difference."""
    ordered = sorted(members, key=lambda one: one.mode.frequency)
    ends = ordered[0], ordered[-1]
    low, high = (one.mode.frequency for one in ends)
    errors = [
        (np.nan_to_num(one.scatter) ** 2 + repeatability**2) * one.mode.frequency**2
        + one.mode.sigma_frequency**2
        for one in ends
    ]
    return (low, high) if high - low > SURE * np.sqrt(sum(errors)) else None


def _together(members: Sequence[Mean], differing: tuple[float, float] | None) -> tuple[Mean, bool]:
    """Return one mode of several setups, and whether their shapes share no sensor or reference."""
    if len(members) == 1:
        return members[0], False
    modes = [one.mode for one in members]
    frequency, sigma, scatter = _weighted(
        [mode.frequency for mode in modes],
        [mode.sigma_frequency for mode in modes],
        [one.scatter * one.mode.frequency for one in members],
    )
    if differing is not None:
        low, high = differing
        frequency, scatter = 0.5 * (low + high), max(float(np.nan_to_num(scatter)), 0.5 * (high - low))
    damping, sigma_damping, damping_scatter = _weighted(
        [mode.damping for mode in modes],
        [mode.sigma_damping for mode in modes],
        [one.damping_scatter * one.mode.damping for one in members],
    )
    shaped = [mode for mode in modes if mode.shape]
    whole, others, sizes = _by_reference(shaped)
    linked = [mode.shape for mode in others if mode.shape.keys() & whole.keys()]
    shape = mean_shape([whole, *linked])[0] if whole else {}
    known = [mode.sigma_shape for mode in modes if np.isfinite(mode.sigma_shape)]
    sigma_shape = float(np.hypot(max(known, default=np.nan), max(sizes, default=0.0)))
    largest = [one.shape_scatter for one in members if np.isfinite(one.shape_scatter)]
    mode = replace(
        modes[0],
        frequency=frequency,
        damping=damping,
        shape=shape,
        sigma_frequency=sigma,
        sigma_damping=sigma_damping,
        sigma_shape=sigma_shape,
        found_in=min(
            (mode.found_in for mode in modes if mode.found_in), key=lambda one: one[0] / one[1], default=None
        ),
        resolution=min(mode.resolution for mode in modes),
        shift=widest([mode.shift for mode in modes]),
        participation={},
    )
    files = tuple(sorted(i for one in members for i in one.files))
    relative = damping_scatter / damping if damping > 0.0 else np.nan
    joint = Mean(
        mode,
        scatter / frequency,
        relative,
        max(largest, default=np.nan),
        files,
        between=widest([one.between for one in members]),
    )
    return joint, len(linked) < len(others)


def _by_reference(modes: Sequence[Found]) -> tuple[dict[str, complex], list[Found], list[float]]:
    """Join the largest shape of a mode with those that share a reference with it, but no sensor.

    Returns
    -------
    shape : dict of str to complex
    others : list of Found
        Those that are not part of it.
    sigmas : list of float
        Standard deviations of the sizes of the parts, relative; none for a single part.
    """
    if not modes:
        return {}, [], []
    base = max(modes, key=lambda mode: len(mode.shape))
    shape, others, sigmas = dict(base.shape), list[Found](), list[float]()
    for mode in modes:
        if mode is base:
            continue
        common = [name for name in mode.participation if name in base.participation]
        own, of_base = (np.array([one.participation[name] for name in common]) for one in (mode, base))
        size = float(np.vdot(of_base, of_base).real)
        if not size > 0.0 or mode.shape.keys() & shape.keys():
            others.append(mode)
            continue
        factor = np.vdot(of_base, own) / size
        shape |= {name: complex(value * factor) for name, value in mode.shape.items()}
        sigmas += [float(one.sigma_size) for one in (mode, base) if np.isfinite(one.sigma_size)]
    return shape, others, sigmas


def _weighted(
    values: Sequence[float], fits: Sequence[float], scatters: Sequence[float]
) -> tuple[float, float, float]:
    """Return the weighted mean of values, and its standard deviations by the fits and by the scatter of repeats."""
    x, fit, scatter = (np.array(each, dtype=float) for each in (values, fits, scatters))
    good = np.isfinite(x)
    if not good.any():
        return np.nan, 0.0, np.nan
    x, fit, scatter = x[good], fit[good], scatter[good]
    variance = np.nan_to_num(scatter) ** 2 + fit**2
    weights = 1.0 / variance if (variance > 0.0).all() else np.ones(len(x))
    weights = weights / weights.sum()
    mean = float(weights @ x)
    left = float(np.sqrt(weights**2 @ fit**2))
    stated = float(np.sqrt(weights**2 @ np.nan_to_num(scatter) ** 2))
    spread = float(np.sqrt(weights @ (x - mean) ** 2 / max(len(x) - 1, 1))) if len(x) > 1 else 0.0
    known = np.isfinite(scatter).any() or spread > np.hypot(stated, left)
    return mean, left, max(stated, spread) if known else np.nan
