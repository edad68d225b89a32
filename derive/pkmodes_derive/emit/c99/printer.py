"""Printing of one expression as C99; nothing is evaluated here.

The operations and their order are those of the NumPy code.  Small integer powers are products, because ``pow`` is a
function call.
"""

from __future__ import annotations

from math import pi
from typing import ClassVar

from sympy import Expr, Float, Pow, Rational
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

HALF = Rational(1, 2)
LARGEST_PRODUCT = 4


class C99Printer(C99CodePrinter):  # type: ignore[misc]  # SymPy has no types
    """Printer of C99 expressions of type double; it refuses unknown functions."""

    #: C99 has no named constants: ``M_PI`` is POSIX.
    math_macros: ClassVar[dict[Expr, str]] = {}

    def _print_Float(self, expr: Float) -> str:
        return repr(float(expr))

    def _print_Pi(self, expr: Expr) -> str:
        return repr(pi)

    def _print_Pow(self, expr: Pow) -> str:
        base, exponent = expr.as_base_exp()
        if exponent == -HALF:
            return f"1.0/{self._ns}sqrt({self._print(base)})"
        if exponent.is_Integer and 2 <= exponent <= LARGEST_PRODUCT:
            factor = self.parenthesize(base, PRECEDENCE["Mul"])
            return f"({'*'.join([factor] * int(exponent))})"
        if exponent.is_Integer and exponent.is_negative:
            return f"1.0/{self.parenthesize(Pow(base, -exponent), PRECEDENCE['Pow'])}"
        text: str = super()._print_Pow(expr)
        return text


def expression(value: Expr) -> str:
    """Print an expression as C99.

    Raises
    ------
    PrintMethodNotImplementedError
        If it contains a function that C99 does not have.
    """
    text: str = C99Printer({"strict": True}).doprint(value)
    return text
