"""A killed or interrupted map continues where it stopped, and its result is that of an uninterrupted one."""

from __future__ import annotations

import json
import os
import shutil
import signal
import subprocess
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.map_runs import (
    GRID,
    ROWS,
    TASKS,
    chunks_in,
    count_tasks,
    done_in,
    folder_of,
    group_of,
    model,
    started,
)
from pkmodes.core.base.errors import OutputError
from pkmodes.machine.maps import mapping
from pkmodes.machine.maps.storage import GROUP_NAME, Store, disk_store, folder_lock

pytestmark = pytest.mark.skipif(os.name != "posix", reason="sends POSIX signals")


def stopped_after(tasks: int, out: Path, **options: Any) -> None:
    """Leave what a kill after some tasks leaves: the folder as it is at that moment, whatever happens next."""
    kept = out.with_name("kept")

    def copy(source: str, target: str) -> None:
        with suppress(FileNotFoundError):  # a task that is being written goes on
            shutil.copy2(source, target)

    def stop(done: int, _: int) -> None:
        if done == tasks * ROWS:
            shutil.copytree(folder_of(out), kept, copy_function=copy)
            raise KeyboardInterrupt

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mapping, "TASK_ROWS", ROWS)
        with pytest.raises(KeyboardInterrupt):
            model().map(GRID, out=out, threads=1, progress=stop, **options)
    shutil.rmtree(folder_of(out))
    kept.rename(folder_of(out))


def continued(out: Path, monkeypatch: pytest.MonkeyPatch) -> int:
    """Continue a map, which becomes that of an uninterrupted run; return the number of tasks that are computed."""
    whole = model().map(GRID)
    seen = count_tasks(monkeypatch)
    with model().map(GRID, out=out) as found:
        xarray.testing.assert_allclose(found.load(), whole, rtol=1e-12)
    assert not folder_of(out).exists()
    return len(seen)


@pytest.mark.parametrize("after", [1, 8, 15])
def test_the_same_call_computes_only_what_is_missing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, after: int
) -> None:
    out = tmp_path / "map.nc"
    stopped_after(after, out)
    assert done_in(out) == after
    assert continued(out, monkeypatch) == TASKS - after


@pytest.mark.parametrize("how", [signal.SIGKILL, signal.SIGINT])
def test_a_process_that_is_stopped_leaves_a_map_that_continues(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, how: signal.Signals
) -> None:
    out = tmp_path / "map.nc"
    process = started(out, 8)
    process.send_signal(how)
    _, err = process.communicate(timeout=600)
    assert not out.exists()
    if how == signal.SIGINT:
        assert process.returncode == 130
        assert err == "error: interrupted (pkmodes); the same command continues where it stopped\n"
    done = done_in(out)
    # An interrupt waits for the task that is being computed.
    assert 8 <= done <= 8 + (how == signal.SIGINT)
    assert continued(out, monkeypatch) == TASKS - done


def test_what_was_computed_before_is_the_same_to_the_last_digit(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    out = tmp_path / "map.zarr"
    stopped_after(6, out, tracked=True)
    seen = count_tasks(monkeypatch)
    whole = model().map(GRID, tracked=True)
    assert len(seen) == TASKS
    with model().map(GRID, out=out, tracked=True) as found:
        xarray.testing.assert_identical(found.load(), whole)
    assert len(seen) == TASKS + TASKS - 6


@pytest.fixture(scope="module")
def killed(tmp_path_factory: pytest.TempPathFactory) -> Path:
    out = tmp_path_factory.mktemp("killed") / "map.nc"
    stopped_after(3, out)
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
    stopped_after(2, out, sweep={"platform.mass": [1.0, 2.0], "link.mass": [0.6, 0.7]})
    count_tasks(monkeypatch)
    with pytest.raises(OutputError, match="differs in: sweep"):
        model().map(GRID, sweep={"link.mass": [0.6, 0.7], "platform.mass": [1.0, 2.0]}, out=out)


def rewritten(field: str, change: Callable[[bytes], bytes]) -> Callable[[Path], None]:
    """Return what changes the rows of the second of three tasks that were done."""

    def damage(group: Path) -> None:
        chunk = chunks_in(group / field)[1]
        chunk.write_bytes(change(chunk.read_bytes()))

    return damage


#: What happens to an interrupted map of three tasks, and how many of them are lost.
DAMAGE: dict[str, tuple[Callable[[Path], object], int]] = {
    "a bit of a value": (rewritten("frequency", lambda rows: bytes([rows[0] ^ 1]) + rows[1:]), 1),
    "a bit of a code": (rewritten("code", lambda rows: bytes([rows[0] ^ 1]) + rows[1:]), 1),
    "a bit of a checksum": (rewritten("frequency", lambda rows: rows[:-1] + bytes([rows[-1] ^ 64])), 1),
    "truncated": (rewritten("frequency", lambda rows: rows[:-5]), 1),
    "empty": (rewritten("code", lambda rows: b""), 1),
    "missing": (lambda group: chunks_in(group / "frequency")[1].unlink(), 1),
    "a field is missing": (lambda group: shutil.rmtree(group / "frequency"), 3),
    "the plan is missing": (lambda group: (group / "zarr.json").unlink(), 3),
    "what a field is": (lambda group: (group / "frequency" / "zarr.json").write_text("["), 0),
    "what a field is, missing": (lambda group: (group / "frequency" / "zarr.json").unlink(), 0),
}


@pytest.mark.parametrize("damage", DAMAGE)
def test_what_was_damaged_is_computed_again(
    interrupted: Path, monkeypatch: pytest.MonkeyPatch, damage: str
) -> None:
    do, lost = DAMAGE[damage]
    do(group_of(interrupted))
    assert continued(interrupted, monkeypatch) == TASKS - 3 + lost


def test_interrupted_twice(interrupted: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """What the second run stored is kept as well, also tasks in which all poses can be evaluated, or none."""
    count_tasks(monkeypatch)

    def stop(done: int, _: int) -> None:
        if done >= 9 * ROWS:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        model().map(GRID, out=interrupted, threads=1, progress=stop)
    kept = done_in(interrupted)
    assert 9 <= kept < TASKS
    assert continued(interrupted, monkeypatch) == TASKS - kept


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", "[" * 100_000])
def test_a_damaged_plan_is_refused(interrupted: Path, monkeypatch: pytest.MonkeyPatch, text: str) -> None:
    count_tasks(monkeypatch)
    plan = group_of(interrupted) / "zarr.json"
    assert json.loads(plan.read_text())["attributes"]["version"] == pkmodes.__version__
    plan.write_text(text)
    with pytest.raises(OutputError, match=r"is damaged|differs in") as error:
        model().map(GRID, out=interrupted)
    assert error.value.where == str(folder_of(interrupted))
    assert done_in(interrupted) == 3, "nothing is lost by a refusal"


def test_files_that_are_removed_while_the_map_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Zarr would read what is missing as fill values."""
    out = tmp_path / "map.nc"
    count_tasks(monkeypatch)

    def remove(done: int, total: int) -> None:
        if done == total:  # before the file is written
            shutil.rmtree(group_of(out))

    with pytest.raises(OutputError, match="some were removed meanwhile") as error:
        model().map(GRID, out=out, threads=1, progress=remove)
    assert error.value.where == str(folder_of(out))
    assert not out.exists()
    assert continued(out, monkeypatch) == TASKS, "its plan is gone as well"


@pytest.mark.parametrize("tracked", [False, True])
def test_rows_that_are_damaged_while_the_map_is_computed(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tracked: bool
) -> None:
    out = tmp_path / "map.nc"
    count_tasks(monkeypatch)

    def damage(done: int, total: int) -> None:
        if done == total:  # before the modes are tracked and the file is written
            last = chunks_in(group_of(out) / ("shape" if tracked else "frequency"))[-1]
            last.write_bytes(bytes(len(last.read_bytes())))

    with pytest.raises(OutputError, match="were damaged meanwhile") as error:
        model().map(GRID, out=out, threads=1, progress=damage, tracked=tracked)
    assert error.value.remedy == "the same command computes them again"
    assert not out.exists()


def test_a_field_that_is_empty_at_each_pose_does_not_keep_a_task_from_being_done(tmp_path: Path) -> None:
    """As the frequencies of a robot without modes."""
    layouts = {"frequency": ((0,), "f8"), "condition": ((), "f8"), "code": ((), "i1")}

    def opened() -> Store:
        return disk_store(tmp_path, {"version": "1"}, 10, 4, layouts)

    values = {"frequency": np.empty((4, 0)), "condition": np.full(4, np.nan), "code": np.zeros(4, "i1")}
    opened().write_rows(slice(4, 8), values)
    assert opened().done.tolist() == [False, True, False]
    assert opened().arrays["frequency"][:].shape == (10, 0)


def test_a_folder_in_which_nothing_was_begun_is_removed(tmp_path: Path) -> None:
    empty, begun = tmp_path / "empty", tmp_path / "begun"
    with pytest.raises(ZeroDivisionError), folder_lock(empty):
        raise ZeroDivisionError
    with folder_lock(begun):
        (begun / GROUP_NAME).mkdir()
    assert [path.name for path in tmp_path.iterdir()] == ["begun"]


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
    assert done_in(out) == len(seen) == TASKS, "everything had been computed"
    last = group_of(out) / "frequency" / "c" / str(TASKS - 1) / "0"  # with fewer rows than the others
    last.write_bytes(last.read_bytes()[:-1])
    assert continued(out, monkeypatch) == 1
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


@pytest.fixture
def small(tmp_path: Path) -> Iterator[Path]:
    """A file system of 1 MB, where one can be mounted."""
    folder = tmp_path / "small"
    folder.mkdir()
    command = ["mount", "-t", "tmpfs", "-o", "size=1000k", "none", str(folder)]
    if subprocess.run(command, capture_output=True).returncode:
        pytest.skip("a small file system cannot be mounted here: needs the right to")
    yield folder
    subprocess.run(["umount", str(folder)], check=True)


def fill(folder: Path, left: int) -> None:
    """Leave that many bytes of a file system."""
    (folder / "filling").write_bytes(bytes(shutil.disk_usage(folder).free - left))


def test_a_full_disk_shows_before_anything_is_computed(small: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = count_tasks(monkeypatch)
    fill(small, 100_000)
    with pytest.raises(OutputError, match="cannot write: no space left on device") as error:
        model().map(GRID, out=small / "map.nc", shapes=True)
    assert error.value.where == str(small / "map.nc.partial")
    assert not seen
    assert [one.name for one in small.iterdir()] == ["filling"]


def test_a_disk_that_fills_up_while_the_map_is_computed(small: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    out = small / "map.nc"
    count_tasks(monkeypatch)

    def others_write(done: int, _: int) -> None:
        if done == 5 * ROWS:
            with suppress(OSError):  # the map itself may have filled it by now
                fill(small, 0)

    with pytest.raises(OutputError, match="cannot write: no space left on device") as error:
        model().map(GRID, out=out, threads=1, progress=others_write)
    assert error.value.remedy == "choose another place or make room"
    assert not out.exists()
    (small / "filling").unlink(missing_ok=True)
    kept = done_in(out)
    assert kept >= 5
    assert continued(out, monkeypatch) == TASKS - kept


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
