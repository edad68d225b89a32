"""Functions to be emitted, with arguments, outputs and the definitions they may use.

This is the interface between derivation and emission.  A `Function` holds SymPy expressions and their
documentation, independent of any programming language.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product
from math import prod

from sympy import Basic, Expr, Symbol

from pkmodes_derive.vocabulary import Field, Vocabulary
from pkmodes_description import Margin


def mirrored(index: tuple[int, ...]) -> tuple[int, ...]:
    """Return the index with its last two entries swapped."""
    *first, row, column = index
    return (*first, column, row)


@dataclass(frozen=True)
class Argument:
    """An array argument: `symbols` are its entries, in order."""

    name: str
    symbols: tuple[Symbol, ...]
    unit: str
    description: str
    scalar: bool = False


@dataclass(frozen=True)
class Output:
    """An array result in row-major order; `shape` is ``()`` for a scalar.

    A `listed` result is a long vector without structural zeros, written as one list.
    """

    name: str
    shape: tuple[int, ...]
    entries: tuple[Expr, ...]
    unit: str
    description: str
    listed: bool = False

    def __post_init__(self) -> None:
        if prod(self.shape) != len(self.entries):
            raise ValueError(f"output {self.name}: {len(self.entries)} entries for shape {self.shape}")

    @property
    def indices(self) -> list[tuple[int, ...]]:
        """Index of each entry, in order."""
        return list(product(*(range(extent) for extent in self.shape)))

    @property
    def symmetric(self) -> bool:
        """Whether swapping the last two indices changes no entry: a symmetric matrix, or a stack of them."""
        if len(self.shape) < 2 or self.shape[-1] != self.shape[-2]:
            return False
        entry = dict(zip(self.indices, self.entries, strict=True))
        return all(entry[mirrored(index)] == value for index, value in entry.items())


@dataclass(frozen=True)
class Function:
    """One function of the generated code.

    Attributes
    ----------
    name : str
        Its name in every language.
    summary, details : str
        First line and further sentences of the docstring.
    source : str
        The equations it evaluates, in the paper's numbering.
    arguments, outputs : tuple
        Inputs besides the robot's parameters, and results.
    definitions : mapping
        Named intermediate values in evaluation order; only those needed are emitted.
    in_c : bool
        Whether it is also emitted as C, for controllers; parameter derivatives are for estimation on a computer.
    """

    name: str
    summary: str
    source: str
    arguments: tuple[Argument, ...]
    outputs: tuple[Output, ...]
    definitions: Mapping[Symbol, Expr] = field(repr=False)
    details: str = ""
    in_c: bool = True


@dataclass(frozen=True)
class Relation:
    """A result that is derived and shown but not emitted, such as a second route to an emitted one.

    Attributes
    ----------
    latex : str
        Left-hand side, typeset.
    expression : sympy.Expr or sympy.Matrix
        Right-hand side.
    description : str
        A sentence that cites its equation.
    """

    latex: str
    expression: Basic
    description: str


@dataclass(frozen=True)
class FieldGroup:
    """Parameters that are passed together.

    Attributes
    ----------
    name, argument : str
        Name of the type and of the argument, in every language.
    fields : tuple of Field
        In order.
    null : float or None
        Default value of every field, None for no default.
    declared : bool
        Whether the type is declared with the functions; if not, the base model declares it.
    """

    name: str
    argument: str
    fields: tuple[Field, ...]
    null: float | None = None
    declared: bool = True


@dataclass(frozen=True)
class HeldMotors:
    """A robot in use, whose motors are held, or are on springs whose other ends are held.

    Attributes
    ----------
    coordinates : tuple of str
        Those that remain and have inertia, in order.
    functions : tuple of Function
        The function of its matrices; none if its modes cannot be computed.
    dissipates : bool
        Whether the matrices include damping.
    ratio : float
        Damping ratio of every mode, in addition to it.
    springs : str
        The effect that is these springs; empty where the motors are held.
    reason : str
        Why its modes cannot be computed, as a sentence without a full stop; empty if they can.
    """

    coordinates: tuple[str, ...]
    functions: tuple[Function, ...] = field(repr=False, default=())
    dissipates: bool = False
    ratio: float = 0.0
    springs: str = ""
    reason: str = ""

    @property
    def motors(self) -> str:
        """What the motors do, as words that follow "motors"."""
        return f"on their {self.springs.replace('_', ' ')}" if self.springs else "held"


@dataclass(frozen=True)
class Model:
    """A derived mechanism, ready for emission.

    Attributes
    ----------
    mechanism : str
        Name as in the robot file.
    coordinates : tuple of (name, unit)
        Generalised coordinates in order.
    vocabulary : Vocabulary
        Unit and description of every symbol.
    groups : tuple of FieldGroup
        The parameters as arrays.
    functions : tuple of Function
        In reading order.
    relations : tuple of Relation
        Derived, shown in the documentation, not emitted.
    rigid_modes : int or None
        Number of motions that strain no elastic part, at any regular pose and for any parameters; None if it varies.
    constants : tuple of (comment, name, value)
        Constants that programs need, as Python literals.
    conditions : tuple of Margin
        Conditions on a pose; none for a model whose poses are checked with another one.
    notes : tuple of str
        Notes for users of the code, one paragraph each.
    held : HeldMotors or None
        The robot with held motors, whose functions are among those of the model; None for a whole mechanism.
    """

    mechanism: str
    coordinates: tuple[tuple[str, str], ...]
    vocabulary: Vocabulary = field(repr=False)
    groups: tuple[FieldGroup, ...] = field(repr=False)
    functions: tuple[Function, ...] = field(repr=False)
    relations: tuple[Relation, ...] = field(repr=False, default=())
    rigid_modes: int | None = None
    constants: tuple[tuple[str, str, tuple[object, ...]], ...] = field(repr=False, default=())
    notes: tuple[str, ...] = field(repr=False, default=())
    conditions: tuple[Margin, ...] = field(repr=False, default=())
    held: HeldMotors | None = field(repr=False, default=None)

    @property
    def fields(self) -> tuple[Field, ...]:
        """Fields of all groups."""
        return tuple(f for group in self.groups for f in group.fields)
