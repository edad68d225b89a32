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
from pkmodes.pages.report.comparison import by_mode, judged
from pkmodes.pages.report.diagnosis import verdict_headline
from pkmodes.pages.report.formatting import figures, plural, sentence, unit, unit_cell
from pkmodes.pages.report.numbers import errors, fitted_value_tables
from pkmodes.pages.report.setting import ReportSetting
from pkmodes.pages.report.shaper import shapers_tables
from pkmodes.pages.report.shaper_schedule import schedule_blocks

Array = NDArray[np.float64]
#: Most rows of a table.
ROWS = 20


def of_modes(modes: Modes) -> str | None:
    """Return the frequencies of vibration at each pose; None where no frequencies were requested."""
    if "frequencies" not in modes.requested:
        return None
    titles: list[str] = []
    columns = []
    for entry in (FIELDS[name] for name in modes.requested):
        if entry.symbol:
            array = getattr(modes, entry.name)
            vibrations = array.reshape(-1, array.shape[-1])[:, modes.rigid_modes :]
            units = entry.units_of(modes.robot.mechanism)
            titles += [f"{entry.symbol}{i + 1} [{units}]" for i in range(vibrations.shape[1])]
            columns.append(vibrations)
    caption = f"frequencies of vibration, {motors_in_words(modes.robot, modes.drives)}"
    return _at_poses(modes, caption, titles, np.hstack(columns), ".3f")


def of_statics(statics: Statics) -> str:
    """Return the torques and rotations that hold each pose against gravity."""
    mechanism = statics.robot.mechanism
    titles = [f"torque {drive.name} [{unit(drive.unit)}]" for drive in mechanism.drives]
    rest = [
        coordinate for coordinate in mechanism.coordinates if coordinate.name not in mechanism.independent
    ]
    titles += [f"{coordinate.name} [{coordinate.unit}]" for coordinate in rest]
    arrays = (statics.torques, statics.rotations)
    holding = np.hstack([array.reshape(-1, array.shape[-1]) for array in arrays])
    return _at_poses(statics, "what holds the pose against gravity", titles, holding, ".4g")


def _at_poses(result: Modes | Statics, caption: str, titles: Sequence[str], numbers: Array, form: str) -> str:
    """Return a table with a row for each pose; instead of numbers, the reason why there are none."""
    robot = result.robot
    poses = result.poses.reshape(-1, result.poses.shape[-1])
    reasons = np.atleast_1d(result.reason).ravel()
    rows = []
    for point, row, reason in zip(poses[:ROWS], numbers[:ROWS], reasons[:ROWS], strict=True):
        cells = [str(reason)] * len(row) if reason else [format(value + 0.0, form) for value in row]
        rows.append([Cell(text) for text in (*(f"{value:.6g}" for value in point), *cells)])
    columns = [Column(f"{c.name} [{c.unit}]") for c in robot.mechanism.pose] + [*map(Column, titles)]
    return _html(Table(f"{robot.name}: {caption}", columns, rows, note=_omitted(len(poses), "pose")))


def of_robot(robot: Robot) -> str:
    """Return the declared values with their standard deviations, units and meanings."""
    columns = [Column("value", False), Column(""), Column("\u03c3"), Column("unit", False), Column("", False)]
    rows = [
        [
            Cell(path),
            figures(quantity.value),
            figures(quantity.sigma, 2),
            unit_cell(quantity.unit),
            Cell(meaning_of(robot.mechanism, path)),
        ]
        for path, quantity in list(robot.quantities.items())[:ROWS]
    ]
    omitted = _omitted(len(robot.quantities), "value")
    note = f"{omitted}: Robot.quantities" if omitted else ""
    return _html(Table(f"{robot.name}: {robot.mechanism.title}", columns, rows, note=note))


def of_move(move: Move) -> str:
    """Return the deviation of the platform from the commands to the motors, along each component."""
    rows = []
    for i, component in enumerate(move.robot.mechanism.pose):
        at = int(np.argmax(np.abs(move.deviation[:, i])))
        ends = [f"{move.poses[k, i]:.6g} {component.unit}" for k in (0, -1)]
        largest = [f"{1e6 * move.deviation[at, i] + 0.0:.4g}", f"{move.time[at]:.6g}"]
        rows.append([Cell(text) for text in (component.name, *ends, *largest)])
    small = "\u00b5m, \u00b5rad" if move.robot.mechanism.rotations else "\u00b5m"
    columns = [Column(title) for title in ("", "from", "to", f"largest deviation [{small}]", "at [s]")]
    lasts = move.time[-1] - move.time[0]
    note = f"Largest distance {1e6 * move.largest():.4g} \u00b5m; {len(move.time):,} times in {lasts:.6g} s."
    doing = motors_in_words(move.robot, move.drives)
    return _html(Table(f"{move.robot.name}: a move, {doing}", columns, rows, note=note))


def of_shapers(choice: Choice) -> str:
    """Return the shapers that were compared, and what each leaves."""
    if isinstance(choice.ringing, MeasuredRinging):
        return _html(shaper_measured.shapers_table(choice))
    doing = f"<p>{escape(sentence(choice.ringing.motors))}</p>"
    return doing + "".join(map(_html, [*shapers_tables(choice), *schedule_blocks(choice)]))


def of_comparison(result: Comparison) -> str:
    """Return what the differences mean, and how far each mode is off."""
    headline, reason, _ = judged(result)
    return _words(headline, reason) + "".join(map(_html, by_mode(result)))


def of_diagnosis(result: Diagnosis) -> str:
    """Return what was found and why, the errors before and after, and the fitted values."""
    setting = ReportSetting("", None, None, (), None)
    tables = [
        block
        for block in (*errors(result), *fitted_value_tables(result, setting))
        if isinstance(block, Table)
    ]
    return _words(verdict_headline(result), result.reason) + "".join(map(_html, tables))


def _words(strong: str, reason: str) -> str:
    return f"<p><strong>{escape(strong)}.</strong> {escape(sentence(reason))}</p>"


def _omitted(count: int, noun: str) -> str:
    return f"{plural(count - ROWS, f'more {noun}')}" if count > ROWS else ""


def _html(table: Table) -> str:
    """Return a table as HTML, with the columns that a terminal shows."""
    kept = [k for k, column in enumerate(table.columns) if not column.page_only]

    def row(cells: Sequence[str], tag: str) -> str:
        alignments = ("" if table.columns[k].numbers else ' style="text-align:left"' for k in kept)
        tags = (f"<{tag}{style}>{text}</{tag}>" for style, text in zip(alignments, cells, strict=True))
        return f"<tr>{''.join(tags)}</tr>"

    def shown(cell: Cell) -> str:
        text = escape(cell.name or cell.text)
        return f"<strong>{text}</strong>" if cell.strong else text

    over = "".join(f'<th colspan="{count}">{escape(title)}</th>' for title, count in table.groups)
    head = (f"<tr>{over}</tr>" if over else "") + row([escape(table.columns[k].title) for k in kept], "th")
    body = "".join(row([shown(cells[k]) for k in kept], "td") for cells in table.rows)
    note = f"<p>{escape(table.note)}</p>" if table.note else ""
    caption = f"<caption>{escape(table.caption)}</caption>"
    return f"<table>{caption}<thead>{head}</thead><tbody>{body}</tbody></table>{note}"
