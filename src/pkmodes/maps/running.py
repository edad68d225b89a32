"""Run the tasks of a map: on the threads of this machine, or on the workers of a Dask scheduler.

Both are executors of `concurrent.futures`, so one loop submits, collects and stores.  Only a few tasks are under way
at a time, which bounds the memory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, Executor, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from typing import Any

from numpy.typing import NDArray

from pkmodes.errors import MissingExtraError, PkmodesError, shown
from pkmodes.maps.evaluating import Task, evaluate

#: Tasks under way for each thread or worker: one is computed while the result of another is stored.
AHEAD = 2
#: How long to wait for the scheduler and a worker [s].
PATIENCE = 10
#: Workers that may die under one task before it is given up; Dask hands it to another until then.
RETRIES = 3

Store = Callable[[int, Mapping[str, NDArray[Any]]], None]


def run(tasks: Iterable[tuple[int, Task]], store: Store, threads: int, scheduler: str | None) -> None:
    """Evaluate tasks and store their results in any order.

    Parameters
    ----------
    tasks : iterable of (int, Task)
        Each with its number.
    store : callable
        Takes the number of a task and its fields; called in this thread.
    threads : int
        On this machine, without a scheduler.
    scheduler : str, optional
        Address of a Dask scheduler, such as ``"tcp://127.0.0.1:8786"``.

    Raises
    ------
    PkmodesError
        If the scheduler cannot be reached or has no workers that can evaluate.
    """
    pending: dict[Future[Any], int] = {}
    with _executor(threads, scheduler) as (executor, workers):
        try:
            for number, task in tasks:
                pending[executor.submit(evaluate, task)] = number
                if len(pending) >= AHEAD * workers:
                    _collect(pending, store)
            while pending:
                _collect(pending, store)
        except BaseException:
            for future in pending:
                future.cancel()
            raise


def _collect(pending: dict[Future[Any], int], store: Store) -> None:
    done, _ = wait(pending, return_when=FIRST_COMPLETED)
    for future in done:
        store(pending.pop(future), future.result())


@contextmanager
def _executor(threads: int, scheduler: str | None) -> Iterator[tuple[Executor, int]]:
    if scheduler is None:
        pool = ThreadPoolExecutor(threads, thread_name_prefix="pkmodes")
        try:
            yield pool, threads
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
        return
    with _client(scheduler) as client:
        number = len(client.scheduler_info()["workers"])
        executor = client.get_executor(retries=RETRIES, pure=False)
        try:
            yield executor, number
        finally:
            with suppress(Exception):  # the scheduler is gone
                executor.shutdown(wait=False)


@contextmanager
def _client(scheduler: str) -> Iterator[Any]:
    try:
        import distributed
    except ModuleNotFoundError as error:
        remedy = "install it: pip install 'pkmodes[map]'"
        raise MissingExtraError(
            f"a map on a Dask scheduler needs {error.name}", "scheduler", remedy
        ) from None
    import pkmodes

    try:
        client = distributed.Client(scheduler, timeout=PATIENCE, set_as_default=False)
    except (OSError, TimeoutError, ValueError) as error:
        what = f"cannot reach the scheduler: {type(error).__name__}"
        remedy = "start one with: dask scheduler, and give its address, such as tcp://127.0.0.1:8786"
        raise PkmodesError(what, f"scheduler {shown(scheduler)}", remedy) from None
    try:
        try:
            client.wait_for_workers(1, timeout=PATIENCE)
        except TimeoutError:
            remedy = f"start some: dask worker {scheduler}"
            raise PkmodesError(
                "the scheduler has no workers", f"scheduler {shown(scheduler)}", remedy
            ) from None
        versions = client.run(_version)
        wrong = {where: found for where, found in versions.items() if found != pkmodes.__version__}
        for where, found in wrong.items():
            what = f"expected pkmodes {pkmodes.__version__} on every worker, found {found or 'none'}"
            raise PkmodesError(what, f"worker {where}", "install the same version there")
        yield client
    finally:
        client.close(timeout=PATIENCE)


def _version() -> str:
    import pkmodes

    return pkmodes.__version__
