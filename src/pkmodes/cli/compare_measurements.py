"""``pkmodes compare`` of two measurement files: which modes changed, and whether by more than their errors."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.cli.delivery import deliver

if TYPE_CHECKING:
    from pkmodes.measured.measurements import Measurements

#: Pairs that are printed without ``--all``.
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
    from pkmodes.core.robot.columns import parted
    from pkmodes.measured.csv_format import read_text
    from pkmodes.measured.csv_rows import read_lines
    from pkmodes.measured.reading import read_measurements
    from pkmodes.measured.rules import SHAPE
    from pkmodes.updating.channels import channels

    text = read_text(file, str(file), "the measurements", "give a CSV file with one row for each mode")
    _, cells = read_lines(text, str(file)).header(str(file), "start with the names of the columns")
    machines = [registry.mechanism(name) for name in registry.names()]
    known = {f"{SHAPE}{name}" for each in machines for name in channels(each)}
    poses = {component.name for each in machines for component in each.pose}
    names = [parted(cell, [*known, *poses])[0] for cell in cells]
    own = [name for name in names if name.lower().startswith(SHAPE)]
    if set(own) <= known and poses.intersection(names):
        return updating.read(file, band, drives=drives)
    return read_measurements(file, [name[len(SHAPE) :] for name in own], positions=False, drives=drives)
