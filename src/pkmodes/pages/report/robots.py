"""The report of two robots: what their files declare differently, and what that does to the frequencies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from pkmodes.machine.maps.mapping import map_of
from pkmodes.machine.maps.poses import PoseGrid
from pkmodes.machine.maps.robots_compared import NEGLIGIBLE_CHANGE, compare_frequencies
from pkmodes.pages.figures.quantities import plane_poses
from pkmodes.pages.figures.working_plane import working_plane
from pkmodes.pages.plots.changes import colour_scale_limit, relative_changes
from pkmodes.pages.plots.plane import Plane, plane_location
from pkmodes.pages.report.blocks import Cell, Paragraph, Picture, Section
from pkmodes.pages.report.formatting import plural, shorten
from pkmodes.pages.report.page import need_report, page
from pkmodes.pages.report.robot_values import (
    different_value_blocks,
    frequency_difference_blocks,
    robots_summary,
)
from pkmodes.pages.report.sections import origin_section
from pkmodes.pages.report.sources import Source

if TYPE_CHECKING:
    from pkmodes.core.model import Model


def robots_report(
    first: Model,
    second: Model,
    content: dict[str, Any],
    sources: Sequence[Source],
    plane_grid: PoseGrid | None = None,
) -> str:
    """Return the report of two robots of one mechanism.

    - content: the JSON of ``pkmodes compare``
    - sources: the robot files
    - plane_grid: the plane of the pictures; by default the working plane of the first robot

    Raises MissingExtraError if the libraries of the extra ``report`` are not installed.
    """
    need_report()
    pose_count = sum(content["poses"].values())
    sections = [
        Section("values", "What the files declare differently", list(different_value_blocks(first, content))),
        Section(
            "frequencies",
            "Frequencies over the poses that both reach",
            list(frequency_difference_blocks(content)),
        ),
        *_pictures(first, second, content["drives"], plane_grid),
        origin_section(
            sources, first.mechanism, [("poses", [Cell(f"{plural(pose_count, 'pose')} considered")])]
        ),
    ]
    return page(robots_summary(first, second, content), sections)


def _pictures(first: Model, second: Model, drives: str, plane_grid: PoseGrid | None) -> Iterator[Section]:
    components = [component.name for component in first.mechanism.pose]
    if len(components) < 2:
        return
    grid = working_plane(first) if plane_grid is None else plane_grid
    plane = Plane.of(map_of(first, grid, drives=drives), components)
    points = plane_poses(first, plane)
    changes = compare_frequencies(first, second, points.reshape(-1, points.shape[-1]), drives)
    relative = changes.relative.reshape(*points.shape[:-1], -1)
    name, plane_in_words = shorten(first.robot.name), plane_location(plane)
    plane_name = "the plane of the grid" if plane_grid is not None else f"the working plane of {name}"
    if colour_scale_limit(relative) < 100.0 * NEGLIGIBLE_CHANGE:
        text = (
            f"In {plane_name}, {plane_in_words}, no frequency changes by more than {100.0 * NEGLIGIBLE_CHANGE:g} "
            "%."
        )
        yield Section("maps", "Over the working plane", [Paragraph(text)])
        return
    caption = (
        f"Relative difference of each frequency in {plane_name}, {plane_in_words}: red where the second robot is "
        "higher, blue where it is lower, a line where they agree. One scale for all modes; 2 % of the values lie "
        "beyond its ends. Blank where one of the robots cannot be evaluated, or the mode has no partner."
    )
    drawing = relative_changes(plane, relative)
    picture = Picture.from_drawing(drawing, "Difference of the frequencies", caption, caption, cropped=True)
    yield Section("maps", "Over the working plane", [picture])
