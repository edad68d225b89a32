"""Partial derivatives of sums and products, as `sympy.diff` returns them.

SymPy itself differentiates every term, with or without the symbol, and tests every result for zero, which takes most
of the time of a derivation.
"""

from __future__ import annotations

from sympy import Add, Expr, Integer, Mul, Symbol, diff


def partial_derivative(expression: Expr, symbol: Symbol) -> Expr:
    """Differentiate; all other symbols are constants."""
    if expression == symbol:
        return Integer(1)
    if symbol not in expression.free_symbols:
        return Integer(0)
    if isinstance(expression, Add):
        return Add(
            *(partial_derivative(term, symbol) for term in expression.args if symbol in term.free_symbols)
        )
    if isinstance(expression, Mul):
        factors = expression.args
        return Add(
            *(
                Mul(*factors[:i], partial_derivative(factor, symbol), *factors[i + 1 :])
                for i, factor in enumerate(factors)
                if symbol in factor.free_symbols
            )
        )
    return diff(expression, symbol)
