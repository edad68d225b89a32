r"""Derivatives of an eigenvalue with respect to all parameters, by reverse accumulation.

A mode with :math:`\phi^T M \phi = 1` has

.. math:: \frac{d\lambda}{d\theta} = \phi^T \left( \frac{dK}{d\theta} - \lambda \frac{dM}{d\theta} \right) \phi ,

which is a sum over the entries of M and K, with weights that belong to the mode.  Going backwards through the program
that evaluates M and K gives the derivatives of this sum with respect to all inputs, at a cost that does not depend
on their number (Griewank and Walther, Evaluating Derivatives, SIAM 2008, chapter 3).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from sympy import Add, Expr, Integer, Pow, Rational, Symbol, diff
from sympy.core.function import AppliedUndef
from sympy.core.function import Function as Applied

from pkmodes_derive.emit.program import Program, Result, arrange
from pkmodes_derive.functions import Argument, Function, Output
from pkmodes_derive.reserved_words import NUMBERED

Step = tuple[Symbol, Expr]


def gradient(function: Function, inputs: Sequence[Symbol], differentiated: Collection[Symbol]) -> Function:
    """Derive the function that evaluates the derivatives of the eigenvalue of a mode.

    Parameters
    ----------
    function : Function
        Of the pose; its first two outputs are M and K, of n coordinates.
    inputs : sequence of Symbol
        One for each entry of the result.
    differentiated : collection of Symbol
        Those of them that can vary; the entries of the others are zero.

    Returns
    -------
    Function
        Of the pose, and then of the mode: ``shape``, n components, and ``eigenvalue``.
    """
    program = arrange(function)
    shape = tuple(_symbol(f"shape_{i}") for i in range(1, function.outputs[0].shape[0] + 1))
    eigenvalue = _symbol("eigenvalue")
    steps, values = _elementary(program)
    weighted = _weights(program.results[:2], shape, (-eigenvalue, Integer(1)))
    back, derivatives = _backwards(steps, list(zip(values, weighted, strict=False)))
    entries = tuple(derivatives.get(s, Integer(0)) if s in differentiated else Integer(0) for s in inputs)
    return Function(
        f"{function.name}_gradient",
        "Derivatives of the eigenvalue of a mode with respect to all quantities.",
        f"reverse accumulation through {function.name}",
        (
            *function.arguments,
            Argument("shape", shape, "", "mode shape with phi^T M phi = 1"),
            Argument("eigenvalue", (eigenvalue,), "1/s^2", "its eigenvalue", scalar=True),
        ),
        (Output("gradient", (len(entries),), entries, "1/s^2 per unit of the quantity", "derivatives"),),
        dict([*steps, *back]),
    )


def _symbol(name: str) -> Symbol:
    return Symbol(name, real=True)


def _elementary(program: Program) -> tuple[list[Step], list[Expr]]:
    """Give each root, quotient and function a step of its own: its derivative is written in terms of its value."""
    steps: list[Step] = []
    known: dict[Expr, Symbol] = {}
    # The numbers are given again when the whole is arranged.
    renamed = {s: _symbol(f"forward_{s.name}") for s, _ in program.steps if NUMBERED.fullmatch(s.name)}

    def split(expression: Expr) -> Expr:
        if not expression.args:
            return expression
        rebuilt = expression.func(*map(split, expression.args))
        if not _is_elementary(rebuilt):
            return rebuilt
        if rebuilt not in known:
            known[rebuilt] = _symbol(f"forward_{len(known)}")
            steps.append((known[rebuilt], rebuilt))
        return known[rebuilt]

    for symbol, value in program.steps:
        steps.append((renamed.get(symbol, symbol), split(value.xreplace(renamed))))
    values = [split(entry.value.xreplace(renamed)) for r in program.results[:2] for entry in r.entries]
    return steps, values


def _is_elementary(expression: Expr) -> bool:
    if isinstance(expression, Pow):
        return not (expression.exp.is_Integer and expression.exp.is_positive)
    return isinstance(expression, Applied) and not isinstance(expression, AppliedUndef)


def _weights(results: Sequence[Result], shape: Sequence[Symbol], factors: Sequence[Expr]) -> Iterator[Expr]:
    """Yield the weight of each entry of the matrices in the derivative of the eigenvalue."""
    for result, factor in zip(results, factors, strict=True):
        for entry in result.entries:
            yield factor * Add(*(shape[row] * shape[column] for row, column in entry.places))


def _backwards(
    steps: Sequence[Step], weighted: Sequence[tuple[Expr, Expr]]
) -> tuple[list[Step], dict[Symbol, Expr]]:
    """Return the steps of the reverse sweep, and the derivatives with respect to the symbols that are left."""
    terms: dict[Symbol, list[Expr]] = {}

    def spread(value: Expr, adjoint: Expr, symbol: Symbol | None = None) -> None:
        for variable in value.free_symbols:
            terms.setdefault(variable, []).append(adjoint * _partial(value, variable, symbol))

    for value, weight in weighted:
        spread(value, weight)
    back: list[Step] = []
    for symbol, value in reversed(steps):
        if symbol in terms:
            adjoint = _symbol(f"adjoint_{symbol.name}")
            back.append((adjoint, Add(*terms.pop(symbol))))
            spread(value, adjoint, symbol)
    return back, {symbol: Add(*parts) for symbol, parts in terms.items()}


def _partial(value: Expr, variable: Symbol, symbol: Symbol | None) -> Expr:
    """Differentiate a step; a power in terms of its own value, which needs no further root."""
    if symbol is not None and isinstance(value, Pow) and value.base == variable and value.exp.is_number:
        if value.exp == -1:
            return -(symbol**2)
        if value.exp == Rational(1, 2):
            return 1 / (2 * symbol)
    return diff(value, variable)
