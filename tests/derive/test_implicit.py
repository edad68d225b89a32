"""The implicit function theorem on closures that can be solved by hand."""

from __future__ import annotations

import pytest
from sympy import Matrix, Rational, Symbol, diff, simplify, solve, symbols

from pkmodes_derive import implicit
from pkmodes_derive.chain import Chain
from pkmodes_derive.vocabulary import Vocabulary

q1, q2 = symbols("q1 q2", real=True)
s1, s2, s3 = symbols("s1 s2 s3", real=True)

# Three closures that are triangular in s, so s(q) can be written down, with every kind of coupling.
CLOSURES = [s1 - q1 * q2, s2 + s1 * q1 - q2**2, s3 * q2 + s1**2 - s2 * q1]
POINT = {q1: Rational(3, 7), q2: Rational(5, 4)}


def explicit() -> list:
    solution = solve(CLOSURES, [s1, s2, s3], dict=True)[0]
    return [solution[s] for s in (s1, s2, s3)]


def test_first_and_second_derivatives_equal_those_of_the_explicit_solution() -> None:
    chain, s_of_q = Chain(), explicit()
    phi_s, right = implicit.first_order(CLOSURES, [q1, q2], [s1, s2, s3], chain)
    D = phi_s.LUsolve(right)
    names = Matrix(3, 2, lambda i, k: Symbol(f"D_{i}{k}", real=True))
    for i, s in enumerate((s1, s2, s3)):
        for k, q in enumerate((q1, q2)):
            chain.define(names[i, k], D[i, k])
            chain.rule(s, q, names[i, k])
    place = dict(zip((s1, s2, s3), s_of_q, strict=True))
    at = {**{s: value.subs(POINT) for s, value in place.items()}, **POINT}
    for i in range(3):
        for k, q in enumerate((q1, q2)):
            assert simplify(D[i, k].subs(place) - diff(s_of_q[i], q)) == 0
    for k, first in enumerate((q1, q2)):
        for second in (q1, q2)[k:]:
            forcing = implicit.second_order_forcing(CLOSURES, first, second, chain, tuple(names))
            values = {names[i, m]: D[i, m].subs(at) for i in range(3) for m in range(2)}
            found = phi_s.subs(at).LUsolve(Matrix([f.subs(values).subs(at) for f in forcing]))
            expected = Matrix([diff(s, first, second).subs(POINT) for s in s_of_q])
            assert simplify(found - expected) == Matrix.zeros(3, 1)


def test_cofactors_of_three_by_three_are_those_of_sympy() -> None:
    A = Matrix(3, 3, symbols("a:9", real=True))
    adjugate = Matrix(3, 3, lambda i, k: implicit.cofactor(A, k, i))
    assert (adjugate - A.adjugate()).expand() == Matrix.zeros(3, 3)


@pytest.mark.parametrize("n", [1, 2, 3, 4, 6])
def test_systems_of_any_size_are_solved_with_named_minors(n: int) -> None:
    """Compare with SymPy's solution in rational numbers, for the matrix and for its transpose."""
    chain, entries = Chain(), symbols(f"a:{n * n}", real=True)
    solver = implicit.Solver(Matrix(n, n, entries), Vocabulary(), chain, [f"s{i}" for i in range(n)])
    numbers = [
        Rational((7 * i * i + 3 * i + 1) % 11, 1 + i % 3) + (i % (n + 1) == 0) * 9 for i in range(n * n)
    ]
    values = dict(zip(entries, numbers, strict=True))
    A, b = Matrix(n, n, numbers), Matrix([Rational(k + 1, k + 2) for k in range(n)])
    assert A.det() != 0
    for symbol, expression in chain.definitions.items():
        values[symbol] = expression.xreplace(values)
    for found, matrix in ((solver.solve(list(b)), A), (solver.multipliers(list(b)), A.T)):
        assert Matrix([y.xreplace(values) for y in found]) == matrix.LUsolve(b)
