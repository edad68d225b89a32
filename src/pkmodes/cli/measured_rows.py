"""Measured modes as text: rows, poses, and the settings of their measurements."""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.core.support.ordering import listed, sorted_labels
from pkmodes.loop.diagnosis.compare import ComparedRow
from pkmodes.loop.diagnosis.verdict.rows import Row
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.unmatched import nearest_in_words

#: Maximum number of rows, poses or settings named in a line; the JSON has all of them.
MAX_NAMED = 8
Rows = Sequence[Row | ComparedRow]


def rows_in_words(rows: Rows) -> str:
    """Return rows by their lines in the file, poses and frequencies, and why the nearest mode is no partner."""
    descriptions = [
        f"line {row.line}, pose {row.pose}, {row.measured:g} Hz"
        + (f" ({nearest})" if (nearest := nearest_in_words(row)) else "")
        for row in rows
    ]
    return listed(descriptions, MAX_NAMED, "; ", "; and ")


def poses_in_words(labels: Sequence[str]) -> str:
    """Return poses by their labels."""
    return f"pose{'' if len(labels) == 1 else 's'} {listed(labels, MAX_NAMED)}"


def settings_in_words(context: ReportContext, rows: Rows) -> str:
    """Return the settings of the measurements and their poses; empty where there are none."""
    load_of_pose = {row.pose: context.load_cell(row.load).plain_text for row in rows if row.load}
    poses_of_load: dict[str, list[str]] = {}
    for label in sorted_labels(load_of_pose):
        poses_of_load.setdefault(load_of_pose[label], []).append(label)
    cases = [f"{load} ({poses_in_words(labels)})" for load, labels in poses_of_load.items()]
    return f"set by the measurements: {listed(cases, MAX_NAMED, '; ', '; and ')}" if cases else ""
