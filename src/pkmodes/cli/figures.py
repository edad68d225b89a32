"""``pkmodes figures``: pictures of the workspace, the frequencies, and what they depend on."""

from __future__ import annotations

from pathlib import Path

import click

from pkmodes.base.errors import OutputError, shown
from pkmodes.cli.output import (
    check_target,
    deliver,
    json_option,
    mechanism_option,
    named_as_options,
    to_file,
    write_json,
)
from pkmodes.model.loading import load


@click.command(epilog="\b\nExample:\n  pkmodes figures robots/linear-delta-2022.toml --out figures")
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.option("--out", metavar="DIR", required=True, help="Folder to write to; created if it does not exist.")
@click.option(
    "--grid",
    metavar="X=START:STOP:COUNT,...",
    default=None,
    help="The plane: two components of the pose as start:stop:count, the others as one value.  By default the plane "
    "of the workspace with the lowest mean condition number.",
)
@click.option(
    "--format",
    "formats",
    type=click.Choice(["svg", "png", "pdf"]),
    multiple=True,
    default=["svg"],
    show_default=True,
    help="Repeat it for several.",
)
@mechanism_option
@json_option
def figures(robot: Path, out: str, grid: str | None, formats: tuple[str, ...], json_file: str | None) -> None:
    """Draw the working plane, frequencies, directions of motion, and the influence of parameters."""
    check_target(json_file, robot)
    folder = Path(out)
    if not out or "\0" in out or (folder.exists() and not folder.is_dir()):
        raise OutputError("expected the name of a folder", f"--out {shown(out)}", "choose another place")
    model = load(robot)
    from pkmodes.figures.files import write_pictures
    from pkmodes.maps.ranges import parse_grid

    places = None if grid is None else parse_grid(grid, model.mechanism, "--grid")
    with named_as_options({"grid": "--grid"}):
        written = write_pictures(model, folder, places, tuple(dict.fromkeys(formats)))
    content = {"robot": str(robot), "out": out, "files": [path.name for path in written]}
    with deliver(to_file(json_file, content)):
        if json_file == "-":
            write_json(json_file, content)
        else:
            click.echo("\n".join(map(str, written)))
