"""A member of a class: how it is named, and whether its value is one that such a part can have."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Member:
    """A candidate of a class.

    Attributes
    ----------
    sentence, kind, part : str
        As of its candidate.
    implausible : str
        Why its value is not one that such a part can have; empty if it is.
    """

    name: str
    sentence: str = ""
    kind: str = ""
    part: str = ""
    implausible: str = ""

    @property
    def words(self) -> str:
        """What it means, or its name where nobody said."""
        return self.sentence or self.name

    @property
    def with_name(self) -> str:
        """What it means, with its name."""
        return f"{self.sentence} ({self.name})" if self.sentence else self.name
