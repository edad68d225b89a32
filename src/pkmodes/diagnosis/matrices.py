"""A structure given by callables for M and K: the way in for any model that is not a robot of this package."""

from __future__ import annotations

import contextlib
from collections.abc import Callable, Mapping, Sequence

import numpy as np

from pkmodes.diagnosis.problem import Array, Candidate, Parameter, Prediction, Structure
from pkmodes.eigen import generalised_eigh
from pkmodes.errors import PkmodesError, listed, shown

Matrices = Callable[[Mapping[str, float], str], tuple[Array, Array]]
Derivatives = Callable[[Mapping[str, float], str, str], tuple[Array, Array]]

#: Relative change of the matrices at which differences stand in for derivatives: rounding and curvature balance.
CHANGE = 1e-6
#: How far that change may be missed, and how many steps are tried.  Steps grow up to LARGEST, for a parameter that
#: changes nothing.
MISSED, TRIALS, LARGEST = 100.0, 30, 1e12
#: Eigenvalues below zero by less than this fraction of the largest are zero but for rounding.
STABLE = 1e-9
#: What is left unsymmetric by rounding, relative to the largest entry.
ROUNDING = 1e-12


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
        setup; both (n, n) and symmetric, M positive definite, in consistent units (K / M in 1/s^2).
    derivatives : callable, optional
        ``derivatives(values, setup, name) -> (dM, dK)`` by the parameter of that name.  Without it, differences
        of the matrices are taken, with a step that changes them by a millionth, whatever the unit.
    channels : sequence of str
        Names of the n coordinates, as the shape columns of the measurements have them.
    setups : sequence of str
        Labels of the setups, as the measurements have them, in any order.
    rigid : int
        Rigid-body modes, which are not measured.  Other modes are stable: K has no negative eigenvalue for them.

    Raises
    ------
    PkmodesError
        If names are repeated or missing, numbers contradict each other, or the matrices do not have the form
        above.
    """

    def __init__(
        self,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate],
        matrices: Matrices,
        *,
        channels: Sequence[str],
        derivatives: Derivatives | None = None,
        setups: Sequence[str] = ("",),
        rigid: int = 0,
    ) -> None:
        self.parameters: tuple[Parameter, ...] = tuple(
            listed(parameters, "parameters", "parameters", 'Parameter("k", 1e6)', Parameter)
        )
        self.candidates: tuple[Candidate, ...] = tuple(
            listed(candidates, "candidates", "candidates", 'Candidate("k", ("k",), "")', Candidate)
        )
        self.channels: tuple[str, ...] = tuple(listed(channels, "names", "channels", '"x_1"', str))
        self.setups: tuple[str, ...] = tuple(listed(setups, "labels", "setups", '"P1"', str))
        _check_callables(matrices, derivatives)
        if isinstance(rigid, bool) or not isinstance(rigid, int | np.integer) or rigid < 0:
            raise PkmodesError(
                f"expected a number of modes, found {shown(rigid)}", "rigid", "count the rigid-body modes"
            )
        self.rigid = int(rigid)
        self._matrices, self._derivatives = matrices, derivatives
        for p in self.parameters:
            _check_parameter(p)
        for kind, labels in (
            ("parameter", [p.name for p in self.parameters]),
            ("candidate", [c.name for c in self.candidates]),
            ("channel", self.channels),
            ("setup", self.setups),
        ):
            _check_names(kind, labels)
        for candidate in self.candidates:
            _check_candidate(candidate, {p.name: p for p in self.parameters})
        values = np.array([p.value for p in self.parameters])
        for setup in self.setups:
            self._checked(*self._at(values, setup), setup)

    def subset(self, setups: Sequence[int]) -> MatrixStructure:
        """The same structure in some of its setups."""
        return MatrixStructure(
            self.parameters,
            self.candidates,
            self._matrices,
            channels=self.channels,
            derivatives=self._derivatives,
            setups=[self.setups[i] for i in setups],
            rigid=self.rigid,
        )

    def predict(self, values: Array, by: Sequence[int]) -> Prediction:
        """Modes in all setups, with derivatives by some of the parameters."""
        M, K = self._stacked(values)
        eigenvalues, shapes = np.full(M.shape[:2], np.nan), np.zeros(M.shape)
        for setup in range(len(self.setups)):
            if np.isfinite(M[setup]).all() and np.isfinite(K[setup]).all():
                # A singular M is no mistake here: a fit may try any value within the bounds.
                with contextlib.suppress(np.linalg.LinAlgError):
                    one = slice(setup, setup + 1)
                    eigenvalues[one], shapes[one] = generalised_eigh(M[one], K[one])
        # What buckles does not vibrate: sqrt(|lambda|) would be no frequency.
        least = -STABLE * np.abs(eigenvalues).max(axis=1, initial=0.0)
        eigenvalues[(eigenvalues[:, self.rigid :] < least[:, None]).any(axis=1)] = np.nan
        rates = np.full((*eigenvalues.shape, len(by)), np.nan)
        for k, i in enumerate(by if np.isfinite(eigenvalues).any() else ()):
            dM, dK = self._rates(values, i, M, K)
            both = [np.einsum("sma,sab,smb->sm", shapes, d, shapes, optimize=True) for d in (dM, dK)]
            rates[..., k] = both[1] - eigenvalues * both[0]
        return Prediction(eigenvalues, rates, shapes, self.rigid)

    def position_rates(self, values: Array) -> None:
        """Setups have no position."""

    def elsewhere(self, count: int) -> tuple[Array, Structure] | None:
        """No other setups are known."""

    def _at(self, values: Array, setup: str) -> tuple[Array, Array]:
        named = {p.name: float(value) for p, value in zip(self.parameters, values, strict=True)}
        found = self._matrices(named, setup)
        try:
            M, K = found
            if np.iscomplexobj(M) or np.iscomplexobj(K):
                raise TypeError("complex numbers")
            M, K = np.asarray(M, dtype=float), np.asarray(K, dtype=float)
        except (TypeError, ValueError, OverflowError):
            what = f"expected two matrices of numbers, found {shown(found)}"
            raise PkmodesError(what, f"matrices for setup {shown(setup)}", "return M and K") from None
        return M, K

    def _stacked(self, values: Array) -> tuple[Array, Array]:
        """M and K of all setups, (S, n, n)."""
        pairs = [self._at(values, setup) for setup in self.setups]
        M, K = (np.stack(column) for column in zip(*pairs, strict=True))
        return M, K

    def _rates(self, values: Array, i: int, M: Array, K: Array) -> tuple[Array, Array]:
        """Derivatives of M and K by one parameter, in all setups."""
        if self._derivatives is None:
            return self._differences(values, i, M, K)
        named = {p.name: float(value) for p, value in zip(self.parameters, values, strict=True)}
        pairs = [self._derivatives(named, setup, self.parameters[i].name) for setup in self.setups]
        dM, dK = (
            np.stack([np.asarray(d, dtype=float) for d in column]) for column in zip(*pairs, strict=True)
        )
        return dM, dK

    def _differences(self, values: Array, i: int, M: Array, K: Array) -> tuple[Array, Array]:
        """The same by differences, with a step that changes the matrices as much as it should."""
        p = self.parameters[i]
        step = CHANGE * (max(abs(values[i]), p.sigma or 0.0) or 1.0)
        dM, dK = np.zeros_like(M), np.zeros_like(K)
        for _ in range(TRIALS):
            ahead, behind = values.copy(), values.copy()
            ahead[i], behind[i] = min(values[i] + step, p.upper), max(values[i] - step, p.lower)
            with np.errstate(invalid="ignore"):  # infinite matrices, where the step is far too large
                differences = [
                    a - b for a, b in zip(self._stacked(ahead), self._stacked(behind), strict=True)
                ]
            change = float(np.max([_relative(d, of) for d, of in zip(differences, (M, K), strict=True)]))
            if not np.isfinite(change):
                step *= 1e-3
                continue
            if change > 0.0:
                dM, dK = (d / (ahead[i] - behind[i]) for d in differences)
            whole = ahead[i] == p.upper and behind[i] == p.lower
            if abs(np.log(max(change, 1e-300) / CHANGE)) <= np.log(MISSED) or (
                change < CHANGE and (step > LARGEST or whole)
            ):
                break
            step *= min(max(CHANGE / change, 1e-6), 1e6) if change > 0.0 else 1e3
        return dM, dK

    def _checked(self, M: Array, K: Array, setup: str) -> None:
        where, n = f"matrices for setup {shown(setup)}", len(self.channels)
        for name, matrix in (("M", M), ("K", K)):
            if matrix.shape != (n, n):
                what = f"expected {name} of shape {(n, n)} for {n} channels, found {matrix.shape}"
                raise PkmodesError(what, where, "give one channel for each coordinate")
            rounding = ROUNDING * np.abs(matrix).max()
            if not np.isfinite(matrix).all() or not np.allclose(matrix, matrix.T, rtol=1e-9, atol=rounding):
                raise PkmodesError(
                    f"expected {name} finite and symmetric", where, "check how it is assembled"
                )
        if np.linalg.eigvalsh(M)[0] <= 0.0:
            raise PkmodesError("expected M positive definite", where, "give every coordinate a mass")


def at_measured(structure: Structure, labels: Sequence[str]) -> Structure:
    """Return the structure at the measured setups, in the order of the measurements.

    Parameters
    ----------
    structure : Structure
        A `MatrixStructure` is put in order by its labels; another has the setups of the measurements already.
    labels : sequence of str
        Labels of the measurements.

    Raises
    ------
    PkmodesError
        If a `MatrixStructure` has no setup of that label.
    """
    if not isinstance(structure, MatrixStructure) or (structure.setups == ("",) and len(labels) == 1):
        return structure
    for label in labels:
        if label not in structure.setups:
            what = f"the structure has no setup {shown(label)}, which was measured"
            raise PkmodesError(what, "setups", f"setups are: {', '.join(map(shown, structure.setups))}")
    return structure.subset([structure.setups.index(label) for label in labels])


def _relative(change: Array, of: Array) -> float:
    """Largest change of an entry, relative to the diagonal entries of its row and column; NaN if not finite."""
    size = np.sqrt(np.abs(np.diagonal(of, axis1=-2, axis2=-1)))
    scale = size[..., :, None] * size[..., None, :]
    # Entries beside a zero on the diagonal (a free coordinate) have no scale of their own.
    scale = np.where(scale > 0.0, scale, np.abs(of).max())
    known = scale > 0.0
    return float((np.abs(change[known]) / scale[known]).max(initial=0.0))


def _check_names(kind: str, names: Sequence[str]) -> None:
    for name in names:
        if names.count(name) > 1:
            raise PkmodesError(f"two {kind}s are called {shown(name)}", f"{kind}s", "rename one")


def _check_callables(matrices: object, derivatives: object) -> None:
    for name, given in (("matrices", matrices), ("derivatives", derivatives)):
        if not callable(given) and not (name == "derivatives" and given is None):
            what = f"expected a function, found {shown(given)}"
            raise PkmodesError(what, name, "give one of the values by name and the label of a setup")


def _check_parameter(p: Parameter) -> None:
    where = f"parameter {shown(p.name)}"
    if not isinstance(p.name, str):
        raise PkmodesError(f"expected a name, found {shown(p.name)}", "parameters", "give text")
    for number in (p.lower, p.value, p.upper, *(() if p.sigma is None else (p.sigma,))):
        whole = isinstance(number, np.integer) or (type(number) is int and number.bit_length() < 1000)
        if not (whole or isinstance(number, float | np.floating)):
            raise PkmodesError(f"expected a number, found {shown(number)}", where, "give a number")
    if not p.lower < p.upper or not p.lower <= p.value <= p.upper or not np.isfinite(p.value):
        what = f"expected lower <= value <= upper, found {p.lower:g}, {p.value:g}, {p.upper:g}"
        raise PkmodesError(what, where, "widen the bounds or correct the value")
    if p.sigma is not None and not 0.0 <= p.sigma < np.inf:
        what = f"expected a standard deviation of at least 0, found {p.sigma:g}"
        raise PkmodesError(what, where, "leave it out when unknown")


def _check_candidate(candidate: Candidate, parameters: Mapping[str, Parameter]) -> None:
    where = f"candidate {shown(candidate.name)}"
    if not isinstance(candidate.name, str):
        raise PkmodesError(f"expected a name, found {shown(candidate.name)}", "candidates", "give text")
    names = listed(candidate.parameters, "names of parameters", where, '"k"', str)
    if not names or len(set(names)) < len(names):
        raise PkmodesError(f"expected different parameters, found {list(names)}", where, "name each once")
    for name in names:
        if name not in parameters:
            what = f"it has a parameter {shown(name)} that is not there"
            raise PkmodesError(what, where, f"parameters are: {', '.join(parameters)}")
        sigma = parameters[name].sigma
        if sigma is not None:
            state = "refitted under every hypothesis" if sigma else "known exactly"
            what = f"its parameter {shown(name)} has a sigma: it is {state}"
            raise PkmodesError(what, where, "leave out the candidate, or the sigma")
