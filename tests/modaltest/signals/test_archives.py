"""Files of several records: Shake&Tune's measurements, and tables in archives."""

from __future__ import annotations

import io
import json
import pickle
import sys
import tarfile
import zipfile
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import pytest

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.campaign.campaign import read_campaign
from pkmodes.modaltest.campaign.identify import identify
from pkmodes.modaltest.signals.functions import FunctionKind, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

#: A decay at 41.3 Hz in x and one at 63.7 Hz in y, noise in z [mm/s^2], as Klipper prints them: with six decimals.
RATE, FREQUENCIES = 1600.0, (41.3, 63.7)


def samples(seed: int, seconds: float = 12.0) -> np.ndarray:
    """Responses of two oscillators of 2 % damping to white noise, by recursion: times and three accelerations."""
    rng = np.random.default_rng(seed)
    time = 5.25 + np.arange(int(seconds * RATE)) / RATE
    found = [time]
    for frequency in FREQUENCIES:
        pole = np.exp((-0.02 + 1j * np.sqrt(1.0 - 0.02**2)) * 2 * np.pi * frequency / RATE)
        force, state, response = rng.normal(size=time.size), 0j, np.empty(time.size)
        for k in range(time.size):
            state = pole * state + force[k]
            response[k] = state.imag
        found.append(30.0 * response)
    return np.column_stack([*found, rng.normal(size=time.size)]).round(6)


def as_lines(measurements: dict[str, np.ndarray]) -> bytes:
    """What Shake&Tune writes: a line of JSON for each measurement."""
    each = ({"name": name, "samples": numbers.tolist()} for name, numbers in measurements.items())
    return "".join(json.dumps(one) + "\n" for one in each).encode()


def compressed(content: bytes, frames: int = 1) -> bytes:
    """Frames of Zstandard, written as a stream like Shake&Tune does, which leaves an empty one at the end."""
    zstandard = pytest.importorskip("zstandard")
    buffer, size = io.BytesIO(), len(content) // frames + 1
    with zstandard.ZstdCompressor(level=3).stream_writer(buffer, closefd=False) as writer:
        for k in range(frames):
            writer.write(content[k * size : (k + 1) * size])
            writer.flush(zstandard.FLUSH_FRAME)
    return buffer.getvalue()


def as_table(numbers: np.ndarray) -> bytes:
    rows = "".join(",".join(f"{x:.6f}" for x in row) + "\n" for row in numbers)
    return ("#time,accel_x,accel_y,accel_z\n" + rows).encode()


def archive(path: Path, files: dict[str, bytes]) -> None:
    if path.suffix == ".zip":
        with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED) as file:
            for name, content in files.items():
                file.writestr(name, content)
        return
    with tarfile.open(path, "w:gz" if path.name.endswith("gz") else "w") as file:
        for name, content in files.items():
            one = tarfile.TarInfo(name)
            one.size = len(content)
            file.addfile(one, io.BytesIO(content))


def refusal(path: Path) -> MeasurementError:
    with pytest.raises(MeasurementError) as error:
        read_signals(path)
    assert error.value.remedy
    return error.value


SHORT = samples(1, 0.5), samples(2, 0.5)


@pytest.mark.parametrize("frames", [1, 3])
def test_one_of_several_measurements_is_read(tmp_path: Path, frames: int) -> None:
    path = tmp_path / "belts.stdata"
    path.write_bytes(compressed(as_lines({"A_2025": SHORT[0], "B_2025": SHORT[1]}), frames))
    found = read_signals(path / "B_2025", SignalRequest(sensors=frozenset(["accel_y"])))
    (one,) = found.functions
    assert (one.kind, one.response, one.unit) == (FunctionKind.TIME, "accel_y", "mm/s^2")
    np.testing.assert_array_equal(one.values, SHORT[1][:, 2])
    np.testing.assert_allclose(np.diff(one.abscissa), 1.0 / RATE, rtol=1e-3)
    names = [one.response for one in read_signals(str(path / "A_2025")).functions]
    assert names == ["accel_x", "accel_y", "accel_z"]


def test_the_name_is_asked_for_only_where_there_are_several(tmp_path: Path) -> None:
    path = tmp_path / "axis_X.stdata"
    path.write_bytes(compressed(as_lines({"X_2025": SHORT[0]})))
    assert len(read_signals(path).functions) == 3
    path.write_bytes(compressed(as_lines({"A_2025": SHORT[0], "B_2025": SHORT[1]})))
    error = refusal(path)
    assert error.what == "expected one measurement, found 2"
    assert error.remedy.endswith('files = ["axis_X.stdata/A_2025"]: "A_2025", "B_2025"')
    assert 'did you mean "A_2025"' in refusal(path / "A_2024").remedy


@pytest.mark.skipif(find_spec("zstandard") is None, reason="needs zstandard")
def test_damaged_and_old_measurements_are_refused(subtests: pytest.Subtests, tmp_path: Path) -> None:
    path, whole = tmp_path / "x.stdata", as_lines({"X": SHORT[0]})
    for content, what in {
        compressed(whole)[:-40]: "expected a complete file",
        compressed(whole)[:4] + 99 * b"\xff": "cannot unpack the file",
        compressed(whole[:-30]): "expected a measurement of Shake&Tune",
        compressed(b'{"name": "X", "samples": [[1, 2, 3]]}\n'): "expected a measurement of Shake&Tune",
        compressed(b'{"name": "X", "samples": []}\n'): "expected at least 2 points, found none",
        compressed(as_lines({"X": SHORT[0][::-1]})): "expected ascending times",
        compressed(pickle.dumps([{"name": "X", "samples": [(0.0, 0.0, 0.0, 0.0)]}])): "found a Python pickle",
        compressed(b""): "expected one measurement, found none",
    }.items():
        with subtests.test(what=what):
            path.write_bytes(content)
            assert what in refusal(path).what


def test_zstandard_is_an_extra(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "zstandard", None)
    (tmp_path / "x.stdata").write_bytes(b"\x28\xb5\x2f\xfd rest")
    assert refusal(tmp_path / "x.stdata").remedy == "install it with pip install 'pkmodes[zstd]'"


@pytest.mark.parametrize("name", ["old.zip", "old.tar", "old.tar.gz", "old.tgz"])
def test_a_table_in_an_archive_is_read_as_the_table(tmp_path: Path, name: str) -> None:
    files = {f"results/{axis}.csv": as_table(numbers) for axis, numbers in zip("ab", SHORT, strict=True)}
    archive(tmp_path / name, {**files, "results/._a.csv": b"\0\5", "a.png": b"\x89PNG"})
    (tmp_path / "b.csv").write_bytes(files["results/b.csv"])
    alone = read_signals(tmp_path / "b.csv")
    found = read_signals(tmp_path / name / "results/b.csv")
    for one, other in zip(found.functions, alone.functions, strict=True):
        assert (one.response, one.unit) == (other.response, other.unit)
        np.testing.assert_array_equal(one.values, other.values)
    assert found.source.endswith(f"{name}/results/b.csv")
    error = refusal(tmp_path / name)
    assert error.what == "expected one table, found 2"
    assert '"results/a.csv", "results/b.csv"' in error.remedy


def test_other_archives_are_refused_by_name(subtests: pytest.Subtests, tmp_path: Path) -> None:
    archive(tmp_path / "pictures.zip", {"a.png": b"\x89PNG", "x.stdata": b""})
    archive(tmp_path / "book.zip", {"xl/a.csv": b"", "[Content_Types].xml": b""})
    archive(tmp_path / "bad.zip", {"a.csv": b"#time,x\n0,oops\n1,2\n"})
    (tmp_path / "cut.tar.gz").write_bytes(b"\x1f\x8b\x08\x00 rest")
    archive(tmp_path / "whole.tgz", {"a.csv": as_table(SHORT[0])})
    (tmp_path / "half.tgz").write_bytes((tmp_path / "whole.tgz").read_bytes()[:3000])
    (tmp_path / "a.csv").write_bytes(as_table(SHORT[0]))
    for name, what, remedy in [
        ("pictures.zip", 'expected an archive of tables, found "a.png", "x.stdata" in it', "unpack it"),
        ("book.zip", "found an Excel workbook", "save it as CSV UTF-8"),
        ("bad.zip", 'expected a finite number, found "oops"', "write a plain number"),
        ("cut.tar.gz", "cannot read the archive", "unpack it"),
        ("half.tgz", "cannot read the archive", "unpack it"),
        ("a.csv/b.csv", "expected an archive or a file of Shake&Tune", 'leave "b.csv" out'),
        ("none.zip/b.csv", "cannot read the signals: no such file", "check the path"),
    ]:
        with subtests.test(name=name):
            error = refusal(tmp_path / name)
            assert what in error.what
            assert remedy in error.remedy


def test_an_archive_that_unpacks_to_too_much_is_refused(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("pkmodes.modaltest.signals.archives.MAX_UNPACKED_SIZE", 10_000)
    for name in ("a.zip", "a.tgz"):
        archive(tmp_path / name, {"a.csv": as_table(SHORT[0])})
        assert "found more" in refusal(tmp_path / name).what
    archive(tmp_path / "two.tar", {"a.csv": as_table(SHORT[0][:150]), "b.csv": as_table(SHORT[0][:150])})
    assert (
        "found more" in refusal(tmp_path / "two.tar").what
    )  # all of it, since finding the next unpacks each
    (tmp_path / "x.stdata").write_bytes(compressed(as_lines({"X": SHORT[0]})))
    assert "found more" in refusal(tmp_path / "x.stdata").what


def test_a_campaign_names_measurements_of_one_file(tmp_path: Path) -> None:
    content = as_lines({"A": samples(3), "B": samples(4)})
    (tmp_path / "belts.stdata").write_bytes(compressed(content))
    (tmp_path / "c.toml").write_text(
        'format = 1\nchannels = ["x", "y"]\nband = ["20 Hz", "100 Hz"]\n'
        '[[sensor]]\nname = "accel_x"\nchannel = "x"\n[[sensor]]\nname = "accel_y"\nchannel = "y"\n'
        '[[record]]\npose = "P"\nkind = "ambient"\nfiles = ["belts.stdata/A", "belts.stdata/B"]\n'
    )
    (record,) = identify(read_campaign(tmp_path / "c.toml")).records
    found = [mode.frequency for mode in record.modes]
    np.testing.assert_allclose(found, FREQUENCIES, rtol=0.01)
