"""The rotary delta against MuJoCo, which derives nothing: it simulates bodies, joints and springs.

`mujoco_rotary_delta` describes the robot without any formula of the generated model, on a moving frame, so the frame
of the extended model is tested too.  Both sides are exact up to rounding, except where the engine's quantities are
differenced: a relative error of a millionth in any term would be detected.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest
from scipy.linalg import eigh

from helpers.robots.sample_mechanisms import SEEDS, Sample, sample
from helpers.robots.symmetric_rotary_delta import clavel
from pkmodes_generated.rotary_delta import extended, model
from pkmodes_rig.mujoco_rotary_delta import Engine

#: Quantities of the engine without differences, relative to the largest entry of a block of coordinates: a few dozen
#: roundings amplified by the condition of the constraints.  Measured over these and eight more robots, like all
#: errors below: at most 8.2e-15.
EXACT = 5e-14
#: Steps in radians and metres of eighth-order differences.
STEP = 0.01
FRAME, PAYLOAD = 60.0, 0.4
#: The engine has no coordinates for the elongation of the links.
KEPT = np.array([0, 1, 2, 3, 4, 5, 9, 10, 11])

CASES = {
    "clavel-centre": clavel((0.0, 0.0, -0.45)),
    "clavel-aside": clavel((0.09, -0.05, -0.52)),
} | {f"random-{seed}": sample("rotary_delta", seed) for seed in SEEDS}


@cache
def assembled(name: str) -> Engine:
    return Engine(CASES[name].parameters, CASES[name].pose, frame=FRAME, payload=PAYLOAD)


@pytest.fixture(params=CASES)
def case(request: pytest.FixtureRequest) -> Sample:
    return CASES[request.param]


@pytest.fixture
def engine(request: pytest.FixtureRequest, case: Sample) -> Engine:
    return assembled(request.node.callspec.params["case"])


def matrices(robot: Sample) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    chosen = extended.Effects(payload_mass=PAYLOAD, frame_compliance_mass=FRAME)
    found = extended.extended_matrices(robot.pose, robot.parameters, chosen)
    M, K_el, K_g = (matrix[np.ix_(KEPT, KEPT)] for matrix in found)
    return M, K_el, K_g


def worst(found: np.ndarray, expected: np.ndarray, floor: float = 0.0) -> float:
    """Return the largest error relative to the largest entry of its block, or to the floor if that is larger."""
    errors = []
    for i in range(0, len(found), 3):
        for j in range(0, found.shape[1], 3):
            a, b = found[i : i + 3, j : j + 3], expected[i : i + 3, j : j + 3]
            size = max(np.abs(b).max(), floor)
            errors.append(np.abs(a - b).max() / size if size else float(a.any()))
    return float(max(errors))


def test_arms_that_the_engine_can_connect_to_the_platform(case: Sample, engine: Engine) -> None:
    # Lengths of some decimetres, a few roundings each.
    assert engine.closure() < 2e-15
    assert engine.platform() == pytest.approx(case.pose, rel=0, abs=1e-14)


def test_platform_follows_arms_and_frame(case: Sample, engine: Engine) -> None:
    motion = extended.extended_platform_motion(case.pose, case.parameters)[:, KEPT]
    assert worst(engine.platform_motion(), motion) < EXACT


def test_mass_matrix(case: Sample, engine: Engine) -> None:
    expected = engine.mass_matrix()
    # entries that vanish: the engine leaves rounding of the largest, some 60 kg
    assert worst(matrices(case)[0], expected, floor=1e-3) < EXACT
    chosen = model.mass_matrix(case.pose, case.parameters._replace(platform_mass=_carried(case)))
    assert worst(chosen, expected[:6, :6], floor=1e-3) < EXACT


def _carried(case: Sample) -> float:
    return float(case.parameters.platform_mass) + PAYLOAD


def test_weight_of_arms_links_and_platform(case: Sample, engine: Engine) -> None:
    parameters = case.parameters._replace(platform_mass=_carried(case))
    G = model.gravity_gradient(case.pose, parameters)
    assert np.abs(engine.gradient()[:3] - G).max() < EXACT * np.abs(G).max()
    # from energies alone, rounding over step of some joules, reducers' strain included; measured: 5.5e-13
    assert np.abs(engine.slopes(STEP)[:3] - G).max() < 5e-12 * np.abs(G).max()
    torques, wound = model.static_equilibrium(case.pose, parameters)
    engine.move(np.concatenate([np.zeros(3), wound, np.zeros(3)]))
    held = engine.gradient()[:6]
    engine.move(np.zeros(9))
    # zero at the arms; the torques at the motors
    assert np.abs(held - [*np.zeros(3), *torques]).max() < EXACT * np.abs(torques).max()


def test_stiffness_of_gravity_and_reducers(case: Sample, engine: Engine) -> None:
    _, K_el, K_g = matrices(case)
    with_reducers = engine.hessian(STEP)
    bare = Engine(case.parameters, case.pose, frame=FRAME, payload=PAYLOAD)
    bare.relax()
    found = bare.hessian(STEP)
    # truncation, and rounding over step beside the frame's weight of 600 N; measured: 3.1e-12
    assert np.abs(found - K_g).max() < 2e-11 * np.abs(K_g).max()
    # the same steps on both sides, so the remainder of gravity cancels; measured: 1.6e-15
    assert np.abs(with_reducers - found - K_el).max() < EXACT * np.abs(K_el).max()


def test_modes_on_a_frame(case: Sample, engine: Engine) -> None:
    M, K_el, K_g = matrices(case)
    spring = np.diag([*np.zeros(6), *np.full(3, 1e6)])
    expected = eigh(engine.hessian(STEP) + spring, engine.mass_matrix(), eigvals_only=True)
    found = eigh(K_el + K_g + spring, M, eigvals_only=True)
    # errors relative to the matrices and the largest eigenvalue, 3e5 at most; measured: 5.6e-15 and 1e-14
    np.testing.assert_allclose(found[3:], expected[3:], rtol=EXACT)
    assert np.abs(found[:3] - expected[:3]).max() < 1e-13 * expected[3]
