"""Specialise a model to one robot: parameters become numbers, and constants are folded.

Folding works definition by definition, so the readable structure is kept: a definition that becomes a number
or another name for a symbol is substituted where it is used.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from sympy import Expr, Float, Integer, Symbol

from pkmodes_derive.functions import Function, Model


def number(value: float) -> Expr:
    """Return a double as an exact SymPy number; integers stay integers, so 0 and 1 fold away."""
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
    return replace(model, functions=tuple(fold(function, constants) for function in model.functions))


def fold(function: Function, known: Mapping[Symbol, Expr] | None = None) -> Function:
    """Substitute known values, and definitions that become a number or another name for a symbol."""
    known = dict(known or {})
    definitions: dict[Symbol, Expr] = {}
    for symbol, expression in function.definitions.items():
        folded = expression.xreplace(known)
        if folded.is_number or folded.is_Symbol:
            known[symbol] = folded
        else:
            definitions[symbol] = folded
    outputs = tuple(
        replace(output, entries=tuple(entry.xreplace(known) for entry in output.entries))
        for output in function.outputs
    )
    return replace(function, definitions=definitions, outputs=outputs)
