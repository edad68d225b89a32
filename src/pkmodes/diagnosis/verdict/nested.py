"""Nested causes, such as one value for all joints and one value for each joint.

The signature of the special cause lies in the span of the signatures of the general one.  Nested causes do not
contradict each other: the general one always fits at least as well.  It is needed only if it fits better than its
additional parameters would by chance.
"""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, orthonormal
from pkmodes.diagnosis.problem import Array, Candidate
from pkmodes.diagnosis.search.score import score
from pkmodes.diagnosis.search.search import Search


def nested(fitter: Fitter, a: Fit, b: Fit) -> bool:
    """Return whether two fits differ in one cause, and one of these is a special case of the other at both fits."""
    of_a = [cause for cause in a.causes if cause not in b.causes]
    of_b = [cause for cause in b.causes if cause not in a.causes]
    if len(of_a) != 1 or len(of_b) != 1:
        return False
    pairs = ((of_a[0], of_b[0]), (of_b[0], of_a[0]))
    return any(
        all(_is_special(fitter, fit, special, general) for fit in (a, b)) for special, general in pairs
    )


def more_general(search: Search, final: Fit) -> tuple[Candidate, Candidate] | None:
    """Return a cause of a fit and the more general one to which the residual points significantly, or None.

    A score test: its degrees of freedom are the additional parameters of the general cause.  The general cause is not
    fitted, because close modes could then be paired differently, a gain that the null distribution does not include.
    """
    for cause in final.causes:
        for general in search.general:
            if general.general_of != cause.name:
                continue
            scores = score(search.store.fitter, final, [general])
            if scores.each[0].p_value < search.criteria.surely:
                return cause, general
    return None


def _is_special(fitter: Fitter, fit: Fit, special: Candidate, general: Candidate) -> bool:
    """Return whether the signature of one cause lies in the span of another's, and the data can resolve this."""
    used = fitter.used(fit.hypothesis)
    count = int(used.sum()) + int(fitter.shapes.count[used].sum())
    if count < len(general.parameters) + fitter.criteria.redundancy:
        return False
    rates, basis = _rates(fitter, fit, special), orthonormal(_rates(fitter, fit, general))
    left = np.linalg.norm(rates - basis @ (basis.T @ rates), axis=0)
    return bool((left <= fitter.criteria.nested * np.linalg.norm(rates, axis=0)).all())


def _rates(fitter: Fitter, fit: Fit, cause: Candidate) -> Array:
    """Return the whitened derivatives of the data, without priors, with respect to a cause's parameters."""
    return fitter.signatures(fit, fitter.indices(cause))[1][: fitter.prior_rows.start]
