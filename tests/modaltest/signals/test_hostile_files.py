"""Files that are made to fill the memory, to hang or to read others: each is read or refused, in little memory."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from modaltest.signals import hostile
from modaltest.signals.hostile import CASES
from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.functions import SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

#: Bytes of a file, about; and kinds of files that are read in one go, since a process takes its time to begin.
SIZE, TOGETHER = 2_000_000, 3
GROUPS = [list(CASES)[i :: len(CASES) // TOGETHER] for i in range(len(CASES) // TOGETHER)]


@pytest.mark.skipif(not hostile.CAN_MEASURE, reason="needs the memory of a process as Linux tells it")
@pytest.mark.parametrize("kinds", GROUPS, ids=range(len(GROUPS)))
def test_reading_takes_four_times_the_file(
    subtests: pytest.Subtests, tmp_path: Path, kinds: list[str]
) -> None:
    pytest.importorskip("h5py")
    pytest.importorskip("zstandard")
    cases = {tmp_path / f"{i}{CASES[kind].suffix}": CASES[kind] for i, kind in enumerate(kinds)}
    for path, of in cases.items():
        of.write(path, SIZE)
    for kind, (path, of), taken in zip(kinds, cases.items(), hostile.taken(cases), strict=True):
        with subtests.test(kind):
            assert bool(taken.outcome) == bool(of.refused), taken.outcome
            assert of.refused in taken.outcome
            allowed = of.times * path.stat().st_size + of.constant
            if taken.memory >= allowed:  # the allocator and what else runs only add to what reading needs
                (taken,) = hostile.taken({path: of})
            assert taken.memory < allowed


def refusal(path: Path, *sensors: str) -> MeasurementError:
    with pytest.raises(MeasurementError) as error:
        read_signals(path, SignalRequest(sensors=frozenset(sensors)))
    assert str(path) in error.value.where
    assert error.value.remedy
    return error.value


def test_a_rate_that_is_no_number_is_refused_with_its_line(tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text("Sample,x\n0,1\n1,2\nRate 1.2.3, overflows 0\n")
    error = refusal(path, "x")
    assert error.where.endswith("table.csv: line 4")
    assert error.what == 'expected a sampling rate, found "1.2.3"'


@pytest.fixture
def linked(tmp_path: Path) -> Path:
    """A sound file of version 7.3 beside a secret and a pipe that nobody writes into."""
    pytest.importorskip("h5py")
    (tmp_path / "secret.bin").write_bytes(np.arange(1000.0).tobytes())
    os.mkfifo(tmp_path / "pipe")
    return tmp_path / "linked.mat"


def read_x(path: Path) -> list[str]:
    """Read the sound sensor of a file, and return what is said."""
    read = read_signals(path, SignalRequest(sensors=frozenset({"x"})))
    (found,) = read.functions
    np.testing.assert_array_equal(found.values, hostile.numbers(1000, 1)[:, 0])
    return [one.partition(": ")[2] for one in read.messages]


def test_links_in_a_circle_are_followed_once(linked: Path) -> None:
    def change(file: Any) -> None:
        inner = file.create_group("a")
        for i in range(300):
            inner[f"self_{i}"] = inner
            inner[f"root_{i}"] = file
        file["again"] = inner

    hostile.hdf5(linked, change)
    assert read_x(linked) == []


def test_what_is_in_another_file_is_not_read(linked: Path) -> None:
    import h5py

    other = linked.with_name("other.h5")
    with h5py.File(other, "w") as file:
        file["y"] = np.arange(1000.0)

    def change(file: Any) -> None:
        file["broken"] = h5py.SoftLink("/nothing/here")
        file["circle"] = h5py.SoftLink("/circle")
        file["there"] = h5py.SoftLink("/x")
        file["pipe"] = h5py.ExternalLink(str(linked.with_name("pipe")), "/")
        file["out"] = h5py.ExternalLink(str(other), "/y")
        file["through"] = h5py.SoftLink("/folder/y")
        file["folder"] = h5py.ExternalLink(str(other), "/")
        file.create_dataset(
            "secret", (1000,), "f8", external=[(str(linked.with_name("secret.bin")), 0, 8000)]
        )
        layout = h5py.VirtualLayout((1000,), "f8")
        layout[:] = h5py.VirtualSource(str(other), "y", (1000,))
        file.create_virtual_dataset("virtual", layout)
        file["kind"] = np.dtype("f8")

    hostile.hdf5(linked, change)
    said = " ".join(read_x(linked))
    assert "there" not in said
    for name in ("broken", "circle", "pipe", "out", "through", "folder"):
        assert f"{name}: skipped: a link that leads to nothing in the file holds no signals" in said
    for name in ("secret", "virtual"):
        assert f"{name}: skipped: an array whose values are in another file holds no signals" in said
        assert "found an array whose values are in another file" in refusal(linked, name).what
    assert "found a link that leads to nothing in the file" in refusal(linked, "pipe").what
    (there,) = read_signals(linked, SignalRequest(sensors=frozenset({"there"}))).functions
    np.testing.assert_array_equal(there.values, hostile.numbers(1000, 1)[:, 0])


def test_fields_of_a_compressed_struct_are_read_in_any_order(tmp_path: Path) -> None:
    """And what lies after the struct, or is missing from it, is damage."""
    path, a = tmp_path / "struct.mat", hostile.numbers(1000, 3)
    fields = {name: hostile.vector("", a[:, i]) for i, name in enumerate("xyz")}
    whole = hostile.struct_of("s", {**fields, "time": hostile.vector("", hostile.TIME)})
    hostile.mat(path, [whole])
    found = read_signals(path).functions
    assert [one.response for one in found] == ["x", "y", "z"]
    for i, one in enumerate(found):
        np.testing.assert_array_equal(one.values, a[:, i])
    for damaged, what in ((whole + bytes(16), "one whole variable"), (whole[:-100], "one whole variable")):
        hostile.mat(path, [damaged])
        assert what in refusal(path, "x").what


def test_whole_numbers_that_stay_in_their_file_are_the_same(tmp_path: Path) -> None:
    path = tmp_path / "integers.mat"
    hostile.integers(path, 6000)
    found = read_signals(path).functions
    a = np.random.default_rng(1).integers(-3000, 3000, (3, 1000))
    for i, one in enumerate(found):
        assert one.values.dtype == np.float64
        np.testing.assert_array_equal(one.values, a[i])
    path.write_bytes(path.read_bytes()[:200])
    with pytest.raises(MeasurementError, match="expected the file as it was"):
        _ = found[2].values


def test_names_in_an_archive_may_be_long(tmp_path: Path) -> None:
    import tarfile

    content = hostile.rows_of_text(3000).rpartition(b"\n")[0]
    (tmp_path / "a.csv").write_bytes(content)
    for form, archive_format in (("gnu", tarfile.GNU_FORMAT), ("pax", tarfile.PAX_FORMAT)):
        path, name = tmp_path / f"{form}.tar", "folder/" * 30 + "ä.csv"
        with tarfile.open(path, "w", format=archive_format) as archive:
            archive.add(tmp_path, name, filter=lambda one: one if one.isdir() else None)
            archive.add(tmp_path / "a.csv", name)
            archive.add(tmp_path / "a.csv", "b.csv")
        read = read_signals(path / name)
        assert [one.response for one in read.functions] == ["x", "y", "z"]
        assert "expected one table, found 2" in refusal(path).what
