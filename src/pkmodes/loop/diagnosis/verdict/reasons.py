"""Clauses that several reasons of verdicts share."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray
from scipy import stats

from pkmodes.core.base.numbers import format_factor, format_signed, plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Candidate

#: A residual varies with the pose if the p-value of an analysis of variance is below this.
MAX_P_UNEVEN = 1e-3


def names(causes: Sequence[Candidate]) -> str:
    """Return the names of causes."""
    return " and ".join(cause.name for cause in causes)


def causes_in_words(causes: Sequence[Candidate]) -> str:
    """Return causes in words, each with its name in brackets."""
    return " and ".join(
        f"{cause.sentence} ({cause.name})" if cause.sentence else cause.name for cause in causes
    )


def explains(causes: Sequence[Candidate]) -> str:
    """Return the beginning of a clause: the causes would explain, or the declared model explains."""
    return f"{names(causes)} would explain" if causes else "the declared model explains"


def errors_in_words(fit: Fit, lines: NDArray[np.int_]) -> str:
    """Return the measurement errors of a fit, in words."""
    parts, excluded_lines = [], [str(lines[row]) for row in sorted(fit.hypothesis.excluded_rows)]
    if len(excluded_lines) == 1:
        parts.append(f"line {excluded_lines[0]} set aside as an outlier")
    elif excluded_lines:
        parts.append(f"lines {', '.join(excluded_lines)} set aside as outliers")
    if fit.hypothesis.has_shared_error:
        parts.append(f"an error of {plain(100 * fit.shared_error, 2)} % that the modes of a pose share")
    return " and ".join(parts)


def ratio_in_words(ratio: float) -> str:
    """Return how large errors are relative to the stated ones: "170 times as large as", "12 % larger than"."""
    percent = round(100.0 * (ratio - 1.0))
    if percent == 0:
        return "as large as"
    if abs(percent) < 50:
        return f"{abs(percent)} % {'larger' if percent > 0 else 'smaller'} than"
    return f"{format_factor(ratio)} as large as"


def without_mode(count: int) -> str:
    """Return for how many measured modes a model has none left, as the object of a clause."""
    return f"no mode left for {count} measured mode{'' if count == 1 else 's'}"


def variation_with_pose(fitter: Fitter, fit: Fit) -> str:
    """Return how the frequency residual varies with the setup; empty if it does not."""
    residual = fit.residual[fitter.observations.frequency_slice]
    rows = [r for r in fitter.observations.noise.rows if len(r) >= 2]
    if len(rows) < 3:
        return ""
    means = np.array([residual[r].mean() for r in rows])
    squares_between = sum(
        len(r) * (m - residual[np.concatenate(rows)].mean()) ** 2 for r, m in zip(rows, means, strict=True)
    )
    squares_within = sum(float(((residual[r] - m) ** 2).sum()) for r, m in zip(rows, means, strict=True))
    count = sum(map(len, rows))
    ratio = (squares_between / (len(rows) - 1)) / max(squares_within / (count - len(rows)), 1e-300)
    if stats.f.sf(ratio, len(rows) - 1, count - len(rows)) > MAX_P_UNEVEN:
        return ""
    labels = [fitter.data.labels[fitter.data.pose[r[0]]] for r in rows]
    highest_setup, lowest_setup = int(means.argmax()), int(means.argmin())
    return (
        f"the residual varies with the pose, from {format_signed(100 * means[highest_setup])} % at "
        f"{labels[highest_setup]} to {format_signed(100 * means[lowest_setup])} % at {labels[lowest_setup]}"
    )
