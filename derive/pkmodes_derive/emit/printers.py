"""One expression, printed for Python with NumPy and for C99; nothing is evaluated here.

Both printers write the same operations in the same order.  Small integer powers are products in C, where
``pow`` is a library call, and squares in NumPy, which computes them as products.
"""

from __future__ import annotations

from sympy import Expr, Float, Pow, Rational
from sympy.printing.c import C99CodePrinter
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

LARGEST_PRODUCT = 4


class NumPyPrinter(PythonCodePrinter):
    """Python expressions with ``np`` for NumPy."""

    def _print_Float(self, expr: Float) -> str:
        return repr(float(expr))

    def _print_Pow(self, expr: Pow, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if exponent == Rational(1, 2):
            return f"np.sqrt({self._print(base)})"
        if exponent.is_Integer and exponent.is_negative:
            return f"1.0/{self.parenthesize(Pow(base, -exponent), PRECEDENCE['Pow'])}"
        return super()._print_Pow(expr, rational=rational)


class C99Printer(C99CodePrinter):
    """C99 expressions of type double."""

    def _print_Float(self, expr: Float) -> str:
        return repr(float(expr))

    def _print_Pow(self, expr: Pow) -> str:
        base, exponent = expr.as_base_exp()
        if exponent.is_Integer and 2 <= exponent <= LARGEST_PRODUCT:
            factor = self.parenthesize(base, PRECEDENCE["Mul"])
            return f"({'*'.join([factor] * int(exponent))})"
        if exponent.is_Integer and exponent.is_negative:
            return f"1.0/{self.parenthesize(Pow(base, -exponent), PRECEDENCE['Pow'])}"
        return super()._print_Pow(expr)


def numpy_expression(expression: Expr) -> str:
    """Print for NumPy."""
    return NumPyPrinter({"fully_qualified_modules": False}).doprint(expression)


def c_expression(expression: Expr) -> str:
    """Print for C99."""
    return C99Printer().doprint(expression)
