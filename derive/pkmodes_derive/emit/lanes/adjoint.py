r"""Derivatives of an eigenvalue with respect to all parameters, by reverse accumulation.

A mode with :math:`\phi^T M \phi = 1` has

.. math:: \frac{d\lambda}{d\theta} = \phi^T \left( \frac{dK}{d\theta} - \lambda \frac{dM}{d\theta} \right) \phi ,

which is a sum over the entries of M and K, with weights that belong to the mode.  Going backwards through the program
that evaluates M and K gives the derivatives of this sum with respect to all inputs, at a cost that does not depend
on their number (Griewank and Walther, Evaluating Derivatives, SIAM 2008, chapter 3).
"""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from sympy import Add, Expr, Integer, Symbol

from pkmodes_derive.emit.lanes.steps import Step, elementary, named, partial
from pkmodes_derive.emit.program import Result, arrange
from pkmodes_derive.functions import Argument, Function, Output


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
    shape = tuple(named(f"shape_{i}") for i in range(1, function.outputs[0].shape[0] + 1))
    eigenvalue = named("eigenvalue")
    steps, values = elementary(program, 2)
    weights = _weights(program.results[:2], shape, (-eigenvalue, Integer(1)))
    reverse_steps, derivatives = _reverse_sweep(steps, list(zip(values, weights, strict=False)))
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
        dict([*steps, *reverse_steps]),
    )


def _weights(results: Sequence[Result], shape: Sequence[Symbol], factors: Sequence[Expr]) -> Iterator[Expr]:
    """Yield the weight of each entry of the matrices in the derivative of the eigenvalue."""
    for result, factor in zip(results, factors, strict=True):
        for entry in result.entries:
            yield factor * Add(*(shape[row] * shape[column] for row, column in entry.places))


def _reverse_sweep(
    steps: Sequence[Step], weighted: Sequence[tuple[Expr, Expr]]
) -> tuple[list[Step], dict[Symbol, Expr]]:
    """Return the steps of the reverse sweep, and the derivatives with respect to the symbols that are left."""
    terms: dict[Symbol, list[Expr]] = {}

    def add_terms(value: Expr, adjoint: Expr, symbol: Symbol | None = None) -> None:
        for variable in value.free_symbols:
            terms.setdefault(variable, []).append(adjoint * partial(value, variable, symbol))

    for value, weight in weighted:
        add_terms(value, weight)
    reverse_steps: list[Step] = []
    for symbol, value in reversed(steps):
        if symbol in terms:
            adjoint = named(f"adjoint_{symbol.name}")
            reverse_steps.append((adjoint, Add(*terms.pop(symbol))))
            add_terms(value, adjoint, symbol)
    return reverse_steps, {symbol: Add(*parts) for symbol, parts in terms.items()}
