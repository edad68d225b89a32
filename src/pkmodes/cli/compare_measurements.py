"""``pkmodes compare`` of two measurement files: which modes changed, and whether by more than their errors."""

from __future__ import annotations

from pathlib import Path

from pkmodes.cli.delivery import deliver

#: Rows of a table that are printed without ``--all``.
MOST = 10


def compare_measurement_files(
    files: tuple[Path, Path],
    band: tuple[float, float] | None,
    drives: str | None,
    everything: bool,
    to: str | None,
) -> None:
    """Compare two measurement files, and print or write what changed."""
    from pkmodes.cli.terminal import Terminal
    from pkmodes.loop.measured.compared import compare_measurements
    from pkmodes.loop.updating.reading import read_any
    from pkmodes.pages.report.measured_shapes import shape_tables
    from pkmodes.pages.report.measurements import changes, measurements_summary

    first, second = (read_any(file, band, drives=drives) for file in files)
    result = compare_measurements(first, second)

    def show() -> None:
        terminal, limit, head = Terminal(), None if everything else MOST, measurements_summary(result)
        terminal.summary(head)
        terminal.show(*changes(result, limit), *shape_tables(result, limit))
        terminal.notes(head)

    deliver(to, result.as_json(), show)
