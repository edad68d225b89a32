"""What pkmodes says of a machine with six legs, against its oracle: errors of each result, and what they may be."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

import pkmodes
from helpers.references.oracle_six_legged import Result, modes, oracle, result
from helpers.robots.six_legged import Case, Machine, effects, toml_text, with_effects
from pkmodes_rig.mujoco_six_legged import Engine

#: Largest errors: what they are relative to is said in `errors`.  Of ten decimals fewer than the oracle has, most are
#: rounding amplified by the condition of the platform's Jacobian, at most 20 for the machines that are drawn.
TOLERANCES = {
    "joint positions": 1e-14,
    "mass matrix": 1e-12,
    "stiffness matrix": 1e-12,
    "stiffness of gravity": 1e-8,
    "statics": 1e-11,
    "free eigenvalues": 1e-12,
    "free frequencies": 1e-9,
    "free shapes": 1e-10,
    "free platform": 1e-11,
    "held eigenvalues": 1e-12,
    "held frequencies": 1e-9,
    "held shapes": 1e-10,
    "held platform": 1e-11,
}
#: The same for MuJoCo.  The engine requires some mass on each universal joint, and its stiffness of gravity is of
#: differences: rounding over their step.
ENGINE_TOLERANCES = {
    "mass matrix": 1e-10,
    "springs": 1e-13,
    "platform": 1e-12,
    "weight": 1e-11,
    "stiffness of gravity": 1e-8,
}
#: Eigenvalues below this part of the largest are compared relative to the largest only: its rounding, 1e-16, is a
#: relative error of 1e-9 there, as much as is allowed for a frequency.
NEARLY_AT_REST = 1e-7
#: What the machines in MuJoCo have beside the base model.
IN_THE_ENGINE = ("payload", "frame_compliance", "link_compliance")


def load(machine: Machine, folder: Path) -> pkmodes.Model:
    path = folder / f"{machine['name']}.toml"
    path.write_text(toml_text(machine), encoding="utf-8")
    return pkmodes.load(path)


def by_diagonal(found: np.ndarray, expected: np.ndarray) -> float:
    """Largest error of an entry, relative to the roots of its diagonal entries: units differ."""
    size = np.sqrt(np.abs(np.diag(expected)))
    scale = np.outer(size, size)
    rest = scale == 0  # a clamp without inertia has no coupling inertia either
    assert not found[rest].any()
    return float((np.abs(found - expected)[~rest] / scale[~rest]).max())


def relative(found: Any, expected: Any) -> float:
    """Largest error relative to the largest entry; of zeros, whatever is found."""
    size = float(np.abs(expected).max()) or 1.0
    return float(np.abs(np.asarray(found) - expected).max() / size)


def errors(case: Case, folder: Path) -> dict[str, float]:
    """Errors of everything that a robot file's user sees at a pose."""
    model, expected = load(case.machine, folder), result(case.machine, case.pose)
    return matrix_errors(model, case, expected) | mode_errors(model, case, expected)


def matrix_errors(model: pkmodes.Model, case: Case, expected: Result) -> dict[str, float]:
    """Errors of where the drives are, of the matrices, and of the forces of the drives."""
    assert model.coordinates == expected.coordinates
    M, K = model.matrices(case.pose)
    # rounding of the springs, which are 1e2 to 1e6 times as stiff, is in it
    of_gravity = np.abs(K - expected.K)[:6, :6].max() / np.abs(expected.K_g[:6, :6]).max()
    return {
        "joint positions": relative(model.inverse_kinematics(case.pose), expected.independent),
        "mass matrix": by_diagonal(M, expected.M),
        "stiffness matrix": by_diagonal(K, expected.K),
        "stiffness of gravity": float(of_gravity),
        "statics": relative(model.statics(case.pose).torques, expected.statics),
    }


def mode_errors(model: pkmodes.Model, case: Case, expected: Result) -> dict[str, float]:
    """Errors of frequencies and shapes."""
    found: dict[str, float] = {}
    for drives in ("free", "held"):
        found |= _of_modes(model, case, expected, drives)
    return found


def _of_modes(model: pkmodes.Model, case: Case, expected: Result, drives: str) -> dict[str, float]:
    motors = expected.motors if drives == "held" else None
    exact = modes(expected.M, expected.K, motors)
    found = model.modes(case.pose, drives=drives)
    assert found.frequencies.shape == exact.frequencies.shape
    eigenvalues = np.sign(found.frequencies) * (2 * np.pi * found.frequencies) ** 2
    top = exact.eigenvalues[-1]
    known = np.abs(exact.eigenvalues) > NEARLY_AT_REST * top
    known[: found.rigid_modes] = False
    # each shape is a solution of the oracle's equations of motion, and has its norm: no need to sort close modes
    residual = expected.K @ found.shapes.T - expected.M @ found.shapes.T * eigenvalues
    loads = residual.T
    if motors is not None:
        assert found.rigid_modes == 0
        assert np.abs(found.shapes @ motors.T).max() < 1e-12 * np.abs(found.shapes).max()
        # held motors take any load along their own coordinates
        loads = loads - loads @ np.linalg.pinv(motors) @ motors
    size = np.abs(expected.K) @ np.abs(found.shapes.T) + np.abs(expected.M) @ np.abs(found.shapes.T) * top
    norms = found.shapes @ expected.M @ found.shapes.T
    platform = found.shapes @ expected.platform.T
    scale = np.abs(platform).max(axis=0)
    return {
        f"{drives} eigenvalues": relative(eigenvalues, exact.eigenvalues),
        f"{drives} frequencies": float(np.abs(found.frequencies[known] / exact.frequencies[known] - 1).max()),
        f"{drives} shapes": max(
            float((np.abs(loads.T) / size.max(axis=0)).max()), relative(norms, np.eye(len(norms)))
        ),
        f"{drives} platform": float((np.abs(found.platform_shapes - platform) / scale).max()),
    }


def disagreements(found: dict[str, float]) -> dict[str, float]:
    """Those that exceed what rounding explains."""
    return {name: error for name, error in found.items() if not error <= TOLERANCES[name]}


def engine_errors(case: Case) -> dict[str, float]:
    """Errors of the oracle, taken for those of MuJoCo, where the latter has the effects."""
    case = with_effects(case, [name for name in IN_THE_ENGINE if name in effects(case)])
    engine, expected, it = Engine(*case), result(*case), oracle(*case)
    assert len(engine.names) == len(expected.coordinates)
    loads = np.array([float(load) for load in it.gravity_gradient()[:6]])
    return {
        "mass matrix": by_diagonal(engine.mass_matrix(), expected.M),
        "springs": relative(engine.elastic_hessian(), expected.K_el),
        "platform": relative(engine.platform_motion(), expected.platform),
        "weight": relative(engine.gravity_gradient()[:6], loads),
        "stiffness of gravity": relative(engine.gravity_hessian(), expected.K_g),
    }
