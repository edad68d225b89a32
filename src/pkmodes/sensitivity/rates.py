"""Derivatives of eigenvalues and frequencies from a solver that has them, and from NumPy where modes coincide."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import UNSOLVED, Terms
from pkmodes.core.linalg.eigen import magnitude
from pkmodes.core.mechanism.poses import CHUNK, codes_of
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.batch import Job
from pkmodes.core.solve.solver import EIGENVALUES, Codes, Solver
from pkmodes.core.system.evaluation import Evaluation, may_be_refused, number_of_modes
from pkmodes.sensitivity.modes import ROUNDING, separate
from pkmodes.sensitivity.terms import RATES

Array = NDArray[np.float64]


def rates_job(
    solver: Solver,
    system: Evaluation,
    source: str,
    terms: Terms,
    close: float,
    asked: Sequence[str],
    by_numpy: Callable[[Array], Mapping[str, Array]],
) -> Job:
    """Return the job that evaluates derivatives of eigenvalues and frequencies.

    Parameters
    ----------
    solver : Solver
        That differentiates.
    system : Evaluation
        Of the robot.
    source : str
        The robot, for messages.
    terms : Terms
        Of T paths.
    close : float
        As for `pkmodes.Model.sensitivities`.
    asked : sequence of str
        Fields.
    by_numpy : callable
        Evaluates the fields at some poses, (n, d).
    """
    modes = number_of_modes(system)

    def compute(points: Array, rows: Mapping[str, Array], threads: int) -> Codes:
        at = RobotAtPoses(system, points, source, {})
        if not rows:
            return solver.compute(at, rows, threads)
        eigenvalues = np.empty((len(points), modes))
        written = {RATES[name]: array for name, array in rows.items()}
        codes = solver.rates(at, {**written, EIGENVALUES: eigenvalues}, terms, threads)
        for start in range(0, len(codes), CHUNK):
            part = slice(start, start + CHUNK)
            together = _coincide(eigenvalues[part], system, close, "eigenvalues" in asked)
            codes[part][(codes[part] == 0) & together] = UNSOLVED
        return codes

    tail = (len(terms.first) - 1, modes)
    return Job(
        tails=dict.fromkeys(asked, (tail, "f8")),
        known=codes_of(system.mechanism),
        compute=compute,
        by_numpy=by_numpy,
        checks_poses=True,
        refusable=may_be_refused(system),
    )


def _coincide(eigenvalues: Array, system: Evaluation, close: float, of_zero: bool) -> NDArray[np.bool_]:
    """Return where modes form a group; with `of_zero` also of those whose frequency is zero to rounding."""
    sizes = magnitude(eigenvalues, system.first, system.rigid_modes, system.held_motions)
    together = ~separate(eigenvalues, close, sizes)
    if not of_zero:
        moving = np.abs(eigenvalues) > ROUNDING * sizes
        together &= moving[:, 1:] | moving[:, :-1]
    return np.asarray(together.any(axis=1))
