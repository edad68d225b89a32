"""``pkmodes generate``: a model specialised to one robot."""

from __future__ import annotations

from pathlib import Path

import click

from pkmodes.cli.output import check_target, deliver, json_option, to_file, write_json
from pkmodes.errors import OutputError


@click.command(
    epilog="\b\nExample:\n  pkmodes generate robots/linear-delta-2022.toml --out build/linear-delta-2022"
)
@click.argument("robot", metavar="ROBOT.toml", type=click.Path(path_type=Path))
@click.option(
    "--out", metavar="DIR", required=True, help="Folder of the model: a new or empty one, or the model's own."
)
@click.option(
    "--mechanism",
    metavar="FILE.py",
    type=click.Path(path_type=Path),
    help="A mechanism of your own: the Python file that defines it, or the folder that was generated from it.",
)
@json_option
def generate(robot: Path, out: str, mechanism: Path | None, json_file: str | None) -> None:
    """Derive and write a model specialised to one robot.

    The folder gets a NumPy module, a C99 source with its header, and a manifest.  The module needs only
    NumPy and the C source only a compiler: both can be vendored.  Files of your own beside them are left alone.

    A mechanism of your own is a Python file (docs/adding-a-mechanism.md).  Its code goes into a folder of its name
    in DIR, which every command takes as --mechanism DIR/<name>.
    """
    from pkmodes.generation import generate as generate_model

    check_target(json_file, robot, *([mechanism] if mechanism else []))
    if not out.strip():
        raise OutputError("expected a folder, found an empty name", "--out", "name a folder for the model")
    written = generate_model(robot, Path(out), mechanism)
    content = {
        "robot": str(robot),
        "out": str(Path(out)),
        "files": [path.relative_to(out).as_posix() for path in written],
    }
    with deliver(to_file(json_file, content)):
        if json_file == "-":
            write_json(json_file, content)
        else:
            for path in written:
                click.echo(path)
