r"""Exact condensation of coordinates without inertia.

A massless coordinate r is always in equilibrium, :math:`K_{rr} x_r + K_{rq} x_q = 0`, so it follows the others,
:math:`x_r = F x_q` with :math:`F = -K_{rr}^{-1} K_{rq}`, and the condensed stiffness of the others is
:math:`K_{qq} + K_{qr} F`.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence

from sympy import Add, Expr, Integer

Rows = Sequence[Sequence[Expr]]


def follow(K: Rows, kept: Sequence[int], massless: Sequence[int]) -> list[list[Expr]]:
    """Return the map from the kept coordinates to all coordinates: rows of the identity, and F.

    Gauss-Jordan elimination without pivoting: K_rr is positive definite because every released joint has a spring.
    """
    left = [[K[i][j] for j in massless] for i in massless]
    right = [[-K[i][j] for j in kept] for i in massless]
    for pivot, row in enumerate(left):
        divisor = row[pivot]
        left[pivot] = row = [entry / divisor for entry in row]
        right[pivot] = [entry / divisor for entry in right[pivot]]
        for other in range(len(left)):
            factor = left[other][pivot]
            if other != pivot and factor != 0:
                left[other] = [a - factor * b for a, b in zip(left[other], row, strict=True)]
                right[other] = [a - factor * b for a, b in zip(right[other], right[pivot], strict=True)]
    rows = {i: [Integer(i == j) for j in kept] for i in kept}
    rows.update(zip(massless, right, strict=True))
    return [rows[i] for i in range(len(K))]


def condensed(K: Rows, kept: Sequence[int], massless: Sequence[int], by: Rows) -> list[list[Expr]]:
    """Return K_qq + K_qr F, with `by` from `follow`; the lower triangle repeats the upper one."""
    return _symmetric(
        len(kept),
        lambda a, b: Add(K[kept[a]][kept[b]], *(K[kept[a]][r] * by[r][b] for r in massless)),
    )


def projected(matrix: Rows, by: Rows) -> list[list[Expr]]:
    """Return T^T A T of a symmetric matrix A in all coordinates, with T from `follow`."""
    rows = [[i for i, row in enumerate(by) if row[a] != 0] for a in range(len(by[0]))]
    return _symmetric(
        len(by[0]),
        lambda a, b: Add(*(by[i][a] * matrix[i][j] * by[j][b] for i in rows[a] for j in rows[b])),
    )


def _symmetric(size: int, entry: Callable[[int, int], Expr]) -> list[list[Expr]]:
    """Return a matrix from the entries of its upper triangle."""
    n = range(size)
    upper = {(a, b): entry(a, b) for a in n for b in n if a <= b}
    return [[upper[min(a, b), max(a, b)] for b in n] for a in n]
