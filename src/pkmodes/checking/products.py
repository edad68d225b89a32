"""Is generated code current and right?  The committed model, a generated folder, or a robot file."""

from __future__ import annotations

import importlib.util
import types
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.checking.consistency import (
    BOUND,
    Check,
    Generated,
    check_consistency,
    oblique_robot,
    regular_configurations,
)
from pkmodes.errors import PkmodesError, RobotFileError
from pkmodes.generation import derivation, specification
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta

MECHANISM = "linear_delta"
REGENERATE = "make generate"


@dataclass(frozen=True)
class Report:
    """What was found about one target.

    Attributes
    ----------
    target : str
        What was checked.
    findings : list
        Reasons why it is not current (`pkmodes_derive.emit.currency.Finding`); empty when it is.
    checks : list of Check
        Finite-difference consistency.
    mend : str
        Command that mends what was found, empty when nothing has to be mended.
    """

    target: str
    findings: list[Any] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    mend: str = ""

    @property
    def holds(self) -> bool:
        """Whether the target is current and consistent."""
        return not self.findings and all(check.holds for check in self.checks)


def check_committed() -> Report:
    """Check the parametric model that pkmodes itself evaluates, its derivatives for a robot without symmetry."""
    folder = Path(str(files(linear_delta)))
    findings = _findings(folder, derivation("emit.product").parametric(MECHANISM), REGENERATE)
    parameters = oblique_robot()
    checks = check_consistency(Generated(linear_delta, parameters), parameters.limits, parameters.link_length)
    return Report(str(folder), findings, checks, REGENERATE if findings else "")


def check_folder(folder: Path) -> Report:
    """Check a folder that `pkmodes generate` wrote.

    Raises
    ------
    PkmodesError
        If the folder holds no product, or its robot file is wrong.
    """
    recorded = _manifest(folder)
    owner = recorded.get("robot")
    if not isinstance(owner, dict) or not isinstance(owner.get("file"), str):
        if recorded.get("mechanism") != MECHANISM:
            raise PkmodesError(
                f"the manifest names no robot file and no known mechanism, found {recorded.get('mechanism')!r}",
                str(folder / "manifest.json"),
                "generate the model again with: pkmodes generate ROBOT.toml --out DIR",
            )
        fresh = derivation("emit.product").parametric(MECHANISM)
        findings = _findings(folder, fresh, REGENERATE)
        return Report(str(folder), findings, [], REGENERATE if findings else "")
    reference = owner["file"]
    robot_file = folder / reference
    mend = f"pkmodes generate {_shown(robot_file)} --out {folder}"
    if not robot_file.is_file():
        raise RobotFileError(
            [
                PkmodesError(
                    f"the robot file {reference} that this model was generated from is not there",
                    str(folder / "manifest.json"),
                    "put it back, or generate the model again with: pkmodes generate ROBOT.toml --out DIR",
                )
            ]
        )
    robot = read_robot(robot_file)
    product = derivation("emit.product")
    wanted = specification(robot, reference)
    findings = _findings(folder, product.specialised(wanted), mend)
    module = folder / f"{wanted.identifier}.py"
    checks = _file_consistency(module, robot) if module.is_file() else []
    holds = not findings and all(check.holds for check in checks)
    return Report(str(folder), findings, checks, "" if holds else mend)


def check_robot(robot_file: Path) -> Report:
    """Check the model that a robot file gives: derived afresh, consistent, and equal to the parametric one.

    Raises
    ------
    RobotFileError
        If the robot file is wrong.
    """
    robot = read_robot(robot_file)
    texts = derivation("emit.product").specialised(specification(robot, robot_file.name))
    name = next(name for name in texts if name.endswith(".py"))
    module = types.ModuleType(name.removesuffix(".py"))
    exec(compile(texts[name], name, "exec"), module.__dict__)  # the text was derived a moment ago
    specialised, parametric = Generated(module), Generated(linear_delta, robot.parameters)
    return Report(
        str(robot_file), [], [*_consistency(specialised, robot), *_equality(specialised, parametric, robot)]
    )


def _manifest(folder: Path) -> dict[str, object]:
    place = folder / "manifest.json"
    remedy = "give a folder written by: pkmodes generate ROBOT.toml --out DIR"
    if not place.is_file():
        raise PkmodesError("expected a generated model, found no manifest.json", str(folder), remedy)
    try:
        content: dict[str, object] = derivation("emit.currency").read_manifest(folder)
    except (ValueError, OSError) as error:
        raise PkmodesError(f"the manifest cannot be read: {error}", str(place), remedy) from None
    return content


def _findings(folder: Path, fresh: dict[str, str], mend: str) -> list[Any]:
    currency = derivation("emit.currency")
    if not (folder / "manifest.json").is_file():
        return [currency.Finding("missing", "manifest.json", "manifest.json is missing")]
    try:
        recorded = currency.read_manifest(folder)
    except (ValueError, OSError) as error:
        return [currency.Finding("manifest", "manifest.json", f"manifest.json cannot be read: {error}")]
    found: list[Any] = currency.compare(folder, recorded, fresh)
    return found


def _shown(path: Path) -> str:
    """A path as a person would type it: without detours through parent folders where it can be avoided."""
    resolved = path.resolve()
    here = Path.cwd()
    return str(resolved.relative_to(here) if resolved.is_relative_to(here) else resolved)


def _consistency(generated: Generated, robot: Robot) -> list[Check]:
    return check_consistency(generated, robot.parameters.limits, robot.parameters.link_length)


def _file_consistency(module_file: Path, robot: Robot) -> list[Check]:
    """Check a module on disk; one that cannot even be executed fails."""
    try:
        loader = importlib.util.spec_from_file_location(module_file.stem, module_file)
        if loader is None or loader.loader is None:
            return [Check("import of the module", np.inf, BOUND)]
        module = importlib.util.module_from_spec(loader)
        loader.loader.exec_module(module)
        return _consistency(Generated(module), robot)
    except Exception as error:  # edited code can fail in any way; whichever it is, the check does not hold
        return [Check(f"execution of {module_file.name} ({type(error).__name__}: {error})", np.inf, BOUND)]


def _equality(specialised: Generated, parametric: Generated, robot: Robot) -> list[Check]:
    """Constants folded or given as parameters: the same matrices."""
    x, branch = regular_configurations(parametric, robot.parameters.limits)
    if not len(x):
        return []
    p = parametric.direct_kinematics(x, branch)
    names = ("M of the parametric model", "K of the parametric model")
    pairs = zip(names, specialised.modal_matrices(p), parametric.modal_matrices(p), strict=True)
    return [Check(name, _relative(found, expected), 1e-12) for name, found, expected in pairs]


def _relative(found: NDArray[np.float64], expected: NDArray[np.float64]) -> float:
    return float(np.max(np.abs(found - expected)) / np.max(np.abs(expected)))
