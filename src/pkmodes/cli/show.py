"""``pkmodes show``: a page with the robot in three dimensions, moving in its modes."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import drives_option, json_option, mechanism_option, named_as_options
from pkmodes.cli.poses import check_metres, parse_pose
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import Target, check_targets
from pkmodes.cli.varying import OPTION, parse_vary, vary_option
from pkmodes.core.base.errors import PkmodesError
from pkmodes.support.documents import Document
from pkmodes.support.progress import say
from pkmodes.support.writing import write_file


class ShowDocument(Document, frozen=True):
    """The page of a robot."""

    robot: Annotated[str, Meta(description="The robot file, as given.")]
    out: Annotated[str, Meta(description="The page, or the moving picture.")]
    pose: Annotated[list[float], Meta(description="The pose shown first, in SI units.")]


@click.command(
    epilog="\b\nExample:\n  pkmodes show robots/linear-delta-2022.toml \\\n"
    "    --pose 0.6,0,-0.245 --out delta.html"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.option(
    "--pose",
    metavar="X,Y,...",
    default=None,
    help="The pose to show first, as for modes; by default one in the middle of the workspace.",
)
@click.option(
    "--out",
    metavar="FILE.html",
    default=None,
    help="The page, by default the robot file's name with .html; or FILE.gif, a moving picture of one mode.",
)
@click.option(
    "--mode",
    metavar="N",
    type=click.IntRange(1),
    default=None,
    help="Vibration mode of FILE.gif, by default 1.",
)
@vary_option
@drives_option
@mechanism_option
@json_option
def show(
    robot: Path,
    pose: str | None,
    out: str | None,
    mode: int | None,
    vary: str | None,
    drives: str,
    json_file: str | None,
) -> None:
    """Write a page that shows the robot in three dimensions, moving in its modes.

    Choose a pose, a mode, amplitude and speed; belts and other springs are coloured by their share of the
    strain energy; a table gives the numbers.  The page is one file and needs no network.  With --vary, sliders
    change values of the robot, beside thin lines of the robot as declared.
    """
    from pkmodes.view import page, poses_around, typical_pose, varied
    from pkmodes.view import scene as scene_of

    target = f"{robot.stem}.html" if out is None else out
    check_targets(json_file, [robot], Target("--out", target, "the page", (".html", ".gif")))
    moving = Path(target).suffix.lower() == ".gif"
    if mode is not None and not moving:
        remedy = "choose the mode on the page, or name FILE.gif"
        raise PkmodesError("only a moving picture has one mode", f"--mode {mode}", remedy)
    if vary is not None and moving:
        raise PkmodesError("a moving picture has no sliders", OPTION, "name FILE.html")
    model = load(robot)
    ranges = None if vary is None else parse_vary(vary, model.robot)
    if pose is None:
        point = typical_pose(model).tolist()
    else:
        point = parse_pose(pose, model.mechanism)
        check_metres(model, pose, point)
    say("drawing the moving picture" if moving else "computing the modes over the workspace")
    if moving:
        from pkmodes.plots.animation import animation

        one, mode = scene_of(model, point, drives=drives), mode or 1
        if one.rigid_modes + mode > one.shapes.shape[1]:
            known = one.shapes.shape[1] - one.rigid_modes
            raise PkmodesError(
                f"expected a vibration mode up to {known}, found {mode}", "--mode", "choose another"
            )
        write_file(Path(target), animation(one, one.rigid_modes + mode - 1))
    elif ranges is not None:
        with named_as_options({"values": OPTION}):
            write_file(Path(target), page(varied(model, point, ranges, drives=drives)))
    else:
        write_file(Path(target), page(poses_around(model, point, drives=drives)))
    document = ShowDocument(robot=str(robot), out=target, pose=point)
    deliver(json_file, document.as_json(), lambda: echo(target))
