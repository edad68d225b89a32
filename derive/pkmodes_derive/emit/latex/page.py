"""The derivation as a page: every named value and every result in LaTeX, in the order of the derivation."""

from __future__ import annotations

from collections.abc import Iterable

from sympy import Basic, Expr, Symbol, latex

from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import Function, Model, Output
from pkmodes_derive.vocabulary import Family, Quantity, Vocabulary


def page(model: Model) -> str:
    """Return the page in Markdown with LaTeX mathematics."""
    names = {q.symbol: q.latex for q in model.vocabulary}
    parameters = {s for field in model.fields for s in field.symbols}
    definitions: dict[Symbol, Expr] = {}
    for function in model.functions:
        definitions.update({s: e for s, e in function.definitions.items() if s not in definitions})
    return render(
        __package__,
        "derivation.md.j2",
        mechanism=model.mechanism,
        parameters=_table(q for q in model.vocabulary if q.symbol in parameters),
        inputs=_table(
            q for q in model.vocabulary if q.symbol not in parameters and q.symbol not in definitions
        ),
        families=_families(definitions, model.vocabulary, names),
        results=[(f.name, f.summary, f.source, _results(f, names)) for f in model.functions],
        relations=[(r.description, f"{r.latex} = {_typeset(r.expression, names)}") for r in model.relations],
    )


def _typeset(expression: Basic, names: dict[Symbol, str]) -> str:
    text: str = latex(expression, symbol_names=names, mat_delim="[", fold_short_frac=False)
    return text


def _table(quantities: Iterable[Quantity]) -> list[tuple[str, str, str, str]]:
    """Rows of (name, first symbol typeset, unit, description), one for each family."""
    rows = {}
    for q in quantities:
        rows.setdefault(q.family, (q.family.name, q.latex, q.unit, q.family.description))
    return list(rows.values())


def _families(
    definitions: dict[Symbol, Expr], vocabulary: Vocabulary, names: dict[Symbol, str]
) -> list[tuple[str, str, str, list[str]]]:
    groups: dict[Family, list[str]] = {}
    for symbol, expression in definitions.items():
        quantity = vocabulary[symbol]
        equations = groups.setdefault(quantity.family, [])
        equations.append(f"{quantity.latex} = {_typeset(expression, names)}")
    return [(f.name, f.unit, f.description, lines) for f, lines in groups.items()]


def _results(function: Function, names: dict[Symbol, str]) -> list[tuple[str, str, str, list[str]]]:
    return [(o.name, o.unit, o.description, _entries(o, names)) for o in function.outputs]


def _entries(output: Output, names: dict[Symbol, str]) -> list[str]:
    """Equations of the entries that are not zero; of a symmetric matrix the upper triangle."""
    shape, equations = output.shape, []
    symmetric = len(shape) == 2 and shape[0] == shape[1] and _is_symmetric(output)
    symbol = rf"\mathtt{{{output.name.replace('_', chr(92) + '_')}}}"
    for number, entry in enumerate(output.entries):
        index, rest = [], number
        for extent in reversed(shape):
            index.insert(0, rest % extent)
            rest //= extent
        if entry == 0 or (symmetric and index[0] > index[1]):
            continue
        place = f"_{{{','.join(str(i + 1) for i in index)}}}" if index else ""
        equations.append(f"{symbol}{place} = {_typeset(entry, names)}")
    return equations


def _is_symmetric(output: Output) -> bool:
    n = output.shape[0]
    return all(output.entries[n * k + m] == output.entries[n * m + k] for k in range(n) for m in range(k))
