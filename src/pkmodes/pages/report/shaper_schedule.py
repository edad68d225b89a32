"""The schedule of ``pkmodes shaper --set``: the shaper of each setting."""

from __future__ import annotations

from typing import TYPE_CHECKING

from pkmodes.core.base.numbers import plain
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.formatting import clean, number_cell, pointer, unit_text

if TYPE_CHECKING:
    from pkmodes.machine.shaping.results import Choice, Schedule, Step

#: Prefix of paths that titles leave out, since it carries no information.
EFFECTS_PREFIX = "effects."


def schedule_blocks(choice: Choice) -> list[Table]:
    """Return the table of the schedule, or of each axis that has one; empty without any."""
    return [
        _schedule_table(part, part.schedule, ("axes", i) if axis else ())
        for i, (axis, part) in enumerate(choice.parts.items())
        if part.schedule is not None
    ]


def _schedule_table(choice: Choice, schedule: Schedule, choice_keys: tuple[str | int, ...]) -> Table:
    """Return the table of a schedule.

    - choice: that for all settings
    - choice_keys: place of the choice in the JSON
    """
    first_step, fixed = schedule.steps[0], choice.best
    has_one_parameter, has_layers = schedule.parameter is not None, first_step.heights is not None
    setting_columns = [
        Column(
            clean(path.removeprefix(EFFECTS_PREFIX)) + ("" if symbol == "1" else f" [{unit_text(symbol)}]")
        )
        for path, symbol in first_step.setting.units.items()
    ]
    columns = [
        *setting_columns,
        *([Column("from [mm]")] if has_layers else []),
        Column("shaper", numeric=False),
        Column("design [Hz]", numeric=False),
        Column("damping [%]"),
        Column("lasts [ms]", page_only=has_layers),
        Column("left [%]"),
        *([Column("halfway [%]")] if has_one_parameter else []),
        Column("fixed [%]"),
        Column("rounds [\u00b5m]"),
    ]
    height_clause = ", and the height of the print from which it applies" if has_layers else ""
    halfway_clause = ", halfway to its neighbours" if has_one_parameter else ""
    caption = (
        f"The schedule{' of ' + schedule.axis if schedule.axis else ''}: for each setting the shaper that is "
        f"recommended for its poses{height_clause}. What is left is the largest vibration, of the largest "
        f"without a shaper: at the setting itself (left){halfway_clause}, and at the "
        f"setting with the recommended {clean(fixed.kind)} for all of them (fixed). Where a shaped path "
        "turns back, it is rounded by this much for each m/s\u00b2 of acceleration."
    )
    roundings = [1e6 * step.best.rounding for step in schedule.steps]
    note = (
        f"Over all settings the schedule leaves {plain(100.0 * schedule.left.worst, 2)} % of the largest vibration "
        f"without a shaper, and rounds by {min(roundings):.1f} to {max(roundings):.1f} \u00b5m; {clean(fixed.kind)} "
        f"for all of them leaves {plain(100.0 * fixed.left.worst, 2)} % and rounds by "
        f"{1e6 * fixed.rounding:.1f} \u00b5m."
    )
    rows = [
        _step_row(step, (*choice_keys, "schedule", "steps", i), has_layers, has_one_parameter)
        for i, step in enumerate(schedule.steps)
    ]
    return Table(caption, columns, rows, note=note, key_columns=len(setting_columns))


def _step_row(
    step: Step, step_keys: tuple[str | int, ...], has_layers: bool, has_one_parameter: bool
) -> list[Cell]:
    best = step.best
    cells = [
        number_cell(value, ".4g", pointer(*step_keys, "set", path))
        for path, value in step.setting.values.items()
    ]
    if has_layers and step.heights is not None:
        cells.append(number_cell(step.heights[0], ".1f", pointer(*step_keys, "heights_m", 0), scale=1e3))
    cells += [
        Cell(clean(best.kind)),
        Cell(", ".join(f"{f:.2f}" for f in best.frequencies)),
        number_cell(best.damping_ratio, ".3g", pointer(*step_keys, "damping_ratios", 0), scale=100.0),
        number_cell(best.duration, ".1f", pointer(*step_keys, "duration_s"), scale=1e3),
        number_cell(best.left.worst, ".2f", pointer(*step_keys, "left", "worst"), scale=100.0),
    ]
    if has_one_parameter:
        cells.append(number_cell(step.at_ends, ".2f", pointer(*step_keys, "left_at_ends"), scale=100.0))
    cells += [
        number_cell(step.fixed, ".2f", pointer(*step_keys, "left_by_fixed"), scale=100.0),
        number_cell(best.rounding, ".1f", pointer(*step_keys, "rounding_s2"), scale=1e6),
    ]
    return cells
