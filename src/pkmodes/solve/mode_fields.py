"""Fields of one robot at poses: those that its solver fills, and those that follow from them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.dataset.fields import FIELDS, missing, sizes_of, tail
from pkmodes.mechanism.poses import CHUNK
from pkmodes.solve.at_poses import RobotAtPoses
from pkmodes.solve.backends import solver_of
from pkmodes.solve.batch import Job, Rows
from pkmodes.solve.numpy_solver import NumpySolver
from pkmodes.solve.solver import EIGENVALUES, SHAPES, Codes, Solver
from pkmodes.system.evaluation import Evaluation, may_be_refused, number_of_modes
from pkmodes.system.motors import MotorsHeld
from pkmodes.system.strain_free import strain_free_motions

Array = NDArray[np.float64]
#: Poses for which quantities are kept that are not among the fields, for each thread.
PART = 4800


class ModeFields:
    """How a solver and NumPy evaluate some fields of a robot.

    Parameters
    ----------
    solved : Evaluation
        The system that the solver solves: that of the robot, or the one with held motors.
    source : str
        The robot, for messages.
    names : iterable of str
        Of `pkmodes.dataset.fields.FIELDS`.
    given : mapping of str to object
        Quantities that fields need and a robot does not have, such as the normal of a plane.
    """

    def __init__(
        self,
        solver: Solver,
        system: Evaluation,
        solved: Evaluation,
        source: str,
        names: Iterable[str],
        given: Mapping[str, Any],
    ) -> None:
        self._solver, self._system, self._solved = solver, system, solved
        self._source, self._given = source, {**_given_by_motors(system, solved), **given}
        self._names = tuple(names)
        self._derived = [name for name in self._names if name not in solver.fields]
        self._needed = _needed(self._derived, solver.fields) - {*self._names}
        modes = number_of_modes(solved)
        sizes = sizes_of(system.mechanism, modes, len(system.coordinates))
        fields = {name: FIELDS[name] for name in (*self._names, *self._needed) if name in FIELDS}
        self._tails = {name: (tail(field, sizes), field.dtype) for name, field in fields.items()}
        self._tails[EIGENVALUES] = (modes,), "f8"
        of_modes = _needed(self._names, frozenset({EIGENVALUES, SHAPES}))
        self._refusable = bool(of_modes) and may_be_refused(solved)

    def job(self, threads: int) -> Job:
        """Return the job that evaluates the fields."""
        return Job(
            tails={name: self._tails[name] for name in self._names},
            compute=lambda points, rows: self.compute(points, rows, threads),
            by_numpy=self.by_numpy,
            checks_poses=self._solver.checks_poses,
            refusable=self._refusable,
        )

    def compute(self, points: Array, rows: Rows, threads: int) -> Codes:
        """Fill the fields at poses, all or none of them, and return the codes."""
        if not rows or not self._needed:
            return self._part(points, rows, threads)
        codes = np.empty(len(points), dtype=np.int8)
        for start in range(0, len(points), PART * threads):
            part = slice(start, start + PART * threads)
            codes[part] = self._part(
                points[part], {name: array[part] for name, array in rows.items()}, threads
            )
        return codes

    def by_numpy(self, points: Array) -> Rows:
        """Return the fields at poses, solved by NumPy."""
        numpy = self
        if self._solver.name != NumpySolver.name:
            solver = solver_of(self._solved, np.inf, NumpySolver.name)
            numpy = ModeFields(solver, self._system, self._solved, self._source, self._names, self._given)
        rows = {name: _empty(len(points), *self._tails[name]) for name in self._names}
        numpy.compute(points, rows, 1)
        return rows

    def _part(self, points: Array, rows: Rows, threads: int) -> Codes:
        at = RobotAtPoses(self._system, points, self._source, self._given)
        filled = {name: array for name, array in rows.items() if name in self._solver.fields}
        if rows:
            for name in self._needed:
                filled[name] = _empty(len(points), *self._tails[name])
        if filled or self._solver.checks_poses:
            codes = self._solver.compute(at, filled, threads)
        else:
            codes = np.zeros(len(points), dtype=np.int8)
        if rows and self._derived:
            self._derive(at, filled, rows, codes)
        return codes

    def _derive(self, at: RobotAtPoses, filled: Rows, rows: Rows, codes: Codes) -> None:
        """Fill the fields that follow from those of the solver; NaN where there are none."""
        if not codes.any() and len(codes) <= CHUNK:  # `at` may have matrices already
            at.known.update(filled)
            for name in self._derived:
                rows[name][...] = at[name]
            return
        for name in self._derived:
            rows[name][codes != 0] = missing(rows[name].dtype)
        good = np.flatnonzero(codes == 0)
        for start in range(0, len(good), CHUNK):
            some = good[start : start + CHUNK]
            known = {**self._given, **{name: array[some] for name, array in filled.items()}}
            part = RobotAtPoses(self._system, at.points[some], self._source, known)
            for name in self._derived:
                rows[name][some] = part[name]


def _given_by_motors(system: Evaluation, solved: Evaluation) -> dict[str, Any]:
    """Return what fields need to know of the motors.

    Returns
    -------
    dict of str to object
        ``rigid_modes``, the number of rigid modes; ``strain_free_motions``, from N poses the motions of all
        coordinates, None with free motors; ``kept``, all coordinates per unit of those that remain with held motors,
        (n, r), None with free motors or if a motion remains that nothing elastic resists.
    """
    given: dict[str, Any] = {"rigid_modes": solved.rigid_modes, "strain_free_motions": None, "kept": None}
    if isinstance(solved, MotorsHeld):
        given["strain_free_motions"] = partial(strain_free_motions, system)
        given["kept"] = None if solved.rigid_modes else solved.motions()[0]
    return given


def _empty(count: int, shape: tuple[int, ...], dtype: str) -> Array:
    return np.empty((count, *shape), dtype)


def _needed(names: Iterable[str], fields: frozenset[str]) -> frozenset[str]:
    """Return which of a solver's fields some names need, directly or through others."""
    needed: set[str] = set()
    for name in names:
        if name in fields:
            needed.add(name)
        elif name in FIELDS:
            needed |= _needed((one for one in FIELDS[name].needs if one != name), fields)
    return frozenset(needed)
