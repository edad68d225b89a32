"""Diagnose a model by measured modes."""

from __future__ import annotations

import difflib
from collections.abc import Sequence

from pkmodes.diagnosis.fitting import Fitter
from pkmodes.diagnosis.matrices import at_measured
from pkmodes.diagnosis.problem import Structure
from pkmodes.diagnosis.report import Report
from pkmodes.diagnosis.result import Diagnosis
from pkmodes.diagnosis.search import Progress, Search
from pkmodes.errors import PkmodesError, shown
from pkmodes.measured.measurements import Measurements

#: Measured modes beyond the uncertain parameters: one for a cause, and one to test it with.
LEAST = 2
#: One pose in so many is held out by default.
HELD_OUT = 6


def diagnose(
    structure: Structure,
    data: Measurements,
    *,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
) -> Diagnosis:
    """Find what a model lacks.

    Parameters
    ----------
    structure : Structure
        At the setups of the measurements.
    data : Measurements
    holdout : sequence of str, optional
        Labels of setups that take no part in any choice or fit.
    progress : callable, optional
        Called with a sentence at each step.

    Returns
    -------
    Diagnosis

    Raises
    ------
    PkmodesError
        If a label is unknown, or nothing is left to fit.
    """
    structure = at_measured(structure, data.labels)
    fitted, held = split(data, holdout)
    fitter = Fitter(structure.subset(fitted), data.at(fitted))
    search = Search(fitter, structure.candidates, progress)
    report = Report(structure, data, fitter, search, fitted, held)
    if len(fitter.log) < len(fitter.nuisances) + LEAST:
        return report.insufficient()
    outcome = search.run()
    if outcome is None:
        what = "the model cannot be evaluated with its declared values"
        raise PkmodesError(what, data.source, "check the poses and the robot file")
    return report.of(outcome)


def split(data: Measurements, holdout: Sequence[str] | None) -> tuple[list[int], list[int]]:
    """Indices of the setups that are fitted, and of those held out (by default one in six, spread evenly)."""
    count = len(data.labels)
    if holdout is None:
        number = count // HELD_OUT
        held = sorted({int((k + 0.5) * count / number) for k in range(number)})
    else:
        unknown = [label for label in holdout if label not in data.labels]
        if unknown:
            nearest = difflib.get_close_matches(unknown[0], data.labels, n=1)
            some = ", ".join(data.labels[:10]) + (", ..." if count > 10 else "")
            remedy = f'did you mean "{nearest[0]}"?' if nearest else f"labels are: {some}"
            raise PkmodesError(f"no pose is called {shown(unknown[0])}", data.source, remedy)
        held = sorted({data.labels.index(label) for label in holdout})
    fitted = [i for i in range(count) if i not in held]
    if not fitted:
        raise PkmodesError("every pose is held out", data.source, "leave some poses to fit")
    return fitted, held
