"""The rule for data with fewer measured values than unknowns."""

from __future__ import annotations

from pkmodes.core.base.numbers import p_in_words
from pkmodes.loop.diagnosis.verdict.evidence import Start

#: Effective number of uncertain values that the data may determine although these count as held by their priors.
MAX_DETERMINED_PART = 0.1


def too_few(start: Start) -> str:
    """Fewer values are measured than the uncertain parameters and a cause need, with one more to test it.

    An uncertain parameter counts as far as the data determine it: what its prior holds is not unknown.
    """
    fitter = start.fitter
    observations = fitter.observations
    rows, shapes = len(observations.log_frequencies), int(observations.shapes.count.sum())
    if (
        observations.degrees_of_freedom(observations.all_rows)
        >= start.effective_parameters - MAX_DETERMINED_PART + start.criteria.claim.redundancy
    ):
        return ""
    uncertain = [fitter.parameters[i].name for i in fitter.nuisance_indices]
    modes = "1 measured mode" if rows == 1 else f"{rows} measured modes"
    modes += f" with {shapes} shape values" if shapes else ""
    modes += " is" if rows == 1 else " are"
    values = f"the uncertain {', '.join(uncertain)} and " if uncertain else ""
    text = f"{modes} too few to fit {values}a cause, with one value left to test it"
    if start.declared_fit is None:
        return text
    is_single, p = rows == 1, p_in_words(start.store.p_value(start.declared_fit))
    if not start.is_contradicted:
        them = "it" if is_single else "them"
        return f"{text}; the declared model with its uncertain values does not contradict {them} ({p})"
    they, verb = ("it", "contradicts") if is_single else ("they", "contradict")
    hint_clause = f"; {they} would not with {' or '.join(start.hints)}" if start.hints else ""
    return f"{text}; yet {they} {verb} the declared model and its uncertain values ({p}){hint_clause}"
