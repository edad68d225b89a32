"""Diagnose a model from measured modes.

1. `match` pairs measured modes with modes of the model.
2. `fit` refits the nuisance parameters within their priors, to frequencies and shapes.
3. `search` tests in the gate whether the residual is noise, and if not, looks for a cause or pair that explains it.
4. `verdict` judges the result of the search: measurement mistakes, rivals, classes, errors instead of causes, shapes,
   stability.
5. `damping` asks, at the final model, which joint dissipates, where damping was measured.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.diagnosis.arguments import checked
from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.damping.diagnose_damping import with_damping
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.matrices import slowness
from pkmodes.diagnosis.problem import Structure
from pkmodes.diagnosis.search.additions import Progress
from pkmodes.diagnosis.search.search import Outcome, Search
from pkmodes.diagnosis.verdict import limits
from pkmodes.diagnosis.verdict.all_setups import AllSetups
from pkmodes.diagnosis.verdict.builder import DiagnosisBuilder
from pkmodes.diagnosis.verdict.evidence import Evidence
from pkmodes.diagnosis.verdict.mistakes import certain_wiring, other_unit
from pkmodes.diagnosis.verdict.result import Diagnosis
from pkmodes.diagnosis.verdict.rules import decide
from pkmodes.diagnosis.verdict.stability import unchanged
from pkmodes.diagnosis.verdict.verdicts import INSUFFICIENT_DATA, UNEXPLAINED
from pkmodes.diagnosis.verdict.whole_data import remarks
from pkmodes.diagnosis.verdict.wrong_drives import seemingly_wrong_drives, wrong_drives
from pkmodes.measured.measurements import Measurements
from pkmodes.support.numbers import p_in_words

#: By default, one in this many poses is held out.
HELD_OUT = 6
#: Largest number of causes named that would remove a contradiction of too few data.
HINTS = 4


def diagnose(
    structure: Structure,
    data: Measurements,
    *,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
    criteria: Criteria | None = None,
) -> Diagnosis:
    """Find what a model lacks.

    Parameters
    ----------
    structure : Structure
        At the setups of the measurements.
    data : Measurements
        Identified modes of these setups.
    holdout : sequence of str, optional
        Labels of setups that are used in no choice or fit.
    progress : callable, optional
        Called with a sentence at each step.
    criteria : Criteria, optional
        Thresholds.  The error rates in docs/diagnosis-measured.md hold for the default ones.

    Returns
    -------
    Diagnosis
        The verdict with its reason, the causes, and the error before and after.

    Raises
    ------
    PkmodesError
        If a label is unknown, no setup is left to fit, or the model cannot be evaluated as declared.
    """
    structure = checked(structure, data)
    first = _of_frequencies(structure, data, holdout, progress, criteria)
    return with_damping(structure, data, first, criteria)


def _of_frequencies(
    structure: Structure,
    data: Measurements,
    holdout: Sequence[str] | None,
    progress: Progress | None,
    criteria: Criteria | None,
) -> Diagnosis:
    """Return what frequencies and shapes say."""
    if progress is not None and (remark := slowness(structure)):
        progress(remark)
    fitted, held = split(data, holdout)
    fitter = Fitter(structure.subset(fitted), data.at(fitted), criteria)
    builder = DiagnosisBuilder(AllSetups(structure, data, fitter, held))
    unit = other_unit(fitter)
    if unit:
        return _mistaken(builder, unit)
    if (
        len(fitter.log) + int(fitter.shapes.count.sum())
        < len(fitter.nuisances) + fitter.criteria.claim.redundancy
    ):
        return _insufficient(builder)
    plain = FitStore(fitter)
    first = plain.fit(Hypothesis())
    mistake = wrong_drives(plain) or ("" if first is None else certain_wiring(fitter, first))
    if mistake:
        return _mistaken(builder, mistake)
    search, outcome = _searched(plain, structure, progress)
    if outcome is None:
        what = "the model cannot be evaluated with its declared values"
        raise PkmodesError(what, data.source, "check the poses and the robot file")
    evidence = Evidence(builder.setups, search, outcome)
    return builder.after_search(evidence, decide(evidence))


def split(data: Measurements, holdout: Sequence[str] | None) -> tuple[list[int], list[int]]:
    """Return the indices of the fitted and of the held-out setups (by default one in six, evenly spread)."""
    count = len(data.labels)
    if holdout is None:
        number = count // HELD_OUT
        held = sorted({int((k + 0.5) * count / number) for k in range(number)})
    else:
        if isinstance(holdout, str) or not all(isinstance(label, str) for label in holdout):
            what = f"expected a list of labels to hold out, found {shown(holdout)}"
            remedy = f"write [{shown(holdout)}]" if isinstance(holdout, str) else "give labels as strings"
            raise PkmodesError(what, "holdout", remedy)
        unknown = [label for label in holdout if label not in data.labels]
        if unknown:
            nearest = difflib.get_close_matches(unknown[0], data.labels, n=1)
            some = ", ".join(data.labels[:10]) + (", ..." if count > 10 else "")
            remedy = f'did you mean "{nearest[0]}"?' if nearest else f"labels are: {some}"
            raise PkmodesError(f"no pose is called {shown(unknown[0])}", "holdout", remedy)
        held = sorted({data.labels.index(label) for label in holdout})
    fitted = [i for i in range(count) if i not in held]
    if not fitted:
        raise PkmodesError("every pose is held out", "holdout", "leave some poses to fit")
    return fitted, held


def _mistaken(builder: DiagnosisBuilder, mistake: str) -> Diagnosis:
    """Return the result for measurements with an obvious mistake: nothing is fitted or searched for."""
    store = FitStore(builder.fitter)
    suspected = [candidate for candidate in builder.fitter.structure.candidates if candidate.claimable]
    names = tuple(candidate.name for candidate in suspected)
    same, nothing = unchanged(UNEXPLAINED), limits.unknown(store, suspected)
    return builder.without_search(UNEXPLAINED, mistake, store, None, names, (mistake,), same, nothing)


def _searched(
    plain: FitStore, structure: Structure, progress: Progress | None
) -> tuple[Search, Outcome | None]:
    """Search, with the shape scatter estimated from the best of all explanations if none is stated.

    Parameters
    ----------
    plain : FitStore
        With the fit of the declared model.
    """
    fitter = plain.fitter
    c, first = fitter.criteria, plain.fit(Hypothesis())
    scatter = None if first is None else plain.shape_scatter(first)
    store = plain
    while True:
        if scatter is not None:
            bounded = float(np.clip(scatter, c.shapes.least_scatter, c.shapes.most_scatter))
            fitter = Fitter(fitter.structure, fitter.data, c, bounded)
            store = FitStore(fitter, store)
        search = Search(store, structure.candidates, progress)
        outcome = search.run()
        scatters = [search.store.shape_scatter(fit) for fit in search.store.tried()]
        best = min((each for each in scatters if each is not None), default=None)
        # If nothing explains even the frequencies, a smaller shape scatter changes nothing.
        hopeless = all(search.store.frequency_p_value(fit) <= c.gate.surely for fit in search.store.tried())
        if (
            hopeless
            or best is None
            or max(best, c.shapes.least_scatter) >= c.shapes.sharper * fitter.shape_scatter
        ):
            return search, outcome
        scatter = best


def _insufficient(builder: DiagnosisBuilder) -> Diagnosis:
    """Return the result for too few data: no search, only whether they contradict the model and its priors."""
    fitter, store = builder.fitter, FitStore(builder.fitter)
    fit = store.fit(Hypothesis())  # the priors determine it, however few the data
    candidates = [candidate for candidate in fitter.structure.candidates if candidate.claimable]
    p_value, hints, contradicts = None, [], False
    if fit is not None:
        p_value = store.p_value(fit)
        contradicts = p_value <= fitter.criteria.gate.surely
        if contradicts:
            search = Search(store, candidates)
            singles = search.additions.would_do()
            hints = [single.causes[0].name for single in singles[:HINTS]]
    reason = _too_few(fitter, p_value, hints, contradicts)
    drives = seemingly_wrong_drives(fitter)
    about = (*((drives,) if drives else ()), *(() if fit is None else remarks(builder.setups, fit)))
    if fit is None:
        bounded = limits.unknown(store, candidates)
    else:
        bounded = limits.beside(store, [fit], candidates, noise=not contradicts)
    known = {*bounded.limited, *hints}
    unseen = tuple(candidate.name for candidate in candidates if candidate.name not in known)
    same = unchanged(INSUFFICIENT_DATA)
    return builder.without_search(INSUFFICIENT_DATA, reason, store, fit, unseen, about, same, bounded)


def _too_few(fitter: Fitter, p_value: float | None, hints: Sequence[str], contradicts: bool) -> str:
    """Return the reason if there are too few data, and whether they nevertheless contradict the model."""
    rows, shapes = len(fitter.log), int(fitter.shapes.count.sum())
    uncertain = [fitter.parameters[i].name for i in fitter.nuisances]
    modes = "1 measured mode" if rows == 1 else f"{rows} measured modes"
    modes += f" with {shapes} shape values" if shapes else ""
    modes += " is" if rows == 1 else " are"
    names = f"the uncertain {', '.join(uncertain)} and " if uncertain else ""
    text = f"{modes} too few to fit {names}a cause, with one value left to test it"
    if p_value is None:
        return text
    one = rows == 1
    if not contradicts:
        them = "it" if one else "them"
        p = p_in_words(p_value)
        return f"{text}; the declared model with its uncertain values does not contradict {them} ({p})"
    they, verb = ("it", "contradicts") if one else ("they", "contradict")
    would = f"; {they} would not with {' or '.join(hints)}" if hints else ""
    return f"{text}; yet {they} {verb} the declared model and its uncertain values ({p_in_words(p_value)}){would}"
