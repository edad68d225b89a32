"""Prose in generated code that is the same in every language."""

from __future__ import annotations

from collections.abc import Iterable

from pkmodes_derive.emit.program import Program
from pkmodes_derive.vocabulary import Quantity, Vocabulary


def glossary(vocabulary: Vocabulary, programs: Iterable[Program]) -> list[str]:
    """Return the descriptions of the named values in the code, one entry for each family."""
    families = dict.fromkeys(q.family for q in _named(vocabulary, programs))
    return [f"{f.name} [{f.unit}]: {f.description}" for f in families]


def indices(vocabulary: Vocabulary, programs: Iterable[Program]) -> str:
    """Return the introduction of the glossary: the meaning of index letters and of numbered names."""
    used = {letter for q in _named(vocabulary, programs) for letter in q.index}
    counted = "; ".join(text for letter, text in vocabulary.letters.items() if letter in used)
    names = f"Names in the code.  Indices: {counted}." if counted else "Names in the code."
    return f"{names}  t1, t2, ... are subexpressions shared by several values."


def operations(program: Program) -> str:
    """Return the operation counts of a function as a sentence."""
    return (
        f"{program.operations} operations; {program.operations_written_out} with every named value expanded."
    )


def _named(vocabulary: Vocabulary, programs: Iterable[Program]) -> list[Quantity]:
    used = {symbol for program in programs for symbol, _ in program.steps}
    return [q for q in vocabulary if q.symbol in used]
