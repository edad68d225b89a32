"""Reports of the commands: ``--report FILE.html``."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.base.writing import write_file

if TYPE_CHECKING:
    from pkmodes.diagnosis import Comparison, Diagnosis, Measurements
    from pkmodes.report.sources import Source
    from pkmodes.robot.robot import Robot


class Reporting:
    """A report to be written when the result is known.

    It is made when the input files were read, but before anything is computed: missing libraries are reported at
    once, and the digests are those of the files as they were read.

    Parameters
    ----------
    target : Path
        The report.
    inputs : mapping of str to Path
        The input files by their roles, such as "robot file".

    Raises
    ------
    MissingExtraError
        If the libraries for reports are missing.
    """

    def __init__(self, target: Path, inputs: Mapping[str, Path]) -> None:
        from pkmodes.report.page import need_report

        need_report()
        from pkmodes.report.sources import known_sources

        self._target, self._written = target, False
        self._sources = known_sources([(role, str(path)) for role, path in inputs.items()])

    def write(self, made: Callable[[Sequence[Source]], str]) -> None:
        """Write the report, completely or not at all.

        Parameters
        ----------
        made : callable
            Returns the page, given the input files.

        Raises
        ------
        OutputError
            If it cannot be written.
        """
        write_file(self._target, made(self._sources))
        self._written = self._target.is_file()

    def announce(self, json_file: str | None) -> None:
        """Print where the report is, on stderr if standard output is the JSON."""
        if self._written:
            click.echo(f"\nwrote {self._target}", err=json_file == "-")


def measured_reporting(target: Path | None, robot: Path, modes: Path) -> Reporting | None:
    """Return the report of a command with measured modes, if one is wanted."""
    return None if target is None else Reporting(target, {"robot file": robot, "measurement file": modes})


def page_of(
    result: Diagnosis | Comparison, robot: Robot, data: Measurements
) -> Callable[[Sequence[Source]], str]:
    """Return what makes the page of a result from its sources."""

    def made(sources: Sequence[Source]) -> str:
        from pkmodes.report import report, view_of_result

        view = view_of_result(result, robot, data.points)
        return report(result, robot=robot, data=data, sources=sources, view=view)

    return made
