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
from pkmodes.loop.diagnosis.verdict.elsewhere import Elsewhere, MeasuringCondition, apart, elsewhere, ways
from pkmodes.loop.diagnosis.verdict.explanations import Explanation, NamedFits, explanations
from pkmodes.loop.diagnosis.verdict.findings import NextMeasurement
from pkmodes.loop.diagnosis.verdict.information import information, pairs

#: Number of poses to choose from.
POSES = 80
UNKNOWN = "it is not known where else the structure could be measured"


class _Proposal(NamedTuple):
    """The best pose for a way to measure.

    - told: expected information, as a part of what is unknown about the explanations
    - sigmas: distance between the two explanations that it separates
    """

    told: float
    sigmas: float
    effort: int
    measurement: NextMeasurement


def next_measurement(
    store: FitStore, probabilities: Probabilities | None, classes: Sequence[NamedFits]
) -> tuple[NextMeasurement | None, str]:
    """Propose a pose, with other motors or a load if that is far more informative than any pose alone.

    Motors that give way in all remaining explanations are not to be held, unless they were in a measurement.

    - probabilities, classes: of the explanations, see `explanations`

    Returns, in this order:
    - None if no measurement separates any two of them
    - why there is none; empty if there is one, or fewer than two explanations are left
    """
    fitter, rivals = store.fitter, explanations(store, probabilities, classes)
    if len(rivals) < 2:
        return None, ""
    declared, other_setups = fitter.structure, fitter.structure.elsewhere(POSES)
    where = declared.surroundings if isinstance(declared, Surrounded) else "other setups"
    if other_setups is None:
        return None, UNKNOWN
    points, structure = other_setups
    if not len(points):
        return None, f"there are no {where}"
    best, claim = None, fitter.criteria.claim
    # A cause is certain if it is in all remaining explanations.
    causes = [{cause.name for cause in fit.causes} for group in classes for _, fit in group]
    certain = set.intersection(*causes) if causes else set[str]()
    held = not isinstance(declared, Driven) or declared.may_be_held(certain)
    tried = list(ways(structure, points, held=held))
    proposals = [_proposed(fitter, rivals, points, way) for way in tried]
    for proposal in proposals:
        if proposal.sigmas >= claim.worth_measuring and (
            best is None
            or proposal.told > claim.worth_loading * best.told
            or (proposal.effort == best.effort and proposal[:2] > best[:2])
        ):
            best = proposal
    if best is not None:
        return best.measurement, ""
    return None, _nowhere(f"{len(points)} {where}", tried, proposals, claim.worth_measuring)


def _proposed(
    fitter: Fitter, rivals: Sequence[Explanation], points: Array, way: MeasuringCondition
) -> _Proposal:
    """Return the pose expected to be most informative among those at which two explanations differ enough.

    It separates the two that differ enough and that it tells apart with the largest probability; of equally
    informative poses, it is the one where these differ most.  If none differ enough anywhere, it is where two differ
    most.
    """
    there, both = [elsewhere(fitter, way, rival.fit) for rival in rivals], pairs(len(rivals))
    distances, _, overlaps = apart(there, range(len(points)))
    p = np.array([rival.probability for rival in rivals])
    p /= p.sum()
    enough = distances >= min(fitter.criteria.claim.worth_measuring, float(distances.max()))
    told = np.round(information(p, overlaps) / -(p @ np.log(p)), 3)
    told[~enough.any(axis=0)] = -np.inf
    weight = np.array([p[i] * p[j] for i, j in both])[:, None] * (1.0 - overlaps)
    separated = np.where(enough, weight, -1.0).argmax(axis=0)
    best = np.flatnonzero(told == told.max())
    k = int(best[distances[separated[best], best].argmax()])
    i, j = both[separated[k]]
    sigmas, names = float(distances[separated[k], k]), (rivals[i].name, rivals[j].name)
    hidden = _hiding(fitter, (there[i], there[j]), k)
    pose = tuple(points[k].tolist())
    proposed = NextMeasurement(pose, names, sigmas, way.drives, hidden, dict(way.load))
    return _Proposal(float(told[k]), sigmas, way.effort, proposed)


def _hiding(fitter: Fitter, two: Sequence[Elsewhere], pose: int) -> str:
    """Return the uncertain value that could make up most of a difference at a pose within its standard deviation.

    The state of the motors in the measurements may have left values undetermined that matter now, such as the
    inertia of motors that were held.  Empty if the difference is worth measuring despite all uncertainties, or if
    knowing that value would neither make it so nor double it.
    """
    least = fitter.criteria.claim.worth_measuring

    def separation(exact: int | None = None) -> float:
        return float(apart(two, [pose], exact)[1].item())

    hiding = max(fitter.nuisances, key=separation, default=None)
    if hiding is None or separation() >= least or separation(hiding) < min(least, 2.0 * separation()):
        return ""
    return fitter.parameters[hiding].name


def _nowhere(
    where: str, tried: Sequence[MeasuringCondition], proposals: Sequence[_Proposal], least: float
) -> str:
    """Return why nothing is proposed although several explanations remain."""
    best = max(proposals, key=lambda proposal: proposal.sigmas)
    if not best.sigmas:
        return f"at none of {where} can the remaining explanations be compared"
    ways = f", with {motors_instruction(DRIVES)}" if any(way.unlike for way in tried) else ""
    ways += ", or with a load" if any(way.load for way in tried) else ""
    return (
        f"none of {where} separates the remaining explanations by {least:g} standard deviations or more{ways}: "
        f"{' and '.join(best.measurement.separates)} differ by {plain(best.sigmas, 2)} at most"
    )
