"""Specialise a model to one robot: parameters become numbers, and constants are folded.

The folding goes definition by definition, so the structure that a person reads stays as it is: a definition
that becomes a number, or another name for a symbol, disappears into the ones that use it.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr, Float, Integer, Symbol

from pkmodes_derive.functions import Function, Model, Output


def number(value: float) -> Expr:
    """Exact SymPy number of a double; integers stay integers, so that 0 and 1 fold away."""
    return Integer(int(value)) if float(value).is_integer() else Float(float(value))


def specialise(model: Model, values: Mapping[str, float]) -> Model:
    """Replace every parameter by its value.

    Parameters
    ----------
    model : Model
        A parametric model.
    values : mapping of str to float
        Value of every parameter symbol, by name, in SI units.

    Raises
    ------
    KeyError
        If a parameter has no value.
    """
    constants = {symbol: number(values[symbol.name]) for field in model.fields for symbol in field.symbols}
    return replace(model, functions=tuple(_fold(function, constants) for function in model.functions))


def _fold(function: Function, constants: Mapping[Symbol, Expr]) -> Function:
    known: dict[Symbol, Expr] = dict(constants)
    definitions: dict[Symbol, Expr] = {}
    for symbol, expression in function.definitions.items():
        folded = expression.xreplace(known)
        if folded.is_number or folded.is_Symbol:
            known[symbol] = folded
        else:
            definitions[symbol] = folded
    outputs = tuple(
        Output(o.name, o.shape, tuple(e.xreplace(known) for e in o.entries), o.unit, o.description)
        for o in function.outputs
    )
    return replace(function, definitions=definitions, outputs=outputs)
