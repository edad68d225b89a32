"""The extended model: exactly the base model at null values, each effect against a closed form, exact derivatives."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from scipy.linalg import eigh

from helpers.robots.dissipating import dissipating
from helpers.robots.sample_robots import random_robot
from pkmodes.core.mechanism.registry import mechanism
from pkmodes_generated.linear_delta import Parameters, extended, model

SEEDS = range(4)
BASE = len(model.COORDINATES)
CATALOGUE = mechanism("linear_delta").effects
RELEASED = {name: tuple(q.name for q in e.coordinates) for name, e in CATALOGUE.items() if e.coordinates}


def robot(seed: int) -> tuple[Parameters, np.ndarray]:
    return random_robot(np.random.default_rng(9000 + seed))


def effects(**values: float) -> extended.Effects:
    return extended.Effects(**values)


def whole(p: np.ndarray, parameters: Parameters, chosen: extended.Effects) -> tuple[np.ndarray, np.ndarray]:
    """Return M and K in the base coordinates and the released coordinates that are not locked."""
    M, K_el, K_g = extended.extended_matrices(p, parameters, chosen)
    with np.errstate(divide="ignore"):
        stiffness, _ = extended.joint_stiffness(chosen)
    free = np.isfinite(stiffness)
    index = np.concatenate([np.arange(BASE), BASE + np.flatnonzero(free)])
    K = (K_el + K_g)[np.ix_(index, index)] + np.diag(np.concatenate([np.zeros(BASE), stiffness[free]]))
    return M[np.ix_(index, index)], K


def assert_equal(found: np.ndarray, expected: np.ndarray, digits: float = 1e-13) -> None:
    scale = np.sqrt(np.abs(np.diagonal(expected)))
    assert (np.abs(found - expected) <= digits * np.maximum(np.outer(scale, scale), np.abs(expected))).all()


def test_the_catalogue_has_the_effects_parameters_and_coordinates_of_the_contract() -> None:
    assert {name: [p.name for p in effect.parameters] for name, effect in CATALOGUE.items()} == {
        "payload": ["mass"],
        "belt_mass": ["linear_density"],
        "gearbox_inertia": ["inertia"],
        "servo_stiffness": ["stiffness"],
        "belt_end_compliance": ["compliance"],
        "axis_belt_stiffness": ["factor_1", "factor_2", "factor_3"],
        "belt_tension_stiffness": ["coefficient", "tension"],
        "cable_stiffness": ["stiffness"],
        "gearbox_compliance": ["compliance"],
        "link_compliance": ["compliance"],
        "clamp_compliance": ["compliance"],
        "frame_compliance": ["compliance", "mass", "compliance_x", "compliance_y", "compliance_z"],
        "belt_loss": ["loss_factor"],
        "reducer_loss": ["loss_factor"],
        "rail_friction": ["viscous"],
        "drive_friction": ["viscous"],
    }
    only_dissipate = {"belt_loss", "reducer_loss", "rail_friction", "drive_friction"}
    assert set(dissipating("linear_delta")) == only_dissipate
    released = [f"{stem}_{j}" for stem in ("psi", "delta", "eps") for j in (1, 2, 3)] + ["u_x", "u_y", "u_z"]
    assert list(extended.COORDINATES) == [*model.COORDINATES, *released]


@pytest.mark.parametrize("seed", SEEDS)
def test_null_effects_leave_the_base_model_as_leading_block(seed: int) -> None:
    parameters, p = robot(seed)
    M, K_el, K_g = extended.extended_matrices(p, parameters, effects())
    J = extended.extended_platform_motion(p, parameters)
    M_base, K_base = model.modal_matrices(p, parameters)
    assert_equal(M[:BASE, :BASE], M_base, 1e-14)
    assert_equal((K_el + K_g)[:BASE, :BASE], K_base, 1e-14)
    np.testing.assert_allclose(J[:, :3], model.platform_jacobian(p, parameters), rtol=1e-13)
    assert np.all(J[:, 3:BASE] == 0.0)


@pytest.mark.parametrize("seed", SEEDS)
def test_payload_is_platform_mass(seed: int) -> None:
    parameters, p = robot(seed)
    heavier = parameters._replace(platform_mass=parameters.platform_mass + 0.7)
    for found, expected in zip(
        whole(p, parameters, effects(payload_mass=0.7)), model.modal_matrices(p, heavier), strict=True
    ):
        assert_equal(found, expected)
    torques, _ = extended.extended_static_equilibrium(p, parameters, effects(payload_mass=0.7))
    np.testing.assert_allclose(torques, model.static_equilibrium(p, heavier)[0], rtol=1e-12)


@pytest.mark.parametrize("seed", SEEDS)
def test_gearbox_inertia_is_reflected_motor_inertia(seed: int) -> None:
    parameters, p = robot(seed)
    heavier = parameters._replace(motor_inertia=parameters.motor_inertia + 3e-4 / parameters.gear_ratio**2)
    M, _ = whole(p, parameters, effects(gearbox_inertia_inertia=3e-4))
    assert_equal(M, model.mass_matrix(p, heavier))


@pytest.mark.parametrize("seed", SEEDS)
def test_axis_factors_scale_the_specific_stiffness(seed: int) -> None:
    parameters, p = robot(seed)
    factors = np.array([0.1, -0.2, 0.3])
    chosen = effects(**{f"axis_belt_stiffness_factor_{j}": a for j, a in enumerate(factors, start=1)})
    stiffer = parameters._replace(belt_specific_stiffness=parameters.belt_specific_stiffness * (1 + factors))
    assert_equal(whole(p, parameters, chosen)[1], model.stiffness_matrix(p, stiffer))


@pytest.mark.parametrize("seed", SEEDS)
def test_belt_ends_are_springs_in_series(seed: int) -> None:
    parameters, p = robot(seed)
    c = 2e-6
    k = 1.0 / (1.0 / model.belt_stiffness(p, parameters) + c)
    expected = model.stiffness_matrix(p, parameters) + belt_hessian(k, parameters)
    expected -= belt_hessian(model.belt_stiffness(p, parameters), parameters)
    assert_equal(whole(p, parameters, effects(belt_end_compliance_compliance=c))[1], expected, 1e-12)


def belt_hessian(k: np.ndarray, parameters: Parameters) -> np.ndarray:
    """Assemble the three springs of each axis between pulleys and carriage, element by element."""
    K = np.zeros((BASE, BASE))
    for j in range(3):
        R = parameters.pulley_radius[j]
        for stiffness, ends in zip(
            k[j], (((6 + j, R), (3 + j, R)), ((j, 1.0), (6 + j, R)), ((3 + j, R), (j, 1.0))), strict=True
        ):
            row = np.zeros(BASE)
            row[ends[0][0]], row[ends[1][0]] = ends[0][1], -ends[1][1]
            K += stiffness * np.outer(row, row)
    return K


@pytest.mark.parametrize("seed", SEEDS)
def test_belt_mass_is_the_consistent_mass_of_each_span(seed: int) -> None:
    parameters, p = robot(seed)
    rho, length = 0.06, model.belt_spans(p, parameters)
    expected = model.mass_matrix(p, parameters).copy()
    for j in range(3):
        R = parameters.pulley_radius[j]
        for l_f, ends in zip(
            length[j], (((6 + j, R), (3 + j, R)), ((j, 1.0), (6 + j, R)), ((3 + j, R), (j, 1.0))), strict=True
        ):
            for (a, ra), (b, rb), weight in (
                (ends[0], ends[0], 2),
                (ends[1], ends[1], 2),
                (ends[0], ends[1], 1),
                (ends[1], ends[0], 1),
            ):
                expected[a, b] += rho * l_f / 6 * weight * ra * rb
    assert_equal(whole(p, parameters, effects(belt_mass_linear_density=rho))[0], expected)


@pytest.mark.parametrize("seed", SEEDS)
def test_springs_to_ground_are_where_they_should_be(seed: int) -> None:
    parameters, p = robot(seed)
    K = model.stiffness_matrix(p, parameters)
    driven = np.concatenate([np.zeros(3), parameters.drive.T.ravel()])
    assert_equal(
        whole(p, parameters, effects(servo_stiffness_stiffness=500.0))[1], K + np.diag(500.0 * driven)
    )
    D_p = np.zeros((3, BASE))
    D_p[:, :3] = model.platform_jacobian(p, parameters)
    assert_equal(whole(p, parameters, effects(cable_stiffness_stiffness=2e3))[1], K + 2e3 * D_p.T @ D_p)


@pytest.mark.parametrize("seed", SEEDS)
def test_gearbox_compliance_is_a_shaft_between_two_inertias(seed: int) -> None:
    """The same machine in absolute coordinates: motor and pulley angles, with a shaft between them."""
    parameters, p = robot(seed)
    c = 2e-3
    M, K = whole(p, parameters, effects(gearbox_compliance_compliance=c))
    bare = parameters._replace(motor_inertia=np.zeros(3))
    M_absolute, K_absolute = np.zeros((12, 12)), np.zeros((12, 12))
    M_absolute[:9, :9], K_absolute[:9, :9] = model.modal_matrices(p, bare)
    for j in range(3):
        driven, motor = 3 + j + 3 * int(parameters.drive[j, 1]), 9 + j
        M_absolute[motor, motor] = parameters.gear_ratio[j] ** 2 * parameters.motor_inertia[j]
        shaft = np.zeros(12)
        shaft[driven], shaft[motor] = -1.0, 1.0
        K_absolute += np.outer(shaft, shaft) / c
    expected = eigh(K_absolute, M_absolute, eigvals_only=True)
    np.testing.assert_allclose(eigh(K, M, eigvals_only=True), expected, rtol=0, atol=1e-12 * expected[-1])


@pytest.mark.parametrize("seed", SEEDS)
def test_a_frame_carries_every_body(seed: int) -> None:
    parameters, p = robot(seed)
    M, _ = whole(p, parameters, effects(frame_compliance_compliance=1e-8, frame_compliance_mass=80.0))
    moving = parameters.platform_mass + parameters.link_mass.sum() + parameters.carriage_mass.sum()
    np.testing.assert_allclose(M[9:, 9:], (80.0 + moving) * np.eye(3), rtol=1e-12, atol=1e-12)
    # Momentum of the moving bodies per carriage velocity: half of each linkage moves with either end.
    D_p = model.platform_jacobian(p, parameters)
    momentum = (parameters.platform_mass + parameters.link_mass.sum() / 2) * D_p
    momentum += ((parameters.carriage_mass + parameters.link_mass / 2)[:, None] * parameters.direction).T
    np.testing.assert_allclose(M[9:, :3], momentum, rtol=0, atol=1e-12 * np.abs(momentum).max())
    assert np.all(M[9:, 3:9] == 0.0)


#: Compliances that change the frequencies little; also used at a tenth: the remainder is of second order.
SMALL = {
    "gearbox_compliance": 1e-5,
    "link_compliance": 1e-9,
    "clamp_compliance": 1e-9,
    "frame_compliance": 1e-9,
}


@pytest.mark.parametrize("name", list(RELEASED))
@pytest.mark.parametrize("seed", range(2))
def test_released_joints_converge_to_the_base_model_at_the_predicted_rate(name: str, seed: int) -> None:
    r"""d(lambda)/dc at c = 0 is -f^T f with f = (K_rq - lambda M_rq) phi: the force carried by the locked joint."""
    parameters, p = robot(seed)
    fixed = {"frame_compliance_mass": 60.0}
    M, K_el, K_g = extended.extended_matrices(p, parameters, effects(**fixed))
    K = K_el + K_g
    eigenvalues, shapes = eigh(K[:BASE, :BASE], M[:BASE, :BASE])
    r = [extended.COORDINATES.index(q) for q in RELEASED[name]]
    forces = (K[r, :BASE] @ shapes) - (M[r, :BASE] @ shapes) * eigenvalues
    rate = -np.sum(forces**2, axis=0)
    errors = []
    for c in (SMALL[name], 0.1 * SMALL[name]):
        M_c, K_c = whole(p, parameters, effects(**fixed, **{f"{name}_compliance": c}))
        if name == "clamp_compliance":  # massless: condensed
            rr, qq = slice(BASE, None), slice(0, BASE)
            K_c = K_c[qq, qq] - K_c[qq, rr] @ np.linalg.solve(K_c[rr, rr], K_c[rr, qq])
            M_c = M_c[qq, qq]
        found = eigh(K_c, M_c, eigvals_only=True)
        # A backward stable solver leaves rounding of the largest eigenvalue, that of the stiff joint.
        rounding = 20 * np.finfo(float).eps * found[-1]
        errors.append(np.abs(found[:BASE] - eigenvalues - c * rate).max())
    assert errors[1] <= 0.02 * np.abs(c * rate).max(), "the rate is the first-order one"
    assert errors[1] <= 0.02 * errors[0] + rounding, "the remainder falls with the square of the compliance"


def perturbed(
    parameters: Parameters, chosen: extended.Effects, field: str, index: tuple[int, ...], step: complex
) -> tuple[Parameters, extended.Effects]:
    if field in parameters._fields:
        value = np.array(getattr(parameters, field), dtype=complex if isinstance(step, complex) else float)
        value[index] += step
        return parameters._replace(**{field: value}), chosen
    return parameters, chosen._replace(**{field: getattr(chosen, field) + step})


def matrices(
    p: np.ndarray, parameters: Parameters, chosen: extended.Effects
) -> tuple[np.ndarray, np.ndarray]:
    M, K_el, K_g = extended.extended_matrices(p, parameters, chosen)
    return M, K_el + K_g


#: Typical sizes of effect parameters, by unit.
TYPICAL = {
    "kg": 0.3,
    "kg/m": 0.05,
    "kg m^2": 1e-4,
    "N m/rad": 500.0,
    "N s/m": 20.0,
    "N m s/rad": 1e-3,
    "N/m": 1e3,
    "m/N": 1e-7,
    "rad/(N m)": 1e-4,
    "1": 0.1,
    "1/N": 0.01,
    "N": 20.0,
}
UNITS = {f"{name}_{p.name}": p.unit for name, effect in CATALOGUE.items() for p in effect.parameters}


#: Parameters with derivatives, as listed by the two functions.
LISTED = (*extended.VALUE_SENSITIVITIES, *extended.GEOMETRY_SENSITIVITIES)


def sensitivities(p: np.ndarray, parameters: Parameters, chosen: extended.Effects) -> list[np.ndarray]:
    """Return full derivatives of M and K by every parameter: listed entries are symmetric, all others zero."""
    by_value = spread(extended.value_sensitivities(p, parameters, chosen), extended.VALUE_SENSITIVITIES)
    by_geometry = spread(
        extended.geometry_sensitivities(p, parameters, chosen), extended.GEOMETRY_SENSITIVITIES
    )
    return [np.concatenate(both) for both in zip(by_value, by_geometry, strict=True)]


def spread(entries: tuple[np.ndarray, ...], listed: tuple) -> list[np.ndarray]:
    n, found = len(extended.COORDINATES), []
    for matrix, values in enumerate(entries):
        places = [(i, *place) for i, entry in enumerate(listed) for place in entry[2 + matrix]]
        assert values.shape == (len(places),)
        assert len(set(places)) == len(places)
        full = np.zeros((len(listed), n, n))
        for (i, row, column), value in zip(places, values, strict=True):
            assert row <= column
            full[i, row, column] = full[i, column, row] = value
        found.append(full)
    return found


@pytest.mark.parametrize("null", [True, False])
@pytest.mark.parametrize("seed", range(3))
def test_sensitivities_equal_complex_step_and_central_differences(seed: int, null: bool) -> None:
    parameters, p = robot(seed)
    rng = np.random.default_rng(seed)
    typical = {field: TYPICAL[UNITS[field]] for field in extended.Effects._fields}
    active = {field: size * rng.uniform(0.5, 1.5) for field, size in typical.items()}
    chosen = effects() if null else effects(**active)
    derivatives = sensitivities(p, parameters, chosen)
    now = matrices(p, parameters, chosen)
    for i, (field, index, *_) in enumerate(LISTED):
        size = typical[field] if field in typical else np.abs(np.asarray(getattr(parameters, field))).max()
        step = 1e-4 * size
        by_complex_step = difference(matrices, p, parameters, chosen, field, index, 1e-30j)
        by_differences = difference(matrices, p, parameters, chosen, field, index, step)
        for found, exact, coarse, value in zip(
            derivatives, by_complex_step, by_differences, now, strict=True
        ):
            scale = np.abs(exact).max()
            assert np.abs(found[i] - exact).max() <= 1e-10 * scale, (field, index)
            # Truncation is of fourth order in the step; below it, the rounding of the difference.
            bound = 1e-6 * scale + 1e-14 * np.abs(value).max() / step
            assert np.abs(found[i] - coarse).max() <= bound, (field, index)


def difference(
    function: Callable[..., tuple[np.ndarray, ...]],
    p: np.ndarray,
    parameters: Parameters,
    chosen: extended.Effects,
    field: str,
    index: tuple[int, ...],
    step: complex,
) -> list[np.ndarray]:
    ahead = function(p, *perturbed(parameters, chosen, field, index, step))
    if isinstance(step, complex):
        return [np.imag(a) / step.imag for a in ahead]
    behind = function(p, *perturbed(parameters, chosen, field, index, -step))
    far_ahead = function(p, *perturbed(parameters, chosen, field, index, 2 * step))
    far_behind = function(p, *perturbed(parameters, chosen, field, index, -2 * step))
    parts = zip(ahead, behind, far_ahead, far_behind, strict=True)
    return [(8 * (a - b) - (c - d)) / (12 * step) for a, b, c, d in parts]


@pytest.mark.parametrize("field", ["origin", "joint"])
def test_a_rails_origin_counts_as_its_joint_with_opposite_sign(field: str) -> None:
    parameters, p = robot(0)
    found, _ = sensitivities(p, parameters, effects())
    i = [(name, index) for name, index, *_ in LISTED].index(("joint", (1, 2)))
    value = np.array(getattr(parameters, field), dtype=complex)
    value[1, 2] += 1e-30j
    M, _ = matrices(p, parameters._replace(**{field: value}), effects())
    sign = 1.0 if field == "joint" else -1.0
    np.testing.assert_allclose(
        np.imag(M) / 1e-30, sign * found[i], rtol=0, atol=1e-11 * np.abs(found[i]).max()
    )
