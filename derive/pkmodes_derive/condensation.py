r"""Exact condensation of coordinates without inertia.

A massless coordinate r is always in equilibrium, :math:`K_{rr} x_r + K_{rq} x_q = 0`, so it follows the others,
:math:`x_r = F x_q` with :math:`F = -K_{rr}^{-1} K_{rq}`, and the condensed stiffness of the others is
:math:`K_{qq} + K_{qr} F`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Add, Expr, Integer

Rows = Sequence[Sequence[Expr]]


def condensation_map(K: Rows, kept: Sequence[int], massless: Sequence[int]) -> list[list[Expr]]:
    """Return the map from the kept coordinates to all coordinates: rows of the identity, and F.

    Gauss-Jordan elimination without pivoting: K_rr is positive definite because every released joint has a spring.
    """
    stiffness = [[K[i][j] for j in massless] for i in massless]
    solution = [[-K[i][j] for j in kept] for i in massless]
    for pivot, row in enumerate(stiffness):
        divisor = row[pivot]
        stiffness[pivot] = row = [entry / divisor for entry in row]
        solution[pivot] = [entry / divisor for entry in solution[pivot]]
        for other_row in range(len(stiffness)):
            factor = stiffness[other_row][pivot]
            if other_row != pivot and factor != 0:
                stiffness[other_row] = [
                    a - factor * b for a, b in zip(stiffness[other_row], row, strict=True)
                ]
                solution[other_row] = [
                    a - factor * b for a, b in zip(solution[other_row], solution[pivot], strict=True)
                ]
    rows = {i: [Integer(i == j) for j in kept] for i in kept}
    rows.update(zip(massless, solution, strict=True))
    return [rows[i] for i in range(len(K))]


def condensed_stiffness(
    K: Rows, kept: Sequence[int], massless: Sequence[int], mapping: Rows
) -> list[list[Expr]]:
    """Return K_qq + K_qr F, with `mapping` from `condensation_map`; the lower triangle repeats the upper one."""
    return _symmetric(
        len(kept),
        lambda a, b: Add(K[kept[a]][kept[b]], *(K[kept[a]][r] * mapping[r][b] for r in massless)),
    )


def project(matrix: Rows, mapping: Rows) -> list[list[Expr]]:
    """Return T^T A T of a symmetric matrix A in all coordinates, with T from `condensation_map`."""
    nonzero_rows = [[i for i, row in enumerate(mapping) if row[a] != 0] for a in range(len(mapping[0]))]
    return _symmetric(
        len(mapping[0]),
        lambda a, b: Add(
            *(mapping[i][a] * matrix[i][j] * mapping[j][b] for i in nonzero_rows[a] for j in nonzero_rows[b])
        ),
    )


def _symmetric(size: int, entry: Callable[[int, int], Expr]) -> list[list[Expr]]:
    """Return a matrix from the entries of its upper triangle."""
    n = range(size)
    upper = {(a, b): entry(a, b) for a in n for b in n if a <= b}
    return [[upper[min(a, b), max(a, b)] for b in n] for a in n]
