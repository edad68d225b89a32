"""Names of causes: a class of several candidates is named as a class, never by one of its members.

Members that share a kind are named by it, "a compliance in series with the belt (clamps, gearboxes)"; the others by
their sentences.  Every headline, reason and table takes its words from here.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from pkmodes.loop.diagnosis.verdict.findings import Finding, Member

#: Numbers as words; larger ones are written in digits.
NUMBERS = ("none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten")
#: Largest number of characters for a class in a headline; members that do not fit are counted, and listed below it.
LONGEST = 120


def count(number: int) -> str:
    """Return a number in words."""
    return NUMBERS[number] if number < len(NUMBERS) else str(number)


def found_in_words(effects: Sequence[Finding], longest: int | None = None) -> str:
    """Return what was found, to stand after "cause" or "causes".

    - longest: characters of each class

    Returns "found: the gearboxes wind up", "narrowed to two: ...", or "found: ..., and one of two: ...".
    """
    if len(effects) == 1 and len(effects[0].members) > 1:
        (effect,) = effects
        return f"narrowed to {count(len(effect.members))}: {of_class(effect, longest)}{effect.assumed}"
    return f"found: {', and '.join(_of_effect(effect, longest) for effect in effects)}"


def _of_effect(effect: Finding, longest: int | None) -> str:
    if len(effect.members) > 1:
        return f"one of {count(len(effect.members))}: {of_class(effect, longest)}{effect.assumed}"
    return f"{effect.member(effect.name).words}{effect.assumed}"


def explained(effects: Sequence[Finding]) -> str:
    """Return what the causes explain, as a clause of a reason; a single candidate with its name."""
    if len(effects) == 1 and len(effects[0].members) > 1:
        return f"the cause is {found_in_words(effects)}"
    parts = [
        _of_effect(effect, None)
        if len(effect.members) > 1
        else f"{effect.member(effect.name).with_name}{effect.assumed}"
        for effect in effects
    ]
    return f"explanation: {' and '.join(parts)}"


def of_class(effect: Finding, longest: int | None = None) -> str:
    """Return the members of a class as alternatives, those of one kind together.

    - longest: characters; the members that do not fit are counted.  There is always one alternative.
    """
    parts: list[str] = []
    unlisted = len(effect.members)
    for text, size in _alternatives([effect.member(name) for name in effect.members]):
        if longest is not None and parts and len(", or ".join([*parts, text])) > longest:
            break
        parts.append(text)
        unlisted -= size
    if unlisted:
        parts.append(f"{count(unlisted)} {'other' if unlisted == 1 else 'others'}, listed below")
    return ", or ".join(parts)


def chosen(effect: Finding) -> str:
    """Return which member of a class the corrected robot has, within a sentence."""
    return f"it has {effect.name}; the data cannot tell it from {' or '.join(effect.members[1:])}"


def _alternatives(members: Sequence[Member]) -> Iterator[tuple[str, int]]:
    """Yield the alternatives that a class offers, each with the number of its members."""
    done: set[str] = set()
    for member in members:
        if member.kind in done:
            continue
        same = [sibling for sibling in members if sibling.kind and sibling.kind == member.kind]
        if len(same) > 1:
            done.add(member.kind)
            parts = ", ".join(
                f"implausibly {sibling.part}" if sibling.implausible else sibling.part for sibling in same
            )
            yield f"{member.kind} ({parts})", len(same)
        else:
            yield f"implausibly, {member.words}" if member.implausible else member.words, 1
