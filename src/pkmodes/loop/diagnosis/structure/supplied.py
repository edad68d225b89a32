"""M and K from a user's callables, checked at every call, and their derivatives."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Literal, NamedTuple, overload

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.problem import Array, Parameter
from pkmodes.loop.diagnosis.structure.cache import ResultCache

Matrices = Callable[[Mapping[str, float], str], tuple[Any, Any]]
Derivatives = Callable[[Mapping[str, float], str, str], tuple[Any, Any]]

#: Relative change of the matrices in a difference that approximates a derivative: rounding and curvature balance.
TARGET_CHANGE = 1e-6
#: Factor by which the actual change may differ from that, and largest number of trial steps.  Steps grow up to
#: MAX_STEP for a parameter without any effect.
MAX_CHANGE_FACTOR, MAX_TRIALS, MAX_STEP = 100.0, 30, 1e12
#: Steps smaller than this, relative to the value, may be lost to rounding.
MIN_RELATIVE_STEP = 1e-12
#: Matrices whose second difference is below this part of the first are linear: a one-sided difference suffices.
LINEARITY_TOLERANCE = 1e-8
#: Largest difference between two calls with the same values: a hundredth of the change in a difference.
REPEATABILITY_TOLERANCE = 1e-8
#: Asymmetry due to rounding, relative to an entry and to the largest entry.
RELATIVE_ASYMMETRY, ROUNDING = 1e-9, 1e-12
#: Largest number of values named in a message.
MAX_VALUES_NAMED = 8


class MatrixPair(NamedTuple):
    """Mass and stiffness of one setup, or their derivatives, (n, n)."""

    M: Array
    K: Array


class _StepSearch(NamedTuple):
    """Difference derivatives, None if nothing changes; whether any were finite; the last step."""

    rates: list[MatrixPair] | None
    is_finite: bool
    step: float


@contextmanager
def _as_pkmodes_error(matrices: str, location: str, remedy: str) -> Iterator[None]:
    """Re-raise exceptions of the user's callable as a `PkmodesError`."""
    try:
        yield
    except PkmodesError:
        raise
    except Exception as error:
        problem = f"the callable for {matrices} failed: {type(error).__name__}: {error}"
        raise PkmodesError(problem, location, remedy) from error


class SuppliedMatrices:
    """The matrices from the callables, checked to be symmetric float64; errors name setup and values.

    - matrices, derivatives: see `pkmodes.diagnosis.MatrixStructure`
    - coordinate_count: number of coordinates
    - reason: reason for this number, for messages

    Its attributes:
    - calls, seconds: number of calls for M and K, and their total time
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        matrices: Matrices,
        derivatives: Derivatives | None,
        coordinate_count: int,
        reason: str,
    ) -> None:
        self.parameters = parameters
        self.matrices, self.derivatives = matrices, derivatives
        self.coordinate_count, self.reason = coordinate_count, reason
        self.steps: dict[tuple[int, tuple[str, ...]], tuple[float, bool]] = {}
        self.calls, self.seconds = 0, 0.0
        self._cache: ResultCache[MatrixPair | None] = ResultCache()

    @overload
    def evaluate(self, values: Array, setup: str, finite: Literal[True]) -> MatrixPair: ...
    @overload
    def evaluate(self, values: Array, setup: str, finite: Literal[False] = ...) -> MatrixPair | None: ...
    def evaluate(self, values: Array, setup: str, finite: bool = False) -> MatrixPair | None:
        """Return M and K; if they are not finite at these values, None or, with `finite`, an error.

        The callable is called once for the same values, as long as there is memory for the matrices.
        """
        key = np.asarray(values, dtype=float).tobytes(), setup
        if key in self._cache and (self._cache[key] is not None or not finite):
            return self._cache[key]
        return self._store(key, self._call_matrices(values, setup, finite))

    def check_repeatable(self, setup: str) -> None:
        """Refuse a callable that is not reproducible at the declared values.

        Difference derivatives would be dominated by its noise.
        """
        declared = np.array([p.value for p in self.parameters])
        first_pair = self.evaluate(declared, setup, finite=True)
        second_pair = self._call_matrices(declared, setup, finite=True)
        assert second_pair is not None
        difference = max(_relative_change(b - a, a) for a, b in zip(first_pair, second_pair, strict=True))
        if difference > (REPEATABILITY_TOLERANCE if self.derivatives is None else TARGET_CHANGE):
            problem = f"the matrices differ by {difference:.0e} between two calls with the same values"
            remedy = "fix the seed or tighten the solver behind them"
            raise PkmodesError(problem, self._location(declared, setup), remedy)

    def _store(self, key: tuple[object, ...], pair: MatrixPair | None) -> MatrixPair | None:
        return self._cache.keep(key, pair, sum(matrix.nbytes for matrix in pair or ()))

    def _call_matrices(self, values: Array, setup: str, finite: bool) -> MatrixPair | None:
        values_by_name = self._values_by_name(values)
        location = self._location(values, setup)
        start = time.perf_counter()
        with _as_pkmodes_error("M and K", location, "fix it, or narrow the bounds of the parameters"):
            returned = self.matrices(values_by_name, setup)
        self.calls, self.seconds = self.calls + 1, self.seconds + time.perf_counter() - start
        pair = self._check_pair(returned, ("M", "K"), location)
        for name, matrix in zip(("M", "K"), pair, strict=True):
            all_finite = np.isfinite(matrix).all()
            if not all_finite and not finite:
                return None
            if not all_finite or not _is_symmetric(matrix):
                problem = f"expected {name} finite and symmetric"
                raise PkmodesError(problem, location, "check how it is assembled")
        return pair

    def rates(self, values: Array, i: int, setups: Mapping[str, MatrixPair]) -> list[MatrixPair] | None:
        """Return the derivatives with respect to one parameter in setups with known M and K; None if zero."""
        if self.derivatives is None:
            return self._difference_rates(values, i, setups)
        name, pairs = self.parameters[i].name, []
        for setup in setups:
            key = np.asarray(values, dtype=float).tobytes(), setup, name
            if key in self._cache and (cached := self._cache[key]) is not None:
                pairs.append(cached)
                continue
            location = f"derivatives with respect to {shown(name)}, {self._location(values, setup)}"
            with _as_pkmodes_error("dM and dK", location, "fix it, or leave the derivatives out"):
                returned = self.derivatives(self._values_by_name(values), setup, name)
            pair = self._check_pair(returned, ("dM", "dK"), location)
            for kind, matrix in zip(("dM", "dK"), pair, strict=True):
                if not np.isfinite(matrix).all() or not _is_symmetric(matrix):
                    problem = f"expected {kind} finite and symmetric"
                    raise PkmodesError(problem, location, "fix it, or leave the derivatives out")
            pairs.append(pair)
            self._store(key, pairs[-1])
        return pairs

    def _difference_rates(
        self, values: Array, i: int, setups: Mapping[str, MatrixPair]
    ) -> list[MatrixPair] | None:
        """Return these derivatives by differences; the step found at the declared values is tried first."""
        p = self.parameters[i]
        declared = np.array([p.value for p in self.parameters])
        key = i, tuple(setups)
        if key not in self.steps:
            step, is_linear = TARGET_CHANGE * (max(abs(p.value), p.sigma or 0.0) or 1.0), False
            centres = {setup: self.evaluate(declared, setup) for setup in setups}
            evaluated = {setup: pair for setup, pair in centres.items() if pair is not None}
            if len(evaluated) == len(centres):
                declared_search = self._find_step(declared, i, evaluated, step)
                if declared_search.rates is not None:
                    step, is_linear = (
                        declared_search.step,
                        self._is_linear(declared, i, evaluated, declared_search.step),
                    )
            self.steps[key] = step, is_linear
        step, is_linear = self.steps[key]
        if step < MIN_RELATIVE_STEP * abs(values[i]):  # lost in a value that is far from the declared one
            step = TARGET_CHANGE * abs(values[i])
        step_search = self._find_step(values, i, setups, step, is_linear)
        if not step_search.is_finite:
            problem = f"expected M and K finite on both sides of {p.name} = {values[i]:.10g}"
            remedy = "give the parameter the bounds within which it has a meaning, or give derivatives"
            raise PkmodesError(problem, self._location(values, next(iter(setups))), remedy)
        return step_search.rates

    def _is_linear(self, values: Array, i: int, setups: Mapping[str, MatrixPair], step: float) -> bool:
        """Return whether the matrices are linear in a parameter, judged by differences."""
        p = self.parameters[i]
        if p.upper - p.lower < 2.0 * step:
            return False
        points = np.repeat(values[None], 3, axis=0)
        first_value = np.clip(values[i] - step, p.lower, p.upper - 2.0 * step)
        points[:, i] = np.clip(first_value + step * np.arange(3), p.lower, p.upper)
        for setup, centre in setups.items():
            first, second = (self._difference(points[k + 1], points[k], setup) for k in range(2))
            if first is None or second is None:
                return False
            for first_change, second_change, reference in zip(first, second, centre, strict=True):
                curvature = _relative_change(second_change - first_change, reference)
                if curvature > LINEARITY_TOLERANCE * _relative_change(first_change, reference):
                    return False
        return True

    def _find_step(
        self, values: Array, i: int, setups: Mapping[str, MatrixPair], step: float, is_linear: bool = False
    ) -> _StepSearch:
        """Find the step that changes the matrices by about `TARGET_CHANGE`."""
        p = self.parameters[i]
        rates, finite = None, False
        for _ in range(MAX_TRIALS):
            ahead, behind = values.copy(), values.copy()
            ahead[i], behind[i] = min(values[i] + step, p.upper), max(values[i] - step, p.lower)
            if is_linear and ahead[i] > values[i]:  # the other side is known already
                behind[i] = values[i]
            if ahead[i] == behind[i]:
                break
            differences = [self._difference(ahead, behind, setup) for setup in setups]
            if any(pair is None for pair in differences):  # the step is far too large
                step *= 1e-3
                continue
            finite = True
            evaluated = [pair for pair in differences if pair is not None]
            change = max(
                _relative_change(difference, reference)
                for pair, centre in zip(evaluated, setups.values(), strict=True)
                for difference, reference in zip(pair, centre, strict=True)
            )
            if change > 0.0:
                step_width = ahead[i] - behind[i]
                rates = [MatrixPair(pair.M / step_width, pair.K / step_width) for pair in evaluated]
            spans_range = ahead[i] == p.upper and behind[i] == p.lower
            if abs(np.log(max(change, 1e-300) / TARGET_CHANGE)) <= np.log(MAX_CHANGE_FACTOR) or (
                change < TARGET_CHANGE and (step > MAX_STEP or spans_range)
            ):
                break
            step *= min(max(TARGET_CHANGE / change, 1e-6), 1e6) if change > 0.0 else 1e3
        return _StepSearch(rates, finite, step)

    def _difference(self, ahead: Array, behind: Array, setup: str) -> MatrixPair | None:
        pair_ahead, pair_behind = self.evaluate(ahead, setup), self.evaluate(behind, setup)
        if pair_ahead is None or pair_behind is None:
            return None
        return MatrixPair(pair_ahead.M - pair_behind.M, pair_ahead.K - pair_behind.K)

    def _values_by_name(self, values: Array) -> dict[str, float]:
        return {p.name: float(value) for p, value in zip(self.parameters, values, strict=True)}

    def _location(self, values: Array, setup: str) -> str:
        changed_values = [(p.name, v) for p, v in zip(self.parameters, values, strict=True) if v != p.value]
        values_in_words = (
            ", ".join(f"{name} = {value:.10g}" for name, value in changed_values[:MAX_VALUES_NAMED])
            or "the declared values"
        )
        suffix = (
            f" and {len(changed_values) - MAX_VALUES_NAMED} more"
            if len(changed_values) > MAX_VALUES_NAMED
            else ""
        )
        return f"matrices for setup {shown(setup)} at {values_in_words}{suffix}"

    def _check_pair(self, returned: Any, names: tuple[str, str], location: str) -> MatrixPair:
        kind = f"({', '.join(names)})"
        if not isinstance(returned, tuple | list) or len(returned) != 2:
            problem = f"expected a pair {kind}, found {type(returned).__name__}"
            raise PkmodesError(problem, location, f"return {kind}")
        return MatrixPair(
            *(
                self._check_matrix(matrix, name, location)
                for name, matrix in zip(names, returned, strict=True)
            )
        )

    def _check_matrix(self, returned: Any, name: str, location: str) -> Array:
        try:
            returned = returned.toarray() if hasattr(returned, "toarray") else np.asarray(returned)
        except (TypeError, ValueError) as error:
            raise PkmodesError(f"expected {name} as an array: {error}", location, "return arrays") from error
        if returned.dtype.kind not in "biuf":
            kind = "complex numbers" if returned.dtype.kind == "c" else f"values of type {returned.dtype}"
            remedy = "give real matrices: the modes are undamped"
            raise PkmodesError(f"expected {name} of real numbers, found {kind}", location, remedy)
        if returned.dtype.kind == "f" and returned.dtype.itemsize < 8 and self.derivatives is None:
            problem = f"expected {name} in double precision, found {returned.dtype}"
            remedy = "assemble it in float64 for difference derivatives, or give derivatives"
            raise PkmodesError(problem, location, remedy)
        n = self.coordinate_count
        if returned.shape != (n, n):
            problem = f"expected {name} of shape {(n, n)} for {self.reason}, found {returned.shape}"
            raise PkmodesError(
                problem, location, "give one channel for each coordinate, or coordinates= or sensors="
            )
        matrix: Array = returned.astype(float)  # a copy: a callable may reuse its arrays
        return matrix


def _is_symmetric(matrix: Array) -> bool:
    """Return whether a matrix is symmetric up to rounding."""
    if np.array_equal(matrix, matrix.T):
        return True
    return np.allclose(matrix, matrix.T, rtol=RELATIVE_ASYMMETRY, atol=ROUNDING * np.abs(matrix).max())


def _relative_change(change: Array, reference: Array) -> float:
    """Return the largest change of an entry, relative to the diagonal entries of its row and column."""
    root_diagonal = np.sqrt(np.abs(reference.diagonal()))
    rows, columns = np.nonzero(change)
    scale = root_diagonal[rows] * root_diagonal[columns]
    # Entries with a zero diagonal entry (a free coordinate) have no scale.
    scale[scale == 0.0] = np.abs(reference).max(initial=0.0)
    has_scale = scale > 0.0
    return float((np.abs(change[rows, columns])[has_scale] / scale[has_scale]).max(initial=0.0))
