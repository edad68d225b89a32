"""Code for one robot with effects: the same interface as without, and an eigenproblem for any solver."""

from __future__ import annotations

import re
import tomllib
import types
from collections.abc import Callable
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigh

import pkmodes
from helpers.generated.compiled import build, call
from helpers.robots.dissipating import dissipating
from helpers.robots.sample_robots import ROBOTS
from helpers.runs.shared import Shared
from pkmodes.codegen.generation import specification
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.robot.reading import robot_from_document
from pkmodes_derive.emit import product

#: Makes the model, the generated module and the texts of a robot file with some effects.
Sample = Callable[[str, tuple[str, ...]], tuple[pkmodes.Model, types.ModuleType, dict[str, str]]]

#: A robot of each mechanism; of the linear deltas the one whose axes differ.
NAMES = ("linear-delta-2022-identified.toml", "clavel-delta.toml", "corexy-printer.toml")
ROBOT = NAMES[0]
POSE = np.array([0.6, 0.03, -0.245])
POSES = {
    "linear_delta": POSE,
    "rotary_delta": np.array([0.05, 0.03, -0.6]),
    "corexy": np.array([0.1, 0.22]),
}
VALUES: dict[str, dict[str, float]] = {
    "payload": {"mass": 0.35},
    "belt_mass": {"linear_density": 0.06},
    "gearbox_inertia": {"inertia": 2e-4},
    "servo_stiffness": {"stiffness": 500.0},
    "belt_end_compliance": {"compliance": 1e-7},
    "axis_belt_stiffness": {"factor_1": 0.05, "factor_2": -0.1},
    "axis_reducer_stiffness": {"factor_1": 0.05, "factor_2": -0.1, "factor_3": 0.02},
    "belt_tension_stiffness": {"coefficient": 0.01, "tension": 20.0},
    "cable_stiffness": {"stiffness": 1000.0},
    "gearbox_compliance": {"compliance": 1e-3},
    "link_compliance": {"compliance": 1e-7},
    "clamp_compliance": {"compliance": 1e-7},
    "frame_compliance": {"compliance": 1e-8},
    "gantry_racking": {"compliance": 1e-4, "inertia": 0.02, "center": 0.14},
    "belt_loss": {"loss_factor": 0.02},
    "reducer_loss": {"loss_factor": 0.03},
    "rail_friction": {"viscous": 20.0},
    "drive_friction": {"viscous": 1e-3},
}
#: Those that change M or K, and some of them together.
COMBINATIONS = (
    *((name,) for name in VALUES if not any(name in dissipating(each) for each in POSES)),
    ("belt_mass", "clamp_compliance"),
    ("payload", "gearbox_compliance", "clamp_compliance"),
    ("cable_stiffness", "clamp_compliance", "frame_compliance"),
)


@cache
def document(name: str) -> dict:
    return tomllib.loads((ROBOTS / name).read_text(encoding="utf-8"))


def applies(effects: tuple[str, ...], name: str) -> bool:
    return set(effects) <= mechanism(document(name)["mechanism"]).effects.keys()


def robot(name: str, effects: tuple[str, ...], **tables: dict) -> pkmodes.Model:
    content = {
        **document(name),
        "name": "sample",
        "drives": "free",
        "effects": {e: VALUES[e] for e in effects},
    }
    content.update({key: {**content.get(key, {}), **table} for key, table in tables.items()})
    return pkmodes.Model(robot_from_document(content, "sample.toml"))


def emitted(model: pkmodes.Model) -> dict[str, str]:
    return product.specialised(specification(model.robot, "sample.toml"))


def executed(texts: dict[str, str]) -> types.ModuleType:
    module = types.ModuleType("sample")
    exec(compile(texts["sample.py"], "sample.py", "exec"), module.__dict__)
    return module


@pytest.fixture(scope="module")
def sample(shared: Shared) -> Sample:
    """Return a robot file with effects as a model, its generated module, and the texts of all files."""

    @cache
    def made(name: str, effects: tuple[str, ...]) -> tuple[pkmodes.Model, types.ModuleType, dict[str, str]]:
        model = robot(name, effects)
        texts = shared.value(f"single_{name}_{'+'.join(effects)}", lambda: emitted(model))
        return model, executed(texts), texts

    return made


#: Combinations of effects for the linear delta, then for a robot of each kind.
COMBINED = [pytest.param(c, id="+".join(c)) for c in COMBINATIONS if applies(c, ROBOT)]
CASES = [
    pytest.param(name, effects, id=f"{name}-{'+'.join(effects)}")
    for name in NAMES
    for effects in COMBINATIONS
    if applies(effects, name)
]
#: Effects that only dissipate, alone and behind a joint that gives way.
DISSIPATING = [
    pytest.param(name, (*joints, *dissipating(document(name)["mechanism"])), id="-".join((name, *joints)))
    for name in NAMES
    for joints in ((), ("gearbox_compliance",), ("clamp_compliance",))
    if applies(joints, name)
]


def functions(module: types.ModuleType) -> set[str]:
    """Names of the derived functions; what solves the eigenproblem is the same for every robot."""
    return {name for name in module.__all__ if name.islower()} - {"status", "natural_frequencies", "modes"}


def prototypes(texts: dict[str, str]) -> set[str]:
    """Names of the derived functions in C, where shapers are the same for every robot, too."""
    return set(re.findall(r"^void sample_(?!shaped_)(\w+)\(", texts["sample.h"], flags=re.MULTILINE))


def test_every_effect_has_a_case_here() -> None:
    every = {effect for name in NAMES for effect in mechanism(document(name)["mechanism"]).effects}
    assert VALUES.keys() == every


@pytest.mark.parametrize(("name", "effects"), DISSIPATING)
def test_what_dissipates_is_that_of_the_extended_model(
    sample: Sample, name: str, effects: tuple[str, ...]
) -> None:
    """In modal coordinates, where massless ones follow: damping of modes is all that these matrices are for."""
    model, module, texts = sample(name, effects)
    pose = POSES[model.robot.mechanism_name]
    viscous, loss = module.damping_matrix(pose), module.loss_matrix(pose)
    modes = model.modes(pose)
    shapes = modes.shapes
    if hasattr(module, "condensation"):
        shapes = shapes[:, [model.coordinates.index(q) for q in module.COORDINATES]]
    expected = [shapes_by(modes.shapes, matrix[0]) for matrix in model.dissipation.matrices(np.array([pose]))]
    for found, exact in zip((viscous, loss), expected, strict=True):
        assert np.abs(found).max() > 0.0
        np.testing.assert_allclose(shapes_by(shapes, found), exact, rtol=0, atol=1e-10 * np.abs(exact).max())
    assert {"damping_matrix", "loss_matrix"} <= prototypes(texts)


def shapes_by(shapes: np.ndarray, matrix: np.ndarray) -> np.ndarray:
    return np.asarray(shapes @ matrix @ shapes.T)


@pytest.mark.parametrize("effects", COMBINED)
def test_the_interface_is_that_of_a_robot_without_effects(sample: Sample, effects: tuple[str, ...]) -> None:
    _, plain, plain_texts = sample(ROBOT, ())
    model, module, texts = sample(ROBOT, effects)
    condensed = "clamp_compliance" in effects and "belt_mass" not in effects
    own = {"platform_motion"} | ({"condensation", "uncondensed_matrices"} if condensed else set())
    assert len(functions(plain)) == 25
    assert functions(module) == functions(plain) | own
    assert prototypes(plain_texts) == functions(plain)
    assert prototypes(texts) == functions(module)
    assert set(plain.__all__) <= set(module.__all__)
    assert model.modes(POSE).rigid_modes == module.RIGID_MODES
    assert len(module.COORDINATE_UNITS) == len(module.COORDINATES)


@pytest.mark.parametrize(("name", "effects"), CASES)
def test_the_eigenproblem_is_that_of_modes(sample: Sample, name: str, effects: tuple[str, ...]) -> None:
    """Solve with a solver unaware of massless coordinates; shapes equal those of `modes`, including the platform."""
    model, module, texts = sample(name, effects)
    pose = POSES[model.robot.mechanism_name]
    M, K = module.modal_matrices(pose)
    np.linalg.cholesky(M)
    n = len(module.COORDINATES)
    assert M.shape == K.shape == (n, n)
    assert f"pkmodes_real M[{n}][{n}], pkmodes_real K[{n}][{n}]" in re.sub(r"\s+", " ", texts["sample.h"])
    eigenvalues, vectors = eigh(K, M)
    expected = model.modes(pose)
    rigid = expected.rigid_modes
    found = np.sqrt(np.abs(eigenvalues)) / (2.0 * np.pi)
    np.testing.assert_allclose(found[rigid:], expected.frequencies[rigid:], rtol=1e-10)
    # Symmetric robots have repeated modes, so whole sums of shapes are compared: the flexibility.
    every = module.condensation(pose) if hasattr(module, "condensation") else np.eye(n)
    order = module.ALL_COORDINATES if hasattr(module, "condensation") else module.COORDINATES
    assert list(order) == list(model.coordinates)
    flexibility = [(s[:, rigid:] / v[rigid:]) @ s[:, rigid:].T for s, v in (
        (every @ vectors, eigenvalues),
        (expected.shapes.T, (2.0 * np.pi * expected.frequencies) ** 2),
    )]  # fmt: skip
    size = np.sqrt(np.diagonal(flexibility[1]))
    np.testing.assert_array_less(np.abs(flexibility[0] - flexibility[1]), 1e-8 * np.outer(size, size))
    motion = module.platform_motion(pose) @ vectors[:, rigid:]
    of_modes = expected.platform_shapes[rigid:].T
    np.testing.assert_allclose(
        (motion / eigenvalues[rigid:]) @ motion.T,
        (of_modes / (2.0 * np.pi * expected.frequencies[rigid:]) ** 2) @ of_modes.T,
        rtol=0,
        atol=1e-8 * np.abs(of_modes).max() ** 2 / eigenvalues[rigid],
    )


def arguments(module: types.ModuleType, rng: np.random.Generator) -> dict[str, object]:
    n = len(module.COORDINATES)
    return {
        "p": POSE,
        "x": module.inverse_kinematics(POSE),
        "assembly": float(np.sign(module.jacobian_condition(POSE)[0])),
        "x_dot": rng.normal(size=3),
        "q_dot": rng.normal(size=n),
        "delta_q": 1e-3 * rng.normal(size=n),
    }


def results(function: object, inputs: list) -> tuple[np.ndarray, ...]:
    found = function(*inputs)  # type: ignore[operator]
    return found if isinstance(found, tuple) else (found,)


@pytest.mark.compiler
@pytest.mark.parametrize("effects", COMBINED[7:])
def test_c_equals_numpy(sample: Sample, tmp_path: Path, effects: tuple[str, ...]) -> None:
    model, module, texts = sample(ROBOT, effects)
    library = build(tmp_path, "sample", texts)
    given = arguments(module, np.random.default_rng(4))
    for function in product.of_robot(specification(model.robot, "sample.toml")).functions:
        inputs = [given[a.name] for a in function.arguments]
        for a, b in zip(
            call(library, "sample", function, inputs),
            results(getattr(module, function.name), inputs),
            strict=True,
        ):
            # Same operations in the same order; the compiler may fuse a product and a sum.
            np.testing.assert_allclose(a, b, rtol=1e-11, atol=1e-12 * np.abs(b).max(initial=0.0))


@pytest.mark.parametrize(
    ("effect", "tables"),
    [
        ("payload", {"platform": {"mass": 1.5 + 0.35}}),
        ("gearbox_inertia", {"motor": {"inertia": 0.017e-3 + 2e-4 / 100.0}}),
    ],
)
def test_every_function_is_that_of_a_robot_declared_so(
    sample: Sample, effect: str, tables: dict[str, dict]
) -> None:
    """Declaring the effect's contribution in the robot file instead gives the same results from the base model."""
    _, module, _ = sample(ROBOT, (effect,))
    plain = robot(ROBOT, (), **tables)
    declared = executed(emitted(plain))
    given = arguments(module, np.random.default_rng(5))
    product_functions = product.of_robot(specification(plain.robot, "sample.toml")).functions
    assert {f.name for f in product_functions} == functions(declared)
    for function in product_functions:
        inputs = [given[a.name] for a in function.arguments]
        for a, b in zip(
            results(getattr(module, function.name), inputs),
            results(getattr(declared, function.name), inputs),
            strict=True,
        ):
            np.testing.assert_allclose(
                a, b, rtol=1e-12, atol=1e-12 * np.abs(b).max(initial=0.0), err_msg=function.name
            )


def test_massless_clamps_take_the_least_elastic_energy(sample: Sample) -> None:
    """The condensed energy is the minimum over the clamp displacements: any other displacements give more energy."""
    _, module, _ = sample(ROBOT, ("clamp_compliance",))
    _, K = module.uncondensed_matrices(POSE)
    gravity = np.zeros_like(K)
    gravity[:3, :3] = module.gravity_hessian(POSE)
    rng = np.random.default_rng(6)
    q = 1e-3 * rng.normal(size=9)
    least = module.elastic_potential(POSE, q)
    every = module.condensation(POSE) @ q
    np.testing.assert_allclose(every[:9], q, rtol=0, atol=0)
    assert 0.5 * every @ (K - gravity) @ every == pytest.approx(least, rel=1e-11)
    for change in 1e-3 * rng.normal(size=(20, 3)):
        other = every + np.concatenate([np.zeros(9), change])
        assert 0.5 * other @ (K - gravity) @ other > least


def test_a_motor_without_inertia_makes_its_wind_up_massless() -> None:
    """Which coordinates are massless depends on parameter values, here on those of one axis."""
    content = document(ROBOT)
    axes = [dict(axis) for axis in content["axis"]]
    axes[1]["motor"] = {**content["motor"], "inertia": 0.0}
    effects = {
        "gearbox_compliance": VALUES["gearbox_compliance"],
        "cable_stiffness": VALUES["cable_stiffness"],
    }
    model = pkmodes.Model(
        robot_from_document({**content, "name": "sample", "axis": axes, "effects": effects}, "sample.toml")
    )
    module = executed(emitted(model))
    assert tuple(q for q in model.coordinates if q != "psi_2") == module.COORDINATES
    assert model.coordinates == module.ALL_COORDINATES
    eigenvalues = eigh(*module.modal_matrices(POSE)[::-1], eigvals_only=True)
    frequencies = model.modes(POSE).frequencies
    np.testing.assert_allclose(np.sqrt(eigenvalues) / (2 * np.pi), frequencies, rtol=1e-9)
