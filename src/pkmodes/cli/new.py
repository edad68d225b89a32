"""``pkmodes new``: a commented robot file to begin with."""

from __future__ import annotations

from pathlib import Path

import click

from pkmodes.cli.delivery import files_to_write
from pkmodes.cli.options import PATH, forwarded_mechanism_option, overwrite_option
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import Target, check_targets
from pkmodes.core.mechanism import registry
from pkmodes.core.support.pasting import shell_path
from pkmodes.core.support.writing import write_file


@click.command(epilog=f"\b\nExample:\n  pkmodes new {registry.supplied_names()[0]} --out my-robot.toml")
@click.argument("name", metavar="[MECHANISM]", required=False)
@click.option("--out", metavar="FILE.toml", type=PATH, help="File to write instead of standard output.")
@overwrite_option
@forwarded_mechanism_option
def new(name: str | None, out: Path | None, overwrite: bool, mechanism: Path | None) -> None:
    """Write a robot file to start from: every key, its unit, and what to measure it with.

    The file is valid as it stands: its values are those of an example, to be replaced by those of your robot.
    Optional keys are commented out.  Without MECHANISM the command lists the mechanisms.
    """
    check_targets(None, [], Target("--out", out, "the robot file", (".toml",)))
    if name is None:
        for mechanism_name in registry.names():
            echo(f"{mechanism_name}: {registry.mechanism(mechanism_name).title}")
        return
    from pkmodes.core.model import Model
    from pkmodes.core.robot.reading import robot_from_document
    from pkmodes.loop.robot_files.template import example_document, template
    from pkmodes.pages.view import typical_pose

    mechanism_description = registry.mechanism(name)
    robot = robot_from_document(example_document(mechanism_description), mechanism_description.name)
    # The commands in the head of the file have a pose that the example reaches.
    pose = ",".join(f"{component:g}" for component in typical_pose(Model(robot)).tolist())
    folder = "" if mechanism is None else " --mechanism FOLDER"
    commands = [f"pkmodes modes FILE --pose {pose}{folder}", f"pkmodes show FILE{folder}"]
    text = template(mechanism_description, commands)
    if out is None:
        click.echo(text, nl=False)
        return
    if files_to_write(out.parent, {out.name: text}, "--out", overwrite):
        write_file(out, text)
    option = "" if mechanism is None else f" --mechanism {shell_path(mechanism)}"
    echo(f"wrote {out}; next: pkmodes show {shell_path(out)}{option}")
