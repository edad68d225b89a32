"""Machine-readable results of the commands: whole files, or standard output for ``-``."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from pkmodes.errors import OutputError, PkmodesError, shown
from pkmodes.pasting import pasted
from pkmodes.writing import write_file

json_option = click.option(
    "--json",
    "json_file",
    metavar="FILE",
    default=None,
    help="Write the machine-readable result to FILE; - for standard output.",
)


def _add_mechanism(_: click.Context, __: click.Parameter, folder: Path | None) -> Path | None:
    if folder is not None:
        from pkmodes.mechanism import add_folder

        add_folder(folder)
    return folder


mechanism_option = click.option(
    "--mechanism",
    metavar="FOLDER",
    type=click.Path(path_type=Path),
    callback=_add_mechanism,
    expose_value=False,
    help="A mechanism of your own: the folder that generate --mechanism FILE.py wrote.",
)

band_option = click.option(
    "--band",
    metavar="LOW,HIGH",
    default=None,
    help="Where modes were looked for, such as 10,400 in Hz, where the file does not say so.",
)


def band_of(text: str | None) -> tuple[float, float] | None:
    """The band of the option, in Hz.

    Raises
    ------
    MeasurementError
        If it is not two frequencies, the lower one first.
    """
    if text is None:
        return None
    from pkmodes.measured.table import parse_band

    return parse_band(text, "--band", "write --band 10,400")


def check_target(json_file: str | None, *inputs: Path) -> None:
    """Refuse, before anything is computed, a target that is an input or that has no folder.

    Raises
    ------
    OutputError
        If the result could not or should not be written there.
    """
    if json_file is None or json_file == "-":
        return
    path = Path(json_file)
    check_place(json_file, "--json")
    if any(given.exists() and path.exists() and given.samefile(path) for given in inputs):
        raise OutputError(
            "the result would replace its own input", f"--json {json_file}", "choose another file"
        )


def check_place(target: str, option: str) -> None:
    """Refuse a target that is no file in a folder that is there.

    Raises
    ------
    OutputError
    """
    where, path = f"{option} {shown(target)}", Path(target)
    if not target or "\0" in target or target == "-":
        raise OutputError("expected the name of a file", where, "choose another place")
    if path.is_dir():
        raise OutputError("expected a file, and it is a folder", where, "name a file in it")
    if not path.parent.exists():
        raise OutputError(
            f"the folder {path.parent} does not exist", where, "create it, or choose another place"
        )
    if not path.parent.is_dir():
        raise OutputError(f"{path.parent} is no folder", where, "choose another place")


def check_order(robot: Path, modes: Path, command: str) -> None:
    """Refuse measurements in the place of the robot, where their names say that they are exchanged.

    Raises
    ------
    PkmodesError
    """
    if modes.suffix.lower() == ".toml" and robot.suffix.lower() != ".toml":
        what = f"expected ROBOT.toml before MODES.csv, found {robot} before {modes}"
        raise PkmodesError(
            what, command, f"the robot file comes first: {command} {pasted(modes)} {pasted(robot)}"
        )


@contextmanager
def named_as_options() -> Iterator[None]:
    """Name an argument of a function, in an error, as the option that it was."""
    try:
        yield
    except PkmodesError as error:
        if error.where not in ("candidates", "holdout"):
            raise
        raise PkmodesError(error.what, f"--{error.where}", error.remedy) from None


def write_json(json_file: str, content: dict[str, Any]) -> None:
    """Write a result as JSON; numbers that are not finite become null, as JSON has none of them."""
    text = json.dumps(_finite(content), indent=1, allow_nan=False, ensure_ascii=json_file == "-") + "\n"
    if json_file == "-":
        click.echo(text, nl=False)
    else:
        # Bytes of a file name that are not UTF-8 are surrogates, which JSON can only have as escapes.
        write_file(Path(json_file), text.encode("utf-8", "backslashreplace").decode("utf-8"))


def to_file(json_file: str | None, content: dict[str, Any]) -> list[Callable[[], None]]:
    """What `deliver` has to write for ``--json``: nothing where it was not given or is standard output."""
    return [] if json_file is None or json_file == "-" else [lambda: write_json(json_file, content)]


@contextmanager
def deliver(files: Sequence[Callable[[], None]]) -> Iterator[None]:
    """Write files, and print in the body: neither can keep the other from being done.

    A reader of standard output that has seen enough, such as head, changes neither the files nor the exit code;
    a file that cannot be written is told after what is printed.

    Parameters
    ----------
    files : sequence of callable
        Each writes one file.

    Raises
    ------
    PkmodesError
        The first that a writer raised.
    """
    problems = []
    for write in files:
        try:
            write()
        except PkmodesError as error:
            problems.append(error)
    try:
        yield
        if sys.stdout is not None:
            sys.stdout.flush()
    except (BrokenPipeError, SystemExit):  # click and rich turn the one into the other
        silence()
    finally:
        if problems:
            raise problems[0]


def silence() -> None:
    """Let nothing more go to standard output: the interpreter would complain when it flushes."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
