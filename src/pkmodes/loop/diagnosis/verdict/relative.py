"""Values of a group of parameters relative to their mean, where the data determine only these.

The factors of several belts are such a group where the stiffness that they share is uncertain: each may have any
value, but only together with the others.  Their covariance C has one large eigenvalue, whose eigenvector v is the
direction in which they move together.  The values moved along it until their mean is 0,

    d = P a,    P = 1 - v 1^T / (1^T v),    covariance P C P^T,

do not depend on that common motion.  If v is a multiple of 1 + a, as for factors of one stiffness, then d is
(1 + a) / mean(1 + a) - 1; if all entries of v are equal, it is a - mean(a).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Smallest factor by which the standard deviation of each value must fall: otherwise the values themselves suffice.
MIN_REDUCTION = 3.0


def relative_to_mean(
    values: Sequence[float], covariance: Sequence[Sequence[float]]
) -> tuple[Array, Array] | None:
    """Return values relative to their mean, with standard deviations.

    - values: n values in one unit
    - covariance: n by n

    Returns relative and sigma, (n,); None where they are not far better determined than the values themselves.
    """
    a, C = np.array(values, dtype=float), np.array(covariance, dtype=float)
    if len(a) < 2 or C.shape != (len(a), len(a)) or not np.isfinite(C).all() or not (np.diag(C) > 0.0).all():
        return None
    v = np.linalg.eigh(C)[1][:, -1]
    if not (v > 0.0).all() and not (v < 0.0).all():  # no common motion: they do not move together
        return None
    P = np.eye(len(a)) - np.outer(v / v.sum(), np.ones(len(a)))
    sigma = np.sqrt(np.maximum(np.diag(P @ C @ P.T), 0.0))
    if not (MIN_REDUCTION * sigma <= np.sqrt(np.diag(C))).all():
        return None
    return P @ a, sigma
