"""The report of ``pkmodes sensitivities``: what frequencies at a pose depend on, and how uncertain they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from pkmodes.loop.sensitivity.changes import PERCENT, SIGMA, Changes, changes_at
from pkmodes.loop.sensitivity.spread import stated_sigmas
from pkmodes.pages.figures.tornado_picture import describe_changes
from pkmodes.pages.plots.tornado import MAX_PANELS, tornado
from pkmodes.pages.report.blocks import Block, Cell, Paragraph, Picture, Section, Table
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sensitivity_tables import (
    LABEL_COLUMNS,
    per_cent_table,
    per_sigma_table,
    sensitivities_summary,
)
from pkmodes.pages.report.sources import Source, known_sources

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Modes side by side in one table.
MODES_PER_TABLE = 6


def sensitivities_report(
    model: Model, content: dict[str, Any], sources: Sequence[Source] | None = None
) -> str:
    """Return the report of sensitivities at a pose.

    - model: the robot
    - content: the JSON of the command, with at least the quantities for which a change in per cent is meaningful
    - sources: the input files as they were read; by default the robot file as it is now

    Returns HTML that needs no other file and no network.
    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    sources = known_sources([("robot file", model.robot.source)]) if sources is None else sources
    pose, drives = content["pose"], content["drives"]
    percent = changes_at(model, pose, drives, PERCENT)
    sigma = changes_at(model, pose, drives, SIGMA) if stated_sigmas(model.robot) else None
    by_percent: list[Block] = [Paragraph("No frequency depends on any quantity of the robot file.")]
    if percent.largest_of_all():
        percent_table = per_cent_table(model, percent, content)
        note = (
            f"{percent_table.note} Coordinates are left out, since a per cent of a coordinate depends on "
            "where the origin lies; --all and the JSON have everything."
        )
        by_percent = [*_tornado_pictures(percent), *_split_table(replace(percent_table, note=note.strip()))]
    by_sigma: list[Block] = [
        Paragraph(
            'The robot file states no standard deviations. Where it does, as in mass = { value = "1.5 kg", '
            'sigma = "1 %" }, this section shows how well each frequency is known.'
        )
    ]
    if sigma is not None:
        by_sigma = [*_tornado_pictures(sigma), *_split_table(per_sigma_table(model, sigma))]
    sections = [
        *_sections_of_modes("percent", "One per cent of each quantity", by_percent),
        *_sections_of_modes("sigma", "Standard deviations of the robot file", by_sigma),
        origin_section(sources, model.mechanism, [("rigid-body modes", [Cell(str(content["rigid_modes"]))])]),
    ]
    return page(sensitivities_summary(model, percent, sigma, content), sections)


def _sections_of_modes(html_id: str, title: str, blocks: Sequence[Block]) -> list[Section]:
    """Return a section with the first picture and the first table, and a folded one with those of further modes."""
    first_blocks: list[Block] = []
    for kind in (Paragraph, Picture, Table):
        first_blocks += [block for block in blocks if isinstance(block, kind)][:1]
    further_blocks = [block for block in blocks if block not in first_blocks]
    sections = [Section(html_id, title, first_blocks)]
    if further_blocks:
        further_title = f"{title}: further modes"
        sections.append(Section(f"{html_id}-further", further_title, further_blocks, folded=True))
    return sections


def _tornado_pictures(changes: Changes) -> list[Block]:
    """Return the tornado charts, divided into figures that fit on pages."""
    blocks: list[Block] = []
    count, text = len(changes.frequencies), describe_changes(changes)
    for start in range(0, count, MAX_PANELS):
        modes = range(start, min(start + MAX_PANELS, count))
        drawing = tornado(changes, modes)
        title = "Largest changes" if changes.by == PERCENT else "Largest changes by standard deviations"
        if count > MAX_PANELS:
            title += f", modes {modes[0] + 1} to {modes[-1] + 1}"
        blocks.append(Picture.from_drawing(drawing, title, text, text if not start else f"{title}."))
    return blocks


def _split_table(full_table: Table) -> list[Block]:
    """Return a table in parts of several modes each where there are many."""
    parts: list[Block] = []
    count = len(full_table.columns) - LABEL_COLUMNS
    for start in range(0, count, MODES_PER_TABLE):
        column_indices = [
            *range(LABEL_COLUMNS),
            *range(LABEL_COLUMNS + start, LABEL_COLUMNS + min(start + MODES_PER_TABLE, count)),
        ]
        columns = [full_table.columns[k] for k in column_indices]
        rows = [[row[k] for k in column_indices] for row in full_table.rows]
        parts.append(
            Table(
                full_table.caption,
                columns,
                rows,
                note="" if start else full_table.note,
            )
        )
    return parts
