"""Printing of one expression as C99; nothing is evaluated here.

The operations and their order are those of the NumPy code.  Small integer powers are products, because ``pow`` is a
function call.  One text serves both precisions: the macro ``R`` of the template gives numbers and functions of the C
library the suffix ``f`` in single precision.
"""

from __future__ import annotations

from math import pi
from typing import ClassVar

from sympy import Expr, Float, Integer, Pow, Rational
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE

from pkmodes_derive.emit.printing import Ordered

HALF = Rational(1, 2)
MAX_PRODUCT_POWER = 4
#: Whole numbers below it are exact in either precision, and fit into an int.
EXACT_LIMIT = 2**24


class C99Printer(Ordered, C99CodePrinter):  # type: ignore[misc]  # SymPy has no types
    """Printer of C99 expressions of type double; it refuses unknown functions."""

    #: C99 has no named constants: ``M_PI`` is POSIX.
    math_macros: ClassVar[dict[Expr, str]] = {}
    #: Numerator of a reciprocal.
    one: ClassVar[str] = "1.0"

    def _print_Float(self, expr: Float) -> str:
        return repr(float(expr))

    def _print_Pi(self, expr: Expr) -> str:
        return repr(pi)

    def _print_Pow(self, expr: Pow) -> str:
        base, exponent = expr.as_base_exp()
        if exponent == -HALF:
            return f"{self.one}/{self._print(Pow(base, HALF))}"
        if exponent.is_Integer and 2 <= exponent <= MAX_PRODUCT_POWER:
            factor = self.parenthesize(base, PRECEDENCE["Mul"])
            return f"({'*'.join([factor] * int(exponent))})"
        if exponent.is_Integer and exponent.is_negative:
            return f"{self.one}/{self.parenthesize(Pow(base, -exponent), PRECEDENCE['Pow'])}"
        text: str = super()._print_Pow(expr)
        return text


class EitherPrecisionPrinter(C99Printer):
    """Printer of expressions of type double or float, in which nothing is converted to another type.

    Small whole numbers are printed as integers, which take the type of the other operand.
    """

    one: ClassVar[str] = "1"
    #: A function ``sqrt`` is printed as ``R(sqrt)``: this before its name, the suffix after it.
    _ns: ClassVar[str] = "R("
    _prec_funcs: ClassVar[frozenset[str]] = frozenset(f"R({name}" for name in C99CodePrinter._prec_funcs)

    def _get_func_suffix(self, type_: object) -> str:
        return ")"

    def _print_Float(self, expr: Float) -> str:
        return f"R({super()._print_Float(expr)})"

    def _print_Integer(self, expr: Integer) -> str:
        return str(int(expr)) if abs(expr) < EXACT_LIMIT else self._print_Float(Float(int(expr)))

    def _print_Pi(self, expr: Expr) -> str:
        return f"R({super()._print_Pi(expr)})"

    def _print_Rational(self, expr: Rational) -> str:
        return f"R({int(expr.p)}.0)/R({int(expr.q)}.0)"

    def _print_sign(self, expr: Expr) -> str:
        return f"(pkmodes_real){super()._print_sign(expr)}"


_PRINTER = EitherPrecisionPrinter({"strict": True})


def expression(value: Expr) -> str:
    """Print an expression as C99 of either precision.

    Raises
    ------
    PrintMethodNotImplementedError
        If it contains a function that C99 does not have.
    """
    text: str = _PRINTER.doprint(value)
    return text
