"""Terms of matrices: a mass at each coordinate, and springs to ground and between coordinates.

Both are linear in their parameter and the same in every setup, so that their derivatives are exact: a mass at the
coordinate i adds :math:`m e_i e_i^T` to M, and a spring :math:`k v v^T` to K, with :math:`v = e_i`, or
:math:`v = e_i - e_j` between two.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from itertools import combinations
from typing import Literal, NamedTuple, overload

import numpy as np

from pkmodes.loop.diagnosis.problem import Array, Candidate, Parameter
from pkmodes.loop.diagnosis.structure.supplied import MatrixPair, SuppliedMatrices

MASS, SPRING = "mass", "spring"
#: Name of the parameter of each form.
QUANTITIES = {MASS: "mass", SPRING: "stiffness"}


class CoordinateTerm(NamedTuple):
    """A mass or a spring at one or between two coordinates.

    - coordinates: their indices
    """

    candidate: Candidate
    parameter: Parameter
    coordinates: tuple[int, ...]

    def change(self, size: int, zero: Array) -> MatrixPair:
        """Return the derivatives of M and K, (n, n)."""
        v = np.zeros(size)
        v[list(self.coordinates)] = (1.0, -1.0)[: len(self.coordinates)]
        matrix = np.outer(v, v)
        return MatrixPair(matrix, zero) if self.candidate.form == MASS else MatrixPair(zero, matrix)


def coordinate_terms(
    coordinates: Sequence[str], units: tuple[str, str], used_names: Collection[str]
) -> Iterator[CoordinateTerm]:
    """Yield all terms of some coordinates.

    - units: units of M and of K
    - used_names: names of candidates and parameters: a term with one of these names is left out
    """
    forms_and_indices: list[tuple[str, tuple[int, ...]]] = [
        *((MASS, (i,)) for i in range(len(coordinates))),
        *((SPRING, (i,)) for i in range(len(coordinates))),
        *((SPRING, pair) for pair in combinations(range(len(coordinates)), 2)),
    ]
    all_names = set(used_names)
    for form, indices in forms_and_indices:
        names = [coordinates[i] for i in indices]
        term = f"{form}:{'/'.join(names)}"
        parameter = Parameter(f"{term}.{QUANTITIES[form]}", 0.0, units[form == SPRING], lower=0.0)
        if {term, parameter.name} & all_names:
            continue
        all_names |= {term, parameter.name}
        ends = " and ".join(names) if len(names) > 1 else f"{names[0]} and the ground"
        sentence = f"a mass at {names[0]}" if form == MASS else f"a spring between {ends}"
        yield CoordinateTerm(
            Candidate(term, (parameter.name,), sentence, remote=True, form=form), parameter, indices
        )


class SuppliedWithTerms:
    """Supplied matrices with terms, whose parameters follow those of the supplied ones.

    - calls, seconds: number of calls for the supplied M and K, and their total time
    """

    def __init__(self, supplied: SuppliedMatrices, terms: Sequence[CoordinateTerm]) -> None:
        self._supplied = supplied
        self._supplied_count = len(supplied.parameters)
        size = supplied.coordinate_count
        zero = np.zeros((size, size))
        self._changes = [term.change(size, zero) for term in terms]
        self._is_mass = np.array([term.candidate.form == MASS for term in terms])

    @property
    def calls(self) -> int:
        """Number of calls for the supplied M and K."""
        return self._supplied.calls

    @property
    def seconds(self) -> float:
        """Total time of these calls [s]."""
        return self._supplied.seconds

    @overload
    def evaluate(self, values: Array, setup: str, finite: Literal[True]) -> MatrixPair: ...
    @overload
    def evaluate(self, values: Array, setup: str, finite: Literal[False] = ...) -> MatrixPair | None: ...
    def evaluate(self, values: Array, setup: str, finite: bool = False) -> MatrixPair | None:
        """Return M and K with all terms; if they are not finite, None or, with `finite`, an error."""
        supplied_values = values[: self._supplied_count]
        pair = (
            self._supplied.evaluate(supplied_values, setup, finite=True)
            if finite
            else self._supplied.evaluate(supplied_values, setup)
        )
        if pair is None:
            return None
        M, K = pair
        for k in np.flatnonzero(values[self._supplied_count :]):
            change, value = self._changes[k], values[self._supplied_count + k]
            M, K = (M + value * change.M, K) if self._is_mass[k] else (M, K + value * change.K)
        return MatrixPair(M, K)

    def rates(self, values: Array, i: int, setups: Mapping[str, MatrixPair]) -> list[MatrixPair] | None:
        """Return the derivatives with respect to one parameter in setups with known M and K; None if zero."""
        if i >= self._supplied_count:
            return [self._changes[i - self._supplied_count]] * len(setups)
        supplied_pairs = {
            setup: self._supplied.evaluate(values[: self._supplied_count], setup, finite=True)
            for setup in setups
        }
        return self._supplied.rates(values[: self._supplied_count], i, supplied_pairs)
