"""Read a report as a script would: its numbers by their place in the JSON, its text, tables and headings."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from html.parser import HTMLParser
from pathlib import Path
from typing import Any

#: At which no line ends; in a text it is a space.
NO_BREAK_SPACE = "\u00a0"
#: Elements without an end.
VOID = {"meta", "link", "br", "img", "input", "hr", "wbr"}


@dataclass
class Element:
    """An element of a page."""

    tag: str
    attributes: dict[str, str]
    children: list[Element | str] = field(default_factory=list)

    @property
    def text(self) -> str:
        return "".join(child if isinstance(child, str) else child.text for child in self.children)

    def all(self, tag: str) -> list[Element]:
        found = []
        for child in self.children:
            if isinstance(child, Element):
                found += [child] if child.tag == tag else []
                found += child.all(tag)
        return found

    def by_id(self, name: str) -> Element:
        (found,) = [e for e in self._every() if e.attributes.get("id") == name]
        return found

    def ids(self) -> list[str]:
        return [e.attributes["id"] for e in self._every() if "id" in e.attributes]

    def _every(self) -> list[Element]:
        found = []
        for child in self.children:
            if isinstance(child, Element):
                found += [child, *child._every()]
        return found


class _Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__(convert_charrefs=True)
        self.root = Element("", {})
        self._open = [self.root]

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        element = Element(tag, {name: value or "" for name, value in attrs})
        self._open[-1].children.append(element)
        if tag not in VOID:
            self._open.append(element)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self._open[-1].children.append(Element(tag, {name: value or "" for name, value in attrs}))

    def handle_endtag(self, tag: str) -> None:
        assert self._open[-1].tag == tag, f"</{tag}> closes <{self._open[-1].tag}>"
        self._open.pop()

    def handle_data(self, data: str) -> None:
        self._open[-1].children.append(data.replace(NO_BREAK_SPACE, " "))


def source_of(page: Path) -> str:
    """Return a page as it is written, with plain spaces."""
    return page.read_text(encoding="utf-8").replace(NO_BREAK_SPACE, " ")


def read(html: str) -> Element:
    """Parse a page; an element that is not closed properly fails."""
    reader = _Reader()
    reader.feed(html)
    reader.close()
    assert reader._open == [reader.root]
    return reader.root


def powers(page: Element) -> dict[int, int]:
    """Return the power of ten that numbers share with their standard deviation, by the id of their elements."""
    found = {}
    for span in page.all("span"):
        if span.attributes.get("class") == "uncertain":
            _, _, power = span.text.partition("\u200910")
            exponent = int("".join("-0123456789"[RAISED.index(c)] for c in power)) if power else 0
            found |= {id(element): exponent for element in span.all("data")}
    return found


def at(content: Any, pointer: str) -> Any:
    """Follow a JSON pointer."""
    for part in pointer.split("/")[1:]:
        key = part.replace("~1", "/").replace("~0", "~")
        content = content[int(key)] if isinstance(content, list) else content[key]
    return content


#: Raised digits, and a number at the beginning of a text, with a power of ten.
RAISED = "\u207b\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079"
NUMBER = re.compile(f"([+\u2212]?\\d+(?:\\.(\\d+))?)(?:\u2009\u00d7\u200910([{RAISED}]+))?")


def shown(text: str) -> tuple[float, float]:
    """Return the number that a text begins with, and half a unit of its last digit."""
    found = NUMBER.match(text)
    assert found, text
    digits, decimals, power = found.groups()
    exponent = int("".join("-0123456789"[RAISED.index(c)] for c in power or "\u2070"))
    unit = 10.0 ** (exponent - len(decimals or ""))
    if not decimals:  # 730 and 2800 have two significant digits
        number = digits.lstrip("-\u2212")
        unit *= 10.0 ** min(len(number) - len(number.rstrip("0")), max(len(number) - 2, 0))
    return float(digits.replace("\u2212", "-")) * 10.0**exponent, 0.5 * unit
