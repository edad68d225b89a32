"""The vocabulary of symbols: every quantity has a unit, a description and a LaTeX form.

Nothing is derived here.  A mechanism declares its symbols through a `Vocabulary`; the emitted docstrings,
the parameter tables and the LaTeX page read units and descriptions from it, so each is written once.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import NamedTuple

from sympy import Symbol

from pkmodes_derive.reserved_words import is_reserved

AXES = ("x", "y", "z")


class DeclarationError(ValueError):
    """An invalid declaration: what is wrong, and what to do about it."""

    def __init__(self, what: str, remedy: str) -> None:
        super().__init__(what)
        self.remedy = remedy


class Family(NamedTuple):
    """Quantities that differ only in their indices: one entry of a glossary.

    Attributes
    ----------
    name, description : str
        With the indices as letters.
    unit : str
        SI unit of all members, or a rule for it.
    """

    name: str
    description: str
    unit: str


#: Derivatives of named values with respect to parameters: hundreds of members, one meaning.
DERIVATIVES = Family(
    "X_by_Y", "derivative of X with respect to the parameter Y, at a fixed pose", "unit of X / unit of Y"
)


@dataclass(frozen=True)
class Quantity:
    """The meaning of a symbol.

    Attributes
    ----------
    symbol : sympy.Symbol
        Real-valued; its name is a Python and C identifier.
    unit : str
        SI unit, ``"1"`` when dimensionless.
    description : str
        A noun phrase that a reader of the generated code understands.
    latex : str
        LaTeX form; the paper's symbol if it has one.
    family : Family
        Its name and description with the indices as letters.
    index : mapping of str to object
        Value of each index by its letter, in order.
    template : str
        The LaTeX form with ``{letter}`` for each index.
    """

    symbol: Symbol
    unit: str
    description: str
    latex: str
    family: Family
    index: Mapping[str, object] = field(default_factory=dict)
    template: str = ""

    def typeset(self, index: Mapping[str, object]) -> str:
        """Return the LaTeX form with other index values, or with letters."""
        if not self.index:
            return self.latex
        braced = {letter: f"{{{v}}}" if len(str(v)) > 1 else v for letter, v in index.items()}
        return self.template.format(**braced)


@dataclass(frozen=True)
class Field:
    """A group of parameters that the generated code takes as one array.

    Attributes
    ----------
    name : str
        Name in the generated `Parameters`.
    shape : tuple of int
        ``()`` for a scalar; the leading index is the axis if there is one.
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


def _fill_indices(text: str, index: Mapping[str, object]) -> str:
    try:
        return text.format(**index)
    except (LookupError, ValueError):
        letters = ", ".join(f"{{{letter}}}" for letter in index)
        raise DeclarationError(
            f"cannot fill in the indices {letters} of {text!r}", "double all other braces"
        ) from None


class Vocabulary:
    """The symbols of one mechanism, in declaration order.

    Parameters
    ----------
    letters : mapping of str to str
        Meaning of each index letter, such as "axis j".
    """

    def __init__(self, letters: Mapping[str, str] | None = None) -> None:
        self.letters = dict(letters or {})
        self._quantities: dict[Symbol, Quantity] = {}

    def declare(self, name: str, unit: str, description: str, latex: str, **index: object) -> Symbol:
        """Declare a real symbol; a name can be declared only once.

        Parameters
        ----------
        name, unit, description, latex : str
            With ``{letter}`` for each index, filled in from `index`.
        **index
            Values of the indices by letter.

        Raises
        ------
        ValueError
            If the name is taken, if unit, description or LaTeX form is empty, or if an index letter is also a
            word of the name.
        """
        family, template = Family(name, description, unit), latex
        if index:
            if index.keys() & set(re.sub(r"\{\w\}", "", name).split("_")):
                raise ValueError(
                    f"an index letter of {name!r} is also a word of the name; use another letter"
                )
            letters = {letter: letter for letter in index}
            family = Family(_fill_indices(name, letters), _fill_indices(description, letters), unit)
            name, description, latex = (_fill_indices(text, index) for text in (name, description, latex))
        if not (name.isidentifier() and unit and description and latex):
            raise ValueError(f"symbol {name!r} needs an identifier, a unit, a description and a LaTeX form")
        if is_reserved(name):
            raise DeclarationError(f"symbol {name!r} is reserved in generated code", "give it another name")
        symbol = Symbol(name, real=True)
        if symbol in self._quantities:
            raise DeclarationError(
                f"symbol {name!r} is declared twice",
                "rename it: another quantity or effect has that name",
            )
        self._quantities[symbol] = Quantity(symbol, unit, description, latex, family, index, template)
        return symbol

    def derivative(self, value_symbol: Symbol, parameter_symbol: Symbol) -> Symbol:
        """Declare the derivative of a named value with respect to a parameter, at a fixed pose, as one family."""
        value, parameter = self[value_symbol], self[parameter_symbol]
        symbol = self.declare(
            f"{value_symbol.name}_by_{parameter_symbol.name}",
            f"({value.unit})/({parameter.unit})",
            f"derivative at a fixed pose of: {value.description}; with respect to: {parameter.description}",
            rf"\frac{{d {value.latex}}}{{d {parameter.latex}}}",
        )
        self._quantities[symbol] = replace(self._quantities[symbol], family=DERIVATIVES)
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
