"""The next measurement: the pose, motors and perhaps load that are expected to be most informative."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pkmodes.core.base.drives import DRIVES, motors_instruction
from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.posterior.document import Probabilities
from pkmodes.loop.diagnosis.problem import Array, Driven, Surrounded
from pkmodes.loop.diagnosis.verdict.elsewhere import (
    MeasuringCondition,
    PredictionElsewhere,
    explanation_distances,
    measuring_conditions,
    predict_elsewhere,
)
from pkmodes.loop.diagnosis.verdict.explanations import Explanation, NamedFits, explanations
from pkmodes.loop.diagnosis.verdict.findings import NextMeasurement
from pkmodes.loop.diagnosis.verdict.information import information, pairs

#: Number of poses to choose from.
POSE_COUNT = 80
UNKNOWN_SETUPS = "it is not known where else the structure could be measured"


class _Proposal(NamedTuple):
    """The best pose for a way to measure.

    - information: expected information, as a part of what is unknown about the explanations
    - sigmas: distance between the two explanations that it separates
    """

    information: float
    sigmas: float
    effort: int
    measurement: NextMeasurement


def next_measurement(
    store: FitStore, probabilities: Probabilities | None, classes: Sequence[NamedFits]
) -> tuple[NextMeasurement | None, str]:
    """Propose a pose, with other motors or a load if that is far more informative than any pose alone.

    Motors that give way in all remaining explanations are not to be held, unless they were in a measurement.

    - probabilities, classes: probabilities and classes of the explanations, see `explanations`

    Returns, in this order:
    - None if no measurement separates any two of them
    - why there is none; empty if there is one, or fewer than two explanations are left
    """
    fitter, rivals = store.fitter, explanations(store, probabilities, classes)
    if len(rivals) < 2:
        return None, ""
    declared, other_setups = fitter.structure, fitter.structure.elsewhere(POSE_COUNT)
    setups_in_words = declared.surroundings if isinstance(declared, Surrounded) else "other setups"
    if other_setups is None:
        return None, UNKNOWN_SETUPS
    points, structure = other_setups
    if not len(points):
        return None, f"there are no {setups_in_words}"
    best, criteria = None, fitter.criteria.claim
    # A cause is certain if it is in all remaining explanations.
    causes = [{cause.name for cause in fit.causes} for group in classes for _, fit in group]
    certain_causes = set.intersection(*causes) if causes else set[str]()
    may_hold_motors = not isinstance(declared, Driven) or declared.may_be_held(certain_causes)
    conditions = list(measuring_conditions(structure, points, may_hold_motors=may_hold_motors))
    proposals = [_propose(fitter, rivals, points, condition) for condition in conditions]
    for proposal in proposals:
        if proposal.sigmas >= criteria.worth_measuring and (
            best is None
            or proposal.information > criteria.worth_loading * best.information
            or (proposal.effort == best.effort and proposal[:2] > best[:2])
        ):
            best = proposal
    if best is not None:
        return best.measurement, ""
    return None, _why_none(
        f"{len(points)} {setups_in_words}", conditions, proposals, criteria.worth_measuring
    )


def _propose(
    fitter: Fitter, rivals: Sequence[Explanation], points: Array, condition: MeasuringCondition
) -> _Proposal:
    """Return the pose expected to be most informative among those at which two explanations differ enough.

    It separates the two that differ enough and that it tells apart with the largest probability; of equally
    informative poses, it is the one where these differ most.  If none differ enough anywhere, it is where two differ
    most.
    """
    predictions = [predict_elsewhere(fitter, condition, rival.fit) for rival in rivals]
    index_pairs = pairs(len(rivals))
    distances, _, overlaps = explanation_distances(predictions, range(len(points)))
    probabilities = np.array([rival.probability for rival in rivals])
    probabilities /= probabilities.sum()
    differ_enough = distances >= min(fitter.criteria.claim.worth_measuring, float(distances.max()))
    relative_information = np.round(
        information(probabilities, overlaps) / -(probabilities @ np.log(probabilities)), 3
    )
    relative_information[~differ_enough.any(axis=0)] = -np.inf
    weight = np.array([probabilities[i] * probabilities[j] for i, j in index_pairs])[:, None] * (
        1.0 - overlaps
    )
    best_pairs = np.where(differ_enough, weight, -1.0).argmax(axis=0)
    best = np.flatnonzero(relative_information == relative_information.max())
    k = int(best[distances[best_pairs[best], best].argmax()])
    i, j = index_pairs[best_pairs[k]]
    sigmas, names = float(distances[best_pairs[k], k]), (rivals[i].name, rivals[j].name)
    hiding_value = _hiding_value(fitter, (predictions[i], predictions[j]), k)
    pose = tuple(points[k].tolist())
    measurement = NextMeasurement(pose, names, sigmas, condition.drives, hiding_value, dict(condition.load))
    return _Proposal(float(relative_information[k]), sigmas, condition.effort, measurement)


def _hiding_value(fitter: Fitter, predictions: Sequence[PredictionElsewhere], pose: int) -> str:
    """Return the uncertain value that could make up most of a difference at a pose within its standard deviation.

    The state of the motors in the measurements may have left values undetermined that matter now, such as the
    inertia of motors that were held.  Empty if the difference is worth measuring despite all uncertainties, or if
    knowing that value would neither make it so nor double it.
    """
    min_sigmas = fitter.criteria.claim.worth_measuring

    def separation(exact: int | None = None) -> float:
        return float(explanation_distances(predictions, [pose], exact)[1].item())

    hiding_index = max(fitter.nuisance_indices, key=separation, default=None)
    if (
        hiding_index is None
        or separation() >= min_sigmas
        or separation(hiding_index) < min(min_sigmas, 2.0 * separation())
    ):
        return ""
    return fitter.parameters[hiding_index].name


def _why_none(
    setups_in_words: str,
    conditions: Sequence[MeasuringCondition],
    proposals: Sequence[_Proposal],
    min_sigmas: float,
) -> str:
    """Return why nothing is proposed although several explanations remain."""
    best = max(proposals, key=lambda proposal: proposal.sigmas)
    if not best.sigmas:
        return f"at none of {setups_in_words} can the remaining explanations be compared"
    other_ways = (
        f", with {motors_instruction(DRIVES)}"
        if any(condition.has_other_drives for condition in conditions)
        else ""
    )
    other_ways += ", with or without a load" if any(condition.load for condition in conditions) else ""
    return (
        f"none of {setups_in_words} separates the remaining explanations by {min_sigmas:g} standard deviations or "
        f"more{other_ways}: {' and '.join(best.measurement.separates)} differ by at most {plain(best.sigmas, 2)} "
        "standard deviations"
    )
