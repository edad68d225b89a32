"""The back end that needs nothing but NumPy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PoseError
from pkmodes.core.linalg.eigen import base_eigenvalue_scale, condensed_eigh, has_stiff_joint
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.regular import regular_poses
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.held_motions import (
    MIN_RESOLVED_RATIO,
    lost_in_rounding,
    refuse_unresolved,
    solve_held,
)
from pkmodes.core.solve.solver import EIGENVALUES, SHAPES, Codes, Solver
from pkmodes.core.system.evaluation import Evaluation, matrices

Array = NDArray[np.float64]


class NumpySolver(Solver):
    """Solves the eigenproblem with NumPy, and refuses unphysical systems."""

    name = "numpy"
    cheap_fields: ClassVar[frozenset[str]] = frozenset({"mass_matrix", "stiffness_matrix"})

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Prepare for a robot."""
        return cls()

    def compute(self, state: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill the eigenvalues and shapes.

        Raises PoseError as `checked_modes` does.
        """
        solution = dict(zip((EIGENVALUES, SHAPES), checked_modes(state), strict=True))
        for name, array in arrays.items():
            array[...] = solution[name]
        return np.zeros(len(state.points), dtype=np.int8)


def checked_modes(state: RobotAtPoses) -> tuple[Array, Array]:
    """Return eigenvalues and shapes as `modes_of` does, with its layout in memory.

    Raises PoseError if M is not positive definite, the eigenvalues are not finite, or a frequency of vibration is
    lost in rounding.
    """
    try:
        eigenvalues, shapes = modes_of(state)
    except np.linalg.LinAlgError:
        raise PoseError(
            "the mass matrix is not positive definite", state.source, "give every moving body a mass"
        ) from None
    if not np.isfinite(eigenvalues).all():
        raise PoseError("the eigenvalues are not finite", state.source, "check the robot's magnitudes")
    system = state.system
    if not len(eigenvalues):
        return eigenvalues, shapes
    if system.held_motions:
        refuse_unresolved(state, eigenvalues, shapes)
        return eigenvalues, shapes
    lowest, highest = eigenvalues[:, system.rigid_modes], eigenvalues[:, -1]
    stiff = has_stiff_joint(eigenvalues, system.base_count, system.rigid_modes)
    if stiff.any():
        highest = np.where(
            stiff,
            base_eigenvalue_scale(state.mass_matrix, state.stiffness_matrix, system.base_count),
            highest,
        )
    lost = np.abs(lowest) < MIN_RESOLVED_RATIO * highest
    if lost.any() and (system.base_count < len(system.coordinates) or _loses_everywhere(system)):
        index = int(np.argmax(lost))
        raise lost_in_rounding(state, lowest[index], highest[index])
    return eigenvalues, shapes


def modes_of(state: RobotAtPoses) -> tuple[Array, Array]:
    """Return eigenvalues, (N, m), and shapes, (N, m, n), at N valid poses; N may be 0.

    Raises numpy.linalg.LinAlgError if M is not positive definite.
    """
    system = state.system
    massless = None if len(state.points) else system.massless
    eigenvalues, shapes = condensed_eigh(
        state.mass_matrix, state.stiffness_matrix, system.base_count, system.rigid_modes, massless
    )
    solve_held(state, eigenvalues, shapes)
    return eigenvalues, shapes


def _loses_everywhere(system: Evaluation) -> bool:
    """Return whether a robot without effects loses vibrations well inside its workspace, too.

    Where a belt span is short, or near a singular pose, a vibration of any robot grows beyond all bounds.
    """
    mechanism, parameters = system.mechanism, system.parameters
    points = regular_poses(Generated(mechanism.model, parameters), mechanism, parameters)
    if not len(points):
        return True
    eigenvalues, _ = condensed_eigh(*matrices(system, points), system.base_count, system.rigid_modes)
    lowest, highest = eigenvalues[:, system.rigid_modes], eigenvalues[:, -1]
    return bool((np.abs(lowest) < MIN_RESOLVED_RATIO * highest).all())
