"""Whether the modes of two measurements changed alike or each on its own, by more than their errors."""

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
LEVEL = 0.01
#: Significance level of the common change, and of all changes taken together, which are tested in addition.
ADDITIONAL_LEVEL = LEVEL / 2.0
#: Number of standard deviations from which a common change counts as one.
LEAST_COMMON = float(-ndtri(ADDITIONAL_LEVEL / 2.0))
#: Fewest pairs, and smallest share of all pairs, that can share a change which the others do not.
FEWEST, MOST_OF_ALL = 3, 0.75


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
    - clear: whether it is more than the errors, by Holm's procedure, (n,)
    """

    relative: Array
    sigmas: Array
    clear: NDArray[np.bool_]


def holm(p: Array, level: float = LEVEL) -> NDArray[np.bool_]:
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
    return float(-ndtri(LEVEL / (2.0 * max(count, 1))))


def two_sided(sigmas: Array) -> Array:
    """Return the p-values of deviations in standard deviations."""
    return np.asarray(2.0 * ndtr(-np.abs(sigmas)))


def common_and_own(factors: Array, errors: Array) -> tuple[CommonChange | None, OwnChanges]:
    """Tell a change that all modes share from changes of single modes.

    All modes of a machine change by one factor if its stiffness or mass changes everywhere, as by temperature or
    tension, or if a clock is wrong.  The factor is the weighted mean; where the residuals refuse it, that of the
    pairs which did not change, if these are half of all, or of three quarters or more that agree.

    - factors: logarithms of second over first, (n,)
    - errors: their standard deviations, (n,)

    Returns, in this order:
    - common: None of fewer than two pairs
    - own
    """
    count = len(factors)
    unknown = np.full(count, np.nan)
    if count < 2:
        return None, OwnChanges(unknown, unknown, np.zeros(count, dtype=bool))
    _, _, residual_chi2 = _mean(factors, errors)
    p = float(chdtrc(count - 1, residual_chi2))
    sharing = np.ones(count, dtype=bool) if p > LEVEL else _sharing(factors, errors)
    if not sharing.any():
        nothing = CommonChange(None, None, None, False, 0, residual_chi2, p)
        return nothing, OwnChanges(unknown, unknown, np.zeros(count, dtype=bool))
    mean, sigma, _ = _mean(factors[sharing], errors[sharing])
    beyond = _beyond(factors, errors, sharing)
    common = CommonChange(
        relative=float(np.expm1(mean)),
        sigma=float(np.exp(mean) * sigma),
        sigmas=float(mean / sigma),
        differs=bool(two_sided(np.array(mean / sigma)) <= ADDITIONAL_LEVEL),
        pairs=int(sharing.sum()),
        residual_chi2=residual_chi2,
        residual_p_value=p,
    )
    clear = holm(two_sided(beyond)) & (p <= LEVEL)
    return common, OwnChanges(np.expm1(factors - mean), beyond, clear)


def _mean(factors: Array, errors: Array) -> tuple[float, float, float]:
    """Return the weighted mean, its standard deviation, and the sum of squares of what is left."""
    weights = errors**-2
    mean = float(weights @ factors / weights.sum())
    return mean, float(weights.sum() ** -0.5), float((((factors - mean) / errors) ** 2).sum())


def _beyond(factors: Array, errors: Array, sharing: NDArray[np.bool_]) -> Array:
    """Return how far each pair is from the mean of those that share a change, in standard deviations."""
    mean, sigma, _ = _mean(factors[sharing], errors[sharing])
    # The mean has the errors of the pairs that it is of.
    variance = errors**2 + np.where(sharing, -(sigma**2), sigma**2)
    # A pair that outweighs all others is the mean itself: nothing is left of it but rounding.
    return np.asarray((factors - mean) / np.sqrt(np.maximum(variance, 1e-6 * errors**2)))


def _sharing(factors: Array, errors: Array) -> NDArray[np.bool_]:
    """Return the pairs that share a change although not all do, or none.

    Those that did not change are such pairs if they are half of all.  Otherwise nearly all must agree: a change at
    one place moves every mode by another factor, and of these some agree by chance.
    """
    count, none = len(factors), np.zeros(len(factors), dtype=bool)
    same = ~holm(two_sided(factors / errors))
    if 2 * same.sum() >= count:
        return same if same.sum() > 1 and _agree(factors[same], errors[same]) else none
    least = max(FEWEST, int(np.ceil(MOST_OF_ALL * count)))
    if least >= count:
        return none
    cores = []
    for center in factors:
        core = none.copy()
        core[np.argsort(np.abs(factors - center) / errors, kind="stable")[:least]] = True
        cores.append((_mean(factors[core], errors[core])[2], core))
    _, core = min(cores, key=lambda entry: entry[0])
    sharing = core | ~holm(two_sided(_beyond(factors, errors, core)))
    return sharing if _agree(factors[sharing], errors[sharing]) else none


def _agree(factors: Array, errors: Array) -> bool:
    """Return whether changes differ by no more than their errors."""
    return bool(chdtrc(len(factors) - 1, _mean(factors, errors)[2]) > LEVEL)
