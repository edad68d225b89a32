"""Arrays in files of other programs: names in capitals, names that the record gives, several measurements."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import Function, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

TIME = np.array([0.0, 0.25, 0.5, 0.75])
FORCE, X, Y = np.array([[0.0, 9.0, 1.0, 0.0], [1.0, -2.0, 3.0, 4.0], [5.0, 6.0, 7.0, -8.0]])
#: Times x sensors x measurements, and times x measurements.
RECORDS = np.arange(24.0).reshape(4, 2, 3) ** 2
BLOWS = 100.0 + np.arange(12.0).reshape(4, 3)


@pytest.fixture(params=["a.mat", "a.npz"])
def path(request: pytest.FixtureRequest, tmp_path: Path) -> Path:
    return tmp_path / str(request.param)


def written(path: Path, **content: object) -> Path:
    if path.suffix == ".mat":
        savemat(path, content)
    else:
        np.savez(path, **content)  # type: ignore[arg-type]
    return path


def by_name(found: SignalFile) -> dict[str, Function]:
    return {one.response: one for one in found.functions}


@pytest.mark.parametrize("time", ["TIME", "Time", "Time_domain"])
def test_names_in_capitals_or_not(path: Path, time: str) -> None:
    found = by_name(
        read_signals(
            written(path, **{time: TIME, "Force": FORCE, "X": X}), SignalRequest(sensors=frozenset("x"))
        )
    )
    assert found["x"].values.tolist() == X.tolist()
    assert found["x"].abscissa.tolist() == TIME.tolist()
    assert found["force"].force
    assert found["force"].values.tolist() == FORCE.tolist()


def test_frequencies_and_rates_in_capitals(path: Path) -> None:
    (found,) = read_signals(written(path, Freq=1.0 + TIME, H=X + 1j * Y)).functions
    assert (found.kind, found.abscissa.tolist()) == ("frf", (1.0 + TIME).tolist())
    (found,) = read_signals(written(path, FS=4.0, x=X)).functions
    assert found.abscissa.tolist() == TIME.tolist()


def test_single_capitals_are_no_abscissas(path: Path) -> None:
    """T and F are temperatures and forces rather than times and frequencies."""
    found = by_name(read_signals(written(path, fs=4.0, T=X, F=FORCE)))
    assert sorted(found) == ["F", "T"]


def test_a_sensor_of_the_same_name_is_no_force(path: Path) -> None:
    (found,) = read_signals(
        written(path, time=TIME, Force=X), SignalRequest(sensors=frozenset({"Force"}))
    ).functions
    assert (found.response, found.force) == ("Force", False)


def test_the_record_may_say_what_variables_are_called(path: Path) -> None:
    names = {"time": "elapsed", "force": "Hammer", "acc": "ch2"}
    written(path, elapsed=TIME, hammer=FORCE, ch2=Y, t=X, acc=X, force=X)
    found = by_name(read_signals(path, SignalRequest(sensors=frozenset({"acc"}), names=names)))
    assert sorted(found) == ["acc", "force"]
    assert found["acc"].abscissa.tolist() == TIME.tolist()
    assert found["acc"].values.tolist() == Y.tolist()
    assert found["force"].values.tolist() == FORCE.tolist()
    assert found["force"].force


def test_a_column_of_a_matrix_may_be_the_force(path: Path) -> None:
    written(path, fs=4.0, data=np.column_stack([FORCE, X, Y]))
    asked = SignalRequest(sensors=frozenset({"data_2"}), names={"force": "data_1"})
    found = by_name(read_signals(path, asked))
    assert found["force"].values.tolist() == FORCE.tolist()
    assert found["data_2"].values.tolist() == X.tolist()


def test_frequencies_that_the_record_names_prevail_over_times(path: Path) -> None:
    written(path, time=TIME, lines=1.0 + TIME, H=X + 1j * Y)
    (found,) = read_signals(
        path, SignalRequest(names={"frequency": "lines"}, sensors=frozenset("H"))
    ).functions
    assert (found.kind, found.abscissa.tolist()) == ("frf", (1.0 + TIME).tolist())


def test_names_that_are_not_there_are_errors_with_those_found(path: Path) -> None:
    written(path, time=TIME, hammer=FORCE, x=X)
    with pytest.raises(
        MeasurementError, match='expected "Force", which the record names as its force, found "hammer"'
    ):
        read_signals(path, SignalRequest(names={"force": "Force"}))
    with pytest.raises(MeasurementError, match='expected "clock", which the record names as its time'):
        read_signals(path, SignalRequest(names={"time": "clock"}))
    with pytest.raises(MeasurementError) as error:
        read_signals(written(path, clock=TIME, x=X))
    assert "found clock, x" in error.value.what
    assert 'names = { time = "NAME" }' in error.value.remedy


def test_one_of_several_measurements(path: Path) -> None:
    written(path, records=RECORDS, Force=BLOWS, time=TIME)
    found = by_name(read_signals(path / "2"))
    assert sorted(found) == ["force", "records_1", "records_2"]
    assert found["records_1"].values.tolist() == RECORDS[:, 0, 1].tolist()
    assert found["records_2"].values.tolist() == RECORDS[:, 1, 1].tolist()
    assert found["force"].force
    assert found["force"].values.tolist() == BLOWS[:, 1].tolist()
    of_columns = SignalRequest(names={"force": "records_1"}, sensors=frozenset({"records_2"}))
    found = by_name(read_signals(written(path, records=RECORDS, fs=4.0) / "3", of_columns))
    assert found["force"].values.tolist() == RECORDS[:, 0, 2].tolist()
    assert found["records_2"].values.tolist() == RECORDS[:, 1, 2].tolist()
    assert found["records_2"].abscissa.tolist() == TIME.tolist()


def test_measurements_of_a_single_sensor_and_more_of_them_than_samples(path: Path) -> None:
    many = np.arange(4.0 * 9).reshape(4, 1, 9)
    (found,) = read_signals(written(path, records=many, fs=4.0) / "9").functions
    assert found.response == "records_1"
    assert found.values.tolist() == many[:, 0, 8].tolist()


def test_the_measurement_has_to_be_named(path: Path) -> None:
    written(path, records=RECORDS, fs=4.0)
    with pytest.raises(MeasurementError, match="expected one measurement, found 3") as error:
        read_signals(path)
    assert f'files = ["{path.name}/1", "{path.name}/2"]' in error.value.remedy
    assert (
        read_signals(path / "1", SignalRequest(sensors=frozenset({"x"}))).functions == ()
    )  # the campaign says what is there
    with pytest.raises(MeasurementError, match='expected a measurement from 1 to 3, found "4"'):
        read_signals(path / "4")
    with pytest.raises(
        MeasurementError, match="expected an array of times, sensors and measurements, found none"
    ):
        read_signals(written(path, x=X, fs=4.0) / "1")


def test_times_that_count_samples_are_none_beside_a_rate(path: Path) -> None:
    found = read_signals(written(path, t=np.arange(4.0), fs=4.0, x=X))
    assert by_name(found)["x"].abscissa.tolist() == TIME.tolist()
    assert "t counts samples: the rate of 4 Hz" in found.messages[-1]
    assert by_name(read_signals(written(path, t=np.arange(4.0), x=X)))["x"].abscissa.tolist() == [
        0.0,
        1.0,
        2.0,
        3.0,
    ]


def test_fields_of_structured_arrays(tmp_path: Path) -> None:
    table = np.rec.fromarrays([TIME, X], names="time,acc")
    whole = np.zeros((), dtype=[("fs", "f8"), ("bed", [("data", "f8", (4, 2)), ("note", "U3")])])
    whole["fs"], whole["bed"]["data"] = 4.0, np.column_stack([X, Y])
    for content, names in ((table, ["acc"]), (whole, ["data_1", "data_2"])):
        np.savez_compressed(tmp_path / "a.npz", run=content)
        np.save(tmp_path / "a.npy", content)
        for name in ("a.npz", "a.npy"):
            found = by_name(read_signals(tmp_path / name))
            assert sorted(found) == names
            assert found[names[0]].values.tolist() == X.tolist()
            assert found[names[0]].abscissa.tolist() == TIME.tolist()
