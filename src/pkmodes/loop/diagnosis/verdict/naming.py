"""Names of causes: a class of several candidates is named as a class, never by one of its members.

Members that share a kind are named by it, "a compliance in series with the belt (clamps, gearboxes)"; the others by
their sentences.  Every headline, reason and table takes its words from here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from pkmodes.loop.diagnosis.verdict.findings import Finding, Member

#: Numbers as words; larger ones are written in digits.
NUMBER_WORDS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
#: Largest number of characters for a class in a headline; members that do not fit are counted, and listed below it.
MAX_CLASS_LENGTH = 120


def number_in_words(number: int) -> str:
    """Return a number in words."""
    return NUMBER_WORDS[number] if number < len(NUMBER_WORDS) else str(number)


def found_in_words(effects: Sequence[Finding], max_length: int | None = None) -> str:
    """Return what was found, to stand after "cause" or "causes".

    - max_length: characters of each class

    Returns "found: the gearboxes wind up", "narrowed to two: ...", or "found: ..., and one of two: ...".
    """
    if len(effects) == 1 and len(effects[0].members) > 1:
        (effect,) = effects
        number = number_in_words(len(effect.members))
        return f"narrowed to {number}: {class_in_words(effect, max_length)}{effect.assumed}"
    return f"found: {', and '.join(_effect_in_words(effect, max_length) for effect in effects)}"


def _effect_in_words(effect: Finding, max_length: int | None) -> str:
    if len(effect.members) > 1:
        return f"one of {number_in_words(len(effect.members))}: {class_in_words(effect, max_length)}{effect.assumed}"
    return f"{effect.member(effect.name).words}{effect.assumed}"


def explanation_in_words(effects: Sequence[Finding]) -> str:
    """Return what the causes explain, as a clause of a reason; a single candidate with its name."""
    if len(effects) == 1 and len(effects[0].members) > 1:
        return f"the cause is {found_in_words(effects)}"
    parts = [
        _effect_in_words(effect, None)
        if len(effect.members) > 1
        else f"{effect.member(effect.name).with_name}{effect.assumed}"
        for effect in effects
    ]
    return f"explanation: {' and '.join(parts)}"


def class_in_words(effect: Finding, max_length: int | None = None) -> str:
    """Return the members of a class as alternatives, those of one kind together.

    - max_length: characters; the members that do not fit are counted.  There is always one alternative.
    """
    parts: list[str] = []
    unlisted = len(effect.members)
    for text, size in _alternatives([effect.member(name) for name in effect.members]):
        if max_length is not None and parts and len(", or ".join([*parts, text])) > max_length:
            break
        parts.append(text)
        unlisted -= size
    if unlisted:
        parts.append(f"{number_in_words(unlisted)} {'other' if unlisted == 1 else 'others'}, listed below")
    return ", or ".join(parts)


def choice_in_words(effect: Finding) -> str:
    """Return which member of a class the corrected robot has, within a sentence."""
    return f"it has {effect.name}; the data cannot tell it from {' or '.join(effect.members[1:])}"


def _alternatives(members: Sequence[Member]) -> Iterator[tuple[str, int]]:
    """Yield the alternatives that a class offers, each with the number of its members."""
    kinds_listed: set[str] = set()
    for member in members:
        if member.kind in kinds_listed:
            continue
        members_of_kind = [sibling for sibling in members if sibling.kind and sibling.kind == member.kind]
        if len(members_of_kind) > 1:
            kinds_listed.add(member.kind)
            parts = ", ".join(
                f"implausibly {sibling.part}" if sibling.implausible else sibling.part
                for sibling in members_of_kind
            )
            yield f"{member.kind} ({parts})", len(members_of_kind)
        else:
            yield f"implausibly, {member.words}" if member.implausible else member.words, 1
