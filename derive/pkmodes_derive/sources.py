"""The sources that everything is derived from, and their digests."""

from __future__ import annotations

import hashlib
from importlib.resources import files
from importlib.resources.abc import Traversable

import pkmodes_derive
import pkmodes_description


def digest(text: str) -> str:
    """Return the SHA-256 of a text in UTF-8."""
    return hashlib.sha256(text.encode("utf-8")).hexdigest()


def source_digests() -> dict[str, str]:
    """Return the digests of every source and template of the derivation and the description by relative path."""
    digests: dict[str, str] = {}

    def walk(folder: Traversable, prefix: str) -> None:
        for entry in sorted(folder.iterdir(), key=lambda item: item.name):
            path = f"{prefix}{entry.name}"
            if entry.is_dir() and entry.name != "__pycache__":
                walk(entry, f"{path}/")
            elif entry.name.endswith((".py", ".j2", ".c")):
                # Newlines may differ between checkouts of the same sources.
                digests[path] = digest(entry.read_text(encoding="utf-8").replace("\r\n", "\n"))

    walk(files(pkmodes_derive), "")
    walk(files(pkmodes_description), "pkmodes_description/")
    return digests
