"""Print what changed between states on the terminal."""

from __future__ import annotations

from pkmodes.cli import diagnosis_tables
from pkmodes.cli.terminal import Terminal
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.diagnosis.states.result import Change
from pkmodes.pages.report.changed import changes, changes_summary, what_to_do
from pkmodes.pages.report.numbers import errors
from pkmodes.pages.report.setting import ReportSetting


def show_changes(robot: Robot, result: Change, limit: int | None) -> None:
    """Print what changed.

    - limit: modes that are printed, those that changed most; None for all
    """
    terminal, setting = Terminal(), ReportSetting(robot.name, robot, None, (), None)
    head = changes_summary(result, setting)
    terminal.summary(head)
    for name, change in result.by_state.items() or [(result.states[-1], result)]:
        if result.by_state:
            terminal.line()
            terminal.line(f"{name}:")
            terminal.line(change.reason, "  ")
        terminal.show(what_to_do(change, setting))
        diagnosis_tables.show_causes(terminal, change, setting)
        terminal.show(changes(change, limit))
    terminal.show(*errors(result))
    terminal.notes(head)
