"""A content security policy for pages that need no network: what a page may run is what pkmodes wrote into it."""

from __future__ import annotations

import re
from base64 import b64encode
from hashlib import sha256

#: Programs of a page are elements without attributes; data have a type, and text from files is escaped.
SCRIPT = re.compile(r"<script>(.*?)</script>", re.DOTALL)
CHARSET_LINE = '<meta charset="utf-8">\n'


def with_policy(page: str) -> str:
    """Return a finished page with the policy in its head.

    Only the programs in the page run, known by their SHA-256; images come from the page itself, and nothing is
    fetched or sent.

    - page: HTML with ``<meta charset="utf-8">`` on a line, and each program in a ``<script>`` without attributes

    The result is the same for the same page.

    References
    ----------
    W3C, Content Security Policy Level 3, section 2.3.1.
    """
    programs = dict.fromkeys(
        f"'sha256-{b64encode(sha256(text.encode()).digest()).decode()}'" for text in SCRIPT.findall(page)
    )
    rules = {
        "default-src": "'none'",
        "script-src": " ".join(programs) or "'none'",
        # Figures and tables have style attributes, which no digest can allow.
        "style-src": "'unsafe-inline'",
        "img-src": "data: blob:",
        "base-uri": "'none'",
        "form-action": "'none'",
    }
    policy = "; ".join(f"{name} {value}" for name, value in rules.items())
    return page.replace(
        CHARSET_LINE, f'{CHARSET_LINE}<meta http-equiv="Content-Security-Policy" content="{policy}">\n', 1
    )
