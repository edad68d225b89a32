"""Measurement files in other units, the band in which modes were identified, and files without positions."""

from __future__ import annotations

import math
import re
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from helpers.diagnoses.measurement_files import HEADER, ROW
from pkmodes import diagnosis
from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.reading import read_measurements

CHANNELS = {"x_1": "m", "theta_1_1": "rad", "floor [1]": "m", "gauge": "m/s^2"}


def read(tmp_path: Path, text: str, **options) -> Measurements:
    path = tmp_path / "modes.csv"
    path.write_bytes(text.encode("utf-8"))
    return read_measurements(path, options.pop("channels", CHANNELS), **options)


def refusal(tmp_path: Path, text: str, **options) -> str:
    with pytest.raises(MeasurementError) as error:
        read(tmp_path, text, **options)
    (line,) = error.value.lines
    assert str(tmp_path / "modes.csv") in line
    assert error.value.remedy
    return line


# Units -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("unit", "number", "hertz"),
    [
        ("Hz", "55.5", 55.5),
        ("kHz", "0.0555", 55.5),
        ("1/s", "55.5", 55.5),
        ("s^-1", "55.5", 55.5),
        ("1/min", "3330", 55.5),
        ("rpm", "3330", 55.5),
        ("rad/s", "100", 100 / math.tau),
        ("rad/sec", "100", 100 / math.tau),
        ("deg/s", "3600", 10.0),
        ("krad/s", "0.1", 100 / math.tau),
        (" rad / s ", "100", 100 / math.tau),
    ],
)
def test_frequencies_are_converted_to_hertz_and_angular_ones_divided_by_two_pi(
    tmp_path: Path, unit: str, number: str, hertz: float
) -> None:
    found = read(tmp_path, f"pose,x,y,z,frequency [{unit}],sigma[{unit}]\nA,0,0,0,{number},0.01\n")
    assert found.frequency[0] == pytest.approx(hertz, rel=2e-16)
    assert found.sigma[0] == pytest.approx(hertz * 0.01 / float(number), rel=4e-16)


def test_every_quantity_may_have_a_unit_of_its_own(tmp_path: Path) -> None:
    header = (
        "pose,x [mm],y [um],z,frequency [rad/s],sigma,sigma_x [um],sigma_y [mm],damping [%],sigma_damping [%],"
        "sigma_shape [%],shape:x_1 [mm],shape:theta_1_1 [deg],shape:floor [1],shape:gauge [mm/s^2]"
    )
    found = read(tmp_path, f"{header}\nA,35,7,-0.245,100,0.05,100,0.3,2,0.5,5,3,180,1,1\n")
    assert found.points.tolist() == [[0.035, 7e-6, -0.245]]  # the doubles nearest to them
    assert found.point_sigma.tolist() == [[1e-4, 3e-4, 0.0]]
    assert found.sigma.tolist() == [0.05]
    assert found.damping.tolist() == [0.02]
    assert found.damping_sigma.tolist() == [0.005]
    assert found.shape_sigma.tolist() == [0.05]
    assert found.channels == ("x_1", "theta_1_1", "floor [1]", "gauge")
    assert found.shapes.tolist() == [[0.003, math.pi, 1.0, 0.001]]


def test_without_units_of_the_channels_a_shape_is_a_displacement_or_a_rotation(tmp_path: Path) -> None:
    names = list(CHANNELS)
    found = read(tmp_path, f"{HEADER},shape:x_1 [mm],shape:theta_1_1 [deg]\n{ROW},3,180\n", channels=names)
    assert found.shapes.tolist() == [[0.003, math.pi]]
    line = refusal(tmp_path, f"{HEADER},shape:gauge [m/s^2]\n{ROW},3\n", channels=names)
    assert 'such as "mm" or "deg"' in line


@pytest.mark.parametrize(
    ("column", "expected"),
    [
        ("damping [rad]", '"rad" is another kind of unit'),
        ("damping [Hz]", 'such as "%" for damping'),
        ("sigma_x [deg]", 'such as "mm" for sigma_x: "deg" is another kind of unit'),
        ("sigma_x []", '"" is not a unit'),
        ("sigma_x [furlongs per]", "is unknown"),
        ("sigma_x [degC]", "not proportional"),
        ("sigma_x [dB]", "is unknown"),
        ("sigma_x [__import__('os')]", "is not a unit"),
        (f"sigma_x [{'m*' * 1000}m]", "is not a unit"),
        ("mode [1]", 'write only "mode"'),
        ("shape:theta_1_1 [mm]", 'such as "deg" for shape:theta_1_1'),
        ("shape:x_1 [deg]", 'such as "mm" for shape:x_1'),
        ("shape:x_9 [mm]", 'did you mean "shape:x_1"'),
        ("sigma_x (um/s)", 'such as "mm" for sigma_x'),
        ("x [mm]", 'column "x" is repeated, first as column 2'),
        ("set:platform.mass", "unknown column"),
    ],
)
def test_a_unit_that_does_not_belong_is_refused_with_its_column(
    tmp_path: Path, column: str, expected: str
) -> None:
    line = refusal(tmp_path, f"{HEADER},{column}\n{ROW},1\n")
    assert expected in line, line
    assert "modes.csv: line 1, column 7)" in line, line


@pytest.mark.parametrize(
    ("header", "column"),
    [
        (HEADER.replace("frequency", "frequency [m]"), "column 5"),
        (HEADER.replace("frequency", "frequency [hz]"), "column 5"),
        (HEADER.replace("frequency", "frequency [count/s]"), "column 5"),
        (HEADER.replace("sigma", "sigma [%]"), "column 6"),
        (HEADER.replace("pose", "pose [m]"), "column 1"),
        (HEADER.replace(",x", ",x [kg]"), "column 2"),
    ],
)
def test_a_required_column_in_a_wrong_unit_is_refused(tmp_path: Path, header: str, column: str) -> None:
    assert f"line 1, {column})" in refusal(tmp_path, f"{header}\n{ROW}\n")


def test_a_bad_number_is_told_with_the_unit_that_was_expected(tmp_path: Path) -> None:
    line = refusal(tmp_path, f"{HEADER.replace(',x', ',x [mm]')}\nA,600 mm,0,0,5,0.1\n")
    assert "line 2, column x [mm])" in line
    assert "plain number in mm" in line
    # Out of range for doubles only after the conversion, and far out of range for decimals before it.
    for text in ("1e307", "1e999", "1e99999999999999999999"):
        assert "finite" in refusal(tmp_path, f"{HEADER},shape:x_1 [Em]\n{ROW},{text}\n")
    assert "only zeros" in refusal(tmp_path, f"{HEADER},shape:x_1 [mm]\n{ROW},1e-99999999999999999999\n")


@pytest.mark.parametrize(
    ("names", "row", "expected"),
    [
        ("frequency [rad/s],sigma", "-50.882,0.1", "found -50.882 rad/s (-8.09812 Hz)"),
        ("frequency,sigma [1/min]", "55,90000", "below the frequency, found 90000 1/min (1500 Hz)"),
        ("frequency [Hz],sigma", "-3.0,0.1", "above 0 Hz, found -3.0 Hz ("),
        ("frequency,sigma,damping [%]", "55,0.1,200", "below 1, found 200 % (2)"),
        ("frequency,sigma", "-3.0,0.1", "above 0 Hz, found -3 ("),
    ],
)
def test_a_number_that_is_refused_is_quoted_as_it_is_written(
    tmp_path: Path, names: str, row: str, expected: str
) -> None:
    assert expected in refusal(tmp_path, f"pose,x,y,z,{names}\nA,0,0,0,{row}\n")


def test_two_positions_are_quoted_as_they_are_written(tmp_path: Path) -> None:
    text = HEADER.replace(",x", ",x [mm]") + "\nA,450,0,0,5,0.1\n# again\nA, 451,0,0,6,0.1\n"
    line = refusal(tmp_path, text)
    assert 'pose "A" has two positions: x is 450 mm (0.45 m) in line 2 and 451 mm (0.451 m) here' in line
    assert "line 4, column x)" in line


@pytest.mark.parametrize(
    ("column", "remedy"),
    [
        ("sigma [%]", "multiply by the frequency"),
        ("frequency [m]", "or none for Hz"),
        ("x [kg]", "or none for m"),
    ],
)
def test_what_to_write_instead_of_a_wrong_unit(tmp_path: Path, column: str, remedy: str) -> None:
    header = HEADER.replace(f",{column.split(' ')[0]}", f",{column}", 1)
    assert remedy in refusal(tmp_path, f"{header}\n{ROW}\n").partition("; ")[2]


UNITS = {
    "length": {"m": 1.0, "mm": 1e-3, "um": 1e-6, "cm": 1e-2, "inch": 0.0254},
    "frequency": {"Hz": 1.0, "kHz": 1e3, "1/min": 1 / 60, "rpm": 1 / 60, "rad/s": 1 / math.tau},
    "ratio": {"1": 1.0, "%": 1e-2, "ppm": 1e-6},
    "angle": {"rad": 1.0, "deg": math.pi / 180, "mrad": 1e-3},
}
KINDS = {
    **dict.fromkeys(("x", "y", "z", "sigma_x", "sigma_y", "sigma_z", "shape:x_1"), "length"),
    **dict.fromkeys(("frequency", "sigma"), "frequency"),
    **dict.fromkeys(("damping", "sigma_damping", "sigma_shape"), "ratio"),
    "shape:theta_1_1": "angle",
}


@st.composite
def files(draw: st.DrawFn) -> tuple[str, dict[str, list[float]]]:
    """A file in any units, and its content in SI units."""
    units = {name: draw(st.none() | st.sampled_from(sorted(UNITS[kind]))) for name, kind in KINDS.items()}
    factors = {name: UNITS[KINDS[name]][unit] if unit else 1.0 for name, unit in units.items()}
    names = draw(st.permutations(["pose", *KINDS]))
    values: dict[str, list[float]] = {name: [] for name in KINDS}
    heads = [f"{name} [{units[name]}]" if units.get(name) else name for name in names]
    lines = [",".join(heads)]
    for number in range(draw(st.integers(1, 4))):
        row = {name: draw(st.floats(0.01, 0.99)) for name in KINDS}
        row["frequency"] = 10.0 + number + row["frequency"]
        for name, value in row.items():
            values[name].append(value)
        lines.append(
            ",".join(str(number) if name == "pose" else repr(row[name] / factors[name]) for name in names)
        )
    return "\n".join(lines), values


@settings(max_examples=60)
@given(files())
def test_files_in_any_units_read_back_what_was_written(tmp_path: Path, file) -> None:
    text, values = file
    found = read(tmp_path, text)
    back = {
        **{name: found.points[found.pose, k] for k, name in enumerate("xyz")},
        **{f"sigma_{name}": found.point_sigma[found.pose, k] for k, name in enumerate("xyz")},
        "frequency": found.frequency,
        "sigma": found.sigma,
        "damping": found.damping,
        "sigma_damping": found.damping_sigma,
        "sigma_shape": found.shape_sigma,
        **{f"shape:{name}": found.shapes[:, k] for k, name in enumerate(found.channels)},
    }
    assert back.keys() == values.keys()
    for name, column in values.items():
        assert back[name] == pytest.approx(column, rel=1e-15), name


# Standard deviations of damping and shapes -----------------------------------------------------------------


def test_a_blank_deviation_of_damping_is_30_percent_of_it_and_one_of_shapes_is_not_stated(
    tmp_path: Path,
) -> None:
    text = f"{HEADER},damping,sigma_damping,sigma_shape\n{ROW},0.02,,\nA,0.6,0,-0.245,60,0.1,,,0.03\n"
    found = read(tmp_path, text)
    assert found.damping_sigma == pytest.approx([0.006, np.nan], nan_ok=True)
    assert found.shape_sigma == pytest.approx([np.nan, 0.03], nan_ok=True)
    assert found.at([0]).shape_sigma == pytest.approx([np.nan, 0.03], nan_ok=True)
    assert found.at([0]).damping_sigma == pytest.approx([0.006, np.nan], nan_ok=True)


@pytest.mark.parametrize(
    ("column", "bad"), [("sigma_shape", ["0", "-0.1", "1", "5", "nan"]), ("sigma_damping", ["-1", "1"])]
)
def test_a_deviation_out_of_range_is_refused(tmp_path: Path, column: str, bad: list[str]) -> None:
    for number in bad:
        line = refusal(tmp_path, f"{HEADER},damping,{column}\n{ROW},0.02,{number}\n")
        assert f"line 2, column {column})" in line
    with pytest.raises(MeasurementError, match="relative to the largest component, found 1"):
        Measurements.from_rows(["a"], [1.0], [0.1], shape_sigma=[1.0])


# The band --------------------------------------------------------------------------------------------------


def test_a_bad_frequency_is_one_problem_and_not_outside_the_band_too(tmp_path: Path) -> None:
    for number in ("0", "-5", "nan"):
        line = refusal(tmp_path, f"# band: 10, 400\n{HEADER}\nA,0.6,0,-0.245,{number},0.1\n")
        assert "problems" not in line
        assert "in the band" not in line


@pytest.mark.parametrize(
    ("comment", "band"),
    [
        ("# band: 10 Hz, 400 Hz", (10.0, 400.0)),
        ("#band:10,400", (10.0, 400.0)),
        ("  # Band : 10Hz , 0.4 kHz", (10.0, 400.0)),
        ("# band: 600 1/min, 2000 rad/s", (10.0, 2000 / math.tau)),
        ("# band: 10 Hz, 400 Hz,,,", (10.0, 400.0)),  # a spreadsheet fills every line up with commas
        ("# bandwidth: 3", None),
        ("# band of rubber, 3 of them", None),
        ("# the band: 3 Hz", None),
    ],
)
def test_a_comment_states_the_band(tmp_path: Path, comment: str, band: tuple[float, float] | None) -> None:
    for text in (
        f"{comment}\n{HEADER}\n{ROW}\n",
        f"{HEADER}\n{ROW}\n{comment}",
        f"{HEADER}\n{comment}\n{ROW}\n",
    ):
        found = read(tmp_path, text)
        assert found.band == (band if band is None else pytest.approx(band, rel=1e-15))
        assert found.at([0]).band == found.band
        assert found.lines.tolist() == [1 + text.splitlines().index(ROW)]


@pytest.mark.parametrize(
    ("comment", "expected"),
    [
        ("# band: 400 Hz, 10 Hz", "lower and a higher frequency, both above 0 Hz, found 400 Hz and 10 Hz"),
        ("# band: 10 Hz, 10 Hz", "lower and a higher"),
        ("# band: 0 Hz, 10 Hz", "above 0 Hz"),
        ("# band: -1 Hz, 10 Hz", "above 0 Hz"),
        ("# band: 10 Hz, 400 mm", '"mm" is not a unit of frequency'),
        ("# band: 10 Hz", 'found "10 Hz"'),
        ("# band: 10 Hz - 400 Hz", "found"),
        ("# band: 1, 2, 3", "found"),
        ("# band: nan, 3", "found"),
        ("# band: 1, 1e999", "found"),
        ("# band:", 'found ""'),
        ("# band 10 Hz, 400 Hz", "expected a colon"),
        ("# band = 10 Hz, 400 Hz", "expected a colon"),
    ],
)
def test_a_band_that_is_none_is_refused_with_its_line(tmp_path: Path, comment: str, expected: str) -> None:
    line = refusal(tmp_path, f"{HEADER}\n{ROW}\n{comment}\n")
    assert expected in line, line
    assert "modes.csv: line 3)" in line


def test_two_bands_are_refused_where_they_differ(tmp_path: Path) -> None:
    assert read(tmp_path, f"# band: 10, 400\n{HEADER}\n{ROW}\n# band: 10 Hz, 0.4 kHz\n").band == (10.0, 400.0)
    line = refusal(tmp_path, f"# band: 10, 400\n{HEADER}\n{ROW}\n# band: 10 Hz, 401 Hz\n")
    assert "differs from that in line 1 (" in line
    assert "line 4)" in line


def test_a_row_outside_the_band_contradicts_it(tmp_path: Path) -> None:
    line = refusal(tmp_path, f"# band: 10, 50\n{HEADER}\n{ROW}\nA,0.6,0,-0.245,60,0.1\n")
    assert "band from 10 Hz to 50 Hz, found 55.5" in line
    assert "line 3, column frequency, the first of 2 problems)" in line
    assert read(tmp_path, f"# band: 10, 55.5\n{HEADER}\n{ROW}\n").band == (10.0, 55.5)  # the edge is inside
    for band, place in (
        ((20.0, 30.0), "line 1, column frequency"),
        ((30.0, 20.0), "band"),
        ((1, 2, 3), "band"),
    ):
        with pytest.raises(MeasurementError, match=re.escape(f"rig: {place}")):
            Measurements.from_rows(["a"], [10.0], [0.1], band=band, source="rig")
    assert Measurements.from_rows(["a"], [10.0], [0.1], band=(5, 20)).band == (5.0, 20.0)


# Structures other than robots ------------------------------------------------------------------------------


def test_a_structure_without_positions_is_measured_at_labels_alone(tmp_path: Path) -> None:
    path = tmp_path / "modes.csv"
    path.write_text("pose,frequency,sigma,shape:floor 1 [mm]\nempty,5,0.1,1\nloaded,4,0.1,\n")
    found = diagnosis.read_measurements(path, ["floor 1"])
    assert found.labels == ("empty", "loaded")
    assert found.points.tolist() == [[0.0] * 3] * 2
    assert found.shapes[0].tolist() == [0.001]
    path.write_text(f"{HEADER}\n{ROW}\n")
    assert diagnosis.read_measurements(path, []).points.tolist() == [[0.6, 0.0, -0.245]]
    assert 'column "x" is missing' in refusal(tmp_path, "pose,frequency,sigma\nA,1,0.1\n")


@pytest.mark.parametrize("half", ["x", "y,z", "sigma_z", "x,y,sigma_x"])
def test_half_a_position_is_refused(tmp_path: Path, half: str) -> None:
    text = f"pose,frequency,sigma,{half}\nA,5,0.1{',0' * len(half.split(','))}\n"
    assert "give x, y and z, or no position column at all" in refusal(tmp_path, text, positions=False)
