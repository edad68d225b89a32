"""Every symbol has a unit and a description, and every formula is dimensionally consistent."""

from __future__ import annotations

from functools import cache

import pint
import pytest
from sympy import Abs, Add, Expr, Mul, Number, NumberSymbol, Pow, Symbol, atan2, cos, sin, sympify

from pkmodes_derive import mechanisms
from pkmodes_derive.functions import Function, Model
from pkmodes_derive.vocabulary import Vocabulary

MODELS = {name: mechanisms.base(name) for name in mechanisms.names()}
FUNCTIONS = {
    f"{name} {function.name}": (model, function)
    for name, model in MODELS.items()
    for function in model.functions
}
UNITS = pint.UnitRegistry()


def symbols_of(function: Function) -> set[Symbol]:
    entries = [e for output in function.outputs for e in output.entries]
    arguments = {s for argument in function.arguments for s in argument.symbols}
    used = {s for e in [*function.definitions.values(), *entries] for s in sympify(e).free_symbols}
    return used | arguments | set(function.definitions)


def test_every_symbol_has_a_unit_and_a_description(subtests: pytest.Subtests) -> None:
    for model, function in FUNCTIONS.values():
        for symbol in symbols_of(function):
            with subtests.test(symbol=symbol):
                quantity = model.vocabulary[symbol]
                assert quantity.unit
                assert len(quantity.description.split()) >= 2
                assert quantity.latex
                unit(quantity.unit)


def test_incomplete_or_repeated_declarations_are_refused() -> None:
    vocabulary = Vocabulary()
    vocabulary.declare("a", "m", "a length", "a")
    for name, unit, description, latex in (
        ("a", "m", "again", "a"),
        ("b", "", "no unit", "b"),
        ("b", "m", "", "b"),
        ("not an identifier", "m", "a length", "b"),
    ):
        with pytest.raises(ValueError, match=r"declared twice|needs an identifier"):
            vocabulary.declare(name, unit, description, latex)


def test_an_index_has_a_letter_that_its_name_does_not_have() -> None:
    vocabulary = Vocabulary()
    with pytest.raises(ValueError, match="use another letter"):
        vocabulary.declare("k_{j}_{k}", "N/m", "stiffness of span {k} of belt {j}", "k_{{{j}{k}}}", j=1, k=2)
    vocabulary.declare("k_{j}_{s}", "N/m", "stiffness of span {s} of belt {j}", "k_{{{j}{s}}}", j=1, s=2)


def test_derivatives_by_parameters_are_one_family() -> None:
    vocabulary = Vocabulary()
    x, m = vocabulary.declare("x", "m", "a length", "x"), vocabulary.declare("m", "kg", "a mass", "m")
    pairs = [vocabulary[vocabulary.derivative(of, by)] for of, by in ((x, m), (m, x))]
    assert [q.symbol.name for q in pairs] == ["x_by_m", "m_by_x"]
    assert [q.unit for q in pairs] == ["(m)/(kg)", "(kg)/(m)"]
    assert len({q.family for q in pairs}) == 1


def test_quantities_are_typeset_with_any_values_or_letters() -> None:
    vocabulary = Vocabulary()
    quantity = vocabulary[vocabulary.vector("n_{j}", "1", "direction {j}", "n_{j}", j=2)[1]]
    assert quantity.latex == quantity.typeset(quantity.index) == "(n_2)_y"
    assert quantity.typeset({"j": "j", "i": "i"}) == "(n_j)_i"
    assert quantity.typeset({"j": "j'", "i": "x"}) == "(n_{j'})_x"


@cache
def unit(text: str) -> pint.Unit:
    return UNITS.Unit("dimensionless" if text == "1" else text.replace(" ", "*"))


def dimension(expression: Expr, v: Vocabulary) -> dict | None:
    """Return the dimension of an expression, None for a bare number; an inconsistent sum raises."""
    if isinstance(expression, Symbol):
        return dict(unit(v[expression].unit).dimensionality)
    if isinstance(expression, Number | NumberSymbol):
        return None
    if isinstance(expression, Add):
        found = [dimension(term, v) for term in expression.args]
        assert all(clean(d) == clean(found[0]) for d in found), expression
        return found[0]
    if isinstance(expression, Mul):
        total: dict = {}
        for factor in expression.args:
            for key, power in (dimension(factor, v) or {}).items():
                total[key] = total.get(key, 0) + power
        return total
    if isinstance(expression, Abs):
        return dimension(expression.args[0], v)
    if isinstance(expression, Pow):
        return {k: p * float(expression.exp) for k, p in (dimension(expression.base, v) or {}).items()}
    if isinstance(expression, sin | cos | atan2):
        arguments = [clean(dimension(argument, v)) for argument in expression.args]
        assert all(a == arguments[0] for a in arguments), expression
        assert isinstance(expression, atan2) or not arguments[0], expression
        return {}
    raise AssertionError(f"no rule for the dimension of {expression.func}")


def clean(d: dict | None) -> dict:
    return {k: round(float(p), 9) for k, p in (d or {}).items() if abs(p) > 1e-9}


@pytest.mark.parametrize("model", MODELS.values(), ids=MODELS)
def test_every_definition_has_the_dimension_of_its_unit(model: Model) -> None:
    v = model.vocabulary
    definitions = {s: e for function in model.functions for s, e in function.definitions.items()}
    for symbol, expression in definitions.items():
        assert clean(dimension(expression, v)) == clean(dimension(symbol, v)), symbol


def test_every_result_has_the_dimension_of_its_unit(subtests: pytest.Subtests) -> None:
    for name, (model, function) in FUNCTIONS.items():
        for output in function.outputs:
            with subtests.test(f"{name}: {output.name}"):
                allowed = [clean(dict(unit(u.strip()).dimensionality)) for u in output.unit.split(",")]
                for entry in output.entries:
                    if entry != 0:
                        assert clean(dimension(entry, model.vocabulary)) in allowed, entry


def test_arguments_have_the_units_of_their_symbols_and_functions_a_source(subtests: pytest.Subtests) -> None:
    for name, (model, function) in FUNCTIONS.items():
        with subtests.test(name=name):
            assert len(function.source.split()) >= 2
            for argument in function.arguments:
                declared = [u.strip() for u in argument.unit.split(",")]
                assert {model.vocabulary[s].unit for s in argument.symbols} == set(declared), argument.name


def test_fields_have_the_unit_of_their_symbols(subtests: pytest.Subtests) -> None:
    for name, model in MODELS.items():
        for field in model.fields:
            with subtests.test(f"{name} {field.name}"):
                assert {model.vocabulary[s].unit for s in field.symbols} == {field.unit}


def test_relations_that_are_shown_use_declared_symbols_of_the_right_dimension() -> None:
    model = MODELS["linear_delta"]
    used = {s for relation in model.relations for s in relation.expression.free_symbols}
    units = {model.vocabulary[s].family[0]: model.vocabulary[s].unit for s in used}
    assert units == {"phi_j": "rad", "u_j_i": "m", "s_j_i": "m", "l_d_j": "m", "m_d_j": "kg"}
