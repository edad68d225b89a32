"""Reports of the commands: ``--report FILE.html``."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pkmodes.cli.delivery import ResultFile
from pkmodes.core.support.progress import report_progress

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot
    from pkmodes.loop.diagnosis import Comparison, Diagnosis, Measurements
    from pkmodes.modaltest.campaign.campaign import Campaign
    from pkmodes.pages.report.sources import Source


def sources_of(report: Path | None, inputs: Mapping[str, Path | None]) -> Sequence[Source]:
    """Return the input files of a report by their roles, such as "robot file"; none if no report is requested.

    Call it after the files are read and before anything is computed: missing libraries are then reported at once, and
    the digests are those of the files as they were read.

    Raises MissingExtraError if the libraries for reports are missing.
    """
    if report is None:
        return ()
    from pkmodes.pages.report.page import need_report
    from pkmodes.pages.report.sources import known_sources

    need_report()
    return known_sources([(role, str(path)) for role, path in inputs.items() if path is not None])


def report_file(report: Path | None, page: Callable[[], str]) -> ResultFile:
    """Return the report as a file to write; it is not announced if it is a pipe."""

    def messages(file: Path) -> list[str]:
        return [f"\nwrote {file}"] if file.is_file() else []

    def draw_page() -> str:
        report_progress("drawing the report")
        return page()

    return ResultFile(report, draw_page, messages)


def page_of(
    result: Diagnosis | Comparison,
    robot: Robot,
    data: Measurements,
    sources: Sequence[Source],
    campaign: Campaign | None = None,
) -> str:
    """Return the page of a diagnosis or comparison, with measured responses of a campaign."""
    from pkmodes.pages.report import report, view_of_result

    view = view_of_result(result, robot, data)
    return report(result, robot=robot, data=data, sources=sources, view=view, campaign=campaign)
