"""Printing of one expression as Python with NumPy; nothing is evaluated here.

NumPy functions take complex arguments, so a complex step can differentiate them, except the absolute value and the
sign.  `np.arctan2` takes no complex arguments and is called through a function in the template of the module.
"""

from __future__ import annotations

from typing import ClassVar

from sympy import Expr, Float, Pow, Rational
from sympy.printing.precedence import PRECEDENCE
from sympy.printing.pycode import PythonCodePrinter

from pkmodes_derive.emit.printing import Ordered

HALF = Rational(1, 2)
#: Name of the function that replaces `np.arctan2`.
ARCTAN2 = "_arctan2"


class NumPyPrinter(Ordered, PythonCodePrinter):  # type: ignore[misc]  # SymPy has no types
    """Printer of Python expressions with ``np`` for NumPy; it refuses unknown functions."""

    _kf: ClassVar[dict[str, str]] = {
        "Abs": "np.abs",
        "acos": "np.arccos",
        "asin": "np.arcsin",
        "atan": "np.arctan",
        "atan2": ARCTAN2,
        "cos": "np.cos",
        "exp": "np.exp",
        "log": "np.log",
        "sin": "np.sin",
        "tan": "np.tan",
    }
    _kc: ClassVar[dict[str, str]] = {"Pi": "np.pi"}

    def _print_Float(self, expr: Float) -> str:
        return repr(float(expr))

    def _print_sign(self, expr: Expr) -> str:
        return f"np.sign({self._print(expr.args[0])})"

    def _print_Pow(self, expr: Pow, rational: bool = False) -> str:
        base, exponent = expr.as_base_exp()
        if exponent == HALF:
            return f"np.sqrt({self._print(base)})"
        if exponent == -HALF:
            return f"1.0/np.sqrt({self._print(base)})"
        if exponent.is_Integer and exponent.is_negative:
            return f"1.0/{self.parenthesize(Pow(base, -exponent), PRECEDENCE['Pow'])}"
        text: str = super()._print_Pow(expr, rational=rational)
        return text


_PRINTER = NumPyPrinter({"strict": True})


def expression(value: Expr) -> str:
    """Print an expression for NumPy.

    Raises
    ------
    PrintMethodNotImplementedError
        If it contains a function without a known NumPy equivalent.
    """
    text: str = _PRINTER.doprint(value)
    return text
