"""The mean of a mode over repeats, and its standard deviation.

A few repeats do not determine their own scatter.  So the scatter of all modes of a record is pooled, and that of each
mode is shrunk towards it: the posterior variance of Smyth, Stat. Appl. Genet. Mol. Biol. 3 (2004), with a prior worth
`PRIOR_DOF` degrees of freedom.  Frequencies scatter because the machine changes; their relative scatter is about the
same for all modes.  The damping ratio and the shape of a mode scatter mostly by noise, which affects weak modes
more: in proportion to its identification uncertainty.
Student's t turns the result into an effective standard deviation such that +-2 sigma covers 95 % of errors.  The
uncertainty of the identification itself is added: repeats at one place do not show it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray
from scipy.stats import t as student

from pkmodes.modaltest.campaign.grouping import match_visits
from pkmodes.modaltest.campaign.levels import PRIOR_DOF, largest_shift, shifts_between_files
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate

Complex = NDArray[np.complex128]
#: Share of errors that +-2 standard deviations cover.
COVERAGE = 0.95


def mean_modes(groups: Sequence[Mapping[int, ModeEstimate]]) -> list[ModeEstimate]:
    """Return the means of the modes of one record, in order; their `sigma_*` come from the identification alone."""
    repeats = [list(group.values()) for group in groups]
    logs = [np.log([mode.frequency for mode in modes]) for modes in repeats]
    damping_logs = [np.log([mode.damping for mode in modes if mode.damping > 0.0]) for modes in repeats]
    damping_sigmas = [
        [mode.sigma_damping / mode.damping if mode.damping > 0.0 else np.nan for mode in modes]
        for modes in repeats
    ]
    frequency_scatters, damping_scatters = (
        _moderated_scatters(
            [float(np.var(values, ddof=1)) if len(values) > 1 else np.nan for values in logarithms],
            [len(values) for values in logarithms],
            sigmas,
        )
        for logarithms, sigmas in ((logs, None), (damping_logs, _rms_sigmas(damping_sigmas)))
    )
    shapes = [mean_shape([mode.shape for mode in modes]) for modes in repeats]
    shape_scatters = _moderated_scatters(
        [_component_variance(residuals) for _, residuals in shapes],
        [len(modes) for modes in repeats],
        _rms_sigmas([[mode.sigma_shape for mode in modes] for modes in repeats]),
    )
    file_shifts = shifts_between_files(groups)
    return [
        replace(
            _mean_mode(repeats[i], shapes[i][0]),
            scatter=frequency_scatters[i][0],
            damping_scatter=damping_scatters[i][0],
            shape_scatter=shape_scatters[i][0],
            variance=frequency_scatters[i][1],
            shift_between_files=file_shifts[i],
            files=tuple(sorted(group)),
        )
        for i, group in enumerate(groups)
    ]


def group_by_mode(setups: Sequence[Sequence[ModeEstimate]]) -> list[dict[int, ModeEstimate]]:
    """Group the estimates of the same mode; each group maps the index of a setup to its estimate."""
    return [{i: setups[i][k] for i, k in group.items()} for group in match_visits(setups)]


def _mean_mode(modes: Sequence[ModeEstimate], shape: dict[str, complex]) -> ModeEstimate:
    """Return the mean of a mode over its repeats, with the uncertainty from their identification."""
    n = np.sqrt(len(modes))

    def pooled(values: Sequence[float]) -> float:
        return float(np.sqrt(np.mean(np.square(values))) / n)

    damping_ratios = [mode.damping for mode in modes if np.isfinite(mode.damping)]
    order_counts = [mode.found_in for mode in modes if mode.found_in is not None]
    participation, scale_sigma = _mean_participations(modes, shape)
    fit_sigma = pooled([mode.sigma_scale for mode in modes])
    return ModeEstimate(
        float(np.mean([mode.frequency for mode in modes])),
        float(np.mean(damping_ratios)) if damping_ratios else np.nan,
        shape,
        pooled([mode.sigma_frequency for mode in modes]),
        pooled([mode.sigma_damping for mode in modes]),
        pooled([mode.sigma_shape for mode in modes]),
        min(order_counts, key=lambda counts: counts[0] / counts[1])
        if len(order_counts) == len(modes)
        else None,
        resolution=max(mode.resolution for mode in modes),
        shift=largest_shift([mode.shift for mode in modes]),
        participation=participation,
        sigma_scale=max((sigma for sigma in (fit_sigma, scale_sigma) if np.isfinite(sigma)), default=np.nan),
        lengths=modes[0].lengths,
    )


def _mean_participations(
    modes: Sequence[ModeEstimate], shape: Mapping[str, complex]
) -> tuple[dict[str, complex], float]:
    """Return the mean participations that match the mean shape, and the relative standard deviation of the scale."""
    participations: dict[str, list[complex]] = {}
    for mode in modes:
        common = [name for name in mode.shape if name in shape]
        repeat, mean = (np.array([components[name] for name in common]) for components in (mode.shape, shape))
        squared_norm = float(np.vdot(mean, mean).real)
        scale = complex(np.vdot(mean, repeat) / squared_norm) if squared_norm > 0.0 else complex(np.nan)
        for name, value in mode.participation.items():
            participations.setdefault(name, []).append(scale * value)
    means = {name: complex(np.mean(values)) for name, values in participations.items()}
    largest = max(means, key=lambda name: abs(means[name]), default="")
    if len(participations.get(largest, ())) < 2:
        return means, np.nan
    values = np.array(participations[largest])
    return means, float(np.std(values, ddof=1) / np.sqrt(len(values)) / abs(means[largest]))


def _rms_sigmas(sigmas: Sequence[Sequence[float]]) -> list[float] | None:
    """Return the identification's uncertainty of each mode, rms over files; None unless it is known for all."""
    positive = [[sigma for sigma in mode_sigmas if sigma > 0.0] for mode_sigmas in sigmas]
    if not all(positive):
        return None
    return [float(np.sqrt(np.mean(np.square(mode_sigmas)))) for mode_sigmas in positive]


def _moderated_scatters(
    variances: Sequence[float], counts: Sequence[int], scales: Sequence[float] | None = None
) -> list[tuple[float, float]]:
    """Return relative standard deviations and variances of means over n repeats; NaN for single ones.

    Scatters are pooled relative to `scales`, which are all 1 by default.
    """
    if scales is not None:
        relative = [v / scale**2 for v, scale in zip(variances, scales, strict=True)]
        relative_scatters = _moderated_scatters(relative, counts)
        return [(s * scale, v * scale**2) for (s, v), scale in zip(relative_scatters, scales, strict=True)]
    repeated = [(v, n - 1) for v, n in zip(variances, counts, strict=True) if n > 1 and np.isfinite(v)]
    if not repeated:
        return [(np.nan, np.nan)] * len(counts)
    total_dof = sum(n for _, n in repeated)
    pooled = sum(v * n for v, n in repeated) / total_dof
    # The prior cannot have more degrees of freedom than the pooled data.
    largest_prior_dof = min(PRIOR_DOF, total_dof)
    scatters = []
    for v, n in zip(variances, counts, strict=True):
        if n < 2 or not np.isfinite(v):
            scatters.append((np.nan, np.nan))
            continue
        own_dof = n - 1
        # The mode is part of the pool: if it is the only one, its variance is its own.
        prior_dof = largest_prior_dof if total_dof > own_dof else 0.0
        variance = (prior_dof * pooled + own_dof * v) / (prior_dof + own_dof)
        quantile = student.ppf(0.5 + 0.5 * COVERAGE, prior_dof + own_dof) / 2.0
        scatters.append((float(quantile * np.sqrt(variance / n)), variance / n))
    return scatters


def mean_shape(shapes: Sequence[Mapping[str, complex]]) -> tuple[dict[str, complex], Complex]:
    """Return the mean of arbitrarily scaled shapes, relative to its largest component, and the residual of each.

    Each shape is scaled to fit the mean; the mean is their strongest singular vector.  A component missing from some
    shapes is averaged over the others; one that shares no shape with the rest is left out.
    """
    names = list(dict.fromkeys(name for shape in shapes for name in shape))
    if not names:
        return {}, np.empty((0, 0), dtype=complex)
    table = np.array([[shape.get(name, np.nan) for name in names] for shape in shapes], dtype=complex)
    complete_rows = [row for row in table if np.isfinite(row).all()]
    start = (
        complete_rows[0]
        if complete_rows
        else np.nan_to_num(table[int(np.argmax(np.isfinite(table).sum(axis=1)))])
    )
    mean = start / np.abs(start).max()
    for _ in range(20):
        scaled = np.array([row * _fit_scale(row, mean) for row in table])
        count = np.isfinite(scaled).sum(axis=0)
        previous, mean = mean, np.where(count > 0, np.nansum(scaled, axis=0) / np.maximum(count, 1), np.nan)
        mean = mean / mean[np.nanargmax(np.abs(mean))]
        if np.array_equal(mean, previous, equal_nan=True):  # at once for a single shape
            break
    finite = np.isfinite(mean)
    shape = {name: complex(mean[i]) for i, name in enumerate(names) if finite[i]}
    return shape, (scaled - mean)[:, finite]


def _fit_scale(row: Complex, mean: Complex) -> complex:
    """Return the factor that makes a shape most like the mean, NaN if they have no component in common."""
    common = np.isfinite(row) & np.isfinite(mean)
    squared_norm = float(np.vdot(row[common], row[common]).real)
    if squared_norm <= 0.0:
        return complex(np.nan)
    return complex(np.vdot(row[common], mean[common]) / squared_norm)


def _component_variance(residuals: Complex) -> float:
    """Return the variance of the real part of a component over repeats; each scale uses up a degree of freedom."""
    if len(residuals) < 2 or residuals.shape[1] < 2:
        return np.nan
    return float(np.nansum(residuals.real**2) / ((len(residuals) - 1) * (residuals.shape[1] - 1)))
