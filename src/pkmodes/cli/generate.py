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
@json_option
def generate(robot: Path, out: str, json_file: str | None) -> None:
    """Derive and write a model specialised to one robot.

    The folder gets a NumPy module, a C99 source with its header, and a manifest.  The module needs only
    NumPy and the C source only a compiler: both can be vendored.  Files of your own beside them are left alone.
    """
    from pkmodes.generation import generate as generate_model

    check_target(json_file, robot)
    if not out.strip():
        raise OutputError("expected a folder, found an empty name", "--out", "name a folder for the model")
    written = generate_model(robot, Path(out))
    content = {"robot": str(robot), "out": str(Path(out)), "files": [path.name for path in written]}
    with deliver(to_file(json_file, content)):
        if json_file == "-":
            write_json(json_file, content)
        else:
            for path in written:
                click.echo(path)
