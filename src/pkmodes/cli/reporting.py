"""Reports of the commands: ``--report FILE.html``."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.writing import write_file

if TYPE_CHECKING:
    from pkmodes.diagnosis import Comparison, Diagnosis, Measurements
    from pkmodes.robot.robot import Robot


class Reporting:
    """A report to be written when the result is known.

    It is made when the input files were read, but before anything is computed: missing libraries are reported at
    once, and the digests are those of the files as they were read.

    Parameters
    ----------
    target, robot, modes : Path
        The report, and the input files.

    Raises
    ------
    MissingExtraError
        If the libraries for reports are missing.
    """

    def __init__(self, target: Path, robot: Path, modes: Path) -> None:
        from pkmodes.report.page import need_report

        need_report()
        from pkmodes.report.sources import known_sources

        self._target, self._written = target, False
        self._sources = known_sources([("robot file", str(robot)), ("measurement file", str(modes))])

    def write(self, result: Diagnosis | Comparison, robot: Robot, data: Measurements) -> None:
        """Write the report, completely or not at all.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        from pkmodes.report import report
        from pkmodes.report.three import view_of_result

        view = view_of_result(result, robot, data.points)
        write_file(self._target, report(result, robot=robot, data=data, sources=self._sources, view=view))
        self._written = True

    def announce(self, json_file: str | None) -> None:
        """Print where the report is, on stderr if standard output is the JSON."""
        if self._written:
            click.echo(f"\nwrote {self._target}", err=json_file == "-")
