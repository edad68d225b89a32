"""M and K from a user's callables, checked at every call, and their derivatives."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any, Literal, NamedTuple, overload

import numpy as np
from scipy import sparse

from pkmodes.diagnosis.problem import Array, Parameter
from pkmodes.errors import PkmodesError, shown

Matrices = Callable[[Mapping[str, float], str], tuple[Any, Any]]
Derivatives = Callable[[Mapping[str, float], str, str], tuple[Any, Any]]

#: Relative change of the matrices at which differences stand in for derivatives: rounding and curvature balance.
CHANGE = 1e-6
#: How far that change may be missed, and how many steps are tried.  Steps grow up to LARGEST, for a parameter that
#: changes nothing.
MISSED, TRIALS, LARGEST = 100.0, 30, 1e12
#: What is left unsymmetric by rounding: of an entry, and of the largest one.
RELATIVE, ROUNDING = 1e-9, 1e-12
#: From this many coordinates on, a matrix with few entries is kept sparse, whatever it was given as.
MANY, FEW = 200, 0.05
#: How many values a message names.
NAMED = 8


class Pair(NamedTuple):
    """Mass and stiffness of one setup, or their derivatives: both ndarrays, or both sparse arrays."""

    M: Any
    K: Any


class Supplied:
    """What the callables return, as float64 and symmetric, or an error that names setup and values.

    Parameters
    ----------
    parameters : sequence of Parameter
    matrices, derivatives : callable
        See `pkmodes.diagnosis.MatrixStructure`.
    expected : int
        Number of coordinates.
    reason : str
        Why so many, for messages.
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

    @overload
    def at(self, values: Array, setup: str, finite: Literal[True]) -> Pair: ...
    @overload
    def at(self, values: Array, setup: str, finite: Literal[False] = ...) -> Pair | None: ...
    def at(self, values: Array, setup: str, finite: bool = False) -> Pair | None:
        """M and K; where they are not finite, which some values within the bounds may bring, None or an error."""
        named = self._named(values)
        where = self._where(values, setup)
        try:
            returned = self.matrices(named, setup)
        except PkmodesError:
            raise
        except Exception as error:
            what = f"the callable for M and K failed: {type(error).__name__}: {error}"
            raise PkmodesError(what, where, "mend it, or narrow the bounds of the parameters") from error
        pair = self._pair(returned, ("M", "K"), where)
        for name, matrix in zip(("M", "K"), pair, strict=True):
            known = np.isfinite(_entries(matrix)).all()
            if not known and not finite:
                return None
            if not known or not _symmetric(matrix):
                what = f"expected {name} finite and symmetric"
                raise PkmodesError(what, where, "check how it is assembled")
        if (n := pair.M.shape[0]) >= MANY and all(_count(matrix) <= FEW * n * n for matrix in pair):
            return Pair(*map(_packed, pair))
        return Pair(*(matrix.toarray() if is_sparse(matrix) else matrix for matrix in pair))

    def rates(self, values: Array, i: int, setups: Mapping[str, Pair]) -> list[Pair] | None:
        """Derivatives by one parameter in these setups, of which M and K are known; None where there are none."""
        if self.derivatives is None:
            return self._differences(values, i, setups)
        name, found = self.parameters[i].name, []
        for setup in setups:
            where = f"derivatives by {shown(name)}, {self._where(values, setup)}"
            try:
                returned = self.derivatives(self._named(values), setup, name)
            except PkmodesError:
                raise
            except Exception as error:
                what = f"the callable for dM and dK failed: {type(error).__name__}: {error}"
                raise PkmodesError(what, where, "mend it, or leave the derivatives out") from error
            pair = self._pair(returned, ("dM", "dK"), where)
            for kind, matrix in zip(("dM", "dK"), pair, strict=True):
                if not np.isfinite(_entries(matrix)).all() or not _symmetric(matrix):
                    what = f"expected {kind} finite and symmetric"
                    raise PkmodesError(what, where, "mend it, or leave the derivatives out")
            found.append(Pair(*map(_thin, pair)))
        return found

    def _differences(self, values: Array, i: int, setups: Mapping[str, Pair]) -> list[Pair] | None:
        """The same by differences, with a step that changes the matrices as much as it should."""
        p = self.parameters[i]
        step = CHANGE * (max(abs(values[i]), p.sigma or 0.0) or 1.0)
        rates, finite = None, False
        for _ in range(TRIALS):
            ahead, behind = values.copy(), values.copy()
            ahead[i], behind[i] = min(values[i] + step, p.upper), max(values[i] - step, p.lower)
            if ahead[i] == behind[i]:
                break
            differences = [self._difference(ahead, behind, setup) for setup in setups]
            if any(pair is None for pair in differences):  # the step is far too large
                step *= 1e-3
                continue
            finite = True
            known = [pair for pair in differences if pair is not None]
            change = max(
                _relative(d, of)
                for pair, centre in zip(known, setups.values(), strict=True)
                for d, of in zip(pair, centre, strict=True)
            )
            if change > 0.0:
                width = ahead[i] - behind[i]
                rates = [Pair(pair.M / width, pair.K / width) for pair in known]
            whole = ahead[i] == p.upper and behind[i] == p.lower
            if abs(np.log(max(change, 1e-300) / CHANGE)) <= np.log(MISSED) or (
                change < CHANGE and (step > LARGEST or whole)
            ):
                break
            step *= min(max(CHANGE / change, 1e-6), 1e6) if change > 0.0 else 1e3
        if not finite:
            what = f"expected M and K finite on both sides of {p.name} = {values[i]:.10g}"
            remedy = "give the parameter the bounds within which it has a meaning, or give derivatives"
            raise PkmodesError(what, self._where(values, next(iter(setups))), remedy)
        return rates

    def _difference(self, ahead: Array, behind: Array, setup: str) -> Pair | None:
        after, before = self.at(ahead, setup), self.at(behind, setup)
        if after is None or before is None:
            return None
        return Pair(*(_thin(_minus(a, b)) for a, b in zip(after, before, strict=True)))

    def _named(self, values: Array) -> dict[str, float]:
        return {p.name: float(value) for p, value in zip(self.parameters, values, strict=True)}

    def _where(self, values: Array, setup: str) -> str:
        moved = [(p.name, v) for p, v in zip(self.parameters, values, strict=True) if v != p.value]
        text = ", ".join(f"{name} = {value:.10g}" for name, value in moved[:NAMED]) or "the declared values"
        more = f" and {len(moved) - NAMED} more" if len(moved) > NAMED else ""
        return f"matrices for setup {shown(setup)} at {text}{more}"

    def _pair(self, returned: Any, names: tuple[str, str], where: str) -> Pair:
        kind = f"({', '.join(names)})"
        if not isinstance(returned, tuple | list) or len(returned) != 2:
            what = f"expected a pair {kind}, found {type(returned).__name__}"
            raise PkmodesError(what, where, f"return {kind}")
        return Pair(*(self._matrix(m, name, where) for name, m in zip(names, returned, strict=True)))

    def _matrix(self, given: Any, name: str, where: str) -> Any:
        if not is_sparse(given):
            try:
                given = np.asarray(given)
            except (TypeError, ValueError) as error:
                raise PkmodesError(f"expected {name} as an array: {error}", where, "return arrays") from error
        if given.dtype.kind not in "biuf":
            found = "complex numbers" if given.dtype.kind == "c" else f"values of type {given.dtype}"
            remedy = "give real matrices: the modes are those without damping"
            raise PkmodesError(f"expected {name} of real numbers, found {found}", where, remedy)
        if given.dtype.kind == "f" and given.dtype.itemsize < 8 and self.derivatives is None:
            what = f"expected {name} in double precision, found {given.dtype}"
            remedy = "assemble it in float64, which differences need, or give derivatives"
            raise PkmodesError(what, where, remedy)
        n = self.expected
        if given.shape != (n, n):
            what = f"expected {name} of shape {(n, n)} for {self.reason}, found {given.shape}"
            raise PkmodesError(
                what, where, "give one channel for each coordinate, or coordinates= or sensors="
            )
        if is_sparse(given):
            return sparse.csc_array(given).astype(float)
        return given.astype(float)  # a copy: a callable may use its arrays again


def is_sparse(matrix: Any) -> bool:
    """Whether a matrix is one of SciPy's sparse ones."""
    return bool(sparse.issparse(matrix))


def _entries(matrix: Any) -> Array:
    entries: Array = matrix.data if is_sparse(matrix) else matrix
    return entries


def _count(matrix: Any) -> int:
    return int(matrix.nnz) if is_sparse(matrix) else int(np.count_nonzero(matrix))


def _symmetric(matrix: Any) -> bool:
    """Whether a matrix is symmetric but for rounding."""
    if is_sparse(matrix):
        apart, size = abs(matrix - matrix.T), abs(matrix)
        rounding = ROUNDING * float(size.max()) if size.nnz else 0.0
        if apart.nnz == 0 or apart.max() <= rounding:
            return True
        return bool((apart - RELATIVE * size).max() <= rounding)
    if np.array_equal(matrix, matrix.T):
        return True
    return np.allclose(matrix, matrix.T, rtol=RELATIVE, atol=ROUNDING * np.abs(matrix).max())


def _minus(a: Any, b: Any) -> Any:
    """A difference, of which one may have become dense where the other is not."""
    if is_sparse(a) != is_sparse(b):
        a, b = (x.toarray() if is_sparse(x) else x for x in (a, b))
    return a - b


def _thin(matrix: Any) -> Any:
    """A derivative: one parameter often changes few entries, and products with the shapes are then cheap."""
    n = matrix.shape[0]
    if n < MANY or _count(matrix) > FEW * n * n:
        return matrix.toarray() if is_sparse(matrix) else matrix
    return _packed(matrix)


def _packed(matrix: Any) -> Any:
    """A symmetric matrix as a sparse one, of which rows are columns."""
    if is_sparse(matrix):
        return sparse.csc_array(matrix)
    n, flat = len(matrix), np.ravel(matrix)
    places = np.flatnonzero(flat)  # several times as fast as over two axes
    starts = np.searchsorted(places, n * np.arange(n + 1))
    return sparse.csc_array((flat[places], places % n, starts), shape=matrix.shape)


def _relative(change: Any, of: Any) -> float:
    """Largest change of an entry, relative to the diagonal entries of its row and column."""
    size = np.sqrt(np.abs(of.diagonal()))
    if is_sparse(change):
        entries = change.tocoo()
        rows, columns, moved = entries.row, entries.col, np.abs(entries.data)
    else:
        rows, columns = np.nonzero(change)
        moved = np.abs(change[rows, columns])
    scale = size[rows] * size[columns]
    # Entries beside a zero on the diagonal (a free coordinate) have no scale of their own.
    scale[scale == 0.0] = np.abs(_entries(of)).max(initial=0.0)
    known = scale > 0.0
    return float((moved[known] / scale[known]).max(initial=0.0))
