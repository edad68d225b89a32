"""Make the report of a result: that of a diagnosis is in ``diagnosis.py``, that of a comparison here.

In a comparison nothing is fitted, so there is no verdict, only whether the differences are noise.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from os import PathLike

from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.updating.declared_spread import declared_spread
from pkmodes.modaltest.campaign.campaign import Campaign, read_campaign
from pkmodes.pages.plots.evidence import PlottedEvidence
from pkmodes.pages.report import figures
from pkmodes.pages.report.blocks import Block, Section
from pkmodes.pages.report.campaign_responses import measured_responses
from pkmodes.pages.report.changed import change_page
from pkmodes.pages.report.comparison import comparison_summary, mode_difference_tables
from pkmodes.pages.report.diagnosis import diagnosis_page
from pkmodes.pages.report.mode_table import mode_table
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.sections import glossary_section, view_section
from pkmodes.pages.report.sources import Source, known_sources

#: Sections of a comparison that are unfolded when the page opens.
UNFOLDED_SECTIONS = ("modes",)


def report(
    result: Diagnosis | Comparison,
    *,
    robot: Robot | Model | None = None,
    data: Measurements | None = None,
    title: str | None = None,
    sources: Sequence[Source] | None = None,
    view: str | None = None,
    campaign: Campaign | str | PathLike[str] | None = None,
) -> str:
    """Return the report of a diagnosis, of what changed, or of a comparison.

    The same result always gives the same text, but for the date (``SOURCE_DATE_EPOCH``).

    Parameters
    ----------
    result : Diagnosis or Comparison
        From ``pkmodes.loop.updating`` or ``pkmodes.loop.diagnosis``.
    robot : Robot or Model, optional
        The robot, for its name, units, and the correction of its file.
    data : Measurements, optional
        The measurements of the result, for figures against the pose.
    title : str, optional
        What was measured; by default the name of the robot.
    sources : sequence of Source, optional
        The input files, by default those that the robot and the measurements were read from.
    view : str, optional
        HTML of a view in three dimensions, from `view_of_result`; by default there is none.
    campaign : Campaign or path-like, optional
        The campaign that the measurements were identified from, or its file: the page of a diagnosis then shows its
        frequency responses over those of the robot before and after the correction.

    Returns
    -------
    str
        HTML that needs no other file and no network.

    Raises
    ------
    MissingExtraError
        If the libraries of the extra ``report`` are not installed.
    PkmodesError
        If the result is of another kind, the measurements are not those of the result, or the campaign has no
        frequency response functions at their poses, or does not say where its forces act.
    MeasurementError
        If the campaign or one of its files is faulty.
    """
    need_report()
    if not isinstance(result, Diagnosis | Comparison):
        remedy = "give what pkmodes.loop.updating.diagnose or compare returns"
        raise PkmodesError(f"expected a diagnosis or a comparison, found {shown(result)}", "result", remedy)
    if not result.rows:
        raise PkmodesError("expected a result with rows, found none", "result", "measure at least one mode")
    declared = robot.robot if isinstance(robot, Model) else robot
    if sources is None:
        robot_files = [] if declared is None else [("robot file", declared.source)]
        sources = known_sources(
            [*robot_files, *([] if data is None else [("measurement file", data.source)])]
        )
    subject = title if title is not None else "Structure" if declared is None else declared.name
    if isinstance(result, Change) and result.by_state:
        data = None  # the rows are of several measurements
    context = ReportContext(subject, declared, data, tuple(sources), view)
    frequency_sigma = None if declared is None or data is None else declared_spread(declared, data)
    evidence = PlottedEvidence.of(result, data, "setup" if declared is None else "pose", frequency_sigma)
    if isinstance(result, Change):
        return change_page(result, evidence, context)
    if isinstance(result, Diagnosis):
        response_blocks: list[Block] = []
        if campaign is not None and declared is not None:
            campaign = campaign if isinstance(campaign, Campaign) else read_campaign(campaign)
            response_blocks = measured_responses(result, declared, campaign)
        return diagnosis_page(result, evidence, context, response_blocks)
    sections = [
        *figures.figure_sections(evidence),
        *view_section(context.view),
        Section(
            "rows",
            "All measured modes",
            [*mode_difference_tables(result), mode_table(result, evidence, context)],
        ),
        glossary_section(is_diagnosis=False),
        context.origin(evidence),
    ]
    return page(
        comparison_summary(result, context),
        [replace(section, folded=section.html_id not in UNFOLDED_SECTIONS) for section in sections],
    )
