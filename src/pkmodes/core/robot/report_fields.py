"""The table ``[report]`` of a robot file or a campaign file: fields for the header of every report.

Nothing is computed from it, and generated code does not depend on it.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from pkmodes.core.base.errors import nearest_name, printable, shown
from pkmodes.core.robot import schema

REPORT = "report"
#: Keys in the order of the header, with their titles there.
TITLES = {"customer": "Customer", "machine": "Machine", "serial": "Serial number", "operator": "Operator"}
MAX_TEXT_LENGTH = 120


def read_report(raw: Any, problem: Callable[[str, str, str], None]) -> dict[str, str]:
    """Read the table.

    - raw: the table in the parsed file
    - problem: takes the path, what is wrong, and the remedy of each problem

    Returns the fields that it gives, in the order of the header, each on one line and without invisible
    characters.
    """
    if not isinstance(raw, Mapping):
        problem(REPORT, f"expected a table, found {shown(raw)}", f'write customer = "..." below [{REPORT}]')
        return {}
    fields: dict[str, str] = {}
    for name, entry in raw.items():
        place = f"{REPORT}.{name if schema.is_bare_key(name) else shown(name)}"
        if name not in TITLES:
            problem(place, f"unknown key {shown(name)}", nearest_name(name, TITLES))
        elif not isinstance(entry, str) or not entry.strip() or len(entry) > MAX_TEXT_LENGTH:
            message = f"expected text of at most {MAX_TEXT_LENGTH} characters, found {shown(entry)}"
            problem(place, message, f'write {name} = "...", or leave it out')
        else:
            fields[name] = printable(entry).strip()
    return {name: fields[name] for name in TITLES if name in fields}


def head_of(*reports: Mapping[str, str]) -> list[tuple[str, str]]:
    """Return the lines of a header, titles with texts: each field from the first table that gives it."""
    merged = {name: text for report in reversed(reports) for name, text in report.items()}
    return [(TITLES[name], merged[name]) for name in TITLES if name in merged]


def common_head(first: Mapping[str, str], second: Mapping[str, str]) -> list[tuple[str, str]]:
    """Return the header lines of a page on two robots: the fields with the same text in both tables."""
    return head_of({name: text for name, text in first.items() if second.get(name) == text})
