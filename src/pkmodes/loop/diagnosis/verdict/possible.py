"""Which members a class keeps, and whether the value of each is one that such a part can have.

A value is *impossible* if it lies beyond the plausible range in which limits are sought, which also ends at three
standard deviations of a candidate's prior (`search.ranges`): such a member leaves the class.  It is *implausible* if
it is outside the usual range of such a part (`Parameter.usual`): such a member stays, and is marked.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.problem import Parameter
from pkmodes.loop.diagnosis.verdict.findings import Member
from pkmodes.loop.diagnosis.verdict.joints import JointAlone

#: Relative amount by which a value may exceed its range: the last digits of a fit.
RANGE_TOLERANCE = 1e-6


def describe_member(
    fitter: Fitter, fit: Fit, max_deviations: Mapping[int, float], single_joint: JointAlone | None = None
) -> Member:
    """Return the last cause of a fit as the member of a class, in the words of a single joint that explains as much.

    - max_deviations: largest plausible deviations from the declared values, by parameter
    - single_joint: the single joint in which it explains the data as well
    """
    cause = fit.causes[-1]
    violated_range = violated_plausible_range(fitter, fit, max_deviations)
    violated_range = violated_range or violated_usual_range(fitter, fit)
    assumed = " and ".join(assumption.words for assumption in cause.assumes)
    default_in_words = f"{assumed}, which is assumed" if assumed else ""
    if single_joint is not None:
        return Member(cause.name, single_joint.sentence, implausible=violated_range, assumed=default_in_words)
    return Member(cause.name, cause.sentence, cause.kind, cause.part, violated_range, default_in_words)


def violated_plausible_range(fitter: Fitter, fit: Fit, max_deviations: Mapping[int, float]) -> str:
    """Return the plausible range of a value of the last cause of a fit, if the value is beyond it; else empty."""
    for i in fitter.parameter_indices(fit.causes[-1]):
        p, max_deviation = fitter.parameters[i], max_deviations.get(i, np.inf)
        if abs(float(fit.values[i]) - p.value) > (1.0 + RANGE_TOLERANCE) * max_deviation:
            declared = _with_unit(plain(p.value, 3), p)
            return f"at most {_with_unit(plain(max_deviation, 3), p)} from {declared} is plausible"
    return ""


def violated_usual_range(fitter: Fitter, fit: Fit) -> str:
    """Return the usual range of a value of the last cause of a fit, if the value is outside it; else empty."""
    for i in fitter.parameter_indices(fit.causes[-1]):
        p = fitter.parameters[i]
        if p.usual is not None and not p.usual[0] <= fit.values[i] <= p.usual[1]:
            low, high = (plain(end, 3) for end in p.usual)
            return f"{low} to {_with_unit(high, p)} is plausible"
    return ""


def usual_size(p: Parameter) -> float:
    """Return the largest deviation from the declared value within the usual range; infinite if there is none."""
    return np.inf if p.usual is None else max(abs(end - p.value) for end in p.usual)


def _with_unit(text: str, p: Parameter) -> str:
    return text if p.unit == "1" else f"{text} {p.unit}"


def split_possible(
    fitter: Fitter, group: Sequence[Fit], max_deviations: Mapping[int, float]
) -> tuple[list[Fit], list[str]]:
    """Return the members of a class whose values are possible, and a sentence for each of the others.

    A class that would become empty is kept whole.
    """
    violated_ranges = [violated_plausible_range(fitter, fit, max_deviations) for fit in group]
    if all(violated_ranges):
        return list(group), []
    possible_fits, removed_sentences = [], []
    for fit, text in zip(group, violated_ranges, strict=True):
        if not text:
            possible_fits.append(fit)
            continue
        parameters_and_values = [
            (fitter.parameters[i], float(fit.values[i])) for i in fitter.parameter_indices(fit.causes[-1])
        ]
        values = ", ".join(
            f"{p.name} = {_with_unit(plain(value, 3), p)}" for p, value in parameters_and_values
        )
        removed_sentences.append(
            f"{values} would explain the measurements as well, but is left out of the class: {text}"
        )
    return possible_fits, removed_sentences
