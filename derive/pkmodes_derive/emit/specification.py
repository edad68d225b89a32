"""A robot as input of the generator: plain values, so the derivation does not depend on the runtime."""

from __future__ import annotations

import keyword
import re
import sys
from collections.abc import Mapping
from dataclasses import dataclass

from pkmodes_derive.reserved_words import C_KEYWORDS


@dataclass(frozen=True)
class Specification:
    """A robot as input of the generator; the runtime makes it from a robot file.

    Attributes
    ----------
    name : str
        The robot's name; the files are named after it.
    mechanism : str
        Name of its mechanism.
    robot_file : str
        The robot file, relative to the folder of the product, with forward slashes.
    fields : mapping of str to nested lists
        The parameter fields in SI units.
    values : mapping of str to float
        Values of the robot file by dotted path, in SI units, recorded so that a change can be named.
    effects : tuple of str
        Names of the active effects; their parameters are among the fields, as ``<effect>_<parameter>``.
    damping_ratio : float
        Damping ratio of every vibration mode, in addition to what effects dissipate.
    definition : str
        Path of a user-defined mechanism, its file or the folder of its code, relative to the product; empty for a
        mechanism of pkmodes.
    springs : str
        The active effect through which the motors hang on springs in use; empty where they are held.
    """

    name: str
    mechanism: str
    robot_file: str
    fields: Mapping[str, object]
    values: Mapping[str, object]
    effects: tuple[str, ...] = ()
    damping_ratio: float = 0.0
    definition: str = ""
    springs: str = ""

    @property
    def identifier(self) -> str:
        """The name as an identifier of Python and C, in lower case."""
        text = re.sub(r"\W+", "_", self.name.lower(), flags=re.ASCII).strip("_") or "robot"
        is_reserved = (
            keyword.iskeyword(text)
            or text in C_KEYWORDS
            or text in sys.stdlib_module_names
            or text == "numpy"
        )
        return f"robot_{text}" if text[0].isdigit() or is_reserved else text
