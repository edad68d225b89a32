r"""Vibrations along a path: integration of the modes while the pose changes.

The motors are held to the command, or hang on springs whose other ends are.  The platform then follows its commanded
pose p but for a deviation delta, which the modes make: with the motion r of all coordinates that moves or turns the
platform by 1 and strains nothing,

.. math:: \ddot\eta + D \dot\eta + \Lambda \eta = -\Phi^T M r \, \ddot p - \Phi^T C_v r \, \dot p , \qquad
    \delta = J_p \Phi \eta ,

where :math:`\Lambda`, :math:`\Phi`, M, r and D are those of the commanded pose of the moment, and the modes those of
held motors, or of motors on springs: the ends of these move with r, so that :math:`\Phi \eta` alone strains them.  D
has the viscous friction, the damping ratio, and the loss factors as in `pkmodes.core.linalg.damping`.  Ratio and loss
factors damp the vibration alone, friction resists the move too.  Forces that grow with the square of the speed are
left out.  Where the platform turns, the velocity has the angular velocity about base axes, and the deviation small
rotations about them.

Between samples the command is a straight line, so that its acceleration is a jump of the velocity at each sample.
Every sample's matrices hold for half an interval before and after it; in between, displacements
:math:`y = \Phi \eta` and momenta :math:`M \dot y` continue.  This transformation is canonical, so that a pose that
changes slowly leaves the vibration its action, energy over frequency.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import expm

from pkmodes.core.linalg.rotations import AXES, about, matrix_of, vector_of
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.system.strain_free import strain_free_motions
from pkmodes.machine.response.linearised import LinearisedRobot

Array = NDArray[np.float64]
#: Samples whose matrices are held in memory at a time.
PART = 2000
#: Angle between two samples [rad], and frequency [rad/s], above which a mode is so fast that it follows without
#: vibrating.
FAST, FASTER = 1e3, 1e4
#: Time steps that differ by less than this fraction are equal.
EQUAL = 1e-9


def deviation_along(model: Model, time: Array, poses: Array, drives: str) -> Array:
    """Return how far the platform is from its commanded pose, at rest at first, (T, d).

    - model: of a robot without rigid modes
    - time: ascending, (T,) [s]
    - poses: the command, in the workspace, (T, d); only components of the platform's motion change
    - drives: what the motors do, "free" or "held"; free ones hang on springs
    """
    mechanism = model.robot.mechanism
    names = [component.name for component in mechanism.pose]
    moving = [names.index(name) for name in mechanism.components]
    steps = np.diff(time)
    if np.ptp(steps) <= EQUAL * steps.max():  # equal steps as equal numbers
        steps = np.full_like(steps, steps.mean())
    still = np.zeros((1, len(moving)))
    moved = _moved(poses[:, moving], mechanism)
    velocity = np.vstack([still, moved / steps[:, None]])  # before each sample
    jumps = np.diff(velocity, axis=0, append=velocity[-1:])
    deviation, state = np.zeros_like(poses), None
    for start in range(0, len(time), PART):
        first, stop = max(start - 1, 0), min(start + PART, len(time))
        at = _Vibration(model, poses[first:stop], float(steps.min()), drives)
        onward = at.steps(steps[first : stop - 1], velocity[first + 1 : stop])
        kicks = np.einsum("smj,sj->sm", at.kick, jumps[first:stop])
        if state is None:
            state = np.concatenate([np.zeros(at.modes), kicks[0]])
        displacements = np.zeros((stop - first, at.modes))
        for i, (step, drag) in enumerate(zip(*onward, strict=True), start=1):
            state = step @ state + drag
            displacements[i] = state[: at.modes]
            state[at.modes :] += kicks[i]
        deviation[first + 1 : stop, moving] = np.einsum("sdm,sm->sd", at.platform[1:], displacements[1:])
    return deviation


def _moved(path: Array, mechanism: Mechanism) -> Array:
    """Return how the platform moves between samples: displacements, and rotations about base axes, (T - 1, d).

    - path: the components of the platform's motion in its pose, (T, d): those of a rotation vector come last
    """
    moved = np.diff(path, axis=0)
    if mechanism.rotations:
        first = len(mechanism.directions)
        turned = matrix_of(about(mechanism.rotations, path[:, first:]))
        between = vector_of(turned[1:] @ np.swapaxes(turned[:-1], -1, -2))
        moved[:, first:] = between[:, [AXES.index(axis) for axis in mechanism.rotations]]
    return moved


class _Steps(NamedTuple):
    """From just after each sample to just before the next one.

    - of_state: what becomes of displacements and rates of the modes, (S - 1, 2 m, 2 m)
    - drag: what friction adds that resists the move, (S - 1, 2 m)
    """

    of_state: Array
    drag: Array


class _Vibration:
    """The vibration at S samples, in m modes, with j components of the motion of the platform.

    - kick: change of the rates per change of the velocity of the command, (S, m, j)
    - platform: motion of the platform per displacement of the modes, (S, j, m)
    """

    def __init__(self, model: Model, poses: Array, step: float, drives: str) -> None:
        # A machine at rest is evaluated once.
        points, of = np.unique(poses, axis=0, return_inverse=True)
        self._of = np.ravel(of)
        at = LinearisedRobot(model, points, drives, AUTO)
        shapes, M, viscous = at.own_shapes, at.matrices[0], at.dissipation[0]
        names = model.system.coordinates
        moved = strain_free_motions(model.system, points)
        solved_motion, motors = (
            moved[:, [names.index(name) for name in at.system.coordinates]],
            at.motors @ moved,
        )
        self.modes = shapes.shape[1]
        self._drag = -shapes @ (viscous.solved @ solved_motion + viscous.prescribed @ motors)
        self._rates(at, step)
        index = self._of
        self.kick = -(shapes @ (M.solved @ solved_motion + M.prescribed @ motors))[index]
        self.platform = (at.platform @ at.kept @ np.swapaxes(shapes, -1, -2))[index]
        behind, ahead = shapes[index[:-1]], shapes[index[1:]]
        inertia = M.solved[index]
        self._positions = ahead @ inertia[1:] @ np.swapaxes(behind, -1, -2)
        self._momenta = ahead @ inertia[:-1] @ np.swapaxes(behind, -1, -2)

    def _rates(self, at: LinearisedRobot, step: float) -> None:
        """Set the matrices of the states' rates: those of displacements, rates and velocities of the command."""
        m, limit = self.modes, max(FAST / step, FASTER) ** 2
        D, eigenvalues = at.damping.matrix.copy(), at.eigenvalues
        fast = eigenvalues > limit
        D[fast[:, :, None] | fast[:, None, :]] = 0.0
        size = 2 * m + self._drag.shape[-1]
        A = np.zeros((len(D), size, size))
        i = np.arange(m)
        A[:, i, m + i] = 1.0
        A[:, m + i, i] = -np.minimum(eigenvalues, limit)
        A[:, m : 2 * m, m : 2 * m] = -D
        A[:, m + i, m + i] -= np.where(fast, 2.0 * np.sqrt(limit), 0.0)
        A[:, m : 2 * m, 2 * m :] = self._drag
        self._A = A

    def steps(self, duration: Array, velocity: Array) -> _Steps:
        """Return the steps between samples.

        - duration: in s, (S - 1,)
        - velocity: of the command, (S - 1, j)
        """
        n = 2 * self.modes
        # Each sample ends one interval and begins the next: equal halves are computed once.
        of = np.concatenate([self._of[:-1], self._of[1:]])
        pairs, where = np.unique(
            np.column_stack([of, np.tile(0.5 * duration, 2)]), axis=0, return_inverse=True
        )
        transitions = expm(self._A[pairs[:, 0].astype(int)] * pairs[:, 1, None, None])
        begin, end = np.split(np.asarray(transitions)[np.ravel(where)], 2)
        across = np.zeros((len(begin), n, n))
        across[:, : self.modes, : self.modes] = self._positions
        across[:, self.modes :, self.modes :] = self._momenta
        onward = end[:, :n, :n] @ across
        drag = onward @ begin[:, :n, n:] + end[:, :n, n:]
        return _Steps(onward @ begin[:, :n, :n], np.einsum("snj,sj->sn", drag, velocity))
