"""Shapes and types of arguments and results of the generated functions.

One pose at a time is the reference: every batch must hold the same numbers, entry for entry, constants too.
"""

from __future__ import annotations

from itertools import product
from typing import Any

import numpy as np
import pytest

from helpers.generated.generated_functions import CORE_SHAPES, FUNCTIONS, SIGNATURES, arguments, outputs
from helpers.robots.sample_robots import SAMPLES, Sample, sample, tower_printer
from pkmodes_generated.linear_delta import Parameters, model

NAMES = sorted(FUNCTIONS)
# NumPy may use other instructions (fused multiply-add, vector square root) for arrays than for numbers; a few
# units in the last place of some tens of operations, for the well conditioned poses used here.
SAME_NUMBERS = 1e-13

BATCH_SHAPES = [(), (1,), (4,), (2, 5), (3, 1, 2)]


def _near(robot: Sample, shape: tuple[int, ...], seed: int) -> np.ndarray:
    """Reachable poses within 10 mm of a sample's pose."""
    shift = np.random.default_rng(seed).uniform(-0.01, 0.01, (*shape, 3))
    return robot.pose + shift


def _batched(name: str, robot: Sample, shape: tuple[int, ...]) -> dict[str, Any]:
    """Arguments, all with a batch axis except the parameters."""
    poses = _near(robot, shape, seed=1)
    rows = [
        arguments(name, Sample(robot.parameters, pose), seed)
        for seed, pose in enumerate(poses.reshape(-1, 3))
    ]
    stacked: dict[str, Any] = {}
    for argument in SIGNATURES[name]:
        if argument == "parameters":
            stacked[argument] = robot.parameters
        else:
            core = CORE_SHAPES[argument]
            values = np.array([row[argument] for row in rows]) if rows else np.empty((0, *core))
            stacked[argument] = values.reshape((*shape, *core))
    return stacked


def _row(given: dict[str, Any], index: tuple[int, ...]) -> dict[str, Any]:
    return {key: value if key == "parameters" else value[index] for key, value in given.items()}


def _assert_same(found: np.ndarray, expected: np.ndarray) -> None:
    np.testing.assert_allclose(
        found, expected, rtol=SAME_NUMBERS, atol=SAME_NUMBERS * np.max(np.abs(expected))
    )


def test_batch_holds_the_values_of_single_poses(subtests: pytest.Subtests) -> None:
    for name, shape in product(NAMES, BATCH_SHAPES):
        with subtests.test(f"{name}, {shape}"):
            given = _batched(name, sample("random-3"), shape)
            found = outputs(name, **given)
            for index in np.ndindex(*shape):
                single = outputs(name, **_row(given, index))
                for batch, one in zip(found, single, strict=True):
                    assert batch.shape == (*shape, *np.shape(one))
                    assert batch.dtype == np.float64
                    # every entry, so also the constant ones, which are assigned once for all
                    _assert_same(batch[index], one)


def test_empty_batch_gives_empty_outputs(subtests: pytest.Subtests) -> None:
    for name, shape in product(NAMES, [(0,), (2, 0)]):
        with subtests.test(f"{name}, {shape}"):
            robot = sample("random-3")
            single = outputs(name, **arguments(name, robot))
            found = outputs(name, **_batched(name, robot, shape))
            assert [np.shape(one) for one in found] == [(*shape, *np.shape(one)) for one in single]


def test_outputs_without_batch_or_axes_are_numbers(subtests: pytest.Subtests) -> None:
    for name in NAMES:
        with subtests.test(name=name):
            for one in outputs(name, **arguments(name, sample("random-0"))):
                assert isinstance(one, np.ndarray if np.ndim(one) else np.float64)
                assert np.all(np.isfinite(one))


def _stacked_parameters(robots: list[Parameters], shape: tuple[int, ...]) -> Parameters:
    fields = zip(*robots, strict=True)
    return Parameters(*(np.stack(field).reshape(*shape, *np.shape(field[0])) for field in fields))


def test_each_robot_of_a_batch_of_parameters_has_its_own_values(subtests: pytest.Subtests) -> None:
    """Parameters with batch (4, 1) beside arguments with batch (4, 2): different robots, two poses each."""
    for name in NAMES:
        with subtests.test(name=name):
            robots = [sample(f"random-{seed}") for seed in (0, 1, 3, 5)]
            given = [_batched(name, robot, (2,)) for robot in robots]
            together: dict[str, Any] = {
                argument: np.stack([row[argument] for row in given])
                for argument in SIGNATURES[name]
                if argument != "parameters"
            }
            together["parameters"] = _stacked_parameters([robot.parameters for robot in robots], (4, 1))
            found = outputs(name, **together)
            for j, robot in enumerate(robots):
                for k in range(2):
                    alone = outputs(name, **_row(given[j], (k,)) | {"parameters": robot.parameters})
                    for batch, one in zip(found, alone, strict=True):
                        assert batch.shape == (4, 2, *np.shape(one))
                        _assert_same(batch[j, k], one)


def test_one_pose_broadcasts_against_batched_parameters(subtests: pytest.Subtests) -> None:
    """The same arguments without batch for robots that differ in everything except geometry."""
    robot = sample("random-2")
    base = robot.parameters
    geometry = {"origin", "direction", "joint", "link_length", "limits", "branch", "drive", "carriage_length"}
    single = [
        Parameters(
            *(
                value if field in geometry else np.asarray(value) * factor
                for field, value in zip(Parameters._fields, base, strict=True)
            )
        )
        for factor in np.linspace(0.8, 1.2, 3)
    ]
    # only the fields that differ get a batch axis: the others broadcast
    batched = Parameters(
        *(
            base[i] if field in geometry else np.stack([one[i] for one in single])
            for i, field in enumerate(Parameters._fields)
        )
    )
    for name in NAMES:
        with subtests.test(name=name):
            given = arguments(name, robot)
            found = outputs(name, **given | {"parameters": batched})
            for index, parameters in enumerate(single):
                alone = outputs(name, **given | {"parameters": parameters})
                for batch, one in zip(found, alone, strict=True):
                    # a function of the geometry alone has no batch axis
                    _assert_same(batch[index] if batch.ndim > np.ndim(one) else batch, one)


def test_batch_axes_of_each_parameter_reach_the_outputs(subtests: pytest.Subtests) -> None:
    """A batch axis on one field at a time; M and K together depend on all fields."""
    for field in Parameters._fields:
        with subtests.test(field=field):
            robot = sample("random-2")
            value = np.asarray(getattr(robot.parameters, field))
            batched = robot.parameters._replace(**{field: np.broadcast_to(value, (2, 3, *value.shape))})
            for batch, one in zip(
                model.modal_matrices(robot.pose, batched),
                model.modal_matrices(robot.pose, robot.parameters),
                strict=True,
            ):
                # M does not see belts or gravity, K does not see masses of pulleys: but both have one batch
                assert batch.shape == (2, 3, 9, 9)
                _assert_same(batch, np.broadcast_to(one, batch.shape))


FURTHER = [
    (name, other) for name in NAMES for other in SIGNATURES[name] if other not in ("p", "x", "parameters")
]


def test_further_arguments_broadcast_against_the_pose(subtests: pytest.Subtests) -> None:
    for name, argument in FURTHER:
        with subtests.test(f"{name}, {argument}"):
            robot = sample("random-6")
            single = arguments(name, robot)
            rng = np.random.default_rng(3)
            core = CORE_SHAPES[argument]
            many = rng.normal(size=(7, 1, *core)) if argument != "assembly" else np.array([[1.0], [-1.0]])
            first = SIGNATURES[name][0]
            places = (robot.pose if first == "p" else single["x"]) + rng.uniform(-0.01, 0.01, (2, 3))
            found = outputs(name, **single | {argument: many, first: places})
            for j in range(len(many)):
                for k in range(2):
                    expected = outputs(name, **single | {argument: many[j, 0], first: places[k]})
                    for batch, one in zip(found, expected, strict=True):
                        # an output that does not depend on the argument may have kept the smaller batch
                        assert batch.shape[: batch.ndim - np.ndim(one)] == (len(many), 2)
                        _assert_same(batch[j, k], one)


def test_integers_are_taken_as_numbers(subtests: pytest.Subtests) -> None:
    """Centre of the tower at z = 0, in plain lists of integers."""
    for name in NAMES:
        with subtests.test(name=name):
            robot = tower_printer((0, 0, 0))
            exact = arguments(name, robot)
            whole = {"p": [0, 0, 0], "assembly": int(exact.get("assembly", 1)), "x": [1, 1, 1]}
            whole |= {"x_dot": [1, -2, 3], "q_dot": list(range(9)), "delta_q": list(range(-4, 5))}
            given = {key: whole.get(key, robot.parameters) for key in exact}
            floats = {
                key: value if key == "parameters" else np.asarray(value, dtype=float)
                for key, value in given.items()
            }
            for one, other in zip(outputs(name, **given), outputs(name, **floats), strict=True):
                np.testing.assert_array_equal(one, other)
                assert np.asarray(one).dtype == np.float64


def test_a_robot_all_in_integers_is_not_rounded_to_integers(subtests: pytest.Subtests) -> None:
    """Three rails at right angles, linkages of 5 that reach across 3 and along 4."""
    three = [1, 2, 3]
    whole = Parameters(
        platform_mass=2,
        gravity=[0, 0, -10],
        origin=[[0, 3, 0], [0, 0, 3], [3, 0, 0]],
        direction=[[1, 0, 0], [0, 1, 0], [0, 0, 1]],
        joint=[[0, 0, 0]] * 3,
        link_length=[5, 5, 5],
        **dict.fromkeys(
            ("link_mass", "carriage_mass", "belt_width", "pulley_radius", "pulley_inertia", "gear_ratio"),
            three,
        ),
        carriage_length=[1, 1, 1],
        belt_specific_stiffness=[7, 8, 9],
        motor_inertia=three,
        drive=[[1, 0], [0, 1], [1, 0]],
        limits=[[-9, 9]] * 3,
        branch=[1, 1, 1],
    )
    exact = Parameters(*(np.asarray(value, dtype=float) for value in whole))
    known = {"p": [0, 0, 0], "x": [4, 4, 4], "x_dot": [1, -2, 3]}
    known |= {"q_dot": list(range(9)), "delta_q": list(range(-4, 5))}
    for name in NAMES:
        with subtests.test(name=name):
            given = arguments(name, Sample(exact, np.zeros(3)))
            integers = {**known, "assembly": int(given.get("assembly", 1))}
            floats = {key: np.asarray(value, dtype=float) for key, value in integers.items()}
            found = outputs(name, **{key: integers.get(key, whole) for key in given})
            expected = outputs(name, **{key: floats.get(key, exact) for key in given})
            for one, other in zip(found, expected, strict=True):
                assert np.asarray(one).dtype == np.float64
                # integer powers may be taken by multiplication, others by pow
                _assert_same(one, other)


def test_complex_arguments_without_imaginary_part_change_nothing(subtests: pytest.Subtests) -> None:
    for name in NAMES:
        with subtests.test(name=name):
            given = arguments(name, sample("random-1"))
            first = SIGNATURES[name][0]
            for one, other in zip(
                outputs(name, **given), outputs(name, **given | {first: given[first] + 0j}), strict=True
            ):
                # a complex square root or product may round differently
                _assert_same(np.real(other), one)
                assert np.iscomplexobj(other)
                assert not np.any(np.imag(other))


WITH_AXES = [(name, other) for name in NAMES for other in SIGNATURES[name] if CORE_SHAPES.get(other)]


def test_wrong_trailing_axis_is_refused(subtests: pytest.Subtests) -> None:
    for name, argument in WITH_AXES:
        with subtests.test(f"{name}, {argument}"):
            given = arguments(name, sample("random-1"))
            (size,) = CORE_SHAPES[argument]
            for shape in [(), (size - 1,), (size + 1,), (size, 1)]:
                with pytest.raises(ValueError, match="expected an array of shape"):
                    outputs(name, **given | {argument: np.zeros(shape)})


FIELDS_WITH_AXES = [field for field in Parameters._fields if field != "platform_mass"]


def test_parameter_with_wrong_trailing_axes_is_refused(subtests: pytest.Subtests) -> None:
    for field in FIELDS_WITH_AXES:
        with subtests.test(field=field):
            robot = sample("random-1")
            value = getattr(robot.parameters, field)
            for wrong in (value[..., :-1], value[0], 1.0):
                with pytest.raises(ValueError, match="expected an array of shape"):
                    model.modal_matrices(robot.pose, robot.parameters._replace(**{field: wrong}))


def test_batches_that_do_not_match_are_refused(subtests: pytest.Subtests) -> None:
    for name in NAMES:
        with subtests.test(name=name):
            robot = sample("random-1")
            given = _batched(name, robot, (3,))
            given["parameters"] = robot.parameters._replace(
                link_length=np.tile(robot.parameters.link_length, (2, 1))
            )
            with pytest.raises(ValueError, match="broadcast"):
                outputs(name, **given)


def test_out_of_reach_is_not_a_number_and_spoils_no_other_pose(subtests: pytest.Subtests) -> None:
    for robot_name in SAMPLES:
        with subtests.test(robot_name=robot_name):
            robot = sample(robot_name)
            far = robot.pose + np.array([[0.0, 0.0, 0.0], [9.0, 9.0, 9.0], [0.001, 0.0, 0.0]])
            margins = model.reach_margin(far, robot.parameters)
            with np.errstate(invalid="ignore"):
                x = model.inverse_kinematics(far, robot.parameters)
                platform = model.direct_kinematics([[0.0, 5.0, -7.0]], 1.0, robot.parameters)
            np.testing.assert_array_equal(np.isnan(x), margins < 0)
            assert np.all(margins[[0, 2]] > 0)
            assert np.any(margins[1] < 0)
            assert np.all(np.isnan(platform)), "carriages ten metres apart"
