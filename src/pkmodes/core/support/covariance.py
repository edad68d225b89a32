"""The covariance of the uncertain values of a robot: their standard deviations, and the tables ``[[covariance]]``."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.covariance import SIGMA_TOLERANCE, Covariance
from pkmodes.core.robot.layout import table_sources
from pkmodes.core.robot.robot import Robot

Array = NDArray[np.float64]


def sigmas_by_path(robot: Robot) -> dict[str, float]:
    """Return the standard deviations above 0 of a robot by path [SI]; a value that an effect takes counts once."""
    duplicates = {
        path for path, table_path in table_sources(robot.mechanism).items() if table_path in robot.quantities
    }
    return {path: q.sigma for path, q in robot.quantities.items() if q.sigma and path not in duplicates}


def covariance_of(robot: Robot, paths: Sequence[str]) -> Array:
    """Return the covariance of uncertain values that enters the frequencies, (k, k) [SI].

    The covariance of some values is that of all, without the others' rows and columns: those may have any value.
    """
    sigmas = sigmas_by_path(robot)
    matrix = np.diag([sigmas[path] ** 2 for path in paths])
    index_of = {path: i for i, path in enumerate(paths)}
    for table in robot.covariance:
        table_sigmas = _sigmas(table, sigmas)
        members = [k for k, path in enumerate(table.paths) if path in index_of]
        indices = [index_of[table.paths[k]] for k in members]
        matrix[np.ix_(indices, indices)] = (
            np.array(table.correlation) * np.outer(table_sigmas, table_sigmas)
        )[np.ix_(members, members)]
    return matrix


class Prior(NamedTuple):
    """Standard deviation of a value [SI], None where it has none, and its correlations with others by path."""

    sigma: float | None = None
    correlated: tuple[tuple[str, float], ...] = ()


def priors_of(robot: Robot) -> dict[str, Prior]:
    """Return the priors of the uncertain values of a robot by path.

    A value and its table of correlations may state one standard deviation with different numbers of digits: that of
    the table counts, because small differences of strongly correlated values depend on its digits.
    """
    declared, correlations = sigmas_by_path(robot), {}
    tables = [(table, _sigmas(table, declared)) for table in robot.covariance]
    sigmas = declared | {
        path: sigma
        for table, table_sigmas in tables
        for path, sigma in zip(table.paths, table_sigmas, strict=True)
        if abs(declared[path] - sigma) <= SIGMA_TOLERANCE * sigma
    }
    for table, table_sigmas in tables:
        ratios = np.array(table_sigmas) / [sigmas[path] for path in table.paths]
        coefficients = np.array(table.correlation) * np.outer(ratios, ratios)
        for i, path in enumerate(table.paths):
            partners = [
                (partner, float(coefficients[i, k])) for k, partner in enumerate(table.paths) if k != i
            ]
            correlations[path] = tuple(
                (partner, coefficient) for partner, coefficient in partners if coefficient
            )
    return {path: Prior(sigma, correlations.get(path, ())) for path, sigma in sigmas.items()}


def covariance_root(covariance: Array) -> Array:
    """Return a matrix L with L L^T = C, (k, r), by its eigenvectors: C may be singular.

    It is diagonal where C is.
    """
    sigmas = np.sqrt(np.diagonal(covariance))
    if not (covariance - np.diag(np.diagonal(covariance))).any():
        return np.diag(sigmas)
    scale = np.where(sigmas > 0.0, sigmas, 1.0)
    values, vectors = np.linalg.eigh(covariance / np.outer(scale, scale))
    significant = values > len(values) * np.finfo(float).eps
    root: Array = scale[:, None] * vectors[:, significant] * np.sqrt(values[significant])
    return root


def _sigmas(table: Covariance, value_sigmas: Mapping[str, float]) -> list[float]:
    return [value_sigmas[path] for path in table.paths] if table.sigmas is None else list(table.sigmas)


def joined_covariance(tables: Sequence[Covariance], value_sigmas: Mapping[str, float]) -> Covariance:
    """Return one table of the values of several, which stay independent of each other.

    - value_sigmas: standard deviations of the values themselves, by path, for tables that have none of their own
    """
    if len(tables) == 1:
        return tables[0]
    sigmas = None
    if any(table.sigmas is not None for table in tables):
        sigmas = tuple(sigma for table in tables for sigma in _sigmas(table, value_sigmas))
    ends = np.cumsum([0, *(len(table.paths) for table in tables)])
    blocks = np.zeros((ends[-1], ends[-1]))
    for table, start, end in zip(tables, ends, ends[1:], strict=False):
        blocks[start:end, start:end] = table.correlation
    return Covariance(
        tuple(path for table in tables for path in table.paths),
        tuple(tuple(row) for row in blocks.tolist()),
        sigmas,
    )
