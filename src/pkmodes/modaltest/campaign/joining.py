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

from pkmodes.modaltest.campaign.averaging import Mean, grouped_means, mean_shape
from pkmodes.modaltest.campaign.found import Found
from pkmodes.modaltest.campaign.levels import widest

#: Number of standard deviations above which a difference between setups is real.
SURE = 2.0


def joined_setups(
    setups: Mapping[str, Sequence[Mean]], repeatability: float = 0.0
) -> tuple[list[Mean], list[str]]:
    """Return the modes of all setups of a record, and messages about those that differ or could not be joined.

    The mean over setups is weighted by their inverse variances.  If setups differ by more than these explain, their
    spread is used instead; and half their difference if it exceeds two of its standard deviations, which include the
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
        ranges = ", ".join(f"{low:.5g} to {high:.5g}" for low, high in moved)
        notes.append(
            f"the setups {', '.join(names)} differ by more than their standard deviations, as of a machine that "
            f"warms or settles, in the modes at {ranges} Hz: each is one row, with half the difference in sigma"
        )
    return means, notes


def _differing(members: Sequence[Mean], repeatability: float) -> tuple[float, float] | None:
    """Return the lowest and the highest frequency of a mode [Hz], None if their errors explain the difference."""
    ordered = sorted(members, key=lambda mean: mean.mode.frequency)
    ends = ordered[0], ordered[-1]
    low, high = (mean.mode.frequency for mean in ends)
    errors = [
        (np.nan_to_num(mean.scatter) ** 2 + repeatability**2) * mean.mode.frequency**2
        + mean.mode.sigma_frequency**2
        for mean in ends
    ]
    return (low, high) if high - low > SURE * np.sqrt(sum(errors)) else None


def _together(members: Sequence[Mean], differing: tuple[float, float] | None) -> tuple[Mean, bool]:
    """Return the joined mode of several setups, and whether some of their shapes share no sensor or reference."""
    if len(members) == 1:
        return members[0], False
    modes = [mean.mode for mean in members]
    frequency, sigma, scatter = _weighted(
        [mode.frequency for mode in modes],
        [mode.sigma_frequency for mode in modes],
        [mean.scatter * mean.mode.frequency for mean in members],
    )
    if differing is not None:
        low, high = differing
        frequency, scatter = 0.5 * (low + high), max(float(np.nan_to_num(scatter)), 0.5 * (high - low))
    damping, sigma_damping, damping_scatter = _weighted(
        [mode.damping for mode in modes],
        [mode.sigma_damping for mode in modes],
        [mean.damping_scatter * mean.mode.damping for mean in members],
    )
    shaped = [mode for mode in modes if mode.shape]
    whole, unlinked, sizes = _by_reference(shaped)
    linked = [mode.shape for mode in unlinked if mode.shape.keys() & whole.keys()]
    shape = mean_shape([whole, *linked])[0] if whole else {}
    sigmas = [mode.sigma_shape for mode in modes if np.isfinite(mode.sigma_shape)]
    sigma_shape = float(np.hypot(max(sigmas, default=np.nan), max(sizes, default=0.0)))
    largest = [mean.shape_scatter for mean in members if np.isfinite(mean.shape_scatter)]
    mode = replace(
        modes[0],
        frequency=frequency,
        damping=damping,
        shape=shape,
        sigma_frequency=sigma,
        sigma_damping=sigma_damping,
        sigma_shape=sigma_shape,
        found_in=min(
            (mode.found_in for mode in modes if mode.found_in),
            key=lambda counts: counts[0] / counts[1],
            default=None,
        ),
        resolution=min(mode.resolution for mode in modes),
        shift=widest([mode.shift for mode in modes]),
        participation={},
    )
    files = tuple(sorted(i for mean in members for i in mean.files))
    relative = damping_scatter / damping if damping > 0.0 else np.nan
    joint = Mean(
        mode,
        scatter / frequency,
        relative,
        max(largest, default=np.nan),
        files,
        between=widest([mean.between for mean in members]),
    )
    return joint, len(linked) < len(unlinked)


def _by_reference(modes: Sequence[Found]) -> tuple[dict[str, complex], list[Found], list[float]]:
    """Join the shape with most sensors to those that share a reference with it, but no sensor.

    Returns, in this order:
    - shape
    - unlinked: those that are not part of it
    - sigmas: relative standard deviations of the sizes of the parts; empty for a single part
    """
    if not modes:
        return {}, [], []
    base = max(modes, key=lambda mode: len(mode.shape))
    shape, unlinked, sigmas = dict(base.shape), list[Found](), list[float]()
    for mode in modes:
        if mode is base:
            continue
        common = [name for name in mode.participation if name in base.participation]
        of_member, of_base = (
            np.array([member.participation[name] for name in common]) for member in (mode, base)
        )
        size = float(np.vdot(of_base, of_base).real)
        if not size > 0.0 or mode.shape.keys() & shape.keys():
            unlinked.append(mode)
            continue
        factor = np.vdot(of_base, of_member) / size
        shape |= {name: complex(value * factor) for name, value in mode.shape.items()}
        sigmas += [float(member.sigma_size) for member in (mode, base) if np.isfinite(member.sigma_size)]
    return shape, unlinked, sigmas


def _weighted(
    values: Sequence[float], fits: Sequence[float], scatters: Sequence[float]
) -> tuple[float, float, float]:
    """Return the weighted mean of values, and its standard deviations by the fits and by the scatter of repeats."""
    x, fit, scatter = (np.array(numbers, dtype=float) for numbers in (values, fits, scatters))
    good = np.isfinite(x)
    if not good.any():
        return np.nan, 0.0, np.nan
    x, fit, scatter = x[good], fit[good], scatter[good]
    variance = np.nan_to_num(scatter) ** 2 + fit**2
    weights = 1.0 / variance if (variance > 0.0).all() else np.ones(len(x))
    weights = weights / weights.sum()
    mean = float(weights @ x)
    sigma_fit = float(np.sqrt(weights**2 @ fit**2))
    stated = float(np.sqrt(weights**2 @ np.nan_to_num(scatter) ** 2))
    spread = float(np.sqrt(weights @ (x - mean) ** 2 / max(len(x) - 1, 1))) if len(x) > 1 else 0.0
    resolved = np.isfinite(scatter).any() or spread > np.hypot(stated, sigma_fit)
    return mean, sigma_fit, max(stated, spread) if resolved else np.nan
