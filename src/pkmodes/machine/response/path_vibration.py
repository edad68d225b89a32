r"""Vibrations along a path: integration of the modes while the pose changes.

The motors are held to the command, or are driven through springs whose other ends follow it.  The platform follows
its commanded pose p except for a deviation delta, the sum of the modes: with the motion r of all coordinates that
moves or turns the platform by 1 and strains nothing,

.. math:: \ddot\eta + D \dot\eta + \Lambda \eta = -\Phi^T M r \, \ddot p - \Phi^T C_v r \, \dot p , \qquad
    \delta = J_p \Phi \eta ,

where :math:`\Lambda`, :math:`\Phi`, M, r and D are those at the current commanded pose, and the modes those of
held motors, or of motors on springs: the ends of these move with r, so that :math:`\Phi \eta` alone strains them.  D
contains the viscous friction, the damping ratio, and the loss factors as in `pkmodes.core.linalg.damping`.  Ratio and
loss factors damp the vibration alone, friction resists the move too.  Forces that grow with the square of the speed
are left out.  Where the platform turns, the velocity includes the angular velocity about base axes, and the deviation
small rotations about them.

Between samples the command is a straight line, so that its acceleration is an impulse, a velocity jump, at each
sample.  Every sample's matrices hold for half an interval before and after it; in between, displacements
:math:`y = \Phi \eta` and momenta :math:`M \dot y` continue.  This transformation is canonical, so that a slow
change of the pose conserves the action of the vibration, its energy over its frequency.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from pkmodes.core.linalg.rotations import AXES, matrices_of_vectors, vectors_about, vectors_of_matrices
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.system.strain_free import strain_free_motions
from pkmodes.machine.response.linearised import LinearisedRobot

Array = NDArray[np.float64]
#: Samples whose matrices are held in memory at a time.
SAMPLES_AT_ONCE = 2000
#: A mode is quasi-static (follows without vibrating) above both this phase advance per sample [rad] and this
#: frequency [rad/s].
QUASI_STATIC_PHASE, QUASI_STATIC_FREQUENCY = 1e3, 1e4
#: Time steps that differ by less than this fraction are equal.
STEP_TOLERANCE = 1e-9


def deviation_along(model: Model, time: Array, poses: Array, drives: str) -> Array:
    """Return the deviation of the platform from its commanded pose, (T, d); the machine starts at rest.

    - model: model of a robot without rigid modes
    - time: ascending, (T,) [s]
    - poses: the command, in the workspace, (T, d); only components of the platform's motion change
    - drives: what the motors do, "free" or "held"; free ones hang on springs
    """
    mechanism = model.robot.mechanism
    names = [component.name for component in mechanism.pose]
    platform_indices = [names.index(name) for name in mechanism.components]
    durations = np.diff(time)
    if np.ptp(durations) <= STEP_TOLERANCE * durations.max():
        # Remove rounding, so that equal steps are computed once.
        durations = np.full_like(durations, durations.mean())
    at_rest = np.zeros((1, len(platform_indices)))
    velocities = _displacements(poses[:, platform_indices], mechanism) / durations[:, None]
    velocity = np.vstack([at_rest, velocities])  # before each sample
    jumps = np.diff(velocity, axis=0, append=velocity[-1:])
    deviation, state = np.zeros_like(poses), None
    for start in range(0, len(time), SAMPLES_AT_ONCE):
        first_sample, stop = max(start - 1, 0), min(start + SAMPLES_AT_ONCE, len(time))
        vibration = _Vibration(model, poses[first_sample:stop], float(durations.min()), drives)
        steps = vibration.steps(durations[first_sample : stop - 1], velocity[first_sample + 1 : stop])
        kicks = np.einsum("smj,sj->sm", vibration.kick, jumps[first_sample:stop])
        if state is None:
            state = np.concatenate([np.zeros(vibration.modes), kicks[0]])
        displacements = np.zeros((stop - first_sample, vibration.modes))
        for i, (transition, drag) in enumerate(zip(*steps, strict=True), start=1):
            state = transition @ state + drag
            displacements[i] = state[: vibration.modes]
            state[vibration.modes :] += kicks[i]
        deviation[first_sample + 1 : stop, platform_indices] = np.einsum(
            "sdm,sm->sd", vibration.platform[1:], displacements[1:]
        )
    return deviation


def _displacements(path: Array, mechanism: Mechanism) -> Array:
    """Return how the platform moves between samples: displacements, and rotations about base axes, (T - 1, d).

    - path: the components of the platform's motion in its pose, (T, d): those of a rotation vector come last
    """
    displacements = np.diff(path, axis=0)
    if mechanism.rotations:
        first_rotation = len(mechanism.directions)
        rotations = matrices_of_vectors(vectors_about(mechanism.rotations, path[:, first_rotation:]))
        rotation_vectors = vectors_of_matrices(rotations[1:] @ np.swapaxes(rotations[:-1], -1, -2))
        displacements[:, first_rotation:] = rotation_vectors[
            :, [AXES.index(axis) for axis in mechanism.rotations]
        ]
    return displacements


class _Steps(NamedTuple):
    """State transitions from just after each sample to just before the next one.

    - transition: transition matrices of the displacements and velocities of the modes, (S - 1, 2 m, 2 m)
    - drag: what friction adds that resists the move, (S - 1, 2 m)
    """

    transition: Array
    drag: Array


class _Vibration:
    """The vibration at S samples, in m modes, with j components of the motion of the platform.

    - kick: change of the modal velocities per change of the velocity of the command, (S, m, j)
    - platform: motion of the platform per displacement of the modes, (S, j, m)
    """

    def __init__(self, model: Model, poses: Array, step: float, drives: str) -> None:
        # Repeated poses are evaluated once.
        points, inverse = np.unique(poses, axis=0, return_inverse=True)
        self._pose_index = pose_index = np.ravel(inverse)
        linearised = LinearisedRobot(model, points, drives, AUTO)
        shapes, M, viscous = linearised.own_shapes, linearised.matrices[0], linearised.dissipation[0]
        names = model.system.coordinates
        strain_free = strain_free_motions(model.system, points)
        solved_motion, motors = (
            strain_free[:, [names.index(name) for name in linearised.system.coordinates]],
            linearised.motors @ strain_free,
        )
        m = self.modes = shapes.shape[1]
        drag = -shapes @ (viscous.solved @ solved_motion + viscous.prescribed @ motors)
        # The states are modal displacements, modal velocities and the velocity of the command.
        D, eigenvalues = linearised.damping.matrix.copy(), linearised.eigenvalues
        limit = max(QUASI_STATIC_PHASE / step, QUASI_STATIC_FREQUENCY) ** 2
        fast = eigenvalues > limit
        D[fast[:, :, None] | fast[:, None, :]] = 0.0
        size, i = 2 * m + drag.shape[-1], np.arange(m)
        A = np.zeros((len(D), size, size))
        A[:, i, m + i] = 1.0
        A[:, m + i, i] = -np.minimum(eigenvalues, limit)
        A[:, m : 2 * m, m : 2 * m] = -D
        A[:, m + i, m + i] -= np.where(fast, 2.0 * np.sqrt(limit), 0.0)
        A[:, m : 2 * m, 2 * m :] = drag
        self._state_matrices = A
        self.kick = -(shapes @ (M.solved @ solved_motion + M.prescribed @ motors))[pose_index]
        self.platform = (linearised.platform @ linearised.kept @ np.swapaxes(shapes, -1, -2))[pose_index]
        behind, ahead = shapes[pose_index[:-1]], shapes[pose_index[1:]]
        inertia = M.solved[pose_index]
        self._displacement_transfer = ahead @ inertia[1:] @ np.swapaxes(behind, -1, -2)
        self._momentum_transfer = ahead @ inertia[:-1] @ np.swapaxes(behind, -1, -2)

    def steps(self, duration: Array, velocity: Array) -> _Steps:
        """Return the steps between samples.

        - duration: duration of each step [s], (S - 1,)
        - velocity: velocity of the command, (S - 1, j)
        """
        n = 2 * self.modes
        # Each sample ends one interval and begins the next: equal halves are computed once.
        pose_index = np.concatenate([self._pose_index[:-1], self._pose_index[1:]])
        pairs, inverse = np.unique(
            np.column_stack([pose_index, np.tile(0.5 * duration, 2)]), axis=0, return_inverse=True
        )
        transitions = expm(self._state_matrices[pairs[:, 0].astype(int)] * pairs[:, 1, None, None])
        first_half, second_half = np.split(np.asarray(transitions)[np.ravel(inverse)], 2)
        transfer = np.zeros((len(first_half), n, n))
        transfer[:, : self.modes, : self.modes] = self._displacement_transfer
        transfer[:, self.modes :, self.modes :] = self._momentum_transfer
        transfer_and_second_half = second_half[:, :n, :n] @ transfer
        drag = transfer_and_second_half @ first_half[:, :n, n:] + second_half[:, :n, n:]
        return _Steps(
            transfer_and_second_half @ first_half[:, :n, :n], np.einsum("snj,sj->sn", drag, velocity)
        )
