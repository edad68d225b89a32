"""Model updating: correct many parameters of a model together, regularised by their priors.

If many values are slightly wrong, none of them is *the* cause, and searching for one would be misleading.  The update
is the maximum a posteriori model given the measurements and all priors (Friswell and Mottershead, Finite Element
Model Updating in Structural Dynamics, 1995, chapter 8).  It reports for every parameter how far the data moved it and
how much of its prior variance they removed, and how well held-out setups are predicted.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from pkmodes.core.base.arguments import is_all
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.arguments import checked_structure
from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.solver import correlation
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.one_state import split_setups
from pkmodes.loop.diagnosis.problem import Candidate, Structure, reached_bounds
from pkmodes.loop.diagnosis.readings.amplitude import notes_on_amplitude
from pkmodes.loop.diagnosis.readings.table import (
    answer_for_declared_model,
    answer_for_final_fit,
    reading_remarks,
)
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.notes import notes
from pkmodes.loop.diagnosis.verdict.rows import Error, Row
from pkmodes.loop.measured.measurements import Measurements

#: Largest number of rounds in which the scatter of shapes without a stated error is estimated.
MAX_ROUNDS = 4
#: The scatter has converged if it changes by less than this, relatively.
SCATTER_TOLERANCE = 0.02


@dataclass(frozen=True)
class Updated:
    """One parameter of an update.

    - prior_sigma, sigma: standard deviations before and after, in the parameter's unit
    - resolution: part of the prior variance that the data removed, 1 - (sigma / prior_sigma)^2: near 1 the data
      determine the value, near 0 only the prior does
    - moved: change of the value in standard deviations of the prior
    """

    name: str
    unit: str
    before: float
    after: float
    prior_sigma: float
    sigma: float
    resolution: float
    moved: float
    at_bound: bool


@dataclass(frozen=True)
class Update:
    """The result of an update.

    Attributes
    ----------
    parameters : tuple of Updated
        In the order of the structure.
    correlation : ndarray, shape (k, k)
        Posterior correlation of the parameters.
    before, after : Error
        Errors of the frequencies of fitted and of held-out rows, and chi-square per degree of freedom.
    p_value : float
        p-value of the residual, given stated errors and priors.
    held_out_poses : tuple of str
    rows : tuple of Row
        Every measured mode with its predictions before and after (`refit` and `after` are the same).
    shape_scatter : float or None
        Scatter of the shapes without a stated error, relative to the largest component.
    notes : tuple of str
        Notes on the data and the update.
    """

    parameters: tuple[Updated, ...]
    correlation: np.ndarray
    before: Error
    after: Error
    p_value: float
    held_out_poses: tuple[str, ...]
    rows: tuple[Row, ...]
    shape_scatter: float | None
    notes: tuple[str, ...]

    @property
    def values(self) -> dict[str, float]:
        """Updated values by name."""
        return {p.name: p.after for p in self.parameters}


def update(
    structure: Structure,
    data: Measurements,
    parameters: Sequence[str] | None = None,
    *,
    holdout: Sequence[str] | None = None,
    criteria: Criteria | None = None,
) -> Update:
    """Update parameters of a model together.

    Parameters
    ----------
    structure : Structure
        At the setups of the measurements.  Each parameter needs a prior: its own ``sigma``, or that of a candidate.
    data : Measurements
        Identified modes of these setups.
    parameters : sequence of str, optional
        Names of the parameters that may change; by default all that have a prior.
    holdout : sequence of str, optional
        Labels of held-out setups; by default one in six.
    criteria : Criteria, optional
        Thresholds.

    Returns
    -------
    Update
        The values before and after, and the error before and after.

    Raises
    ------
    PkmodesError
        If a name is unknown or has no prior, nothing could change, or the model cannot be evaluated.
    """
    structure = checked_structure(structure, data)
    fitted, held_out = split_setups(data, holdout)
    fitter = Fitter(structure.subset(fitted), data.at(fitted), criteria)
    indices = _parameter_indices(fitter, parameters)
    fitter, fit = _fit_with_scatter(fitter, indices)
    store, setups = FitStore(fitter), AllSetups(structure, data, fitter, held_out)
    no_outliers = np.zeros(len(data.lines), dtype=bool)
    declared_stage, updated_stage = setups.stage(fitter.declared), setups.stage(fit.values)
    squares, degrees = store.frequency_misfit(fit)
    updated = tuple(_updated_parameter(fitter, fit, i) for i in indices)
    messages = [
        *answer_for_declared_model(fitter),
        *answer_for_final_fit(fitter, fit),
        *reading_remarks(setups.stage(fit.values), fitter.criteria.readings),
        *notes_on_amplitude(fitter, fit.values),
    ]
    held_by_prior = [p.name for p in updated if p.resolution < 0.05]
    if held_by_prior:
        priors = "only its prior does" if len(held_by_prior) == 1 else "only their priors do"
        messages.append(f"these data do not determine {', '.join(held_by_prior)}: {priors}")
    if stats.chi2.sf(squares, max(degrees, 1.0)) < fitter.criteria.gate.surely:
        messages.append("the residual still exceeds the stated errors: something else is missing")
    return Update(
        parameters=updated,
        correlation=correlation(fit.covariance_of(indices)),
        before=setups.declared_error(declared_stage, no_outliers),
        after=setups.error(updated_stage, squares, degrees, no_outliers),
        p_value=store.p_value(fit),
        held_out_poses=setups.held_out_poses,
        rows=setups.rows(declared_stage, updated_stage, updated_stage, no_outliers),
        shape_scatter=store.shape_scatter(fit),
        notes=(*messages, *notes(store, fit, adequate=False)),
    )


def _parameter_indices(fitter: Fitter, parameters: Sequence[str] | None) -> list[int]:
    names = [p.name for p in fitter.parameters]
    if is_all(parameters):
        parameters = None
    if isinstance(parameters, str):
        problem = f"expected a list of names, found {shown(parameters)}"
        raise PkmodesError(problem, "parameters", f"write [{shown(parameters)}]")
    for name in parameters or ():
        if name not in names:
            problem = f"there is no parameter {shown(name)}"
            raise PkmodesError(problem, "parameters", f"parameters are: {', '.join(names)}")
        if fitter.priors.row_of(names.index(name)) is None:
            problem = f"the parameter {shown(name)} has no prior"
            remedy = "give it a sigma: an update needs the plausible error of each value"
            raise PkmodesError(problem, "parameters", remedy)
    indices = [i for i, name in enumerate(names) if parameters is None or name in parameters]
    indices = [i for i in indices if fitter.priors.row_of(i) is not None]
    if not indices:
        raise PkmodesError(
            "no parameter has a prior", "parameters", "give a sigma to the parameters that may change"
        )
    return indices


def _fit_with_scatter(fitter: Fitter, indices: Sequence[int]) -> tuple[Fitter, Fit]:
    """Fit all chosen parameters, with the shape scatter estimated from the residual if none is stated."""
    names = tuple(fitter.parameters[i].name for i in indices)
    # Nuisance parameters that were not chosen stay at their declared values.
    parameters = tuple(p if p.name in names else replace(p, sigma=None) for p in fitter.parameters)
    c, scatter, start = fitter.criteria, fitter.shape_scatter, None
    hypothesis = Hypothesis((Candidate("update", names),))
    rounds = MAX_ROUNDS
    while True:
        fitter = Fitter(fitter.structure, fitter.data, c, scatter, parameters=parameters)
        fit = fitter.fit(hypothesis, start)
        if fit is None:
            problem = "the model cannot be evaluated with its declared values"
            raise PkmodesError(problem, fitter.data.source, "check the parameters and the setups")
        estimate, start, rounds = FitStore(fitter).shape_scatter(fit), fit.values, rounds - 1
        if estimate is None or not rounds:
            return fitter, fit
        scatter = float(np.clip(estimate, c.shapes.least_scatter, c.shapes.most_scatter))
        if abs(scatter / fitter.shape_scatter - 1.0) < SCATTER_TOLERANCE:
            return fitter, fit


def _updated_parameter(fitter: Fitter, fit: Fit, i: int) -> Updated:
    p, row, sigma = fitter.parameters[i], fitter.priors.row_of(i), fit.sigma_of(i)
    assert row is not None
    prior = float(fitter.priors.sigmas_in_units(fit.values)[row])
    return Updated(
        name=p.name,
        unit=p.unit,
        before=p.value,
        after=float(fit.values[i]),
        prior_sigma=prior,
        sigma=min(sigma, prior),
        resolution=max(1.0 - (sigma / prior) ** 2, 0.0),
        moved=float(fitter.priors.distances(fit.values)[row]),
        at_bound=bool(reached_bounds(p, fit.values[i], prior)),
    )
