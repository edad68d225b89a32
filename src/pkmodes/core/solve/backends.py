"""The back ends that evaluate modes, and which of them is used."""

from __future__ import annotations

import os
from contextlib import suppress
from functools import cache

from pkmodes.core.base.arguments import POSITIVE_INTEGER, check_argument
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.solve.compiled_solver import CompiledSolver
from pkmodes.core.solve.held_solver import HeldSolver
from pkmodes.core.solve.numpy_solver import NumpySolver
from pkmodes.core.solve.solver import Solver, UnavailableError
from pkmodes.core.system.evaluation import Evaluation
from pkmodes.core.system.motors import MotorsHeld

AUTO = "auto"
#: The back ends by the names that a user gives.
SOLVERS: dict[str, type[Solver]] = {solver.name: solver for solver in (NumpySolver, CompiledSolver)}
#: What "auto" tries, in this order; the last one can always be used.
PREFERRED = (CompiledSolver.name, NumpySolver.name)
#: Environment variable with the back end to use where none is asked for.
VARIABLE = "PKMODES_BACKEND"
COUNTED = {3: "three", 4: "four", 5: "five"}


def chosen(backend: str) -> str:
    """Return the back end that the caller or the environment selects.

    Parameters
    ----------
    backend : str
        A name of `SOLVERS`; with "auto", the environment variable ``PKMODES_BACKEND`` decides.

    Raises
    ------
    PkmodesError
        If either is not the name of a back end.
    """
    name, where = backend, "backend"
    if isinstance(backend, str) and backend == AUTO:
        name, where = os.environ.get(VARIABLE, "") or AUTO, f"environment variable {VARIABLE}"
    known = (AUTO, *SOLVERS)
    if not (isinstance(name, str) and name in known):
        *others, last = (f'"{one}"' for one in known)
        count = COUNTED.get(len(known), str(len(known)))
        raise PkmodesError(
            f"expected {', '.join(others)} or {last}, found {shown(name)}",
            where,
            f"choose one of the {count}",
        )
    return name


def checked_threads(threads: int | None) -> int:
    """Check a number of threads; by default one for each core that this process may use.

    Raises
    ------
    PkmodesError
        If it is not a positive integer.
    """
    if threads is None:
        return all_cores()
    check_argument(threads, POSITIVE_INTEGER, "threads", "leave it out for all cores")
    return int(threads)


@cache
def all_cores() -> int:
    """Cores that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on this system
        return os.cpu_count() or 1


def solver_of(
    system: Evaluation, largest_condition: float, backend: str, free: Solver | None = None
) -> Solver:
    """Return the solver of a robot.

    Parameters
    ----------
    largest_condition : float
        Poses with a larger condition number are singular.
    backend : str
        From `chosen`; with "auto", the first of `PREFERRED` that can be used.
    free : Solver, optional
        For held motors: see `pkmodes.core.solve.held_solver.HeldSolver`.

    Raises
    ------
    UnavailableError
        If it cannot be used here.
    """
    if isinstance(system, MotorsHeld):
        return HeldSolver(_solver_of(system, largest_condition, backend), system, free)
    return _solver_of(system, largest_condition, backend)


def _solver_of(system: Evaluation, largest_condition: float, backend: str) -> Solver:
    if backend != AUTO:
        return SOLVERS[backend].init(system, largest_condition)
    for name in PREFERRED[:-1]:
        with suppress(UnavailableError):
            return SOLVERS[name].init(system, largest_condition)
    return SOLVERS[PREFERRED[-1]].init(system, largest_condition)
