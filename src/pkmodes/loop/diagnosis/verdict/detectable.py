"""Which candidates the data can show: one definition, for the JSON, the table, the chart and the list.

A candidate is *detectable* if one of these holds:

* it is claimed, in the class of a claim, or remains as an explanation, or the reason of the verdict names it as one
  to which the data point;
* the residual of the refitted model shows it: its score is significant;
* the data bound it: one of its parameters has a limit (`limits`), so that its absence beyond that is known.

So a candidate that is called not detectable never has a limit, and is never part of an explanation.

Only plausible changes count, those in the range in which limits are sought (`search.ranges`); the score too is that
of the best change within it.  A candidate nearly parallel to an uncertain value, such as gravity, would otherwise
seem significant at a size outside any machine's range.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.score import Score, Scores, allowed_sign
from pkmodes.loop.diagnosis.verdict.findings import Examined, Value


def examine_candidates(
    fitter: Fitter,
    first_scores: Scores,
    last_scores: Scores,
    max_deviations: Mapping[int, float],
    *,
    named: Collection[str],
    limited: Collection[str],
    unbounded: Collection[str],
) -> tuple[Examined, ...]:
    """Return the test of each candidate, its smallest visible change, and whether it is detectable.

    - first_scores, last_scores: before any claim, and beside the claims
    - max_deviations: largest plausible deviation of each parameter
    - named: candidates that are claimed, in the class of a claim, remain, or are named by the reason or the stability
    - limited, unbounded: candidates with a parameter that the data bound, and with one that they do not bound
    """
    c = fitter.criteria
    scores_beside_claims = {entry.candidate.name: entry for entry in last_scores.by_candidate}
    tests = []
    for candidate_score in first_scores.by_candidate:
        name, index = candidate_score.candidate.name, fitter.parameter_indices(candidate_score.candidate)
        current_score = candidate_score if name in named else scores_beside_claims.get(name, candidate_score)
        max_of_candidate = np.array([max_deviations.get(i, np.inf) for i in index])
        p_value = p_value_within_range(fitter, candidate_score, max_of_candidate)
        sizes = c.claim.seen * current_score.sigma
        is_visible = (
            current_score.is_visible
            and name not in unbounded
            and bool((np.isfinite(sizes) & (sizes <= max_of_candidate)).all())
        )
        parameters = [fitter.parameters[i] for i in index] if is_visible else []
        values = tuple(
            Value(p.name, float(size), float(size / c.claim.seen), p.unit)
            for p, size in zip(parameters, sizes, strict=bool(parameters))
        )
        detectable = name in named or name in limited or p_value <= c.gate.surely
        tests.append(Examined(name, p_value, values, detectable, candidate_score.candidate.sentence))
    return tuple(tests)


def p_value_within_range(fitter: Fitter, candidate_score: Score, max_deviations: Array) -> float:
    """Return the p-value of a score, of the best change within the plausible range.

    A part t of the step to the best change yields t (2 - t) of its decrease of chi2.

    - max_deviations: largest plausible deviations, (k,)
    """
    step = np.abs(candidate_score.step)
    part_of_step = float(
        np.min(
            np.where(step > max_deviations, max_deviations / np.where(step > 0.0, step, 1.0), 1.0),
            initial=1.0,
        )
    )
    if part_of_step >= 1.0:
        return candidate_score.p_value
    p = float(
        stats.chi2.sf(
            candidate_score.gain * part_of_step * (2.0 - part_of_step), max(int((step > 0.0).sum()), 1)
        )
    )
    return 0.5 * p if allowed_sign(fitter, candidate_score.candidate) else p
