"""One vocabulary of symbols: every quantity has a unit, a description and its place in the paper.

Nothing is derived here.  A mechanism declares its symbols through a `Vocabulary`; the emitted docstrings,
the parameter tables and the LaTeX page read units and descriptions from it, so that each is stated once.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import product

from sympy import Symbol

AXES = ("x", "y", "z")


@dataclass(frozen=True)
class Quantity:
    """What a symbol stands for.

    Attributes
    ----------
    symbol : sympy.Symbol
        Real-valued; its name is a Python and C identifier.
    unit : str
        SI unit, ``"1"`` when dimensionless.
    description : str
        A noun phrase that a reader of the generated code understands.
    latex : str
        How the symbol is typeset; the paper's symbol where it has one.
    family : tuple of (str, str)
        Name and description with the indices as letters, the same for all members: the glossary's entry.
    """

    symbol: Symbol
    unit: str
    description: str
    latex: str
    family: tuple[str, str]


@dataclass(frozen=True)
class Field:
    """A group of parameters that the generated code takes as one array.

    Attributes
    ----------
    name : str
        Name in the generated `Parameters`.
    shape : tuple of int
        ``()`` for a scalar; the leading index is the axis where there is one.
    symbols : tuple of sympy.Symbol
        The entries in row-major order.
    unit, description : str
        SI unit and a noun phrase.
    """

    name: str
    shape: tuple[int, ...]
    symbols: tuple[Symbol, ...]
    unit: str
    description: str

    @property
    def indices(self) -> list[tuple[int, ...]]:
        """Index of each entry, in the order of `symbols`."""
        return list(product(*(range(extent) for extent in self.shape)))


class Vocabulary:
    """The symbols of one mechanism, in the order in which they were declared."""

    def __init__(self) -> None:
        self._quantities: dict[Symbol, Quantity] = {}

    def declare(self, name: str, unit: str, description: str, latex: str, **index: object) -> Symbol:
        """Declare a real symbol; a name can be declared once.

        Parameters
        ----------
        name, unit, description, latex : str
            With ``{letter}`` for each index, which is filled in from `index`.
        **index
            Values of the indices by letter.

        Raises
        ------
        ValueError
            If the name is taken, or if unit, description or LaTeX form is empty.
        """
        family = (name, description)
        if index:
            letters = {letter: letter for letter in index}
            family = (name.format(**letters), description.format(**letters))
            name, description, latex = (text.format(**index) for text in (name, description, latex))
        if not (name.isidentifier() and unit and description and latex):
            raise ValueError(f"symbol {name!r} needs an identifier, a unit, a description and a LaTeX form")
        symbol = Symbol(name, real=True)
        if symbol in self._quantities:
            raise ValueError(f"symbol {name!r} is declared twice")
        self._quantities[symbol] = Quantity(symbol, unit, description, latex, family)
        return symbol

    def vector(
        self,
        name: str,
        unit: str,
        description: str,
        latex: str,
        *,
        axes: Sequence[str] = AXES,
        **index: object,
    ) -> tuple[Symbol, ...]:
        """Declare the components of a vector in the base frame, by default x, y and z; index letter i."""
        return tuple(
            self.declare(
                f"{name}_{{i}}",
                unit,
                f"{description}, component {{i}}",
                f"({latex})_{{i}}" if index else latex.replace("{", "{{").replace("}", "}}") + "_{i}",
                **index,
                i=axis,
            )
            for axis in axes
        )

    def __getitem__(self, symbol: Symbol) -> Quantity:
        return self._quantities[symbol]

    def __contains__(self, symbol: object) -> bool:
        return symbol in self._quantities

    def __iter__(self) -> Iterator[Quantity]:
        return iter(self._quantities.values())

    def __len__(self) -> int:
        return len(self._quantities)
