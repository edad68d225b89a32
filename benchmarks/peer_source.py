"""M and K of the published robot as a Python function: the program of the generated code, for any array library.

The function is printed from the program that pkmodes prints as NumPy and C, with the robot's values in it: named
values, shared subexpressions and constants are the same, so what is compared is how the program is executed.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import numpy as np
import sympy
from sympy.printing.pycode import PythonCodePrinter

from pkmodes_derive.emit.program import Program, arrange
from pkmodes_derive.functions import Function
from pkmodes_derive.mechanisms import base
from pkmodes_derive.specialise import specialise
from published import published


class Printer(PythonCodePrinter):
    """Numbers with all digits, functions without the name of a module."""

    _kf = {"Abs": "abs"}  # noqa: RUF012  the name is SymPy's

    def __init__(self) -> None:
        super().__init__({"fully_qualified_modules": False, "inline": True, "strict": True})

    def _print_Float(self, expr: sympy.Float) -> str:  # noqa: N802
        return repr(float(expr))

    def _print_Pow(self, expr: sympy.Pow, rational: bool = False) -> str:  # noqa: N802
        base, exponent = expr.as_base_exp()
        if exponent == sympy.Rational(1, 2):
            return f"sqrt({self._print(base)})"
        if exponent == -sympy.Rational(1, 2):
            return f"(1.0/sqrt({self._print(base)}))"
        return super()._print_Pow(expr, rational=rational)


@dataclass(frozen=True)
class Matrices:
    """What is to be evaluated at a pose.

    Attributes
    ----------
    function, program
        Of M and K, with the robot's values.
    rows, columns : dict of str to ndarray of int, shape (e,)
        Places of the values of "M" and "K", both triangles.
    values : dict of str to ndarray of int, shape (e,)
        Which of the function's values stands there.
    """

    function: Function
    program: Program
    rows: dict[str, np.ndarray]
    columns: dict[str, np.ndarray]
    values: dict[str, np.ndarray]

    def filled(self, name: str, found: tuple, zero: Any = 0.0) -> list[list[Any]]:
        """Place values in a matrix, as nested lists."""
        n = len(published().coordinates)
        matrix = [[zero] * n for _ in range(n)]
        for row, column, value in zip(self.rows[name], self.columns[name], self.values[name], strict=True):
            matrix[row][column] = found[value]
        return matrix


@cache
def matrices() -> Matrices:
    model, parameters = base(published().mechanism.name), published().robot.parameters
    numbers = {
        symbol.name: float(value)
        for field in model.fields
        for symbol, value in zip(field.symbols, np.ravel(getattr(parameters, field.name)), strict=True)
    }
    (function,) = (f for f in specialise(model, numbers).functions if f.name == "modal_matrices")
    program = arrange(function)
    places: dict[str, list[tuple[int, int, int]]] = {"M": [], "K": []}
    number = 0
    for result in program.results:
        for entry in result.entries:
            places[result.output.name] += [(row, column, number) for row, column in entry.places]
            number += 1
    split = {name: np.array(found).T for name, found in places.items()}
    return Matrices(function, program, *({name: found[i] for name, found in split.items()} for i in range(3)))


def printed(functions: Mapping[str, Callable]) -> Callable[..., tuple]:
    """Print the program.

    Parameters
    ----------
    functions : mapping of str to callable
        What the names of functions in the program mean: ``{"sqrt": math.sqrt}``.

    Returns
    -------
    callable
        Of the pose's three coordinates; it returns the distinct values of M and K (`Matrices.values`).
    """
    program = matrices().program
    values = [
        sympy.Float(v) if v.is_number else v for r in program.results for v in (e.value for e in r.entries)
    ]
    return sympy.lambdify(
        matrices().function.arguments[0].symbols,
        tuple(values),
        modules=[dict(functions)],
        printer=Printer(),
        cse=lambda _: (program.steps, tuple(values)),
    )
