"""Relations that apply to one mechanism only: those of the module of its name in `pkmodes.codegen.mechanisms`."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import import_module
from importlib.util import find_spec

from pkmodes.codegen.checking.relations import Relation, State

PLACE = "pkmodes.codegen.mechanisms"


def own_relations(at: State) -> Iterator[Relation]:
    """Yield the relations at one pose that apply to this mechanism only."""
    place = f"{PLACE}.{at.mechanism.name}"
    if find_spec(place) is not None:
        yield from import_module(place).relations(at)
