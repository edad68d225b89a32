"""Whether the modes of two measurements changed by a common factor or individually, by more than their errors."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import numpy as np
from msgspec import Meta
from numpy.typing import NDArray
from scipy.special import chdtrc, ndtr, ndtri

from pkmodes.core.support.documents import Count, Document, Probability, Size

Array = NDArray[np.float64]
#: Significance level of a change, over all pairs together, and over all places of all shapes together.
SIGNIFICANCE_LEVEL = 0.01
#: Significance level of the common change, and of all changes taken together, which are tested in addition.
ADDITIONAL_LEVEL = SIGNIFICANCE_LEVEL / 2.0
#: Number of standard deviations from which a common change is significant.
MIN_COMMON_SIGMAS = float(-ndtri(ADDITIONAL_LEVEL / 2.0))
#: Smallest number of pairs, and smallest fraction of all pairs, that can share a change that the others lack.
MIN_SHARING_PAIRS, MIN_SHARING_FRACTION = 3, 0.75


class CommonChange(Document, frozen=True):
    """What all modes have in common, and whether that is all."""

    relative: Annotated[
        float | None,
        Meta(description="Change that the modes share: weighted mean; null if not most modes agree."),
    ]
    sigma: Annotated[Size | None, Meta(description="Its standard deviation.")]
    sigmas: Annotated[float | None, Meta(description="The change in standard deviations.")]
    differs: Annotated[bool, Meta(description="Whether it is one, at the level of 0.5 %.")]
    pairs: Annotated[Count, Meta(description="Pairs that share it, of which it is the mean.")]
    residual_chi2: Annotated[
        Size, Meta(description="Sum of squares of what is left of all changes after their weighted mean.")
    ]
    residual_p_value: Annotated[
        Probability, Meta(description="Of residual_chi2 if all modes changed by one factor.")
    ]


@dataclass(frozen=True)
class OwnChanges:
    """Changes of modes beyond the common one, for n pairs.

    - relative, sigmas: (n,); NaN without a common change
    - is_clear: whether it is more than the errors, by Holm's procedure, (n,)
    """

    relative: Array
    sigmas: Array
    is_clear: NDArray[np.bool_]


def holm(p: Array, level: float = SIGNIFICANCE_LEVEL) -> NDArray[np.bool_]:
    """Return which of several hypotheses are refused at a level together (Holm, Scand. J. Statist. 6, 1979).

    - p: their p-values, (n,)
    - level: largest probability that any true one is refused
    """
    order = np.argsort(p)
    passed = p[order] <= level / np.arange(len(p), 0, -1)
    refused = np.zeros(len(p), dtype=bool)
    refused[order] = np.logical_and.accumulate(passed)
    return refused


def holm_threshold(count: int) -> float:
    """Return the number of standard deviations that `holm` requires of the largest of several deviations."""
    return float(-ndtri(SIGNIFICANCE_LEVEL / (2.0 * max(count, 1))))


def two_sided(sigmas: Array) -> Array:
    """Return the p-values of deviations in standard deviations."""
    return np.asarray(2.0 * ndtr(-np.abs(sigmas)))


def common_and_own(log_ratios: Array, errors: Array) -> tuple[CommonChange | None, OwnChanges]:
    """Separate a change that all modes share from changes of single modes.

    All modes of a machine change by one factor if its stiffness or mass changes everywhere, as by temperature or
    tension, or if a clock is wrong.  The factor is the weighted mean; where the residuals refuse it, that of the
    pairs which did not change, if these are half of all, or of three quarters or more that agree.

    - log_ratios: logarithms of second over first, (n,)
    - errors: standard deviations of these logarithms, (n,)

    Returns, in this order:
    - common: the common change; None for fewer than two pairs
    - own: changes of single modes
    """
    count = len(log_ratios)
    not_known = np.full(count, np.nan)
    if count < 2:
        return None, OwnChanges(not_known, not_known, np.zeros(count, dtype=bool))
    _, _, residual_chi2 = _weighted_mean(log_ratios, errors)
    p = float(chdtrc(count - 1, residual_chi2))
    sharing = np.ones(count, dtype=bool) if p > SIGNIFICANCE_LEVEL else _sharing_pairs(log_ratios, errors)
    if not sharing.any():
        no_common_change = CommonChange(None, None, None, False, 0, residual_chi2, p)
        return no_common_change, OwnChanges(not_known, not_known, np.zeros(count, dtype=bool))
    mean, sigma, _ = _weighted_mean(log_ratios[sharing], errors[sharing])
    deviations = _deviations_from_shared(log_ratios, errors, sharing)
    common = CommonChange(
        relative=float(np.expm1(mean)),
        sigma=float(np.exp(mean) * sigma),
        sigmas=float(mean / sigma),
        differs=bool(two_sided(np.array(mean / sigma)) <= ADDITIONAL_LEVEL),
        pairs=int(sharing.sum()),
        residual_chi2=residual_chi2,
        residual_p_value=p,
    )
    is_clear = holm(two_sided(deviations)) & (p <= SIGNIFICANCE_LEVEL)
    return common, OwnChanges(np.expm1(log_ratios - mean), deviations, is_clear)


def _weighted_mean(log_ratios: Array, errors: Array) -> tuple[float, float, float]:
    """Return the weighted mean, its standard deviation, and the sum of squares of the residuals."""
    weights = errors**-2
    mean = float(weights @ log_ratios / weights.sum())
    return mean, float(weights.sum() ** -0.5), float((((log_ratios - mean) / errors) ** 2).sum())


def _deviations_from_shared(log_ratios: Array, errors: Array, sharing: NDArray[np.bool_]) -> Array:
    """Return how far each pair is from the mean of those that share a change, in standard deviations."""
    mean, sigma, _ = _weighted_mean(log_ratios[sharing], errors[sharing])
    # A pair that belongs to the mean is correlated with it.
    variance = errors**2 + np.where(sharing, -(sigma**2), sigma**2)
    # A pair that outweighs all others is the mean itself: its residual is rounding.
    return np.asarray((log_ratios - mean) / np.sqrt(np.maximum(variance, 1e-6 * errors**2)))


def _sharing_pairs(log_ratios: Array, errors: Array) -> NDArray[np.bool_]:
    """Return the pairs that share a change although not all do; none if there are no such pairs.

    The unchanged pairs are such pairs if they are half of all.  Otherwise nearly all must agree: a change at
    one place moves every mode by another factor, and of these some agree by chance.
    """
    count, no_pairs = len(log_ratios), np.zeros(len(log_ratios), dtype=bool)
    unchanged = ~holm(two_sided(log_ratios / errors))
    if 2 * unchanged.sum() >= count:
        return (
            unchanged
            if unchanged.sum() > 1 and _agree(log_ratios[unchanged], errors[unchanged])
            else no_pairs
        )
    core_size = max(MIN_SHARING_PAIRS, int(np.ceil(MIN_SHARING_FRACTION * count)))
    if core_size >= count:
        return no_pairs
    cores = []
    for center in log_ratios:
        core = no_pairs.copy()
        core[np.argsort(np.abs(log_ratios - center) / errors, kind="stable")[:core_size]] = True
        cores.append((_weighted_mean(log_ratios[core], errors[core])[2], core))
    _, core = min(cores, key=lambda entry: entry[0])
    sharing = core | ~holm(two_sided(_deviations_from_shared(log_ratios, errors, core)))
    return sharing if _agree(log_ratios[sharing], errors[sharing]) else no_pairs


def _agree(log_ratios: Array, errors: Array) -> bool:
    """Return whether changes differ by no more than their errors."""
    return bool(chdtrc(len(log_ratios) - 1, _weighted_mean(log_ratios, errors)[2]) > SIGNIFICANCE_LEVEL)
