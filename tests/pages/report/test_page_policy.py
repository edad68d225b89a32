"""Only what pkmodes wrote into a page runs there."""

from __future__ import annotations

import re
from base64 import b64encode
from hashlib import sha256

from pkmodes.core.support.page_policy import with_policy

PAGE = """<!doctype html>
<head>
<meta charset="utf-8">
</head>
<script>{}</script>
<script type="application/json">1</script>"""


def rules(page: str) -> dict[str, list[str]]:
    found = re.search(r'http-equiv="Content-Security-Policy" content="([^"]*)"', page)
    assert found
    parts = [rule.split() for rule in found.group(1).split(";")]
    return {name: values for name, *values in parts}


def test_a_program_is_allowed_by_its_digest_and_data_need_none() -> None:
    program = 'const a = "\u2212";\nfetch(a);\n'
    expected = b64encode(sha256(program.encode("utf-8")).digest()).decode("ascii")
    assert rules(with_policy(PAGE.format(program)))["script-src"] == [f"'sha256-{expected}'"]


def test_a_page_without_programs_runs_none() -> None:
    assert rules(with_policy('<meta charset="utf-8">\n<p>text</p>'))["script-src"] == ["'none'"]


def test_nothing_is_fetched() -> None:
    found = rules(with_policy(PAGE.format("1")))
    assert found["default-src"] == ["'none'"]
    assert not any(
        ":" in value and value not in ("data:", "blob:") for values in found.values() for value in values
    )


def test_the_policy_comes_before_everything_that_it_governs() -> None:
    page = with_policy(PAGE.format("1"))
    assert page.index("Content-Security-Policy") < page.index("<script>")
