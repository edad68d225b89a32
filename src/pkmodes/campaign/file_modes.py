"""What one file gives: its modes, and what to say of it."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.campaign.found import Found


@dataclass(frozen=True, eq=False)
class FileModes:
    """The modes of a file.

    Attributes
    ----------
    modes : tuple of Found
    messages : tuple of str
        What the user should know.
    seen : frozenset of str
        Names of the sensors and, without their signs, of the forces in the file.
    """

    modes: tuple[Found, ...]
    messages: tuple[str, ...]
    seen: frozenset[str]
