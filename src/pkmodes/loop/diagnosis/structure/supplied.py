"""M and K from a user's callables, checked at every call, and their derivatives."""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, Literal, NamedTuple, overload

import numpy as np

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.loop.diagnosis.problem import Array, Parameter
from pkmodes.loop.diagnosis.structure.kept import Kept

Matrices = Callable[[Mapping[str, float], str], tuple[Any, Any]]
Derivatives = Callable[[Mapping[str, float], str, str], tuple[Any, Any]]

#: Relative change of the matrices in a difference that approximates a derivative: rounding and curvature balance.
CHANGE = 1e-6
#: Factor by which the actual change may differ from that, and largest number of trial steps.  Steps grow up to
#: LARGEST for a parameter without any effect.
MISSED, TRIALS, LARGEST = 100.0, 30, 1e12
#: Steps smaller than this, relative to the value, may be lost to rounding.
SMALLEST = 1e-12
#: Matrices whose second difference is below this part of the first are linear: a one-sided difference suffices.
STRAIGHT = 1e-8
#: Largest difference between two calls with the same values: a hundredth of the change in a difference.
REPEATABLE = 1e-8
#: Asymmetry due to rounding, relative to an entry and to the largest entry.
RELATIVE, ROUNDING = 1e-9, 1e-12
#: Largest number of values named in a message.
NAMED = 8


class Pair(NamedTuple):
    """Mass and stiffness of one setup, or their derivatives, (n, n)."""

    M: Array
    K: Array


class _StepSearch(NamedTuple):
    """Difference derivatives, None if nothing changes; whether any were finite; the last step."""

    rates: list[Pair] | None
    finite: bool
    step: float


@contextmanager
def _errors_of(matrices: str, where: str, remedy: str) -> Iterator[None]:
    """Re-raise exceptions of the user's callable as a `PkmodesError`."""
    try:
        yield
    except PkmodesError:
        raise
    except Exception as error:
        problem = f"the callable for {matrices} failed: {type(error).__name__}: {error}"
        raise PkmodesError(problem, where, remedy) from error


class Supplied:
    """The matrices from the callables, checked to be symmetric float64; errors name setup and values.

    - matrices, derivatives: see `pkmodes.diagnosis.MatrixStructure`
    - expected: number of coordinates
    - reason: reason for this number, for messages

    Its attributes:
    - calls, seconds: number of calls for M and K, and their total time
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        matrices: Matrices,
        derivatives: Derivatives | None,
        expected: int,
        reason: str,
    ) -> None:
        self.parameters = parameters
        self.matrices, self.derivatives = matrices, derivatives
        self.expected, self.reason = expected, reason
        self.steps: dict[tuple[int, tuple[str, ...]], tuple[float, bool]] = {}
        self.calls, self.seconds = 0, 0.0
        self._cache: Kept[Pair | None] = Kept()

    @overload
    def at(self, values: Array, setup: str, finite: Literal[True]) -> Pair: ...
    @overload
    def at(self, values: Array, setup: str, finite: Literal[False] = ...) -> Pair | None: ...
    def at(self, values: Array, setup: str, finite: bool = False) -> Pair | None:
        """Return M and K; if they are not finite at these values, None or, with `finite`, an error.

        The callable is called once for the same values, as long as there is memory for the matrices.
        """
        key = np.asarray(values, dtype=float).tobytes(), setup
        if key in self._cache and (self._cache[key] is not None or not finite):
            return self._cache[key]
        return self._keep(key, self._called(values, setup, finite))

    def check_repeatable(self, setup: str) -> None:
        """Refuse a callable that is not reproducible at the declared values.

        Difference derivatives would be dominated by its noise.
        """
        declared = np.array([p.value for p in self.parameters])
        before, again = self.at(declared, setup, finite=True), self._called(declared, setup, finite=True)
        assert again is not None
        apart = max(_relative_change(b - a, a) for a, b in zip(before, again, strict=True))
        if apart > (REPEATABLE if self.derivatives is None else CHANGE):
            problem = f"the matrices differ by {apart:.0e} between two calls with the same values"
            remedy = "fix the seed or tighten the solver behind them"
            raise PkmodesError(problem, self._where(declared, setup), remedy)

    def _keep(self, key: tuple[object, ...], pair: Pair | None) -> Pair | None:
        return self._cache.keep(key, pair, sum(matrix.nbytes for matrix in pair or ()))

    def _called(self, values: Array, setup: str, finite: bool) -> Pair | None:
        named = self._named(values)
        where = self._where(values, setup)
        start = time.perf_counter()
        with _errors_of("M and K", where, "fix it, or narrow the bounds of the parameters"):
            returned = self.matrices(named, setup)
        self.calls, self.seconds = self.calls + 1, self.seconds + time.perf_counter() - start
        pair = self._pair(returned, ("M", "K"), where)
        for name, matrix in zip(("M", "K"), pair, strict=True):
            all_finite = np.isfinite(matrix).all()
            if not all_finite and not finite:
                return None
            if not all_finite or not _is_symmetric(matrix):
                problem = f"expected {name} finite and symmetric"
                raise PkmodesError(problem, where, "check how it is assembled")
        return pair

    def rates(self, values: Array, i: int, setups: Mapping[str, Pair]) -> list[Pair] | None:
        """Return the derivatives with respect to one parameter in setups with known M and K; None if zero."""
        if self.derivatives is None:
            return self._differences(values, i, setups)
        name, each_setup = self.parameters[i].name, []
        for setup in setups:
            key = np.asarray(values, dtype=float).tobytes(), setup, name
            if key in self._cache and (cached := self._cache[key]) is not None:
                each_setup.append(cached)
                continue
            where = f"derivatives with respect to {shown(name)}, {self._where(values, setup)}"
            with _errors_of("dM and dK", where, "fix it, or leave the derivatives out"):
                returned = self.derivatives(self._named(values), setup, name)
            pair = self._pair(returned, ("dM", "dK"), where)
            for kind, matrix in zip(("dM", "dK"), pair, strict=True):
                if not np.isfinite(matrix).all() or not _is_symmetric(matrix):
                    problem = f"expected {kind} finite and symmetric"
                    raise PkmodesError(problem, where, "fix it, or leave the derivatives out")
            each_setup.append(pair)
            self._keep(key, each_setup[-1])
        return each_setup

    def _differences(self, values: Array, i: int, setups: Mapping[str, Pair]) -> list[Pair] | None:
        """Return the same by differences; the step found at the declared values is tried first."""
        p = self.parameters[i]
        declared = np.array([p.value for p in self.parameters])
        key = i, tuple(setups)
        if key not in self.steps:
            step, straight = CHANGE * (max(abs(p.value), p.sigma or 0.0) or 1.0), False
            centres = {setup: self.at(declared, setup) for setup in setups}
            evaluated = {setup: pair for setup, pair in centres.items() if pair is not None}
            if len(evaluated) == len(centres):
                first = self._search(declared, i, evaluated, step)
                if first.rates is not None:
                    step, straight = first.step, self._is_straight(declared, i, evaluated, first.step)
            self.steps[key] = step, straight
        step, straight = self.steps[key]
        if step < SMALLEST * abs(values[i]):  # lost in a value that is far from the declared one
            step = CHANGE * abs(values[i])
        search = self._search(values, i, setups, step, straight)
        if not search.finite:
            problem = f"expected M and K finite on both sides of {p.name} = {values[i]:.10g}"
            remedy = "give the parameter the bounds within which it has a meaning, or give derivatives"
            raise PkmodesError(problem, self._where(values, next(iter(setups))), remedy)
        return search.rates

    def _is_straight(self, values: Array, i: int, setups: Mapping[str, Pair], step: float) -> bool:
        """Return whether the matrices are linear in a parameter, judged by differences."""
        p = self.parameters[i]
        if p.upper - p.lower < 2.0 * step:
            return False
        points = np.repeat(values[None], 3, axis=0)
        first_of = np.clip(values[i] - step, p.lower, p.upper - 2.0 * step)
        points[:, i] = np.clip(first_of + step * np.arange(3), p.lower, p.upper)
        for setup, centre in setups.items():
            first, second = (self._difference(points[k + 1], points[k], setup) for k in range(2))
            if first is None or second is None:
                return False
            for former, latter, of in zip(first, second, centre, strict=True):
                if _relative_change(latter - former, of) > STRAIGHT * _relative_change(former, of):
                    return False
        return True

    def _search(
        self, values: Array, i: int, setups: Mapping[str, Pair], step: float, straight: bool = False
    ) -> _StepSearch:
        """Find the step that changes the matrices by about `CHANGE`."""
        p = self.parameters[i]
        rates, finite = None, False
        for _ in range(TRIALS):
            ahead, behind = values.copy(), values.copy()
            ahead[i], behind[i] = min(values[i] + step, p.upper), max(values[i] - step, p.lower)
            if straight and ahead[i] > values[i]:  # the other side is known already
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
                _relative_change(d, of)
                for pair, centre in zip(evaluated, setups.values(), strict=True)
                for d, of in zip(pair, centre, strict=True)
            )
            if change > 0.0:
                width = ahead[i] - behind[i]
                rates = [Pair(pair.M / width, pair.K / width) for pair in evaluated]
            whole = ahead[i] == p.upper and behind[i] == p.lower
            if abs(np.log(max(change, 1e-300) / CHANGE)) <= np.log(MISSED) or (
                change < CHANGE and (step > LARGEST or whole)
            ):
                break
            step *= min(max(CHANGE / change, 1e-6), 1e6) if change > 0.0 else 1e3
        return _StepSearch(rates, finite, step)

    def _difference(self, ahead: Array, behind: Array, setup: str) -> Pair | None:
        after, before = self.at(ahead, setup), self.at(behind, setup)
        if after is None or before is None:
            return None
        return Pair(after.M - before.M, after.K - before.K)

    def _named(self, values: Array) -> dict[str, float]:
        return {p.name: float(value) for p, value in zip(self.parameters, values, strict=True)}

    def _where(self, values: Array, setup: str) -> str:
        moved = [(p.name, v) for p, v in zip(self.parameters, values, strict=True) if v != p.value]
        text = ", ".join(f"{name} = {value:.10g}" for name, value in moved[:NAMED]) or "the declared values"
        suffix = f" and {len(moved) - NAMED} more" if len(moved) > NAMED else ""
        return f"matrices for setup {shown(setup)} at {text}{suffix}"

    def _pair(self, returned: Any, names: tuple[str, str], where: str) -> Pair:
        kind = f"({', '.join(names)})"
        if not isinstance(returned, tuple | list) or len(returned) != 2:
            problem = f"expected a pair {kind}, found {type(returned).__name__}"
            raise PkmodesError(problem, where, f"return {kind}")
        return Pair(*(self._matrix(m, name, where) for name, m in zip(names, returned, strict=True)))

    def _matrix(self, returned: Any, name: str, where: str) -> Array:
        try:
            returned = returned.toarray() if hasattr(returned, "toarray") else np.asarray(returned)
        except (TypeError, ValueError) as error:
            raise PkmodesError(f"expected {name} as an array: {error}", where, "return arrays") from error
        if returned.dtype.kind not in "biuf":
            kind = "complex numbers" if returned.dtype.kind == "c" else f"values of type {returned.dtype}"
            remedy = "give real matrices: the modes are undamped"
            raise PkmodesError(f"expected {name} of real numbers, found {kind}", where, remedy)
        if returned.dtype.kind == "f" and returned.dtype.itemsize < 8 and self.derivatives is None:
            problem = f"expected {name} in double precision, found {returned.dtype}"
            remedy = "assemble it in float64 for difference derivatives, or give derivatives"
            raise PkmodesError(problem, where, remedy)
        n = self.expected
        if returned.shape != (n, n):
            problem = f"expected {name} of shape {(n, n)} for {self.reason}, found {returned.shape}"
            raise PkmodesError(
                problem, where, "give one channel for each coordinate, or coordinates= or sensors="
            )
        matrix: Array = returned.astype(float)  # a copy: a callable may reuse its arrays
        return matrix


def _is_symmetric(matrix: Array) -> bool:
    """Return whether a matrix is symmetric up to rounding."""
    if np.array_equal(matrix, matrix.T):
        return True
    return np.allclose(matrix, matrix.T, rtol=RELATIVE, atol=ROUNDING * np.abs(matrix).max())


def _relative_change(change: Array, of: Array) -> float:
    """Return the largest change of an entry, relative to the diagonal entries of its row and column."""
    size = np.sqrt(np.abs(of.diagonal()))
    rows, columns = np.nonzero(change)
    scale = size[rows] * size[columns]
    # Entries with a zero diagonal entry (a free coordinate) have no scale.
    scale[scale == 0.0] = np.abs(of).max(initial=0.0)
    scaled = scale > 0.0
    return float((np.abs(change[rows, columns])[scaled] / scale[scaled]).max(initial=0.0))
