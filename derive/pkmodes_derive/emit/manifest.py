"""The manifest: a record of what a product was made from, so a later check can tell what has changed.

It holds digests of the derivation's sources and templates and of every output, the generator's version,
the operation counts and, for a robot, the values of its file.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from importlib.resources import files
from importlib.resources.abc import Traversable

import sympy

import pkmodes_derive
import pkmodes_description
from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.specification import Specification

FILE_NAME = "manifest.json"
FORMAT = 1


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


def text(
    product: str,
    mechanism: str,
    specification: Specification | None,
    outputs: Mapping[str, str],
    programs: Mapping[str, Program],
    definition: tuple[str, str] | None = None,
) -> str:
    """Return the manifest of a product as JSON, keys sorted.

    Parameters
    ----------
    product, mechanism : str
    specification : Specification or None
        The robot, None for a parametric model.
    outputs, programs : mapping
    definition : tuple of str, optional
        For a user-defined mechanism: where the definition comes from, and its text.
    """
    content: dict[str, object] = {
        "format": FORMAT,
        "product": product,
        "mechanism": mechanism,
        "generator": {"pkmodes_derive": pkmodes_derive.__version__, "sympy": sympy.__version__},
        "sources": source_digests(),
        "outputs": {name: digest(outputs[name]) for name in outputs},
        "operations": {
            name: {"written_out": p.operations_written_out, "emitted": p.operations}
            for name, p in programs.items()
        },
    }
    if definition is not None:
        content["definition"] = definition[0]
        content["sources"] = {**source_digests(), f"{mechanism}.py": digest(definition[1])}
    if specification is not None:
        content["robot"] = {
            "file": specification.robot_file,
            "name": specification.name,
            "values": dict(specification.values),
        }
    written = json.dumps(content, indent=1, sort_keys=True, ensure_ascii=False) + "\n"
    # Bytes of a file name that are not UTF-8 are surrogates here, which must be escaped in JSON.
    return written.encode("utf-8", "backslashreplace").decode("utf-8")
