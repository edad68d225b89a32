"""Dissipation of a robot: a damping ratio of every vibration mode, viscous friction, and loss factors of springs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import Evaluation, ExtendedSystem

Array = NDArray[np.float64]


class Dissipation:
    """The damping of one robot.

    - system: the robot with free motors

    Its attributes:
    - ratio: damping ratio of every vibration mode, in addition to what the effects dissipate
    - by_effects: whether any effect dissipates
    """

    def __init__(self, robot: Robot, system: Evaluation) -> None:
        self.ratio, self.by_effects = robot.damping_ratio, robot.effects_dissipate
        self._dissipates = robot.dissipates
        self._size = len(system.coordinates)
        self._system = system if isinstance(system, ExtendedSystem) else ExtendedSystem.of(robot)

    def __bool__(self) -> bool:
        """Whether the robot dissipates anything."""
        return self._dissipates

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """Return C_v [N s/m, N s, N m s] and K'' [N/m, N, N m] in the coordinates of the robot, each (N, n, n)."""
        if not self.by_effects:
            zero = np.zeros((len(p), self._size, self._size))
            return zero, zero
        viscous, loss = self.model_matrices(p)
        return self._system.free_part(viscous), self._system.free_part(loss)

    def model_matrices(self, p: Array) -> tuple[Array, Array]:
        """Return C_v and K'' in all coordinates of the generated model, each (N, e, e)."""
        system = self._system
        functions = system.generated
        viscous, loss = functions.extended_dissipation(p)
        diagonal = np.arange(system.base_count, loss.shape[-1])
        loss[..., diagonal, diagonal] += functions.joint_loss() * system.joints[system.base_count :]
        return viscous, loss
