"""A map on a Dask scheduler with worker processes, one of which is killed midway."""

from __future__ import annotations

import signal
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from socket import socket

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.map_runs import GRID, count_tasks, model
from helpers.runs.processes import environment
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import registry as mechanism
from pkmodes.maps import mapping, running

#: Longer than any machine takes to start or to answer [s].
LONG = 600
HERE = ["--host", "127.0.0.1", "--no-dashboard"]


@pytest.fixture(autouse=True)
def _patience(monkeypatch: pytest.MonkeyPatch) -> None:
    """A busy machine starts processes slowly."""
    monkeypatch.setattr(running, "PATIENCE", LONG)


def free_address() -> str:
    with socket() as one:
        one.bind(("127.0.0.1", 0))
        return f"tcp://127.0.0.1:{one.getsockname()[1]}"


@contextmanager
def processes(*commands: list[str], folders: Sequence[Path] = ()) -> Iterator[list[subprocess.Popen[bytes]]]:
    """Run processes, and end them."""
    started = [
        subprocess.Popen(
            [sys.executable, "-m", *command],
            env=environment(*folders),
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        for command in commands
    ]
    try:
        yield started
    finally:
        # A worker whose scheduler is gone waits for it, and ends when killed.
        for process in reversed(started):
            process.terminate()
            try:
                process.wait(timeout=20)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def scheduling(address: str) -> list[str]:
    return ["distributed.cli.dask_scheduler", "--port", address.rpartition(":")[2], *HERE]


def worker(address: str) -> list[str]:
    options = ["--nthreads", "1", "--death-timeout", str(LONG), "--no-nanny"]
    return ["distributed.cli.dask_worker", address, *HERE, *options]


@pytest.fixture(scope="module")
def scheduler() -> Iterator[str]:
    address = free_address()
    with processes(scheduling(address)):
        yield address


@pytest.fixture(scope="module")
def workers(scheduler: str) -> Iterator[list[subprocess.Popen[bytes]]]:
    with processes(worker(scheduler), worker(scheduler)) as found:
        wait_for(scheduler, 2)
        yield found


def wait_for(address: str, number: int) -> None:
    import distributed

    with distributed.Client(address, timeout=LONG, set_as_default=False) as client:
        deadline = time.monotonic() + LONG
        while len(client.scheduler_info()["workers"]) != number:
            assert time.monotonic() < deadline
            time.sleep(0.1)


def test_the_result_is_that_of_this_machine(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mapping, "ROWS", 20)
    sweep = {"platform.mass": [1.0, 2.0]}
    here = model().map(GRID, sweep=sweep, shapes=True)
    seen = count_tasks(monkeypatch)
    there = model().map(GRID, sweep=sweep, shapes=True, scheduler=scheduler)
    assert not seen, "nothing is computed here"
    xarray.testing.assert_identical(here, there)


@pytest.mark.slow
def test_one_worker_killed_midway_changes_nothing(scheduler: str, tmp_path: Path) -> None:
    """Every task waits a moment, so that the worker dies with tasks under way."""
    out = tmp_path / "map.nc"
    numbers: list[int] = []
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(mapping, "ROWS", 5)
        here = model().map(GRID)
        address = free_address()
        with processes(scheduling(address), worker(address), worker(address)) as (_, first, _other):
            wait_for(address, 2)

            def progress(done: int, total: int) -> None:
                numbers.append(done)
                if len(numbers) == 10:
                    first.send_signal(signal.SIGKILL)

            with model().map(GRID, out=out, scheduler=address, progress=progress) as there:
                assert first.wait(timeout=LONG) == -signal.SIGKILL
                xarray.testing.assert_identical(here, there.load())
    assert numbers[-1] == 330
    assert numbers == sorted(numbers)
    assert [one.name for one in tmp_path.iterdir()] == ["map.nc"]


def test_a_mechanism_of_ones_own_on_workers(
    scheduler: str,
    workers: list[subprocess.Popen[bytes]],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    from helpers.commands.adding_a_mechanism import COMMANDS, DEFINITION, ROBOT

    (tmp_path / "five_bar.py").write_text(DEFINITION, encoding="utf-8")
    (tmp_path / "robot.toml").write_text(ROBOT, encoding="utf-8")
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(mechanism, "_added", {})
    assert run(COMMANDS[0]) == 0
    own = pkmodes.load("robot.toml")
    grid = {"x": np.linspace(-0.1, 0.1, 5), "y": [-0.42, -0.33]}
    here = own.map(grid, backend="numpy")
    xarray.testing.assert_identical(here, own.map(grid, backend="numpy", scheduler=scheduler))


def test_other_generated_code_on_the_workers(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mapping, "code_of", lambda kind: "0" * 64)
    with pytest.raises(PkmodesError, match="the generated code of linear_delta differs from that of the map"):
        model().map(GRID, scheduler=scheduler)


def test_an_error_in_a_task_is_the_users(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(task: object) -> None:
        raise PkmodesError("the joint is too soft", "robot.toml", "make it stiffer")

    fails.__module__ = "__main__"  # by value: the workers do not have this file
    monkeypatch.setattr(running, "evaluate", fails)
    with pytest.raises(PkmodesError) as error:
        model().map(GRID, scheduler=scheduler)
    assert str(error.value) == "the joint is too soft (robot.toml); make it stiffer"


def test_an_unexpected_error_of_a_worker_says_so(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    def fails(task: object) -> None:
        raise ZeroDivisionError("division\nby zero")

    fails.__module__ = "__main__"
    monkeypatch.setattr(running, "evaluate", fails)
    with pytest.raises(
        PkmodesError, match="the workers could not finish: ZeroDivisionError: division by zero"
    ):
        model().map(GRID, scheduler=scheduler)


def test_another_version_on_the_workers(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(running, "VERSION", "9.9")
    with pytest.raises(
        PkmodesError, match=r"expected pkmodes 9.9 on every worker, found .* on tcp://"
    ) as error:
        model().map(GRID, scheduler=scheduler)
    assert error.value.remedy == "install the same version there"


def test_a_worker_without_pkmodes(tmp_path: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text("import sys\nsys.modules['pkmodes'] = None\n")
    address = free_address()
    with processes(scheduling(address), worker(address), folders=[tmp_path]):
        wait_for(address, 1)
        with pytest.raises(PkmodesError, match=r"on every worker, found none on tcp://"):
            model().map(GRID, scheduler=address)


def test_a_scheduler_without_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(running, "PATIENCE", 2)
    address = free_address()
    with processes(scheduling(address)):
        deadline = time.monotonic() + LONG
        while True:
            try:
                model().map(GRID, scheduler=address)
            except PkmodesError as error:
                if "cannot reach" in error.what and time.monotonic() < deadline:
                    continue  # it is still starting
                assert error.what == "the scheduler has no workers"
                assert error.remedy == f"start some: dask worker {address}"
                break


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:9", "127.0.0.1:9", "nonsense://x", "", "tcp://", 5])
def test_a_scheduler_that_is_not_there(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, address: str) -> None:
    monkeypatch.setattr(running, "PATIENCE", 1)
    with pytest.raises(
        PkmodesError, match=r"cannot reach the scheduler|expected the address of a scheduler"
    ) as error:
        model().map(GRID, scheduler=address, out=tmp_path / "map.nc")
    assert "dask scheduler" in error.value.remedy
    assert not (tmp_path / "map.nc").exists()
