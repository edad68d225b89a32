"""Run the tasks of a map: on the threads of this machine, or on the workers of a Dask scheduler.

Both are executors of `concurrent.futures`, so one loop submits, collects and stores.  Only a few tasks are in
progress at a time, which bounds the memory.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from concurrent.futures import FIRST_COMPLETED, CancelledError, Future, ThreadPoolExecutor, wait
from contextlib import contextmanager, suppress
from typing import Any

from numpy.typing import NDArray

from pkmodes.core.base.arguments import Constraint, check_argument
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.base.version import VERSION
from pkmodes.core.support.extras import require
from pkmodes.machine.maps.evaluating import Task, evaluate

#: Tasks in progress for each thread: one is computed while the result of another is stored.
TASKS_PER_THREAD = 2
#: Timeout for the scheduler and for a worker [s].
TIMEOUT = 10
#: Protocols for which a client needs certificates.
ENCRYPTED_PROTOCOLS = ("tls://", "wss://")
#: Only the type is checked; whether it is an address shows when a client connects.
ADDRESS = Constraint("the address of a scheduler", lambda value: isinstance(value, str))

Values = Mapping[str, NDArray[Any]]
Put = Callable[[int, Values], None]
Submit = Callable[[int, Task], Future[Values | None]]


def run_tasks(
    tasks: Iterable[tuple[int, Task]],
    put: Put,
    finish: Callable[[int], None],
    threads: int,
    scheduler: str | None,
) -> None:
    """Evaluate tasks and store their results in any order.

    - tasks: each with its number
    - put: stores the fields of a task, given its number; several threads may call it
    - finish: takes the number of a task that is stored; called in this thread
    - threads: number of threads on this machine, without a scheduler
    - scheduler: address of a Dask scheduler, such as ``"tcp://127.0.0.1:8786"``

    Raises PkmodesError if the scheduler cannot be reached, or has no workers that can evaluate; or the error of a
    task.
    """
    pending: dict[Future[Values | None], int] = {}
    with _submitter(put, threads, scheduler) as (submit, number_of_threads):
        try:
            for number, task in tasks:
                pending[submit(number, task)] = number
                if len(pending) >= TASKS_PER_THREAD * number_of_threads:
                    _collect(pending, put, finish)
            while pending:
                _collect(pending, put, finish)
        except BaseException:
            for future in pending:
                future.cancel()
            raise


def _collect(pending: dict[Future[Values | None], int], put: Put, finish: Callable[[int], None]) -> None:
    done, _ = wait(pending, return_when=FIRST_COMPLETED)
    for future in done:
        number = pending.pop(future)
        values = future.result()
        if values is not None:
            put(number, values)
        finish(number)


@contextmanager
def _submitter(put: Put, threads: int, scheduler: str | None) -> Iterator[tuple[Submit, int]]:
    """Yield a function that submits a task, and the number of threads; threads here store their own results."""
    if scheduler is None:

        def evaluate_here(number: int, task: Task) -> None:
            put(number, evaluate(task))

        pool = ThreadPoolExecutor(threads, thread_name_prefix="pkmodes")
        try:
            yield lambda number, task: pool.submit(evaluate_here, number, task), threads
        finally:
            pool.shutdown(wait=True, cancel_futures=True)
        return
    with connect(scheduler) as client:
        executor = client.get_executor(pure=False)
        try:
            yield lambda _, task: executor.submit(evaluate, task), sum(client.nthreads().values())
        except (PkmodesError, MemoryError):
            raise
        except (Exception, CancelledError) as error:  # errors of Dask, such as that of a lost scheduler
            reason = " ".join(str(error).split()) or "the connection was lost"
            problem = f"the workers could not finish: {type(error).__name__}: {reason[:300]}"
            remedy = "check the scheduler and its workers; with an output file, the same command continues"
            raise PkmodesError(problem, f"scheduler {shown(scheduler)}", remedy) from error
        finally:
            with suppress(Exception):  # the scheduler is gone
                executor.shutdown(wait=False)


@contextmanager
def connect(scheduler: str) -> Iterator[Any]:
    """Connect to a Dask scheduler; it and all of its workers must have this version of pkmodes.

    - scheduler: its address

    The client is closed at the end.
    Raises PkmodesError if it cannot be reached, has no workers, or runs another version, as a worker may.
    """
    require("work on a Dask scheduler", "cluster", "distributed")
    import distributed

    remedy = "start one with: dask scheduler, and give its address, such as tcp://127.0.0.1:8786"
    check_argument(scheduler, ADDRESS, "scheduler", remedy)
    if scheduler.startswith(ENCRYPTED_PROTOCOLS):
        _check_certificates(scheduler)
    try:
        client = distributed.Client(scheduler, timeout=TIMEOUT, set_as_default=False)
    except Exception as error:  # also what the protocol of the address raises
        problem = f"cannot reach the scheduler: {type(error).__name__}"
        raise PkmodesError(problem, f"scheduler {shown(scheduler)}", remedy) from None
    try:
        try:
            client.wait_for_workers(1, timeout=TIMEOUT)
        except TimeoutError:
            remedy = f"start some: dask worker {scheduler}"
            raise PkmodesError(
                "the scheduler has no workers", f"scheduler {shown(scheduler)}", remedy
            ) from None
        # The scheduler reads the tasks, too, before it hands them out.
        versions = {
            **client.run(_version_function()),
            scheduler: client.run_on_scheduler(_version_function()),
        }
        mismatches = {where: version for where, version in versions.items() if version != VERSION}
        for where, version in mismatches.items():
            mismatch = f"{version or 'none'} on {where}"
            problem = f"expected pkmodes {VERSION} on the scheduler and every worker, found {mismatch}"
            raise PkmodesError(problem, f"scheduler {shown(scheduler)}", "install the same version there")
        yield client
    finally:
        client.close(timeout=TIMEOUT)


def _check_certificates(scheduler: str) -> None:
    """Refuse an encrypted address without certificates, for which the client's own error is of no help."""
    import distributed

    certificates = "none"
    try:
        if distributed.Security().get_connection_args("client").get("ssl_context"):
            return
    except OSError as error:
        certificates = f"files that cannot be read ({error.strerror or type(error).__name__})"
    raise PkmodesError(
        f"expected certificates for TLS in the configuration of Dask, found {certificates}",
        f"scheduler {shown(scheduler)}",
        "set distributed.comm.tls.ca-file, and cert and key of distributed.comm.tls.client",
    )


def _version_function() -> Callable[[], str]:
    """Return a function that reports the version of pkmodes where it runs; empty where pkmodes is not installed."""

    def version() -> str:
        try:
            from pkmodes.core.base.version import VERSION
        except ModuleNotFoundError:
            return ""
        return VERSION

    version.__module__ = "__main__"  # a function of this module would be imported there
    return version
