"""``pkmodes changed``: find what changed on a robot since a trusted campaign of measured modes."""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

import click

from pkmodes.cli.delivery import deliver
from pkmodes.cli.diagnosing import parse_verdicts, progress_lines, split_names
from pkmodes.cli.options import (
    PATH,
    band_option,
    check_file_order,
    json_option,
    measured_drives_option,
    mechanism_option,
    parse_band_option,
    rename_arguments_in_errors,
    report_option,
    robot_argument,
)
from pkmodes.cli.reporting import page_of, report_file, sources_of
from pkmodes.cli.targets import check_targets, report_target
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.robot.reading import read_robot

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot
    from pkmodes.loop.measured.measurements import Measurements

#: Maximum number of modes printed without ``--all``.
MAX_MODES_PRINTED = 10


@click.command(
    epilog="\b\nExample:\n"
    "  pkmodes changed examples/changed_printer/robot.toml \\\n    examples/changed_printer/before.csv "
    "examples/changed_printer/after.csv"
)
@robot_argument
@click.argument("states", metavar="TRUSTED.csv LATER.csv...", type=PATH, nargs=-1, required=True)
@click.option(
    "--candidates",
    metavar="NAMES",
    help="What may have changed, separated by commas, as for diagnose; by default everything.",
)
@click.option(
    "--holdout",
    metavar="POSES",
    help="Labels of poses of the later files to exclude from all fits, separated by commas, or the word none; by "
    "default one pose in six.",
)
@report_option
@click.option(
    "--no-beyond",
    "no_beyond",
    is_flag=True,
    help="Do not search beyond the candidates for one thing at one place, such as a mass on one body.",
)
@click.option(
    "--fail-on",
    "fail_on",
    metavar="VERDICTS",
    help="Verdicts that give exit code 1, separated by commas, or the word any for all except adequate; by "
    "default no verdict.",
)
@click.option(
    "--all",
    "everything",
    is_flag=True,
    help="Print every measured mode, not only those that changed most.",
)
@band_option
@measured_drives_option
@mechanism_option
@json_option
def changed(
    robot: Path,
    states: tuple[Path, ...],
    candidates: str | None,
    holdout: str | None,
    report_to: Path | None,
    no_beyond: bool,
    fail_on: str | None,
    everything: bool,
    band: str | None,
    drives: str | None,
    json_file: str | None,
) -> int:
    """Find what changed on a machine since a trusted measurement, such as before and after a repair.

    Each file has the modes of one state of the machine, the first file those of the trusted state; a file may have
    several states, named in a column "state".  The error of the model in the trusted state is subtracted from the
    other states, so that differences are compared with differences.  The result states whether anything changed, and
    what, with a value and its uncertainty, or that the data cannot tell.

    Uncertain values are those of the trusted state.  The stiffness that all belts, legs or reducers share may differ
    by some 1.5 % from one day to the next, which does not count as a change.  The exit code is 0 for any verdict
    except those in --fail-on, which give 1, and 2 for bad input.
    """
    for file in states:
        check_file_order(robot, file, "pkmodes changed")
    check_targets(json_file, [robot, *states], report_target(report_to))
    candidate_names = None if candidates is None else split_names(candidates, "--candidates")
    held_out = (
        None if holdout is None else [] if holdout.strip() == "none" else split_names(holdout, "--holdout")
    )
    failing_verdicts = frozenset() if fail_on is None else parse_verdicts(split_names(fail_on, "--fail-on"))
    from pkmodes.loop import updating  # SciPy is loaded only where it is used

    declared_robot = read_robot(robot)
    campaigns = _campaigns(states, declared_robot, parse_band_option(band), drives)
    sources = sources_of(
        report_to,
        {"robot file": robot, **{f"measurement file {i}": file for i, file in enumerate(states, start=1)}},
    )
    trusted_state, *later_states = campaigns
    with progress_lines("changed") as progress, rename_arguments_in_errors("candidates", "holdout"):
        result = updating.changed(
            declared_robot,
            campaigns[trusted_state],
            {name: campaigns[name] for name in later_states},
            candidates=candidate_names,
            holdout=held_out,
            progress=progress,
            terms=not no_beyond,
            name=trusted_state,
        )
    data = campaigns[later_states[0]]
    report = report_file(report_to, lambda: page_of(result, declared_robot, data, sources))

    def show() -> None:
        from pkmodes.cli.diagnosis_tables import show_causes
        from pkmodes.cli.terminal import Terminal
        from pkmodes.pages.report.changed import action_after_change, change_summary, mode_changes_table
        from pkmodes.pages.report.numbers import error_blocks
        from pkmodes.pages.report.report_context import ReportContext

        terminal, context = Terminal(), ReportContext(declared_robot.name, declared_robot, None, (), None)
        summary = change_summary(result, context)
        terminal.summary(summary)
        for name, change in result.by_state.items() or [(result.states[-1], result)]:
            if result.by_state:
                terminal.line()
                terminal.line(f"{name}:")
                terminal.line(change.reason, "  ")
            terminal.show(action_after_change(change, context))
            show_causes(terminal, change, context)
            terminal.show(mode_changes_table(change, None if everything else MAX_MODES_PRINTED))
        terminal.show(*error_blocks(result))
        terminal.notes(summary)

    deliver(json_file, result.as_json(), show, report)
    return 1 if result.verdict in failing_verdicts else 0


def _campaigns(
    files: tuple[Path, ...], robot: Robot, band: tuple[float, float] | None, drives: str | None
) -> dict[str, Measurements]:
    """Return the campaigns of all files by state; a state without a name has that of its file.

    Raises PkmodesError if two have the same name, or there is only one.
    """
    from pkmodes.loop.updating.reading import read_states

    campaigns: dict[str, Measurements] = {}
    for file in files:
        for state, data in read_states(file, band, robot, drives=drives).items():
            name = state or file.stem
            if name in campaigns:
                problem = f"two states are called {shown(name)}: in {campaigns[name].source} and in {file}"
                raise PkmodesError(problem, "pkmodes changed", 'name them in the files: "# state: before"')
            campaigns[name] = data
    if len(campaigns) < 2:
        problem = f"expected two states or more, found {shown(next(iter(campaigns)))} only"
        remedy = "give the measurement of another state after it: TRUSTED.csv LATER.csv"
        raise PkmodesError(problem, str(files[0]), remedy)
    return campaigns
