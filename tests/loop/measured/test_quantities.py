"""The table of measured quantities: a made-up entry is read, checked and selected like the others."""

from __future__ import annotations

import copy
import math
import pickle
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from helpers.diagnoses.measurement_files import HEADER, read, refusal
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.columns import Numbers
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import (
    DAMPING,
    FREQUENCY,
    IDENTITY,
    LOGARITHM,
    QUANTITIES,
    MeasuredQuantity,
    NumberColumn,
    Range,
)
from pkmodes.loop.measured.scaling import with_errors

ROWS = "A,0.6,0,-0.245,55,0.1,{}\nA,0.6,0,-0.245,60,0.1,{}\nB,0.5,0,-0.245,50,0.1,{}\n"


@pytest.fixture
def bandwidth(monkeypatch: pytest.MonkeyPatch) -> MeasuredQuantity:
    """A quantity of tests: the half-power bandwidth of a resonance."""
    width = Range(1e-3, 1e3, "a bandwidth from 1 mHz to 1 kHz", "leave it blank if unknown")
    error = Range(1e-6, 1e3, "a standard deviation above 0 Hz", "write that of the bandwidth")
    made_up = MeasuredQuantity(
        NumberColumn("bandwidth", "bandwidth", "Hz", width),
        NumberColumn("sigma_bandwidth", "bandwidth_sigma", "Hz", error),
        LOGARITHM,
        usual_sigma=lambda widths: 0.1 * widths,
    )
    monkeypatch.setitem(QUANTITIES, "bandwidth", made_up)
    return made_up


def test_an_entry_of_the_table_is_a_column_of_files(tmp_path: Path, bandwidth: MeasuredQuantity) -> None:
    text = f"{HEADER},bandwidth [rad/s],sigma_bandwidth [mHz]\n{ROWS.format('3,20', ',', '4,')}"
    data = read(tmp_path, text)
    widths = np.array([3.0, np.nan, 4.0]) / math.tau
    np.testing.assert_allclose(data.numbers["bandwidth"], widths, rtol=1e-15)
    np.testing.assert_allclose(data.numbers["bandwidth_sigma"], [0.02, np.nan, 0.1 * widths[2]], rtol=1e-15)
    np.testing.assert_array_equal(bandwidth.transformed(data), np.log(data.numbers["bandwidth"]))
    np.testing.assert_allclose(bandwidth.transformed_sigma(data), [0.04 * math.pi / 3, np.nan, 0.1])
    absent = read(tmp_path, f"{HEADER}\nA,0.6,0,-0.245,55,0.1\n")
    assert np.isnan(absent.numbers["bandwidth"]).all()
    assert np.isnan(absent.numbers["bandwidth_sigma"]).all()


@pytest.mark.parametrize(
    ("column", "row", "expected"),
    [
        ("bandwidth [mm]", "1", 'expected a unit such as "Hz" or "rad/s" for bandwidth'),
        ("bandwidt", "1", 'did you mean "bandwidth"'),
        ("bandwidth", "-1", "expected a bandwidth from 1 mHz to 1 kHz, found -1 ("),
        ("bandwidth [kHz]", "2", "expected a bandwidth from 1 mHz to 1 kHz, found 2 kHz (2000 Hz)"),
        ("bandwidth", "one", 'expected a finite number, found "one"'),
        ("sigma_bandwidth [%]", "1", "multiply by the bandwidth, and write the result in its unit"),
        ("sigma_bandwidth", "0", "expected a standard deviation above 0 Hz, found 0 ("),
        ("bandwidth,sigma_bandwidth", "1,2", "expected a standard deviation below the bandwidth, found 2"),
    ],
)
def test_its_mistakes_are_refused_with_line_and_column(
    tmp_path: Path, bandwidth: MeasuredQuantity, column: str, row: str, expected: str
) -> None:
    line = refusal(tmp_path, f"{HEADER},{column}\nA,0.6,0,-0.245,55,0.1,{row}\n")
    assert expected in line, line
    assert "line " in line


def test_it_goes_with_the_rows_of_measurements(bandwidth: MeasuredQuantity) -> None:
    labels, three = ["A", "B", "A"], [1.0, 1.0, 1.0]
    data = Measurements.from_rows(
        labels, [10, 20, 30], three, bandwidth=[1.0, 2.0, np.nan], bandwidth_sigma=0.5
    )
    np.testing.assert_array_equal(data.numbers["bandwidth"], [1.0, 2.0, np.nan])
    np.testing.assert_array_equal(data.at([0]).numbers["bandwidth"], [1.0, np.nan])
    np.testing.assert_array_equal(data.at([1]).numbers["bandwidth_sigma"], [0.5])
    for same in (replace(data, band=(1, 40)), copy.deepcopy(data), pickle.loads(pickle.dumps(data))):
        np.testing.assert_array_equal(same.numbers["bandwidth"], data.numbers["bandwidth"])
    wider = replace(data, bandwidth=2 * data.numbers["bandwidth"])
    np.testing.assert_array_equal(wider.numbers["bandwidth"], [2.0, 4.0, np.nan])
    assert wider.frequency.tolist() == [10.0, 20.0, 30.0]
    with pytest.raises(ValueError, match="read-only"):
        data.numbers["bandwidth"][0] = 3.0
    with pytest.raises(MeasurementError, match="below the bandwidth") as error:
        Measurements.from_rows(["A"], [10], [1], bandwidth=[1.0], bandwidth_sigma=[2.0])
    assert error.value.where == "measurements: line 1, argument bandwidth_sigma"
    with pytest.raises(MeasurementError, match=r"shape \(1,\), found \(2,\)"):
        Measurements.from_rows(["A"], [10], [1], bandwidth=[1.0, 2.0])
    with pytest.raises(MeasurementError) as error:
        Measurements.from_rows(["A"], [10], [1], bandwith=[1.0])
    assert error.value.remedy == 'did you mean "bandwidth"?'


def test_rows_that_differ_in_it_do_not_repeat_each_other(bandwidth: MeasuredQuantity) -> None:
    twice = {"pose": ["A", "A"], "frequency": [10, 10], "sigma": [1, 1]}
    assert Measurements.from_rows(**twice, bandwidth=[1.0, 2.0]).frequency.tolist() == [10.0, 10.0]
    with pytest.raises(MeasurementError, match="repeats line 1"):
        Measurements.from_rows(**twice, bandwidth=[1.0, 1.0])


def test_a_row_is_repeated_whatever_is_said_of_the_error_of_an_optional_quantity() -> None:
    """Only the standard deviation that every row has tells two measurements of one mode apart."""
    twice = {"pose": ["A", "A"], "frequency": [10, 10], "damping": [0.02, 0.02]}
    with pytest.raises(MeasurementError, match="repeats line 1"):
        Measurements.from_rows(**twice, sigma=[1, 1], damping_sigma=[0.001, 0.002])
    assert len(Measurements.from_rows(**twice, sigma=[1, 2], damping_sigma=0.001).frequency) == 2


def test_columns_are_those_at_the_time_they_were_given() -> None:
    given = {"frequency": np.array([10.0])}
    numbers = Numbers(given)
    given["frequency"] = np.array([20.0])
    given["more"] = np.array([1.0])
    assert {name: column.tolist() for name, column in numbers.items()} == {"frequency": [10.0]}


def test_without_its_entry_it_is_unknown(tmp_path: Path) -> None:
    assert 'unknown column "bandwidth"' in refusal(tmp_path, f"{HEADER},bandwidth\n{ROWS}")
    with pytest.raises(MeasurementError, match='unknown argument "bandwidth"'):
        Measurements.from_rows(["A"], [10], [1], bandwidth=[1.0])


def test_frequencies_are_compared_by_their_logarithms_and_ratios_as_they_are() -> None:
    data = Measurements.from_rows(["A"] * 2, [10, 20], [0.1, 0.4], damping=[0.0, 0.02])
    np.testing.assert_array_equal(FREQUENCY.transformed(data), np.log([10.0, 20.0]))
    np.testing.assert_array_equal(FREQUENCY.transformed_sigma(data), [0.1 / 10.0, 0.4 / 20.0])
    assert FREQUENCY.residual(np.log(data.frequency), np.log([5.0, 20.0])) == pytest.approx([math.log(2), 0])
    assert DAMPING.transformation is IDENTITY
    np.testing.assert_array_equal(DAMPING.transformed(data), data.damping)
    np.testing.assert_array_equal(DAMPING.transformed_sigma(data), [0.0, 0.3 * 0.02])


@pytest.mark.parametrize("factor", [0.5, 2.0])
def test_all_errors_are_scaled_together(bandwidth: MeasuredQuantity, factor: float) -> None:
    data = Measurements.from_rows(
        ["A", "A", "B"],
        [10.0, 20.0, 30.0],
        [0.1, 0.2, 0.3],
        damping=[0.02, 0.04, np.nan],
        bandwidth=[1.0, np.nan, 2.0],
        bandwidth_sigma=[0.25, 0.5, np.nan],
        shapes={"x_1": [1.0, np.nan, 0.5]},
        shape_sigma=[0.05, np.nan, 0.02],
        points=[[0.6, 0.0, -0.2], [0.6, 0.0, -0.2], [0.5, 0.0, -0.2]],
        point_sigma=[[0.001, 0.0, 0.0], [0.001, 0.0, 0.0], [0.0, 0.002, 0.0]],
    )
    scaled = with_errors(data, factor)
    for name in ("sigma", "damping_sigma", "bandwidth_sigma"):
        np.testing.assert_array_equal(scaled.numbers[name], factor * data.numbers[name], err_msg=name)
    np.testing.assert_array_equal(scaled.shape_sigma, factor * data.shape_sigma)
    np.testing.assert_array_equal(scaled.point_sigma, factor * data.point_sigma)
    for name in ("frequency", "damping", "bandwidth"):
        np.testing.assert_array_equal(scaled.numbers[name], data.numbers[name], err_msg=name)
    np.testing.assert_array_equal(scaled.shapes, data.shapes)


def test_errors_are_scaled_as_far_as_a_file_may_state_them() -> None:
    data = Measurements.from_rows(
        ["A", "A"],
        [10.0, 20.0],
        [6.0, 1e-30],
        damping=[0.5, 0.5],
        damping_sigma=[0.6, 0.0],
        shapes={"x_1": [1.0, 1.0]},
        shape_sigma=[0.7, 1e-30],
    )
    larger, smaller = with_errors(data, 2.0), with_errors(data, 0.5)
    assert larger.sigma.tolist() == [math.nextafter(10.0, 0.0), 2e-30]
    assert larger.damping_sigma.tolist() == [math.nextafter(1.0, 0.0), 0.0]
    assert larger.shape_sigma.tolist() == [math.nextafter(1.0, 0.0), 2e-30]
    assert smaller.sigma.tolist() == [3.0, 1e-30]
    assert smaller.shape_sigma.tolist() == [0.35, 1e-30]


def test_columns_of_reports_have_the_heading_of_the_quantity(bandwidth: MeasuredQuantity) -> None:
    assert (FREQUENCY.value.heading, FREQUENCY.sigma.heading) == (
        "f [Hz]",
        "\N{GREEK SMALL LETTER SIGMA} [Hz]",
    )
    assert bandwidth.value.heading == "bandwidth [Hz]"
