"""JSON documents: a class declares the keys of an object once, for the output and for its JSON Schema."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Annotated, Any, Self

import msgspec
from msgspec import Meta, Struct

DIALECT = "https://json-schema.org/draft/2020-12/schema"

Count = Annotated[int, Meta(ge=0)]
#: A line of a file, or the number of a mode, from 1.
Number = Annotated[int, Meta(ge=1)]
Size = Annotated[float, Meta(ge=0)]
Probability = Annotated[float, Meta(ge=0, le=1)]
Matrix = list[list[float]]
#: Settings of a measured row.
Settings = Annotated[
    dict[str, float],
    Meta(
        description="Values set by the measurements at its pose, by path, in SI units; present only where there "
        "are any."
    ),
]


class Document(Struct, frozen=True):
    """An object in JSON: the fields are its keys, in their order, and their descriptions those of the schema.

    A field with another name in JSON is declared with ``msgspec.field(name=...)``; with ``omit_defaults=True`` a
    field that has its default is left out.
    """

    @classmethod
    def of(cls, source: object, **overrides: Any) -> Self:
        """Fill the fields from the attributes of a result with the same names.

        - source: the result
        - **overrides: the fields that differ from its attributes
        """
        names = [name for name in cls.__struct_fields__ if name not in overrides]
        return cls(**{name: getattr(source, name) for name in names}, **overrides)

    def as_json(self) -> dict[str, Any]:
        """Return the object as JSON has it; numbers that are not finite are None."""
        content: dict[str, Any] = _to_json(msgspec.to_builtins(self, enc_hook=_to_builtin))
        return content


def _to_builtin(value: Any) -> Any:
    """Return a value that msgspec does not know, such as one of NumPy, as one that it does."""
    return dict(value) if isinstance(value, Mapping) else value.tolist()


def _to_json(value: Any) -> Any:
    """Replace tuples by lists, and numbers that are not finite by None."""
    if isinstance(value, dict):
        return {key: _to_json(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_to_json(entry) for entry in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


def schema_of(document: type[Document], title: str) -> dict[str, Any]:
    """Return the JSON Schema of a document."""
    name, definitions = (
        document.__name__,
        msgspec.json.schema_components([document], ref_template="#/$defs/{name}")[1],
    )
    root = {**definitions.pop(name), "title": title}
    return {"$schema": DIALECT, **root, **({"$defs": definitions} if definitions else {})}
