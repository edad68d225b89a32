"""A killed or interrupted map continues where it stopped, and its result is that of an uninterrupted one."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
from pathlib import Path

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.map_runs import (
    GRID,
    ROWS,
    TASKS,
    count_tasks,
    done_in,
    folder_of,
    model,
    started,
)
from pkmodes.core.base.errors import OutputError
from pkmodes.maps import mapping
from pkmodes.maps.locking import locked

pytestmark = pytest.mark.skipif(os.name != "posix", reason="sends POSIX signals")


def stopped(out: Path, how: signal.Signals, after: int, *options: str) -> tuple[int, str]:
    """Stop a map after some tasks; return its exit code and what it wrote to stderr."""
    process = started(out, after, *options)
    process.send_signal(how)
    _, err = process.communicate(timeout=600)
    assert not out.exists()
    return process.returncode, err


@pytest.mark.parametrize("after", [1, 8, 15])
@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_the_same_call_computes_only_what_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: signal.Signals, after: int
) -> None:
    out = tmp_path / "map.nc"
    code, err = stopped(out, how, after)
    if how == signal.SIGINT:
        assert code == 130
        assert err == "error: interrupted (pkmodes); the same command continues where it stopped\n"
    done = done_in(out)
    assert done == after < TASKS
    whole = model().map(GRID)
    seen = count_tasks(monkeypatch)
    with model().map(GRID, out=out) as found:
        assert len(seen) == TASKS - done
        xarray.testing.assert_allclose(found.load(), whole, rtol=1e-12)
    assert not folder_of(out).exists()


def test_what_was_computed_before_is_the_same_to_the_last_digit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "map.zarr"
    stopped(out, signal.SIGKILL, 6, "--tracked")
    seen = count_tasks(monkeypatch)
    whole = model().map(GRID, tracked=True)
    assert len(seen) == TASKS
    with model().map(GRID, out=out, tracked=True) as found:
        xarray.testing.assert_identical(found.load(), whole)


@pytest.fixture(scope="module")
def killed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("killed") / "map.nc"
    stopped(out, signal.SIGKILL, 3)
    return out


@pytest.fixture
def interrupted(killed: Path, tmp_path: Path) -> Path:
    """A copy of an interrupted map."""
    shutil.copytree(folder_of(killed), folder_of(tmp_path / "map.nc"))
    return tmp_path / "map.nc"


def test_another_map_is_refused_with_what_differs(interrupted: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    count_tasks(monkeypatch)
    robot = model()
    other_grid = {**GRID, "z": -0.25}

    def said(found: pkmodes.Model = robot, **options: object) -> str:
        with pytest.raises(OutputError) as error:
            found.map(**{"grid": GRID, "out": interrupted, **options})  # type: ignore[arg-type]
        assert "delete this folder to start again" in error.value.remedy
        return error.value.what

    prefix = "this folder holds an interrupted map that differs in: "
    assert said(grid=other_grid) == prefix + "grid"
    assert said(grid=[[0.6, 0.0, -0.245]]) == prefix + "grid, poses"
    assert said(shapes=True) == prefix + "shapes"
    assert said(tracked=True) == prefix + "shapes"
    assert said(sweep={"platform.mass": [1.0]}) == prefix + "sweep"
    assert said(backend="numpy") == prefix + "back end"
    assert said(robot.with_values({"platform.mass": 2.0})) == prefix + "robot"
    assert said(pkmodes.Model(robot.robot, 1e3)) == prefix + "largest condition number"
    monkeypatch.setattr(mapping, "VERSION", "9.9")
    assert said() == prefix + "version"
    assert done_in(interrupted) >= 3, "nothing is lost by a refusal"


def test_the_order_of_swept_parameters_matters(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Rows of the map are in that order, so that the two must not be mixed."""
    out = tmp_path / "map.nc"
    options = ["--set", "platform.mass=1:2:2", "--set", "link.mass=0.6:0.7:2"]
    stopped(out, signal.SIGKILL, 2, *options)
    count_tasks(monkeypatch)
    with pytest.raises(OutputError, match="differs in: sweep"):
        model().map(GRID, sweep={"link.mass": [0.6, 0.7], "platform.mass": [1.0, 2.0]}, out=out)


@pytest.mark.parametrize("name", ["frequency.npy", "done.npy", "code.npy"])
@pytest.mark.parametrize("damage", ["truncated", "empty", "missing", "other"])
def test_damaged_arrays_are_refused(
    interrupted: Path, monkeypatch: pytest.MonkeyPatch, name: str, damage: str
) -> None:
    count_tasks(monkeypatch)
    file = folder_of(interrupted) / name
    content = file.read_bytes()
    if damage == "truncated":
        file.write_bytes(content[:-5])
    elif damage == "empty":
        file.write_bytes(b"")
    elif damage == "missing":
        file.unlink()
    else:
        np.save(file, np.zeros(3))
    with pytest.raises(OutputError, match=f"the file {name} of the interrupted map is ") as error:
        model().map(GRID, out=interrupted)
    assert error.value.where == str(folder_of(interrupted))
    assert not interrupted.exists()


@pytest.mark.parametrize("name", ["frequency.npy", "done.npy", "checks.npy"])
def test_a_damaged_header_is_refused(interrupted: Path, monkeypatch: pytest.MonkeyPatch, name: str) -> None:
    """Whichever of its bytes; NumPy would evaluate it as Python."""
    count_tasks(monkeypatch)
    file = folder_of(interrupted) / name
    content = file.read_bytes()
    for place in range(content.index(b"\n") + 1):
        file.write_bytes(content[:place] + bytes([content[place] ^ 0x10]) + content[place + 1 :])
        with pytest.raises(OutputError, match=f"the file {name} of the interrupted map is damaged"):
            model().map(GRID, out=interrupted)
    assert not interrupted.exists()


@pytest.mark.parametrize("name", ["frequency.npy", "code.npy", "checks.npy", "done.npy"])
@pytest.mark.parametrize("bit", [0, 6])
def test_rows_that_were_damaged_are_computed_again(
    interrupted: Path, monkeypatch: pytest.MonkeyPatch, name: str, bit: int
) -> None:
    """One flipped bit in the rows of the second of three tasks that were done, or in what is recorded of it."""
    file = folder_of(interrupted) / name
    stored = np.load(file)
    rows = TASKS if name in ("checks.npy", "done.npy") else len(GRID["x"]) * len(GRID["y"])
    content = bytearray(file.read_bytes())
    place = len(content) - stored.nbytes + (stored.nbytes // rows) * (1 if rows == TASKS else ROWS + 3)
    content[place] ^= 1 << bit
    file.write_bytes(content)
    done = 3
    whole = model().map(GRID)
    seen = count_tasks(monkeypatch)
    with model().map(GRID, out=interrupted) as found:
        xarray.testing.assert_allclose(found.load(), whole, rtol=1e-12)
    assert len(seen) == TASKS - done + 1


@pytest.mark.parametrize("text", ["", "{", "[]", '{"version": 1}', "null", "[" * 100_000])
def test_a_damaged_plan_is_refused(interrupted: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    count_tasks(monkeypatch)
    plan = folder_of(interrupted) / "plan.json"
    assert json.loads(plan.read_text())["version"] == pkmodes.__version__
    plan.write_text(text)
    with pytest.raises(OutputError, match=r"damaged|differs in"):
        model().map(GRID, out=interrupted)


def test_a_folder_in_which_nothing_was_begun_is_removed(tmp_path: Path) -> None:
    empty, begun = tmp_path / "empty", tmp_path / "begun"
    with pytest.raises(ZeroDivisionError), locked(empty):
        raise ZeroDivisionError
    with locked(begun):
        (begun / "plan.json").touch()
    assert [path.name for path in tmp_path.iterdir()] == ["begun"]


def test_a_folder_without_a_plan_is_begun_anew(interrupted: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Killed before its plan was written."""
    (folder_of(interrupted) / "plan.json").unlink()
    seen = count_tasks(monkeypatch)
    model().map(GRID, out=interrupted).close()
    assert len(seen) == TASKS


def test_killed_while_the_file_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The file under way is in the folder of the interrupted map, never under its final name."""
    out = tmp_path / "map.nc"
    seen = count_tasks(monkeypatch)

    def dies(self: xarray.Dataset, path: Path, **_: object) -> None:
        assert path.parent == folder_of(out)
        path.write_bytes(b"half")
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(xarray.Dataset, "to_netcdf", dies)
        with pytest.raises(KeyboardInterrupt):
            model().map(GRID, out=out)
    assert [one.name for one in tmp_path.iterdir()] == [folder_of(out).name]
    seen.clear()
    model().map(GRID, out=out).close()
    assert not seen, "everything had been computed"
    assert [one.name for one in tmp_path.iterdir()] == ["map.nc"]


def test_two_processes_do_not_write_the_same_map(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = tmp_path / "map.nc"
    first = started(out, 2)
    try:
        with pytest.raises(OutputError, match="another process is writing this map"):
            model().map(GRID, out=out)
    finally:
        _, err = first.communicate(timeout=600)
    assert (first.returncode, err) == (0, "")
    with xarray.open_dataset(out) as found:
        xarray.testing.assert_allclose(found.load(), model().map(GRID), rtol=1e-12)


def test_a_full_disk_shows_before_anything_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On a real file system of 200 kB where one can be mounted."""
    small = tmp_path / "small"
    small.mkdir()
    mounted = subprocess.run(
        ["mount", "-t", "tmpfs", "-o", "size=100k", "none", str(small)], capture_output=True
    )
    if mounted.returncode:
        pytest.skip("a small file system cannot be mounted here: needs the right to")
    try:
        seen = count_tasks(monkeypatch)
        with pytest.raises(OutputError, match="cannot write: no space left on device"):
            model().map(GRID, out=small / "map.nc", shapes=True)
        assert not seen
        assert not (small / "map.nc").exists()
    finally:
        subprocess.run(["umount", str(small)], check=True)


def test_a_disk_that_fills_up_while_the_file_is_written(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen = count_tasks(monkeypatch)
    out = tmp_path / "map.nc"

    def full(*_: object, **__: object) -> None:
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(xarray.Dataset, "to_netcdf", full)
        with pytest.raises(OutputError, match="no space left on device") as error:
            model().map(GRID, out=out)
    assert "the same command continues" in error.value.remedy
    assert not out.exists()
    seen.clear()
    model().map(GRID, out=out).close()
    assert not seen
