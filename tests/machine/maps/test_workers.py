"""Maps and suites on a Dask scheduler with worker processes; a worker, or the client, is killed midway."""

from __future__ import annotations

import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import replace
from importlib import import_module
from pathlib import Path
from socket import socket
from typing import Any

import numpy as np
import pytest
import xarray

import pkmodes
from helpers.commands.map_runs import (
    CLIENT,
    GRID,
    GRID_TEXT,
    ROBOT,
    ROWS,
    TASKS,
    count_tasks,
    done_in,
    folder_of,
    model,
    started,
)
from helpers.runs.processes import ROOT, environment
from pkmodes.cli import run
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism import registry as mechanism
from pkmodes.machine.maps import mapping, running
from pkmodes.machine.maps.evaluating import Task
from studies import mechanism_cases, mechanism_suites
from studies.mechanism_cases import MechanismOutcome
from studies.running import Pool, run_all

#: Longer than any machine takes to start or to answer [s].
LONG = 600
HERE = ["--host", "127.0.0.1", "--no-dashboard"]


@pytest.fixture(autouse=True)
def _patience(monkeypatch: pytest.MonkeyPatch) -> None:
    """A busy machine starts processes slowly."""
    monkeypatch.setattr(running, "TIMEOUT", LONG)


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
    with processes(scheduling(address), folders=[ROOT / "tests"]):
        yield address


@pytest.fixture(scope="module")
def workers(scheduler: str) -> Iterator[list[subprocess.Popen[bytes]]]:
    with processes(worker(scheduler), worker(scheduler), folders=[ROOT / "tests"]) as found:
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
    monkeypatch.setattr(mapping, "TASK_ROWS", 20)
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
        patch.setattr(mapping, "TASK_ROWS", 5)
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


@pytest.fixture(scope="module")
def killed(
    scheduler: str, workers: list[subprocess.Popen[bytes]], tmp_path_factory: pytest.TempPathFactory
) -> Path:
    """What the command leaves that is killed with six tasks stored."""
    out = tmp_path_factory.mktemp("killed") / "map.nc"
    process = started(out, 6, "--scheduler", scheduler, program=CLIENT)
    process.kill()
    process.communicate(timeout=LONG)
    assert done_in(out) == 6
    return folder_of(out)


@pytest.mark.parametrize("again", ["with the scheduler", "without"])
def test_the_client_killed_midway_and_the_same_command_again(
    scheduler: str, killed: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, again: str
) -> None:
    monkeypatch.setattr(mapping, "TASK_ROWS", ROWS)
    out, whole = tmp_path / "map.nc", tmp_path / "whole.nc"
    model().map(GRID, out=whole).close()
    shutil.copytree(killed, folder_of(out))
    started_now: list[int] = []

    def counted(tasks: Iterable[tuple[int, Task]], *others: Any) -> None:
        listed = list(tasks)
        started_now.extend(number for number, _ in listed)
        running.run_tasks(listed, *others)

    monkeypatch.setattr(mapping, "run_tasks", counted)
    options = ["--scheduler", scheduler] if again == "with the scheduler" else []
    assert run(["map", str(ROBOT), "--grid", GRID_TEXT, "--out", str(out), *options]) == 0
    assert len(started_now) == TASKS - 6
    assert [one.name for one in tmp_path.iterdir() if one != whole] == ["map.nc"]
    with xarray.open_dataset(out) as found, xarray.open_dataset(whole) as expected:
        xarray.testing.assert_identical(found.load(), expected.load())


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
    monkeypatch.setattr(mechanism, "_package_by_name", {})
    assert run(COMMANDS[0]) == 0
    own = pkmodes.load("robot.toml")
    grid = {"x": np.linspace(-0.1, 0.1, 5), "y": [-0.42, -0.33]}
    here = own.map(grid, backend="numpy")
    xarray.testing.assert_identical(here, own.map(grid, backend="numpy", scheduler=scheduler))


def test_other_generated_code_on_the_workers(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mapping, "code_hash", lambda kind: "0" * 64)
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
        PkmodesError, match=r"expected pkmodes 9.9 on the scheduler and every worker, found .* on tcp://"
    ) as error:
        model().map(GRID, scheduler=scheduler)
    assert error.value.remedy == "install the same version there"


def test_another_version_on_the_scheduler(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    import distributed

    monkeypatch.setattr(running, "VERSION", "9.9")
    monkeypatch.setattr(distributed.Client, "run", lambda client, probe: {"tcp://a-worker": "9.9"})
    with pytest.raises(PkmodesError, match=f"found {pkmodes.__version__} on {scheduler}"):
        model().map(GRID, scheduler=scheduler)


def test_cases_of_a_suite_on_workers(
    scheduler: str, workers: list[subprocess.Popen[bytes]], capsys: pytest.CaptureFixture[str]
) -> None:
    cases = [case for case in mechanism_suites.cases() if case.label.startswith("corexy, nothing missing")][
        :2
    ]
    broken = replace(cases[0], poses="none")  # type: ignore[arg-type]
    there = run_all(
        mechanism_cases.run,
        [*cases, broken],
        Pool(scheduler=scheduler),
        lambda one: one.case.label,
        MechanismOutcome,
    )
    assert [replace(one, seconds=0.0) for one in there[:2]] == [
        replace(mechanism_cases.run(case), seconds=0.0) for case in cases
    ]
    assert there[2].state == "failed"
    assert "TypeError" in there[2].reason
    assert capsys.readouterr().err.splitlines()[1] == f"2/3 {cases[1].label}"


@pytest.mark.parametrize(
    "suite",
    ["campaigns", "clear_suites", "damping", "diagnosis", "limits", "mechanism_suites", "six_legged_suites"],
)
def test_every_suite_with_a_pool_takes_a_scheduler(suite: str, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(running, "TIMEOUT", 1)
    monkeypatch.setattr(sys, "argv", [suite, "--scheduler", "nonsense://x"])
    with pytest.raises(SystemExit, match="error: cannot reach the scheduler"):
        import_module(f"studies.{suite}").main()


def test_a_worker_that_would_run_several_cases_in_one_process(
    scheduler: str, workers: list[subprocess.Popen[bytes]], monkeypatch: pytest.MonkeyPatch
) -> None:
    import distributed

    monkeypatch.setattr(distributed.Client, "nthreads", lambda client: {"tcp://one": 1, "tcp://other": 4})
    with (
        pytest.raises(SystemExit, match="expected workers with one thread each, found one with 4"),
        Pool(scheduler=scheduler).executor(),
    ):
        pass


@pytest.mark.parametrize(
    ("configured", "found"), [(False, "none"), (True, "files that cannot be read (No such")]
)
def test_an_encrypted_scheduler_without_certificates(tmp_path: Path, configured: bool, found: str) -> None:
    import dask

    names = ("ca-file", "client.cert") if configured else ()
    settings = {f"distributed.comm.tls.{name}": str(tmp_path / "absent.pem") for name in names}
    with dask.config.set(settings), pytest.raises(PkmodesError) as error:
        model().map(GRID, scheduler="tls://127.0.0.1:9")
    assert f"expected certificates for TLS in the configuration of Dask, found {found}" in error.value.what
    assert "distributed.comm.tls.ca-file" in error.value.remedy


@pytest.mark.skipif(shutil.which("openssl") is None, reason="makes certificates with openssl")
def test_an_encrypted_scheduler(tmp_path: Path) -> None:
    import dask
    import distributed

    key, certificate = tmp_path / "key.pem", tmp_path / "certificate.pem"
    make = (
        "openssl req -x509 -newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes -days 2 -subj /CN=pkmodes"
    )
    subprocess.run(
        [*make.split(), "-keyout", key, "-out", certificate], check=True, capture_output=True, timeout=LONG
    )
    settings: dict[str, object] = {"distributed.comm.tls.ca-file": str(certificate)}
    for who in ("client", "scheduler", "worker"):
        settings |= {
            f"distributed.comm.tls.{who}.cert": str(certificate),
            f"distributed.comm.tls.{who}.key": str(key),
        }
    settings["distributed.comm.require-encryption"] = True
    here = model().map(GRID)
    with (
        dask.config.set(settings),
        distributed.LocalCluster(
            n_workers=1,
            threads_per_worker=1,
            processes=False,
            protocol="tls",
            host="127.0.0.1",
            dashboard_address=":0",
            security=distributed.Security(),
        ) as cluster,
    ):
        assert cluster.scheduler_address.startswith("tls://127.0.0.1:")
        xarray.testing.assert_identical(here, model().map(GRID, scheduler=cluster.scheduler_address))


def test_a_worker_without_pkmodes(tmp_path: Path) -> None:
    (tmp_path / "sitecustomize.py").write_text("import sys\nsys.modules['pkmodes'] = None\n")
    address = free_address()
    with processes(scheduling(address), worker(address), folders=[tmp_path]):
        wait_for(address, 1)
        with pytest.raises(PkmodesError, match=r"and every worker, found none on tcp://"):
            model().map(GRID, scheduler=address)


def test_a_scheduler_without_workers(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(running, "TIMEOUT", 2)
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
    monkeypatch.setattr(running, "TIMEOUT", 1)
    with pytest.raises(
        PkmodesError, match=r"cannot reach the scheduler|expected the address of a scheduler"
    ) as error:
        model().map(GRID, scheduler=address, out=tmp_path / "map.nc")
    assert "dask scheduler" in error.value.remedy
    assert not (tmp_path / "map.nc").exists()
