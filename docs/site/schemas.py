"""A directive that shows a JSON schema as a table: path, type and meaning."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.util.docutils import SphinxDirective

FOLDER = Path(__file__).parents[1] / "schemas"
Row = tuple[str, str, str]


def rows(schema: dict[str, Any]) -> list[Row]:
    """Return path, types and meaning of every value that a schema describes, in its order."""
    return list(_properties(schema, schema.get("$defs", {}), ""))


def _properties(part: dict[str, Any], definitions: dict[str, Any], path: str) -> Iterator[Row]:
    """Yield the rows of an object's keys, or of a list's items."""
    for inner in _variants(part, definitions):
        always = inner.get("required", ())
        for key, value in inner.get("properties", {}).items():
            yield from _value(value, definitions, f"{path}.{key}".lstrip("."), optional=key not in always)
        others, items = inner.get("additionalProperties"), inner.get("items")
        if isinstance(others, dict):
            yield from _value(others, definitions, f"{path}.<name>".lstrip("."))
        if isinstance(items, dict) and set(items) - {"type"}:
            yield from _properties(items, definitions, f"{path}[]")


def _value(
    part: dict[str, Any], definitions: dict[str, Any], path: str, *, optional: bool = False
) -> Iterator[Row]:
    """Yield the row of a value, and those of what is inside it."""
    meaning = part.get("description", "")
    if "enum" in part:
        meaning += f" One of {', '.join(map(str, part['enum']))}."
    if optional:
        meaning += " May be absent."
    kinds = [kind for inner in _variants(part, definitions) for kind in _kinds(inner, definitions)]
    yield path, " or ".join(dict.fromkeys(kinds)), meaning.strip()
    yield from _properties(part, definitions, path)


def _variants(part: dict[str, Any], definitions: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield what a value may be, with references resolved."""
    if "$ref" in part:
        yield from _variants(definitions[part["$ref"].rsplit("/", 1)[1]], definitions)
    elif "anyOf" in part:
        for inner in part["anyOf"]:
            yield from _variants(inner, definitions)
    else:
        yield part


def _kinds(part: dict[str, Any], definitions: dict[str, Any]) -> list[str]:
    """Return the types of a value; a list with the type of its items, if they have one."""
    if "enum" in part:
        return ["string"]
    kind = part["type"]
    items = [inner["type"] for inner in _variants(part.get("items", {}), definitions) if "type" in inner]
    return [f"{kind} of {items[0]}s" if len(items) == 1 else kind]


class SchemaTable(SphinxDirective):
    """``{schema} modes``: the table of ``modes.schema.json``."""

    required_arguments = 1

    def run(self) -> list[nodes.Node]:
        """Return the table."""
        path = FOLDER / f"{self.arguments[0]}.schema.json"
        self.env.note_dependency(str(path))
        schema = json.loads(path.read_text(encoding="utf-8"))
        group = nodes.tgroup(cols=3)
        group += [nodes.colspec(colwidth=width) for width in (4, 2, 6)]
        group += nodes.thead("", _row(("key", "type", "meaning"), literal=False))
        group += nodes.tbody("", *(_row(row, literal=True) for row in rows(schema)))
        return [nodes.table("", group, classes=["schema"])]


def _row(cells: Row, *, literal: bool) -> nodes.row:
    """Return a row; the first cell is code."""
    row = nodes.row()
    for number, text in enumerate(cells):
        content = nodes.literal(text, text) if literal and number == 0 else nodes.Text(text)
        row += nodes.entry("", nodes.paragraph("", "", content))
    return row


def setup(app: Sphinx) -> dict[str, bool]:
    """Register the directive."""
    app.add_directive("schema", SchemaTable)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
