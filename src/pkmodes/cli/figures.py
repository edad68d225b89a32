"""``pkmodes figures``: pictures of the workspace, the frequencies, and what they depend on."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta

from pkmodes.api import load
from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import (
    drives_option,
    json_option,
    mechanism_option,
    overwrite_option,
    rename_arguments_in_errors,
    robot_argument,
)
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import check_targets
from pkmodes.cli.terminal import Terminal
from pkmodes.core.base.errors import OutputError, shown
from pkmodes.core.support.documents import Document
from pkmodes.core.support.places import resolve_path


class FiguresDocument(Document, frozen=True):
    """The files of the figures."""

    robot: Annotated[str, Meta(description="The robot file, as given.")]
    out: Annotated[str, Meta(description="The folder of the figures, as given.")]
    files: Annotated[list[str], Meta(description="Names of the files written there.")]
    same_everywhere: Annotated[
        dict[str, str],
        Meta(
            description="What is said instead of a figure that would show the same everywhere, by the name that its "
            "file would have without suffix; there is no such file."
        ),
    ]


@click.command(epilog="\b\nExample:\n  pkmodes figures robots/linear-delta-2022.toml --out figures")
@robot_argument
@click.option("--out", metavar="DIR", required=True, help="Folder to write to; created if it does not exist.")
@click.option(
    "--grid",
    metavar="X=START:STOP:COUNT,...",
    help="The plane: two components of the pose as start:stop:count, the others as one value.  By default the "
    "plane of the workspace with the lowest mean condition number.",
)
@click.option(
    "--format",
    "formats",
    type=click.Choice(["svg", "png", "pdf"]),
    multiple=True,
    default=["svg"],
    show_default=True,
    help="Format of the pictures; may be repeated.",
)
@overwrite_option
@drives_option
@mechanism_option
@json_option
def figures(
    robot: Path,
    out: str,
    grid: str | None,
    formats: tuple[str, ...],
    overwrite: bool,
    drives: str,
    json_file: str | None,
) -> None:
    """Draw the working plane, frequencies, directions of motion, and the influence of parameters."""
    check_targets(json_file, [robot])
    folder = Path(out)
    if not out or "\0" in out or (folder.exists() and not folder.is_dir()):
        raise OutputError("expected the name of a folder", f"--out {shown(out)}", "choose another place")
    resolve_path(folder, "--out")
    model = load(robot)
    from pkmodes.machine.maps.ranges import parse_grid
    from pkmodes.pages.figures.files import write_pictures_and_sentences

    grid_axes = None if grid is None else parse_grid(grid, model.mechanism, "--grid")
    with rename_arguments_in_errors("grid", folder="--out"):
        written, sentences = write_pictures_and_sentences(
            model, folder, grid_axes, tuple(dict.fromkeys(formats)), drives=drives, overwrite=overwrite
        )
    document = FiguresDocument(
        robot=str(robot), out=out, files=[path.name for path in written], same_everywhere=sentences
    )

    def show() -> None:
        for path in written:
            echo(path)
        for name, sentence in sentences.items():
            for line in Terminal().wrap(f"note: {name} is not drawn: {sentence}"):
                echo(line, err=True)

    deliver(json_file, document.as_json(), show)
