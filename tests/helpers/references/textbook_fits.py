"""A log-linear structure, its simulated measurements, and their textbook least squares."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from helpers.robots.small_structures import LogLinear, log_linear
from pkmodes.loop.diagnosis import Candidate, Measurements, Parameter
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis

SIGMA = 0.002

#: Two nuisances, and two causes that are fitted freely.
PARAMETERS = (
    Parameter("n1", 0.3, sigma=0.05),
    Parameter("n2", -1.0, sigma=0.002),
    Parameter("u", 0.0),
    Parameter("v", 0.5),
)
CAUSES = (Candidate("u", ("u",)), Candidate("v", ("v",)))
DECLARED = np.array([p.value for p in PARAMETERS])
PRIORS = np.array([0.05, 0.002])


def structure(seed: int, setups: int = 5, modes: int = 4, **options: bool) -> LogLinear:
    found = log_linear(np.random.default_rng(seed), setups, modes, PARAMETERS, CAUSES, **options)
    found.G *= 0.02  # changes of some per cent, so that no mode is mistaken for another
    return found


def simulated(model: LogLinear, values: np.ndarray, seed: int, tau: float = 0.0) -> np.ndarray:
    rng = np.random.default_rng([seed, 1])
    y = model.base + model.G @ values
    return y + SIGMA * rng.standard_normal(y.shape) + tau * rng.standard_normal((len(y), 1))


def least_squares(
    G: np.ndarray, y: np.ndarray, V: np.ndarray, declared: np.ndarray, sigmas: Sequence[float | None]
) -> tuple[np.ndarray, np.ndarray, float]:
    """Generalised least squares with priors: estimates, covariance and least sum of squares."""
    precision = np.diag([0.0 if s is None else s**-2 for s in sigmas])
    information = G.T @ np.linalg.solve(V, G) + precision
    covariance = np.linalg.inv(information)
    found = covariance @ (G.T @ np.linalg.solve(V, y) + precision @ declared)
    left, moved = y - G @ found, found - declared
    return found, covariance, float(left @ np.linalg.solve(V, left) + moved @ precision @ moved)


def fitted(model: LogLinear, data: Measurements, hypothesis: Hypothesis) -> Fit:
    found = Fitter(model, data).fit(hypothesis)
    assert found is not None
    return found


BOTH = Hypothesis(CAUSES)
TRUE = np.array([0.36, -1.001, 0.4, 1.1])
