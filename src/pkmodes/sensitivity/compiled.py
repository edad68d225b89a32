"""Derivatives of modes from the compiled evaluator, and from NumPy where joints are locked."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import Along
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import Solver
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.sensitivity.matrices import MatrixDerivatives
from pkmodes.sensitivity.paths import ParameterPath
from pkmodes.sensitivity.terms import terms_of_all

Array = NDArray[np.float64]


class CompiledDerivatives(MatrixDerivatives):
    """Derivatives of given modes, evaluated together for all poses, robots and paths.

    Parameters
    ----------
    system, p, paths, matrices
        As for `MatrixDerivatives`.
    along : Along
        Of the modes for which derivatives will be requested.
    """

    def __init__(
        self,
        system: ExtendedSystem,
        p: Array,
        paths: Sequence[Sequence[ParameterPath]],
        matrices: tuple[Array, Array] | None,
        along: Along,
    ) -> None:
        super().__init__(system, p, paths, matrices)
        self._of_modes = along

    def eigenvalues(self, eigenvalues: Array, shapes: Array) -> Array:
        """Return derivatives of simple eigenvalues, (N, m, T)."""
        rates = np.ascontiguousarray(np.swapaxes(self._of_modes.mode_rates, 1, 2))
        self._add_locked(rates, eigenvalues, shapes)
        return rates

    def changes(self, eigenvalues: Array, shapes: Array) -> tuple[Array, Array]:
        """Return (dK - lambda dM) phi, (N, T, m, n), and phi^T dM phi, (N, T, m), along each path."""
        change, norm = self._of_modes.changes, self._of_modes.norms
        for t in self.locked:
            change[:, t], norm[:, t] = self.locked_change(t, eigenvalues, shapes)
        return change, norm

    def motions(self, shapes: Array) -> Array | None:
        """Return the derivatives of the platform's motion in fixed shapes, (N, T, m, directions)."""
        return self._of_modes.motions


def derivatives_of(
    solver: Solver | None,
    systems: Sequence[ExtendedSystem],
    system: ExtendedSystem,
    p: Array,
    paths: Sequence[Sequence[ParameterPath]],
    modes: tuple[Array, Array],
    matrices: tuple[Array, Array] | None,
) -> MatrixDerivatives:
    """Return the derivatives of modes along paths, from a solver if it has them.

    Parameters
    ----------
    solver : Solver, optional
        Of the robots.
    systems : sequence of ExtendedSystem, length B
        The robots.
    system : ExtendedSystem
        The robots as one.
    p, paths, matrices
        As for `MatrixDerivatives`.
    modes : tuple of ndarray, shapes (N, m) and (N, m, n)
        Eigenvalues and shapes.
    """
    along = None
    if solver is not None:
        along = solver.along(RobotAtPoses(system, p, "", {}), *modes, terms_of_all(systems, paths))
    if along is None:
        return MatrixDerivatives(system, p, paths, matrices)
    return CompiledDerivatives(system, p, paths, matrices, along)
