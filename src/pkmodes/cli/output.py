"""Machine-readable results of the commands: complete files, or standard output for ``-``."""

from __future__ import annotations

import json
import math
import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from pkmodes.base.errors import OutputError, PkmodesError, shown
from pkmodes.base.pasting import pasted
from pkmodes.base.writing import write_file

json_option = click.option(
    "--json",
    "json_file",
    metavar="FILE",
    default=None,
    help="Write the machine-readable result to FILE; - for standard output.",
)


report_option = click.option(
    "--report",
    "report_to",
    metavar="FILE.html",
    type=click.Path(path_type=Path),
    help="Write a report, one page that needs no other file and no network.",
)


def _add_mechanism(_: click.Context, __: click.Parameter, folder: Path | None) -> Path | None:
    if folder is not None:
        from pkmodes.mechanism.registry import add_folder

        add_folder(folder)
    return folder


_MECHANISM: dict[str, Any] = {
    "metavar": "FOLDER",
    "type": click.Path(path_type=Path),
    "callback": _add_mechanism,
    "help": "A mechanism of your own: the folder that generate --mechanism FILE.py wrote.",
}
mechanism_option = click.option("--mechanism", expose_value=False, **_MECHANISM)
#: The same for a command that prints other commands for the mechanism.
repeated_mechanism_option = click.option("--mechanism", **_MECHANISM)

band_option = click.option(
    "--band",
    metavar="LOW,HIGH",
    default=None,
    help="Frequency band of the measurement, such as 10,400 in Hz, if the file does not give it.",
)


def band_of(text: str | None) -> tuple[float, float] | None:
    """Return the band of the option in Hz.

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
    """Reject, before anything is computed, a target that is an input or whose folder does not exist.

    Raises
    ------
    OutputError
        If the result cannot or must not be written there.
    """
    if json_file is None or json_file == "-":
        return
    path = Path(json_file)
    check_place(json_file, "--json")
    if any(given.exists() and path.exists() and given.samefile(path) for given in inputs):
        raise OutputError(
            "the result would replace its own input", f"--json {json_file}", "choose another file"
        )


def check_other_targets(
    targets: Mapping[str, tuple[Path | None, str]], json_file: str | None, *inputs: Path
) -> None:
    """Reject, before anything is computed, targets that cannot or must not be written.

    Parameters
    ----------
    targets : mapping of str to (Path or None, str)
        By option, the file and what it will be, such as "the report".
    json_file : str or None
        Target of ``--json``, which is checked by `check_target`.
    *inputs : Path

    Raises
    ------
    OutputError
        If the folder of a target does not exist, it is an input, or two targets are the same file; or if the
        report is not named as a page.
    """
    for option, (target, _) in targets.items():
        if target is not None:
            check_place("" if target == Path() else str(target), option)
    check_distinct(targets, json_file, *inputs)
    report, _ = targets.get("--report", (None, ""))
    if report is not None:
        check_page(report, f"--report {report}")


def check_distinct(
    targets: Mapping[str, tuple[Path | None, str]], json_file: str | None, *inputs: Path
) -> None:
    """Reject targets that are an input or another target; the parameters are those of `check_other_targets`.

    Raises
    ------
    OutputError
    """
    taken: dict[Path, str] = (
        {} if json_file in (None, "-") else {Path(str(json_file)).resolve(): "the result"}
    )
    for option, (target, what) in targets.items():
        if target is None:
            continue
        where = f"{option} {target}"
        if target.resolve() in taken:
            found = f"{taken[target.resolve()]} and {what} would be the same file"
            raise OutputError(found, where, "choose another file")
        if any(given.exists() and target.exists() and given.samefile(target) for given in inputs):
            raise OutputError(f"{what} would replace its own input", where, "choose another file")
        taken[target.resolve()] = what


def check_place(target: str, option: str) -> None:
    """Reject a target that is not a file in an existing folder.

    Raises
    ------
    OutputError
    """
    where, path = f"{option} {shown(target)}", Path(target)
    if not target or "\0" in target or target == "-":
        raise OutputError("expected the name of a file", where, "choose another place")
    if path.is_dir():
        raise OutputError("expected a file, found a folder", where, "name a file in it")
    if not path.parent.exists():
        raise OutputError(
            f"the folder {path.parent} does not exist", where, "create it, or choose another place"
        )
    if not path.parent.is_dir():
        raise OutputError(f"{path.parent} is not a folder", where, "choose another place")


def check_page(target: Path, where: str, *others: str) -> None:
    """Reject a name that no browser would open as a page; a pipe or a device may have any name.

    Parameters
    ----------
    target : Path
    where : str
        The option and its value, for the message.
    *others : str
        Further suffixes that the command writes.

    Raises
    ------
    OutputError
    """
    special = target.exists() and not target.is_file()
    if not special and target.suffix.lower() not in (".html", ".htm", *others):
        known = " or ".join((".html", *others))
        what = f"expected a name that ends in {known}, found {shown(target.name)}"
        raise OutputError(what, where, f"write {pasted(target.with_suffix('.html'))}")


def check_order(robot: Path, modes: Path, command: str) -> None:
    """Reject swapped robot and measurement files, recognised by their names.

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
def named_as_options(options: Mapping[str, str]) -> Iterator[None]:
    """Replace the name of a function argument in an error by that of the option.

    Parameters
    ----------
    options : mapping of str to str
        Options by argument.  The place of an error is an argument, alone or before a colon: ``sweep: platform.mass``.
    """
    try:
        yield
    except PkmodesError as error:
        argument, _, rest = error.where.partition(": ")
        if argument not in options:
            raise
        raise type(error)(error.what, f"{options[argument]} {rest}".rstrip(), error.remedy) from None


def write_json(json_file: str, content: dict[str, Any]) -> None:
    """Write a result as JSON; numbers that are not finite become null, because JSON cannot represent them."""
    text = json.dumps(_finite(content), indent=1, allow_nan=False, ensure_ascii=json_file == "-") + "\n"
    if json_file == "-":
        click.echo(text, nl=False)
    else:
        # Bytes of a file name that are not UTF-8 are surrogates, which JSON can hold only as escapes.
        write_file(Path(json_file), text.encode("utf-8", "backslashreplace").decode("utf-8"))


def to_file(json_file: str | None, content: dict[str, Any]) -> list[Callable[[], None]]:
    """Return the writers that `deliver` needs for ``--json``: none if it is not given or is standard output."""
    return [] if json_file is None or json_file == "-" else [lambda: write_json(json_file, content)]


@contextmanager
def deliver(files: Sequence[Callable[[], None]]) -> Iterator[None]:
    """Write files, then print in the body; a failure of one does not prevent the other.

    If the reader of standard output, such as head, closes the pipe early, the files and the exit code do not change.
    A file that cannot be written is reported after printing.

    Parameters
    ----------
    files : sequence of callable
        Each writes one file.

    Raises
    ------
    PkmodesError
        The first error that a writer raised.
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
    """Discard further standard output: the interpreter would report an error when it flushes a closed pipe."""
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
