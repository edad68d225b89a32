"""Is generated code current and right?  The committed model, a generated folder, or a robot file."""

from __future__ import annotations

import stat
import types
from importlib.resources import files
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.checking.consistency import Check, check_consistency
from pkmodes.checking.own_mechanisms import check_definition, check_mechanism
from pkmodes.checking.recorded import recorded_robot
from pkmodes.checking.report import Report, findings_of, manifest_of
from pkmodes.derivation import derivation
from pkmodes.errors import PkmodesError, shown
from pkmodes.evaluation import active_effects, evaluation, matrices
from pkmodes.generated import Generated
from pkmodes.generation import specialised, specification
from pkmodes.mechanism import meanwhile, mechanism, names, supplied
from pkmodes.pasting import pasted
from pkmodes.product_folder import MANIFEST
from pkmodes.regular import regular_poses, sample
from pkmodes.robot.reading import read_robot
from pkmodes.robot.robot import Robot

REGENERATE = "python -m pkmodes_derive generate"

Array = NDArray[np.float64]


def check_committed(name: str) -> Report:
    """Check a parametric model that pkmodes itself evaluates, its derivatives for a robot without symmetry.

    Parameters
    ----------
    name : str
        The mechanism.
    """
    kind = mechanism(name)
    folder = Path(str(files(kind.package)))
    findings = findings_of(folder, derivation("emit.product").parametric(name))
    parameters = sample(kind)
    checks = check_consistency(Generated(kind.model, parameters), kind, parameters)
    return Report(str(folder), findings, checks, REGENERATE if findings else "")


def check_folder(folder: Path) -> Report:
    """Check a folder that `pkmodes generate` wrote.

    What is executed is the fresh derivation, never a file that somebody may have edited: where the two are
    the same, the check holds for both, and where they differ, that is found.  Where the folder was copied
    without its robot file, the robot is the one that the manifest records; whether the file says the same is
    then left unchecked, and nothing else.

    Raises
    ------
    PkmodesError
        If the folder holds no product, its robot file is wrong, or its manifest does not record a robot.
    """
    recorded = manifest_of(folder)
    if "robot" not in recorded and recorded.get("product") in supplied():
        findings = findings_of(folder, derivation("emit.product").parametric(recorded["product"]))
        return Report(str(folder), findings, [], REGENERATE if findings else "")
    if "definition" not in recorded:
        return _check_model(folder, recorded)
    if "robot" not in recorded:
        return check_mechanism(folder, recorded)
    name = recorded.get("mechanism")
    if name in names():
        return _check_model(folder, recorded)
    inner = folder / str(name)
    if not inner.is_dir():
        what = f"the model is one of the mechanism {shown(name)}, which is not known, and not in this folder either"
        remedy = "say where the code of the mechanism is: --mechanism DIR/<mechanism>"
        raise PkmodesError(what, str(folder), remedy)
    with meanwhile(inner):
        return _check_model(folder, recorded)


def _check_model(folder: Path, recorded: dict[str, Any]) -> Report:
    """Check the model of a robot whose mechanism is known."""
    reference, there = _robot_file(folder, recorded)
    definition = str(recorded.get("definition", ""))
    command = (
        f"pkmodes generate --mechanism {pasted(folder / definition)}" if definition else "pkmodes generate"
    )
    if there:
        robot, command = read_robot(folder / reference), f"{command} {pasted(folder / reference)}"
        unchecked = []
    else:
        robot, command = recorded_robot(recorded, str(folder / MANIFEST)), f"{command} ROBOT.toml"
        unchecked = [_without_robot_file(folder, reference, robot.name)]
    texts = specialised(specification(robot, reference, definition))
    findings = findings_of(folder, texts)
    if definition and not (folder / definition).is_dir():
        changed, left = check_definition(folder, definition, robot.mechanism)
        findings, unchecked = [*findings, *changed], [*unchecked, *left]
    mend = _mend(folder, findings, f"{command} --out {pasted(folder)}")
    return Report(str(folder), findings, _checks(_executed(texts), robot), mend, tuple(unchecked))


def _without_robot_file(folder: Path, reference: str, name: str) -> str:
    return (
        f"whether the robot file {shown(reference)} still says what this model was generated with: it is not "
        f"there; put it back, or give the file of {shown(name)} with: "
        f"pkmodes generate ROBOT.toml --out {pasted(folder)}"
    )


def _robot_file(folder: Path, recorded: dict[str, object]) -> tuple[str, bool]:
    """The robot file as a manifest names it, and whether it is there."""
    owner = recorded.get("robot")
    reference = owner.get("file") if isinstance(owner, dict) else None
    remedy = "put it back, or generate the model again with: pkmodes generate ROBOT.toml --out DIR"
    if not isinstance(reference, str):
        raise PkmodesError("the manifest names no robot file", str(folder / MANIFEST), remedy)
    try:
        found = stat.S_ISREG((folder / reference).stat().st_mode)
    except (FileNotFoundError, NotADirectoryError):
        return reference, False
    except (OSError, ValueError):  # a name that cannot be one of a file
        found = False
    if not found:
        what = f"the manifest names {shown(reference)}, which cannot be a robot file"
        raise PkmodesError(what, str(folder / MANIFEST), remedy)
    return reference, True


def _mend(folder: Path, findings: list[Any], generate: str) -> str:
    """Commands that mend what was found: remove what does not belong, generate the rest."""
    orphans = [finding for finding in findings if finding.cause == "orphan"]
    commands = [f"rm {pasted(folder / finding.subject)}" for finding in orphans]
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
    texts = specialised(specification(robot, robot_file.name))
    module = _executed(texts)
    return Report(str(robot_file), [], _checks(module, robot))


def _executed(texts: dict[str, str]) -> types.ModuleType:
    """Execute the NumPy module of a product that was derived a moment ago."""
    name = next(name for name in texts if name.endswith(".py"))
    module = types.ModuleType(name.removesuffix(".py"))
    exec(compile(texts[name], name, "exec"), module.__dict__)
    return module


def _checks(module: types.ModuleType, robot: Robot) -> list[Check]:
    """Differences, and equality with the model that pkmodes evaluates."""
    kind = robot.kind
    effects = bool(active_effects(kind, robot.effects))
    return [*check_consistency(Generated(module), kind, robot.parameters, effects), *_equality(module, robot)]


def _equality(module: types.ModuleType, robot: Robot) -> list[Check]:
    """Constants folded or given as parameters: the same matrices, of the coordinates with inertia and of all."""
    kind = robot.kind
    p = regular_poses(Generated(kind.model, robot.parameters), kind, robot.parameters)
    if not len(p):
        return []
    expected = evaluation(robot)
    M, K = matrices(expected, p)
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
