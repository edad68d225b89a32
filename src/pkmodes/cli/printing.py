"""Lines for a person: text from files and file names cannot control the terminal."""

from __future__ import annotations

import click

from pkmodes.cli.progress import clear_progress
from pkmodes.core.base.errors import printable


def echo(text: object = "", *, err: bool = False) -> None:
    """Print one line; characters that are not visible are written as escapes.

    - text: a line break at its beginning gives an empty line
    - err: whether it goes to stderr
    """
    clear_progress()
    line = str(text)
    visible_text = line.removeprefix("\n")
    click.echo("\n" * (len(line) - len(visible_text)) + printable(visible_text), err=err)
