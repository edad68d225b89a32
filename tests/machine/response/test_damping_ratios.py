"""Ratios of light damping, against the complex eigenproblem of all coordinates and closed forms; the modes stay."""

from __future__ import annotations

from itertools import product

import numpy as np
import pytest
from scipy.linalg import eig

from helpers.references.damping_by_hand import friction_by_hand, loss_by_hand
from helpers.references.motors_by_hand import followers
from helpers.references.whole_system import whole_modes
from helpers.robots.damped_robots import BACKENDS, CASES, DRIVES, EFFECTS, FRICTION, LOSSES, repeated
from helpers.robots.one_of_each import FILES, POSES, model_of
from pkmodes.machine.response.linearised import LinearisedRobot
from pkmodes.machine.response.poles import notes_on_damping


@pytest.mark.parametrize("drives", DRIVES)
@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("case", ["plain", "everything"])
@pytest.mark.parametrize("mechanism", FILES)
def test_modes_and_matrices_are_to_the_bit_those_without_dissipation(
    mechanism: str, case: str, backend: str, drives: str
) -> None:
    p = np.stack([POSES[mechanism], POSES[mechanism] + 0.01])
    plain = model_of(mechanism, EFFECTS[case])
    damped = model_of(mechanism, EFFECTS[case], LOSSES, FRICTION, ratio=0.1)
    assert damped.coordinates == plain.coordinates
    one, other = (model.modes(p, drives=drives, backend=backend) for model in (plain, damped))
    assert one.rigid_modes == other.rigid_modes
    for field in ("frequencies", "shapes", "platform_shapes", "mass_matrix", "stiffness_matrix"):
        np.testing.assert_array_equal(getattr(one, field), getattr(other, field))
    np.testing.assert_array_equal(damped.matrices(p), plain.matrices(p))
    alone = (model.frequencies(p, drives=drives, backend=backend) for model in (plain, damped))
    np.testing.assert_array_equal(*alone)
    vibrating = other.damping_ratios[:, other.rigid_modes :]
    assert (vibrating > 0.1).all()
    assert np.isnan(other.damping_ratios[:, : other.rigid_modes]).all()


def assert_light_ratios(mechanism: str, case: str, drives: str) -> None:
    """-Re(s)/|s| of (K + i K'' + s C + s^2 M) q = 0 in all coordinates, for positive imaginary parts.

    The damping is a thousandth: what is left is of second order in it.
    """
    light = {path: 1e-4 * value for path, value in (LOSSES | FRICTION).items()}
    model, p = model_of(mechanism, EFFECTS[case], light, ratio=1e-5), POSES[mechanism]
    modes = model.modes(p, drives=drives)
    M, K = model.matrices(p)
    omega, phi, T = whole_modes(M, K, followers(model, drives)[0], modes.rigid_modes)
    C = friction_by_hand(model) + M @ phi @ np.diag(2e-5 * omega) @ phi.T @ M
    M, C, K, loss = (T.T @ a @ T for a in (M, C, K, loss_by_hand(model, p)))
    n, d = len(M), 1 / np.sqrt(np.diag(M))
    scale = omega.max()
    M, C, K, loss = (a * np.outer(d, d) for a in (M, C / scale, K / scale**2, loss / scale**2))
    one, none = np.eye(n), np.zeros((n, n))
    A = np.block([[none, one], [-K - 1j * loss, -C]])
    s = scale * eig(A, np.block([[one, none], [none, M]]), right=False)
    upper = s[s.imag > 0.5 * omega.min()]
    upper = upper[np.argsort(upper.imag)]
    ratios = modes.damping_ratios[modes.rigid_modes :]
    assert len(upper) == len(ratios)
    np.testing.assert_allclose(ratios, -upper.real / np.abs(upper), rtol=1e-4)


def test_light_ratios_are_those_of_the_complex_eigenproblem(subtests: pytest.Subtests) -> None:
    for (mechanism, case), drives in product(CASES, DRIVES):
        with subtests.test(f"{mechanism}, {case}, {drives}"):
            assert_light_ratios(mechanism, case, drives)


@pytest.mark.parametrize("backend", BACKENDS)
def test_ratios_of_repeated_modes_are_those_of_the_motions_that_damping_does_not_couple(backend: str) -> None:
    """Each belt alone is such a motion; x and y, an equally good basis of the undamped modes, are not."""
    model, p, expected = repeated()
    modes = model.modes(p, drives="held", backend=backend)
    assert modes.frequencies[1] / modes.frequencies[0] == pytest.approx(1.0, abs=1e-12)
    assert expected[1] > 1.01 * expected[0]
    assert modes.damping_ratios == pytest.approx(expected, rel=1e-9)


def test_modes_whose_ratio_is_not_that_of_their_pole_are_named() -> None:
    """Beyond critical damping the pole of a body alone has the ratio 1; below, both ratios are the same."""
    model, p, _ = repeated()
    model = model.with_values({"effects.belt_loss.loss_factor": 0.0})
    omega, mass = 2 * np.pi * model.frequencies(p, drives="held"), model.robot.parameters.toolhead_mass
    for ratio in (0.5, 1.5):
        damped = model.with_values({"effects.rail_friction.viscous": 2 * ratio * mass * omega[0]})
        ratios = damped.modes(p, drives="held").damping_ratios
        assert ratios == pytest.approx([ratio, ratio], rel=1e-9)
        notes = notes_on_damping(LinearisedRobot(damped, np.array([p]), "held", "auto"), ratios)
        assert [note.split(":")[0] for note in notes] == (["mode 1", "mode 2"] if ratio > 1.0 else [])
        assert all("1.5" in note and "that of the pole is 1:" in note for note in notes)
