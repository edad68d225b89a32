"""Structures that are no robots, small enough that everything about them is known in closed form.

`LogLinear` has frequencies whose logarithms are linear in its parameters: least squares, covariances and
chi-square are those of textbooks.  `log_linear` draws one at random, `of_signatures` has the signatures that are
given in standard deviations; `with_changes` measures one that is given in the same way, `logs_measured` any.
`frame` is a row of masses and springs, measured by `frame_measured`, and `altered` one with other matrices.
`relative_frame` has a factor for each mass and spring, and `relative_modes` are its modes.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from scipy.linalg import eigh

from pkmodes.loop.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, Prediction
from pkmodes.loop.diagnosis.problem import Batch, Structure, predict_one_by_one


class LogLinear:
    """ln f = base + G theta in each setup; shapes are unit vectors.

    Parameters
    ----------
    base : ndarray, shape (S, m)
        ln f where all parameters are 0.
    G : ndarray, shape (S, m, T)
    parameters, candidates
    B : ndarray, shape (S, m, 3), optional
        Derivatives of ln f by the position of each setup.
    """

    def __init__(
        self,
        base: np.ndarray,
        G: np.ndarray,
        parameters: Sequence[Parameter],
        candidates: Sequence[Candidate] = (),
        B: np.ndarray | None = None,
    ) -> None:
        self.base, self.G, self.B = base, G, B
        self.parameters, self.candidates = tuple(parameters), tuple(candidates)
        self.channels = tuple(f"c{i}" for i in range(base.shape[1]))
        self.channel_units = ("m",) * len(self.channels)

    def predict(self, values: np.ndarray, by: Sequence[int], *, shape_rates: bool = False) -> Prediction:
        with np.errstate(over="ignore"):  # a fit may try anything
            eigenvalues = (2 * np.pi * np.exp(self.base + self.G @ values)) ** 2
        eigenvalues = np.where(np.isfinite(eigenvalues), eigenvalues, np.nan)
        rates = 2 * eigenvalues[..., None] * self.G[..., list(by)]
        shapes = np.broadcast_to(np.eye(self.base.shape[1]), (len(self.base), *[self.base.shape[1]] * 2))
        along = np.zeros((*shapes.shape, len(by))) if shape_rates else None
        return Prediction(eigenvalues, rates, shapes, 0, along)

    def predict_many(
        self, values: np.ndarray, by: Sequence[Sequence[int]], *, shape_rates: bool = False
    ) -> list[Batch]:
        return predict_one_by_one(self, values, by, shape_rates=shape_rates)

    def subset(self, setups: Sequence[int]) -> LogLinear:
        chosen = list(setups)
        B = None if self.B is None else self.B[chosen]
        return LogLinear(self.base[chosen], self.G[chosen], self.parameters, self.candidates, B)

    def position_rates(self, values: np.ndarray, *, shape_rates: bool = False) -> Prediction | None:
        if self.B is None:
            return None
        found = self.predict(values, (0, 0, 0), shape_rates=shape_rates)
        return replace(found, rates=2 * found.eigenvalues[..., None] * self.B)

    def elsewhere(self, count: int) -> tuple[np.ndarray, Structure] | None:
        return None


#: A relative error of frequencies that a test of a real structure reaches.
SIGMA = 0.002


def ladder(setups: int, modes: int) -> np.ndarray:
    """ln f of modes from 10 Hz that are half an octave apart, so that none is mistaken for another."""
    return np.tile(np.log(10.0) + 0.35 * np.arange(modes), (setups, 1))


def each(names: Iterable[str], **options: Any) -> list[Candidate]:
    """A candidate with the name of its only parameter, for each."""
    return [Candidate(name, (name,), **options) for name in names]


def log_linear(
    rng: np.random.Generator,
    setups: int,
    modes: int,
    parameters: Sequence[Parameter],
    candidates: Sequence[Candidate] = (),
    *,
    positions: bool = False,
) -> LogLinear:
    """A structure with random signatures."""
    G = rng.standard_normal((setups, modes, len(parameters)))
    B = rng.standard_normal((setups, modes, 3)) if positions else None
    return LogLinear(ladder(setups, modes), G, parameters, candidates, B)


def of_signatures(
    signatures: Mapping[str, np.ndarray],
    setups: int,
    modes: int,
    *,
    roles: Mapping[str, Mapping[str, Any]] = {},
    known: Mapping[str, Mapping[str, Any]] = {},
) -> LogLinear:
    """A structure that changes by a signature, in standard deviations, for each unit of a parameter.

    Parameters
    ----------
    signatures : mapping of str to ndarray
        By parameter: of all rows, setup by setup.
    setups, modes : int
    roles, known : mapping of str to mapping
        Options of the candidates and of the parameters.  A parameter with a sigma is uncertain, and no candidate.
    """
    parameters = [Parameter(name, 0.0, **known.get(name, {})) for name in signatures]
    causes = [Candidate(p.name, (p.name,), **roles.get(p.name, {})) for p in parameters if p.sigma is None]
    G = np.stack([one.reshape(setups, modes) for one in signatures.values()], axis=-1) * SIGMA
    return LogLinear(ladder(setups, modes), G, parameters, causes)


def directions(rows: int, count: int, seed: int = 11) -> np.ndarray:
    """Orthonormal directions in the space of all rows, for signatures."""
    return np.linalg.qr(np.random.default_rng(seed).standard_normal((rows, count)))[0].T


def errors(rows: int, beside: np.ndarray | None = None) -> np.ndarray:
    """Errors in standard deviations; none in the directions that are given, so that what is there is exact."""
    drawn = 0.9 * np.random.default_rng(3).standard_normal(rows)
    return drawn if beside is None else drawn - beside.T @ (beside @ drawn)


def with_changes(model: LogLinear, changes: np.ndarray) -> Measurements:
    """Frequencies that differ from the declared ones by so many standard deviations."""
    return logs_measured(model.base + SIGMA * changes.reshape(model.base.shape), SIGMA)


def logs_measured(
    y: np.ndarray, sigma: np.ndarray | float, point_sigma: np.ndarray | None = None
) -> Measurements:
    """Measurements with logarithms y, (S, m), and their standard deviations; setups P0, P1 ..."""
    setups, modes = y.shape
    f = np.exp(y).ravel()
    stated = np.broadcast_to(sigma, y.shape).ravel()
    spread = None if point_sigma is None else np.repeat(point_sigma, modes, axis=0)
    return Measurements.from_rows(
        [f"P{i}" for i in range(setups) for _ in range(modes)], f, stated * f, point_sigma=spread
    )


def some_rows(data: Measurements, rows: Any, **more: Any) -> Measurements:
    """Some rows, or all in another order; `more` as for `Measurements.from_rows`."""
    labels = [data.labels[i] for i in data.pose[rows]]
    return Measurements.from_rows(labels, data.frequency[rows], data.sigma[rows], **more)


def in_a_row(k: np.ndarray) -> np.ndarray:
    """K of masses in a row on springs, the first of which stands on the ground."""
    return np.diag(k + np.append(k[1:], 0.0)) - np.diag(k[1:], 1) - np.diag(k[1:], -1)


def columns(shapes: np.ndarray, name: str = "floor ", first: int = 1) -> dict[str, np.ndarray]:
    """Columns of measured shapes (rows, channels) by numbered channels."""
    return {f"{name}{first + k}": column for k, column in enumerate(shapes.T)}


def normalised(vectors: np.ndarray) -> np.ndarray:
    """Rows of shapes, their largest component 1, from modes in columns."""
    return vectors.T / np.abs(vectors.T).max(axis=1, keepdims=True)


MASS, STIFFNESS = 20.0, 4.0e5
#: Two setups of a frame: mass on its roof [kg].
LOADS = {"empty": 0.0, "loaded": 5.0}


def frame_matrices(storeys: int, loads: Mapping[str, float], unit: float = 1.0) -> Callable:
    """M and K of a shear frame on the ground, with some mass on its roof in each setup; mass in kg / unit."""

    def matrices(values: Mapping[str, float], setup: str) -> tuple[np.ndarray, np.ndarray]:
        M = values["mass"] * np.eye(storeys)
        M[-1, -1] += loads[setup] * unit
        M[0, 0] += values["first floor"]
        k = values["storey"] + np.array([values[f"brace {i}"] for i in range(1, storeys + 1)])
        return M, in_a_row(k)

    return matrices


def frame_derivatives(storeys: int) -> Callable:
    """Their derivatives, from the definition."""

    def derivatives(values: Mapping[str, float], setup: str, name: str) -> tuple[np.ndarray, np.ndarray]:
        dM, dK = np.zeros((storeys, storeys)), np.zeros((storeys, storeys))
        springs = {"storey": range(storeys)}
        springs |= {f"brace {i}": range(i - 1, i) for i in range(1, storeys + 1)}
        for i in springs.get(name, ()):
            stretch = np.eye(storeys)[i] - (np.eye(storeys)[i - 1] if i else 0.0)
            dK += np.outer(stretch, stretch)
        dM += {"mass": np.eye(storeys), "first floor": np.diag(np.eye(storeys)[0])}.get(name, 0.0)
        return dM, dK

    return derivatives


def frame(
    loads: Mapping[str, float],
    *,
    storeys: int = 4,
    unit: float = 1.0,
    only: Sequence[str] | None = None,
    exact: bool = True,
) -> MatrixStructure:
    """A shear frame whose mass and stiffness are uncertain, and that may have a brace or a mass too many.

    Parameters
    ----------
    loads : mapping of str to float
        Mass on the roof in each setup [kg].
    storeys : int
    unit : float
        Masses are in kg / unit and stiffnesses in N/m / unit.
    only : sequence of str, optional
        Candidates; by default all.
    exact : bool
        Whether derivatives are given.
    """
    parameters = [
        Parameter("mass", MASS * unit, "kg", sigma=0.005 * MASS * unit),
        Parameter("storey", STIFFNESS * unit, "N/m", sigma=0.03 * STIFFNESS * unit),
        Parameter("first floor", 0.0, "kg", lower=0.0),
        *(Parameter(f"brace {i}", 0.0, "N/m", lower=0.0) for i in range(1, storeys + 1)),
    ]
    names = [p.name for p in parameters if p.sigma is None] if only is None else only
    return MatrixStructure(
        parameters,
        [Candidate(name, (name,), f"there is a {name}") for name in names],
        frame_matrices(storeys, loads, unit),
        derivatives=frame_derivatives(storeys) if exact else None,
        channels=[f"floor {i}" for i in range(1, storeys + 1)],
        setups=list(loads),
    )


def altered(plain: MatrixStructure, matrices: Callable, **changes: Any) -> MatrixStructure:
    """A structure with other matrices, and perhaps another of its arguments."""
    kept = {name: getattr(plain, name) for name in ("parameters", "candidates", "channels", "setups")}
    return MatrixStructure(matrices=matrices, **(kept | changes))


def frame_measured(
    loads: Mapping[str, float],
    truth: Mapping[str, float],
    rng: np.random.Generator,
    *,
    storeys: int = 4,
    stated: float = SIGMA,
    shapes: float | None = None,
    change: Callable[[np.ndarray, np.ndarray], None] | None = None,
) -> Measurements:
    """What a test of the frame would give, by SciPy's solver.

    Parameters
    ----------
    loads, storeys
        As for `frame`.
    truth : mapping of str to float
        What is not as declared, in kg and N/m.
    rng : numpy.random.Generator
        Of the errors, SIGMA in ln f.
    stated : float
        Their standard deviation as stated.
    shapes : float, optional
        Relative error of shapes, where they are measured.
    change : callable, optional
        Changes M and K in place: something that no candidate describes.
    """
    values = {"mass": MASS, "storey": STIFFNESS, "first floor": 0.0}
    values |= {f"brace {i}": 0.0 for i in range(1, storeys + 1)} | dict(truth)
    pose, logs, rows = [], [], []
    for setup in loads:
        M, K = frame_matrices(storeys, loads)(values, setup)
        if change is not None:
            change(M, K)
        eigenvalues, modes = eigh(K, M)
        pose += [setup] * storeys
        logs += list(0.5 * np.log(eigenvalues) - np.log(2 * np.pi) + SIGMA * rng.standard_normal(storeys))
        if shapes is not None:
            rows += list(modes.T * (1 + shapes * rng.standard_normal(modes.shape)))
    f = np.exp(logs)
    found = columns(np.array(rows)) if rows else None
    return Measurements.from_rows(pose, f, stated * f, shapes=found)


def uncertain(rng: np.random.Generator) -> dict[str, float]:
    """Values of the frame's nuisances, drawn from their priors."""
    mass, stiffness = 1 + 0.005 * rng.standard_normal(), 1 + 0.03 * rng.standard_normal()
    return {"mass": MASS * mass, "storey": STIFFNESS * stiffness}


#: A frame with values relative to the declared ones, in one setup.
STOREYS = 4
RELATIVE = [f"{kind} {i}" for kind in ("storey", "mass") for i in range(1, STOREYS + 1)]


def relative_matrices(values: Mapping[str, float], _: str = "") -> tuple[np.ndarray, np.ndarray]:
    """M and K for the factors ``storey 1`` to ``mass 4``, and one of all storeys, ``stiffness``."""
    k = 1e6 * values["stiffness"] * np.array([values[f"storey {i}"] for i in range(1, STOREYS + 1)])
    return np.diag(100.0 * np.array([values[f"mass {i}"] for i in range(1, STOREYS + 1)])), in_a_row(k)


def relative_frame(
    prior: float, priors: Callable[[str], float | None] = lambda _: None, **bounds: float
) -> MatrixStructure:
    """The frame whose stiffness is uncertain, and in which each factor may be wrong, with a prior or without."""
    parameters = [Parameter("stiffness", 1.0, sigma=prior, lower=0.1)]
    parameters += [Parameter(name, 1.0, **bounds) for name in RELATIVE]
    given = {name: priors(name) for name in RELATIVE}
    causes = [Candidate(name, (name,), sigma=None if s is None else (s,)) for name, s in given.items()]
    channels = [f"floor {i}" for i in range(1, STOREYS + 1)]
    return MatrixStructure(parameters, causes, relative_matrices, channels=channels)


def relative_modes(truth: Mapping[str, float]) -> tuple[np.ndarray, np.ndarray]:
    """Frequencies and shapes of the frame, by SciPy's solver."""
    M, K = relative_matrices({"stiffness": 1.0} | dict.fromkeys(RELATIVE, 1.0) | dict(truth))
    eigenvalues, vectors = eigh(K, M)
    return np.sqrt(eigenvalues) / (2 * np.pi), normalised(vectors)


def mixture(n: int, still: int, seed: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """M of rank n - still with directions of its own, K, and the motions without mass."""
    rng = np.random.default_rng(seed)
    A, B = rng.standard_normal((2, n, n))
    Q = np.linalg.qr(B)[0]
    M = (Q[:, still:] * rng.uniform(1.0, 3.0, n - still)) @ Q[:, still:].T
    return 0.5 * (M + M.T), A @ A.T + n * np.eye(n), Q[:, :still]
