"""The steps of a program in a form that is easily differentiated, and their derivatives."""

from __future__ import annotations

from sympy import Expr, Pow, Rational, Symbol
from sympy.core.function import AppliedUndef
from sympy.core.function import Function as Applied

from pkmodes_derive.differentiation import partial_derivative
from pkmodes_derive.emit.program import Program
from pkmodes_derive.reserved_words import SHARED_SUBEXPRESSION

Step = tuple[Symbol, Expr]


def named(name: str) -> Symbol:
    """Return the symbol of a name."""
    return Symbol(name, real=True)


def elementary(program: Program, outputs: int) -> tuple[list[Step], list[Expr]]:
    """Give each root, quotient and function a step of its own: its derivative is written in terms of its value.

    Parameters
    ----------
    outputs : int
        Number of outputs needed, the first ones.

    Returns
    -------
    steps : list of (Symbol, Expr)
    values : list of Expr
        Of the entries of these outputs.
    """
    steps: list[Step] = []
    known: dict[Expr, Symbol] = {}
    # The numbers are given again when the whole is arranged.
    renamed = {
        s: named(f"forward_{s.name}") for s, _ in program.steps if SHARED_SUBEXPRESSION.fullmatch(s.name)
    }

    def split(expression: Expr) -> Expr:
        if not expression.args:
            return expression
        rebuilt = expression.func(*map(split, expression.args))
        if not _is_elementary(rebuilt):
            return rebuilt
        if rebuilt not in known:
            known[rebuilt] = named(f"forward_{len(known)}")
            steps.append((known[rebuilt], rebuilt))
        return known[rebuilt]

    for symbol, value in program.steps:
        steps.append((renamed.get(symbol, symbol), split(value.xreplace(renamed))))
    values = [split(entry.value.xreplace(renamed)) for r in program.results[:outputs] for entry in r.entries]
    return steps, values


def _is_elementary(expression: Expr) -> bool:
    if isinstance(expression, Pow):
        return not (expression.exp.is_Integer and expression.exp.is_positive)
    return isinstance(expression, Applied) and not isinstance(expression, AppliedUndef)


def partial(value: Expr, variable: Symbol, symbol: Symbol | None) -> Expr:
    """Differentiate a step; a power in terms of its own value, which needs no further root.

    Parameters
    ----------
    symbol : Symbol, optional
        Name of the value.
    """
    if symbol is not None and isinstance(value, Pow) and value.base == variable and value.exp.is_number:
        if value.exp == -1:
            return -(symbol**2)
        if value.exp == Rational(1, 2):
            return 1 / (2 * symbol)
    return partial_derivative(value, variable)
