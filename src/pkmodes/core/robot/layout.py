"""Layout of a robot file: its keys with their dotted paths, and the fields of the generated model they map to.

The layout follows from the description of the mechanism.  Entries of a repeated table count from 1 in paths.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from functools import cache, cached_property

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.robot.units import DIMENSIONS
from pkmodes_description import Key, Table

#: A number among the generated parameters or effects: its field, and its index in the field.
Slot = tuple[str, tuple[int, ...]]

EFFECTS = "effects"
XYZ = ("x", "y", "z")
#: The vector that every robot file has besides its tables.
GRAVITY = Key(
    name="gravity",
    kind="vector",
    field="gravity",
    dimension="acceleration",
    description="gravitational acceleration in the base frame",
    elements=XYZ,
    signed=True,
)
#: Kinds of keys whose values are quantities; other keys are choices, without unit or standard deviation.
QUANTITY_KINDS = ("quantity", "vector", "pair")


@dataclass(frozen=True)
class Number:
    """A quantity of a robot file.

    - path: such as ``platform.mass``, ``axis.2.belt.width``, ``axis.1.origin.x``
    - unit: SI unit
    - slot: None for a value that the entries of a repeated table share: it is stored in the slots of the entries; and
      for a value that changes neither M nor K, such as a damping ratio
    - key_path: its keys in the parsed file
    """

    path: str
    unit: str
    slot: Slot | None
    key_path: tuple[str | int, ...]


@dataclass(frozen=True)
class Item:
    """A key of the robot file in one of its tables.

    - path: such as ``gravity``, ``belt.width``, ``axis.2.belt.width``, ``axis.1.direction``
    - index: index of its numbers in their field; None for a value that the entries of a repeated table share
    - entry: index of the entry in the repeated table, from 0
    - shared: path of the shared value that is used if this one is not given; empty for none
    - key_path: its keys in the parsed file
    """

    path: str
    key: Key
    index: tuple[int, ...] | None
    entry: int | None
    shared: str
    key_path: tuple[str | int, ...]

    @cached_property
    def numbers(self) -> tuple[Number, ...]:
        """The item's quantities; empty for a choice."""
        unit = DIMENSIONS[self.key.dimension][0]
        if self.key.kind == "quantity":
            return (Number(self.path, unit, self._slot(()), self.key_path),)
        if self.key.kind not in QUANTITY_KINDS:
            return ()
        return tuple(
            Number(f"{self.path}.{name}", unit, self._slot((i,)), (*self.key_path, i))
            for i, name in enumerate(self.key.elements)
        )

    def _slot(self, element: tuple[int, ...]) -> Slot | None:
        if not self.key.field:
            return (self.key.effect, ()) if self.key.effect else None
        return None if self.index is None else (self.key.field, (*self.index, *element))


@cache
def items(mechanism: Mechanism) -> tuple[Item, ...]:
    """Return every key that a robot file may have, in the order of the file, without those of effects."""
    return tuple(_items(mechanism))


def _items(mechanism: Mechanism) -> Iterator[Item]:
    yield Item(GRAVITY.name, GRAVITY, GRAVITY.index, None, "", (GRAVITY.name,))
    for table in mechanism.tables:
        if table.count:
            for j in range(table.count):
                yield from _entry(mechanism, table, j)
        else:
            for key in table.keys:
                index = None if table.shared_by else key.index
                yield Item(f"{table.name}.{key.name}", key, index, None, "", (table.name, key.name))


def _entry(mechanism: Mechanism, table: Table, j: int) -> Iterator[Item]:
    """Yield the keys of one entry of a repeated table: its own keys, and overrides of shared ones."""
    name = f"{table.name}.{j + 1}"
    for key in table.keys:
        yield Item(f"{name}.{key.name}", key, (j, *key.index), j, "", (table.name, j, key.name))
    for shared_table in mechanism.tables:
        if shared_table.shared_by == table.name:
            for key in shared_table.keys:
                shared = f"{shared_table.name}.{key.name}"
                key_path = (table.name, j, shared_table.name, key.name)
                yield Item(f"{name}.{shared}", key, (j, *key.index), j, shared, key_path)


@cache
def items_by_path(mechanism: Mechanism) -> dict[str, Item]:
    """Return the keys by their own paths and by the paths of their quantities."""
    items_at = {item.path: item for item in items(mechanism)}
    return items_at | {number.path: item for item in items(mechanism) for number in item.numbers}


@cache
def overrides_by_path(mechanism: Mechanism) -> dict[str, tuple[Item, ...]]:
    """Return, by the path of a shared value, the keys that may override it, and else take it."""
    overrides: dict[str, tuple[Item, ...]] = {}
    for item in items(mechanism):
        if item.shared:
            overrides[item.shared] = (*overrides.get(item.shared, ()), item)
    return overrides


@cache
def dependents(mechanism: Mechanism, path: str) -> tuple[Item, ...]:
    """Return the key at a path, and keys that may depend on it: overrides of a shared value, the middle of a pair."""
    shared = (items_by_path(mechanism)[path], *overrides_by_path(mechanism).get(path, ()))
    pairs = {item.path for item in shared}
    return (*shared, *(item for item in items(mechanism) if item.key.middle_of in pairs))


@cache
def table_sources(mechanism: Mechanism) -> dict[str, str]:
    """Return, by the path of an effect parameter, the path of the table value it comes from."""
    return {f"{EFFECTS}.{item.key.effect}": item.path for item in items(mechanism) if item.key.effect}


@cache
def effect_parameters(mechanism: Mechanism) -> dict[str, str]:
    """Return the SI units of the parameters of all effects that apply, by path."""
    return {
        f"{EFFECTS}.{effect.name}.{parameter.name}": parameter.unit
        for effect in mechanism.effects.values()
        for parameter in effect.parameters
    }
