"""What the dotted path of a value means, in words, from the description of the robot's mechanism.

``link.length`` is the length of each linkage, ``axis.2.link.length`` that of linkage 2, and ``axis.1.origin.z`` one
component of a point.
"""

from __future__ import annotations

import re

from pkmodes.core.mechanism.described import DAMPING_RATIO, Mechanism
from pkmodes.core.robot.layout import EFFECTS, Item, items_by_path
from pkmodes.core.robot.parameter_groups import groups_by_path

#: In a description, what follows this is a formula.
FORMULA_SEPARATOR = ":"
#: The letters by which descriptions count the entries of a repeated table, and the elements within one.
ENTRY_LETTER, ELEMENT_LETTER = "j", "k"


def meaning_of(mechanism: Mechanism, path: str) -> str:
    """Return what a path of a robot file means; empty where the mechanism does not describe it.

    - path: of a declared value, or of a parameter of an effect, with or without ``effects.``
    """
    if path == DAMPING_RATIO:
        return "damping ratio of every mode"
    item = items_by_path(mechanism).get(path)
    if item is not None:
        return _meaning_of_item(item, path)
    group = groups_by_path(mechanism).get(path)
    if group is not None:
        return _with_entry_number(group.description, ENTRY_LETTER, None)
    effect, _, name = path.removeprefix(f"{EFFECTS}.").partition(".")
    if effect not in mechanism.effects:
        return ""
    parameters = {p.name: p.description for p in mechanism.effects[effect].parameters}
    return parameters.get(name, "")


def _meaning_of_item(item: Item, path: str) -> str:
    words = _with_entry_number(item.key.description.partition(FORMULA_SEPARATOR)[0], ENTRY_LETTER, item.entry)
    element = path.removeprefix(item.path).lstrip(".")
    if element.isdigit():
        return _with_entry_number(words, ELEMENT_LETTER, int(element) - 1)
    matching = [part for part in words.split(", ") if element and part.startswith(f"{element}(")]
    return matching[0] if matching else f"{words} ({element})" if element else words


def _with_entry_number(words: str, letter: str, entry: int | None) -> str:
    """Return words with the number of an entry in place of its letter, or without it for what all entries share."""
    if entry is None:
        return re.sub(rf"\bof ((?:(?!of\b)\w+ )*(?!of\b)\w+) {letter}\b", r"of each \1", words)
    return re.sub(rf"(?<= ){letter}\b|(?<=_){letter}\b", str(entry + 1), words)
