"""Diagnose a model from measured modes of one state of a machine, or of several of which the first is trusted."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.one_state import diagnose_one_state
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.states.changes import diagnose_changes
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements


def diagnose(
    structure: Structure,
    data: Measurements,
    *,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
    criteria: Criteria | None = None,
    terms: bool = False,
    states: Mapping[str, str] | None = None,
) -> Diagnosis:
    """Find what a model lacks, or what changed between states of the machine.

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
        Thresholds.  The error rates in docs/reference/results.md hold for the default ones.
    terms : bool, optional
        Whether a structure that is extensible, such as a `MatrixStructure`, is tried with terms, one thing at one
        place, where the candidates do not explain the measurements.
    states : mapping of str to str, optional
        State of the machine in each setup, by label; the first one is trusted.  The candidates are then what may
        have changed in another state.  Uncertain values and errors of the model are those of the trusted state, and
        no state is held out as a whole.

    Returns
    -------
    Diagnosis
        The verdict with its reason, the causes, and the error before and after.

    Raises
    ------
    PkmodesError
        If a label is unknown, no setup is left to fit, the model cannot be evaluated as declared, there are more
        than 10,000 measured modes, or states have no mode in common.
    """
    if states is None:
        return diagnose_one_state(
            structure, data, holdout=holdout, progress=progress, criteria=criteria, terms=terms
        )
    return diagnose_changes(
        structure, data, states, holdout=holdout, progress=progress, criteria=criteria, terms=terms
    )
