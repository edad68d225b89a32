"""What a check of a sentence answers."""

from __future__ import annotations

from collections.abc import Callable

from working_area import Area

#: Whether the sentence holds, and the number that shows it.
Answer = tuple[bool, str]
Check = Callable[[Area], Answer]


def percent(value: float) -> str:
    """Format a ratio."""
    return f"{100 * value:.0f} %"
