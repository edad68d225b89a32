"""Vectors written as tuples of expressions: products, and those of rotation matrices."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import Add, Expr, Integer


def dot(a: Sequence[Expr], b: Sequence[Expr]) -> Expr:
    """Return the scalar product."""
    return Add(*(u * w for u, w in zip(a, b, strict=True)))


def mean_square(vectors: Sequence[Sequence[Expr]]) -> Expr:
    """Return the mean of the squared lengths."""
    return Add(*(dot(vector, vector) for vector in vectors)) / len(vectors)


def cross(a: Sequence[Expr], b: Sequence[Expr]) -> tuple[Expr, Expr, Expr]:
    """Return the vector product."""
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def axis(name: str) -> tuple[Expr, Expr, Expr]:
    """Return the unit vector along x, y or z."""
    return Integer(name == "x"), Integer(name == "y"), Integer(name == "z")


def placed(names: Sequence[str], components: Sequence[Expr]) -> tuple[Expr, ...]:
    """Return a vector with three components from those along some axes; the others are zero."""
    component_of = dict(zip(names, components, strict=True))
    return tuple(component_of.get(name, Integer(0)) for name in "xyz")


def skew(a: Sequence[Expr]) -> list[list[Expr]]:
    """Return the matrix [a], with [a] b = a x b."""
    return [[Integer(0), -a[2], a[1]], [a[2], Integer(0), -a[0]], [-a[1], a[0], Integer(0)]]
