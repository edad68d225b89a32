"""Layouts of arrays in MATLAB and NumPy files: matrices, structs, rates and other names of abscissas."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest
from scipy.io import savemat

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

TIME = np.array([0.0, 0.25, 0.5, 0.75])
#: Samples x sensors.
SIGNALS = np.array([[1.0, 10.0, -1.0], [2.0, 20.0, -2.0], [3.0, 30.0, -3.0], [4.0, 40.0, -4.0]])
FRF = SIGNALS + 1j * SIGNALS[::-1]


def hdf5(path: Path, content: dict[str, object]) -> None:
    """Write a file as MATLAB does with -v7.3: rows and columns exchanged, structs as groups, complex as pairs."""
    h5py = pytest.importorskip("h5py")

    def write(group: object, values: dict[str, object]) -> None:
        for name, value in values.items():
            if isinstance(value, dict):
                write(group.create_group(name), value)  # type: ignore[attr-defined]
                continue
            array = np.atleast_2d(np.asarray(value))
            if np.iscomplexobj(array):
                pairs = np.empty(array.shape, [("real", "f8"), ("imag", "f8")])
                pairs["real"], pairs["imag"] = array.real, array.imag
                array = pairs
            group[name] = array.T  # type: ignore[index]

    with h5py.File(path, "w", userblock_size=512) as file:
        write(file, content)
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file, Platform: GLNXA64")


WRITERS: dict[str, Callable[[Path, dict[str, object]], None]] = {
    "5.mat": savemat,
    "4.mat": lambda path, content: savemat(path, content, format="4"),
    "packed.mat": lambda path, content: savemat(path, content, do_compression=True),
    "7.3.mat": hdf5,
    "x.npz": lambda path, content: np.savez(path, **content),  # type: ignore[arg-type]
}


@pytest.fixture(params=WRITERS)
def read(request: pytest.FixtureRequest, tmp_path: Path) -> Callable[..., SignalFile]:
    def reader(asked: SignalRequest | None = None, **content: object) -> SignalFile:
        path = tmp_path / request.param
        WRITERS[request.param](path, content)
        return read_signals(path, asked or SignalRequest())

    return reader


def values(found: SignalFile) -> dict[str, list[object]]:
    return {f"{one.response}/{one.reference}": one.values.tolist() for one in found.functions}


COLUMNS = {f"data_{i + 1}/": SIGNALS[:, i].tolist() for i in range(3)}


@pytest.mark.parametrize("turned", [False, True])
def test_columns_of_a_matrix_are_signals_whichever_way_it_lies(
    read: Callable[..., SignalFile], turned: bool
) -> None:
    found = read(t=TIME, data=SIGNALS.T if turned else SIGNALS)
    assert values(found) == COLUMNS
    assert found.functions[0].abscissa.tolist() == TIME.tolist()
    only = read(SignalRequest(sensors=frozenset({"data_2"})), t=TIME, data=SIGNALS)
    assert values(only) == {"data_2/": SIGNALS[:, 1].tolist()}


@pytest.mark.parametrize("name", ["fs", "Fs"])
def test_a_sampling_rate_stands_in_for_times(read: Callable[..., SignalFile], name: str) -> None:
    found = read(data=SIGNALS, **{name: 4.0})
    assert values(found) == COLUMNS
    assert found.functions[0].abscissa.tolist() == TIME.tolist()
    with pytest.raises(MeasurementError, match="the campaign says a rate of 5 Hz, and the file 4 Hz"):
        read(SignalRequest(rate=5.0), data=SIGNALS, **{name: 4.0})


@pytest.mark.parametrize("name", ["f", "freq", "frequencyBand"])
def test_matrices_of_frequency_responses(read: Callable[..., SignalFile], name: str) -> None:
    found = read(H=FRF, **{name: TIME})
    assert values(found) == {f"H_{i + 1}/": FRF[:, i].tolist() for i in range(3)}
    assert {one.kind for one in found.functions} == {"frf"}


def test_frequency_responses_of_several_references(tmp_path: Path) -> None:
    cube = np.stack([FRF, 2.0 * FRF], axis=2)
    for name in ("5.mat", "x.npz"):
        WRITERS[name](tmp_path / name, {"H": cube, "frequency": TIME})
        found = values(read_signals(tmp_path / name))
        assert found == {f"H_{i + 1}/{r + 1}": cube[:, i, r].tolist() for i in range(3) for r in range(2)}


@pytest.mark.parametrize("name", ["5.mat", "packed.mat", "7.3.mat"])
def test_fields_of_structs_are_variables(tmp_path: Path, name: str) -> None:
    of_struct = {"time": TIME, "acc": SIGNALS[:, 0], "more": {"acc_2": SIGNALS[:, 1]}}
    WRITERS[name](tmp_path / name, {"test": of_struct})
    found = read_signals(tmp_path / name)
    assert values(found) == {"acc/": SIGNALS[:, 0].tolist(), "acc_2/": SIGNALS[:, 1].tolist()}
    two = {"a": {"x": SIGNALS[:, 0]}, "b": {"x": SIGNALS[:, 1]}, "fs": 4.0}
    WRITERS[name](tmp_path / name, two)
    assert values(read_signals(tmp_path / name)) == {
        "a.x/": SIGNALS[:, 0].tolist(),
        "b.x/": SIGNALS[:, 1].tolist(),
    }


def test_a_single_array_of_numpy_is_called_data(tmp_path: Path) -> None:
    path = tmp_path / "x.npy"
    np.save(path, SIGNALS)
    assert values(read_signals(path, SignalRequest(rate=4.0))) == COLUMNS
    with pytest.raises(MeasurementError, match="expected times, frequencies or a sampling rate, found data"):
        read_signals(path)
    np.save(path, np.rec.fromarrays([TIME, SIGNALS[:, 0]], names="time,acc"))
    assert values(read_signals(path)) == {"acc/": SIGNALS[:, 0].tolist()}


def test_damaged_files_and_objects_are_refused(tmp_path: Path) -> None:
    np.savez(tmp_path / "x.npz", time=TIME, acc=SIGNALS[:, 0])
    np.save(tmp_path / "x.npy", np.array([TIME, "text"], object), allow_pickle=True)
    whole = (tmp_path / "x.npz").read_bytes()
    for name, content in (("x.npz", whole[:-40]), ("x.npz", whole[:60]), ("x.npy", None)):
        if content is not None:
            (tmp_path / name).write_bytes(content)
        with pytest.raises(MeasurementError, match="cannot read the NumPy file"):
            read_signals(tmp_path / name)


def test_a_damaged_file_of_version_7_3_is_refused(tmp_path: Path) -> None:
    path = tmp_path / "x.mat"
    hdf5(path, {"time": TIME, "acc": SIGNALS[:, 0]})
    whole = path.read_bytes()
    for damaged in (whole[:700], whole.replace(b"SNOD", b"SNOX"), whole.replace(b"HEAP", b"HEAX")):
        assert damaged != whole
        path.write_bytes(damaged)
        with pytest.raises(MeasurementError, match="cannot read the MATLAB file"):
            read_signals(path)


def test_the_columns_of_a_matrix_that_is_taken_for_a_sensor_are_named(
    read: Callable[..., SignalFile],
) -> None:
    with pytest.raises(MeasurementError, match="expected a vector of numbers") as error:
        read(SignalRequest(sensors=frozenset({"data"})), fs=4.0, data=SIGNALS)
    assert error.value.remedy == "name its columns: data_1, data_2, data_3"
