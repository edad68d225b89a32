"""Lines for a person: text from files and file names cannot control the terminal."""

from __future__ import annotations

import click

from pkmodes.base.errors import printable


def echo(text: object = "", *, err: bool = False) -> None:
    """Print one line; characters that are not visible are written as escapes.

    Parameters
    ----------
    err : bool
        Whether it goes to stderr.
    """
    click.echo(printable(str(text)), err=err)
