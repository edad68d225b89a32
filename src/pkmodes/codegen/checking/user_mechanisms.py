"""Check the generated code of a user-defined mechanism: up to date, and correct for its sample robot.

The definition stored in the folder and the code derived from it are executed; other files are only compared.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from pkmodes.codegen.checking.consistency import check_consistency
from pkmodes.codegen.checking.drawing import check_drawing
from pkmodes.codegen.checking.report import Report, findings_of
from pkmodes.codegen.derivation import derivation, parametric, read_definition, staged
from pkmodes.codegen.product_folder import MANIFEST
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.packages import DEFINITION
from pkmodes.core.mechanism.regular import sample
from pkmodes.support.pasting import pasted


def check_mechanism(folder: Path, recorded: dict[str, Any]) -> Report:
    """Check the folder of a mechanism that ``pkmodes generate --mechanism FILE.py`` wrote.

    Parameters
    ----------
    recorded : mapping
        Its manifest.

    Raises
    ------
    PkmodesError
        If the definition is missing or invalid.
    """
    name, reference = recorded.get("product"), recorded.get("definition")
    if not isinstance(name, str) or not isinstance(reference, str):
        remedy = "generate it again with: pkmodes generate --mechanism FILE.py ROBOT.toml --out DIR"
        raise PkmodesError("the manifest does not name a mechanism", str(folder / MANIFEST), remedy)
    fresh = parametric(read_definition(folder / DEFINITION, name), reference)
    changed, unchecked = check_definition(folder, reference, name)
    findings = [*findings_of(folder, fresh), *changed]
    with staged(name, fresh) as mechanism:
        parameters = sample(mechanism)
        checks = check_consistency(Generated(mechanism.model, parameters), mechanism, parameters)
        checks += check_drawing(mechanism, parameters)
    source = "FILE.py" if unchecked else pasted(folder / reference)
    fix = (
        f"pkmodes generate --mechanism {source} ROBOT.toml --out {pasted(folder.parent)}" if findings else ""
    )
    return Report(str(folder), findings, checks, fix, tuple(unchecked))


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
