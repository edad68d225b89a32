"""Check whether a product is current: compare the files on disk with their manifest and a fresh derivation.

Every finding names its cause as precisely as possible: a field of the robot file, a source or template of the
derivation, the SymPy version, a manual edit, a missing file or one that does not belong to the product.
"""

from __future__ import annotations

import difflib
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from pkmodes_derive import sources
from pkmodes_derive.emit import manifest
from pkmodes_derive.emit.provenance import is_generated

DIFF_LINES = 40
#: Enough for the first three lines of a generated file, which contain a command with a path.
HEADER_BYTES = 20_000


@dataclass(frozen=True)
class Finding:
    """One reason why a product is not current.

    Attributes
    ----------
    cause : str
        ``robot``, ``derivation``, ``sympy``, ``generator``, ``edited``, ``missing``, ``orphan``, ``manifest`` or
        ``different``.
    subject : str
        The field or file.
    message : str
        One sentence.
    diff : str
        Unified diff from the file on disk to the expected file, shortened; may be empty.
    """

    cause: str
    subject: str
    message: str
    diff: str = ""


def read_manifest(folder: Path) -> dict[str, object]:
    """Read the manifest of a product.

    Raises
    ------
    ValueError
        If it is not a manifest; the message says why.
    OSError
        If it cannot be read.
    """
    try:
        content = json.loads((folder / manifest.FILE_NAME).read_text(encoding="utf-8"))
    except (json.JSONDecodeError, UnicodeDecodeError, RecursionError) as error:
        raise ValueError(f"it is not valid JSON: {error}") from None
    parts = ("generator", "outputs", "sources")
    if not isinstance(content, dict) or not all(isinstance(content.get(part), dict) for part in parts):
        raise ValueError("it is not a manifest of pkmodes")
    if content.get("format") != manifest.FORMAT:
        raise ValueError(f"its format is {content.get('format')!r}, expected {manifest.FORMAT}")
    return content


def compare(folder: Path, recorded: Mapping[str, object], fresh: Mapping[str, str]) -> list[Finding]:
    """Compare a folder and its manifest with the texts of a fresh derivation."""
    fresh_manifest = json.loads(fresh[manifest.FILE_NAME])
    on_disk = {name: _read_text(folder / name) for name in fresh}
    findings = [
        *_robot_findings(recorded, fresh_manifest),
        *_generator_findings(recorded, fresh_manifest),
        *_source_findings(recorded, fresh_manifest),
        *_output_findings(recorded, fresh, on_disk),
        *_orphan_findings(folder, recorded, fresh),
    ]
    text = on_disk[manifest.FILE_NAME]
    if not findings and text != fresh[manifest.FILE_NAME]:
        diff = _diff(manifest.FILE_NAME, text or "", fresh[manifest.FILE_NAME])
        findings.append(
            Finding("edited", manifest.FILE_NAME, f"{manifest.FILE_NAME} was edited by hand", diff)
        )
    return findings


def _read_text(path: Path) -> str | None:
    # Bytes that are not UTF-8 count as an edit, so they are shown, not refused.
    if not path.is_file():
        return None
    return path.read_bytes().decode("utf-8", errors="replace")


def _mapping_at(content: Mapping[str, object], *keys: str) -> dict[str, object]:
    value: object = content
    for key in keys:
        value = value.get(key, {}) if isinstance(value, Mapping) else {}
    return dict(value) if isinstance(value, Mapping) else {}


def _robot_findings(recorded: Mapping[str, object], fresh_manifest: Mapping[str, object]) -> list[Finding]:
    old, new = _mapping_at(recorded, "robot", "values"), _mapping_at(fresh_manifest, "robot", "values")
    old["name"], new["name"] = (
        _mapping_at(recorded, "robot").get("name"),
        _mapping_at(fresh_manifest, "robot").get("name"),
    )
    return [
        Finding(
            "robot",
            path,
            f"the robot file changed: {path} is {_value(new.get(path))}, the model was generated with "
            f"{_value(old.get(path))}",
        )
        for path in dict.fromkeys([*old, *new])
        if old.get(path) != new.get(path)
    ]


def _value(value: object) -> str:
    return "absent" if value is None else json.dumps(value)


def _generator_findings(
    recorded: Mapping[str, object], fresh_manifest: Mapping[str, object]
) -> list[Finding]:
    old, new = _mapping_at(recorded, "generator"), _mapping_at(fresh_manifest, "generator")
    names = {"sympy": "SymPy"}
    return [
        Finding(
            "sympy" if key == "sympy" else "generator",
            key,
            f"different {names.get(key, key)} version: generated with {old.get(key)}, installed is {new[key]}",
        )
        for key in new
        if old.get(key) != new[key]
    ]


def _source_findings(recorded: Mapping[str, object], fresh_manifest: Mapping[str, object]) -> list[Finding]:
    old, new = _mapping_at(recorded, "sources"), _mapping_at(fresh_manifest, "sources")
    return [
        Finding(
            "derivation",
            path,
            f"the {'template' if path.endswith('.j2') else 'derivation'} changed: {path} is "
            + ("new" if path not in old else "missing" if path not in new else "modified"),
        )
        for path in sorted(old.keys() | new.keys())
        if old.get(path) != new.get(path)
    ]


def _output_findings(
    recorded: Mapping[str, object], fresh: Mapping[str, str], on_disk: Mapping[str, str | None]
) -> list[Finding]:
    findings = []
    digests = _mapping_at(recorded, "outputs")
    for name, text in fresh.items():
        content = on_disk[name]
        if name == manifest.FILE_NAME:
            continue
        if content is None:
            findings.append(Finding("missing", name, f"{name} is missing"))
        elif content != text and content.replace("\r\n", "\n") == text:
            findings.append(Finding("edited", name, f"{name} has different line endings than generated"))
        elif name in digests and digests[name] != sources.digest(content):
            findings.append(Finding("edited", name, f"{name} was edited by hand", _diff(name, content, text)))
        elif content != text:
            message = f"{name} differs from the current derivation"
            findings.append(Finding("different", name, message, _diff(name, content, text)))
    return findings


def _orphan_findings(folder: Path, recorded: Mapping[str, object], fresh: Mapping[str, str]) -> list[Finding]:
    """Find generated files that do not belong to this model; regenerating removes those of its former name.

    Everything else in the folder, including folders and links, belongs to the user.
    """
    earlier_outputs, findings = _mapping_at(recorded, "outputs"), []
    for path in sorted(folder.iterdir()):
        if path.name in fresh or path.is_symlink() or not (path.is_file() and carries_header(path)):
            continue
        if path.name in earlier_outputs:
            findings.append(
                Finding(
                    "different", path.name, f"{path.name} is of a former model: another name, or with effects"
                )
            )
        else:
            message = (
                f"{path.name} was generated but does not belong to this model: an orphan; move or remove it"
            )
            findings.append(Finding("orphan", path.name, message))
    return findings


def carries_header(path: Path) -> bool:
    """Return whether a file begins with the header of generated files; False if it cannot be read."""
    try:
        with path.open("rb") as file:
            return is_generated(file.read(HEADER_BYTES).decode("utf-8", errors="replace"))
    except OSError:
        return False


def _diff(name: str, content: str, expected: str) -> str:
    lines = list(
        difflib.unified_diff(
            content.splitlines(),
            expected.splitlines(),
            f"{name} (on disk)",
            f"{name} (derived now)",
            lineterm="",
            n=1,
        )
    )
    if len(lines) > DIFF_LINES:
        lines = [*lines[:DIFF_LINES], f"... and {len(lines) - DIFF_LINES} more lines"]
    return "\n".join(lines)
