"""Differentiation through named values, compared with SymPy's differentiation of the expanded expression."""

from __future__ import annotations

import pytest
from sympy import Symbol, cos, diff, exp, expand, sin, sqrt

from pkmodes_derive.chain import Chain

x, y, a, b, c = (Symbol(name, real=True) for name in "xyabc")


@pytest.fixture
def chain() -> Chain:
    chain = Chain()
    chain.define(a, sin(x) * y)
    chain.define(b, exp(a) + x)
    chain.define(c, sqrt(1 + b**2) * a)
    return chain


def test_derivative_passes_through_definitions(chain: Chain) -> None:
    written_out = chain.expand(c * x)
    for variable in (x, y):
        found = chain.expand(chain.derivative(c * x, variable))
        assert (found - diff(written_out, variable)).equals(0)


def test_hessian_is_symmetric_and_equals_the_written_out_one(chain: Chain) -> None:
    hessian = chain.hessian(b, [x, y])
    assert hessian[0][1] is hessian[1][0]
    for i, first in enumerate((x, y)):
        for k, second in enumerate((x, y)):
            assert (chain.expand(hessian[i][k]) - diff(chain.expand(b), first, second)).equals(0)


def test_rules_take_precedence_over_definitions(chain: Chain) -> None:
    chain.rule(a, x, cos(y))
    assert chain.derivative(a, x) == cos(y)
    assert expand(chain.derivative(b, x) - (exp(a) * cos(y) + 1)) == 0


def test_a_rule_stated_later_is_not_hidden_by_an_earlier_result(chain: Chain) -> None:
    before = chain.derivative(b, x)
    chain.rule(a, x, cos(y))
    assert chain.derivative(b, x) != before


def test_held_symbols_are_constant(chain: Chain) -> None:
    assert chain.derivative(b, x, hold=[a]) == 1
    assert chain.derivative(a, a, hold=[a]) == 1


def test_a_symbol_has_one_definition_and_one_rule(chain: Chain) -> None:
    with pytest.raises(ValueError, match="defined twice"):
        chain.define(a, x)
    chain.rule(a, x, y)
    with pytest.raises(ValueError, match="set twice"):
        chain.rule(a, x, y)
