"""Derivatives of eigenvalues and frequencies from the compiled evaluator, and from NumPy where modes coincide."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.compiled.evaluator import Evaluator
from pkmodes.compiled.lanes import Terms
from pkmodes.linalg.eigen import magnitude
from pkmodes.mechanism.poses import CHUNK, CheckedPoses, OnError
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.modes import ROUNDING, separate
from pkmodes.sensitivity.terms import RATES
from pkmodes.solve.compiled_modes import EIGENVALUES, Job, evaluated, left_to_numpy
from pkmodes.solve.gathering import Out
from pkmodes.system.evaluation import Evaluation

Array = NDArray[np.float64]


def compiled_rates(
    evaluator: Evaluator,
    robot: Robot,
    system: Evaluation,
    terms: Terms,
    close: float,
    poses: ArrayLike,
    on_error: OnError,
    asked: Sequence[str],
    out: Out,
    threads: int,
    redone: Callable[[Array], Mapping[str, Array]],
) -> tuple[CheckedPoses, dict[str, Array]]:
    """Evaluate derivatives of eigenvalues and frequencies at poses.

    Parameters
    ----------
    evaluator : Evaluator
    robot : Robot
    system : Evaluation
        Of the robot.
    terms : Terms
        Of T paths.
    close : float
        As for `pkmodes.Model.sensitivities`.
    poses, on_error, out
        As for `pkmodes.Model.sensitivities`.
    asked : sequence of str
        Fields.
    threads : int
    redone : callable
        Evaluates the fields at some poses, (n, d), with NumPy.

    Returns
    -------
    CheckedPoses
        With the code of each pose.
    dict of str to ndarray, shape (..., T, m)
        By field; NaN where a pose cannot be evaluated.

    Raises
    ------
    PoseError, PkmodesError
        As `pkmodes.Model.sensitivities` does.
    """

    def left(codes: NDArray[np.int8], written: Mapping[str, Array]) -> NDArray[np.intp]:
        values = written[EIGENVALUES]
        unsolved = left_to_numpy(system, codes, values)
        together = codes == 0
        for start in range(0, len(codes), CHUNK):
            part = slice(start, start + CHUNK)
            together[part] &= _coincide(values[part], system, close, "eigenvalues" in asked)
        return np.union1d(unsolved, np.flatnonzero(together))

    tail = (len(terms.first) - 1, evaluator.modes)
    job = Job(
        tails=dict.fromkeys(asked, tail),
        kernel={name: RATES[name] for name in asked},
        evaluation=system,
        by_eigenvalues=True,
        terms=terms,
        left=left,
        redone=redone,
    )
    return evaluated(evaluator, robot, poses, on_error, job, out, threads)


def _coincide(eigenvalues: Array, system: Evaluation, close: float, of_zero: bool) -> NDArray[np.bool_]:
    """Return where modes form a group; with `of_zero` also of those whose frequency is zero to rounding."""
    sizes = magnitude(eigenvalues, system.first, system.rigid_modes)
    together = ~separate(eigenvalues, close, sizes)
    if not of_zero:
        moving = np.abs(eigenvalues) > ROUNDING * sizes
        together &= moving[:, 1:] | moving[:, :-1]
    return np.asarray(together.any(axis=1))
