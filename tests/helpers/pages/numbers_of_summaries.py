"""The numbers in the summary of a page, each with its place in the JSON: none may be of the page's own making.

A number is that of a JSON value if it equals the value, or the value in another unit, to half of its last digit, or
stands in a sentence of the JSON.  Three more kinds are allowed: the difference of two values of the JSON that the
same sentence gives, the share that one of them is of a value of the JSON, and how many entries a list of the JSON
has, or all lists of that name.  Two numbers that are equal by chance are not told apart.
"""

from __future__ import annotations

import itertools
import re
from collections import Counter
from collections.abc import Iterator
from typing import Any, NamedTuple

from helpers.pages.page_reading import RAISED, Element, at

#: What turns SI units and shares into the units of pages: per cent, milli, micro, and degrees.
SCALES = (1.0, 1e2, 1e3, 1e6, 1e-3, 1e-2, 180.0 / 3.141592653589793, 1.0 / 60.0)
THIN = "\u2009\u202f\u00a0"
NUMBER = re.compile(
    rf"(?<![\w.^/\u2080-\u2089])[+\u2212-]?(\d{{1,3}}(?:[\u2009\u202f]\d{{3}})+|\d+)(\.\d+)?"
    rf"(?:[{THIN} ]?\u00d7[{THIN} ]?10([{RAISED}]+))?(?![\w^\u00b2\u00b3])(?!\.\d)"
)


class Number(NamedTuple):
    """A number in a sentence: as written, its value, and half a unit of its last digit."""

    text: str
    value: float
    half: float


def leaves(content: Any, pointer: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the values of a JSON document with their pointers, and of each list its length."""
    if isinstance(content, dict):
        for key, value in content.items():
            yield from leaves(value, f"{pointer}/{key.replace('~', '~0').replace('/', '~1')}")
    elif isinstance(content, list):
        yield f"{pointer}/length", len(content)
        for i, value in enumerate(content):
            yield from leaves(value, f"{pointer}/{i}")
    else:
        yield pointer, content


def numbers_in(sentence: str) -> list[Number]:
    """Return the numbers in a sentence."""
    numbers = []
    for found in NUMBER.finditer(sentence):
        whole, decimals, power = found.groups()
        exponent = int("".join("-0123456789"[RAISED.index(c)] for c in power)) if power else 0
        size = float(re.sub(r"\D", "", whole) + (decimals or "")) * 10.0**exponent
        half = 0.5 * 10.0 ** (exponent - max(len(decimals or "") - 1, 0))
        if size >= 1000.0 and not decimals:  # limits are rounded down to whole hundreds
            half = 10.0 ** (len(whole) - len(whole.rstrip("0")))
        numbers.append(Number(found.group(), -size if found.group()[0] in "-\u2212" else size, half))
    return numbers


def sentences(page: Element) -> list[str]:
    """Return the sentences of a page's summary: headline, action, reason, tiles and notes."""
    summary = page.by_id("summary")
    tags = [element for tag in ("h2", "dd", "p", "li") for element in summary.all(tag)]
    return [" ".join(element.text.split(" ")) for element in tags]


def pointers(sentence: str, content: Any) -> dict[str, list[str]]:
    """Return the places in the JSON of each number of a sentence; no place for one that has none."""
    values = list(leaves(content))
    sentence = sentence.replace("\u00b0", " deg").replace("chi\u00b2", "chi2")  # as in the JSON
    for text in (v for _, v in values if isinstance(v, str) and len(v) >= 60):
        sentence = re.sub(re.escape(text.rstrip(".")), " ", sentence, flags=re.IGNORECASE)
    # Labels and names of the JSON are no numbers: P4, k_2, model.csv.
    for label in sorted(
        {v for _, v in values if isinstance(v, str) and v in sentence and len(v) < 60}, key=len
    ):
        if re.search(r"\d", label):
            sentence = re.sub(rf"(?<!\w){re.escape(label)}(?!\w)", " ", sentence)
    numeric = [
        (pointer, float(v)) for pointer, v in values if isinstance(v, int | float) and not isinstance(v, bool)
    ]
    totals = Counter[str]()
    for pointer, value in numeric:
        if pointer.endswith("/length"):
            totals[re.sub(r"/\d+(?=/)", "/*", pointer)] += int(value)
    numeric += [(pointer, float(total)) for pointer, total in totals.items()]
    places: dict[str, list[str]] = {}
    found = numbers_in(sentence)
    for number in found:
        places[number.text] = [
            pointer
            for pointer, value in numeric
            if any(abs(abs(scale * value) - abs(number.value)) <= 1.001 * number.half for scale in SCALES)
        ]
    for number in found:
        if not places[number.text]:
            with_places = [other for other in found if places[other.text]]
            for other, (pointer, value) in itertools.product(with_places, numeric):  # a share of a count
                if value > 0.0 and abs(100.0 * other.value / value - number.value) <= 1.001 * number.half:
                    places[number.text] = [f"{other.text} of {pointer}"]
            for first, second in itertools.combinations(with_places, 2):
                tolerance = first.half + second.half + number.half
                for value in (
                    first.value - second.value,
                    100.0 * (first.value / (second.value or 1.0) - 1.0),
                ):
                    if abs(abs(value) - abs(number.value)) <= tolerance:
                        places[number.text] = [f"{first.text} and {second.text}"]
    return places


def without_place(page: Element, content: Any) -> list[str]:
    """Return the numbers of a summary that no value of the JSON gives, each with its sentence."""
    wrong = []
    for element in page.by_id("summary").all("data"):  # tiles, which say where they are
        if pointer := element.attributes.get("data-at"):
            assert float(element.attributes["value"]) == at(content, pointer), pointer
    for sentence in sentences(page):
        wrong += [f"{text}: {sentence}" for text, places in pointers(sentence, content).items() if not places]
    return wrong
