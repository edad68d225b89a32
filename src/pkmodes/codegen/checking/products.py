"""Check whether generated code is up to date and correct.

Targets are a committed model, a robot file, and a generated folder, of a robot or of a user-defined mechanism.  The
fresh derivation is executed, and so is the definition of a mechanism that is stored in its folder; other files are
only compared.
"""

from __future__ import annotations

import stat
import types
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.codegen.checking.consistency import Check, check_consistency, check_drawing
from pkmodes.codegen.derivation import (
    add_effects,
    derive_mechanism,
    import_derivation,
    python_text,
    read_definition,
    read_effect,
    staged_mechanism,
)
from pkmodes.codegen.generation import derive_robot_model, specification
from pkmodes.codegen.product_folder import MANIFEST
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.mechanism import registry
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.packages import DEFINITION_FILE
from pkmodes.core.mechanism.regular import regular_poses, sample_parameters
from pkmodes.core.robot.reading import read_robot, robot_from_document
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.variants import document_of
from pkmodes.core.support.pasting import shell_path
from pkmodes.core.system.evaluation import evaluation, matrices
from pkmodes.core.system.released import active_effects

REGENERATE = "python -m pkmodes_derive generate"

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Report:
    """Report on one target.

    - target: the folder or robot file that was checked
    - findings: reasons why it is not up to date (`pkmodes_derive.emit.currency.Finding`); empty if it is
    - checks: finite-difference consistency
    - fix_command: command that fixes the findings, empty if there is nothing to fix
    - unchecked: items that could not be checked, with their remedies
    """

    target: str
    findings: list[Any] = field(default_factory=list)
    checks: list[Check] = field(default_factory=list)
    fix_command: str = ""
    unchecked: tuple[str, ...] = ()

    @property
    def holds(self) -> bool:
        """Whether everything that could be checked is up to date and consistent."""
        return not self.findings and all(check.holds for check in self.checks)


def check_committed(name: str) -> Report:
    """Check a parametric model supplied with pkmodes; its derivatives are checked for an asymmetric robot.

    - name: the mechanism
    """
    mechanism = registry.mechanism(name)
    folder = Path(str(files(mechanism.package)))
    add_effects(name, [])
    findings = _findings_of(folder, import_derivation("emit.product").parametric(name))
    return Report(str(folder), findings, _checks_of_sample(mechanism), REGENERATE if findings else "")


def check_folder(folder: Path) -> Report:
    """Check a folder that `pkmodes generate` wrote.

    The fresh derivation is executed, never a file that may have been edited: if the two are equal, the check applies
    to both; if they differ, the difference is reported.  If the folder was copied without its robot file, the robot
    recorded in the manifest is used, and only the comparison with the robot file is left unchecked.

    Raises PkmodesError if the folder holds no generated code, its robot file is invalid, or its manifest does not
    record a robot.
    """
    manifest_file = folder / MANIFEST
    remedy = "give a folder written by: pkmodes generate ROBOT.toml --out DIR"
    if not manifest_file.is_file():
        raise PkmodesError("expected a generated model, found no manifest.json", str(folder), remedy)
    try:
        manifest: dict[str, Any] = import_derivation("emit.currency").read_manifest(folder)
    except (ValueError, OSError) as error:
        raise PkmodesError(f"the manifest cannot be read: {error}", str(manifest_file), remedy) from None
    is_user_defined = "definition" in manifest or "effects" in manifest
    if "robot" not in manifest and is_user_defined:
        return _check_mechanism(folder, manifest)
    if "robot" not in manifest and manifest.get("product") in registry.supplied_names():
        add_effects(manifest["product"], [])
        findings = _findings_of(folder, import_derivation("emit.product").parametric(manifest["product"]))
        return Report(str(folder), findings, [], REGENERATE if findings else "")
    if not is_user_defined:
        return _check_model(folder, manifest)
    name = manifest.get("mechanism")
    if name in registry.names() and "effects" not in manifest:
        return _check_model(folder, manifest)
    mechanism_folder = folder / str(name)
    if not mechanism_folder.is_dir():
        problem = f"the model's mechanism {shown(name)} is unknown, and its code is not in this folder"
        remedy = "give the folder with the code of the mechanism: --mechanism DIR/<mechanism>"
        raise PkmodesError(problem, str(folder), remedy)
    with registry.temporarily_registered(mechanism_folder):
        return _check_model(folder, manifest)


def _findings_of(folder: Path, fresh: dict[str, str]) -> list[Any]:
    """Return the reasons why a folder differs from a fresh derivation."""
    currency = import_derivation("emit.currency")
    if not (folder / MANIFEST).is_file():
        return [currency.Finding("missing", "manifest.json", "manifest.json is missing")]
    try:
        manifest = currency.read_manifest(folder)
    except (ValueError, OSError) as error:
        return [currency.Finding("manifest", "manifest.json", f"manifest.json cannot be read: {error}")]
    findings: list[Any] = currency.compare(folder, manifest, fresh)
    return findings


def _check_mechanism(folder: Path, manifest: dict[str, Any]) -> Report:
    """Check the folder of a mechanism that was generated from a user's files: a definition, effects, or both.

    - manifest: its manifest

    Raises PkmodesError if the definition or an effect is missing or invalid.
    """
    name, reference = manifest.get("product"), manifest.get("definition", "")
    effect_copies = manifest.get("effects", {})
    if not isinstance(name, str) or not isinstance(reference, str) or not isinstance(effect_copies, dict):
        remedy = "generate it again with: pkmodes generate --mechanism FILE.py ROBOT.toml --out DIR"
        raise PkmodesError("the manifest does not name a mechanism", str(folder / MANIFEST), remedy)
    definition = read_definition(folder / DEFINITION_FILE, name) if reference else None
    copies = {path: read_effect(folder / str(copy)) for path, copy in effect_copies.items()}
    fresh = derive_mechanism(name, definition, reference, copies)
    sources = [(reference, f"{name}.py", "definition", "--mechanism")] if reference else []
    sources += [(path, copy.file.name, "effect", "--effect") for path, copy in copies.items()]
    findings, unchecked, options = _findings_of(folder, fresh), list[str](), list[str]()
    for path, source, noun, option in sources:
        more_findings, more_unchecked = _check_given_file(folder, path, source, noun)
        findings, unchecked = [*findings, *more_findings], [*unchecked, *more_unchecked]
        options.append(f"{option} {'FILE.py' if more_unchecked else shell_path(folder / path)}")
    with staged_mechanism(name, fresh) as mechanism:
        checks = _checks_of_sample(mechanism)
    command = (
        f"pkmodes generate {' '.join(options)} ROBOT.toml --out {shell_path(folder.parent)}"
        if findings
        else ""
    )
    return Report(str(folder), findings, checks, command, tuple(unchecked))


def _check_model(folder: Path, manifest: dict[str, Any]) -> Report:
    """Check the model of a robot whose mechanism is known."""
    reference, exists = _robot_file(folder, manifest)
    definition = str(manifest.get("definition", ""))
    command = (
        f"pkmodes generate --mechanism {shell_path(folder / definition)}"
        if definition
        else "pkmodes generate"
    )
    if exists:
        robot, command = read_robot(folder / reference), f"{command} {shell_path(folder / reference)}"
        unchecked = []
    else:
        robot, command = recorded_robot(manifest, str(folder / MANIFEST)), f"{command} ROBOT.toml"
        unchecked = [
            f"whether the robot file {shown(reference)} has changed since this model was generated: it does not "
            f"exist; restore it, or give the file of {shown(robot.name)} with: "
            f"pkmodes generate ROBOT.toml --out {shell_path(folder)}"
        ]
    texts = derive_robot_model(specification(robot, reference, definition))
    findings = _findings_of(folder, texts)
    if definition and not (folder / definition).is_dir():
        more_findings, more_unchecked = _check_given_file(
            folder, definition, f"{robot.mechanism_name}.py", "definition"
        )
        findings, unchecked = [*findings, *more_findings], [*unchecked, *more_unchecked]
    # Files that do not belong are removed, and the rest is generated.
    orphans = [finding for finding in findings if finding.cause == "orphan"]
    commands = [f"rm {shell_path(folder / finding.subject)}" for finding in orphans]
    if len(findings) > len(orphans):
        commands.append(f"{command} --out {shell_path(folder)}")
    return Report(
        str(folder), findings, _checks_of_robot(texts, robot), " && ".join(commands), tuple(unchecked)
    )


def _check_given_file(folder: Path, reference: str, source: str, noun: str) -> tuple[list[Any], list[str]]:
    """Check whether a file has changed since a mechanism was derived from it; return findings and unchecked items.

    - reference: path of the file relative to the folder
    - source: its name among the sources of the manifest
    - noun: what it is called: "definition" or "effect"
    """
    try:
        text = python_text(folder / reference, noun, "")
    except PkmodesError:
        return [], [f"whether the {noun} {shown(reference)} has changed: it cannot be read"]
    digests = import_derivation("emit.currency").read_manifest(folder)["sources"]
    if digests.get(source) == import_derivation("sources").digest(text):
        return [], []
    file = (folder / reference).name
    message = f"the {noun} changed: {file} differs from the file this was derived from"
    return [import_derivation("emit.currency").Finding("derivation", reference, message)], []


def _robot_file(folder: Path, manifest: dict[str, object]) -> tuple[str, bool]:
    """Return the robot file named in a manifest, and whether it exists."""
    robot = manifest.get("robot")
    reference = robot.get("file") if isinstance(robot, dict) else None
    remedy = "restore it, or generate the model again with: pkmodes generate ROBOT.toml --out DIR"
    if not isinstance(reference, str):
        raise PkmodesError("the manifest does not name a robot file", str(folder / MANIFEST), remedy)
    try:
        regular_file = stat.S_ISREG((folder / reference).stat().st_mode)
    except (FileNotFoundError, NotADirectoryError):
        return reference, False
    except (OSError, ValueError):  # not a valid file name
        regular_file = False
    if not regular_file:
        problem = f"the manifest names {shown(reference)}, which cannot be a robot file"
        raise PkmodesError(problem, str(folder / MANIFEST), remedy)
    return reference, True


def recorded_robot(manifest: Mapping[str, Any], source: str) -> Robot:
    """Read a robot from the values in a manifest, which are in SI units and complete.

    - manifest: the manifest
    - source: the manifest's file, for messages

    Raises PkmodesError if the manifest does not record a valid robot.
    """
    try:
        values = manifest["robot"]["values"]
        mechanism = registry.mechanism(manifest["mechanism"])
        robot = robot_from_document(document_of(mechanism, manifest["robot"]["name"], values), source)
        is_same = robot.declared == values
    except (PkmodesError, LookupError, TypeError, ValueError, AttributeError):
        is_same = False
    if not is_same:
        raise PkmodesError(
            "the manifest does not record the robot that the model was generated with",
            source,
            "restore its robot file, or generate the model again with: pkmodes generate ROBOT.toml --out DIR",
        )
    return robot


def check_robot(robot_file: Path) -> Report:
    """Derive the model of a robot file and check that it is consistent and equal to the parametric model.

    Raises RobotFileError if the robot file is invalid.
    """
    robot = read_robot(robot_file)
    texts = derive_robot_model(specification(robot, robot_file.name))
    return Report(str(robot_file), [], _checks_of_robot(texts, robot))


def _checks_of_sample(mechanism: registry.Mechanism) -> list[Check]:
    """Check the parametric model of a mechanism for an asymmetric robot."""
    parameters = sample_parameters(mechanism)
    checks = check_consistency(Generated(mechanism.model, parameters), mechanism, parameters)
    return [*checks, *check_drawing(mechanism, parameters)]


def _checks_of_robot(texts: dict[str, str], robot: Robot) -> list[Check]:
    """Check the modules of a robot: with its effects, and then without them."""
    with_effects, *without_effects = (name for name in texts if name.endswith(".py"))
    all_checks = _checks_of_module(_execute_module({with_effects: texts[with_effects]}), robot)
    for name in without_effects:
        checks = _checks_of_module(_execute_module({name: texts[name]}), replace(robot, effects={}))
        all_checks += [replace(check, name=f"{check.name}, without effects") for check in checks]
    return all_checks


def _execute_module(texts: dict[str, str]) -> types.ModuleType:
    """Execute the NumPy module of a freshly derived model."""
    (name,) = texts
    module = types.ModuleType(name.removesuffix(".py"))
    exec(compile(texts[name], name, "exec"), module.__dict__)
    return module


def _checks_of_module(module: types.ModuleType, robot: Robot) -> list[Check]:
    """Check a module against finite differences and against the model that pkmodes evaluates."""
    mechanism = robot.mechanism
    effects = bool(active_effects(mechanism, robot.effects))
    return [
        *check_consistency(Generated(module), mechanism, robot.parameters, effects),
        *_parametric_checks(module, robot),
    ]


def _parametric_checks(module: types.ModuleType, robot: Robot) -> list[Check]:
    """Check that a module with folded constants gives the same matrices as the parametric model.

    Both the condensed matrices, of the coordinates with inertia, and the matrices of all coordinates are compared.
    """
    mechanism = robot.mechanism
    p = regular_poses(Generated(mechanism.model, robot.parameters), mechanism, robot.parameters)
    if not len(p):
        return []
    expected = evaluation(robot)
    M, K = matrices(expected, p)
    with_inertia = [expected.coordinates.index(name) for name in module.COORDINATES]
    massless = [i for i in range(M.shape[-1]) if i not in with_inertia]
    expansion = np.zeros((len(p), M.shape[-1], len(with_inertia)))
    expansion[:, with_inertia, range(len(with_inertia))] = 1.0
    expected_M, expected_K = M[:, with_inertia][..., with_inertia], K[:, with_inertia][..., with_inertia]
    K_scales = _entry_scales(expected_K)
    pairs: list[tuple[str, Array, Array, Array | float]] = []
    if massless:
        condensation = -np.linalg.solve(K[:, massless][..., massless], K[:, massless][..., with_inertia])
        expansion[:, massless] = condensation
        expected_K = expected_K + K[:, with_inertia][..., massless] @ condensation
        all_M, all_K = module.uncondensed_matrices(p)
        pairs = [
            ("uncondensed M", all_M, M, _entry_scales(M)),
            ("uncondensed K", all_K, K, _entry_scales(K)),
            ("condensation", module.condensation(p), expansion, 0.0),
        ]
    actual_M, actual_K = module.modal_matrices(p)
    pairs = [
        ("M", actual_M, expected_M, _entry_scales(expected_M)),
        ("K", actual_K, expected_K, K_scales),
        *pairs,
    ]
    pairs.append(("torques", module.static_equilibrium(p)[0], expected.statics(p)[0], 0.0))
    if hasattr(module, "platform_motion"):
        motion = expected.platform_motion(p) @ expansion
        pairs.append(("platform motion", module.platform_motion(p), motion, 0.0))
    return [
        Check(f"{name} of the parametric model", _relative_error(value, reference, scale), 1e-12)
        for name, value, reference, scale in pairs
    ]


def _entry_scales(matrix: Array) -> Array:
    """Return the scale of each entry of a symmetric matrix, so that a stiff joint does not hide the others."""
    root = np.sqrt(np.abs(np.diagonal(matrix, axis1=-2, axis2=-1)))
    return np.asarray(root[..., :, None] * root[..., None, :])


def _relative_error(value: Array, expected: Array, size: Array | float) -> float:
    """Return the largest error relative to the scale of each entry, or to the largest entry if its scale is zero."""
    if value.shape != expected.shape:
        return float("inf")
    largest = float(np.max(np.abs(expected), initial=0.0)) or 1.0
    scale = np.where(np.asarray(size) > 0.0, size, largest)
    return float(np.max(np.abs(value - expected) / scale))
