"""Priors as additional data: always for nuisances, for parameters of candidates if the candidate is assumed."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import PkmodesError, shown
from pkmodes.diagnosis.problem import Array, Candidate, Parameter


class Priors:
    """Normal and log-normal priors of the parameters that have one.

    Parameters
    ----------
    widened : float, optional
        Factor on all standard deviations.

    Attributes
    ----------
    index : ndarray of int, shape (P,)
        Indices of the parameters with a prior.
    sigma : ndarray, shape (P,)
        Their standard deviations, of the logarithms if they are log-normal.

    Raises
    ------
    PkmodesError
        If a prior is not positive, a candidate does not have one for each parameter, two candidates contradict each
        other, or a log-normal parameter is not positive.
    """

    def __init__(
        self, parameters: Sequence[Parameter], candidates: Sequence[Candidate], widened: float = 1.0
    ) -> None:
        sigmas = {i: p.sigma for i, p in enumerate(parameters) if p.sigma}
        names = {p.name: i for i, p in enumerate(parameters)}
        for candidate in candidates:
            if candidate.sigma is None:
                continue
            where = f"candidate {shown(candidate.name)}"
            if len(candidate.sigma) != len(candidate.parameters):
                what = (
                    f"expected {len(candidate.parameters)} standard deviations, found {len(candidate.sigma)}"
                )
                raise PkmodesError(what, where, "give one for each of its parameters")
            for name, sigma in zip(candidate.parameters, candidate.sigma, strict=True):
                if not 0.0 < sigma < np.inf:
                    what = f"expected a standard deviation above 0, found {sigma:g}"
                    raise PkmodesError(what, where, "leave sigma out if unknown")
                if sigmas.setdefault(names[name], sigma) != sigma:
                    what = f"{shown(name)} has two priors: {sigmas[names[name]]:g} and {sigma:g}"
                    raise PkmodesError(what, where, "give the same one in every candidate")
        self.index: NDArray[np.intp] = np.array(sorted(sigmas), dtype=np.intp)
        self._row = {i: row for row, i in enumerate(self.index.tolist())}
        self.sigma = widened * np.array([sigmas[i] for i in sorted(sigmas)], dtype=float)
        self._declared = np.array([parameters[i].value for i in self.index])
        self._log = np.array([parameters[i].log for i in self.index], dtype=bool)
        for i in self.index[self._log & (self._declared <= 0.0)]:
            what = f"expected a positive value for a log-normal prior, found {parameters[i].value:g}"
            raise PkmodesError(what, f"parameter {shown(parameters[i].name)}", "leave out log=True")

    def residual(self, values: Array) -> Array:
        """Return the distances from the declared values in standard deviations, (P,)."""
        at = values[self.index]
        with np.errstate(divide="ignore", invalid="ignore"):
            away = np.where(
                self._log, np.log(np.maximum(at, 1e-300) / np.where(self._log, self._declared, 1.0)), 0.0
            )
        away = np.where(self._log, away, at - self._declared)
        return np.asarray(away / self.sigma)

    def rates(self, values: Array, free: Sequence[int]) -> Array:
        """Return the derivatives of the residual with respect to some parameters, (P, k)."""
        derivatives, width = np.zeros((len(self.index), len(free))), self.width(values)
        for column, i in enumerate(free):
            if (row := self.of(i)) is not None:
                derivatives[row, column] = width[row] ** -1
        return derivatives

    def width(self, values: Array) -> Array:
        """Return the standard deviations in the units of the parameters, (P,)."""
        return np.where(self._log, self.sigma * np.maximum(np.abs(values[self.index]), 1e-300), self.sigma)

    def of(self, i: int) -> int | None:
        """Return the index of a parameter among those with a prior; None if it has none."""
        return self._row.get(i)
