"""Measurements that are given as arrays obey the rules of files."""

from __future__ import annotations

import pickle
from dataclasses import replace

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.measurements import Measurements


def test_measurements_are_made_by_hand_and_cannot_be_written_to() -> None:
    found = Measurements.from_rows(["rig", "rig"], [10, 20.5], [0.1, 0.1], shapes={"m_1": [1, np.nan]})
    assert found.points.tolist() == [[0.0, 0.0, 0.0]]
    assert found.lines.tolist() == [1, 2]
    assert found.channels == ("m_1",)
    with pytest.raises(ValueError, match="read-only"):
        found.frequency[0] = 1.0
    points = np.zeros((2, 3))
    placed = Measurements.from_rows(["a", "b"], [1, 2], [0.1, 0.1], points=points)
    points[0] = 7.0
    assert (placed.points == 0.0).all()


CHANGES = [
    ({"sigma": [0.1, 0.0]}, "rig: line 2, column sigma", "above 0 Hz"),
    ({"sigma": [0.1]}, "rig: sigma", r"shape \(2,\), found \(1,\)"),
    ({"frequency": ["a", "b"]}, "rig: frequency", "numbers"),
    ({"frequency": 3.0}, "rig: frequency", "shape"),
    ({"frequency": [np.nan, 1.0]}, "rig: line 1, column frequency", "above 0 Hz"),
    ({"mode": ["1"]}, "rig: mode", "expected 2 mode numbers, found 1"),
    ({"pose": "ab"}, "rig: pose", "one label for each row"),
    ({"points": [[0, 0, 0]]}, "rig: points", "shape"),
    ({"points": [[0, 0, 0], [0, 0, 1]]}, "rig: line 2, column z", "two positions"),
    ({"points": [[0, 0, np.inf], [0, 0, np.inf]]}, "rig: line 1, column z", "finite"),
    ({"point_sigma": [[0, 0, -1.0], [0, 0, -1.0]]}, "rig: line 1, column sigma_z", "at least 0 m"),
    ({"shapes": {"m_1": [1.0]}}, "rig: shape:m_1", "shape"),
    ({"shapes": {"m_1": [1.0, np.inf]}}, "rig: line 2, column shape:m_1", "finite"),
    ({"lines": [1.5, 2.5]}, "rig: lines", "whole numbers"),
    ({"shape_sigma": [0.1, 2.0]}, "rig: line 2, argument shape_sigma", "below 1, .* found 2"),
    ({"shape_sigma": 5}, "rig: line 1, argument shape_sigma, the first of 2 problems", "found 5"),
    ({"damping_sigma": [0.1, -1.0]}, "rig: line 2, argument damping_sigma", "found -1"),
    ({"unit": "mm"}, "rig: unit", '"mm" is not a unit of frequency'),
    ({"sigma_shape": 0.02}, "from_rows", 'unknown argument "sigma_shape"'),
]


def test_measurements_made_by_hand_obey_the_same_rules(subtests: pytest.Subtests) -> None:
    for changes, place, expected in CHANGES:
        with subtests.test(f"{place}, {expected}"):
            columns = {
                "pose": ["a", "a"],
                "frequency": [1.0, 2.0],
                "sigma": [0.1, 0.1],
                "source": "rig",
                **changes,
            }
            with pytest.raises(MeasurementError, match=expected) as error:
                Measurements.from_rows(**columns)
            assert error.value.where == place


def test_one_number_states_the_deviation_of_all_shapes() -> None:
    found = Measurements.from_rows(["a", "a"], [1, 2], [0.1, 0.1], shape_sigma=0.02, damping_sigma=0.1)
    assert found.shape_sigma.tolist() == [0.02, 0.02]
    with pytest.raises(MeasurementError) as error:
        Measurements.from_rows(["a"], [1], [0.1], sigma_shape=[0.02])
    assert error.value.remedy == 'did you mean "shape_sigma"?'


def test_of_several_mistakes_that_of_the_frequencies_is_told() -> None:
    data = Measurements.from_rows(["a", "b"], [1, 2], [0.1, 0.1])
    wrong = dict.fromkeys(("damping_sigma", "sigma", "damping", "frequency"), np.ones(3))
    with pytest.raises(MeasurementError, match="frequency"):
        replace(data, **wrong)


def test_a_missing_quantity_is_named() -> None:
    columns = dict.fromkeys(("pose", "labels", "points", "point_sigma", "shapes", "channels"))
    with pytest.raises(TypeError, match="missing measured quantities: sigma, damping, damping_sigma"):
        Measurements(frequency=np.ones(1), **columns)


@pytest.mark.parametrize("protocol", range(pickle.HIGHEST_PROTOCOL + 1))
def test_measurements_can_be_pickled_with_any_protocol_and_show_their_numbers(protocol: int) -> None:
    data = Measurements.from_rows(["a", "b"], [1, 2.5], [0.1, 0.1])
    again = pickle.loads(pickle.dumps(data, protocol))
    assert again.frequency.tolist() == [1.0, 2.5]
    assert "2.5" in repr(again)


def test_a_shape_may_have_components_at_rest() -> None:
    data = Measurements.from_rows(["A"], [10.0], [0.1], shapes={"a": [0.0], "b": [1.0]})
    np.testing.assert_array_equal(data.shapes, [[0.0, 1.0]])


def test_a_refusal_keeps_its_place_in_another_process() -> None:
    with pytest.raises(MeasurementError) as error:
        Measurements.from_rows(["A"], [-10.0], [0.1])
    copied = pickle.loads(pickle.dumps(error.value))
    assert str(copied) == str(error.value)
    assert copied.where == error.value.where != ""
