"""The options of a command as a table: a class with a field for each option and the use of its value.

Commands with few options use click's decorators instead.
"""

from __future__ import annotations

import functools
from collections.abc import Callable, Mapping, Sequence
from contextlib import AbstractContextManager
from dataclasses import dataclass, field, fields
from pathlib import Path
from typing import TYPE_CHECKING, Any, Self, TypeVar

import click

from pkmodes.cli.options import json_option, rename_arguments_in_errors, report_option
from pkmodes.cli.reporting import sources_of
from pkmodes.cli.targets import Target, check_targets
from pkmodes.core.base.errors import PkmodesError

if TYPE_CHECKING:
    from pkmodes.pages.report.sources import Source

Result = TypeVar("Result")
ENTRY_KEY = "entry"


@dataclass(frozen=True)
class OptionEntry:
    """An option of a command.

    - option: the decorator that adds it to the command, such as ``click.option(...)``; its name is that of the field
    - passed: whether its value is passed unchanged as the argument of the same name
    - only: the only source to which it applies, such as "measured modes"; "" if it applies to all
    - needs: options that name files to write, at least one of which must be given with it
    - reads: for a file that is read, its role on the report; "" if the report does not list it
    - writes: for a file that is written, its label, such as "the table"
    - endings, checked_when_written: as for `Target`
    """

    option: Callable[[Any], Any]
    passed: bool = False
    only: str = ""
    needs: Sequence[str] = ()
    reads: str | None = None
    writes: str = ""
    endings: tuple[str, ...] = ()
    checked_when_written: bool = False


def entry(option: Callable[[Any], Any], **uses: Any) -> Any:
    """Return a field of an `OptionTable`; `uses` are the further fields of `OptionEntry`."""
    return field(metadata={ENTRY_KEY: OptionEntry(option, **uses)})


def option(*names: str, **settings: Any) -> Any:
    """Return a field of an `OptionTable`; `settings` are those of `OptionEntry` and of ``click.option``."""
    uses = {
        entry_field.name: settings.pop(entry_field.name)
        for entry_field in fields(OptionEntry)
        if entry_field.name in settings
    }
    return entry(click.option(*names, **settings), **uses)


def missing_file_error(option_name: str, files: Mapping[str, str]) -> PkmodesError:
    """Return the error of an option that is of use only to files that are not written.

    - files: the labels of these files, such as "the report", by the options that write them with their metavar
    """
    verb = "is" if len(files) == 1 else "are"
    problem = f"{option_name} is for {' and '.join(files.values())}, which {verb} not written"
    return PkmodesError(problem, option_name, f"add {' or '.join(files)}, or leave {option_name} out")


@dataclass(frozen=True)
class OptionTable:
    """The values of a command's options, in the order of its help; those of all commands come last."""

    report_to: Path | None = entry(report_option, writes="the report", endings=(".html",))
    json_file: str | None = entry(json_option)

    @classmethod
    def entries(cls) -> dict[str, OptionEntry]:
        """Return the entries by name."""
        entries = {table_field.name: table_field.metadata[ENTRY_KEY] for table_field in fields(cls)}
        shared_entries = {
            table_field.name: entries.pop(table_field.name) for table_field in fields(OptionTable)
        }
        return entries | shared_entries

    @classmethod
    def add_to(cls, function: Callable[[Self], Result]) -> Callable[..., Result]:
        """Add the options to a command, which is called with their values."""

        @functools.wraps(function)
        def command(**values: Any) -> Result:
            return function(cls(**values))

        for option_entry in reversed(cls.entries().values()):
            option_entry.option(command)
        return command

    def check_files(self) -> None:
        """Check the files that are written, as `check_targets` does."""
        entries, parameters = self.entries(), _parameters()
        targets = [
            Target(
                parameters[name].opts[0],
                getattr(self, name),
                option_entry.writes,
                option_entry.endings,
                option_entry.checked_when_written,
            )
            for name, option_entry in entries.items()
            if option_entry.writes
        ]
        inputs = [
            getattr(self, name) for name, option_entry in entries.items() if option_entry.reads is not None
        ]
        check_targets(self.json_file, inputs, *targets)

    def check_only(self, source: str) -> None:
        """Refuse options that apply only to another source.

        - source: the source of this run, as in `OptionEntry.only`

        Raises click.UsageError.
        """
        for name, option_entry in self.entries().items():
            if self._is_given(name) and option_entry.only not in ("", source):
                problem = f"{_parameters()[name].opts[0]} is for {option_entry.only}"
                raise click.UsageError(problem, click.get_current_context())

    def check_needs(self) -> None:
        """Refuse options that need a file to be written where none is.

        Raises PkmodesError.
        """
        entries, parameters = self.entries(), _parameters()
        for name, option_entry in entries.items():
            if (
                self._is_given(name)
                and option_entry.needs
                and not any(map(self._is_given, option_entry.needs))
            ):
                files = {
                    f"{parameters[needed].opts[0]} {parameters[needed].metavar}": entries[needed].writes
                    for needed in option_entry.needs
                }
                raise missing_file_error(parameters[name].opts[0], files)

    def sources(self) -> Sequence[Source]:
        """Return the files that the report lists, as `sources_of` does."""
        return sources_of(
            self.report_to,
            {
                option_entry.reads: getattr(self, name)
                for name, option_entry in self.entries().items()
                if option_entry.reads
            },
        )

    def call_arguments(self, source: str = "") -> dict[str, Any]:
        """Return the values marked `passed`, by name, without those that apply only to another source."""
        return {
            name: getattr(self, name)
            for name, option_entry in self.entries().items()
            if option_entry.passed and option_entry.only in ("", source)
        }

    def name_in_errors(self, **renamed: str) -> AbstractContextManager[None]:
        """Name options in errors that name arguments, as `rename_arguments_in_errors` does.

        - renamed: options by argument, where an argument does not have the name of a field
        """
        options = {
            name: parameter.opts[0]
            for name, parameter in _parameters().items()
            if isinstance(parameter, click.Option)
        }
        return rename_arguments_in_errors(**(options | renamed))

    def _is_given(self, name: str) -> bool:
        """Return whether an option is given."""
        value = getattr(self, name)
        return not (value is None or value is False or value == ())


def _parameters() -> dict[str, click.Parameter]:
    """Return the parameters of the running command by name."""
    return {str(parameter.name): parameter for parameter in click.get_current_context().command.params}
