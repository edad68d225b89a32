"""Whether a single joint of a cause with a value for each joint explains the data as well.

"The legs are not equally stiff" has six values; "leg 3 is 25 % softer than the others" has one, and says where to
look.
"""

from __future__ import annotations

from dataclasses import replace

from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.score import score
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.held_out import p_of_held_out
from pkmodes.loop.diagnosis.verdict.joints import JointAlone


def joint_alone(setups: AllSetups, search: Search, fit: Fit) -> JointAlone | None:
    """Return the single joint in which the last cause of a fit explains the data as well; None if there is none.

    It fits by the criterion at least as well as all joints together, leaves only noise, predicts the held-out setups,
    and no other joint alone survives beside it.  The fits are kept separate from those of the search, on which
    probabilities depend.
    """
    cause, c, fitter = fit.causes[-1], search.criteria, search.store.fitter
    if not cause.joints:
        return None
    separate_search = Search(FitStore(fitter), search.candidates)
    hypothesis = replace(fit.hypothesis, causes=fit.causes[:-1])
    base = separate_search.store.fit(hypothesis, search.store.values_without(fit, hypothesis))
    if base is None:
        return None
    sigma_of = dict(zip(cause.parameters, cause.sigma or (), strict=False))
    joint_candidates = {
        joint.parameter: Candidate(
            f"{cause.name} of {joint.words} alone",
            (joint.parameter,),
            sigma=(sigma_of[joint.parameter],) if joint.parameter in sigma_of else None,
        )
        for joint in cause.joints
    }
    criterion = separate_search.store.criterion
    fits = [
        option
        for option in separate_search.additions.with_another_cause(
            base, score(fitter, base, [*joint_candidates.values()])
        )
        if not option.at_bound
    ]
    best, rivals = next(iter(fits), None), fits[1:]
    if best is None or criterion(best) > criterion(fit):
        return None
    if any(criterion(rival) <= criterion(best) + c.search.survives for rival in rivals):
        return None
    if not separate_search.gate(best).passed or p_of_held_out(setups, separate_search, best) <= c.gate.surely:
        return None
    (name,) = best.causes[-1].parameters
    (i,) = fitter.parameter_indices(best.causes[-1])
    joint = next(part for part in cause.joints if part.parameter == name)
    return JointAlone(joint, float(best.values[i]), best.sigma_of(i), len(cause.joints) - 1)
