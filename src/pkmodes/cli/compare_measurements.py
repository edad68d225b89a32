"""``pkmodes compare`` of two measurement files: which modes changed, and whether by more than their errors."""

from __future__ import annotations

import re
from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.cli.delivery import deliver

if TYPE_CHECKING:
    from pkmodes.measured.measurements import Measurements

#: Pairs that are printed without ``--all``.
MOST = 10
SHAPE = re.compile(r"shape:\s*([^,;\t\[\]\r\n\"]*[^,;\t\[\]\r\n\"\s])")


def compare_measurement_files(
    files: tuple[Path, Path],
    band: tuple[float, float] | None,
    drives: str | None,
    everything: bool,
    to: str | None,
) -> None:
    """Compare two measurement files, and print or write what changed."""
    from pkmodes.cli.terminal import Terminal
    from pkmodes.measured.compared import compare_measurements
    from pkmodes.report.measurements import changes, summary

    first, second = (read_table(file, band, drives) for file in files)
    result = compare_measurements(first, second)

    def show() -> None:
        terminal = Terminal()
        terminal.summary(summary(result))
        terminal.show(*changes(result, None if everything else MOST))

    deliver(to, result.as_json(), show)


def read_table(file: Path, band: tuple[float, float] | None, drives: str | None) -> Measurements:
    """Read a file of a robot, or of another structure: without positions, or with channels of its own."""
    from pkmodes import updating
    from pkmodes.core.mechanism import registry
    from pkmodes.measured.cells import separator_of
    from pkmodes.measured.csv_format import read_text
    from pkmodes.measured.reading import read_measurements
    from pkmodes.updating.channels import channels

    text = read_text(file, str(file), "the measurements", "give a CSV file with one row for each mode")
    header = next((line for line in text.splitlines() if line.strip() and line[0] != "#"), "")
    own = SHAPE.findall(header)
    machines = [registry.mechanism(name) for name in registry.names()]
    known = {name for each in machines for name in channels(each)}
    columns = {cell.partition("[")[0].strip(' "') for cell in header.split(separator_of(header))}
    if set(own) <= known and columns & {component.name for each in machines for component in each.pose}:
        return updating.read(file, band, drives=drives)
    return read_measurements(file, own, positions=False, drives=drives)
