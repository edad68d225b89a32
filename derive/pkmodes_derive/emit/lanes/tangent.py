r"""Derivatives of M, K and the motion of the platform along one direction in the space of all quantities.

Going forwards through the program that evaluates them, each step also gets its derivative along the direction, at
twice the cost of the program, however many quantities change (Griewank and Walther, Evaluating Derivatives, SIAM
2008, chapter 3).  Derivatives of mode shapes need these matrices, and not only their products with a mode.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence

from sympy import Add, Expr, Integer, Symbol

from pkmodes_derive.emit.lanes.steps import elementary, named, partial
from pkmodes_derive.emit.program import arrange
from pkmodes_derive.functions import Argument, Function, Output

#: Names of the results, for the outputs of the function in their order.
NAMES = ("mass_rate", "stiffness_rate", "motion_rate")


def tangent(function: Function, inputs: Sequence[Symbol], differentiated: Collection[Symbol]) -> Function:
    """Derive the function that evaluates the derivatives along a direction.

    Parameters
    ----------
    function : Function
        Of the pose; its outputs are M, K and the motion of the platform.
    inputs : sequence of Symbol
        One for each entry of the direction.
    differentiated : collection of Symbol
        Those of them that can vary.

    Returns
    -------
    Function
        Of the pose, and then of the ``direction``.
    """
    program = arrange(function)
    direction = tuple(named(f"along_{i}") for i in range(1, len(inputs) + 1))
    rates = {s: component for s, component in zip(inputs, direction, strict=True) if s in differentiated}
    steps, values = elementary(program, len(function.outputs))
    rate_steps = []
    for symbol, value in steps:
        rate = _rate(value, rates, symbol)
        if rate != 0:
            rates[symbol] = named(f"tangent_{symbol.name}")
            rate_steps.append((rates[symbol], rate))
    remaining = iter(values)
    outputs = []
    for name, result in zip(NAMES, program.results, strict=True):
        rate_at = {
            place: rate
            for entry in result.entries
            for rate in [_rate(next(remaining), rates)]
            for place in entry.places
        }
        output = result.output
        entries = tuple(rate_at.get(index, Integer(0)) for index in output.indices)
        outputs.append(
            Output(name, output.shape, entries, f"{output.unit} per unit", f"derivative of {output.name}")
        )
    return Function(
        f"{function.name}_tangent",
        "Derivatives of the matrices and of the motion of the platform along a direction.",
        f"forward accumulation through {function.name}",
        (*function.arguments, Argument("direction", direction, "", "change of every quantity")),
        tuple(outputs),
        dict([*steps, *rate_steps]),
    )


def _rate(value: Expr, rates: Mapping[Symbol, Expr], symbol: Symbol | None = None) -> Expr:
    """Return the derivative of a step, or of a short expression."""
    moving = sorted(value.free_symbols & rates.keys(), key=lambda variable: variable.name)
    return Add(*(partial(value, variable, symbol) * rates[variable] for variable in moving))
