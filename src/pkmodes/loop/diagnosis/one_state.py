"""Diagnose a model from the measured modes of one state of a machine.

1. `match` pairs measured modes with modes of the model.
2. `fit` refits the nuisance parameters within their priors, to frequencies and shapes.
3. `search` tests in the gate whether the residual is noise, and if not, looks for a cause or pair that explains it.
4. `verdict` applies its rules, some of them before the search, on measurement mistakes, rivals, classes, errors
   instead of causes, shapes, stability and held-out setups, and assembles the result.
5. `damping` determines at the final model which joint dissipates, where damping was measured.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.arguments import checked_structure
from pkmodes.loop.diagnosis.beyond.explore import TermSearch, with_term_result
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping.diagnose_damping import add_damping_diagnosis
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.matrices import slow_call_remark
from pkmodes.loop.diagnosis.problem import Extensible, Structure
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.builder import DiagnosisBuilder
from pkmodes.loop.diagnosis.verdict.evidence import Evidence, Start
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.diagnosis.verdict.rules import decide, decide_before_search
from pkmodes.loop.measured.measurements import Measurements

#: By default, one in this many poses is held out.
POSES_PER_HELD_OUT = 6
#: Largest number of measured modes that are diagnosed: this takes some minutes, and a third of a megabyte per mode.
MAX_MODES = 10_000


def diagnose_one_state(
    structure: Structure,
    data: Measurements,
    *,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
    criteria: Criteria | None = None,
    terms: bool = False,
) -> Diagnosis:
    """Find what a model lacks, as `diagnose` does where all setups are of one state.

    Raises PkmodesError if a label is unknown, no setup is left to fit, the model cannot be evaluated as declared, or
    there are more than 10,000 measured modes.
    """
    structure = checked_structure(structure, data)
    if (count := len(data.frequency)) > MAX_MODES:
        problem = f"expected at most {MAX_MODES:,} measured modes to diagnose, found {count:,}"
        poses_per_kept = -(-count // MAX_MODES)
        remedy = (
            f"keep one pose in {poses_per_kept}: the others add little information; compare takes them all"
        )
        raise PkmodesError(problem, data.source, remedy)
    frequency_diagnosis = _diagnose_frequencies(structure, data, holdout, progress, criteria, terms)
    return add_damping_diagnosis(structure, data, frequency_diagnosis, criteria)


def _diagnose_frequencies(
    structure: Structure,
    data: Measurements,
    holdout: Sequence[str] | None,
    progress: Progress | None,
    criteria: Criteria | None,
    terms: bool,
) -> Diagnosis:
    """Return the diagnosis of the frequencies and shapes."""
    if progress is not None and (remark := slow_call_remark(structure)):
        progress(remark)
    fitted, held_out = split_setups(data, holdout)
    fitter = Fitter(structure.subset(fitted), data.at(fitted), criteria)
    start = Start(AllSetups(structure, data, fitter, held_out))
    builder, early_decision = DiagnosisBuilder(start.setups), decide_before_search(start)
    if early_decision is not None:
        return builder.before_search(start, early_decision)
    search, outcome = _search_causes(start.store, structure, progress)
    if outcome is None:
        problem = "the model cannot be evaluated with its declared values"
        raise PkmodesError(problem, data.source, "check the poses and the robot file")
    if not (terms and isinstance(structure, Extensible)):
        evidence = Evidence(start.setups, search, outcome)
        return builder.after_search(evidence, decide(evidence))
    term_search = TermSearch(structure, held_out, progress)
    evidence = Evidence(start.setups, search, outcome, term_instead=term_search.replacement_fit)
    decision = decide(evidence)
    result = builder.after_search(evidence, decision)
    return with_term_result(result, term_search.evidence_after(evidence, decision), evidence)


def split_setups(data: Measurements, holdout: Sequence[str] | None) -> tuple[list[int], list[int]]:
    """Return the indices of the fitted and of the held-out setups (by default one in six, evenly spread)."""
    setup_count = len(data.labels)
    if holdout is None:
        held_out_count = setup_count // POSES_PER_HELD_OUT
        held_out = sorted({int((k + 0.5) * setup_count / held_out_count) for k in range(held_out_count)})
    else:
        if isinstance(holdout, str) or not all(isinstance(label, str) for label in holdout):
            problem = f"expected a list of labels to hold out, found {shown(holdout)}"
            remedy = f"write [{shown(holdout)}]" if isinstance(holdout, str) else "give labels as strings"
            raise PkmodesError(problem, "holdout", remedy)
        unknown = [label for label in holdout if label not in data.labels]
        if unknown:
            nearest_labels = difflib.get_close_matches(unknown[0], data.labels, n=1)
            label_list = ", ".join(data.labels[:10]) + (", ..." if setup_count > 10 else "")
            remedy = f'did you mean "{nearest_labels[0]}"?' if nearest_labels else f"labels are: {label_list}"
            raise PkmodesError(f"no pose is called {shown(unknown[0])}", "holdout", remedy)
        held_out = sorted({data.labels.index(label) for label in holdout})
    fitted = [i for i in range(setup_count) if i not in held_out]
    if not fitted:
        raise PkmodesError("every pose is held out", "holdout", "leave some poses to fit")
    return fitted, held_out


def _search_causes(
    declared_store: FitStore, structure: Structure, progress: Progress | None
) -> tuple[Search, Outcome | None]:
    """Search, with the shape scatter estimated from the best of all explanations if none is stated.

    - declared_store: contains the fit of the declared model
    """
    fitter = declared_store.fitter
    c, declared_fit = fitter.criteria, declared_store.fit(Hypothesis())
    scatter = None if declared_fit is None else declared_store.shape_scatter(declared_fit)
    store = declared_store
    while True:
        if scatter is not None:
            bounded_scatter = float(np.clip(scatter, c.shapes.least_scatter, c.shapes.most_scatter))
            fitter = Fitter(fitter.structure, fitter.data, c, bounded_scatter)
            store = FitStore(fitter, store)
        search = Search(store, structure.candidates, progress)
        outcome = search.run()
        scatters = [search.store.shape_scatter(fit) for fit in search.store.all_fits()]
        best_scatter = min((estimate for estimate in scatters if estimate is not None), default=None)
        # If nothing explains even the frequencies, a smaller shape scatter changes nothing.
        none_explains_frequencies = all(
            search.store.frequency_p_value(fit) <= c.gate.surely for fit in search.store.all_fits()
        )
        if (
            none_explains_frequencies
            or best_scatter is None
            or max(best_scatter, c.shapes.least_scatter) >= c.shapes.sharper * fitter.shape_scatter
        ):
            return search, outcome
        scatter = best_scatter
