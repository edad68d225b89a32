"""Products of vectors written as tuples of expressions."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr


def dot(a: Sequence[Expr], b: Sequence[Expr]) -> Expr:
    """Return the scalar product."""
    return Add(*(u * w for u, w in zip(a, b, strict=True)))


def cross(a: Sequence[Expr], b: Sequence[Expr]) -> tuple[Expr, Expr, Expr]:
    """Return the vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])
