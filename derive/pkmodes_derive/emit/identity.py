"""The identity of generated code: name, version, digest, and the limits that the robot file declares."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from pkmodes_derive.machine import Machine
from pkmodes_derive.tables import unit_of

#: Hexadecimal digits of a digest; 64 bits tell the models of a machine apart.
DIGEST_DIGITS = 16
#: Names that are string literals of any language as they stand; the schema of robot files allows no others.
LITERAL_NAME = re.compile(r"[A-Za-z0-9][A-Za-z0-9 ._+-]*")


@dataclass(frozen=True)
class Limit:
    """One end of a travel, as the robot file declares it.

    Attributes
    ----------
    path : str
        In the robot file: ``axis.1.limits.min``.
    value : float
        In SI units.
    """

    path: str
    value: float
    unit: str
    description: str

    @property
    def name(self) -> str:
        """The path as the name of a constant."""
        return self.path.replace(".", "_").upper()


@dataclass(frozen=True)
class Identity:
    """The identity of a product, as stated in its code.

    Attributes
    ----------
    name : str
        Name of the robot or the mechanism.
    version : str
        Version of the generator.
    digest : str
        `digest` of its C source.
    limits : tuple of Limit
        None for a model whose limits are parameters.
    """

    name: str = ""
    version: str = ""
    digest: str = ""
    limits: tuple[Limit, ...] = ()


def literal(name: str, identifier: str) -> str:
    """Return a name that can stand in a string literal: `identifier`, an identifier, if the name cannot."""
    return name if LITERAL_NAME.fullmatch(name) else identifier


def digest(source: str) -> str:
    """Return the digest of a C source from its first directive on: comments before it do not count.

    All that the model computes is in its C source.  If a value of the robot is folded into others, such as one of two
    factors of a product, a change of it may leave the source unchanged.
    """
    code = source[source.index('#include "') :]
    return hashlib.sha256(code.encode("utf-8")).hexdigest()[:DIGEST_DIGITS]


def limits(machine: Machine, fields: Mapping[str, Any]) -> tuple[Limit, ...]:
    """Return the limits of a robot: the pairs of its file, if a condition on the pose refers to limits.

    Parameters
    ----------
    machine : Machine
        That its mechanism declares.
    fields : mapping of str to nested lists
        Its parameters in SI units.
    """
    if not any(margin.code == "limits" for margin in machine.margins):
        return ()
    found = []
    for table in machine.tables.described():
        for key in (key for key in table.keys if key.kind == "pair"):
            for path, entry_index in _places(table.name, table.count):
                values: Any = fields[key.field]
                for i in (*entry_index, *key.index):
                    values = values[i]
                found += [
                    Limit(f"{path}.{key.name}.{end}", float(value), unit_of(key.dimension), key.description)
                    for end, value in zip(("min", "max"), values, strict=True)
                ]
    return tuple(found)


def _places(table: str, count: int) -> list[tuple[str, tuple[int, ...]]]:
    """Return the path and the index of each entry of a table."""
    return [(f"{table}.{i + 1}", (i,)) for i in range(count)] if count else [(table, ())]
