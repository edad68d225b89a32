"""The generated code of a user's own mechanism: current, and right for its sample robot.

Its definition, which lies with it, is run, and what is derived from it; the rest of the folder is compared only.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pkmodes.checking.consistency import check_consistency
from pkmodes.checking.report import Report, findings_of
from pkmodes.derivation import derivation, parametric, read_definition, staged
from pkmodes.errors import PkmodesError, shown
from pkmodes.generated import Generated
from pkmodes.mechanism_packages import DEFINITION
from pkmodes.pasting import pasted
from pkmodes.product_folder import MANIFEST
from pkmodes.regular import sample


def check_mechanism(folder: Path, recorded: dict[str, Any]) -> Report:
    """Check the folder of a mechanism that ``pkmodes generate --mechanism FILE.py`` wrote.

    Parameters
    ----------
    folder : Path
    recorded : mapping
        Its manifest.

    Raises
    ------
    PkmodesError
        If the definition is missing or wrong.
    """
    name, reference = recorded.get("product"), recorded.get("definition")
    if not isinstance(name, str) or not isinstance(reference, str):
        remedy = "generate it again with: pkmodes generate --mechanism FILE.py ROBOT.toml --out DIR"
        raise PkmodesError("the manifest names no mechanism", str(folder / MANIFEST), remedy)
    fresh = parametric(read_definition(folder / DEFINITION, name), reference)
    changed, unchecked = check_definition(folder, reference, name)
    findings = [*findings_of(folder, fresh), *changed]
    with staged(name, fresh) as kind:
        parameters = sample(kind)
        checks = check_consistency(Generated(kind.model, parameters), kind, parameters)
    source = "FILE.py" if unchecked else pasted(folder / reference)
    mend = (
        f"pkmodes generate --mechanism {source} ROBOT.toml --out {pasted(folder.parent)}" if findings else ""
    )
    return Report(str(folder), findings, checks, mend, tuple(unchecked))


def check_definition(folder: Path, reference: str, name: str) -> tuple[list[Any], list[str]]:
    """Whether the file that a mechanism was derived from still says the same: findings, and what was not checked."""
    try:
        given = read_definition(folder / reference, name)
    except PkmodesError:
        return [], [f"whether the definition {shown(reference)} still says the same: it cannot be read"]
    digests = derivation("emit.manifest")
    recorded = derivation("emit.currency").read_manifest(folder)["sources"]
    if recorded.get(f"{name}.py") == digests.digest(given.text):
        return [], []
    message = f"the definition changed: {given.file.name} is not what this was derived from"
    return [derivation("emit.currency").Finding("derivation", reference, message)], []
