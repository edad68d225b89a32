"""Report on generated code: reasons why it is not up to date, and checks of its results."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from pkmodes.codegen.checking.consistency import Check
from pkmodes.codegen.derivation import derivation
from pkmodes.codegen.product_folder import MANIFEST
from pkmodes.core.base.errors import PkmodesError


@dataclass(frozen=True)
class Report:
    """Report on one target.

    Attributes
    ----------
    target : str
        The folder or robot file that was checked.
    findings : list
        Reasons why it is not up to date (`pkmodes_derive.emit.currency.Finding`); empty if it is.
    checks : list of Check
        Finite-difference consistency.
    mend : str
        Command that fixes the findings, empty if there is nothing to fix.
    unchecked : tuple of str
        What could not be checked, and what to do about it.
    """

    target: str
    findings: list[Any] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    mend: str = ""
    unchecked: tuple[str, ...] = ()

    @property
    def holds(self) -> bool:
        """Whether everything that could be checked is up to date and consistent."""
        return not self.findings and all(check.holds for check in self.checks)


def manifest_of(folder: Path) -> dict[str, Any]:
    """Read the manifest of a generated folder.

    Raises
    ------
    PkmodesError
        If there is none or it cannot be read.
    """
    place = folder / MANIFEST
    remedy = "give a folder written by: pkmodes generate ROBOT.toml --out DIR"
    if not place.is_file():
        raise PkmodesError("expected a generated model, found no manifest.json", str(folder), remedy)
    try:
        content: dict[str, Any] = derivation("emit.currency").read_manifest(folder)
    except (ValueError, OSError) as error:
        raise PkmodesError(f"the manifest cannot be read: {error}", str(place), remedy) from None
    return content


def findings_of(folder: Path, fresh: dict[str, str]) -> list[Any]:
    """Return the reasons why a folder differs from a fresh derivation."""
    currency = derivation("emit.currency")
    if not (folder / MANIFEST).is_file():
        return [currency.Finding("missing", "manifest.json", "manifest.json is missing")]
    try:
        recorded = currency.read_manifest(folder)
    except (ValueError, OSError) as error:
        return [currency.Finding("manifest", "manifest.json", f"manifest.json cannot be read: {error}")]
    findings: list[Any] = currency.compare(folder, recorded, fresh)
    return findings
