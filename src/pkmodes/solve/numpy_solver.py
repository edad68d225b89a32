"""The back end that needs nothing but NumPy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import PoseError
from pkmodes.linalg.eigen import condensed_eigh, natural_frequencies
from pkmodes.solve.at_poses import RobotAtPoses
from pkmodes.solve.solver import EIGENVALUES, SHAPES, Codes, Solver
from pkmodes.system.evaluation import Evaluation

Array = NDArray[np.float64]
#: Eigenvalues have an error of some 1e-16 of the largest.  Below this fraction of the largest, a vibration frequency
#: no longer has nine correct digits.
RESOLVED = 1e-7


class NumpySolver(Solver):
    """Solves the eigenproblem with NumPy, and refuses unphysical systems."""

    name = "numpy"

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Prepare for a robot."""
        return cls()

    def compute(self, at: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill the eigenvalues and shapes.

        Raises
        ------
        PoseError
            As `checked_modes` does.
        """
        both = dict(zip((EIGENVALUES, SHAPES), checked_modes(at), strict=True))
        for name, array in arrays.items():
            array[...] = both[name]
        return np.zeros(len(at.points), dtype=np.int8)


def checked_modes(at: RobotAtPoses) -> tuple[Array, Array]:
    """Return eigenvalues and shapes as `modes_of` does, with its layout in memory.

    Raises
    ------
    PoseError
        If M is not positive definite, the eigenvalues are not finite, or a released joint is so soft that its
        frequency is lost in rounding.
    """
    try:
        eigenvalues, shapes = modes_of(at)
    except np.linalg.LinAlgError:
        raise PoseError(
            "the mass matrix is not positive definite", at.source, "give every moving body a mass"
        ) from None
    _check(eigenvalues, at)
    return eigenvalues, shapes


def modes_of(at: RobotAtPoses) -> tuple[Array, Array]:
    """Return eigenvalues, (N, m), and shapes, (N, m, n), at N valid poses; N may be 0.

    Raises
    ------
    numpy.linalg.LinAlgError
        If M is not positive definite.
    """
    system = at.system
    massless = None if len(at.points) else system.massless()
    return condensed_eigh(at.mass_matrix, at.stiffness_matrix, system.first, system.rigid_modes, massless)


def _check(eigenvalues: Array, at: RobotAtPoses) -> None:
    """Reject eigenvalues that are no frequencies.

    A robot with rigid-body modes has a vibration near zero frequency only if a joint is too soft.
    """
    if not np.isfinite(eigenvalues).all():
        raise PoseError("the eigenvalues are not finite", at.source, "check the robot's magnitudes")
    first, rigid = at.system.first, at.system.rigid_modes
    if not rigid or len(at.system.coordinates) <= first:
        return
    lost = np.abs(eigenvalues[:, rigid]) < RESOLVED * eigenvalues[:, first - 1]
    if lost.any():
        low, high = natural_frequencies(eigenvalues[int(np.argmax(lost)), [rigid, first - 1]])
        raise PoseError(
            f"a joint is so soft that its vibration at {abs(low):.2g} Hz is lost in rounding against {high:.4g} Hz",
            at.source,
            "check the compliances under [effects]: make the joint stiffer",
        )
