"""Causes of which one is a special case of the other: one value for all joints, and one for each of them.

What the special one does lies in the span of what the parameters of the general one do.  Such causes do not
contradict each other: the general one fits at least as well, whatever the truth.  It says more, and is needed only
where it fits better than its further parameters would by chance.
"""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, orthonormal
from pkmodes.diagnosis.problem import Array, Candidate
from pkmodes.diagnosis.search.score import score
from pkmodes.diagnosis.search.search import Search


def nested(fitter: Fitter, a: Fit, b: Fit) -> bool:
    """Whether two fits differ in one cause, and that of one is a special case of the other's, at both fits."""
    of_a = [cause for cause in a.causes if cause not in b.causes]
    of_b = [cause for cause in b.causes if cause not in a.causes]
    if len(of_a) != 1 or len(of_b) != 1:
        return False
    pairs = ((of_a[0], of_b[0]), (of_b[0], of_a[0]))
    return any(
        all(_is_special(fitter, fit, special, general) for fit in (a, b)) for special, general in pairs
    )


def more_general(search: Search, final: Fit) -> tuple[Candidate, Candidate] | None:
    """A cause of a fit and the general one that what is left points at significantly; None where it points at none.

    By the score: what the cause leaves has as many directions as the general one has parameters more.  Nothing is
    fitted, so that close modes cannot change places with a neighbour that happens to be nearer, which is a gain that
    no distribution of further parameters has.
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
    """Whether what one cause does at a fit lies in the span of another, and the data could show that it does not."""
    used = fitter.used(fit.hypothesis)
    count = int(used.sum()) + int(fitter.shapes.count[used].sum())
    if count < len(general.parameters) + fitter.criteria.redundancy:
        return False
    rates, basis = _rates(fitter, fit, special), orthonormal(_rates(fitter, fit, general))
    left = np.linalg.norm(rates - basis @ (basis.T @ rates), axis=0)
    return bool((left <= fitter.criteria.nested * np.linalg.norm(rates, axis=0)).all())


def _rates(fitter: Fitter, fit: Fit, cause: Candidate) -> Array:
    """Whitened derivatives of the data, without priors, with respect to a cause's parameters."""
    return fitter.signatures(fit, fitter.indices(cause))[1][: fitter.prior_rows.start]
