"""Results of the commands: complete files, and text or JSON on standard output."""

from __future__ import annotations

import json
import os
import re
import sys
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TextIO

import click

from pkmodes.cli.printing import echo
from pkmodes.cli.progress import end_progress
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.replacing import check_replaced
from pkmodes.core.support.writing import write_all

#: Invisible characters that JSON may hold and a terminal acts on: controls, and marks of text direction.  Bytes of a
#: file name that are not UTF-8 are surrogates, which JSON can hold only as escapes.
INVISIBLE_CHARACTERS = re.compile("[\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069\ud800-\udfff]")


@dataclass(frozen=True)
class ResultFile:
    """A file that a command writes besides the JSON.

    - file: None if it is not requested
    - content: returns what is written
    - lines: messages after it is written; by default one with its name
    """

    file: Path | None
    content: Callable[[], str | bytes]
    lines: Callable[[Path], Sequence[str]] = lambda file: (f"wrote {file}",)


def deliver(
    json_file: str | None, content: dict[str, Any], show: Callable[[], object], *files: ResultFile
) -> None:
    """Write the files, then print the result, or its JSON if ``--json`` is ``-``.

    Either all files are written or none: an error of one of them is raised after printing.  If the reader of
    standard output, such as head, closes the pipe early, the files and the exit code do not change.

    - json_file: the target of ``--json``
    - content: the result for scripts, `Document.as_json`
    - show: prints it for a person
    - *files: made in this order.  Their lines follow the result in reverse order, on stderr if standard output is the
      JSON.

    Raises PkmodesError if a file cannot be made or written.
    """
    to_stdout = json_file == "-"
    write_error: PkmodesError | None = None
    messages: list[str] = []
    if json_file is not None and not to_stdout:
        files = (ResultFile(Path(json_file), lambda: json_file_text(content), lambda _: ()), *files)
    requested = [(result_file, result_file.file) for result_file in files if result_file.file is not None]
    try:
        write_all({file: result_file.content() for result_file, file in requested})
    except PkmodesError as error:
        write_error = error
    else:
        messages = [line for result_file, file in reversed(requested) for line in result_file.lines(file)]
    end_progress()
    try:
        if to_stdout:
            click.echo(_json_text(content, ascii_only=True), nl=False)
        else:
            show()
        for line in messages:
            echo(line, err=to_stdout)
        if sys.stdout is not None:
            sys.stdout.flush()
    except (BrokenPipeError, SystemExit):  # click and rich turn BrokenPipeError into SystemExit
        silence(sys.stdout)
    finally:
        if write_error is not None:
            raise write_error


def files_to_write(
    folder: Path, contents: Mapping[str, str | bytes], option: str, overwrite: bool
) -> dict[str, str | bytes]:
    """Return the files that a folder lacks, or that have another content there.

    - contents: by file name below the folder
    - option: the option that names the place
    - overwrite: whether a file that exists with another content is replaced

    Raises OutputError if such a file exists and must not be replaced.
    """
    encoded = {name: text.encode() if isinstance(text, str) else text for name, text in contents.items()}
    existing = {name: (folder / name).read_bytes() for name in encoded if (folder / name).is_file()}
    different = [folder / name for name, content in existing.items() if content != encoded[name]]
    check_replaced(different, option, overwrite, what="the file exists with another content")
    return {name: content for name, content in encoded.items() if existing.get(name) != content}


def json_file_text(content: dict[str, Any]) -> str:
    """Return a result as the text of a JSON file."""
    return INVISIBLE_CHARACTERS.sub(
        lambda match: f"\\u{ord(match[0]):04x}", _json_text(content, ascii_only=False)
    )


def _json_text(content: dict[str, Any], ascii_only: bool) -> str:
    return json.dumps(content, indent=1, allow_nan=False, ensure_ascii=ascii_only) + "\n"


def silence(stream: TextIO) -> None:
    """Discard the buffer of a stream that cannot be written, and all later output.

    At the end the interpreter flushes it, and would report an error or replace the exit code by 120.
    """
    os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())
