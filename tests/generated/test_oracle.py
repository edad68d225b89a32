"""The generated matrices of the rotary delta and the CoreXY against 60 digits from their contract, effect by effect.

The oracle (`oracle_rotary_delta`, `oracle_corexy`) has independent positions, energies and loops, and differentiates
them by differences that are exact to some 20 digits.  What remains is the rounding of the generated code; a wrong
term, sign, factor or exchange exceeds it by ten orders of magnitude.
"""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

from helpers.references.coordinate_blocks import kinds, worst
from helpers.references.high_precision_mechanisms import Compared, Reference
from helpers.references.oracle_modes import free
from helpers.robots.dissipating import dissipating
from helpers.robots.sample_mechanisms import (
    NAMES,
    SEEDS,
    TOGETHER,
    TYPICAL,
    effect_names,
    effects,
    extended,
    model,
    oracle,
    reference,
    sample,
)
from pkmodes.core.mechanism.generated import Generated

#: Relative rounding per unit of the condition number of the loops (7 to 11 here): a few units in the last
#: place in each linkage vector, amplified in solving for the platform's motion, summed over some tens of terms.
#: Measured over 12 robots of each kind with all effects: at most 5.1e-16 (2.5e-16 for the rotary delta).
ROUNDING = 3e-15


def condition(name: str, seed: int) -> float:
    """Return the Frobenius condition number of D_l; 1 if the coordinates are the pose."""
    if name == "corexy":
        return 1.0
    robot = sample(name, seed)
    return float(model(name).jacobian_condition(robot.pose, robot.parameters)[1])


CHOICES = [
    (name, label)
    for name in NAMES
    for label in (*TOGETHER, *effect_names(name))
    if label in ("nothing", "everything") or set(TOGETHER.get(label, (label,))) & set(effect_names(name))
]


def chosen_effects(label: str) -> tuple[str, ...]:
    return TOGETHER.get(label, (label,))


def assert_extended_model(name: str, label: str, seed: int) -> None:
    robot, chosen = sample(name, seed), effects(name, chosen_effects(label))
    expected: Reference = reference(name, seed, chosen)
    generated, tolerance = extended(name), ROUNDING * condition(name, seed)
    blocks = kinds(generated.COORDINATES)
    M, K_el, K_g = generated.extended_matrices(robot.pose, robot.parameters, chosen)
    assert worst(M, expected.M, blocks) < tolerance
    assert worst(K_el, expected.K_el, blocks) < tolerance
    assert worst(K_g, expected.K_g, blocks) < tolerance
    for matrix in (M, K_el, K_g):
        np.testing.assert_array_equal(matrix, matrix.T)

    motion = Generated(generated, robot.parameters, chosen).extended_platform_motion(robot.pose)
    assert np.abs(motion - expected.platform).max() < tolerance * np.abs(expected.platform).max()
    torques, displacements = generated.extended_static_equilibrium(robot.pose, robot.parameters, chosen)
    assert np.abs(torques - expected.torques).max() < tolerance * np.abs(expected.torques).max()
    size = np.abs(expected.displacements).max()
    assert np.abs(displacements - expected.displacements).max() < tolerance * size


def test_extended_model_agrees_with_the_oracle(subtests: pytest.Subtests) -> None:
    for (name, label), seed in product(CHOICES, SEEDS):
        with subtests.test(f"{name}, {label}, {seed}"):
            assert_extended_model(name, label, seed)


def assert_base_model(name: str, seed: int) -> None:
    """The base model has its own functions, separate from those of the extended model."""
    robot, generated = sample(name, seed), model(name)
    expected, tolerance = reference(name, seed, effects(name)), ROUNDING * condition(name, seed)
    n = len(generated.COORDINATES)
    blocks = kinds(generated.COORDINATES)
    M, K = (matrix[:n, :n] for matrix in (expected.M, expected.K_el + expected.K_g))
    given = robot.pose, robot.parameters
    assert worst(generated.mass_matrix(*given), M, blocks) < tolerance
    assert worst(generated.stiffness_matrix(*given), K, blocks) < tolerance
    assert worst(generated.elastic_hessian(*given), expected.K_el[:n, :n], blocks) < tolerance
    for found, other in zip(generated.modal_matrices(*given), (M, K), strict=True):
        assert worst(found, other, blocks) < tolerance
    for found, other in zip(
        generated.static_equilibrium(*given), (expected.torques, expected.displacements), strict=True
    ):
        assert np.abs(found - other).max() < tolerance * np.abs(other).max()


def test_base_model_agrees_with_the_oracle(subtests: pytest.Subtests) -> None:
    for name, seed in product(NAMES, SEEDS):
        with subtests.test(f"{name}, {seed}"):
            assert_base_model(name, seed)


@pytest.mark.parametrize("seed", SEEDS)
def test_arms_that_lean_as_far_as_is_accepted(seed: int) -> None:
    """|a . z| up to 1e-6 is not corrected: the oracle uses z and a x z as they are, in its own closure.

    The generated code may treat both as unit vectors: they are, to half the square of that, 5e-13, which the loops
    amplify by their condition number like rounding.
    """
    name = "rotary_delta"
    robot, chosen = sample(name, seed), effects(name, ("",))
    zero = robot.parameters.zero + 0.99e-6 * robot.parameters.axis
    zero /= np.linalg.norm(zero, axis=-1, keepdims=True)
    leaning = robot._replace(parameters=robot.parameters._replace(zero=zero))
    assert (model(name).perpendicular_margin(leaning.parameters) > 0).all()
    expected = Compared(oracle(name, leaning, chosen)).reference
    found = extended(name).extended_matrices(leaning.pose, leaning.parameters, chosen)
    blocks = kinds(extended(name).COORDINATES)
    for one, other in zip(found, (expected.M, expected.K_el, expected.K_g), strict=True):
        assert worst(one, other, blocks) < 5e-13 * condition(name, seed)


@pytest.mark.parametrize("name", NAMES)
def test_released_joints_are_springs_of_their_compliance(name: str) -> None:
    generated, base = extended(name), len(model(name).COORDINATES)
    chosen = effects(name, ("",))
    compliance = free(name, chosen)
    assert list(compliance) == list(generated.COORDINATES[base:])
    stiffness, rate = generated.joint_stiffness(chosen)
    c = np.array(list(compliance.values()))
    # a division and a square: a few roundings
    np.testing.assert_allclose(stiffness, 1 / c, rtol=1e-15)
    np.testing.assert_allclose(rate, -1 / c**2, rtol=1e-15)
    with np.errstate(divide="ignore"):
        assert np.isposinf(generated.joint_stiffness(effects(name))[0]).all()


@pytest.mark.parametrize("name", NAMES)
def test_names_are_those_of_the_contract(name: str) -> None:
    expected = oracle(name, sample(name, 0), effects(name)).coordinates
    assert expected == extended(name).COORDINATES
    applying = {
        "rotary_delta": {
            *("payload", "gearbox_inertia", "servo_stiffness", "cable_stiffness"),
            *("link_compliance", "frame_compliance", "axis_reducer_stiffness"),
            *("reducer_loss", "drive_friction"),
        },
        "corexy": {
            *("payload", "gearbox_inertia", "servo_stiffness", "cable_stiffness", "belt_end_compliance"),
            *("axis_belt_stiffness", "gearbox_compliance", "clamp_compliance", "frame_compliance"),
            *("belt_mass", "belt_tension_stiffness", "gantry_racking"),
            *("belt_loss", "reducer_loss", "rail_friction", "drive_friction"),
        },
    }
    assert set(effect_names(name)) == applying[name]
    assert set(dissipating(name)) == applying[name] & set(dissipating("linear_delta"))
    assert set(extended(name).Effects._fields) <= set(TYPICAL)


def test_samples_show_every_choice() -> None:
    """Otherwise a wrong formula for one branch or direction could go undetected."""
    deltas, machines = ([sample(name, seed) for seed in SEEDS] for name in NAMES)
    assert {np.sign(robot.pose[2]) for robot in deltas} == {-1.0, 1.0}
    for j in range(3):
        assert {robot.parameters.branch[j] for robot in deltas} == {-1.0, 1.0}
    assert {np.sign(model("rotary_delta").jacobian_condition(r.pose, r.parameters)[0]) for r in deltas} == {
        -1.0,
        1.0,
    }
    for i in range(2):
        assert len({tuple(robot.parameters.belt_path_direction[i]) for robot in machines}) > 1
    for robot in machines:
        assert (model("corexy").run_margin(robot.parameters) > 0).all()
        assert (model("corexy").crossing_margin(robot.parameters) > 0).all()
