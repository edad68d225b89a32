"""Whether the files of one's own, from which a mechanism was derived, have changed since."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pkmodes.codegen.derivation import Definition, derivation, read_definition
from pkmodes.core.base.errors import PkmodesError, shown


def check_definition(folder: Path, reference: str, name: str) -> tuple[list[Any], list[str]]:
    """Check whether the file that a mechanism was derived from has changed; return findings and unchecked items."""
    try:
        given = read_definition(folder / reference, name)
    except PkmodesError:
        return [], [f"whether the definition {shown(reference)} has changed: it cannot be read"]
    digests = derivation("sources")
    recorded = derivation("emit.currency").read_manifest(folder)["sources"]
    if recorded.get(f"{name}.py") == digests.digest(given.text):
        return [], []
    message = f"the definition changed: {given.file.name} differs from the file this was derived from"
    return [derivation("emit.currency").Finding("derivation", reference, message)], []


def check_effect(folder: Path, reference: str, copy: Definition) -> tuple[list[Any], list[str]]:
    """Check whether the file of an effect has changed since a mechanism was derived with it."""
    try:
        given = read_definition(folder / reference)
    except PkmodesError:
        return [], [f"whether the effect {shown(reference)} has changed: it cannot be read"]
    if given.text == copy.text:
        return [], []
    message = f"the effect changed: {given.file.name} differs from the file this was derived with"
    return [derivation("emit.currency").Finding("derivation", reference, message)], []
