"""Measured modes in a line: which rows, at which poses, and what their measurements set."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.support.ordering import listed, sorted_labels
from pkmodes.loop.diagnosis.compare import ComparedRow
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.pages.report.setting import ReportSetting

#: Most rows, poses or settings named in a line; the JSON has all of them.
MOST = 8
Rows = Sequence[Row | ComparedRow]


def rows_in_words(rows: Rows) -> str:
    """Return rows by their lines in the file, poses and frequencies."""
    named = [f"line {row.line}, pose {row.pose}, {row.measured:g} Hz" for row in rows]
    return listed(named, MOST, "; ", "; and ")


def poses_in_words(labels: Sequence[str]) -> str:
    """Return poses by their labels."""
    return f"pose{'' if len(labels) == 1 else 's'} {listed(labels, MOST)}"


def settings_in_words(setting: ReportSetting, rows: Rows) -> str:
    """Return what the measurements set, and at which poses; empty where they set nothing."""
    at = {row.pose: setting.load(row.load).plain for row in rows if row.load}
    loads: dict[str, list[str]] = {}
    for label in sorted_labels(at):
        loads.setdefault(at[label], []).append(label)
    cases = [f"{load} ({poses_in_words(labels)})" for load, labels in loads.items()]
    return f"set by the measurements: {listed(cases, MOST, '; ', '; and ')}" if cases else ""
