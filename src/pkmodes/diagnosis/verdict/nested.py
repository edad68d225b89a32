"""Causes of which one is a special case of the other: one value for all joints, and one for each of them.

What the special one does lies in the span of what the parameters of the general one do.  Such causes do not
contradict each other: the general one fits at least as well, whatever the truth.  It says more, and is needed only
where it fits better than its further parameters would by chance.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, orthonormal
from pkmodes.diagnosis.problem import Array, Candidate
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
    """A cause of a fit and the general one that is significantly better in its place; None where none is.

    By the likelihood ratio, which for a special case is chi-square distributed with as many degrees of freedom as the
    general cause has more parameters.
    """
    store = search.store
    for place, cause in enumerate(final.causes):
        for general in search.general:
            more = len(general.parameters) - len(cause.parameters)
            if general.general_of != cause.name or more < 1:
                continue
            causes = (*final.causes[:place], *final.causes[place + 1 :], general)
            hypothesis = replace(final.hypothesis, causes=causes)
            fit = store.fitter.fit(hypothesis, _as_general(search, final, cause, general))
            if fit is None:
                continue
            gain = max(final.deviance - fit.deviance, 0.0)
            if stats.chi2.sf(gain, more) < search.criteria.gate:
                return cause, general
    return None


def _as_general(search: Search, fit: Fit, special: Candidate, general: Candidate) -> Array:
    """Values of a fit, with what the special cause does in the words of the general one."""
    fitter = search.store.fitter
    rates, by = _rates(fitter, fit, general), list(fitter.indices(general))
    index = list(fitter.indices(special))
    done = _rates(fitter, fit, special) @ (fit.values[index] - fitter.declared[index])
    size = np.linalg.norm(rates, axis=0)
    scale = np.where(size > 0.0, size, 1.0)
    step = np.linalg.lstsq(rates / scale, done, rcond=None)[0] / scale
    values = fit.values.copy()
    values[index] = fitter.declared[index]
    lower, upper = (
        np.array([getattr(fitter.parameters[i], name) for i in by]) for name in ("lower", "upper")
    )
    values[by] = np.clip(fitter.declared[by] + step, lower, upper)
    return values


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
