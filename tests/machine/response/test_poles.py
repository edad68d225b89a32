"""Poles against those of all coordinates together, where `pkmodes` works in modal coordinates, and closed forms."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest

import pkmodes
from helpers.references.whole_system import companion_poles, full_damping
from helpers.robots.damped_robots import BACKENDS, CASES, DRIVES, EFFECTS, FRICTION, LOSSES, repeated
from helpers.robots.one_of_each import POSES, model_of
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.linalg.damping import ModalDamping
from pkmodes.machine.response.poles import poles, ratios_of_poles


def test_poles_are_those_of_the_whole_first_order_system(subtests: pytest.Subtests) -> None:
    """With all coordinates at once; the stronger damping has ratios up to 60 % and poles without oscillation."""
    for (mechanism, case), strength, drives in product(CASES, [1.0, 30.0], DRIVES):
        with subtests.test(f"{mechanism}, {case}, {strength}, {drives}"):
            friction = {path: strength * value for path, value in FRICTION.items()}
            losses = {path: min(strength * value, 0.9) for path, value in LOSSES.items()}
            ratio = min(0.02 * strength, 0.6)
            model, p = model_of(mechanism, EFFECTS[case], friction, losses, ratio=ratio), POSES[mechanism]
            found = model.poles(p, drives=drives)
            expected = companion_poles(*full_damping(model, p, drives))
            assert len(found) == len(expected)
            assert_same_poles(found, expected)


def assert_same_poles(found: np.ndarray, expected: np.ndarray, tolerance: float = 1e-11) -> None:
    """Each is the nearest left of the other, to a part of its own size, or near zero of the largest."""
    left = list(expected)
    for pole in found:
        nearest = int(np.argmin(np.abs(np.array(left) - pole)))
        error = abs(left.pop(nearest) - pole)
        assert error < tolerance * abs(pole) + 1e-12 * np.abs(expected).max()


@pytest.mark.parametrize("backend", BACKENDS)
def test_poles_of_repeated_modes_have_the_ratios_of_these_motions(backend: str) -> None:
    """K'' enters them as the viscous ratio of its mode, which within a group is one that damping does not couple."""
    model, p, expected = repeated()
    poles = model.poles(p, drives="held", backend=backend)
    ratios = np.sort((-poles.real / np.abs(poles))[poles.imag > 0.0])
    assert ratios == pytest.approx(expected, rel=1e-9)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("ratio", [0.02, 0.6])
def test_poles_of_a_ratio_alone_follow_from_the_frequencies(ratio: float, backend: str) -> None:
    """s = omega (-zeta +- i sqrt(1 - zeta^2)), ascending, the one with positive imaginary part first."""
    model, p = model_of("linear_delta", {}, ratio=ratio), POSES["linear_delta"]
    omega = 2 * np.pi * model.frequencies(p, drives="held", backend=backend)
    pair = np.array([-ratio + 1j * np.sqrt(1 - ratio**2), -ratio - 1j * np.sqrt(1 - ratio**2)])
    found = model.poles(p, drives="held", backend=backend)
    np.testing.assert_allclose(found, np.outer(omega, pair).ravel(), rtol=1e-11)


@pytest.mark.parametrize("mechanism", ["corexy"])
def test_rigid_modes_have_poles_of_friction_alone(mechanism: str) -> None:
    """A level CoreXY of equal belts: along x and y it creeps to a stop, 0 and -C/M of the rigid motion."""
    model = model_of(
        mechanism, {}, {"rail_friction.viscous": 7.0, "drive_friction.viscous": 1e-4}, ratio=0.05
    )
    model = model.with_values({"belt.specific_stiffness": 2.6e12})
    q, p = model.robot.parameters, POSES[mechanism]
    R, inertia = q.pulley_radius[0], (q.pulley_inertia + q.gear_ratio**2 * q.motor_inertia)[0]
    friction = 7.0 + 2 * 1e-4 / R**2
    mass = np.array([q.toolhead_mass, q.toolhead_mass + q.gantry_mass]) + 2 * inertia / R**2
    found = model.poles(p)
    largest = np.abs(found).max()
    assert (np.abs(found[:2]) < 1e-7 * largest).all()
    np.testing.assert_allclose(np.sort(found[2:4].real), np.sort(-friction / mass), rtol=1e-4)


def test_poles_without_any_vibration_mode_are_those_of_friction() -> None:
    """Two rigid modes that friction couples: the other poles are minus the eigenvalues of D, 3 and 1."""
    D = np.array([[[2.0, 1.0], [1.0, 2.0]]])
    damping = ModalDamping(np.zeros((1, 2)), D, 2)
    assert poles(damping)[0] == pytest.approx([0.0, 0.0, -1.0, -3.0], abs=1e-12)
    assert ratios_of_poles(damping).shape == (1, 2)


def test_poles_of_stiff_joints_are_those_of_locked_ones(subtests: pytest.Subtests) -> None:
    """Soft motions keep nine digits, like frequencies: what the joint gives way is a part of 1e-11."""
    for joint, compliance in product(["gearbox", "link", "clamp", "frame"], [1e-16, 1e-20, 1e-30]):
        with subtests.test(f"{joint}, {compliance}"):
            locked, p = model_of("linear_delta", LOSSES, FRICTION, ratio=0.01), POSES["linear_delta"]
            effects = {f"{joint}_compliance.compliance": compliance}
            stiff = model_of("linear_delta", LOSSES, FRICTION, effects, ratio=0.01)
            expected = locked.poles(p, drives="held")
            found = stiff.poles(p, drives="held")
            assert len(found) == len(expected) + (0 if joint == "clamp" else 6)
            for pole in expected:
                assert np.abs(found - pole).min() < 1e-9 * abs(pole)


def test_poles_of_poses_that_cannot_be_evaluated() -> None:
    model = model_of("corexy", FRICTION, ratio=0.01)
    poles = model.poles([[0.1, 0.05], [9.0, 0.0]], "nan")
    assert poles.shape == (2, 8)
    np.testing.assert_array_equal(poles[0], model.poles([0.1, 0.05]))
    assert np.isnan(poles[1]).all()
    with pytest.raises(pkmodes.PoseError):
        model.poles([9.0, 0.0])
    with pytest.raises(PkmodesError, match='"free" or "held"'):
        model.poles([0.1, 0.05], drives="locked")
