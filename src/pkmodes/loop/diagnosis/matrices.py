"""A structure given by callables for M and K, for any model that is not a robot of this package."""

from __future__ import annotations

import copy
from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np

from pkmodes.core.base.errors import PkmodesError, checked_list, shown
from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.problem import (
    Array,
    Batch,
    Candidate,
    Parameter,
    Prediction,
    Structure,
    predict_one_by_one,
)
from pkmodes.loop.diagnosis.structure.cache import ResultCache
from pkmodes.loop.diagnosis.structure.checks import (
    check_callables,
    check_candidate,
    check_names,
    check_parameter,
    sensor_map,
)
from pkmodes.loop.diagnosis.structure.modes import (
    SetupModes,
    UnstableError,
    UnusableError,
    differentiate_shapes,
    modal_forces,
    setup_modes,
)
from pkmodes.loop.diagnosis.structure.supplied import Derivatives, Matrices, MatrixPair, SuppliedMatrices
from pkmodes.loop.diagnosis.structure.terms import SuppliedWithTerms, coordinate_terms

#: Calls of the callable that take longer than this dominate the time of a diagnosis [s].
SLOW_CALL_SECONDS = 0.02


class _SolvedSetup(NamedTuple):
    """Matrices and modes of one setup."""

    pair: MatrixPair
    modes: SetupModes


class MatrixStructure:
    """A model with mass and stiffness matrices that depend on named parameters.

    Parameters
    ----------
    parameters : sequence of Parameter
        All that can vary: nuisances have a ``sigma``; for candidates, ``value`` is the null value.
    candidates : sequence of Candidate
        Causes that may be missing or wrong.
    matrices : callable
        ``matrices(values, setup) -> (M, K)``, with the values of all parameters by name and the label of a
        setup; both (n, n), real and symmetric, arrays or scipy.sparse matrices, in consistent units (K / M in
        1/s^2); all are solved as dense ones, which suits up to some 60 coordinates.  M may be singular if K is
        positive definite for the motions without inertia; these are condensed exactly.  If the matrices are not
        finite, the values cannot be evaluated, and a fit avoids them; an exception at any values within the bounds
        is an error.  The matrices must be reproducible; they are cached while there is memory for them.
    channels : sequence of str
        Names allowed for the shape columns of the measurements: those of the n coordinates, some of
        `coordinates`, or one name for each row of `sensors`.
    coordinates : sequence of str, optional
        Names of the n coordinates, if the channels are some of them.
    sensors : array_like or sparse matrix, shape (C, n), optional
        Motion of each channel for unit motions of the coordinates, if the channels are not coordinates.
    derivatives : callable, optional
        ``derivatives(values, setup, name) -> (dM, dK)`` with respect to the named parameter.  By default differences
        of the matrices are used, with a step that changes them by about a millionth, whatever the unit.
    setups : sequence of str
        Labels of the setups, as in the measurements, in any order; by default there is one setup with any label.
    rigid : int
        Number of rigid-body modes, which are not measured.  All other modes must be stable.
    modes : int, optional
        Number of modes that are compared, the lowest, rigid ones included; by default all.
    units : tuple of two str
        Units of M and K, in which masses and springs at its coordinates are reported (`with_terms`).

    Raises
    ------
    PkmodesError
        If names are repeated or missing, numbers contradict each other, or the matrices do not have the form
        above; also from `predict`, if they violate it at other values.
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
        matrices: Matrices,
        *,
        channels: Sequence[str],
        coordinates: Sequence[str] | None = None,
        sensors: Any = None,
        derivatives: Derivatives | None = None,
        setups: Sequence[str] = ("",),
        rigid: int = 0,
        modes: int | None = None,
        units: tuple[str, str] = ("kg", "N/m"),
    ) -> None:
        self.parameters: tuple[Parameter, ...] = tuple(
            checked_list(parameters, "parameters", "parameters", 'Parameter("k", 1e6)', Parameter)
        )
        self.candidates: tuple[Candidate, ...] = tuple(
            checked_list(candidates, "candidates", "candidates", 'Candidate("k", ("k",), "")', Candidate)
        )
        self.channels: tuple[str, ...] = tuple(checked_list(channels, "names", "channels", '"x_1"', str))
        self.setups: tuple[str, ...] = tuple(checked_list(setups, "labels", "setups", '"P1"', str))
        check_callables(matrices, derivatives)
        if isinstance(rigid, bool) or not isinstance(rigid, int | np.integer) or rigid < 0:
            problem = f"expected a number of modes, found {shown(rigid)}"
            raise PkmodesError(problem, "rigid", "give the number of rigid-body modes")
        self.rigid = int(rigid)
        for p in self.parameters:
            check_parameter(p)
        self.modes, self.channel_units = modes, ("",) * len(self.channels)
        for kind, labels in (
            ("parameter", [p.name for p in self.parameters]),
            ("candidate", [c.name for c in self.candidates]),
            ("channel", self.channels),
            ("coordinate", coordinates or ()),
            ("setup", self.setups),
        ):
            check_names(kind, labels)
        for candidate in self.candidates:
            check_candidate(candidate, {p.name: p for p in self.parameters})
        if not isinstance(modes, int | None) or (modes is not None and modes <= rigid):
            problem = f"expected a whole number of modes, more than the {rigid} rigid ones, found {modes}"
            raise PkmodesError(
                problem, "modes", "give the number of measured modes plus the rigid ones, or more"
            )
        unit_pair = checked_list(units, "units", "units", '"kg", "N/m"', str)
        if len(unit_pair) != 2:
            problem = f"expected the units of M and K, found {shown(units)}"
            raise PkmodesError(problem, "units", 'give two, such as ("kg", "N/m")')
        self.units: tuple[str, str] = (unit_pair[0], unit_pair[1])
        self._map = sensor_map(self.channels, coordinates, sensors)
        self._size = len(self.channels) if self._map is None else self._map.shape[1]
        coordinate_numbers = [f"coordinate {i}" for i in range(1, self._size + 1)]
        self.coordinates = tuple(coordinate_numbers if sensors is not None else coordinates or self.channels)
        size_origin = f"{self._size} coordinates" if sensors is None else f"{self._size} columns of sensors"
        supplied = SuppliedMatrices(
            self.parameters,
            matrices,
            derivatives,
            self._size,
            f"{self._size} channels" if self._map is None else size_origin,
        )
        self._supplied: SuppliedMatrices | SuppliedWithTerms = supplied
        self._count = min(self._size, modes or self._size)
        self._solutions: ResultCache[list[_SolvedSetup | None]] = ResultCache()
        self._check(UnusableError)
        for setup in self.setups[:1]:
            supplied.check_repeatable(setup)

    def with_terms(self) -> MatrixStructure:
        """Return the structure with a mass at each coordinate, and springs to ground and between two of them.

        They are ``mass:NAME``, ``spring:NAME`` and ``spring:NAME/NAME`` with the names of the coordinates, which are
        numbered if `sensors` are given: ``mass:coordinate 3``.  Where a parameter or a candidate has such a name
        already, there is no term of that name.
        """
        if isinstance(self._supplied, SuppliedWithTerms):
            return self
        used_names = {*(p.name for p in self.parameters), *(candidate.name for candidate in self.candidates)}
        terms = list(coordinate_terms(self.coordinates, self.units, used_names))
        extended = copy.copy(self)
        extended._supplied, extended._solutions = SuppliedWithTerms(self._supplied, terms), ResultCache()
        extended.parameters = (*self.parameters, *(term.parameter for term in terms))
        extended.candidates = (*self.candidates, *(term.candidate for term in terms))
        return extended

    def subset(self, setups: Sequence[int]) -> MatrixStructure:
        """Return the same structure in some of its setups."""
        subset = copy.copy(self)
        subset.setups, subset._solutions = tuple(self.setups[i] for i in setups), ResultCache()
        return subset

    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Return the modes in all setups, with derivatives with respect to some of the parameters."""
        solutions = self._solve_setups(values)
        solved_setups = {setup: s for setup, s in zip(self.setups, solutions, strict=True) if s is not None}
        count = min((len(s.modes.eigenvalues) for s in solved_setups.values()), default=self._count)
        count = min(count, self._count)
        size = (len(self.setups), count)
        eigenvalues, rates = np.full(size, np.nan), np.full((*size, len(by)), np.nan)
        shapes = np.zeros((*size, len(self.channels)))
        channel_rates = np.full((*shapes.shape, len(by)), np.nan) if shape_rates else None
        pairs = {setup: s.pair for setup, s in solved_setups.items()}
        matrix_rates = [self._supplied.rates(values, i, pairs) for i in by] if solved_setups else []
        for row, (setup, solution) in enumerate(solved_setups.items()):
            k = self.setups.index(setup)
            changes = [
                None if parameter_rates is None else parameter_rates[row] for parameter_rates in matrix_rates
            ]
            eigenvalues[k] = solution.modes.eigenvalues[:count]
            shapes[k] = self._at_channels(solution.modes.shapes[:count])
            forces, norm = modal_forces(solution.modes, changes)
            rates[k] = np.einsum("tin,in->it", forces, solution.modes.shapes)[:count]
            if channel_rates is not None:
                shape_changes = differentiate_shapes(solution.pair.K, solution.modes, forces, norm)[:, :count]
                channel_rates[k] = np.moveaxis(self._at_channels(shape_changes), 0, -1)
        return Prediction(eigenvalues, rates, shapes, self.rigid, channel_rates)

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """Return the modes for several sets of values, one by one."""
        return predict_one_by_one(self, values, by, shape_rates=shape_rates)

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> None:
        """Return None: setups have no position."""

    def elsewhere(self, count: int) -> tuple[Array, Structure] | None:
        """Return None: no other setups are known."""

    @property
    def seconds_per_call(self) -> float:
        """Mean time of a call for M and K [s]."""
        return self._supplied.seconds / max(self._supplied.calls, 1)

    def check_stable(self) -> None:
        """Refuse a structure that is not stable with its declared values.

        Raises
        ------
        PkmodesError
            For the first setup in which it is unstable.
        """
        self._check(UnstableError)

    def _check(self, kind: type[UnusableError]) -> None:
        """Refuse matrices without modes at the declared values."""
        declared = np.array([p.value for p in self.parameters])
        for setup in self.setups:
            pair = self._supplied.evaluate(declared, setup, finite=True)
            try:
                setup_modes(pair, self.rigid)
            except UnusableError as error:
                if isinstance(error, UnstableError) and kind is not UnstableError:
                    continue
                problem = f"the model cannot be evaluated with its declared values: {error.what}"
                raise PkmodesError(problem, f"{error.where} for setup {shown(setup)}", error.remedy) from None

    def _at_channels(self, shapes: Array) -> Array:
        """Return shapes (..., n) at the channels."""
        return shapes if self._map is None else shapes @ self._map.T

    def _solve_setups(self, values: Array) -> list[_SolvedSetup | None]:
        """Return the modes of all setups, None for a setup without modes at these values."""
        key = np.asarray(values, dtype=float).tobytes()
        if key in self._solutions:
            return self._solutions[key]
        solutions: list[_SolvedSetup | None] = []
        for setup in self.setups:
            pair = self._supplied.evaluate(values, setup)
            try:  # matrices without modes are not an error here: a fit may try any value within the bounds
                solutions.append(None if pair is None else _SolvedSetup(pair, setup_modes(pair, self.rigid)))
            except UnusableError:
                solutions.append(None)
        return self._solutions.keep(
            key, solutions, sum(solution.modes.size for solution in solutions if solution is not None)
        )


def at_measured_setups(structure: Structure, labels: Sequence[str]) -> Structure:
    """Return the structure at the measured setups, in the order of the measurements.

    - structure: a `MatrixStructure` is reordered by its labels; one with a single unlabelled setup matches any label.
      Other structures already have the setups of the measurements.
    - labels: labels of the measurements

    Raises PkmodesError if a `MatrixStructure` has no setup with a measured label, or is unstable at the declared
    values.
    """
    if not isinstance(structure, MatrixStructure):
        return structure
    if structure.setups == ("",) and len(labels) == 1:
        structure.check_stable()
        return structure
    for label in labels:
        if label not in structure.setups:
            problem = f"the structure has no setup {shown(label)}, which was measured"
            raise PkmodesError(problem, "setups", f"setups are: {', '.join(map(shown, structure.setups))}")
    measured_structure = structure.subset([structure.setups.index(label) for label in labels])
    measured_structure.check_stable()
    return measured_structure


def slow_call_remark(structure: Structure) -> str:
    """Return a sentence if the callable for M and K dominates the computing time; else an empty string."""
    if not isinstance(structure, MatrixStructure) or structure.seconds_per_call < SLOW_CALL_SECONDS:
        return ""
    seconds = f"{plain(structure.seconds_per_call, 2)} s"
    return f"each call for the matrices takes {seconds}: a few hundred calls dominate the computing time"
