"""Formulas that differ only in their indices, written once with letters as indices.

A formula is guessed from one member: each index in it that has the value of one of the member's own indices may
stand for that index.  The guess holds if it reproduces the formula of every other member.  If no guess holds, the
members are split (by whether two indices are equal, or by the value of an index) and the parts are tried again;
remaining members are written out.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations, islice, product

from sympy import Expr, Symbol, default_sort_key, preorder_traversal

from pkmodes_derive.vocabulary import AXES, Quantity, Vocabulary

Index = Mapping[str, object]
#: Guesses that are tried for one part of a family before it is split.
MAX_GUESSES = 2000


@dataclass(frozen=True)
class Member:
    """One formula of a family: the values of its indices by their letters, and its right-hand side."""

    index: Index
    expression: Expr


@dataclass(frozen=True)
class Formula:
    """A formula for one or more members.

    Attributes
    ----------
    index : mapping of str to object
        Letter or value of each index of the family on the left-hand side.
    expression : sympy.Expr
        The right-hand side; `names` has the LaTeX forms of its symbols.
    unequal : tuple of (str, str)
        Pairs of indices that must differ, because equal ones have another formula.
    """

    index: Index
    expression: Expr
    names: Mapping[Symbol, str]
    unequal: tuple[tuple[str, str], ...] = ()


class Families:
    """The formulas of families whose members are written in the symbols of a vocabulary."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary
        self._symbols = {(q.family, tuple(q.index.values())): q.symbol for q in vocabulary if q.index}

    def formulas(self, members: Sequence[Member]) -> list[Formula]:
        """Return the fewest formulas found for these members, in the order of the members."""
        return self._formulas(members, True, {})

    def _formulas(
        self, members: Sequence[Member], is_whole_family: bool, known: dict[tuple[int, ...], list[Formula]]
    ) -> list[Formula]:
        if len(members) == 1:
            return [self._written_out(members[0])]
        key = tuple(map(id, members))
        if key not in known:
            formula = self._common_formula(members, is_whole_family)
            splits = () if formula else _possible_splits(members)
            alternatives = (
                [f for key in groups for f in self._formulas(key, False, known)] for groups in splits
            )
            known[key] = [formula] if formula else min(alternatives, key=len)
        return known[key]

    def _written_out(self, member: Member) -> Formula:
        names = {s: self._vocabulary[s].latex for s in member.expression.free_symbols}
        return Formula(member.index, member.expression, names)

    def _common_formula(self, members: Sequence[Member], is_whole_family: bool) -> Formula | None:
        """Return one formula for all members, or None."""
        common = _common_indices(members)
        letters = [letter for letter, value in common.items() if letter == value]
        members, sums = _without_common_sums(members)
        # A member with distinct indices leaves the fewest guesses.
        first = max(members, key=lambda m: len({m.index[letter] for letter in letters}))
        symbols = sorted(first.expression.free_symbols - sums.keys(), key=default_sort_key)
        choices = [list(self._choices(s, first, members, letters)) for s in symbols]
        others = [m for m in members if m is not first]
        for indices in islice(product(*choices), MAX_GUESSES):
            guess = dict(zip(symbols, indices, strict=True))
            if self._holds(guess, first, others):
                unequal = () if is_whole_family else tuple(_unequal(members, common))
                return self._formula_of_guess(guess, first, sums, common, unequal)
        return None

    def _choices(
        self, symbol: Symbol, first: Member, members: Sequence[Member], letters: Sequence[str]
    ) -> Iterator[Index]:
        """Yield candidates for the indices of a symbol: letters or values for which every member has a symbol."""
        quantity = self._vocabulary[symbol]
        slots = [
            # The value first: if every member has it, it is one term of a sum.
            [value, *(letter for letter in letters if _value(first.index[letter], value) == value)]
            for value in quantity.index.values()
        ]
        for chosen in product(*slots):
            index = dict(zip(quantity.index, chosen, strict=True))
            if all(self._symbol(quantity, index, m) in m.expression.free_symbols for m in members):
                yield index

    def _symbol(self, quantity: Quantity, index: Index, member: Member) -> Symbol | None:
        """Return the symbol that a choice of indices denotes for a member."""
        if not quantity.index:
            return quantity.symbol
        values = (
            _value(member.index[choice], own)
            if isinstance(choice, str) and choice in member.index
            else choice
            for choice, own in zip(index.values(), quantity.index.values(), strict=True)
        )
        return self._symbols.get((quantity.family, tuple(values)))

    def _holds(self, guess: Mapping[Symbol, Index], first: Member, others: list[Member]) -> bool:
        for member in others:
            substitution = {s: self._symbol(self._vocabulary[s], index, member) for s, index in guess.items()}
            if first.expression.xreplace(substitution) != member.expression:
                others.remove(member)  # the next guess is likely to fail here as well
                others.insert(0, member)
                return False
        return True

    def _formula_of_guess(
        self,
        guess: Mapping[Symbol, Index],
        first: Member,
        sums: Mapping[Symbol, Expr],
        common: Index,
        unequal: tuple[tuple[str, str], ...],
    ) -> Formula:
        substitution: dict[Symbol, Expr] = dict(sums)
        names = {s: self._vocabulary[s].latex for e in sums.values() for s in e.free_symbols}
        for symbol, index in guess.items():
            quantity = self._vocabulary[symbol]
            text = quantity.typeset(index)
            if text != quantity.latex:
                substitution[symbol] = Symbol(f"{quantity.family.name}:{text}", real=True)
            names[substitution.get(symbol, symbol)] = text
        return Formula(common, first.expression.xreplace(substitution), names, unequal)


def _without_common_sums(members: Sequence[Member]) -> tuple[list[Member], dict[Symbol, Expr]]:
    """Return members with a name for each sum that they have in common, and the meaning of the names.

    In such a sum an index keeps its value; elsewhere in the same formula it may stand for a letter.
    """
    parts = [{e for e in preorder_traversal(m.expression) if e.is_Add and e != m.expression} for m in members]
    common = sorted(set.intersection(*parts), key=default_sort_key)
    names = {part: Symbol(f"sum {number}", real=True) for number, part in enumerate(common)}
    named = [Member(m.index, m.expression.xreplace(names)) for m in members]
    return named, {name: part for part, name in names.items()}


def _value(value: object, example: object) -> object:
    """Return the value of an index, as a component (x, y, z) if `example` is one."""
    if example in AXES and isinstance(value, int) and 1 <= value <= len(AXES):
        return AXES[value - 1]
    return value


def _common_indices(members: Sequence[Member]) -> dict[str, object]:
    """Return the indices of a common left-hand side: a value shared by all members, an equal index, or a letter."""
    common: dict[str, object] = {}
    for letter, value in members[0].index.items():
        equal = [a for a in common if common[a] == a and all(m.index[a] == m.index[letter] for m in members)]
        is_constant = all(m.index[letter] == value for m in members)
        common[letter] = value if is_constant else equal[0] if equal else letter
    return common


def _unequal(members: Sequence[Member], common: Index) -> Iterator[tuple[str, str]]:
    free = [letter for letter, value in common.items() if value == letter]
    for a, b in combinations(free, 2):
        comparable = {m.index[a] for m in members} & {m.index[b] for m in members}
        if comparable and all(m.index[a] != m.index[b] for m in members):
            yield a, b


def _possible_splits(members: Sequence[Member]) -> Iterator[list[list[Member]]]:
    """Yield ways to split members: by whether two indices are equal, and by the value of an index."""
    letters = list(members[0].index)
    keys: list[list[object]] = [
        [m.index[a] == m.index[b] for m in members] for a, b in combinations(letters, 2)
    ]
    keys += [[m.index[letter] for m in members] for letter in letters]
    for key in keys:
        parts: dict[object, list[Member]] = {}
        for value, member in zip(key, members, strict=True):
            parts.setdefault(value, []).append(member)
        if len(parts) > 1:
            yield list(parts.values())


def grouped(items: Iterable[tuple[object, Member]]) -> list[list[Member]]:
    """Group members by key, in their order."""
    groups: dict[object, list[Member]] = {}
    for key, member in items:
        groups.setdefault(key, []).append(member)
    return list(groups.values())
