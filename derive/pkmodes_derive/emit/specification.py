"""A robot as the generator sees it: plain values, so that the derivation knows nothing of the runtime."""

from __future__ import annotations

import keyword
import re
from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Specification:
    """A robot as the generator sees it; the runtime makes it from a robot file.

    Attributes
    ----------
    name : str
        The robot's name; the files are called after it.
    mechanism : str
        Which mechanism it is.
    robot_file : str
        The robot file, relative to the folder of the product, with forward slashes.
    fields : mapping of str to nested lists
        The parameter fields in SI units.
    values : mapping of str to float
        What the robot file says, by dotted path, in SI units: recorded so that a change can be named.
    """

    name: str
    mechanism: str
    robot_file: str
    fields: Mapping[str, object]
    values: Mapping[str, object]

    @property
    def identifier(self) -> str:
        """The name as an identifier of Python and C, in lower case."""
        text = re.sub(r"\W+", "_", self.name.lower(), flags=re.ASCII).strip("_") or "robot"
        return f"robot_{text}" if text[0].isdigit() or keyword.iskeyword(text) else text
