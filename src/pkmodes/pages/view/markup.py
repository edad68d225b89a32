"""Text as HTML."""

from __future__ import annotations

import re
from html import escape


def breakable(name: str) -> str:
    """Return a dotted path as HTML that may be broken after a dot or an underscore."""
    return re.sub(r"([._])", r"\1<wbr>", escape(name))
