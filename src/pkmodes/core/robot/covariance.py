r"""The tables ``[[covariance]]`` of a robot file: values with correlated errors.

Each names values with a ``sigma`` and their correlations r.  Where it has a list ``sigma`` of its own, s, the
covariance of two of its values is :math:`s_i s_j r_{ij}`; without one, s are the values' own standard deviations.
Values in no table, or in different ones, are independent.

A value's own standard deviation may be larger than s.  The rest, :math:`\sigma_i^2 - s_i^2`, comes from other values
in the file that have no ``sigma``: a fitted value compensates their errors, and the compensation does not change the
frequencies.  So the frequencies have the covariance from s, and a value itself, such as a prior, has its sigma.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import is_number
from pkmodes.core.base.errors import nearest_name, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot import schema
from pkmodes.core.robot.layout import table_sources
from pkmodes.core.robot.units import Quantity, dimension_of, with_unit

COVARIANCE = "covariance"
PATHS, SIGMA, CORRELATION = "paths", "sigma", "correlation"
#: Tolerances for rounding in a file: of the symmetry, the diagonal and the smallest eigenvalue of a matrix; and of a
#: sigma, which programs write with three digits.
ROUNDING, SIGMA_TOLERANCE = 1e-6, 1e-2

Array = NDArray[np.float64]
Problem = Callable[[str, str, str], None]


@dataclass(frozen=True)
class Covariance:
    """Values with correlated errors.

    - paths: in the order of the table, length k
    - correlation: symmetric and positive semidefinite, 1 on its diagonal
    - sigmas: standard deviations to which the correlations apply, length k [SI]; None for those of the values
    """

    paths: tuple[str, ...]
    correlation: tuple[tuple[float, ...], ...]
    sigmas: tuple[float, ...] | None = None

    def without(self, paths: Collection[str]) -> Covariance:
        """Return the table of the other values."""
        kept = [i for i, path in enumerate(self.paths) if path not in paths]
        return Covariance(
            tuple(self.paths[i] for i in kept),
            tuple(tuple(self.correlation[i][k] for k in kept) for i in kept),
            None if self.sigmas is None else tuple(self.sigmas[i] for i in kept),
        )

    def raw(self) -> dict[str, Any]:
        """Return the table as a robot file has it."""
        table: dict[str, Any] = {PATHS: list(self.paths)}
        if self.sigmas is not None:
            table[SIGMA] = list(self.sigmas)
        return {**table, CORRELATION: [list(row) for row in self.correlation]}


def with_sigmas(
    tables: Sequence[Covariance], new_sigmas: Mapping[str, float | None]
) -> tuple[Covariance, ...]:
    """Return the tables of a robot with some new standard deviations, None or 0 for none.

    A value without one leaves its table; one with another keeps its correlations.
    """
    changed = []
    for table in tables:
        removed = {path for path in table.paths if path in new_sigmas and not new_sigmas[path]}
        remaining = table.without(removed)
        if remaining.sigmas is not None:
            sigmas = (new_sigmas.get(p) or s for p, s in zip(remaining.paths, remaining.sigmas, strict=True))
            remaining = Covariance(remaining.paths, remaining.correlation, tuple(sigmas))
        if remaining.paths:
            changed.append(remaining)
    return tuple(changed)


def read_covariance(
    raw: Any, mechanism: Mechanism, quantities: Mapping[str, Quantity], problem: Problem
) -> tuple[Covariance, ...]:
    """Read the tables.

    - raw: the list of tables in the parsed file
    - quantities: every declared value by path
    - problem: takes the path, what is wrong, and the remedy of each problem

    Returns those without a problem; a value that an effect takes from a table of the file has its path there.
    """
    if not isinstance(raw, list) or not all(isinstance(table, Mapping) for table in raw):
        actual = shown(raw)
        problem(COVARIANCE, f"expected tables, found {actual}", f"write each below [[{COVARIANCE}]]")
        return ()
    tables, table_number = [], dict[str, int]()
    for number, table in enumerate(raw, start=1):
        where = f"{COVARIANCE}.{number}"
        for key in table:
            if key not in (PATHS, SIGMA, CORRELATION):
                name = key if schema.is_bare_key(key) else shown(key)
                valid_keys = (PATHS, CORRELATION, SIGMA)
                problem(f"{where}.{name}", f"unknown key {shown(key)}", nearest_name(key, valid_keys))
        paths = _paths(table.get(PATHS), where, mechanism, quantities, table_number, number, problem)
        if paths is None:
            continue
        correlation = _correlation(table.get(CORRELATION), len(paths), f"{where}.{CORRELATION}", problem)
        sigmas = None
        if SIGMA in table:
            members = [quantities[path] for path in paths]
            sigmas = _table_sigmas(table[SIGMA], members, f"{where}.{SIGMA}", problem)
            if sigmas is None:
                continue
        if correlation is not None:
            tables.append(Covariance(paths, correlation, sigmas))
    return tuple(tables)


def _paths(
    raw: Any,
    where: str,
    mechanism: Mechanism,
    quantities: Mapping[str, Quantity],
    table_number: dict[str, int],
    number: int,
    problem: Problem,
) -> tuple[str, ...] | None:
    example = f'write {PATHS} = ["platform.mass", "belt.width"], values of this file that have a sigma'
    if not isinstance(raw, list) or not raw:
        actual = "nothing" if raw is None else "an empty list" if raw == [] else shown(raw)
        problem(f"{where}.{PATHS}", f"expected a list of dotted paths, found {actual}", example)
        return None
    aliases = {
        path: table_path for path, table_path in table_sources(mechanism).items() if table_path in quantities
    }
    expected = "expected the dotted path of a value with a sigma"
    paths = []
    for position, entry in enumerate(raw, start=1):
        path = aliases.get(entry, entry) if isinstance(entry, str) else entry
        quantity = quantities.get(path) if isinstance(path, str) else None
        if quantity is not None and quantity.sigma and path not in table_number:
            table_number[path] = number
            paths.append(path)
            continue
        message, remedy = f"{expected}, found {shown(path)}", example
        if isinstance(path, str) and quantity is None:
            message, remedy = f"{message}, which this file does not declare", nearest_name(path, quantities)
        elif quantity is not None and not quantity.sigma:
            reason = (
                "which has no sigma" if quantity.sigma is None else "whose sigma is 0: it is known exactly"
            )
            message, remedy = f"{message}, {reason}", "give it a sigma, or leave it out here"
        elif quantity is not None:
            message = f"expected each value once, found {path} also in {COVARIANCE}.{table_number[path]}"
            remedy = "name it in one table, once"
        problem(f"{where}.{PATHS}.{position}", message, remedy)
    return tuple(paths) if len(paths) == len(raw) else None


def _correlation(raw: Any, count: int, where: str, problem: Problem) -> tuple[tuple[float, ...], ...] | None:
    rows = "row" if count == 1 else "rows"
    remedy = f"write {count} {rows} of {count}, in the order of {PATHS}, such as [[1, 0.8], [0.8, 1]] for two"
    right_length = isinstance(raw, list) and len(raw) == count
    if not right_length or not all(isinstance(row, list) and len(row) == count for row in raw):
        sizes = (
            [f"{len(row)}" if isinstance(row, list) else shown(row) for row in raw] if right_length else []
        )
        actual = "nothing" if raw is None else shown(raw)
        if isinstance(raw, list):
            actual = f"rows of {', '.join(sizes)}" if right_length else f"a list of {len(raw)}"
        problem(where, f"expected a matrix of {count} by {count} correlations, found {actual}", remedy)
        return None
    for i, row in enumerate(raw, start=1):
        for k, coefficient in enumerate(row, start=1):
            if not is_number(coefficient) or not abs(coefficient) <= 1.0 + ROUNDING:
                message = f"expected a correlation from -1 to 1, found {shown(coefficient)}"
                problem(f"{where}.{i}.{k}", message, "write a number without a unit")
                return None
    matrix = np.array(raw, dtype=float)
    diagonal = np.flatnonzero(np.abs(np.diagonal(matrix) - 1.0) > ROUNDING)
    if len(diagonal):
        i = int(diagonal[0])
        message = f"expected 1 on the diagonal, found {matrix[i, i]:g}"
        problem(f"{where}.{i + 1}.{i + 1}", message, "write correlations, not covariances")
        return None
    asymmetric = np.argwhere(np.abs(matrix - matrix.T) > ROUNDING)
    if len(asymmetric):
        i, k = asymmetric[0].tolist()
        pair = f"{matrix[i, k]:g} here and {matrix[k, i]:g} in row {k + 1}"
        message = f"expected a symmetric matrix, found {pair}"
        problem(f"{where}.{i + 1}.{k + 1}", message, "write the same number in both places")
        return None
    smallest = float(np.linalg.eigvalsh(matrix)[0])
    if smallest < -ROUNDING:
        message = f"expected a positive semidefinite matrix, found an eigenvalue of {plain(smallest, 3)}"
        problem(
            where,
            message,
            "no set of values can be correlated like this: write more digits, or smaller correlations",
        )
        return None
    return tuple(tuple(row) for row in matrix.tolist())


def _table_sigmas(
    raw: Any, members: Sequence[Quantity], where: str, problem: Problem
) -> tuple[float, ...] | None:
    count = len(members)
    if not isinstance(raw, list) or len(raw) != count:
        actual = f"a list of {len(raw)}" if isinstance(raw, list) else shown(raw)
        remedy = f"write one for each of {PATHS}, or leave {SIGMA} out to use those of the values"
        problem(where, f"expected {count} standard deviations, found {actual}", remedy)
        return None
    sigmas = []
    for position, (raw_sigma, quantity) in enumerate(zip(raw, members, strict=True), start=1):
        path = f"{where}.{position}"
        try:
            sigma = schema.parse_sigma(raw_sigma, quantity.value, dimension_of(quantity.unit))
        except schema.RefusedError as error:
            problem(path, error.what, error.remedy)
            return None
        limit = quantity.sigma or 0.0
        if not 0.0 < sigma <= (1.0 + SIGMA_TOLERANCE) * limit:
            limit_text, actual = (with_unit(size, quantity.unit) for size in (limit, sigma))
            expected = f"a standard deviation above 0 and at most that of the value, {limit_text}"
            message = f"expected {expected}, found {actual}"
            problem(
                path, message, "it may not be larger: enlarge the sigma of the value, or leave this one out"
            )
            return None
        sigmas.append(sigma)
    return tuple(sigmas)
