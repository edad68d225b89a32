"""Changes between states of one machine, diagnosed from the differences of their measurements.

The first state is trusted.  Uncertain values are fitted to it, and the residual is the error of the model, which the
other states share (`shared_errors`).  With that error removed, a later state is diagnosed as any machine is: its
candidates are what may have changed.  Poses of a later state are held out, never a state as a whole.
"""

from __future__ import annotations

import copy
import difflib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import TypeVar

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.arguments import checked_structure
from pkmodes.loop.diagnosis.criteria import Criteria, of_changes
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.one_state import diagnose_one_state
from pkmodes.loop.diagnosis.problem import Array, Structure
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.states.result import Change, Counterpart, change_from_difference, merge_changes
from pkmodes.loop.diagnosis.states.shared_errors import (
    FittedValues,
    SharedErrors,
    shared_errors,
    without_shared_errors,
)
from pkmodes.loop.measured.measurements import Measurements

S = TypeVar("S", bound=Structure)


@dataclass(frozen=True, eq=False)
class TrustedState:
    """The trusted state, with the model fitted to it.

    - fitter: fits hypotheses to the measurements of this state
    - fit: fit of the uncertain values
    """

    name: str
    fitter: Fitter
    fit: Fit

    @classmethod
    def of(
        cls, name: str, structure: Structure, data: Measurements, criteria: Criteria | None = None
    ) -> TrustedState:
        """Fit the uncertain values of a structure to the trusted state.

        Raises PkmodesError if the structure cannot be evaluated.
        """
        fitter = Fitter(structure, data, criteria)
        fit = FitStore(fitter).fit(Hypothesis())
        if fit is None:
            problem = "the model cannot be evaluated with its declared values"
            raise PkmodesError(problem, data.source, "check the poses and the model")
        return cls(name, fitter, fit)

    @property
    def values(self) -> dict[str, float]:
        """Fitted uncertain values, by name."""
        return {
            self.fitter.parameters[i].name: float(self.fit.values[i]) for i in self.fitter.nuisance_indices
        }

    @property
    def shape_error(self) -> float:
        """Standard deviation of the components of shapes by which the model differs from the trusted state."""
        misfit = self.fitter.misfit(self.fit, SHAPE, stated=True)
        sigma = self.fitter.data.shape_sigma
        if misfit.degrees <= 0.0 or np.isnan(sigma).all():
            return FitStore(self.fitter).shape_scatter(self.fit) or 0.0
        return float(np.sqrt(np.nanmean(sigma**2) * misfit.ratio))

    @property
    def model_error(self) -> float:
        """Root mean square of the relative error of the model as declared."""
        pairing, residual, *_ = self.fitter.evaluate(self.fitter.declared, self.fitter.observations.all_rows)
        return _rms(residual[pairing.partner >= 0])

    @property
    def remaining_error(self) -> float:
        """Root mean square of the relative error of the model with its values fitted."""
        return _rms(
            self.fit.residual[self.fitter.observations.frequency_slice][self.fit.pairing.partner >= 0]
        )

    def diagnose_change(
        self,
        name: str,
        structure: Structure,
        data: Measurements,
        *,
        holdout: Sequence[str] | None = None,
        progress: Progress | None = None,
        criteria: Criteria | None = None,
        terms: bool = False,
    ) -> Change:
        """Return what changed from the trusted state to another one.

        - structure: at the setups of that state, with the values of the trusted one; its candidates are what may have
          changed

        Raises PkmodesError if both states have no mode in common, were measured under other conditions, or have the
        same rows.
        """
        self._check(name, data)
        nuisances = tuple(self.fitter.nuisance_indices)
        names = tuple(self.fitter.parameters[i].name for i in nuisances)
        fitted_values = FittedValues(names, self.fit.covariance_of(nuisances))
        shared = shared_errors(self.fitter, self.fit.values, structure, data, self.shape_error, fitted_values)
        if not shared.measured_before.any():
            problem = f"no mode of {shown(name)} was measured in {shown(self.name)}"
            remedy = "measure modes at poses that both states have"
            raise PkmodesError(problem, data.source, remedy)
        corrected = without_shared_errors(data, shared)
        result = diagnose_one_state(
            structure,
            corrected,
            holdout=holdout,
            progress=progress,
            criteria=of_changes(criteria or Criteria()),
            terms=terms,
        )
        trusted_data = self.fitter.data
        counterparts = tuple(
            Counterpart(
                int(trusted_data.lines[row]),
                float(trusted_data.frequency[row]),
                float(trusted_data.sigma[row]),
            )
            if row >= 0
            else None
            for row in shared.counterpart.tolist()
        )
        change = change_from_difference(
            result, (self.name, name), data, shared, counterparts, self.model_error
        )
        return replace(change, notes=(*change.notes, *self._notes(name, data, shared)))

    def _check(self, name: str, data: Measurements) -> None:
        """Refuse the trusted state itself, and one that was measured only with the motors in another state."""
        trusted = self.fitter.data
        if data.frequency.shape == trusted.frequency.shape and np.array_equal(
            data.frequency, trusted.frequency
        ):
            problem = (
                f"{shown(self.name)} and {shown(name)} have the same frequencies: they are one measurement"
            )
            raise PkmodesError(problem, data.source, "give the measurement of the other state")
        if not {*data.drives} & {*trusted.drives}:
            trusted_drives, later_drives = trusted.drives[0], data.drives[0]
            problem = (
                f"the motors were {trusted_drives} in {shown(self.name)}, and {later_drives} in {shown(name)}"
            )
            raise PkmodesError(problem, data.source, "compare measurements with the motors in the same state")

    def _notes(self, name: str, data: Measurements, shared: SharedErrors) -> list[str]:
        """Return how the states were compared."""
        rows, compared_count = len(shared.offset), int(shared.compared.sum())
        declared_error, remaining_error = (
            f"{plain(100 * error, 2)} %" for error in (self.model_error, self.remaining_error)
        )
        notes = [
            f"the declared model differs from {self.name} by {declared_error} (rms); its values are "
            f"fitted to {self.name}, and the remaining {remaining_error} is subtracted from {name} too: "
            "standard deviations are those of the difference"
        ]
        if compared_count < rows:
            notes.append(
                f"{rows - compared_count} of {rows} rows of {name} have no counterpart at the same pose in "
                f"{self.name}: the error of the model is less certain there, and their standard deviations are larger"
            )
        if not np.isnan(data.damping).all():
            notes.append("damping ratios of two states are not compared")
        return notes


def _rms(values: Array) -> float:
    return float(np.sqrt(np.mean(values**2))) if len(values) else float("nan")


def diagnose_changes(
    structure: Structure,
    data: Measurements,
    states: Mapping[str, str],
    *,
    holdout: Sequence[str] | None = None,
    progress: Progress | None = None,
    criteria: Criteria | None = None,
    terms: bool = False,
) -> Change:
    """Return what changed between states of any structure, as `pkmodes.diagnosis.diagnose` does.

    Raises PkmodesError also if a setup has no state, or there is only one state.
    """
    structure = checked_structure(structure, data)
    trusted, setups_of_later_states = setups_by_state(data, states)
    name, setups = trusted
    trusted_state = TrustedState.of(name, structure.subset(setups), data.at(setups), criteria)
    changes = {}
    for state, later_setups in setups_of_later_states.items():
        fitted_structure = with_known_values(structure.subset(later_setups), trusted_state.values)
        held_out_labels = (
            None if holdout is None else [label for label in holdout if states.get(label) == state]
        )
        changes[state] = trusted_state.diagnose_change(
            state,
            fitted_structure,
            data.at(later_setups),
            holdout=held_out_labels,
            progress=progress,
            criteria=criteria,
            terms=terms,
        )
    return merge_changes(name, changes)


def with_known_values(structure: S, values: Mapping[str, float]) -> S:
    """Return a structure in which some uncertain values are known."""
    copied = copy.copy(structure)
    copied.parameters = tuple(  # type: ignore[misc]
        replace(p, value=values[p.name], sigma=None, correlated=()) if p.name in values else p
        for p in structure.parameters
    )
    return copied


def setups_by_state(
    data: Measurements, states: Mapping[str, str]
) -> tuple[tuple[str, list[int]], dict[str, list[int]]]:
    """Return the trusted state and the others, each with its setups.

    Raises PkmodesError if the states are not a mapping, lack a measured setup, or are only one.
    """
    example = '{"P1": "before", "P1 again": "after"}'
    if not isinstance(states, Mapping) or not all(
        isinstance(entry, str) and entry for pair in states.items() for entry in pair
    ):
        problem = f"expected a mapping of setups to states, found {shown(states)}"
        raise PkmodesError(problem, "states", f"write for example {example}")
    for label in states:
        if label not in data.labels:
            nearest_labels = difflib.get_close_matches(label, data.labels, n=1)
            remedy = (
                f'did you mean "{nearest_labels[0]}"?'
                if nearest_labels
                else f"measured: {', '.join(data.labels[:10])}"
            )
            raise PkmodesError(f"no setup is called {shown(label)}", "states", remedy)
    missing_labels = [label for label in data.labels if label not in states]
    if missing_labels:
        problem = f"the setup {shown(missing_labels[0])} has no state"
        raise PkmodesError(problem, "states", "give the state of every measured setup")
    setups_of: dict[str, list[int]] = {state: [] for state in states.values()}
    for i, label in enumerate(data.labels):
        setups_of[states[label]].append(i)
    (name, setups), *later = setups_of.items()
    if not later:
        problem = f"expected two states or more, found {shown(name)} only"
        raise PkmodesError(problem, "states", "leave states out, or give the setups of the other state")
    return (name, setups), dict(later)
