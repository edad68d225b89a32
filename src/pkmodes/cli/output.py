"""Machine-readable results of the commands: whole files, or standard output for ``-``."""

from __future__ import annotations

import json
import math
from pathlib import Path
from typing import Any

import click

from pkmodes.writing import write_file

json_option = click.option(
    "--json",
    "json_file",
    metavar="FILE",
    default=None,
    help="Write the machine-readable result to FILE; - for standard output.",
)


def write_json(json_file: str, content: dict[str, Any]) -> None:
    """Write a result as JSON; numbers that are not finite become null, as JSON has none of them."""
    text = json.dumps(_finite(content), indent=1, allow_nan=False, ensure_ascii=False) + "\n"
    if json_file == "-":
        click.echo(text, nl=False)
    else:
        write_file(Path(json_file), text)


def _finite(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _finite(entry) for key, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_finite(entry) for entry in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
