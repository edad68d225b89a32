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
    folded_definitions: dict[int, tuple[dict[Symbol, Expr], dict[Symbol, Expr]]] = {}
    functions = []
    for function in model.functions:
        # Most functions of a model share their definitions.
        key = id(function.definitions)
        if key not in folded_definitions:
            folded_definitions[key] = _fold_definitions(function.definitions, constants)
        functions.append(_with_known_values(function, *folded_definitions[key]))
    return replace(model, functions=tuple(functions))


def fold(function: Function, known: Mapping[Symbol, Expr] | None = None) -> Function:
    """Substitute known values, and definitions that become a number or another name for a symbol."""
    return _with_known_values(function, *_fold_definitions(function.definitions, known or {}))


def _fold_definitions(
    definitions: Mapping[Symbol, Expr], known: Mapping[Symbol, Expr]
) -> tuple[dict[Symbol, Expr], dict[Symbol, Expr]]:
    """Return the definitions that remain, and all values that are known with those of the others."""
    known, remaining = dict(known), {}
    for symbol, expression in definitions.items():
        folded = expression.xreplace(known)
        if folded.is_number or folded.is_Symbol:
            known[symbol] = folded
        else:
            remaining[symbol] = folded
    return remaining, known


def _with_known_values(
    function: Function, definitions: Mapping[Symbol, Expr], known: Mapping[Symbol, Expr]
) -> Function:
    outputs = tuple(
        replace(output, entries=tuple(entry.xreplace(known) for entry in output.entries))
        for output in function.outputs
    )
    return replace(function, definitions=definitions, outputs=outputs)
