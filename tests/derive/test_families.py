"""Formulas with letters as indices: one for a whole family if it holds for every member, else for parts of it."""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

from sympy import Expr, Symbol

from pkmodes_derive.emit.latex.families import Families, Member
from pkmodes_derive.vocabulary import AXES, Vocabulary

VOCABULARY = Vocabulary()
A = [VOCABULARY.declare("a_{j}", "m", "a length of axis {j}", "a_{j}", j=j) for j in (1, 2, 3)]
B = [VOCABULARY.declare("b_{j}", "m", "another length of axis {j}", "b_{j}", j=j) for j in (1, 2, 3)]
N = [VOCABULARY.vector("n_{j}", "1", "a direction of axis {j}", "n_{j}", j=j) for j in (1, 2, 3)]
C = VOCABULARY.declare("c", "m", "one length", "c")
J = (1, 2, 3)


def shown(expression: Callable[..., Expr], *letters: str) -> list[tuple[str, str, tuple]]:
    """Return left-hand side, right-hand side with LaTeX names, and condition of each formula."""
    places = product(J, repeat=len(letters))
    members = [Member(dict(zip(letters, place, strict=True)), expression(*place)) for place in places]
    return [
        (
            ",".join(str(value) for value in formula.index.values()),
            str(formula.expression.xreplace({s: Symbol(text) for s, text in formula.names.items()})),
            formula.unequal,
        )
        for formula in Families(VOCABULARY).formulas(members)
    ]


def test_a_family_is_one_formula() -> None:
    assert shown(lambda j: A[j - 1] * B[j - 1] + C, "j") == [("j", "a_j*b_j + c", ())]
    assert shown(lambda j, k: A[j - 1] * B[k - 1], "j", "k") == [("j,k", "a_j*b_k", ())]


def test_a_sum_over_all_members_keeps_its_numbers() -> None:
    assert shown(lambda j: B[j - 1] * (A[0] + A[1] + A[2]), "j") == [("j", "b_j*(a_1 + a_2 + a_3)", ())]
    assert shown(lambda j: A[j - 1] * (A[0] + A[1] + A[2]), "j") == [("j", "a_j*(a_1 + a_2 + a_3)", ())]


def test_components_are_counted_by_numbers_too() -> None:
    members = [Member({"k": j, "l": i}, N[j - 1][i - 1]) for j in J for i in J]
    (formula,) = Families(VOCABULARY).formulas(members)
    assert list(formula.names.values()) == ["(n_k)_l"]
    assert len(AXES) == 3


def test_equal_indices_are_a_case_of_their_own() -> None:
    found = shown(lambda j, k: A[j - 1] + (C if j == k else 0), "j", "k")
    assert sorted(found) == [("j,j", "a_j + c", ()), ("j,k", "a_j", (("j", "k"),))]


def test_what_differs_in_more_than_indices_is_split_or_spelled_out() -> None:
    found = shown(lambda j, k: A[j - 1] * (B[j - 1] if k == 3 else C**k), "j", "k")
    assert found == [("j,1", "a_j*c", ()), ("j,2", "a_j*c**2", ()), ("j,3", "a_j*b_j", ())]
    cyclic = shown(lambda j: A[j % 3], "j")
    assert cyclic == [("1", "a_2", ()), ("2", "a_3", ()), ("3", "a_1", ())]
