"""Matrices, Jacobians and statics of one pose, free and held, with effects: those of NumPy, and those of a batch."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from helpers.robots import sample_mechanisms
from helpers.robots.one_of_each import EVERY, ROBOTS
from pkmodes import Model, PkmodesError, PoseError, read_robot
from pkmodes.core.mechanism.poses import CHUNK
from pkmodes.core.mechanism.regular import regular_poses
from pkmodes.core.solve.mode_fields import ModeFields

pytestmark = pytest.mark.compiler

#: Fields, and the largest difference relative to the largest entry: hundreds of operations, each rounded to 1e-16.  A
#: condition number multiplies the error of its matrix, and amplitudes have the error of shapes (1e-8 at most).
FIELDS = {
    "mass_matrix": 1e-13,
    "stiffness_matrix": 1e-13,
    "platform_motion": 1e-13,
    "platform_jacobian": 1e-13,
    "joint_positions": 1e-13,
    "static_torque": 1e-13,
    "static_rotation": 1e-13,
    "elastic_stiffness": 1e-13,
    "condition": 1e-12,
    "vibration_amplitudes": 1e-9,
}


@cache
def model(name: str, effects: bool) -> Model:
    robot = read_robot(ROBOTS / EVERY[name])
    if effects:
        values = {
            f"effects.{effect.name}.{parameter.name}": sample_mechanisms.TYPICAL[key]
            for effect in robot.mechanism.conservative_effects.values()
            for parameter in effect.parameters
            if (key := f"{effect.name}_{parameter.name}") in sample_mechanisms.TYPICAL
            and not parameter.name.startswith("compliance_")  # of a direction, instead of all
        }
        robot = robot.with_values(values)
    return Model(robot)


def poses(of: Model) -> np.ndarray:
    """Four poses, and one that is out of reach."""
    found = regular_poses(of._generated, of.mechanism, of.robot.parameters)
    return np.concatenate([found, found[:1] + 50.0])


@pytest.mark.parametrize("effects", [False, True], ids=["plain", "with effects"])
@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("name", sorted(EVERY))
def test_fields_are_those_of_numpy(name: str, drives: str, effects: bool) -> None:
    of = model(name, effects)
    points = poses(of)
    for field, most in FIELDS.items():
        (_, numpy), (_, compiled) = (
            of.fields_at(points, "nan", [field], backend, drives=drives) for backend in ("numpy", "compiled")
        )
        expected, found = numpy[field], compiled[field]
        np.testing.assert_array_equal(np.isnan(found), np.isnan(expected), err_msg=field)
        assert np.isnan(found[-1]).all(), field
        size = np.nan_to_num(np.abs(expected)).max()
        np.testing.assert_allclose(found, expected, rtol=0.0, atol=most * size, err_msg=field)
        for k, point in enumerate(points[:-1]):
            _, alone = of.fields_at(point, "raise", [field], "compiled", drives=drives)
            np.testing.assert_array_equal(alone[field], found[k], err_msg=field)
    names = ["frequencies", "shapes", *(field for field in FIELDS if field != "condition")]
    _, together = of.fields_at(points, "nan", names, "compiled", drives=drives)
    _, one = of.fields_at(points[0], "nan", names, "compiled", drives=drives)
    for field in names:
        np.testing.assert_array_equal(one[field], together[field][0], err_msg=field)


@pytest.mark.parametrize("effects", [False, True], ids=["plain", "with effects"])
@pytest.mark.parametrize("name", sorted(EVERY))
def test_methods_give_these_fields(name: str, effects: bool) -> None:
    of = model(name, effects)
    points, lost = poses(of)[:-1], poses(of)[-1]
    M, K = of.matrices(points)
    modes = of.modes(points, fields=["mass_matrix", "stiffness_matrix"])
    np.testing.assert_array_equal(M, modes.mass_matrix)
    np.testing.assert_array_equal(K, modes.stiffness_matrix)
    statics = of.statics(points[0])
    np.testing.assert_array_equal(statics.torques, of.statics(points).torques[0])
    np.testing.assert_array_equal(statics.rotations, of.statics(points).rotations[0])
    lengths = np.repeat(
        [1.0, of.characteristic_length], [len(of.mechanism.directions), len(of.mechanism.rotations)]
    )
    singular = np.linalg.svd(of.platform_jacobian(points) * lengths[:, None], compute_uv=False)
    np.testing.assert_allclose(of.condition(points), singular[:, 0] / singular[:, -1], rtol=1e-13)
    for method in (of.matrices, of.statics, of.platform_jacobian, of.inverse_kinematics, of.condition):
        with pytest.raises(PoseError) as refused:
            method(lost)
        with pytest.raises(PoseError) as expected:
            of.modes(lost, backend="numpy")
        assert str(refused.value) == str(expected.value)


def test_results_go_where_the_caller_says() -> None:
    of = model("linear_delta", False)
    points = poses(of)[:-1]
    M, K = of.matrices(points)
    own = np.empty_like(M)
    found = of.matrices(points, out={"mass_matrix": own}, threads=1)
    assert found[0] is own
    np.testing.assert_array_equal(own, M)
    np.testing.assert_array_equal(found[1], K)
    for method in (of.platform_jacobian, of.inverse_kinematics, of.condition):
        expected = method(points)
        array = np.empty_like(expected)
        assert method(points, out=array) is array
        np.testing.assert_array_equal(array, expected)
        one = np.empty_like(expected[0])
        np.testing.assert_array_equal(method(points[0], out=one), expected[0])
    with pytest.raises(PkmodesError, match="expected an array of shape"):
        of.platform_jacobian(points, out=np.empty(3))
    with pytest.raises(PkmodesError, match='unknown field "mass"'):
        of.matrices(points, out={"mass": own})


@pytest.mark.parametrize("drives", ["free", "held"])
@pytest.mark.parametrize("first", ["mass_matrix", "stiffness_matrix"])
def test_matrices_that_are_read_of_modes_are_those_that_are_asked_for(
    monkeypatch: pytest.MonkeyPatch, first: str, drives: str
) -> None:
    it = model("linear_delta", True)
    given = regular_poses(it._generated, it.mechanism, it.robot.parameters)
    read = list[str]()
    again = ModeFields.evaluate_again

    def counted(fields: ModeFields, *arguments: Any) -> dict[str, np.ndarray]:
        found = again(fields, *arguments)
        read.extend(found)
        return found

    monkeypatch.setattr(ModeFields, "evaluate_again", counted)
    second = {"mass_matrix": "stiffness_matrix", "stiffness_matrix": "mass_matrix"}[first]
    for at in (given[0], given, np.resize(given, (CHUNK + 1, given.shape[1]))):
        asked = it.modes(at, fields=["frequencies", first, second], drives=drives)
        modes = it.modes(at, drives=drives)
        read.clear()
        one = getattr(modes, first)
        assert set(read) == ({first, second} if len(at) <= CHUNK else {first})
        np.testing.assert_array_equal(one, getattr(asked, first))
        np.testing.assert_array_equal(getattr(modes, second), getattr(asked, second))
        assert sorted(read) == sorted([first, second])  # nothing twice
