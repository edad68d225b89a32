"""The report of two robots: what their files declare differently, and what that does to the frequencies."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from pkmodes.core.robot.report_fields import common_head
from pkmodes.figures.quantities import points_of
from pkmodes.figures.working_plane import working_plane
from pkmodes.maps.mapping import map_of
from pkmodes.maps.poses import Grid
from pkmodes.maps.robots_compared import NOTHING, ModeChange, compare_frequencies, headline
from pkmodes.plots.changes import relative_changes, scale_of
from pkmodes.plots.labels import MINUS
from pkmodes.plots.plane import Plane, where
from pkmodes.report.blocks import (
    Block,
    Cell,
    Column,
    Listing,
    Paragraph,
    Picture,
    Section,
    Summary,
    Table,
)
from pkmodes.report.formatting import clean, number, plural, pointer, thousands, unit
from pkmodes.report.page import need_report, page
from pkmodes.report.sections import origin
from pkmodes.report.sources import Source
from pkmodes.support.motors import motors_of_both
from pkmodes.support.words import in_words

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Titles of numbers of poses by their keys.
REACHED = {"both": "poses that both reach", "first_only": "the first only", "second_only": "the second only"}
#: Titles of standard deviations by their keys.
SIGMAS = {"first_sigma": "\u03c3, first", "second_sigma": "\u03c3, second"}


def robots_report(
    first: Model,
    second: Model,
    content: dict[str, Any],
    sources: Sequence[Source],
    places: Grid | None = None,
) -> str:
    """Return the report of two robots of one mechanism.

    Parameters
    ----------
    content : dict
        The JSON of ``pkmodes compare``.
    sources : sequence of Source
        The robot files.
    places : Grid, optional
        The plane of the pictures; by default the working plane of the first robot.

    Raises
    ------
    MissingExtraError
        If the libraries of the extra ``report`` are not installed.
    """
    need_report()
    considered = sum(content["poses"].values())
    sections = [
        Section("values", "What the files declare differently", list(_values(first, content))),
        Section("frequencies", "Frequencies over the poses that both reach", list(_frequencies(content))),
        *_pictures(first, second, content["drives"], places),
        origin(sources, first.mechanism, [("poses", [Cell(f"{plural(considered, 'pose')} considered")])]),
    ]
    head = common_head(first.robot.report, second.robot.report)
    doing = motors_of_both(first.robot, second.robot, content["drives"])
    return page(_summary(content, head, doing), sections)


def _summary(content: dict[str, Any], head: Sequence[tuple[str, str]], doing: str) -> Summary:
    poses = content["poses"]
    facts = [
        ("values that differ", Cell(str(len(content["values"])), len(content["values"]))),
        *(
            (title, Cell(thousands(poses[key]), poses[key], pointer("poses", key)))
            for key, title in REACHED.items()
        ),
    ]
    names = f"{clean(content['first'])} (first) and {clean(content['second'])} (second)"
    return Summary(
        subject=f"{names}, {doing}",
        kind="Comparison of robots",
        headline=headline([ModeChange(**mode) for mode in content["modes"]]).replace("-", MINUS),
        reason="Differences are second minus first, relative to the first.",
        notes=[clean(note, None) for note in content["notes"]],
        facts=facts,
        head=head,
    )


def _values(first: Model, content: dict[str, Any]) -> Iterator[Block]:
    values = content["values"]
    if values:
        # Columns that would say nothing are left out.
        sigmas = [
            key for key in ("first_sigma", "second_sigma") if any(value[key] is not None for value in values)
        ]
        rows = [
            [
                Cell.named(clean(in_words(first.robot.mechanism, value["path"])), clean(value["path"])),
                number(value["first"], ".6g", pointer("values", i, "first")),
                number(value["second"], ".6g", pointer("values", i, "second")),
                number(value["relative"], "+.2f", pointer("values", i, "relative"), scale=100.0),
                *(number(value[key], ".2g", pointer("values", i, key)) for key in sigmas),
                Cell(unit(value["unit"])),
            ]
            for i, value in enumerate(values)
        ]
        titles = ["first", "second", "difference [%]", *(SIGMAS[key] for key in sigmas)]
        columns = [Column("quantity", numbers=False), *map(Column, titles), Column("unit", numbers=False)]
        yield Table("Declared values that differ, in SI units; \u2013: not declared.", columns, rows)
    else:
        yield Paragraph("Every value is the same in both files.")
    choices = [
        f"{clean(one['path'])}: {clean(one['first'])}, then {clean(one['second'])}"
        for one in content["choices"]
    ]
    if choices:
        yield Listing(choices)
    for key, sentence in (
        ("effects_added", "Effects of the second robot only:"),
        ("effects_removed", "Effects of the first robot only:"),
    ):
        if content[key]:
            yield Paragraph(sentence)
            yield Listing([clean(name) for name in content[key]], names=True)


def _frequencies(content: dict[str, Any]) -> Iterator[Block]:
    counts = {mode["poses"] for mode in content["modes"]}
    known = len(counts) > 1  # otherwise the summary says it
    rows = [
        [
            Cell(str(mode["mode"])),
            number(mode["partner"], ".0f", pointer("modes", i, "partner")),
            *([number(mode["poses"], ".0f", pointer("modes", i, "poses"))] if known else []),
            *(
                number(mode[key], "+.2f", pointer("modes", i, key), scale=100.0)
                for key in ("low", "median", "high")
            ),
            number(mode["exchanged"], ".1f", pointer("modes", i, "exchanged"), scale=100.0),
            number(mode["mac"], ".3f", pointer("modes", i, "mac")),
        ]
        for i, mode in enumerate(content["modes"])
    ]
    titles = ["mode", "partner", *(["poses"] if known else [])]
    titles += ["2 % [%]", "median [%]", "98 % [%]", "exchanged [%]", "MAC"]
    caption = (
        "Relative difference of each frequency: its median, and the values below which 2 % and 98 % lie."
    )
    yield Table(caption, [Column(title) for title in titles], rows)
    yield Paragraph(
        "Modes are numbered by frequency in the first robot. At each pose they are paired with those of the second "
        "by their shapes: the pairs with the largest sum of MAC. The partner named is the most frequent one; "
        "exchanged is the share of poses at which it is another, because frequencies cross or veer; MAC is the "
        "median of the pairs."
    )


def _pictures(first: Model, second: Model, drives: str, places: Grid | None) -> Iterator[Section]:
    components = [component.name for component in first.mechanism.pose]
    if len(components) < 2:
        return
    chosen = working_plane(first) if places is None else places
    plane = Plane.of(map_of(first, chosen, drives=drives), components)
    points = points_of(first, plane)
    changes = compare_frequencies(first, second, points.reshape(-1, points.shape[-1]), drives)
    relative = changes.relative.reshape(*points.shape[:-1], -1)
    name, plane_in_words = clean(first.robot.name), where(plane)
    of = "the plane of the grid" if places is not None else f"the working plane of {name}"
    if scale_of(relative) < 100.0 * NOTHING:
        text = f"In {of}, {plane_in_words}, no frequency changes by more than {100.0 * NOTHING:g} %."
        yield Section("maps", "Over the working plane", [Paragraph(text)])
        return
    caption = (
        f"Relative difference of each frequency in {of}, {plane_in_words}: red where the second robot is "
        "higher, blue where it is lower, a line where they agree. One scale for all modes; 2 % of the values lie "
        "beyond its ends. Blank where one of the robots cannot be evaluated."
    )
    drawn = relative_changes(plane, relative)
    picture = Picture.of(drawn, "Difference of the frequencies", caption, caption, cropped=True)
    yield Section("maps", "Over the working plane", [picture])
