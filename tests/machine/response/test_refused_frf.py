"""Frequency responses that are refused: 0 Hz of a free machine, and arguments that are wrong, with what to do."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

import pkmodes
from helpers.robots.one_of_each import FILES, POSES, model_of
from pkmodes.core.base.errors import PkmodesError


@pytest.mark.parametrize("mechanism", FILES)
def test_0_hz_is_refused_where_the_machine_moves_without_end(mechanism: str) -> None:
    model, p = model_of(mechanism, {}, ratio=0.02), POSES[mechanism]
    with pytest.raises(PkmodesError, match=r'0 Hz.*motors free.*rigid modes.*drives="held"'):
        model.frf(p, [10.0, 0.0], ["force_x"], ["p_x"])
    assert np.isfinite(model.frf(p, [10.0, 0.0], ["force_x"], ["p_x"], drives="held").values).all()
    servo = model.with_values({"effects.servo_stiffness.stiffness": 50.0})
    assert np.isfinite(servo.frf(p, [0.0], ["force_x", "torque_1"], ["p_x"]).values).all()


@pytest.mark.parametrize(
    "frequencies", [-1.0, [10.0, -2.0], [np.nan], [10.0, np.inf], [], None, "fast", [[1.0, 2.0]], [1j], {}]
)
def test_frequencies_that_are_none_are_refused(frequencies: Any) -> None:
    with pytest.raises(PkmodesError, match=r"expected (a list of )?frequencies.*\(frequencies\)"):
        model_of("corexy", {}, ratio=0.02).frf(
            POSES["corexy"], frequencies, ["force_x"], ["p_x"], drives="held"
        )


WRONG = [
    ({"inputs": ["forcex"]}, r'unknown name "forcex" \(inputs\); did you mean "force_x"'),
    ({"inputs": ["torque_3"]}, r'unknown name "torque_3" \(inputs\); did you mean "torque_'),
    ({"inputs": ["p_x"]}, r'unknown name "p_x" \(inputs\)'),
    ({"inputs": [3]}, r"unknown name 3 \(inputs\); known: torque_1"),
    ({"inputs": []}, "at least one of the inputs"),
    ({"inputs": ["force_x", "force_x"]}, '"force_x" is given twice'),
    (
        {"inputs": ["motor_1"]},
        r'prescribed angle, but the motors are free .*use torque_1, or drives="held"',
    ),
    (
        {"inputs": ["torque_1"], "drives": "held"},
        r'torque of a motor, but the motors are held .*use motor_1, or drives="free"',
    ),
    ({"outputs": ["p_z"]}, r'unknown name "p_z" \(outputs\); did you mean "p_[xy]"'),
    ({"outputs": ["psi_1"]}, r'unknown name "psi_1" \(outputs\)'),
    ({"outputs": ["force_x"]}, r'unknown name "force_x" \(outputs\)'),
    ({"outputs": []}, "at least one of the outputs"),
    ({"outputs": [{}]}, "at least one of the outputs"),
    ({"outputs": ["p_x", "p_x"]}, '"p_x" is given twice'),
    ({"outputs": {"oblique": [0.0, 0.0]}}, r"expected a direction along x, y.*\(outputs: oblique\)"),
    ({"outputs": {"oblique": [1.0, 0.0, 0.0]}}, "expected a direction along x, y"),
    ({"outputs": {"oblique": [np.nan, 1.0]}}, "expected a direction along x, y"),
    ({"outputs": {"oblique": "up"}}, 'expected a direction along x, y, found "up"'),
    ({"quantity": "speed"}, 'expected displacement, velocity or acceleration, found "speed"'),
    ({"quantity": None}, "expected displacement, velocity or acceleration"),
    ({"drives": "locked"}, 'expected "free" or "held", found "locked"'),
    ({"on_error": "skip"}, 'expected on_error "raise" or "nan"'),
]


def test_wrong_arguments_are_refused_with_what_to_do(subtests: pytest.Subtests) -> None:
    for arguments, message in WRONG:
        with subtests.test(arguments=arguments):
            given: dict[str, Any] = {"frequencies": [10.0], "inputs": ["force_x"], "outputs": ["p_x"]}
            with pytest.raises(PkmodesError, match=message):
                model_of("corexy", {}, ratio=0.02).frf(POSES["corexy"], **(given | dict(arguments)))


@pytest.mark.parametrize("names", [None, 5, [["p_x"]]])
@pytest.mark.parametrize("argument", ["inputs", "outputs"])
def test_what_is_no_list_of_names_is_refused(argument: str, names: Any) -> None:
    given: dict[str, Any] = {"frequencies": [10.0], "inputs": ["force_x"], "outputs": ["p_x"]}
    with pytest.raises(PkmodesError, match=argument):
        model_of("corexy", {}, ratio=0.02).frf(POSES["corexy"], **(given | {argument: names}))


@pytest.mark.parametrize("name", ["p_x", "y", "motor_1"])
def test_a_direction_does_not_take_the_name_of_another_output(name: str) -> None:
    """Otherwise a table's `p_x` would be motion along y."""
    with pytest.raises(PkmodesError, match=name):
        model_of("corexy", {}, ratio=0.02).frf(POSES["corexy"], [10.0], ["force_x"], {name: [0.0, 1.0]})


def test_a_pose_outside_is_refused() -> None:
    with pytest.raises(pkmodes.PoseError):
        model_of("corexy", {}, ratio=0.02).frf([9.0, 9.0], [10.0], ["force_x"], ["p_x"])
