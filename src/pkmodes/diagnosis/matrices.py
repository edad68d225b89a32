"""A structure given by callables for M and K: the way in for any model that is not a robot of this package."""

from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, NamedTuple

import numpy as np

from pkmodes.diagnosis.problem import (
    Array,
    Batch,
    Candidate,
    Index,
    Parameter,
    Prediction,
    Structure,
    one_by_one,
)
from pkmodes.diagnosis.structure.kept import Kept
from pkmodes.diagnosis.structure.massless import UnstableError, UnusableError
from pkmodes.diagnosis.structure.modes import Modes, lowest_modes, modes_below
from pkmodes.diagnosis.structure.names import check_callables, check_candidate, check_names, check_parameter
from pkmodes.diagnosis.structure.sensors import sensor_map
from pkmodes.diagnosis.structure.shape_rates import ShapeRates, eigenvalue_rates
from pkmodes.diagnosis.structure.shape_rates import shape_rates as rates_of_shapes
from pkmodes.diagnosis.structure.supplied import Derivatives, Matrices, Pair, Supplied
from pkmodes.errors import PkmodesError, listed, shown

#: Structures with no more coordinates than SMALL have all modes by default, others the lowest FEW, and as many as
#: REACH times the highest measured frequency asks for: farther away no mode is paired with it.
SMALL, FEW, REACH = 150, 40, 2.0
#: A call of the callable that takes longer than this [s] is what a diagnosis takes its time for.
SLOW = 0.02
#: Modes beyond those that are predicted, so that the last of them is known from its neighbours.
GUARD = 3


class _Solved(NamedTuple):
    """Matrices and modes of one setup."""

    pair: Pair
    modes: Modes


class MatrixStructure:
    """A model with mass and stiffness matrices that depend on named parameters.

    Parameters
    ----------
    parameters : sequence of Parameter
        All that can vary: nuisances have a ``sigma``, those of candidates their null value as ``value``.
    candidates : sequence of Candidate
        Causes that may be missing or wrong.
    matrices : callable
        ``matrices(values, setup) -> (M, K)``, with the values of all parameters by name and the label of a
        setup; both (n, n), real and symmetric, arrays or scipy.sparse matrices, in consistent units (K / M in
        1/s^2).  M may be singular (coordinates, or motions, without inertia are condensed exactly) where K is
        positive definite for what has no inertia.  Where they are not finite, the values cannot be evaluated,
        and a fit avoids them; an exception is an error at any values within the bounds.  For the same values it
        returns the same matrices, and is asked once, as long as there is memory for them.
    derivatives : callable, optional
        ``derivatives(values, setup, name) -> (dM, dK)`` by the parameter of that name.  Without it, differences
        of the matrices are taken, with a step that changes them by a millionth, whatever the unit.
    channels : sequence of str
        What the shape columns of the measurements may be called: the names of the n coordinates, some of
        `coordinates`, or one name for each row of `sensors`.
    coordinates : sequence of str, optional
        Names of the n coordinates, where the channels are some of them.
    sensors : array_like or sparse matrix, shape (C, n), optional
        Motion of each channel by those of the coordinates, where the channels are not coordinates.
    setups : sequence of str
        Labels of the setups, as the measurements have them, in any order; left out, there is one setup, of
        whatever label.
    rigid : int
        Rigid-body modes, which are not measured.  Other modes are stable: K has no negative eigenvalue for them.
    modes : int, optional
        How many modes are computed, the lowest, rigid ones included.  By default all for up to 150 coordinates,
        and 40 for more, or as many as lie below twice the highest frequency that is asked of `reaching`.

    Raises
    ------
    PkmodesError
        If names are repeated or missing, numbers contradict each other, or the matrices do not have the form
        above; from `predict` too, where they lose it at other values.
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
    ) -> None:
        self.parameters: tuple[Parameter, ...] = tuple(
            listed(parameters, "parameters", "parameters", 'Parameter("k", 1e6)', Parameter)
        )
        self.candidates: tuple[Candidate, ...] = tuple(
            listed(candidates, "candidates", "candidates", 'Candidate("k", ("k",), "")', Candidate)
        )
        self.channels: tuple[str, ...] = tuple(listed(channels, "names", "channels", '"x_1"', str))
        self.setups: tuple[str, ...] = tuple(listed(setups, "labels", "setups", '"P1"', str))
        check_callables(matrices, derivatives)
        if isinstance(rigid, bool) or not isinstance(rigid, int | np.integer) or rigid < 0:
            what = f"expected a number of modes, found {shown(rigid)}"
            raise PkmodesError(what, "rigid", "count the rigid-body modes")
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
            what = f"expected more modes than the rigid ones, in whole numbers, found {modes} and {rigid}"
            raise PkmodesError(what, "modes", "ask for as many as were measured, and the rigid ones")
        self._map = sensor_map(self.channels, coordinates, sensors)
        self._size = len(self.channels) if self._map is None else self._map.shape[1]
        reason = f"{self._size} coordinates" if sensors is None else f"{self._size} columns of sensors"
        self._supplied = Supplied(
            self.parameters,
            matrices,
            derivatives,
            self._size,
            f"{self._size} channels" if self._map is None else reason,
        )
        self._count = min(self._size, modes or (self._size if self._size <= SMALL else FEW + rigid))
        self._solutions: Kept[list[_Solved | None]] = Kept()
        self._check(UnusableError)
        for setup in self.setups[:1]:
            self._supplied.check_repeatable(setup)

    def subset(self, setups: Sequence[int]) -> MatrixStructure:
        """The same structure in some of its setups."""
        part = copy.copy(self)
        part.setups, part._solutions = tuple(self.setups[i] for i in setups), Kept()
        return part

    def reaching(self, frequency: float) -> MatrixStructure:
        """The same structure with modes enough for measurements up to a frequency [Hz].

        Only where it has more than 150 coordinates, and `modes` was left to it.
        """
        if self.modes is not None or self._size <= SMALL:
            return self
        limit = (2.0 * np.pi * REACH * frequency) ** 2
        pairs = (self._supplied.at(self._declared, setup, finite=True) for setup in self.setups)
        needed = max(modes_below(pair, limit) for pair in pairs)
        part = copy.copy(self)
        part._count, part._solutions = min(max(self._count, needed), self._size), Kept()
        return part

    def predict(self, values: Array, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        """Modes in all setups, with derivatives by some of the parameters."""
        solved = self._solved(values)
        known = {setup: s for setup, s in zip(self.setups, solved, strict=True) if s is not None}
        count = min((len(s.modes.eigenvalues) for s in known.values()), default=self._count)
        count = min(count, self._count)
        size = (len(self.setups), count)
        eigenvalues, rates = np.full(size, np.nan), np.full((*size, len(by)), np.nan)
        shapes = np.zeros((*size, len(self.channels)))
        for k, one in enumerate(solved):
            if one is not None:
                eigenvalues[k] = one.modes.eigenvalues[:count]
                shapes[k] = self._measured(one.modes.shapes[:count])
        pairs = {setup: s.pair for setup, s in known.items()}
        by_each = [self._supplied.rates(values, i, pairs) for i in by] if known else []
        derive: list[Callable[[Index], Array] | None] = [None] * len(solved)
        place = iter(range(len(known)))
        for k, one in enumerate(solved):
            if one is not None:
                at = next(place)
                changes = [None if each is None else each[at] for each in by_each]
                rates[k] = eigenvalue_rates(one.modes, np.arange(count), changes)
                derive[k] = partial(self._shape_rates, one, changes)
        moved = ShapeRates(derive, (*shapes.shape, len(by))) if shape_rates else None
        return Prediction(eigenvalues, rates, shapes, self.rigid, moved)

    def predict_many(
        self, values: Array, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        """The same for several sets of values, one by one: each is a problem for LAPACK or ARPACK anyhow."""
        return one_by_one(self, values, by, shape_rates=shape_rates)

    def position_rates(self, values: Array, *, shape_rates: bool = False) -> None:
        """Setups have no position."""

    def elsewhere(self, count: int) -> tuple[Array, Structure] | None:
        """No other setups are known."""

    @property
    def seconds_a_call(self) -> float:
        """How long the callable for M and K takes [s]."""
        return self._supplied.seconds / max(self._supplied.calls, 1)

    def check_stands(self) -> None:
        """Refuse a structure that is not stable with its declared values.

        Raises
        ------
        PkmodesError
            With the first setup in which it is not.
        """
        self._check(UnstableError)

    def _check(self, kind: type[UnusableError]) -> None:
        """Refuse what keeps the declared values from having modes."""
        for setup in self.setups:
            pair = self._supplied.at(self._declared, setup, finite=True)
            try:
                lowest_modes(pair, self._count, self.rigid)
            except UnusableError as error:
                if isinstance(error, UnstableError) and kind is not UnstableError:
                    continue
                what = f"the model cannot be evaluated with its declared values: {error.what}"
                raise PkmodesError(what, f"{error.where} for setup {shown(setup)}", error.remedy) from None

    @property
    def _declared(self) -> Array:
        return np.array([p.value for p in self.parameters])

    def _shape_rates(self, one: _Solved, changes: Sequence[Pair | None], some: Index) -> Array:
        """Derivatives of some shapes at the channels, (W, C, T)."""
        found = rates_of_shapes(one.pair, one.modes, some, changes)
        return np.moveaxis(self._measured(np.moveaxis(found, 2, 1)), 1, 2)

    def _measured(self, shapes: Array) -> Array:
        """Shapes (..., n) at the channels."""
        if self._map is None:
            return shapes
        found: Array = (self._map @ shapes.reshape(-1, self._size).T).T
        return found.reshape(*shapes.shape[:-1], len(self.channels))

    def _solved(self, values: Array) -> list[_Solved | None]:
        """Modes of all setups, None where these values have none."""
        key = np.asarray(values, dtype=float).tobytes()
        if key in self._solutions:
            return self._solutions[key]
        found = [self._solve(values, setup) for setup in self.setups]
        return self._solutions.keep(key, found, sum(one.modes.size for one in found if one is not None))

    def _solve(self, values: Array, setup: str) -> _Solved | None:
        pair = self._supplied.at(values, setup)
        if pair is None:
            return None
        count = min(self._count + GUARD, self._size) if self._count < self._size else self._size
        try:  # matrices without modes are no mistake here: a fit may try any value within the bounds
            return _Solved(pair, lowest_modes(pair, count, self.rigid))
        except UnusableError:
            return None


def at_measured(structure: Structure, labels: Sequence[str], highest: float | None = None) -> Structure:
    """Return the structure at the measured setups, in the order of the measurements.

    Parameters
    ----------
    structure : Structure
        A `MatrixStructure` is put in order by its labels, one of a single setup without a label is what was measured
        under any; another structure has the setups of the measurements already.
    labels : sequence of str
        Labels of the measurements.
    highest : float, optional
        Highest measured frequency [Hz], which a large `MatrixStructure` has to reach.

    Raises
    ------
    PkmodesError
        If a `MatrixStructure` has no setup of that label, or does not stand as declared.
    """
    if not isinstance(structure, MatrixStructure):
        return structure
    if highest is not None:
        structure = structure.reaching(highest)
    if structure.setups == ("",) and len(labels) == 1:
        structure.check_stands()
        return structure
    for label in labels:
        if label not in structure.setups:
            what = f"the structure has no setup {shown(label)}, which was measured"
            raise PkmodesError(what, "setups", f"setups are: {', '.join(map(shown, structure.setups))}")
    measured = structure.subset([structure.setups.index(label) for label in labels])
    measured.check_stands()
    return measured


def slowness(structure: Structure) -> str:
    """Say so where it is the callable for M and K that takes the time; else nothing."""
    if not isinstance(structure, MatrixStructure) or structure.seconds_a_call < SLOW:
        return ""
    seconds = f"{structure.seconds_a_call:.2g} s"
    return f"each call for the matrices takes {seconds}: some hundred of them take the time"
