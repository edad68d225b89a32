"""Print what changed between states on the terminal."""

from __future__ import annotations

from pkmodes.cli import diagnosis_tables
from pkmodes.cli.terminal import Terminal
from pkmodes.core.robot.robot import Robot
from pkmodes.diagnosis.states.result import Change
from pkmodes.report.changed import changes, changes_summary, what_to_do
from pkmodes.report.numbers import errors
from pkmodes.report.setting import ReportSetting


def show_changes(robot: Robot, result: Change, most: int | None) -> None:
    """Print what changed.

    Parameters
    ----------
    most : int or None
        Modes that are printed, those that changed most; None for all.
    """
    terminal, setting = Terminal(), ReportSetting(robot.name, robot, None, (), None)
    head = changes_summary(result, setting)
    terminal.summary(head)
    for name, one in result.by_state.items() or [(result.states[-1], result)]:
        if result.by_state:
            terminal.line()
            terminal.line(f"{name}:")
            terminal.line(one.reason, "  ")
        terminal.show(what_to_do(one, setting))
        diagnosis_tables.show_causes(terminal, one, setting)
        terminal.show(changes(one, most))
    terminal.show(*errors(result))
    terminal.notes(head)
