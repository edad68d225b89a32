"""Text from files as figures and pages show it."""

from __future__ import annotations

#: Longest label of an axis.
LONGEST = 18


def visible(text: object, longest: int | None = None) -> str:
    """Return text on one line, without characters that are not visible, such as those that turn the direction.

    Parameters
    ----------
    text : object
    longest : int or None
        Longer text is shortened.
    """
    found = "".join(c if c.isprintable() else c.encode("unicode_escape").decode("ascii") for c in str(text))
    return found if longest is None or len(found) <= longest else f"{found[: longest - 1]}\u2026"


def short(text: object, longest: int = LONGEST) -> str:
    """Return a label for an axis."""
    return visible(text, longest)
