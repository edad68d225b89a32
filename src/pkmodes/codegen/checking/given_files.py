"""Whether a user's own files, from which a mechanism was derived, have changed since."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pkmodes.codegen.derivation import derivation, python_text
from pkmodes.core.base.errors import PkmodesError, shown


def check_given_file(folder: Path, reference: str, source: str, noun: str) -> tuple[list[Any], list[str]]:
    """Check whether a file has changed since a mechanism was derived from it; return findings and unchecked items.

    - reference: path of the file relative to the folder
    - source: its name among the sources of the manifest
    - noun: what it is called: "definition" or "effect"
    """
    try:
        text = python_text(folder / reference, noun, "")
    except PkmodesError:
        return [], [f"whether the {noun} {shown(reference)} has changed: it cannot be read"]
    recorded = derivation("emit.currency").read_manifest(folder)["sources"]
    if recorded.get(source) == derivation("sources").digest(text):
        return [], []
    file = (folder / reference).name
    message = f"the {noun} changed: {file} differs from the file this was derived from"
    return [derivation("emit.currency").Finding("derivation", reference, message)], []
