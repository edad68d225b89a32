"""What generated code says about itself in words, the same in every language."""

from __future__ import annotations

from collections.abc import Iterable

from pkmodes_derive.emit.program import Program
from pkmodes_derive.vocabulary import Quantity, Vocabulary


def glossary(vocabulary: Vocabulary, programs: Iterable[Program]) -> list[str]:
    """What the named values in the code are: one entry for all members of a family."""
    families = dict.fromkeys(q.family for q in _named(vocabulary, programs))
    return [f"{f.name} [{f.unit}]: {f.description}" for f in families]


def indices(vocabulary: Vocabulary, programs: Iterable[Program]) -> str:
    """What comes before the glossary: what the letters of indices count, and which names are no names."""
    used = {letter for q in _named(vocabulary, programs) for letter in q.index}
    counted = "; ".join(text for letter, text in vocabulary.letters.items() if letter in used)
    names = f"Names in the code, for {counted}." if counted else "Names in the code."
    return f"{names}  t1, t2, ... are subexpressions that several values share."


def operations(program: Program) -> str:
    """What a function costs."""
    return f"{program.operations} operations; {program.operations_written_out} with every named value written out."


def _named(vocabulary: Vocabulary, programs: Iterable[Program]) -> list[Quantity]:
    used = {symbol for program in programs for symbol, _ in program.steps}
    return [q for q in vocabulary if q.symbol in used]
