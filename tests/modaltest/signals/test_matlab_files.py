"""MATLAB files: what is read, what is skipped, and what is refused."""

from __future__ import annotations

import sys
import tracemalloc
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals import arrays
from pkmodes.modaltest.signals.functions import FunctionKind, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

TIME = np.array([0.0, 0.5, 1.0])
RESPONSE = np.array([1 + 2j, 3 - 4j, 5j])


def read(
    folder: Path,
    asked: SignalRequest = SignalRequest(),  # noqa: B008
    form: str = "5",
    **content: object,
) -> SignalFile:
    path = folder / "signals.mat"
    savemat(path, content, format=form)
    return read_signals(path, asked)


@pytest.mark.parametrize("form", ["4", "5"])
@pytest.mark.parametrize("shape", [(-1, 1), (1, -1)])
def test_signals_in_time(tmp_path: Path, form: str, shape: tuple[int, int]) -> None:
    content = {"time": TIME.reshape(shape), "force": np.array([0, 9, 0]), "acc_1": TIME.reshape(shape) ** 2}
    found = {one.response: one for one in read(tmp_path, form=form, **content).functions}
    assert set(found) == {"force", "acc_1"}
    assert found["acc_1"].values.tolist() == [0.0, 0.25, 1.0]
    assert (found["force"].force, found["force"].values.dtype) == (True, np.float64)
    assert found["acc_1"].abscissa.tolist() == TIME.tolist()
    assert (found["acc_1"].kind, found["acc_1"].unit) == (FunctionKind.TIME, None)


def test_frequency_responses_and_spectra(tmp_path: Path) -> None:
    found = read(tmp_path, frequency=TIME, acc_1=RESPONSE, acc_2__hammer_1=RESPONSE, psd=TIME).functions
    assert [(one.kind, one.response, one.reference) for one in found] == [
        (FunctionKind.FRF, "acc_1", ""),
        (FunctionKind.FRF, "acc_2", "hammer_1"),
        (FunctionKind.SPECTRUM, "psd", ""),
    ]
    assert found[1].values.tolist() == RESPONSE.tolist()


def test_names_with_two_underscores_are_whole_in_time(tmp_path: Path) -> None:
    (found,) = read(tmp_path, time=TIME, acc__1=TIME).functions
    assert (found.response, found.reference) == ("acc__1", "")


def test_other_variables_are_skipped_and_said(tmp_path: Path) -> None:
    others = {"note": "text", "setup": {"of": "text"}, "fs": 3200.0, "table": np.ones((4, 2))}
    found = read(tmp_path, time=TIME, acc_1=TIME, **others)
    assert [one.response for one in found.functions] == ["acc_1"]
    names = ["note", "of", "fs", "table"]
    assert [name for name in names if any(f": {name}: skipped" in one for one in found.messages)] == names


def test_a_rate_stands_in_for_times(tmp_path: Path) -> None:
    (found,) = read(tmp_path, SignalRequest(rate=2.0), acc_1=np.array([1.0, 2.0, 3.0])).functions
    assert found.abscissa.tolist() == [0.0, 0.5, 1.0]
    asked = SignalRequest(rate=2.0, sensors=frozenset({"acc_1"}))
    (found,) = read(tmp_path, asked, a_calibration=TIME[:2], acc_1=TIME).functions
    assert found.abscissa.tolist() == [0.0, 0.5, 1.0]


def test_only_wanted_sensors_are_kept(tmp_path: Path) -> None:
    asked = SignalRequest(sensors=frozenset({"acc_2"}))
    found = read(tmp_path, asked, time=TIME, acc_1=TIME[:2], acc_2=TIME, force=TIME)
    assert {one.response for one in found.functions} == {"acc_2", "force"}


FAULTS = {
    "no abscissa": ({"acc_1": TIME}, "time or frequency"),
    "two abscissas": ({"time": TIME, "frequency": TIME}, "both"),
    "another length": ({"time": TIME, "acc_1": TIME[:2]}, "found 2"),
    "not a number": ({"time": TIME, "acc_1": np.array([1.0, np.nan, 1.0])}, "value 2"),
    "complex in time": ({"time": TIME, "acc_1": RESPONSE}, "complex"),
    "falling times": ({"time": TIME[::-1], "acc_1": TIME}, "ascending"),
    "one line": ({"frequency": TIME[:1], "acc_1": RESPONSE[:1]}, "time or frequency"),
}


@pytest.mark.parametrize("fault", FAULTS)
def test_faults_are_refused(tmp_path: Path, fault: str) -> None:
    content, what = FAULTS[fault]
    with pytest.raises(MeasurementError, match=what) as caught:
        read(tmp_path, **content)
    assert "signals.mat" in caught.value.where


def test_gaps_of_frequency_responses_outside_the_band_are_no_damage(tmp_path: Path) -> None:
    response = np.array([complex(np.nan, 0.0), 3 - 4j, 5j])
    (found,) = read(tmp_path, SignalRequest(band=(0.5, 1.0)), frequency=TIME, acc_1=response).functions
    assert np.isnan(found.values).tolist() == [True, False, False]
    with pytest.raises(MeasurementError, match="as value 1"):
        read(tmp_path, SignalRequest(band=(0.0, 1.0)), frequency=TIME, acc_1=response)


def test_a_matrix_for_a_wanted_sensor_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match="vector") as caught:
        read(tmp_path, SignalRequest(sensors=frozenset({"acc_1"})), time=TIME, acc_1=np.ones((3, 2)))
    assert "acc_1" in caught.value.where


def test_version_7_3_needs_h5py(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "h5py", None)
    path = tmp_path / "new.mat"
    path.write_bytes(b"MATLAB 7.3 MAT-file, Platform: GLNXA64".ljust(512) + b"\x89HDF\r\n\x1a\n" + bytes(100))
    with pytest.raises(MeasurementError, match="save -v7"):
        read_signals(path)


def test_a_file_cut_anywhere_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "cut.mat"
    savemat(path, {"time": TIME, "acc_1": TIME, "force": TIME})
    whole = path.read_bytes()
    complete = 0
    for size in range(len(whole)):
        path.write_bytes(whole[:size])
        try:
            found = read_signals(path)
        except MeasurementError:
            continue
        complete += 1
        # a cut exactly between two variables leaves a whole file of fewer
        assert len(found.functions) in (0, 1)
    assert complete <= 2


def test_compressed_files_and_all_types_of_numbers(tmp_path: Path) -> None:
    path = tmp_path / "types.mat"
    kinds = ["f8", "f4", "i1", "u1", "i2", "u2", "i4", "u4", "i8", "u8", "?", ">f8"]
    content = {f"v_{number}": np.array([[0, 1, 1]]).astype(kind) for number, kind in enumerate(kinds)}
    savemat(path, {"time": TIME, **content, "empty": np.zeros((0, 0))}, do_compression=True)
    found = read_signals(path).functions
    assert [one.values.tolist() for one in found] == [[0.0, 1.0, 1.0]] * len(kinds)


def test_a_changed_byte_is_refused_or_changes_only_values(tmp_path: Path) -> None:
    """SciPy's reader crashes the interpreter on some of these."""
    path = tmp_path / "changed.mat"
    savemat(path, {"time": TIME, "acc_1": RESPONSE.real, "setup": {"rate": 1.0}, "note": "text"})
    whole = path.read_bytes()
    for place in range(124, len(whole)):
        for byte in (0, 1, 255, whole[place] ^ 8):
            path.write_bytes(whole[:place] + bytes([byte]) + whole[place + 1 :])
            try:
                found = read_signals(path)
            except MeasurementError:
                continue
            assert all(one.values.shape == (3,) for one in found.functions)


def test_a_vector_that_is_shorter_than_its_dimensions_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "short.mat"
    savemat(path, {"time": TIME, "acc_1": TIME})
    dimensions = np.array([1, 3], "<i4").tobytes()
    whole = path.read_bytes()
    assert whole.count(dimensions) == 2
    path.write_bytes(whole.replace(dimensions, np.array([1, 4], "<i4").tobytes()))
    with pytest.raises(MeasurementError, match="expected 4 values of time"):
        read_signals(path)
    path.write_bytes(whole[:-8])
    with pytest.raises(MeasurementError, match="bytes of an element"):
        read_signals(path)


@pytest.fixture
def of_zeros(tmp_path: Path) -> Path:
    """A small file with a vector of 32 MB."""
    path = tmp_path / "zeros.mat"
    savemat(path, {"time": TIME, "acc_1": TIME, "other": np.zeros(4_000_000)}, do_compression=True)
    assert path.stat().st_size < 100_000
    return path


def peak_of(path: Path, *sensors: str) -> tuple[SignalFile | str, int]:
    """Return what is read, or why not, and the bytes that this takes at most."""
    tracemalloc.start()
    try:
        return read_signals(path, SignalRequest(sensors=frozenset(sensors))), tracemalloc.get_traced_memory()[
            1
        ]
    except MeasurementError as error:
        return str(error), tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()


def test_what_no_sensor_names_is_not_unpacked(of_zeros: Path) -> None:
    found, peak = peak_of(of_zeros, "acc_1")
    assert not isinstance(found, str), found
    assert [one.response for one in found.functions] == ["acc_1"]
    assert peak < 2_000_000


def test_more_values_than_fit_into_memory_are_refused_before_they_are_unpacked(
    of_zeros: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(arrays, "MAX_VALUES", 4_000_000)
    said, peak = peak_of(of_zeros, "acc_1", "other")
    assert "they have 4,000,006 values, more than 4,000,000" in str(said)
    assert peak < 2_000_000
    monkeypatch.undo()
    said, peak = peak_of(of_zeros, "other")
    assert "expected 3 values, one for each time or frequency, found 4000000" in str(said)
    assert 32_000_000 < peak < 80_000_000


@pytest.mark.parametrize("name", ["large.mat", "large.csv"])
def test_a_file_with_gigabytes_of_nothing_is_refused_at_its_beginning(tmp_path: Path, name: str) -> None:
    path = tmp_path / name
    savemat(path, {"time": TIME}, appendmat=False)
    header = path.read_bytes()[:128]
    with path.open("wb") as file:
        file.write(header if name == "large.mat" else b"")
        file.truncate(3_000_000_000 if name == "large.mat" else 900_000_000)  # takes no room on the disk
    said, peak = peak_of(path, "acc_1")
    assert "found an element of type 0" in str(said) or "found binary data" in str(said)
    assert peak < 2_000_000


def test_what_a_file_has_instead_is_named(tmp_path: Path) -> None:
    with pytest.raises(MeasurementError, match=r"found x, data \(a cell array\)"):
        read(tmp_path, x=TIME, data=np.array(["a", 1.0], object))
