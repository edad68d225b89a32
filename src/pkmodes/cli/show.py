"""``pkmodes show``: a page with the robot in three dimensions, moving in its modes."""

from __future__ import annotations

from pathlib import Path

import click

from pkmodes.cli.output import check_place, deliver, mechanism_option
from pkmodes.cli.poses import check_metres, parse_pose
from pkmodes.errors import OutputError
from pkmodes.loading import load
from pkmodes.writing import write_file


@click.command(
    epilog="\b\nExample:\n  pkmodes show robots/linear-delta-2022.toml --pose 0.6,0,-0.245 --out delta.html"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.option(
    "--pose",
    metavar="X,Y,...",
    default=None,
    help="The pose to show first, as for modes; by default one in the middle of the workspace.",
)
@click.option(
    "--out", metavar="FILE.html", default=None, help="The page; by default the robot file's name with .html."
)
@mechanism_option
def show(robot: Path, pose: str | None, out: str | None) -> None:
    """Write a page that shows the robot in three dimensions, moving in its modes.

    Choose a pose, a mode, amplitude and speed; belts and other springs have the colour of their share in the strain
    energy, which a table gives in numbers.  The page is one file and needs no network.
    """
    from pkmodes.view import page, poses_around, typical_pose

    target = f"{robot.stem}.html" if out is None else out
    check_place(target, "--out")
    if Path(target).exists() and robot.exists() and robot.samefile(target):
        raise OutputError("the page would replace its own input", f"--out {target}", "choose another file")
    model = load(robot)
    if pose is None:
        point = typical_pose(model).tolist()
    else:
        point = parse_pose(pose, model.kind)
        check_metres(model, pose, point)
    write_file(Path(target), page(poses_around(model, point)))
    with deliver([]):
        click.echo(target)
