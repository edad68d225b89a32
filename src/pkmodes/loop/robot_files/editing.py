"""Edit values of a TOML text in place; comments, order and layout of everything else are preserved.

Keys are tuples of table names and array indices that end in a name or an index.  A quantity that replaces another one
keeps its notation.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from decimal import ROUND_CEILING, Context, Decimal
from typing import Any

import tomlkit
from tomlkit.exceptions import TOMLKitError
from tomlkit.items import AoT, Comment, InlineTable, Item, String, Table, Whitespace

from pkmodes.core.base.errors import OutputError
from pkmodes.core.robot.units import NUMBER, QuantityError, dimension_of, parse

Keys = tuple[str | int, ...]
SIGMA_DIGITS = 3


class TomlText:
    """A TOML text that can be edited.

    - text: valid TOML; a byte order mark and Windows line endings are kept
    - source: its file, for messages

    Raises OutputError if its layout cannot be preserved.
    """

    def __init__(self, text: str, source: str) -> None:
        self._byte_order_mark = "\ufeff" if text.startswith("\ufeff") else ""
        text = text.removeprefix("\ufeff")
        self._windows = "\r\n" in text and re.search(r"(?<!\r)\n", text) is None
        self._lacks_last_newline = not text.endswith("\n")  # a table can only be added after a line ending
        self._appended = ""
        text += self._newline if self._lacks_last_newline else ""
        try:
            self._document: Any = tomlkit.parse(text)
            is_preserved = tomlkit.dumps(self._document) == text
        except (TOMLKitError, RecursionError):
            is_preserved = False
        if not is_preserved:
            raise OutputError(
                "cannot edit the robot file and keep its layout",
                source,
                "write the entries of a repeated table one after another, and each table only once",
            )

    @property
    def _newline(self) -> str:
        return "\r\n" if self._windows else "\n"

    @property
    def text(self) -> str:
        """The text with all edits."""
        body = tomlkit.dumps(self._document)
        body = body.removesuffix(self._newline) if self._lacks_last_newline and not self._appended else body
        body += self._appended
        return self._byte_order_mark + (re.sub(r"(?<!\r)\n", "\r\n", body) if self._windows else body)

    def find(self, keys: Keys) -> Any:
        """Return the item at a place, None if there is none."""
        node = self._document
        for key in keys:
            try:
                node = node[key]
            except (KeyError, IndexError):
                return None
        return node

    def replace(self, keys: Keys, raw: str) -> None:
        """Replace an existing value by another, given as TOML text."""
        self.find(keys[:-1])[keys[-1]] = tomlkit.value(raw)

    def insert(self, keys: Keys, raw: str) -> None:
        """Add a key to a table; a missing table is added to its parent first."""
        *path, key = keys
        table = self.find(tuple(path))
        if table is not None:
            self._add_key(table, key, raw)
            return
        parent = self.find(tuple(path[:-1]))
        if isinstance(parent, InlineTable):
            new = tomlkit.inline_table()
            new[str(key)] = tomlkit.value(raw)
            parent[str(path[-1])] = new
            return
        # After the last line of the parent, before the blank lines and comments of the next table.
        last = parent
        while last.value.body and isinstance(last.value.body[-1][1], Table):
            last = last.value.body[-1][1]
        body = last.value.body
        trailing_comments = _pop_trailing_comments(body)
        # Comments up to the first blank line belong to the lines before them.
        is_blank = [isinstance(item, Whitespace) for _, item in trailing_comments]
        if any(is_blank):
            body.extend(trailing_comments[: is_blank.index(True)])
            trailing_comments = trailing_comments[is_blank.index(True) :]
        new_table = tomlkit.table()
        new_table[str(key)] = tomlkit.value(raw)
        parent.append(str(path[-1]), new_table)
        new_table.trivia.indent = self._newline
        new_table.value.body.extend(trailing_comments)

    def append_table(
        self, name: str, values: dict[str, str], comment: str, *, repeated: bool = False
    ) -> None:
        """Add a table, or an entry of a repeated one, at the end of the text, after a blank line and a comment."""
        head = f"[[{name}]]" if repeated else f"[{name}]"
        lines = ["", *([f"# {_one_line(comment)}"] if comment else []), head]
        lines += [f"{key} = {raw}" for key, raw in values.items()]
        self._appended += "\n".join(lines) + "\n"

    def rewrite(self, keys: Keys, values: dict[str, str]) -> None:
        """Give a table other values, keeping its comments; other keys are removed."""
        table = self.find(keys)
        for key in [key for key in table if key not in values]:
            table.remove(key)
        for key, raw in values.items():
            if key in table:
                table[key] = tomlkit.value(raw)
            else:
                self._add_key(table, key, raw)

    def remove_entry(self, name: str, index: int) -> None:
        """Remove an entry of a repeated table, but not the first; comments after it stay."""
        entries = self.find((name,))
        if isinstance(entries, AoT):
            body, before = entries[index].value.body, entries[index - 1].value.body
            before.extend(_pop_trailing_comments(body))
        del entries[index]

    def comment(self, keys: Keys, text: str) -> None:
        """Add a comment at the end of a value's line, after any existing comment.

        Values on one line share its comment, because TOML does not allow comments inside inline tables.
        """
        node, line = self._document, None
        for key in keys:
            node = node[key]
            if isinstance(node, Item) and not isinstance(node, Table | AoT):
                line = node
                break
        text = _one_line(text)
        if line is None or not text:
            return
        before = line.trivia.comment
        if text in before:
            return
        line.trivia.comment_ws = line.trivia.comment_ws or "  "
        line.trivia.comment = f"{before}; {text}" if before else f"# {text}"

    def is_inline(self, keys: Keys) -> bool:
        """Return whether a table is written as an inline table."""
        return isinstance(self.find(keys), InlineTable)

    @staticmethod
    def _add_key(table: Any, key: str | int, raw: str) -> None:
        body = table.value.body if isinstance(table, Table) else []
        trailing_comments = _pop_trailing_comments(body)
        table[key] = tomlkit.value(raw)
        body.extend(trailing_comments)


def _pop_trailing_comments(body: list[Any]) -> list[Any]:
    """Remove the blank lines and comments at the end of a table, and return them."""
    comments: list[Any] = []
    while body and isinstance(body[-1][1], Whitespace | Comment):
        comments.insert(0, body.pop())
    return comments


def _one_line(text: str) -> str:
    """Return text on one line and without control characters, for a comment."""
    return " ".join("".join(c if c.isprintable() else " " for c in text).split())


def sigma_text(value: float) -> str:
    """Return a standard deviation with three digits, such as 2130 and not 2.13e+03."""
    text = f"{value:.{SIGMA_DIGITS}g}"
    return f"{float(text):.0f}" if text.endswith("e+03") else text


@dataclass(frozen=True)
class ValueNotation:
    """A notation for values of one dimension.

    - scale: the written unit in SI units
    - before, after: text around the number: quotes and the unit
    """

    scale: float = 1.0
    before: str = ""
    after: str = ""

    @classmethod
    def of(cls, item: object, unit: str) -> ValueNotation:
        """Return the notation of a value of a TOML document whose SI unit is `unit`."""
        if not isinstance(item, String) or (match := NUMBER.fullmatch(item)) is None:
            return cls()  # a bare number
        dimension = dimension_of(unit)
        try:
            scale = parse(f"1 {match[2]}", dimension) if match[2] else 1.0
        except QuantityError:  # one unit alone is out of range
            return cls.si(unit)
        quote = "'" if item.as_string().startswith("'") else '"'
        return cls(scale, quote, re.sub(r"[\r\n]+", " ", item[match.end(1) :]) + quote)

    @classmethod
    def si(cls, unit: str) -> ValueNotation:
        """Return the notation for a value that is new in the document."""
        return cls() if unit == "1" else cls(1.0, '"', f' {unit.replace(" ", "*")}"')

    @property
    def beside_sigma(self) -> ValueNotation:
        """The notation of a value and of its absolute standard deviation: without per cent, for both alike."""
        return ValueNotation() if "%" in self.after else self

    def number(self, value: float, digits: int) -> str:
        """Format a value as TOML."""
        return f"{self.before}{value / self.scale + 0.0:.{digits}g}{self.after}"  # + 0.0: no minus zero

    def sigma(self, value: float) -> str:
        """Format an absolute standard deviation as TOML, rounded up; a percentage would be read as relative.

        Rounded down, it would be smaller than that in a table of correlations, which has more digits.
        """
        notation = self.beside_sigma
        digits = Decimal(repr(value / notation.scale))
        written = Context(prec=SIGMA_DIGITS, rounding=ROUND_CEILING).plus(digits)
        return f"{notation.before}{sigma_text(float(written))}{notation.after}"

    def quantity(self, value: float, sigma: float | None, digits: int) -> str:
        """Format a value as TOML, with its standard deviation if it has one."""
        if sigma is None:
            return self.number(value, digits)
        return f"{{ value = {self.beside_sigma.number(value, digits)}, sigma = {self.sigma(sigma)} }}"
