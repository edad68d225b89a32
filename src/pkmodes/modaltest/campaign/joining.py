"""Setups of a record: other excitations, hammer points or sensor places at one pose.

Frequencies and damping are common to all setups.  Shapes are joined by the sensors that they share, and those that
share none by their common references, as residues are accelerations per force: so a fixed sensor joins the points of
a roving hammer.

Where the frequencies of a mode differ by more than the standard deviations of both setups, the machine has warmed or
settled in between: it had both frequencies, whatever their weights.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.modaltest.campaign.averaging import group_by_mode, mean_shape
from pkmodes.modaltest.campaign.levels import largest_shift
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate

#: Number of standard deviations above which a difference between setups is real.
DIFFERENCE_SIGMAS = 2.0


def join_setups(
    setups: Mapping[str, Sequence[ModeEstimate]], pose: str, repeatability: float, log: list[str]
) -> list[ModeEstimate]:
    """Return the modes of all setups of a record; report those that differ or could not be joined.

    The mean over setups is weighted by their inverse variances.  If setups differ by more than these explain, their
    spread is used instead; and half their difference if it exceeds two of its standard deviations, which include the
    relative `repeatability`.
    """
    if len(setups) == 1:
        return list(next(iter(setups.values())))
    names = list(setups)
    joined, moved_ranges = list[ModeEstimate](), list[tuple[float, float]]()
    for group in group_by_mode(list(setups.values())):
        members = [group[i] for i in sorted(group)]
        ordered = sorted(members, key=lambda mode: mode.frequency)
        ends = ordered[0], ordered[-1]
        low, high = (mode.frequency for mode in ends)
        errors = [
            (np.nan_to_num(mode.scatter) ** 2 + repeatability**2) * mode.frequency**2
            + mode.sigma_frequency**2
            for mode in ends
        ]
        # None if their errors explain the difference.
        frequency_range = (low, high) if high - low > DIFFERENCE_SIGMAS * np.sqrt(sum(errors)) else None
        mode, unlinked = _join_mode(members, frequency_range)
        joined.append(mode)
        moved_ranges += [frequency_range] if frequency_range else []
        if unlinked:
            setup_names = ", ".join(names[i] for i in sorted(group))
            log.append(
                f"{pose}: the shapes of the mode at {mode.frequency:.4g} Hz share no sensor in the setups "
                f"{setup_names}, nor a reference with a name: only the one with most sensors is kept"
            )
    if moved_ranges:
        ranges = ", ".join(f"{low:.5g} to {high:.5g}" for low, high in moved_ranges)
        log.append(
            f"{pose}: the setups {', '.join(names)} differ by more than their standard deviations, as when a machine "
            f"warms up or settles, in the modes at {ranges} Hz: each is one row, with half the difference in sigma"
        )
    return joined


def _join_mode(
    members: Sequence[ModeEstimate], frequency_range: tuple[float, float] | None
) -> tuple[ModeEstimate, bool]:
    """Return the joined mode of several setups, and whether some of their shapes share no sensor or reference."""
    if len(members) == 1:
        return members[0], False
    frequency, sigma, scatter = _weighted_mean(
        [mode.frequency for mode in members],
        [mode.sigma_frequency for mode in members],
        [mode.scatter * mode.frequency for mode in members],
    )
    if frequency_range is not None:
        low, high = frequency_range
        frequency, scatter = 0.5 * (low + high), max(float(np.nan_to_num(scatter)), 0.5 * (high - low))
    damping, sigma_damping, damping_scatter = _weighted_mean(
        [mode.damping for mode in members],
        [mode.sigma_damping for mode in members],
        [mode.damping_scatter * mode.damping for mode in members],
    )
    joined_shape, unlinked, scale_sigmas = _join_by_reference([mode for mode in members if mode.shape])
    linked = [mode.shape for mode in unlinked if mode.shape.keys() & joined_shape.keys()]
    sigmas = [mode.sigma_shape for mode in members if np.isfinite(mode.sigma_shape)]
    joint = ModeEstimate(
        frequency,
        damping,
        mean_shape([joined_shape, *linked])[0] if joined_shape else {},
        sigma,
        sigma_damping,
        sigma_shape=float(np.hypot(max(sigmas, default=np.nan), max(scale_sigmas, default=0.0))),
        found_in=min(
            (mode.found_in for mode in members if mode.found_in),
            key=lambda counts: counts[0] / counts[1],
            default=None,
        ),
        resolution=min(mode.resolution for mode in members),
        shift=largest_shift([mode.shift for mode in members]),
        scatter=scatter / frequency,
        damping_scatter=damping_scatter / damping if damping > 0.0 else np.nan,
        shape_scatter=max(
            (mode.shape_scatter for mode in members if np.isfinite(mode.shape_scatter)), default=np.nan
        ),
        shift_between_files=largest_shift([mode.shift_between_files for mode in members]),
        files=tuple(sorted(i for mode in members for i in mode.files)),
        lengths=members[0].lengths,
    )
    return joint, len(linked) < len(unlinked)


def _join_by_reference(
    modes: Sequence[ModeEstimate],
) -> tuple[dict[str, complex], list[ModeEstimate], list[float]]:
    """Join the shape with most sensors to those that share a reference with it, but no sensor.

    Returns, in this order:
    - shape
    - unlinked: modes that are not part of it
    - sigmas: relative standard deviations of the sizes of the parts; empty for a single part
    """
    if not modes:
        return {}, [], []
    base = max(modes, key=lambda mode: len(mode.shape))
    shape, unlinked, sigmas = dict(base.shape), list[ModeEstimate](), list[float]()
    for mode in modes:
        if mode is base:
            continue
        common = [name for name in mode.participation if name in base.participation]
        member_participation, base_participation = (
            np.array([member.participation[name] for name in common]) for member in (mode, base)
        )
        size = float(np.vdot(base_participation, base_participation).real)
        if not size > 0.0 or mode.shape.keys() & shape.keys():
            unlinked.append(mode)
            continue
        factor = np.vdot(base_participation, member_participation) / size
        shape |= {name: complex(value * factor) for name, value in mode.shape.items()}
        sigmas += [float(member.sigma_scale) for member in (mode, base) if np.isfinite(member.sigma_scale)]
    return shape, unlinked, sigmas


def _weighted_mean(
    values: Sequence[float], fits: Sequence[float], scatters: Sequence[float]
) -> tuple[float, float, float]:
    """Return the weighted mean of values, and its standard deviations by the fits and by the scatter of repeats."""
    x, fit, scatter = (np.array(numbers, dtype=float) for numbers in (values, fits, scatters))
    finite = np.isfinite(x)
    if not finite.any():
        return np.nan, 0.0, np.nan
    x, fit, scatter = x[finite], fit[finite], scatter[finite]
    variance = np.nan_to_num(scatter) ** 2 + fit**2
    weights = 1.0 / variance if (variance > 0.0).all() else np.ones(len(x))
    weights = weights / weights.sum()
    mean = float(weights @ x)
    sigma_fit = float(np.sqrt(weights**2 @ fit**2))
    sigma_scatter = float(np.sqrt(weights**2 @ np.nan_to_num(scatter) ** 2))
    spread = float(np.sqrt(weights @ (x - mean) ** 2 / max(len(x) - 1, 1))) if len(x) > 1 else 0.0
    resolved = np.isfinite(scatter).any() or spread > np.hypot(sigma_scatter, sigma_fit)
    return mean, sigma_fit, max(sigma_scatter, spread) if resolved else np.nan
