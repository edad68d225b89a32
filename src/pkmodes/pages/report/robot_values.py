"""What two robot files declare differently, and how much that changes each frequency, in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from pkmodes.core.robot.report_fields import common_head
from pkmodes.core.support.mac import MIN_MAC_OF_PAIR
from pkmodes.core.support.motors import motors_of_both
from pkmodes.core.support.words import meaning_of
from pkmodes.machine.maps.robots_compared import ModeChange, largest_difference_sentence
from pkmodes.pages.report.blocks import Cell, Column, Listing, Paragraph, Summary, Table
from pkmodes.pages.report.formatting import (
    clean,
    group_thousands,
    number_cell,
    pointer,
    shorten,
    to_sentence,
    typeset_sentences,
    unit_cell,
)

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Titles of the pose counts by their keys.
POSE_COUNT_TITLES = {
    "both": "poses that both reach",
    "first_only": "poses that only the first reaches",
    "second_only": "poses that only the second reaches",
}
#: Titles of the standard deviations by their keys.
SIGMA_TITLES = {"first_sigma": "\u03c3, first", "second_sigma": "\u03c3, second"}
ValueBlock = Paragraph | Listing | Table


def robots_summary(first: Model, second: Model, content: dict[str, Any]) -> Summary:
    """Return which frequency differs most, and what was compared."""
    poses, motors = content["poses"], motors_of_both(first.robot, second.robot, content["drives"])
    difference_count = len(content["values"])
    facts = [
        (
            "declared values that differ",
            Cell(f"{difference_count} of {content['compared']}", difference_count),
        ),
        *(
            (title, Cell(group_thousands(poses[key]), poses[key], pointer("poses", key)))
            for key, title in POSE_COUNT_TITLES.items()
        ),
    ]
    names = f"{shorten(content['first'])} (first) and {shorten(content['second'])} (second)"
    return Summary(
        subject=f"{names}, {motors}",
        kind="Comparison of robots",
        headline=typeset_sentences(
            largest_difference_sentence([ModeChange(**mode) for mode in content["modes"]])
        ),
        reason="Differences are second minus first, relative to the first.",
        notes=[typeset_sentences(to_sentence(note)) for note in content["notes"]],
        facts=facts,
        head=common_head(first.robot.report, second.robot.report),
    )


def different_value_blocks(
    first: Model, content: dict[str, Any], max_rows: int | None = None
) -> Iterator[ValueBlock]:
    """Yield what the files declare differently.

    - max_rows: maximum number of values, those that differ most; None for all, in the order of the files
    """
    indexed_values = list(enumerate(content["values"]))
    note = ""
    if max_rows is not None and len(indexed_values) > max_rows:
        # Those without a relative difference first, then the largest ones.
        sizes = [
            math.inf if value["relative"] is None else abs(value["relative"]) for _, value in indexed_values
        ]
        indexed_values = sorted(indexed_values, key=lambda entry: -sizes[entry[0]])[:max_rows]
        note = f"The {max_rows} that differ most of {len(content['values'])}; all: --all, --json or --report."
    if indexed_values:
        shown_values = [value for _, value in indexed_values]
        # Columns without information are left out.
        sigma_keys = [
            key
            for key in ("first_sigma", "second_sigma")
            if any(value[key] is not None for value in shown_values)
        ]
        rows = [
            [
                Cell.named(clean(meaning_of(first.robot.mechanism, value["path"])), clean(value["path"])),
                number_cell(value["first"], ".6g", pointer("values", i, "first")),
                number_cell(value["second"], ".6g", pointer("values", i, "second")),
                number_cell(value["relative"], "+.2f", pointer("values", i, "relative"), scale=100.0),
                *(number_cell(value[key], ".2g", pointer("values", i, key)) for key in sigma_keys),
                unit_cell(value["unit"]),
            ]
            for i, value in indexed_values
        ]
        titles = ["first", "second", "difference [%]", *(SIGMA_TITLES[key] for key in sigma_keys)]
        columns = [Column("quantity", numeric=False), *map(Column, titles), Column("unit", numeric=False)]
        yield Table(
            "Declared values that differ, in SI units; \u2013: not declared.", columns, rows, note=note
        )
    else:
        yield Paragraph("Every value is the same in both files.")
    choices = [
        f"{clean(choice['path'])}: {clean(choice['first'])} in the first, {clean(choice['second'])} in the second"
        for choice in content["choices"]
    ]
    if choices:
        yield Listing(choices)
    for key, title in (
        ("effects_added", "Effects of the second robot only:"),
        ("effects_removed", "Effects of the first robot only:"),
    ):
        if content[key]:
            yield Paragraph(title)
            yield Listing([clean(name) for name in content[key]], in_columns=True)


def frequency_difference_blocks(content: dict[str, Any]) -> Iterator[ValueBlock]:
    """Yield how much each frequency differs over the poses that both reach."""
    counts = {mode["poses"] for mode in content["modes"]}
    counts_differ = len(counts) > 1  # otherwise the summary says it
    rows = [
        [
            Cell(str(mode["mode"])),
            number_cell(mode["partner"], ".0f", pointer("modes", i, "partner")),
            *([number_cell(mode["poses"], ".0f", pointer("modes", i, "poses"))] if counts_differ else []),
            *(
                number_cell(mode[key], "+.2f", pointer("modes", i, key), scale=100.0)
                for key in ("low", "median", "high")
            ),
            number_cell(mode["exchanged"], ".1f", pointer("modes", i, "exchanged"), scale=100.0),
            number_cell(mode["mac"], ".3f", pointer("modes", i, "mac")),
        ]
        for i, mode in enumerate(content["modes"])
    ]
    titles = ["mode", "partner", *(["poses"] if counts_differ else [])]
    titles += ["2 %", "median", "98 %", "exchanged [%]", "MAC"]
    groups = [("", 2 + counts_differ), ("difference [%]", 3), ("", 2)]
    caption = (
        "Relative difference of each frequency where the mode has the partner named: its median, and the values "
        "below which 2 % and 98 % lie."
    )
    yield Table(caption, [Column(title) for title in titles], rows, groups)
    yield Paragraph(
        "Modes are numbered by frequency in the first robot. At each pose they are paired with those of the second "
        f"by their shapes: the pairs with the largest sum of MAC, none below {MIN_MAC_OF_PAIR:g}. The partner named "
        "is the most frequent one; exchanged is the share of poses at which it is another, because frequencies cross "
        "or veer, or there is none; MAC is the median of the pairs."
    )
