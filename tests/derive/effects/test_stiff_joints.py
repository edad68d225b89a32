"""Joints from rigid to soft: every compliance from 1e-30 gives the modes of an evaluation in 80 digits.

The stiffness 1/c of a joint is combined with belts of 1e5 N/m, and the error of a symmetric solver is rounding of
the largest eigenvalue.  The requirement is nine digits for every mode of vibration, soft or stiff.
"""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

import pkmodes
from helpers.references.high_precision import Exact, exact_derivatives, exact_modes, mp
from helpers.references.sensitivity_references import robot_of
from helpers.robots.sample_robots import Sample, published, random_robot
from pkmodes.core.base.errors import PoseError
from pkmodes.core.linalg.eigen import condensed_eigh, generalised_eigh
from pkmodes.core.mechanism.registry import mechanism
from pkmodes.core.system.evaluation import ExtendedSystem, matrices

KIND = mechanism("linear_delta")
CATALOGUE = KIND.effects

COMPLIANCES = (1e-30, 1e-20, 1e-15, 1e-14, 1e-12, 1e-9, 1e-6)
RELEASED = tuple(name for name, effect in CATALOGUE.items() if effect.coordinates)
#: Effects and the factor of the compliance in each: alone, with the clamp's mass, and several of different sizes.
CASES: dict[str, dict[str, float]] = {
    **{name: {name: 1.0} for name in RELEASED},
    "heavy clamp": {"clamp_compliance": 1.0, "belt_mass": 0.0},
    "gearbox, link": {"gearbox_compliance": 1.0, "link_compliance": 1e3},
}
SAMPLES = ("published", "random 1", "random 2")
#: A rigid joint with a soft one, with and without inertia, and three more sizes between them.
MIXED = (
    {"gearbox_compliance.compliance": 1e-30, "link_compliance.compliance": 1e-6},
    {"clamp_compliance.compliance": 1e-6, "gearbox_compliance.compliance": 1e-30},
    {"clamp_compliance.compliance": 1e-30, "gearbox_compliance.compliance": 1e-4},
    {
        "gearbox_compliance.compliance": 1e-16,
        "link_compliance.compliance": 1e-30,
        "clamp_compliance.compliance": 1e-9,
        "frame_compliance.compliance": 1e-22,
        "frame_compliance.mass": 50.0,
        "belt_mass.linear_density": 0.05,
    },
    {
        "gearbox_compliance.compliance": 1e-30,
        "gearbox_compliance.compliance.psi_2": 1e-20,
        "gearbox_compliance.compliance.psi_3": 1e-4,
    },
    {"servo_stiffness.stiffness": 100.0, "gearbox_compliance.compliance": 1e-7},
)


def sample(name: str) -> Sample:
    if name == "published":
        return published((0.6, 0.03, -0.245))
    return random_robot(np.random.default_rng(int(name.split()[1])))


def effects_of(case: str, compliance: float) -> dict[str, float]:
    effects = {f"{name}.compliance": compliance * factor for name, factor in CASES[case].items() if factor}
    if "belt_mass" in CASES[case]:
        effects["belt_mass.linear_density"] = 0.05
    if "frame_compliance" in CASES[case]:
        effects["frame_compliance.mass"] = 50.0
    return effects


@cache
def _reference(name: str, effects: tuple[tuple[str, float], ...]) -> Exact:
    parameters, p = sample(name)
    return exact_modes(parameters, dict(effects), p)


def reference(name: str, effects: dict[str, float]) -> Exact:
    """Return the modes of a sample in 80 digits; each is found once."""
    return _reference(name, tuple(effects.items()))


def solve(name: str, effects: dict[str, float]) -> tuple[np.ndarray, np.ndarray, np.ndarray, int]:
    """Return the package's eigenvalues and shapes at a pose, M, and the number of rigid modes."""
    parameters, p = sample(name)
    evaluation = ExtendedSystem(KIND, parameters, effects)
    M, K = matrices(evaluation, p[None])
    eigenvalues, shapes = condensed_eigh(M, K, 9, evaluation.rigid_modes)
    return eigenvalues[0], shapes[0], M[0], evaluation.rigid_modes


def alone(eigenvalues: np.ndarray) -> np.ndarray:
    """Return which modes have no neighbour so close that rounding of M would rotate their shapes."""
    near = np.diff(eigenvalues) < 1e-3 * np.abs(eigenvalues[1:])
    return ~(np.append(near, False) | np.append(False, near))


def assert_equal_modes(name: str, effects: dict[str, float]) -> None:
    eigenvalues, shapes, M, rigid = solve(name, effects)
    expected = reference(name, effects)
    values, rows = expected.values(), expected.rows()
    # Frequencies to 1e-9, which is 2e-9 of their squares.
    np.testing.assert_allclose(eigenvalues[rigid:], values[rigid:], rtol=1e-9)
    scale = np.sqrt(np.where(np.diagonal(M) > 0.0, np.diagonal(M), 0.0))
    rows *= np.sign(np.sum(rows * shapes * scale**2, axis=1))[:, None]
    for i in np.flatnonzero(alone(values)):
        if i < rigid:
            continue
        error, whole = np.abs(shapes[i] - rows[i]), np.abs(rows[i] * scale).max()
        assert (error * scale).max() < 1e-9 * whole
        # The displacement of a stiff joint in a soft mode is tiny, and correct relative to its size.
        yields = values[i] < 1e-3 * values[-1]
        own = np.abs(rows[i, 9:]).reshape(-1, 3).max(axis=1).repeat(3)
        if yields and i < 9:
            assert (error[9:] <= 1e-9 * own).all()
            assert own.min() > 0.0


@pytest.mark.parametrize("name", SAMPLES)
def test_modes_equal_eighty_digits_at_every_compliance(subtests: pytest.Subtests, name: str) -> None:
    for case in CASES:
        with subtests.test(case=case):
            for compliance in COMPLIANCES:
                assert_equal_modes(name, effects_of(case, compliance))


@pytest.mark.parametrize("effects", MIXED, ids=range(len(MIXED)))
def test_joints_of_different_sizes_equal_eighty_digits(effects: dict[str, float]) -> None:
    for name in SAMPLES:
        assert_equal_modes(name, effects)


@cache
def derivatives(name: str, effect: str, compliance: float) -> tuple[pkmodes.Model, Exact]:
    effects = effects_of(effect, compliance)
    return pkmodes.Model(robot_of(sample(name).parameters, effects)), reference(name, effects)


@pytest.mark.parametrize("compliance", COMPLIANCES[:-1])
@pytest.mark.parametrize("effect", [*RELEASED, "heavy clamp"])
def test_sensitivities_equal_eighty_digits(effect: str, compliance: float) -> None:
    """Derivatives with respect to the compliance, a mass and a stiffness; those of matrices are tested elsewhere."""
    name = "random 1"
    model, modes = derivatives(name, effect, compliance)
    own = f"{next(iter(CASES[effect]))}.compliance"
    found = model.sensitivities(sample(name).pose, [f"effects.{own}", "platform.mass", "axis.2.belt.width"])
    values, rows = modes.values(), modes.rows()
    listed = model.modes(sample(name).pose).shapes
    sign = np.sign(np.sum(rows * listed * np.abs(np.diagonal(found.mass_matrix[1])).clip(1e-9), axis=1))
    assert (np.diff(found.groups[3:]) == 1).all(), "no two modes of vibration are mistaken for one"
    dM, dK = mp.zeros(len(rows[0])), mp.zeros(len(rows[0]))
    for q in CATALOGUE[own.split(".")[0]].coordinates:
        i = model.coordinates.index(q.name)
        dK[i, i] = -1 / mp.mpf(compliance) ** 2
    others = zip(found.mass_matrix[1:3], found.stiffness_matrix[1:3], strict=True)
    by = [(dM, dK), *(tuple(mp.matrix(a.tolist()) for a in pair) for pair in others)]
    for k in range(3, len(values)):
        for t, (rate, shape) in enumerate(exact_derivatives(modes, k, by)):
            assert found.eigenvalues[t, k] == pytest.approx(float(rate), rel=1e-9), (t, k)
            frequency = float(rate) / (4 * np.pi * np.sqrt(values[k]))
            assert found.frequencies[t, k] == pytest.approx(frequency, rel=1e-9), (t, k)
            if alone(values)[k]:
                expected = sign[k] * np.array([float(x) for x in shape])
                error = np.abs(found.shapes[t, k] - expected)
                for part in (slice(0, 9), slice(9, None)):
                    if part.start == 0 or k < 9:
                        # A mass hardly changes the shape of a stiff mode: rounding of the shape dominates.
                        nothing = 1e-14 * np.abs(rows[k]).max() / found.values[t] if k >= 9 else 0.0
                        bound = 1e-9 * np.abs(expected[part]).max() + nothing
                        assert error[part].max() < bound, (t, k, part)


@pytest.mark.parametrize("name", SAMPLES)
@pytest.mark.parametrize("effect", RELEASED)
def test_frequencies_go_to_those_of_the_locked_joint_at_a_linear_rate(name: str, effect: str) -> None:
    parameters, p = sample(name)
    locked = pkmodes.Model(robot_of(parameters, {}))
    base, rate = (
        locked.modes(p).frequencies,
        locked.sensitivities(p, [f"effects.{effect}.compliance"]).frequencies,
    )
    for compliance in (1e-30, 1e-15, 1e-12):
        constants = {"frame_compliance.mass": 50.0} if effect == "frame_compliance" else {}
        found = pkmodes.Model(robot_of(parameters, {f"{effect}.compliance": compliance, **constants})).modes(
            p
        )
        np.testing.assert_allclose(found.frequencies[3:9], base[3:] + rate[0, 3:] * compliance, rtol=1e-10)


@pytest.mark.parametrize("name", SAMPLES)
def test_motor_and_pulley_swing_against_each_other_on_a_stiff_gearbox(name: str) -> None:
    """Two inertias on a spring: lambda = k (1 / I_motor + 1 / I_pulley), unaffected by anything else."""
    parameters, _ = sample(name)
    eigenvalues, *_ = solve(name, {"gearbox_compliance.compliance": 1e-20})
    motor = parameters.gear_ratio**2 * parameters.motor_inertia
    expected = np.sort(1e20 * (1.0 / motor + 1.0 / parameters.pulley_inertia))
    np.testing.assert_allclose(eigenvalues[9:], expected, rtol=1e-12)


def test_the_symmetric_solver_alone_would_lose_them() -> None:
    """The graded form is needed; without this check the tests above would prove nothing."""
    parameters, p = sample("published")
    system = ExtendedSystem(KIND, parameters, {"gearbox_compliance.compliance": 1e-15})
    M, K = matrices(system, p[None])
    exact = reference("published", {"gearbox_compliance.compliance": 1e-15}).values()
    assert (np.abs(generalised_eigh(M, K)[0][0] / exact - 1.0)[3:9] > 1e-3).any()


@pytest.mark.parametrize("compliance", [1e-5, 1e-4, 1e-3])
def test_joints_of_usual_stiffness_are_solved_as_ever(compliance: float) -> None:
    """Equal to the last bit, and for a whole batch at once."""
    parameters, p = sample("published")
    evaluation = ExtendedSystem(KIND, parameters, {"gearbox_compliance.compliance": compliance})
    M, K = matrices(evaluation, p + np.linspace(0.0, 0.05, 7)[:, None])
    for found, expected in zip(condensed_eigh(M, K, 9, 3), generalised_eigh(M, K), strict=True):
        np.testing.assert_array_equal(found, expected)


@pytest.mark.parametrize("effect", [*RELEASED, "heavy clamp"])
def test_no_valid_pose_gives_as_many_modes_as_any(effect: str) -> None:
    parameters, p = sample("published")
    model = pkmodes.Model(robot_of(parameters, effects_of(effect, 1e-6)))
    far, near = ([9.0, 9.0, 9.0] + 0.0 * p)[None], p[None]
    for kind in ("frequencies", "shapes", "platform_shapes"):
        none, one = (getattr(model.modes(at, on_error="nan"), kind) for at in (far, near))
        assert none.shape == one.shape
        assert np.isnan(none).all()
    for kind in ("frequencies", "shapes", "groups", "mass_matrix"):
        none, one = (
            getattr(model.sensitivities(at, ["platform.mass"], on_error="nan"), kind) for at in (far, near)
        )
        assert none.shape == one.shape


def test_an_empty_batch_has_the_modes_of_the_coordinates_with_inertia() -> None:
    massless = np.array([False] * 9 + [True] * 3)
    eigenvalues, shapes = condensed_eigh(np.zeros((0, 12, 12)), np.zeros((0, 12, 12)), 9, massless=massless)
    assert eigenvalues.shape == (0, 9)
    assert shapes.shape == (0, 9, 12)


@pytest.mark.parametrize("compliance", [1.0, 1e2, 1e4, 1e8, 1e20, 1e30])
@pytest.mark.parametrize("effect", RELEASED)
def test_joints_that_hardly_hold_are_right_or_refused(effect: str, compliance: float) -> None:
    for name in SAMPLES[:2]:
        parameters, p = sample(name)
        model = pkmodes.Model(robot_of(parameters, effects_of(effect, compliance)))
        try:
            found = model.modes(p).frequencies
        except PoseError as error:
            assert "so soft that its vibration" in str(error)
            with pytest.raises(PoseError, match="so soft"):
                model.sensitivities(p, ["platform.mass"])
            continue
        exact = exact_modes(parameters, effects_of(effect, compliance), p).values()
        np.testing.assert_allclose(found[3:], np.sqrt(exact[3:]) / (2.0 * np.pi), rtol=1e-9)


def test_a_soft_joint_within_reason_is_not_refused() -> None:
    """The frame moves at half a hertz."""
    parameters, p = sample("published")
    found = pkmodes.Model(robot_of(parameters, effects_of("frame_compliance", 1e-3))).modes(p)
    assert 0.1 < found.frequencies[3] < 2.0
