"""Is generated code current and right?  The committed model, a generated folder, or a robot file."""

from __future__ import annotations

import shlex
import types
from dataclasses import dataclass, field
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.checking.consistency import Check, Generated, check_consistency, oblique_robot, regular_poses
from pkmodes.errors import PkmodesError, RobotFileError, shown
from pkmodes.evaluation import active_effects, evaluation
from pkmodes.generation import derivation, specification
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot
from pkmodes_generated import linear_delta

MECHANISM = "linear_delta"
REGENERATE = "python -m pkmodes_derive generate"

Array = NDArray[np.float64]


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
    checks = check_consistency(Generated(linear_delta, parameters), parameters)
    return Report(str(folder), findings, checks, REGENERATE if findings else "")


def check_folder(folder: Path) -> Report:
    """Check a folder that `pkmodes generate` wrote.

    What is executed is the fresh derivation, never a file that somebody may have edited: where the two are
    the same, the check holds for both, and where they differ, that is found.

    Raises
    ------
    PkmodesError
        If the folder holds no product, or its robot file is wrong.
    """
    recorded = _manifest(folder)
    product = derivation("emit.product")
    if "robot" not in recorded and recorded.get("product") == MECHANISM:
        findings = _findings(folder, product.parametric(MECHANISM), REGENERATE)
        return Report(str(folder), findings, [], REGENERATE if findings else "")
    reference, robot_file = _robot_file(folder, recorded)
    robot = read_robot(robot_file)
    texts = product.specialised(specification(robot, reference))
    mend = f"pkmodes generate {_shown(robot_file)} --out {_shown(folder)}"
    findings = _findings(folder, texts, mend)
    checks = _checks(_executed(texts), robot)
    return Report(str(folder), findings, checks, _mend(folder, findings, mend))


def _robot_file(folder: Path, recorded: dict[str, object]) -> tuple[str, Path]:
    """The robot file that a manifest names, as it names it and where it is."""
    owner = recorded.get("robot")
    reference = owner.get("file") if isinstance(owner, dict) else None
    remedy = "put it back, or generate the model again with: pkmodes generate ROBOT.toml --out DIR"
    place = str(folder / "manifest.json")
    if not isinstance(reference, str):
        raise PkmodesError("the manifest names no robot file", place, remedy)
    try:
        found = (folder / reference).is_file()
    except (OSError, ValueError):  # a name that cannot be one of a file
        found = False
    if not found:
        what = f"the robot file {shown(reference)} that this model was generated from is not there"
        raise RobotFileError([PkmodesError(what, place, remedy)])
    return reference, folder / reference


def _mend(folder: Path, findings: list[Any], generate: str) -> str:
    """Commands that mend what was found: remove what does not belong, generate the rest."""
    orphans = [finding for finding in findings if finding.cause == "orphan"]
    commands = [f"rm -r {_shown(folder / finding.subject)}" for finding in orphans]
    if len(findings) > len(orphans):
        commands.append(generate)
    return " && ".join(commands)


def check_robot(robot_file: Path) -> Report:
    """Check the model that a robot file gives: derived afresh, consistent, and equal to the parametric one.

    Raises
    ------
    RobotFileError
        If the robot file is wrong.
    """
    robot = read_robot(robot_file)
    texts = derivation("emit.product").specialised(specification(robot, robot_file.name))
    module = _executed(texts)
    return Report(str(robot_file), [], _checks(module, robot))


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
    """A path as a person can paste it: relative where it is below the working directory, and quoted."""
    resolved, here = path.resolve(), Path.cwd()
    below = resolved != here and resolved.is_relative_to(here) and here != Path(here.anchor)
    text = str(resolved.relative_to(here) if below else resolved)
    return shlex.quote(f"./{text}" if text.startswith("-") else text)


def _executed(texts: dict[str, str]) -> types.ModuleType:
    """Execute the NumPy module of a product that was derived a moment ago."""
    name = next(name for name in texts if name.endswith(".py"))
    module = types.ModuleType(name.removesuffix(".py"))
    exec(compile(texts[name], name, "exec"), module.__dict__)
    return module


def _checks(module: types.ModuleType, robot: Robot) -> list[Check]:
    """Differences, and equality with the model that pkmodes evaluates."""
    effects = bool(active_effects(robot.effects))
    parametric = Generated(linear_delta, robot.parameters)
    return [
        *check_consistency(Generated(module), robot.parameters, effects),
        *_equality(module, parametric, robot),
    ]


def _equality(module: types.ModuleType, parametric: Generated, robot: Robot) -> list[Check]:
    """Constants folded or given as parameters: the same matrices, of the coordinates with inertia and of all."""
    p = regular_poses(parametric, robot.parameters)
    if not len(p):
        return []
    expected = evaluation(robot.parameters, robot.effects)
    M, K = expected.matrices(p)
    kept = [expected.coordinates.index(name) for name in module.COORDINATES]
    massless = [i for i in range(M.shape[-1]) if i not in kept]
    every = np.zeros((len(p), M.shape[-1], len(kept)))
    every[:, kept, range(len(kept))] = 1.0
    wanted_M, wanted_K = M[:, kept][..., kept], K[:, kept][..., kept]
    size = _sizes(wanted_K)
    pairs: list[tuple[str, Array, Array, Array | float]] = []
    if massless:
        follow = -np.linalg.solve(K[:, massless][..., massless], K[:, massless][..., kept])
        every[:, massless] = follow
        wanted_K = wanted_K + K[:, kept][..., massless] @ follow
        all_M, all_K = module.uncondensed_matrices(p)
        pairs = [
            ("uncondensed M", all_M, M, _sizes(M)),
            ("uncondensed K", all_K, K, _sizes(K)),
            ("condensation", module.condensation(p), every, 0.0),
        ]
    found_M, found_K = module.modal_matrices(p)
    pairs = [("M", found_M, wanted_M, _sizes(wanted_M)), ("K", found_K, wanted_K, size), *pairs]
    pairs.append(("torques", module.static_equilibrium(p)[0], expected.statics(p)[0], 0.0))
    if hasattr(module, "platform_motion"):
        motion = expected.platform_motion(p) @ every
        pairs.append(("platform motion", module.platform_motion(p), motion, 0.0))
    return [
        Check(f"{name} of the parametric model", _relative(found, wanted, scale), 1e-12)
        for name, found, wanted, scale in pairs
    ]


def _sizes(matrix: Array) -> Array:
    """Size of the terms of each entry of a symmetric matrix: a stiff joint must not hide the others."""
    root = np.sqrt(np.abs(np.diagonal(matrix, axis1=-2, axis2=-1)))
    return np.asarray(root[..., :, None] * root[..., None, :])


def _relative(found: Array, expected: Array, size: Array | float) -> float:
    """Largest error by the size of the entries, or of the largest where they have none of their own."""
    if found.shape != expected.shape:
        return float("inf")
    largest = float(np.max(np.abs(expected), initial=0.0)) or 1.0
    scale = np.where(np.asarray(size) > 0.0, size, largest)
    return float(np.max(np.abs(found - expected) / scale))
