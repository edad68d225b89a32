"""Results of the functions, entry by entry: entries that differ only in their indices share one formula."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

from pkmodes_derive.emit.latex.families import Families, Formula, Member, grouped
from pkmodes_derive.functions import Function, Model, Output
from pkmodes_derive.vocabulary import AXES, Quantity, Vocabulary

#: Default index letters for the entries of an array.
LETTERS = ("k", "l", "m")


@dataclass(frozen=True)
class DisplayedResult:
    """A result as the page shows it.

    Attributes
    ----------
    same_as : str
        An earlier result with the same entries, if there is one.
    equations : tuple of str
        Equations of the nonzero entries; for a symmetric matrix, of the upper triangle.
    """

    name: str
    unit: str
    description: str
    same_as: str
    equations: tuple[str, ...]


def results(
    model: Model, families: Families, equation: Callable[[str, Formula], str]
) -> list[tuple[Function, list[DisplayedResult]]]:
    """Return every function with its results."""
    coordinates = {q.symbol.name: q for q in model.vocabulary}
    labels = [coordinates[name] for name, _ in model.coordinates]
    first_use: dict[tuple[object, ...], str] = {}
    results = []
    for function in model.functions:
        result_list = []
        for output in function.outputs:
            earlier = first_use.get((output.shape, output.entries), "")
            equations = () if earlier else _equations(output, labels, model.vocabulary, families, equation)
            first_use.setdefault((output.shape, output.entries), f"`{output.name}` of `{function.name}`")
            result_list.append(
                DisplayedResult(output.name, output.unit, output.description, earlier, equations)
            )
        results.append((function, result_list))
    return results


def _equations(
    output: Output,
    labels: list[Quantity],
    vocabulary: Vocabulary,
    families: Families,
    equation: Callable[[str, Formula], str],
) -> tuple[str, ...]:
    symbol = rf"\mathtt{{{output.name.replace('_', chr(92) + '_')}}}"
    letters = _letters(output, vocabulary)
    symmetric = output.symmetric
    lines = []
    entries = [
        (index, entry)
        for index, entry in zip(output.indices, output.entries, strict=True)
        if entry != 0 and not (symmetric and index[-2] > index[-1])
    ]
    # A dimension with one entry per generalised coordinate is labelled by these, any other by numbers; three entries
    # may also be vector components, so they get numbers.
    labelled = [extent == len(labels) != len(AXES) for extent in output.shape]
    dimensions = [
        _Dimension(letter, labels if by_coordinate else None, "'" * sum(labelled[:d]))
        for d, (letter, by_coordinate) in enumerate(zip(letters, labelled, strict=False))
    ]
    parts = grouped(
        (
            tuple(d.kind(i) for d, i in zip(dimensions, index, strict=True)),
            Member(
                {k: v for d, i in zip(dimensions, index, strict=True) for k, v in d.index(i).items()}, entry
            ),
        )
        for index, entry in entries
    )
    index_of = {
        tuple(k for d, i in zip(dimensions, index, strict=True) for k in d.index(i).items()): index
        for index, _ in entries
    }
    for part in parts:
        first = index_of[tuple(part[0].index.items())]
        for formula in families.formulas(part):
            subscript = ",".join(d.text(i, formula.index) for d, i in zip(dimensions, first, strict=True))
            lines.append(equation(f"{symbol}_{{{subscript}}}" if subscript else symbol, formula))
    return tuple(lines)


@dataclass(frozen=True)
class _Dimension:
    """One index of an array: a number with a letter, or a generalised coordinate with its own indices."""

    letter: str
    labels: list[Quantity] | None
    prime: str

    def kind(self, place: int) -> object:
        return self.labels[place].family if self.labels else None

    def index(self, place: int) -> dict[str, object]:
        if self.labels is None:
            return {self.letter: place + 1}
        return {letter + self.prime: value for letter, value in self.labels[place].index.items()}

    def text(self, place: int, index: Mapping[str, object]) -> str:
        if self.labels is None:
            return str(index[self.letter])
        q = self.labels[place]
        return q.typeset({letter: index[letter + self.prime] for letter in q.index})


def _letters(output: Output, vocabulary: Vocabulary) -> tuple[str, ...]:
    """Return the index letters of the entries' family if they form one, otherwise the default letters."""
    quantities = [vocabulary[entry] for entry in output.entries if entry.is_Symbol and entry in vocabulary]
    kinds = {q.family for q in quantities}
    if len(quantities) == len(output.entries) and len(kinds) == 1:
        own = tuple(quantities[0].index)
        if len(own) == len(output.shape):
            return own
    return LETTERS[: len(output.shape)]
