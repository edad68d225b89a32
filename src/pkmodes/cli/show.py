"""``pkmodes show``: a page with the robot in three dimensions, moving in its modes.

``--vary`` takes ranges, such as ``platform.mass=0.5:3,effects.payload.mass=0:2 kg:9``.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import click
import numpy as np
from msgspec import Meta
from numpy.typing import NDArray

from pkmodes.api import load
from pkmodes.cli.delivery import ResultFile, deliver
from pkmodes.cli.options import (
    drives_option,
    json_option,
    mechanism_option,
    overwrite_option,
    rename_arguments_in_errors,
    robot_argument,
)
from pkmodes.cli.poses import parse_pose_option
from pkmodes.cli.targets import Target, check_targets
from pkmodes.core.base.errors import PkmodesError, nearest_name, shown
from pkmodes.core.support.documents import Document
from pkmodes.core.support.progress import report_progress
from pkmodes.core.support.replacing import check_replaced, contains_mark

if TYPE_CHECKING:
    from pkmodes.core.robot.robot import Robot

VARY_OPTION = "--vary"
VARY_EXAMPLE = f"for example: {VARY_OPTION} platform.mass=0.5:3,effects.payload.mass=0:2"


class ShowDocument(Document, frozen=True):
    """The page of a robot."""

    robot: Annotated[str, Meta(description="The robot file, as given.")]
    out: Annotated[str, Meta(description="The page, or the moving picture.")]
    pose: Annotated[list[float], Meta(description="The pose shown first, in SI units.")]


@click.command(
    epilog="\b\nExample:\n  pkmodes show robots/linear-delta-2022.toml \\\n    --pose 0.6,0,-0.245 --out delta.html"
)
@robot_argument
@click.option(
    "--pose",
    metavar="X,Y,...",
    help="The pose to show first, as for modes; by default one in the middle of the workspace.",
)
@click.option(
    "--out",
    metavar="FILE.html",
    help="Page to write, or FILE.gif for a moving picture of one mode; an existing file is replaced.  By default "
    "the robot file's name with .html, which replaces only a page of this command.",
)
@overwrite_option
@click.option("--mode", metavar="N", type=click.IntRange(1), help="Vibration mode of FILE.gif, by default 1.")
@click.option(
    VARY_OPTION,
    "vary",
    metavar="PATH=START:STOP,...",
    help="Sliders for up to three parameters or effects instead of the pose, which stays at --pose: start:stop, "
    "or start:stop:count, in SI units or with units.",
)
@drives_option
@mechanism_option
@json_option
def show(
    robot: Path,
    pose: str | None,
    out: str | None,
    overwrite: bool,
    mode: int | None,
    vary: str | None,
    drives: str,
    json_file: str | None,
) -> None:
    """Write a page that shows the robot in three dimensions, moving in its modes.

    The page has controls for pose, mode, amplitude and speed; belts and other springs are coloured by their share of
    the strain energy, and a table gives the numbers.  The page is one file and needs no network.  With --vary,
    sliders change values of the robot, and thin lines show it as declared.
    """
    from pkmodes.pages.view import page, poses_around, typical_pose, varied
    from pkmodes.pages.view import scene as scene_of
    from pkmodes.pages.view.page import PAGE_MARK

    output_name = f"{robot.stem}.html" if out is None else out
    check_targets(json_file, [robot], Target("--out", output_name, "the page", (".html", ".gif")))
    if out is None:
        problem = "the file exists, and is not a page of pkmodes show"
        remedy = "name the page with --out FILE.html, or replace what is there with --overwrite"
        check_replaced(
            [Path(output_name)], "--out", overwrite, contains_mark(PAGE_MARK), what=problem, remedy=remedy
        )
    is_gif = Path(output_name).suffix.lower() == ".gif"
    if mode is not None and not is_gif:
        remedy = "choose the mode on the page, or name FILE.gif"
        raise PkmodesError("only a moving picture has one mode", f"--mode {mode}", remedy)
    if vary is not None and is_gif:
        raise PkmodesError("a moving picture has no sliders", VARY_OPTION, "name FILE.html")
    model = load(robot)
    ranges = None if vary is None else parse_vary(vary, model.robot)
    shown_pose = typical_pose(model).tolist() if pose is None else parse_pose_option(model, pose)
    report_progress("drawing the moving picture" if is_gif else "computing the modes over the workspace")
    if is_gif:
        from pkmodes.pages.plots.animation import animation

        scene, mode = scene_of(model, shown_pose, drives=drives), mode or 1
        if scene.rigid_modes + mode > scene.shapes.shape[1]:
            highest_mode = scene.shapes.shape[1] - scene.rigid_modes
            raise PkmodesError(
                f"expected a vibration mode up to {highest_mode}, found {mode}", "--mode", "choose another"
            )
        content: str | bytes = animation(scene, scene.rigid_modes + mode - 1)
    elif ranges is not None:
        with rename_arguments_in_errors(values=VARY_OPTION):
            content = page(varied(model, shown_pose, ranges, drives=drives))
    else:
        content = page(poses_around(model, shown_pose, drives=drives))
    document = ShowDocument(robot=str(robot), out=output_name, pose=shown_pose)
    lines = () if json_file == "-" else (output_name,)
    deliver(
        json_file,
        document.as_json(),
        lambda: None,
        ResultFile(Path(output_name), lambda: content, lambda _: lines),
    )


def parse_vary(text: str, robot: Robot) -> dict[str, NDArray[np.float64]]:
    """Read the ranges of the option.

    - robot: defines the paths and their units

    Returns values in SI units by path, in the order given.
    Raises PkmodesError if a path is unknown or repeated, a range is invalid, or there are too many.
    """
    from pkmodes.core.robot.declaration import changeable_units
    from pkmodes.machine.maps.ranges import parse_range
    from pkmodes.pages.view.varying import DEFAULT_COUNTS, MAX_PARAMETERS

    parts = [part.strip() for part in text.split(",")]
    if len(parts) > MAX_PARAMETERS:
        problem = f"expected at most {MAX_PARAMETERS} parameters, found {len(parts)}"
        raise PkmodesError(problem, VARY_OPTION, "vary the others on another page")
    units, ranges = changeable_units(robot), dict[str, NDArray[np.float64]]()
    for part in parts:
        path, equals, range_text = (piece.strip() for piece in part.partition("="))
        if not equals or not path or not range_text:
            raise PkmodesError(f"expected PATH=START:STOP, found {shown(part)}", VARY_OPTION, VARY_EXAMPLE)
        if path not in units:
            remedy = nearest_name(path, units, "see docs/reference/parameter-paths.md for the paths")
            raise PkmodesError(f"unknown parameter path {shown(path)}", VARY_OPTION, remedy)
        if path in ranges:
            raise PkmodesError(f"{path} is given twice", VARY_OPTION, "give its range once")
        if range_text.count(":") not in (1, 2):
            problem = f"expected start:stop or start:stop:count, found {shown(range_text)}"
            raise PkmodesError(problem, f"{VARY_OPTION} {path}", VARY_EXAMPLE)
        start, stop, *count = (piece.strip() for piece in range_text.split(":"))
        if start == stop or count == ["1"]:
            problem = f"a slider needs several values, found {shown(range_text)}"
            raise PkmodesError(
                problem, f"{VARY_OPTION} {path}", "give two different ends and a count of at least 2, or none"
            )
        full_range = (
            range_text if range_text.count(":") == 2 else f"{range_text}:{DEFAULT_COUNTS[len(parts)]}"
        )
        ranges[path] = parse_range(full_range, units[path], f"{VARY_OPTION} {path}")
    return ranges
