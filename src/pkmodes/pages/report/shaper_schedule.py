"""The schedule of ``pkmodes shaper --set``: the shaper of each setting."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pkmodes.core.base.numbers import plain
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import clean, number, pointer, unit

if TYPE_CHECKING:
    from pkmodes.machine.shaping.results import Choice, Schedule, Step

#: Prefix of paths that titles leave out, since it carries no information.
OF_EFFECTS = "effects."


def schedule_blocks(choice: Choice) -> list[Table]:
    """Return the table of the schedule, or of each axis that has one; empty without any."""
    return [
        _table(part, part.schedule, ("axes", i) if axis else ())
        for i, (axis, part) in enumerate(choice.parts.items())
        if part.schedule is not None
    ]


def _table(choice: Choice, schedule: Schedule, at: tuple[str | int, ...]) -> Table:
    """Return the table of a schedule.

    - choice: that for all settings
    - at: place of the choice in the JSON
    """
    first, fixed = schedule.steps[0], choice.best
    one_parameter, layers = schedule.parameter is not None, first.heights is not None
    settings = [
        Column(clean(path.removeprefix(OF_EFFECTS)) + ("" if symbol == "1" else f" [{unit(symbol)}]"))
        for path, symbol in first.setting.units.items()
    ]
    columns = [
        *settings,
        *([Column("from [mm]")] if layers else []),
        Column("shaper", numbers=False),
        Column("design [Hz]", numbers=False),
        Column("damping [%]"),
        Column("lasts [ms]", page_only=layers),
        Column("left [%]"),
        *([Column("halfway [%]")] if one_parameter else []),
        Column("fixed [%]"),
        Column("rounds [\u00b5m]"),
    ]
    serves = ", and the height of the print from which it applies" if layers else ""
    halfway = ", halfway to its neighbours" if one_parameter else ""
    caption = (
        f"The schedule{' of ' + schedule.axis if schedule.axis else ''}: for each setting the shaper that is "
        f"recommended for its poses{serves}. What is left is the largest vibration, of the largest without a shaper: "
        f"at the setting itself (left){halfway}, and at the "
        f"setting with the recommended {clean(fixed.kind)} for all of them (fixed). Where a shaped path "
        "turns back, it is rounded by this much for each m/s\u00b2 of acceleration."
    )
    rounds = [1e6 * step.best.rounding for step in schedule.steps]
    note = (
        f"Over all settings the schedule leaves {plain(100.0 * schedule.left.worst, 2)} % of the largest vibration "
        f"without a shaper, and rounds by {min(rounds):.1f} to {max(rounds):.1f} \u00b5m; {clean(fixed.kind)} for "
        f"all of them leaves {plain(100.0 * fixed.left.worst, 2)} % and rounds by {1e6 * fixed.rounding:.1f} \u00b5m."
    )
    rows = [
        _row(step, (*at, "schedule", "steps", i), layers, one_parameter)
        for i, step in enumerate(schedule.steps)
    ]
    return Table(caption, columns, rows, note=note, heads=len(settings))


def _row(step: Step, at: tuple[str | int, ...], layers: bool, one_parameter: bool) -> list[Cell]:
    best = step.best
    cells = [number(value, ".4g", pointer(*at, "set", path)) for path, value in step.setting.values.items()]
    if layers and step.heights is not None:
        cells.append(number(step.heights[0], ".1f", pointer(*at, "heights_m", 0), scale=1e3))
    cells += [
        Cell(clean(best.kind)),
        Cell(", ".join(f"{f:.2f}" for f in best.frequencies)),
        number(best.damping_ratio, ".3g", pointer(*at, "damping_ratios", 0), scale=100.0),
        number(best.duration, ".1f", pointer(*at, "duration_s"), scale=1e3),
        number(best.left.worst, ".2f", pointer(*at, "left", "worst"), scale=100.0),
    ]
    if one_parameter:
        cells.append(number(step.at_ends, ".2f", pointer(*at, "left_at_ends"), scale=100.0))
    cells += [
        number(step.fixed, ".2f", pointer(*at, "left_by_fixed"), scale=100.0),
        number(best.rounding, ".1f", pointer(*at, "rounding_s2"), scale=1e6),
    ]
    return cells
