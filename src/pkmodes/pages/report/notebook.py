"""What notebooks show of results: tables of their pages, as HTML without a style sheet."""

from __future__ import annotations

from collections.abc import Sequence
from html import escape

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.fields import FIELDS
from pkmodes.core.solve.results import Modes, Statics
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.words import meaning_of
from pkmodes.loop.diagnosis.compare import Comparison
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.machine.response.moves import Move
from pkmodes.machine.shaping.measured_modes import MeasuredRinging
from pkmodes.machine.shaping.results import Choice
from pkmodes.pages.report import shaper_measured
from pkmodes.pages.report.blocks import Cell, Column, Table
from pkmodes.pages.report.comparison import assess_differences, mode_difference_tables
from pkmodes.pages.report.diagnosis import verdict_headline
from pkmodes.pages.report.formatting import plural, rounded_cell, to_sentence, unit_cell, unit_text
from pkmodes.pages.report.numbers import error_blocks, fitted_value_tables
from pkmodes.pages.report.report_context import ReportContext
from pkmodes.pages.report.shaper import shapers_tables
from pkmodes.pages.report.shaper_schedule import schedule_blocks

Array = NDArray[np.float64]
#: Maximum number of rows of a table.
MAX_ROWS = 20


def modes_html(modes: Modes) -> str | None:
    """Return the frequencies of vibration at each pose; None where no frequencies were requested."""
    if "frequencies" not in modes.requested:
        return None
    titles: list[str] = []
    columns = []
    for field in (FIELDS[name] for name in modes.requested):
        if field.symbol:
            array = getattr(modes, field.name)
            vibrations = array.reshape(-1, array.shape[-1])[:, modes.rigid_modes :]
            units = field.units_of(modes.robot.mechanism)
            titles += [f"{field.symbol}{i + 1} [{units}]" for i in range(vibrations.shape[1])]
            columns.append(vibrations)
    caption = f"frequencies of vibration, {motors_in_words(modes.robot, modes.drives)}"
    return _pose_table_html(modes, caption, titles, np.hstack(columns), ".3f")


def statics_html(statics: Statics) -> str:
    """Return the torques and rotations that hold each pose against gravity."""
    mechanism = statics.robot.mechanism
    titles = [f"torque {drive.name} [{unit_text(drive.unit)}]" for drive in mechanism.drives]
    passive_coordinates = [
        coordinate for coordinate in mechanism.coordinates if coordinate.name not in mechanism.independent
    ]
    titles += [f"{coordinate.name} [{coordinate.unit}]" for coordinate in passive_coordinates]
    arrays = (statics.torques, statics.rotations)
    holding_values = np.hstack([array.reshape(-1, array.shape[-1]) for array in arrays])
    return _pose_table_html(statics, "what holds the pose against gravity", titles, holding_values, ".4g")


def _pose_table_html(
    result: Modes | Statics, caption: str, titles: Sequence[str], numbers: Array, form: str
) -> str:
    """Return a table with a row for each pose; instead of numbers, the reason why there are none."""
    robot = result.robot
    poses = result.poses.reshape(-1, result.poses.shape[-1])
    reasons = np.atleast_1d(result.reason).ravel()
    rows = []
    for point, row, reason in zip(poses[:MAX_ROWS], numbers[:MAX_ROWS], reasons[:MAX_ROWS], strict=True):
        cells = [str(reason)] * len(row) if reason else [format(value + 0.0, form) for value in row]
        rows.append([Cell(text) for text in (*(f"{value:.6g}" for value in point), *cells)])
    columns = [Column(f"{component.name} [{component.unit}]") for component in robot.mechanism.pose] + [
        *map(Column, titles)
    ]
    return _table_html(
        Table(f"{robot.name}: {caption}", columns, rows, note=_omitted_note(len(poses), "pose"))
    )


def robot_html(robot: Robot) -> str:
    """Return the declared values with their standard deviations, units and meanings."""
    columns = [Column("value", False), Column(""), Column("\u03c3"), Column("unit", False), Column("", False)]
    rows = [
        [
            Cell(path),
            rounded_cell(quantity.value),
            rounded_cell(quantity.sigma, 2),
            unit_cell(quantity.unit),
            Cell(meaning_of(robot.mechanism, path)),
        ]
        for path, quantity in list(robot.quantities.items())[:MAX_ROWS]
    ]
    omitted = _omitted_note(len(robot.quantities), "value")
    note = f"{omitted}: Robot.quantities" if omitted else ""
    return _table_html(Table(f"{robot.name}: {robot.mechanism.title}", columns, rows, note=note))


def move_html(move: Move) -> str:
    """Return the deviation of the platform from the commands to the motors, along each component."""
    rows = []
    for i, component in enumerate(move.robot.mechanism.pose):
        largest_index = int(np.argmax(np.abs(move.deviation[:, i])))
        ends = [f"{move.poses[k, i]:.6g} {component.unit}" for k in (0, -1)]
        largest = [f"{1e6 * move.deviation[largest_index, i] + 0.0:.4g}", f"{move.time[largest_index]:.6g}"]
        rows.append([Cell(text) for text in (component.name, *ends, *largest)])
    small_unit = "\u00b5m, \u00b5rad" if move.robot.mechanism.rotations else "\u00b5m"
    columns = [Column(title) for title in ("", "from", "to", f"largest deviation [{small_unit}]", "at [s]")]
    duration = move.time[-1] - move.time[0]
    note = (
        f"Largest distance {1e6 * move.largest():.4g} \u00b5m; {len(move.time):,} times in {duration:.6g} s."
    )
    motors = motors_in_words(move.robot, move.drives)
    return _table_html(Table(f"{move.robot.name}: a move, {motors}", columns, rows, note=note))


def shapers_html(choice: Choice) -> str:
    """Return the shapers that were compared, and what each leaves."""
    if isinstance(choice.ringing, MeasuredRinging):
        return _table_html(shaper_measured.shapers_table(choice))
    motors = f"<p>{escape(to_sentence(choice.ringing.motors))}</p>"
    return motors + "".join(map(_table_html, [*shapers_tables(choice), *schedule_blocks(choice)]))


def comparison_html(result: Comparison) -> str:
    """Return what the differences mean, and how far each mode is off."""
    headline, reason, _ = assess_differences(result)
    return _headline_html(headline, reason) + "".join(map(_table_html, mode_difference_tables(result)))


def diagnosis_html(result: Diagnosis) -> str:
    """Return what was found and why, the errors before and after, and the fitted values."""
    context = ReportContext("", None, None, (), None)
    tables = [
        block
        for block in (*error_blocks(result), *fitted_value_tables(result, context))
        if isinstance(block, Table)
    ]
    return _headline_html(verdict_headline(result), result.reason) + "".join(map(_table_html, tables))


def _headline_html(headline: str, reason: str) -> str:
    return f"<p><strong>{escape(headline)}.</strong> {escape(to_sentence(reason))}</p>"


def _omitted_note(count: int, noun: str) -> str:
    return f"{plural(count - MAX_ROWS, f'more {noun}')}" if count > MAX_ROWS else ""


def _table_html(table: Table) -> str:
    """Return a table as HTML, with the columns that a terminal shows."""
    column_indices = [k for k, column in enumerate(table.columns) if not column.page_only]

    def row_html(cells: Sequence[str], tag: str) -> str:
        alignments = ("" if table.columns[k].numeric else ' style="text-align:left"' for k in column_indices)
        tags = (f"<{tag}{style}>{text}</{tag}>" for style, text in zip(alignments, cells, strict=True))
        return f"<tr>{''.join(tags)}</tr>"

    def cell_html(cell: Cell) -> str:
        text = escape(cell.identifier or cell.text)
        return f"<strong>{text}</strong>" if cell.strong else text

    group_titles = "".join(f'<th colspan="{count}">{escape(title)}</th>' for title, count in table.groups)
    head = (f"<tr>{group_titles}</tr>" if group_titles else "") + row_html(
        [escape(table.columns[k].title) for k in column_indices], "th"
    )
    body = "".join(row_html([cell_html(cells[k]) for k in column_indices], "td") for cells in table.rows)
    note = f"<p>{escape(table.note)}</p>" if table.note else ""
    caption = f"<caption>{escape(table.caption)}</caption>"
    return f"<table>{caption}<thead>{head}</thead><tbody>{body}</tbody></table>{note}"
