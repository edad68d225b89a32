"""Arrays of sensitivities: their shapes for one pose and many, poses without modes, and refused arguments."""

from __future__ import annotations

import numpy as np
import pytest

import pkmodes
from helpers.references.sensitivity_references import robot_of
from helpers.robots.sample_robots import published
from helpers.robots.sensitivity_cases import GENERIC, case
from pkmodes.loop.sensitivity.sensitivities import Sensitivities


def same(a: Sensitivities, b: Sensitivities, i: object, j: object) -> None:
    for field in ("mass_matrix", "stiffness_matrix", "eigenvalues", "frequencies", "shapes", "groups"):
        x, y = getattr(a, field)[i], getattr(b, field)[j]
        np.testing.assert_allclose(x, y, rtol=1e-9, atol=1e-9 * np.nanmax(np.abs(x)) if x.size else 0.0)


def test_results_have_the_shape_of_the_poses() -> None:
    it = case("published-active")
    model, names = pkmodes.Model(it.robot), it.names[:5]
    one = model.sensitivities(GENERIC, names)
    assert one.mass_matrix.shape == one.stiffness_matrix.shape == (5, 21, 21)
    assert one.eigenvalues.shape == one.frequencies.shape == (5, 21)
    assert one.shapes.shape == (5, 21, 21)
    assert one.groups.shape == (21,)
    assert one.valid.shape == ()
    grid = np.array(GENERIC) + np.array([[0.0, 0.01, 0.02], [0.03, 0.04, 0.05]])[..., None] * [1.0, 0.2, 0.1]
    many = model.sensitivities(grid, names)
    assert many.shapes.shape == (2, 3, 5, 21, 21)
    assert many.groups.shape == (2, 3, 21)
    assert many.valid.tolist() == [[True] * 3] * 2
    same(many, one, (0, 0), ())
    same(many, model.sensitivities(grid[1, 2], names), (1, 2), ())
    same(many, model.sensitivities(grid.reshape(6, 3), names), (1,), slice(3, 6))


def test_bad_poses_are_refused_or_nan() -> None:
    model = pkmodes.Model(case("published").robot)
    found = model.sensitivities([GENERIC, [9.0, 9.0, 9.0], GENERIC], ["link.mass"], on_error="nan")
    assert found.valid.tolist() == [True, False, True]
    assert (found.groups[1] == -1).all()
    for field in ("mass_matrix", "stiffness_matrix", "eigenvalues", "frequencies", "shapes"):
        assert np.isnan(getattr(found, field)[1]).all()
    same(found, model.sensitivities(GENERIC, ["link.mass"]), 2, ())
    none = model.sensitivities([[9.0, 9.0, 9.0]], ["link.mass"], on_error="nan")
    assert none.shapes.shape == (1, 1, 9, 9)
    assert np.isnan(none.shapes).all()
    with pytest.raises(pkmodes.PoseError, match="out of reach"):
        model.sensitivities([GENERIC, [9.0, 9.0, 9.0]])
    with pytest.raises(pkmodes.PoseError, match="at least one pose"):
        model.sensitivities(np.zeros((0, 3)))


def test_no_parameters_give_arrays_without_any() -> None:
    found = pkmodes.Model(case("published").robot).sensitivities([GENERIC], [])
    assert found.parameters == found.units == ()
    assert found.values.shape == (0,)
    assert found.mass_matrix.shape == found.stiffness_matrix.shape == found.shapes.shape == (1, 0, 9, 9)
    assert found.eigenvalues.shape == found.frequencies.shape == (1, 0, 9)
    assert found.groups.tolist() == [list(range(9))]


def test_a_mass_matrix_that_cannot_be_solved_is_named_as_modes_name_it() -> None:
    parameters = published().parameters._replace(carriage_mass=np.zeros(3), link_mass=np.zeros(3))
    robot = robot_of(parameters, {"link_compliance.compliance": 1e-7})
    for ask in ("modes", "sensitivities"):
        with pytest.raises(pkmodes.PoseError, match="mass matrix is not positive definite"):
            getattr(pkmodes.Model(robot), ask)(GENERIC)


@pytest.mark.parametrize("close", [-1e-3, 1.0, float("nan"), "1e-6", None])
def test_a_bad_fraction_is_refused(close: object) -> None:
    with pytest.raises(pkmodes.PkmodesError, match="expected a fraction below 1"):
        pkmodes.Model(case("published").robot).sensitivities(GENERIC, [], close=close)
