"""The derivation as a page: every named value and every result in LaTeX, in the order of the derivation."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from sympy import Basic, Expr, Symbol, latex

from pkmodes_derive.emit import layout
from pkmodes_derive.emit.latex import results
from pkmodes_derive.emit.latex.families import Families, Formula, Member
from pkmodes_derive.emit.templating import render
from pkmodes_derive.functions import Model
from pkmodes_derive.vocabulary import Quantity


def page(model: Model) -> str:
    """Return the page in Markdown with LaTeX mathematics."""
    names = {q.symbol: q.latex for q in model.vocabulary}
    parameters = {s for field in model.fields for s in field.symbols}
    definitions: dict[Symbol, Expr] = {}
    for function in model.functions:
        definitions.update({s: e for s, e in function.definitions.items() if s not in definitions})
    families = Families(model.vocabulary)
    return render(
        __package__,
        "derivation.md.j2",
        mechanism=model.mechanism,
        indices=layout.prose(
            f"Indices: {'; '.join(model.vocabulary.letters.values())}.  Entries of an array are indexed by k, l, m, "
            "or by their coordinates.",
            "",
        ),
        parameters=_table(q for q in model.vocabulary if q.symbol in parameters),
        inputs=_table(
            q for q in model.vocabulary if q.symbol not in parameters and q.symbol not in definitions
        ),
        families=_families(definitions, model, families),
        results=results.results(model, families, equation),
        relations=[(r.description, f"{r.latex} = {_typeset(r.expression, names)}") for r in model.relations],
    )


def equation(left: str, formula: Formula) -> str:
    """Return a formula as a line, with the conditions under which it holds."""
    conditions = ", ".join(rf"{a} \ne {b}" for a, b in formula.unequal)
    line = f"{left} = {_typeset(formula.expression, formula.names)}"
    return rf"{line} \qquad ({conditions})" if conditions else line


def _typeset(expression: Basic, names: Mapping[Symbol, str]) -> str:
    text: str = latex(expression, symbol_names=dict(names), mat_delim="[", fold_short_frac=False)
    return text


def _table(quantities: Iterable[Quantity]) -> list[tuple[str, str, str, str]]:
    """Return rows of (name, typeset, unit, description), one for each family."""
    rows: dict[object, tuple[str, str, str, str]] = {}
    for q in quantities:
        letters = {letter: letter for letter in q.index}
        rows.setdefault(q.family, (q.family.name, q.typeset(letters), q.unit, q.family.description))
    return list(rows.values())


def _families(
    definitions: Mapping[Symbol, Expr], model: Model, families: Families
) -> list[tuple[str, str, str, list[str]]]:
    """Return name, unit, description and equations of each family of named values."""
    groups: dict[object, list[Quantity]] = {}
    for symbol in definitions:
        quantity = model.vocabulary[symbol]
        groups.setdefault(quantity.family, []).append(quantity)
    named_values = []
    for quantities in groups.values():
        members = [Member(q.index, definitions[q.symbol]) for q in quantities]
        first = quantities[0]
        equations = [equation(first.typeset(f.index), f) for f in families.formulas(members)]
        named_values.append((first.family.name, first.family.unit, first.family.description, equations))
    return named_values
