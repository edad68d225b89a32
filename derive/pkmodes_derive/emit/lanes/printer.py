"""One expression, printed for lanes: the C99 text, with numbers as doubles and the lanes' own functions."""

from __future__ import annotations

from typing import ClassVar

from sympy import Expr, Integer

from pkmodes_derive.emit.c99.printer import C99Printer


class LanesPrinter(C99Printer):
    """Expressions in which a name is a double or a vector of them: the operators are the same for both."""

    #: Before the names of functions: these have a version for lanes and one for a double.
    _ns: ClassVar[str] = "lanes_"

    def _print_sign(self, expr: Expr) -> str:
        return f"lanes_sign({self._print(expr.args[0])})"

    def _print_Integer(self, expr: Integer) -> str:
        return f"{int(expr)}.0"


_PRINTER = LanesPrinter({"strict": True})


def expression(value: Expr) -> str:
    """Print for lanes.

    Raises
    ------
    PrintMethodNotImplementedError
        If it holds a function that C99 does not have.
    """
    text: str = _PRINTER.doprint(value)
    return text
