r"""The equations of small motions of one robot at poses, with everything that a response needs.

.. math:: M \ddot q + (C_v + C_m) \dot q + (K + i K'') q = B u ,

where q are the coordinates of the robot with free motors, and C_m is the damping of a ratio zeta of every mode.  With
held motors their angles are prescribed, and the other coordinates are solved for.
"""

from __future__ import annotations

from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.damping import ModalDamping, modal_damping, uniform_ratio_diagonal
from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes.core.model import Model
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.support.solutions import solve_modes, with_all_coordinates, with_fields
from pkmodes.core.system.motors import MotorsHeld, motor_motion

Array = NDArray[np.float64]
MATRICES, PLATFORM_MOTION = ("mass_matrix", "stiffness_matrix"), "platform_motion"


class Blocks(NamedTuple):
    """Blocks of a matrix at N poses, of the k coordinates that are solved for.

    - solved: (N, k, k)
    - prescribed: forces on these coordinates per unit of each prescribed motor angle, (N, k, drives); 0 where motors
      are free
    """

    solved: Array
    prescribed: Array


class LinearisedRobot:
    """A robot at N poses that can be evaluated, with free or held motors.

    - points: (N, d)

    Its attributes:
    - eigenvalues, own_shapes: modes in the k coordinates that are solved for, (N, m) and (N, m, k)
    - kept, prescribed: the n coordinates per unit of these, and of each motor angle where motors are held, (n, k) and
      (n, drives)
    - massless: which of the k coordinates have no inertia, (k,)
    - rigid: number of rigid modes
    """

    def __init__(self, model: Model, points: Array, drives: str, backend: str) -> None:
        self.model, self.points = model, points
        system = self.system = model.solved(drives)
        self._solver, self._backend = model.solver(backend, drives).inner, backend
        read_too = () if isinstance(system, MotorsHeld) else (*MATRICES, PLATFORM_MOTION)
        self._at = solve_modes(self._solver, system, points, model.robot.source, *read_too)
        self.rigid, self.massless = system.rigid_modes, system.massless
        n, motors = len(model.system.coordinates), len(model.robot.mechanism.drives)
        self.kept, self.prescribed = np.eye(n), np.zeros((n, motors))
        if isinstance(system, MotorsHeld):
            self.kept, self.prescribed = system.kept_and_motor_motions()
        self.eigenvalues, self.own_shapes = self._at["eigenvalues"], self._at["shapes"]
        if rigid := self.rigid:
            # These are from an eigenproblem of their own: otherwise they have the rounding of the largest eigenvalue,
            # which shows at low frequencies.
            self.eigenvalues, self.own_shapes = self.eigenvalues.copy(), self.own_shapes.copy()
            R = self.own_shapes[:, :rigid]
            M, K = (R @ self._at[name] @ np.swapaxes(R, -1, -2) for name in MATRICES)
            self.eigenvalues[:, :rigid], turned = generalised_eigh(M, K)
            self.own_shapes[:, :rigid] = turned @ R

    @cached_property
    def matrices(self) -> tuple[Blocks, Blocks]:
        """M and K."""
        if isinstance(self.system, MotorsHeld):
            at = with_all_coordinates(self._solver, self._at)
            M, K = (self._blocks(self.system, matrix) for matrix in at["all_coordinates"])
        else:
            M, K = (Blocks(self._at[name], self._nothing) for name in MATRICES)
        return M, K

    @cached_property
    def dissipation(self) -> tuple[Blocks, Blocks]:
        """C_v and K''."""
        of, system = self.model.dissipation, self.system
        if not of.by_effects:
            nothing = Blocks(np.zeros((len(self.points), *2 * self.kept.shape[1:])), self._nothing)
            return nothing, nothing
        if isinstance(system, MotorsHeld):
            viscous, loss = (
                self._blocks(system, system.in_basis(matrix)) for matrix in of.model_matrices(self.points)
            )
        else:
            viscous, loss = (Blocks(matrix, self._nothing) for matrix in of.matrices(self.points))
        return viscous, loss

    def _blocks(self, system: MotorsHeld, matrix: Array) -> Blocks:
        """Return the blocks of a matrix in all coordinates of a robot with held motors.

        Without motor inertia and servos, which have no influence: nothing large cancels.
        """
        return Blocks(system.free_part(matrix), matrix[:, system.free[:, None], system.rotors])

    @property
    def _nothing(self) -> Array:
        return np.zeros((len(self.points), self.kept.shape[1], self.prescribed.shape[1]))

    @cached_property
    def rates(self) -> Array:
        """Diagonal damping of the modes by the damping ratio [1/s], (N, m)."""
        return uniform_ratio_diagonal(self.eigenvalues, self.model.dissipation.ratio, self.rigid)

    @cached_property
    def damping(self) -> ModalDamping:
        """Damping in modal coordinates."""
        viscous, loss = self.dissipation
        ratio = self.model.dissipation.ratio
        return modal_damping(
            self.eigenvalues, self.own_shapes, viscous.solved, loss.solved, ratio, self.rigid
        )

    @cached_property
    def motors(self) -> Array:
        """The angle of each motor per unit of each of the n coordinates, (drives, n)."""
        return motor_motion(self.model.system)

    @cached_property
    def platform(self) -> Array:
        """Absolute motion of the platform per unit of each of the n coordinates, (N, components, n)."""
        at, model = self._at, self.model
        if isinstance(self.system, MotorsHeld):
            at = RobotAtPoses(model.system, at.points, model.robot.source, {})
            with_fields(model.solver(self._backend), at, PLATFORM_MOTION)
        motion: Array = at[PLATFORM_MOTION]
        return motion


def nan_in_both_parts(values: NDArray[np.complex128]) -> NDArray[np.complex128]:
    """Return values whose imaginary part is NaN too where the real part is: at poses that cannot be evaluated."""
    return np.where(np.isnan(values), complex(np.nan, np.nan), values)
