"""What two robot files declare differently, and how much that changes each frequency, in numbers."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from pkmodes.core.robot.report_fields import common_head
from pkmodes.core.support.motors import motors_of_both
from pkmodes.core.support.words import meaning_of
from pkmodes.machine.maps.robots_compared import MIN_PAIR_MAC, ModeChange, largest_difference_sentence
from pkmodes.pages.plots.labels import MINUS
from pkmodes.pages.report.blocks import Cell, Column, Listing, Paragraph, Summary, Table
from pkmodes.pages.report.formatting import (
    clean,
    number,
    pointer,
    prose,
    sentence,
    shortened,
    thousands,
    unit_cell,
)

if TYPE_CHECKING:
    from pkmodes.core.model import Model

#: Titles of the pose counts by their keys.
REACHED = {
    "both": "poses that both reach",
    "first_only": "poses that only the first reaches",
    "second_only": "poses that only the second reaches",
}
#: Titles of the standard deviations by their keys.
SIGMAS = {"first_sigma": "\u03c3, first", "second_sigma": "\u03c3, second"}
Shared = Paragraph | Listing | Table


def robots_summary(first: Model, second: Model, content: dict[str, Any]) -> Summary:
    """Return which frequency differs most, and what was compared."""
    poses, doing = content["poses"], motors_of_both(first.robot, second.robot, content["drives"])
    differ = len(content["values"])
    facts = [
        ("declared values that differ", Cell(f"{differ} of {content['compared']}", differ)),
        *(
            (title, Cell(thousands(poses[key]), poses[key], pointer("poses", key)))
            for key, title in REACHED.items()
        ),
    ]
    names = f"{shortened(content['first'])} (first) and {shortened(content['second'])} (second)"
    return Summary(
        subject=f"{names}, {doing}",
        kind="Comparison of robots",
        headline=largest_difference_sentence([ModeChange(**mode) for mode in content["modes"]]).replace(
            "-", MINUS
        ),
        reason="Differences are second minus first, relative to the first.",
        notes=[prose(sentence(note)) for note in content["notes"]],
        facts=facts,
        head=common_head(first.robot.report, second.robot.report),
    )


def different_values(first: Model, content: dict[str, Any], max_rows: int | None = None) -> Iterator[Shared]:
    """Yield what the files declare differently.

    - max_rows: most values, those that differ most; None for all, in the order of the files
    """
    numbered = list(enumerate(content["values"]))
    note = ""
    if max_rows is not None and len(numbered) > max_rows:
        # Those without a relative difference first, then the largest ones.
        sizes = [math.inf if value["relative"] is None else abs(value["relative"]) for _, value in numbered]
        numbered = sorted(numbered, key=lambda entry: -sizes[entry[0]])[:max_rows]
        note = f"The {max_rows} that differ most of {len(content['values'])}; all: --all, --json or --report."
    if numbered:
        shown = [value for _, value in numbered]
        # Columns without information are left out.
        sigmas = [
            key for key in ("first_sigma", "second_sigma") if any(value[key] is not None for value in shown)
        ]
        rows = [
            [
                Cell.named(clean(meaning_of(first.robot.mechanism, value["path"])), clean(value["path"])),
                number(value["first"], ".6g", pointer("values", i, "first")),
                number(value["second"], ".6g", pointer("values", i, "second")),
                number(value["relative"], "+.2f", pointer("values", i, "relative"), scale=100.0),
                *(number(value[key], ".2g", pointer("values", i, key)) for key in sigmas),
                unit_cell(value["unit"]),
            ]
            for i, value in numbered
        ]
        titles = ["first", "second", "difference [%]", *(SIGMAS[key] for key in sigmas)]
        columns = [Column("quantity", numbers=False), *map(Column, titles), Column("unit", numbers=False)]
        yield Table(
            "Declared values that differ, in SI units; \u2013: not declared.", columns, rows, note=note
        )
    else:
        yield Paragraph("Every value is the same in both files.")
    choices = [
        f"{clean(choice['path'])}: {clean(choice['first'])}, then {clean(choice['second'])}"
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
            yield Listing([clean(name) for name in content[key]], names=True)


def frequencies(content: dict[str, Any]) -> Iterator[Shared]:
    """Yield how much each frequency differs over the poses that both reach."""
    counts = {mode["poses"] for mode in content["modes"]}
    varied = len(counts) > 1  # otherwise the summary says it
    rows = [
        [
            Cell(str(mode["mode"])),
            number(mode["partner"], ".0f", pointer("modes", i, "partner")),
            *([number(mode["poses"], ".0f", pointer("modes", i, "poses"))] if varied else []),
            *(
                number(mode[key], "+.2f", pointer("modes", i, key), scale=100.0)
                for key in ("low", "median", "high")
            ),
            number(mode["exchanged"], ".1f", pointer("modes", i, "exchanged"), scale=100.0),
            number(mode["mac"], ".3f", pointer("modes", i, "mac")),
        ]
        for i, mode in enumerate(content["modes"])
    ]
    titles = ["mode", "partner", *(["poses"] if varied else [])]
    titles += ["2 %", "median", "98 %", "exchanged [%]", "MAC"]
    groups = [("", 2 + varied), ("difference [%]", 3), ("", 2)]
    caption = (
        "Relative difference of each frequency: its median, and the values below which 2 % and 98 % lie."
    )
    yield Table(caption, [Column(title) for title in titles], rows, groups)
    yield Paragraph(
        "Modes are numbered by frequency in the first robot. At each pose they are paired with those of the second "
        f"by their shapes: the pairs with the largest sum of MAC, none below {MIN_PAIR_MAC:g}. The partner "
        "named is the most "
        "frequent one; exchanged is the share of poses at which it is another, because frequencies cross or veer, or "
        "there is none; MAC is the median of the pairs."
    )
