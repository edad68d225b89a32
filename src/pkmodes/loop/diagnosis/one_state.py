"""Diagnose a model from the measured modes of one state of a machine.

1. `match` pairs measured modes with modes of the model.
2. `fit` refits the nuisance parameters within their priors, to frequencies and shapes.
3. `search` tests in the gate whether the residual is noise, and if not, looks for a cause or pair that explains it.
4. `verdict` asks its rules, some before the search, of measurement mistakes, rivals, classes, errors instead of
   causes, shapes, stability and held-out setups, and assembles the result.
5. `damping` asks, at the final model, which joint dissipates, where damping was measured.
"""

from __future__ import annotations

import difflib
from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.arguments import checked
from pkmodes.loop.diagnosis.beyond.explore import TermSearch, with_beyond
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.damping.diagnose_damping import with_damping
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.matrices import slowness
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
HELD_OUT = 6
#: Largest number of measured modes that are diagnosed: this takes some minutes, and a third of a megabyte per mode.
MOST = 10_000


def diagnosed(
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
    structure = checked(structure, data)
    if (count := len(data.frequency)) > MOST:
        problem = f"expected at most {MOST:,} measured modes to diagnose, found {count:,}"
        remedy = (
            f"keep one pose in {-(-count // MOST)}: the others add little information; compare takes them all"
        )
        raise PkmodesError(problem, data.source, remedy)
    first = _of_frequencies(structure, data, holdout, progress, criteria, terms)
    return with_damping(structure, data, first, criteria)


def _of_frequencies(
    structure: Structure,
    data: Measurements,
    holdout: Sequence[str] | None,
    progress: Progress | None,
    criteria: Criteria | None,
    terms: bool,
) -> Diagnosis:
    """Return the diagnosis of the frequencies and shapes."""
    if progress is not None and (remark := slowness(structure)):
        progress(remark)
    fitted, held = split(data, holdout)
    fitter = Fitter(structure.subset(fitted), data.at(fitted), criteria)
    start = Start(AllSetups(structure, data, fitter, held))
    builder, early = DiagnosisBuilder(start.setups), decide_before_search(start)
    if early is not None:
        return builder.before_search(start, early)
    search, outcome = _searched(start.store, structure, progress)
    if outcome is None:
        problem = "the model cannot be evaluated with its declared values"
        raise PkmodesError(problem, data.source, "check the poses and the robot file")
    if not (terms and isinstance(structure, Extensible)):
        evidence = Evidence(start.setups, search, outcome)
        return builder.after_search(evidence, decide(evidence))
    beyond = TermSearch(structure, held, progress)
    evidence = Evidence(start.setups, search, outcome, term_instead=beyond.instead)
    decision = decide(evidence)
    result = builder.after_search(evidence, decision)
    return with_beyond(result, beyond.after(evidence, decision), evidence)


def split(data: Measurements, holdout: Sequence[str] | None) -> tuple[list[int], list[int]]:
    """Return the indices of the fitted and of the held-out setups (by default one in six, evenly spread)."""
    count = len(data.labels)
    if holdout is None:
        number = count // HELD_OUT
        held = sorted({int((k + 0.5) * count / number) for k in range(number)})
    else:
        if isinstance(holdout, str) or not all(isinstance(label, str) for label in holdout):
            problem = f"expected a list of labels to hold out, found {shown(holdout)}"
            remedy = f"write [{shown(holdout)}]" if isinstance(holdout, str) else "give labels as strings"
            raise PkmodesError(problem, "holdout", remedy)
        unknown = [label for label in holdout if label not in data.labels]
        if unknown:
            nearest = difflib.get_close_matches(unknown[0], data.labels, n=1)
            listed = ", ".join(data.labels[:10]) + (", ..." if count > 10 else "")
            remedy = f'did you mean "{nearest[0]}"?' if nearest else f"labels are: {listed}"
            raise PkmodesError(f"no pose is called {shown(unknown[0])}", "holdout", remedy)
        held = sorted({data.labels.index(label) for label in holdout})
    fitted = [i for i in range(count) if i not in held]
    if not fitted:
        raise PkmodesError("every pose is held out", "holdout", "leave some poses to fit")
    return fitted, held


def _searched(
    plain: FitStore, structure: Structure, progress: Progress | None
) -> tuple[Search, Outcome | None]:
    """Search, with the shape scatter estimated from the best of all explanations if none is stated.

    - plain: with the fit of the declared model
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
        best = min((estimate for estimate in scatters if estimate is not None), default=None)
        # If nothing explains even the frequencies, a smaller shape scatter changes nothing.
        hopeless = all(search.store.frequency_p_value(fit) <= c.gate.surely for fit in search.store.tried())
        if (
            hopeless
            or best is None
            or max(best, c.shapes.least_scatter) >= c.shapes.sharper * fitter.shape_scatter
        ):
            return search, outcome
        scatter = best
