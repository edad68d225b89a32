"""What the motors do: they turn freely, or position loops far stiffer than the machine hold them."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Annotated, Literal

from msgspec import Meta

from pkmodes.core.base.arguments import Constraint, alternatives, check_argument, one_of

FREE, HELD = DRIVES = "free", "held"
#: The same in a JSON document.
Drives = Annotated[Literal["free", "held"], Meta(description="What the motors do: turn freely, or are held.")]

_FREE_OR_HELD = Constraint(alternatives(f'"{word}"' for word in DRIVES), one_of(DRIVES).holds)


def other_drives(drives: str) -> str:
    """Return "held" for "free", and "free" for "held"."""
    return HELD if drives == FREE else FREE


def motors_text(drives: Iterable[str | None]) -> str:
    """Return what the motors do in one or several measurements, in words: motors free or held."""
    states = set(drives)
    return f"motors {' or '.join(word for word in DRIVES if word in states)}"


def motors_instruction(drives: Iterable[str | None]) -> str:
    """Return how to set the motors for measurements still to be made, in words.

    Shafts are clamped: position loops hold the motors of many machines only as springs do.
    """
    return (
        motors_text(drives)
        .replace(f"motors {HELD}", "motor shafts clamped")
        .replace(HELD, "their shafts clamped")
    )


def checked_drives(drives: str) -> str:
    """Check the state of the motors that the caller gives.

    Raises PkmodesError if it is neither "free" nor "held".
    """
    remedy = "say whether the motors turn freely or position loops hold them"
    check_argument(drives, _FREE_OR_HELD, "drives", remedy)
    return drives
