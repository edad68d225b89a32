"""``pkmodes generate``: write a model specialised to one robot."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import click
from msgspec import Meta

from pkmodes.cli.delivery import deliver
from pkmodes.cli.options import PATH, json_option, robot_argument
from pkmodes.cli.printing import echo
from pkmodes.cli.targets import check_targets
from pkmodes.core.base.errors import OutputError
from pkmodes.core.support.documents import Document
from pkmodes.core.support.progress import report_progress


class GenerateDocument(Document, frozen=True):
    """The files of a model."""

    robot: Annotated[str, Meta(description="The robot file, as given.")]
    out: Annotated[str, Meta(description="The folder of the model, as given.")]
    files: Annotated[
        list[str],
        Meta(
            description="Names of the files written there; for your own mechanism, the files in its folder."
        ),
    ]


@click.command(
    epilog="\b\nExample:\n  pkmodes generate robots/linear-delta-2022.toml --out build/linear-delta-2022"
)
@robot_argument
@click.option(
    "--out",
    metavar="DIR",
    required=True,
    help="Output folder: new, empty, or with this robot's previous model.",
)
@click.option(
    "--mechanism",
    metavar="FILE.py",
    type=PATH,
    help="A mechanism of your own: the Python file that defines it, or the folder that was generated from it.",
)
@click.option(
    "--effect",
    "effects",
    metavar="FILE.py",
    type=PATH,
    multiple=True,
    help="An effect of your own beside those of the catalogue: a file of diagnose --save-effect, or as in "
    "docs/how-to/adding-an-effect.md; may be repeated.",
)
@json_option
def generate(
    robot: Path, out: str, mechanism: Path | None, effects: tuple[Path, ...], json_file: str | None
) -> None:
    """Derive and write a model specialised to one robot.

    The output is a NumPy module, a C99 source with its header, and a manifest.  The module needs only NumPy and the C
    source only a compiler, so both can be vendored.  For a robot with effects there is a second set of these files,
    without the effects.  Other files in the folder are not touched.

    A mechanism of your own is defined by a Python file (docs/how-to/adding-a-mechanism.md).  Its code is written to
    the folder DIR/<name>, which the other commands accept as --mechanism DIR/<name>; so is the code of a supplied
    mechanism with an effect of your own.
    """
    from pkmodes.codegen.generation import generate as generate_model

    check_targets(json_file, [robot, mechanism, *effects])
    if not out.strip():
        raise OutputError("expected a folder, found an empty name", "--out", "name a folder for the model")
    report_progress("deriving the model")
    written = generate_model(robot, Path(out), mechanism, effects)
    files = [path.relative_to(out).as_posix() for path in written]
    document = GenerateDocument(robot=str(robot), out=str(Path(out)), files=files)
    deliver(json_file, document.as_json(), lambda: list(map(echo, written)))
