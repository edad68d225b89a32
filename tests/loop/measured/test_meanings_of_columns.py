"""Unknown columns of a table of modes: all in one error, with what they are likely to mean."""

from __future__ import annotations

from pathlib import Path

import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.loop.measured.meanings import likely_meaning
from pkmodes.loop.measured.reading import read_measurements

CHANNELS = {"p_x": "m", "p_z": "m", "r_x": "rad", "u_x": "m", "x_1": "m", "theta_1_1": "rad"}
KNOWN = ["pose", "x", "z", "frequency", "sigma", "damping", "sigma_damping", "mode", "sigma_shape"]
KNOWN += [f"shape:{name}" for name in CHANNELS]


@pytest.mark.parametrize(
    ("cell", "meaning"),
    [
        ("Frequency in Hz", "frequency [Hz]"),
        ("Natural frequency [rad/s]", "frequency [rad/s]"),
        ("Frequenz (Hz)", "frequency [Hz]"),
        ("f0", "frequency"),
        ("Standard deviation in Hz", "sigma [Hz]"),
        ("Damping ratio in %", "damping [%]"),
        ("zeta", "damping"),
        ("Shape x", "shape:p_x"),
        ("Mode shape X", "shape:p_x"),
        ("shape_x_1", "shape:x_1"),
        ("Shape rx", "shape:r_x"),
        ("Shape theta 1 1", "shape:theta_1_1"),
        ("Position z (mm)", "z [mm]"),
        ("Mode no", "mode"),
        ("Temperature", ""),
    ],
)
def test_a_column_is_likely_to_mean(cell: str, meaning: str) -> None:
    assert likely_meaning(cell, KNOWN) == meaning


def refusal(folder: Path, header: str) -> MeasurementError:
    path = folder / "modes.csv"
    path.write_text(f"{header}\n{','.join('1' for _ in header.split(','))}\n", encoding="utf-8")
    with pytest.raises(MeasurementError) as error:
        read_measurements(path, CHANNELS, positions=False)
    return error.value


def test_all_unknown_columns_are_in_one_error_the_likely_ones_first(tmp_path: Path) -> None:
    error = refusal(tmp_path, "pose,Ambient temperature,Frequency in Hz,Sigma,Shape x,Operator's name")
    assert error.what == (
        'unknown columns "Frequency in Hz", "Shape x", "Ambient temperature", "Operator\'s name"'
    )
    assert error.where.endswith("modes.csv: line 1, columns 2, 3, 5 and 6")
    assert error.remedy == (
        'likely meanings: "Frequency in Hz" -> "frequency [Hz]", "Shape x" -> "shape:p_x"; '
        "rename these, and remove the others"
    )


def test_a_column_that_is_there_is_not_suggested_again(tmp_path: Path) -> None:
    assert "frequency" not in refusal(tmp_path, "pose,frequency,sigma,Frequency in Hz,Shape x").remedy
    twice = refusal(tmp_path, "pose,Frequency in Hz,Eigenfrequency,sigma").remedy
    assert twice.count("frequency [Hz]") == 1


def test_a_single_one_has_its_unit_too(tmp_path: Path) -> None:
    error = refusal(tmp_path, "pose,frequency,sigma,Damping ratio in %")
    assert error.what == 'unknown column "Damping ratio in %"'
    assert error.remedy.endswith('did you mean "damping"? With its unit: "damping [%]"')
