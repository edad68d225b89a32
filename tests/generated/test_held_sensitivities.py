"""Derivatives with held motors: against differences, and where the motors have no influence."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import FILES, POSES, ROBOTS
from pkmodes.core.base.errors import PkmodesError
from pkmodes.loop.sensitivity.paths import change_quantities, paths, resolve

WINDING = {"effects.gearbox_compliance.compliance": 2e-3}
CASES: list[tuple[str, Mapping[str, float]]] = [
    *((mechanism, {}) for mechanism in FILES),
    ("linear_delta", WINDING),
    ("corexy", {**WINDING, "effects.clamp_compliance.compliance": 1e-6, "effects.payload.mass": 0.1}),
    ("rotary_delta", {"effects.link_compliance.compliance": 1e-7, "effects.cable_stiffness.stiffness": 3e3}),
]
BACKENDS = ["numpy", pytest.param("compiled", marks=pytest.mark.compiler)]
#: Weights of differences at +-h and +-2h, over h.
FOURTH = {1: 2 / 3, -1: -2 / 3, 2: -1 / 12, -2: 1 / 12}


def model_of(mechanism: str, values: Mapping[str, float]) -> pkmodes.Model:
    return pkmodes.load(ROBOTS / FILES[mechanism]).with_values(values)


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize(("mechanism", "values"), CASES)
def test_derivatives_are_those_of_differences(
    mechanism: str, values: Mapping[str, float], backend: str
) -> None:
    model, p = model_of(mechanism, values), POSES[mechanism]
    some = [path for path in paths(model.robot) if resolve(model.robot, path).value != 0.0]
    fields = ["frequencies", "eigenvalues"]
    found = model.sensitivities(p, some, fields=fields, drives="held", backend=backend)
    assert found.drives == "held"
    f = model.frequencies(p, drives="held")
    compared = 0
    for t, path in enumerate(some):
        move = resolve(model.robot, path)
        step = 1e-4 * abs(move.value)
        try:
            slope = sum(
                weight
                / step
                * pkmodes.Model(change_quantities(model.robot, [(move, k * step)])).frequencies(p, drives="held")
                for k, weight in FOURTH.items()
            )
        except PkmodesError:  # a limit that the pose is at
            continue
        scale = f / abs(move.value)
        np.testing.assert_allclose(
            found.frequencies[t], slope, rtol=2e-6, atol=2e-8 * scale.max(), err_msg=path
        )
        rates = 8 * np.pi**2 * f * found.frequencies[t]
        np.testing.assert_allclose(found.eigenvalues[t], rates, rtol=1e-12)
        compared += 1
    assert compared > 10


@pytest.mark.parametrize(("mechanism", "values"), CASES)
def test_shapes_turn_as_differences_say(mechanism: str, values: Mapping[str, float]) -> None:
    model, p = model_of(mechanism, values), POSES[mechanism]
    path = {"linear_delta": "axis.1.link.mass", "rotary_delta": "axis.1.link.mass", "corexy": "toolhead.mass"}
    move = resolve(model.robot, path[mechanism])
    found = model.sensitivities(p, [path[mechanism]], drives="held")
    step = 1e-4 * move.value
    slope = sum(
        weight / step * pkmodes.Model(change_quantities(model.robot, [(move, k * step)])).modes(p, drives="held").shapes
        for k, weight in FOURTH.items()
    )
    size = np.abs(model.modes(p, drives="held").shapes).max(axis=0) / move.value
    assert found.shapes.shape == (1, *slope.shape)
    at_rest = size == 0.0  # rotors of held motors
    assert at_rest.any() or "effects.gearbox_compliance.compliance" in values
    assert (found.shapes[0][:, at_rest] == 0.0).all()
    found_part, slope = (a[:, ~at_rest] / size[~at_rest] for a in (found.shapes[0], slope))
    np.testing.assert_allclose(found_part, slope, rtol=0, atol=2e-6 * np.abs(slope).max())


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("mechanism", ["linear_delta", "corexy"])
def test_a_gearbox_that_begins_to_wind_up_lowers_the_frequencies(mechanism: str, backend: str) -> None:
    """The wind-up is locked with a rigid gearbox: its rotor then follows a motor at rest."""
    model, p = model_of(mechanism, {}), POSES[mechanism]
    path = "effects.gearbox_compliance.compliance"
    fields = ["frequencies"]
    (found,) = model.sensitivities(p, [path], fields=fields, drives="held", backend=backend).frequencies
    held = model.frequencies(p, drives="held")
    small = 1e-9
    slope = (model.with_values({path: small}).frequencies(p, drives="held")[: len(held)] - held) / small
    np.testing.assert_allclose(found, slope, rtol=1e-4)  # the second order of so small a compliance
    assert (found < 0.0).all()


@pytest.mark.parametrize("backend", BACKENDS)
@pytest.mark.parametrize("values", [{}, WINDING])
def test_motors_and_servos_have_no_influence(values: Mapping[str, float], backend: str) -> None:
    model, p = model_of("linear_delta", values), POSES["linear_delta"]
    names = ["motor.inertia", "motor.gear_ratio", "effects.servo_stiffness.stiffness", "pulley.inertia"]
    fields = ["eigenvalues"]
    found = model.sensitivities(p, names, fields=fields, drives="held", backend=backend).eigenvalues
    free = model.sensitivities(p, names, fields=fields, backend=backend).eigenvalues
    assert (np.abs(found[:3]).max(axis=1) <= 1e-12 * np.abs(free[:3]).max(axis=1)).all()
    assert (found[3] != 0.0).any()


def test_matrices_are_those_of_all_coordinates() -> None:
    model, p = model_of("linear_delta", WINDING), POSES["linear_delta"]
    names = ["motor.inertia", "platform.mass", "effects.gearbox_compliance.compliance"]
    held, free = (model.sensitivities(p, names, drives=drives) for drives in ("held", "free"))
    np.testing.assert_array_equal(held.mass_matrix, free.mass_matrix)
    np.testing.assert_array_equal(held.stiffness_matrix, free.stiffness_matrix)
    assert held.shapes.shape == (3, 9, 12)
    assert free.shapes.shape == (3, 12, 12)
    one = model.sensitivities(p, names, fields=["shapes", "groups"], drives="held")
    np.testing.assert_array_equal(one.shapes, held.shapes)


def test_a_batch_is_differentiated_as_its_poses_are() -> None:
    model, p = model_of("corexy", {}), POSES["corexy"]
    poses = p + np.array([[0.0, 0.0], [0.05, 0.1], [9.0, 0.0]])
    names = ["belt.width", "toolhead.mass"]
    batch = model.sensitivities(poses, names, on_error="nan", drives="held", fields=["frequencies"])
    for pose, rates in zip(poses[:2], batch.frequencies, strict=False):
        one = model.sensitivities(pose, names, drives="held", backend="numpy").frequencies
        np.testing.assert_allclose(rates, one, rtol=1e-11)
    assert np.isnan(batch.frequencies[2]).all()
    with pytest.raises(PkmodesError, match=r'expected "free" or "held"'):
        model.sensitivities(p, names, drives="stopped")
