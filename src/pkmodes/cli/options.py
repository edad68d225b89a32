"""Options that several commands share, and errors that name them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import click

from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.support.pasting import shell_path

#: The type of arguments and options that name a file or a folder.
PATH = click.Path(path_type=Path)

robot_argument = click.argument("robot", metavar="ROBOT.toml", type=PATH)

json_option = click.option(
    "--json",
    "json_file",
    metavar="FILE",
    help="Write the machine-readable result to FILE; - for standard output.",
)

overwrite_option = click.option(
    "--overwrite",
    is_flag=True,
    help="Replace an existing file even if it holds something else, such as your own work.",
)

report_option = click.option(
    "--report",
    "report_to",
    metavar="FILE.html",
    type=PATH,
    help="Write a report: one page that needs no other file and no network.",
)


def _add_mechanism(_: click.Context, __: click.Parameter, folder: Path | None) -> Path | None:
    if folder is not None:
        from pkmodes.core.mechanism.registry import add_folder

        add_folder(folder)
    return folder


_MECHANISM_SETTINGS: dict[str, Any] = {
    "metavar": "FOLDER",
    "type": PATH,
    "help": "A mechanism of your own: the folder that generate --mechanism FILE.py wrote.",
}
mechanism_option = click.option(
    "--mechanism", expose_value=False, callback=_add_mechanism, **_MECHANISM_SETTINGS
)
#: The same option, passed to the command: for a command that prints other commands for the mechanism, or has a table
#: of options.  The second does not register the mechanism, for the command that checks the folder.
forwarded_mechanism_option = click.option("--mechanism", callback=_add_mechanism, **_MECHANISM_SETTINGS)
unregistered_mechanism_option = click.option("--mechanism", **_MECHANISM_SETTINGS)

drives_option = click.option(
    "--drives",
    type=click.Choice(DRIVES),
    help="Motors: free to turn, or held by position loops far stiffer than the machine; by default as the robot file "
    "says, else free.",
)

#: The same option for a command that reads measurements, whose file may state the drives.
measured_drives_option = click.option(
    "--drives",
    type=click.Choice(DRIVES),
    help="Motors in the test, if the file does not state it: free to turn, or held; by default as the robot file "
    "says, else free.",
)

band_option = click.option(
    "--band",
    metavar="LOW,HIGH",
    help="Frequency band of the measurement in Hz, such as 10,400, if the file does not state it.",
)


def parse_band_option(text: str | None) -> tuple[float, float] | None:
    """Return the band of the option in Hz.

    Raises MeasurementError if it is not two frequencies, the lower one first.
    """
    if text is None:
        return None
    from pkmodes.loop.measured.statements import parse_band

    return parse_band(text, "--band", "write --band 10,400")


def comma_list(text: str, option: str, example: str, noun: str = "names") -> list[str]:
    """Return names that are separated by commas, each once.

    - example: the option as it should be written, for messages
    - noun: what the items are called, for messages

    Raises PkmodesError if one is empty.
    """
    names = [name.strip() for name in text.split(",")]
    if not all(names):
        raise PkmodesError(
            f"expected {noun} separated by commas, found {shown(text)}", option, f"for example: {example}"
        )
    return list(dict.fromkeys(names))


def quantity_parser(
    unit: str, example: str
) -> Callable[[click.Context, click.Parameter, str | None], float | None]:
    """Return a callback that parses an option, a number in SI units or a number with its unit.

    - unit: the SI unit
    - example: a value with its unit, for messages
    """

    def parse(_: click.Context, option: click.Parameter, text: str | None) -> float | None:
        from pkmodes.core.robot.units import QuantityError, parse_number_or_quantity

        if text is None:
            return None
        try:
            return parse_number_or_quantity(text, unit)
        except QuantityError as error:
            name = option.opts[0]
            raise PkmodesError(str(error), name, error.remedy or f'for example: {name} "{example}"') from None

    return parse


def check_file_order(robot: Path, modes: Path, command: str) -> None:
    """Reject swapped robot and measurement files, recognised by their names."""
    if modes.suffix.lower() == ".toml" and robot.suffix.lower() != ".toml":
        problem = f"expected ROBOT.toml before MODES.csv, found {robot} before {modes}"
        raise PkmodesError(
            problem, command, f"the robot file comes first: {command} {shell_path(modes)} {shell_path(robot)}"
        )


@contextmanager
def rename_arguments_in_errors(*arguments: str, **renamed: str) -> Iterator[None]:
    """Replace the name of a function argument in an error by that of the option.

    The place of an error is an argument, alone or before a colon: ``sweep: platform.mass``.  A remedy may give an
    argument a value: ``drives="held"``.

    - arguments: arguments that have the names of their options
    - renamed: options by argument
    """
    options = {name: f"--{name}" for name in arguments} | renamed
    try:
        yield
    except PkmodesError as error:
        argument, _, rest = error.where.partition(": ")
        if argument not in options:
            raise
        remedy = re.sub(
            r'\b(\w+)="(\w+)"',
            lambda match: f"{options[match[1]]} {match[2]}" if match[1] in options else match[0],
            error.remedy,
        )
        raise type(error)(error.what, f"{options[argument]} {rest}".rstrip(), remedy) from None
