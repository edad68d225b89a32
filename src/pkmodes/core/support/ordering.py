"""The order of labels in tables and figures, and lists of them in sentences.

Labels are in the order in which people count: P2 before P10, and -0.5 mm before +0.0 mm.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Sequence

#: A number with its unit, as the whole of a label; a number within one.
QUANTITY = re.compile(r"\s*([+\-\u2212]?\d+(?:\.\d+)?)\s*(\D*?)\s*")
NUMBER = re.compile(r"(\d+(?:\.\d+)?)")


def natural_order(labels: Sequence[str]) -> list[int]:
    """Return the places of labels in their natural order.

    Labels that are numbers of one unit are in the order of these numbers, and others in that of the numbers within
    them.  If any has no number, all stay in the order given, which is that of their file.
    """
    indices = list(range(len(labels)))
    matches = [QUANTITY.fullmatch(label) for label in labels]
    quantities = [(match[1], match[2]) for match in matches if match is not None]
    if len(quantities) == len(labels) and len({unit for _, unit in quantities}) == 1:
        values = [float(digits.replace("\u2212", "-")) for digits, _ in quantities]
        return sorted(indices, key=lambda i: values[i])
    if not all(NUMBER.search(label) for label in labels):
        return indices
    return sorted(indices, key=lambda i: _key(labels[i]))


def sorted_labels(labels: Iterable[str]) -> list[str]:
    """Return labels in their natural order."""
    sequence = list(labels)
    return [sequence[i] for i in natural_order(sequence)]


def listed(names: Sequence[str], limit: int, separator: str = ", ", before_surplus: str = " and ") -> str:
    """Return the first names in a sentence, and how many more there are.

    - separator, before_surplus: what stands between two names, and before the number of the others
    """
    surplus = len(names) - limit
    return separator.join(names[:limit]) + (f"{before_surplus}{surplus} more" if surplus > 0 else "")


def joined(names: Collection[str], conjunction: str = "and") -> str:
    """Return all names in a sentence: "a, b and c"; empty for none.

    - conjunction: the word before the last name
    """
    *leading, last = [*names] or [""]
    return f"{', '.join(leading)} {conjunction} {last}" if leading else last


def _key(label: str) -> list[tuple[float, str]]:
    """Return the texts and numbers of a label alternately; numbers are ordered by value."""
    parts = NUMBER.split(label)
    return [(float(part), "") if k % 2 else (-1.0, part.casefold()) for k, part in enumerate(parts)]
