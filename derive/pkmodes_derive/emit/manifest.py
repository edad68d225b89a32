"""The manifest: a record of what a product was made from, so that a later check can report what has changed.

It holds digests of the derivation's sources and templates and of every output, the generator's version,
the operation counts and, for a robot, the values of its file.
"""

from __future__ import annotations

import json
from collections.abc import Mapping

import sympy

import pkmodes_derive
from pkmodes_derive import sources
from pkmodes_derive.emit.program import Program
from pkmodes_derive.emit.specification import Specification

FILE_NAME = "manifest.json"
FORMAT = 1


def text(
    product: str,
    mechanism: str,
    specification: Specification | None,
    outputs: Mapping[str, str],
    programs: Mapping[str, Program],
    definition: tuple[str, str | None] | None = None,
    effects: Mapping[str, tuple[str, str]] | None = None,
) -> str:
    """Return the manifest of a product as JSON, keys sorted.

    Parameters
    ----------
    specification : Specification or None
        The robot, None for a parametric model.
    definition : tuple of str, optional
        For a user-defined mechanism: where the definition comes from, and its text; without a text for the folder of
        a mechanism of pkmodes with effects of one's own.
    effects : mapping, optional
        Of effects of one's own: name and text of the copy by where the file comes from.
    """
    copies = dict((effects or {}).values())
    if definition is not None and definition[1] is not None:
        copies[f"{mechanism}.py"] = definition[1]
    content: dict[str, object] = {
        "format": FORMAT,
        "product": product,
        "mechanism": mechanism,
        "generator": {"pkmodes_derive": pkmodes_derive.__version__, "sympy": sympy.__version__},
        "sources": {
            **sources.source_digests(),
            **{name: sources.digest(copy_text) for name, copy_text in copies.items()},
        },
        "outputs": {name: sources.digest(outputs[name]) for name in outputs},
        "operations": {
            name: {"written_out": p.operations_written_out, "emitted": p.operations}
            for name, p in programs.items()
        },
    }
    if definition is not None:
        content["definition"] = definition[0]
    if effects:
        content["effects"] = {path: name for path, (name, _) in effects.items()}
    if specification is not None:
        content["robot"] = {
            "file": specification.robot_file,
            "name": specification.name,
            "values": dict(specification.values),
        }
    json_text = json.dumps(content, indent=1, sort_keys=True, ensure_ascii=False) + "\n"
    # Bytes of a file name that are not UTF-8 are surrogates here, which must be escaped in JSON.
    return json_text.encode("utf-8", "backslashreplace").decode("utf-8")
