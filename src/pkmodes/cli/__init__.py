"""The command line: one module for each command, registered here.

A repeated option is refused, and an interrupt ends a command without a traceback.  Errors go to stderr as ``error:
<what> (<where>); <what to do>``.  Exit codes: 0 success, 1 a check failed, 2 bad input or usage, 130 interrupted.
"""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import Any

import click

from pkmodes.cli.changed import changed
from pkmodes.cli.check import check
from pkmodes.cli.compare import compare
from pkmodes.cli.delivery import silence
from pkmodes.cli.diagnose import diagnose
from pkmodes.cli.examples import examples
from pkmodes.cli.figures import figures
from pkmodes.cli.generate import generate
from pkmodes.cli.identify import identify
from pkmodes.cli.map import map_
from pkmodes.cli.modes import modes
from pkmodes.cli.new import new
from pkmodes.cli.printing import echo
from pkmodes.cli.progress import progress_line
from pkmodes.cli.response import response
from pkmodes.cli.sensitivities import sensitivities
from pkmodes.cli.shaper import shaper
from pkmodes.cli.show import show
from pkmodes.cli.version import print_version
from pkmodes.core.base.errors import PkmodesError

SUCCESS, CHECK_FAILED, BAD_INPUT, INTERRUPTED = 0, 1, 2, 130


#: The commands by task, each with a sentence for the help.
WORKFLOW: dict[str, dict[click.Command, str]] = {
    "Describe a machine": {
        examples: "List the examples of the documentation, or write them.",
        new: "Write a robot file to start from, with a comment on each key.",
    },
    "Look at a machine": {
        modes: "Print frequencies, mode shapes and damping at a pose.",
        map_: "Compute the modes over the workspace.",
        sensitivities: "Show which parameters change each frequency, and by how much.",
        show: "Write a page with the moving machine in three dimensions.",
        figures: "Draw the working plane, frequencies and directions of motion.",
    },
    "Measure it": {
        identify: "Identify modes from measured signals.",
        compare: "Compare a model with measured modes, or two of either.",
    },
    "Diagnose it": {
        diagnose: "Find the physical effect that the model lacks, and add it.",
        changed: "Find what changed on a machine since a trusted measurement.",
    },
    "Use the model": {
        response: "Compute responses to motors and forces on the platform.",
        shaper: "Choose input shapers that keep the machine from ringing.",
        generate: "Generate NumPy and C code for one robot.",
        check: "Check that generated code is up to date and correct.",
    },
}


class Commands(click.Group):
    """A group whose commands reject a repeated option, of which click would use only the last."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """Find the command and check its options."""
        name, command, rest = super().resolve_command(ctx, args)
        if command is not None:
            context = click.Context(command, info_name=name, parent=ctx)
            parsed_options: list[click.Parameter] = []
            with suppress(click.UsageError):  # which the command itself reports
                _, _, parsed_options = command.make_parser(context).parse_args(list(rest))
            for option in dict.fromkeys(parsed_options):
                single_valued = isinstance(option, click.Option) and not (
                    option.multiple or option.count or option.is_flag
                )
                if single_valued and parsed_options.count(option) > 1:
                    raise click.UsageError(f"option '{option.opts[0]}' is given more than once", context)
        return name, command, rest

    def make_context(self, *args: Any, **kwargs: Any) -> click.Context:
        """Read the arguments; click itself would print an empty line on an interrupt."""
        with _interruptible():
            return super().make_context(*args, **kwargs)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        """Write the commands in the order in which they are used, each with its sentence from `WORKFLOW`."""
        width = max(len(name) for name in self.commands)  # no map(): the name is that of a submodule here
        for title, group in WORKFLOW.items():
            with formatter.section(title):
                formatter.write_dl(
                    [(f"{command.name:{width}}", sentence) for command, sentence in group.items()]
                )

    def invoke(self, ctx: click.Context) -> Any:
        """Run the command."""
        with _interruptible(), progress_line("loading"):
            return super().invoke(ctx)


@contextmanager
def _interruptible() -> Iterator[None]:
    try:
        yield
    except KeyboardInterrupt:
        raise click.Abort from None


@click.group(
    cls=Commands,
    context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110},
    epilog="\b\nExample:\n  pkmodes examples robots\n"
    "  pkmodes modes robots/linear-delta-2022.toml --pose 0.6,0,-0.245",
)
@click.option(
    "--version",
    is_flag=True,
    expose_value=False,
    callback=print_version,
    help="Print the version and exit; with --verbose also the libraries, the back end and the C compiler.",
)
@click.option("--verbose", is_flag=True, is_eager=True, hidden=True)
def cli(verbose: bool) -> None:
    """Vibration modes of parallel robots with compliant transmissions."""


for group in WORKFLOW.values():
    for command in group:
        cli.add_command(command)


def main(arguments: Sequence[str] | None = None) -> None:
    """Run the command line and exit; the installed command is `pkmodes.__main__`, which loads this module."""
    sys.exit(run(arguments))


def run(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return the exit code."""
    _tolerate_unwritable_output()
    try:
        code = cli.main(
            args=None if arguments is None else list(arguments), prog_name="pkmodes", standalone_mode=False
        )
        if sys.stdout is not None:
            sys.stdout.flush()
        return code if isinstance(code, int) else SUCCESS
    except PkmodesError as error:
        return _report(error.lines)
    except click.exceptions.NoArgsIsHelpError as error:
        click.echo(error.format_message(), err=True)
        return BAD_INPUT
    except click.UsageError as error:
        command_path = error.ctx.command_path if error.ctx else "pkmodes"
        message = error.format_message().rstrip(".")
        return _report([f"{message[0].lower()}{message[1:]} ({command_path}); see {command_path} --help"])
    except click.ClickException as error:
        return _report([f"{error.format_message()} (pkmodes); see pkmodes --help"])
    except (click.Abort, KeyboardInterrupt) as error:
        if sys.stderr is not None and sys.stderr.isatty():
            click.echo(err=True)  # after the terminal's ^C
        _report([f"interrupted (pkmodes); {error.args[0] if error.args else 'run it again'}"])
        return INTERRUPTED
    except (BrokenPipeError, SystemExit):
        # A reader such as head closed the pipe, which click turns into SystemExit.
        silence(sys.stdout)
        return SUCCESS
    except OSError as error:
        where = str(error.filename) if error.filename else "standard output"
        if not error.filename:
            silence(sys.stdout)
        return _report(
            [f"{(error.strerror or str(error)).lower()} ({where}); check the place and run it again"]
        )


def _tolerate_unwritable_output() -> None:
    """Escape text that the terminal cannot encode, and tolerate a closed standard output."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="backslashreplace")
    if sys.stdout is None:
        sys.stdout = Path(os.devnull).open("w", encoding="utf-8")  # noqa: SIM115 - open for the whole process


def _report(lines: Sequence[str]) -> int:
    try:
        for line in lines:
            echo(f"error: {line}", err=True)
    except OSError:  # stderr cannot be written either
        with suppress(OSError):
            silence(sys.stderr)
    return BAD_INPUT
