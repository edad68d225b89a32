"""Tables of a robot file: each key declares its symbols, its place in the generated parameters, and its description.

A mechanism declares a quantity once, with the paper's symbol, unit and bounds; the schema of the robot file, the
parameter paths, the arrays of the generated code and the glossary follow.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from itertools import chain as concatenate
from typing import TypeVar

from sympy import Symbol

from pkmodes_derive.vocabulary import AXES, DeclarationError, Field, Vocabulary
from pkmodes_description import UNITS, Key, Table

#: Dimensions that a key can have; others are those of effects.
DIMENSIONS = (
    "mass",
    "length",
    "angle",
    "number",
    "moment of inertia",
    "specific stiffness",
    "stiffness",
    "torsional stiffness",
    "acceleration",
)
#: Keys of every robot file that a mechanism does not declare.
RESERVED = ("format", "name", "mechanism", "gravity", "effects", "usable", "damping")


def _check_key(name: str) -> None:
    if not re.fullmatch("[a-z][a-z0-9_]*", name):
        raise DeclarationError(
            f"{name!r} cannot be a key of a robot file", "use lower-case letters, digits and underscores"
        )


def unit_of(dimension: str) -> str:
    """Return the SI unit of a dimension."""
    if dimension not in DIMENSIONS:
        raise DeclarationError(f"unknown dimension {dimension!r}", f"use one of {', '.join(DIMENSIONS)}")
    return UNITS[dimension]


Symbols = tuple[Symbol, ...]
AnyTable = TypeVar("AnyTable", bound="Declared")


class Tables:
    """The tables of one mechanism's robot file, in declaration order."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        self._vocabulary = vocabulary
        self._tables: list[Declared] = []
        self.fields: list[Field] = []

    def single(self, name: str, description: str) -> Declared:
        """Declare a table that occurs once."""
        return self._add_table(Declared(self, name, description, 0, ""))

    def repeated(self, name: str, count: int, description: str) -> Repeated:
        """Declare a repeated table, with index letter j."""
        return self._add_table(Repeated(self, name, description, count, ""))

    def constant(self, table: str, key: str, description: str, default: float, effect: str) -> None:
        """Declare a table of a mass that only an effect uses, with a default."""
        added = self._add_table(Declared(self, table, description, 0, ""))
        added.constant(key, "mass", description, effect, default=default, above=0.0)

    @property
    def numbers(self) -> range:
        """Numbers of the entries of the repeated table, from 1."""
        return range(1, max(table.count for table in self._tables) + 1)

    def described(self) -> tuple[Table, ...]:
        """Return the descriptions of the tables, the repeated one last."""
        tables = sorted(self._tables, key=lambda table: table.count)
        return tuple(Table(t.name, t.description, tuple(t.keys), t.count, t.shared_by) for t in tables)

    def declare(self, name: str, unit: str, description: str, latex: str, count: int) -> Symbols:
        """Declare one symbol, or one for each entry of a repeated table."""
        if not count:
            return (self._vocabulary.declare(name, unit, description, latex),)
        return tuple(
            self._vocabulary.declare(f"{name}_{{j}}", unit, description, latex, j=j)
            for j in range(1, count + 1)
        )

    def vectors(
        self, name: str, unit: str, description: str, latex: str, count: int, axes: Sequence[str] = AXES
    ) -> tuple[Symbols, ...]:
        """Declare the components of one vector for each entry of a repeated table."""
        vector = self._vocabulary.vector
        return tuple(
            vector(f"{name}_{{j}}", unit, description, latex, axes=axes, j=j) for j in range(1, count + 1)
        )

    def field(
        self, name: str, shape: tuple[int, ...], symbols: Sequence[Symbol], unit: str, description: str
    ) -> None:
        """Add an array to the generated parameters."""
        _check_key(name)
        if name in (field.name for field in self.fields):
            raise DeclarationError(f"the parameter {name} is declared twice", "rename its key or its table")
        self.fields.append(Field(name, shape, tuple(symbols), unit, description.format(j="j")))

    def _add_table(self, table: AnyTable) -> AnyTable:
        _check_key(table.name)
        if table.name in RESERVED:
            raise DeclarationError(
                f'"{table.name}" is a key of every robot file', "give the table another name"
            )
        if table.name in (known.name for known in self._tables):
            raise DeclarationError(f"the table {table.name} is declared twice", "give it another name")
        self._tables.append(table)
        return table


class Declared:
    """A table whose keys are declared one by one."""

    def __init__(self, tables: Tables, name: str, description: str, count: int, shared_by: str) -> None:
        self.name, self.description, self.count, self.shared_by = name, description, count, shared_by
        self.keys: list[Key] = []
        self._tables, self._entries = tables, count

    def quantity(
        self,
        key: str,
        symbol: str,
        dimension: str,
        description: str,
        *,
        latex: str = "",
        field: str = "",
        at_least: float | None = None,
        above: float | None = None,
        signed: bool = False,
    ) -> Symbols:
        """Declare a quantity; in a shared table, one for each entry that shares it."""
        name, unit = field or f"{self.name}_{key}", unit_of(dimension)
        symbols = self._tables.declare(symbol, unit, description, latex or symbol, self._entries)
        self._tables.field(name, (self._entries,) if self._entries else (), symbols, unit, description)
        self.keys.append(
            Key(
                key,
                "quantity",
                name,
                dimension,
                description.format(j="j"),
                at_least=at_least,
                above=above,
                signed=signed,
            )
        )
        return symbols

    def vector_of(
        self,
        key: str,
        symbol: str,
        dimension: str,
        description: str,
        latex: str,
        elements: Sequence[str] = AXES,
        *,
        above: float | None = None,
        default: float | None = None,
    ) -> Symbols:
        """Declare several numbers under one key of a single table; letter i for the element in their LaTeX.

        They may have either sign if there is no bound.  With a default the key may be left out.
        """
        unit, name = unit_of(dimension), f"{self.name}_{key}"
        declare = self._tables._vocabulary.declare
        symbols = tuple(
            declare(f"{symbol}_{{i}}", unit, f"{description}, component {{i}}", latex, i=one)
            for one in elements
        )
        self._tables.field(name, (len(elements),), symbols, unit, description)
        self.keys.append(
            Key(
                key,
                "vector",
                name,
                dimension,
                description,
                elements=tuple(elements),
                above=above,
                default=default,
                signed=above is None,
            )
        )
        return symbols

    def constant(
        self,
        key: str,
        dimension: str,
        description: str,
        effect: str,
        *,
        default: float = 0.0,
        middle_of: str = "",
        above: float | None = None,
    ) -> None:
        """Declare a quantity that only an effect uses, ``<effect>.<parameter>``.

        Without it the value is the default, or the middle of the pair with the path `middle_of`.
        """
        self.keys.append(
            Key(
                key,
                "quantity",
                "",
                dimension,
                description,
                above=above,
                default=default,
                effect=effect,
                signed=above is None,
                suspected=False,
                middle_of=middle_of,
            )
        )

    def ranges(
        self, keys: Sequence[str], symbol: str, description: str, latex: str
    ) -> tuple[Symbols, Symbols]:
        """Declare length ranges, lower end first, under several keys that share one field; letter i for the key."""
        v = self._tables._vocabulary
        ends = tuple(
            tuple(
                v.declare(
                    f"{symbol}_{end}_{{i}}", "m", f"{which} end of {description}", rf"\{end}({latex})", i=key
                )
                for key in keys
            )
            for end, which in (("min", "lower"), ("max", "upper"))
        )
        symbols = tuple(concatenate(*zip(*ends, strict=True)))
        self._tables.field(self.name, (len(keys), 2), symbols, "m", self.description)
        for place, key in enumerate(keys):
            what = description.format(i=key)
            pair = ("min", "max")
            self.keys.append(
                Key(key, "pair", self.name, "length", what, (place,), pair, signed=True, suspected=False)
            )
        return ends[0], ends[1]


class Repeated(Declared):
    """A repeated table; each entry may override the keys of the tables that the entries share."""

    def shared(self, name: str, description: str) -> Declared:
        """Declare a table that the entries share."""
        table = self._tables._add_table(Declared(self._tables, name, description, 0, self.name))
        table._entries = self.count
        return table

    def vector(
        self, key: str, symbol: str, description: str, latex: str, axes: Sequence[str] = AXES
    ) -> tuple[Symbols, ...]:
        """Declare a position in the base frame."""
        symbols = self._tables.vectors(symbol, "m", description, latex, self.count, axes)
        self._tables.field(key, (self.count, len(axes)), tuple(concatenate(*symbols)), "m", description)
        self._add(key, "vector", key, "length", description, elements=tuple(axes), signed=True)
        return symbols

    def direction(self, key: str, symbol: str, description: str, latex: str) -> tuple[Symbols, ...]:
        """Declare a unit vector."""
        symbols = self._tables.vectors(symbol, "1", description, latex, self.count)
        self._tables.field(key, (self.count, 3), tuple(concatenate(*symbols)), "1", description)
        self._add(key, "direction", key, "number", description)
        return symbols

    def pair(
        self,
        key: str,
        low: tuple[str, str, str],
        high: tuple[str, str, str],
        dimension: str,
        description: str,
        **bounds: float,
    ) -> tuple[Symbols, Symbols]:
        """Declare a range, lower end first; each end is (symbol, description, LaTeX form)."""
        unit = unit_of(dimension)
        ends = tuple(
            self._tables.declare(symbol, unit, what, tex, self.count) for symbol, what, tex in (low, high)
        )
        self._tables.field(
            key, (self.count, 2), tuple(concatenate(*zip(*ends, strict=True))), unit, description
        )
        self._add(key, "pair", key, dimension, description, elements=("min", "max"), signed=True, **bounds)
        return ends[0], ends[1]

    def lengths(self, key: str, symbol: str, count: int, description: str, latex: str) -> tuple[Symbols, ...]:
        """Declare several positive lengths for each entry, with index letter k."""
        return self._several(key, "vector", symbol, "length", count, description, latex, above=0.0)

    def signs(self, key: str, symbol: str, count: int, description: str, latex: str) -> tuple[Symbols, ...]:
        """Declare several numbers for each entry, each +1 or -1, with index letter k."""
        return self._several(key, "signs", symbol, "number", count, description, latex, choices=(1, -1))

    def choice(
        self, key: str, symbol: str, choices: tuple[int, ...], description: str, latex: str
    ) -> Symbols:
        """Declare a choice of one of several numbers."""
        symbols = self._tables.declare(symbol, "1", description, latex, self.count)
        self._tables.field(key, (self.count,), symbols, "1", description)
        self._add(key, "choice", key, "number", description, choices=choices)
        return symbols

    def one_of(
        self,
        key: str,
        field: str,
        symbol: str,
        choices: tuple[int, ...],
        what: str,
        description: str,
        latex: str,
    ) -> tuple[Symbols, ...]:
        """Declare a choice of one of several numbers k, as symbols that are 1 for the chosen number, else 0."""
        v, entries = self._tables._vocabulary, range(1, self.count + 1)
        symbols = tuple(
            tuple(v.declare(f"{symbol}_{{j}}_{{k}}", "1", description, latex, j=j, k=k) for k in choices)
            for j in entries
        )
        shape = (self.count, len(choices))
        self._tables.field(field, shape, tuple(concatenate(*symbols)), "1", description.format(j="j", k="k"))
        self._add(key, "one_of", field, "number", what, choices=choices)
        return symbols

    def _several(
        self,
        key: str,
        kind: str,
        symbol: str,
        dimension: str,
        count: int,
        description: str,
        latex: str,
        *,
        above: float | None = None,
        choices: tuple[int, ...] = (),
    ) -> tuple[Symbols, ...]:
        v, unit, numbers = self._tables._vocabulary, unit_of(dimension), range(1, count + 1)
        symbols = tuple(
            tuple(v.declare(f"{symbol}_{{j}}_{{k}}", unit, description, latex, j=j, k=k) for k in numbers)
            for j in range(1, self.count + 1)
        )
        name = key if key != "lengths" and key != "direction" else f"{self.name}_{key}"
        text = description.format(j="j", k="k")
        self._tables.field(name, (self.count, count), tuple(concatenate(*symbols)), unit, text)
        elements = tuple(map(str, numbers))
        self._add(key, kind, name, dimension, text, elements=elements, above=above, choices=choices)
        return symbols

    def _add(self, key: str, kind: str, field: str, dimension: str, description: str, **more: object) -> None:
        make: Callable[..., Key] = Key
        self.keys.append(make(key, kind, field, dimension, description.format(j="j", k="k"), **more))
