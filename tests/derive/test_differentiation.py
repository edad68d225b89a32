"""Partial derivatives and exact nullities, against those of SymPy."""

from __future__ import annotations

import pytest
from sympy import Expr, Integer, Matrix, atan2, cos, diff, sin, sqrt, symbols

from pkmodes_derive import mechanisms
from pkmodes_derive.assembly.rank import nullity
from pkmodes_derive.differentiation import partial_derivative

A, B, C = symbols("a b c", real=True)
EXPRESSIONS = {
    "constant": Integer(3) * B,
    "symbol": A,
    "sum": 2 * A + A**2 - B / 3,
    "product": A * (A + B) * sin(A) / 2,
    "number times sum": 2 * (A + B) * A,
    "quotient": (A - B) / sqrt(A**2 + B**2),
    "power": (A * B + C) ** B,
    "functions": cos(A * B) * atan2(A, B) - sin(C) * A,
}


@pytest.mark.parametrize("name", EXPRESSIONS)
def test_partial_derivatives_are_those_of_sympy(name: str) -> None:
    for symbol in (A, B, C):
        assert partial_derivative(EXPRESSIONS[name], symbol) == diff(EXPRESSIONS[name], symbol)


def test_partial_derivatives_of_a_mechanism_are_those_of_sympy() -> None:
    """As expressions, not only as values: the emitted text depends on it."""
    function = mechanisms.base("corexy").functions[0]
    for expression in function.definitions.values():
        for symbol in expression.free_symbols:
            assert partial_derivative(expression, symbol) == diff(expression, symbol)


@pytest.mark.parametrize("factor", [Integer(1), B / 7, sqrt(B)], ids=str)
def test_the_nullity_is_exact_for_rational_and_other_entries(factor: Expr) -> None:
    rows = Matrix([[A, -A, 0], [-A, A + C, -C], [0, -C, C]]) * factor
    assert nullity(rows.tolist()) == 1
    rows[0, 0] += factor * A / 10**9
    assert nullity(rows.tolist()) == 0
