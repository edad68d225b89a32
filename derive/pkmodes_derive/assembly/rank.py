"""The motions that strain nothing: the exact nullity of a stiffness matrix for unrelated values of its symbols."""

from __future__ import annotations

from collections.abc import Sequence

from sympy import QQ, Expr, Integer, Matrix, default_sort_key, prime
from sympy.polys.matrices import DomainMatrix


def nullity(stiffness: Sequence[Sequence[Expr]]) -> int:
    """Return the nullity of a square matrix at unrelated values: its symbols are primes."""
    symbols = sorted(
        {s for row in stiffness for entry in row for s in entry.free_symbols}, key=default_sort_key
    )
    values = {symbol: Integer(prime(i)) for i, symbol in enumerate(symbols, start=1)}
    matrix = Matrix([[entry.xreplace(values) for entry in row] for row in stiffness])
    # The entries have long numerators and denominators, with which `Matrix.rank` takes half a minute.
    rational = all(entry.is_Rational for entry in matrix)
    rank = DomainMatrix.from_Matrix(matrix).convert_to(QQ).rank() if rational else matrix.rank()
    return len(stiffness) - int(rank)
