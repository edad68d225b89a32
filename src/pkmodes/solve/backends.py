"""The back ends that evaluate modes: generated NumPy code, and a compiled library where there is one."""

from __future__ import annotations

import os
from functools import cache
from typing import TYPE_CHECKING

import numpy as np

from pkmodes.base.errors import PkmodesError, shown
from pkmodes.mechanism.registry import Mechanism
from pkmodes.system.evaluation import Evaluation

if TYPE_CHECKING:
    from pkmodes.compiled.evaluator import Evaluator

NUMPY, COMPILED, AUTO = "numpy", "compiled", "auto"
BACKENDS = (AUTO, NUMPY, COMPILED)
#: Environment variable with the back end to use where none is asked for.
VARIABLE = "PKMODES_BACKEND"


def chosen(backend: str) -> str:
    """Return the back end that the caller or the environment selects.

    Parameters
    ----------
    backend : {"auto", "numpy", "compiled"}
        With "auto", the environment variable ``PKMODES_BACKEND`` decides.

    Raises
    ------
    PkmodesError
        If either is not one of the three.
    """
    found, where = backend, "backend"
    if isinstance(backend, str) and backend == AUTO:
        found, where = os.environ.get(VARIABLE, "") or AUTO, f"environment variable {VARIABLE}"
    if not (isinstance(found, str) and found in BACKENDS):
        known = '"auto", "numpy" or "compiled"'
        raise PkmodesError(f"expected {known}, found {shown(found)}", where, "choose one of the three")
    return found


def checked_threads(threads: int | None) -> int:
    """Check a number of threads; by default one for each core that this process may use.

    Raises
    ------
    PkmodesError
        If it is not a positive integer.
    """
    if threads is None:
        return all_cores()
    if isinstance(threads, bool) or not isinstance(threads, int | np.integer) or threads < 1:
        raise PkmodesError(
            f"expected a positive integer, found {shown(threads)}", "threads", "leave it out for all cores"
        )
    return int(threads)


@cache
def all_cores() -> int:
    """Cores that this process may use."""
    try:
        return len(os.sched_getaffinity(0))
    except AttributeError:  # not on this system
        return os.cpu_count() or 1


def compiled(
    mechanism: Mechanism, evaluation: Evaluation, largest_condition: float, backend: str
) -> Evaluator | None:
    """Make the compiled evaluator of a robot.

    Parameters
    ----------
    mechanism : Mechanism
    evaluation : Evaluation
        Of the robot.
    largest_condition : float
        Poses with a larger condition number are singular.
    backend : {"auto", "numpy", "compiled"}
        From `chosen`.

    Returns
    -------
    Evaluator or None
        None for NumPy.

    Raises
    ------
    PkmodesError
        If "compiled" is asked for and there is no library.
    """
    if backend == NUMPY:
        return None
    # Building and loading libraries needs modules that are slow to import.
    from pkmodes.compiled.evaluator import Evaluator
    from pkmodes.compiled.loader import UnavailableError, load

    try:
        found = load(mechanism.package, mechanism.name)
        return Evaluator(found, evaluation.lanes(), len(evaluation.coordinates), largest_condition)
    except UnavailableError as error:
        if backend == AUTO:
            return None
        raise PkmodesError(
            f"the compiled back end is not available: {error.why}", mechanism.name, error.remedy
        ) from None
