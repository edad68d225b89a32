"""Checks of a TOML file before it is parsed."""

from __future__ import annotations

import re

#: Maximum number of parts of a key: the memory for a key grows with the square of their number.
MAX_KEY_PARTS = 100
#: Patterns of a part of a key, and of a key with more parts than that.
KEY_PART = r"""(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')"""
LONG_KEY = re.compile(rf"(?<![\w-]){KEY_PART}(?:[ \t]*+\.[ \t]*+{KEY_PART}){{{MAX_KEY_PARTS}}}")


def line_of_long_key(text: str) -> int | None:
    """Return the number of the line of a key with too many parts, None if there is none.

    - text: of a TOML file
    """
    match = LONG_KEY.search(text)
    return None if match is None else text.count("\n", 0, match.start()) + 1
