"""One robot's matrices from the generated model: the base model, or the extended one where effects are active.

Effects whose parameters are all at their null value are not there: their coordinates are locked, and the
base model evaluates the robot.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from pkmodes_generated import linear_delta as generated
from pkmodes_generated.linear_delta import Parameters

Array = NDArray[np.float64]


class Evaluation(Protocol):
    """What the solver needs of a robot.

    Attributes
    ----------
    coordinates : tuple of str
        Names of the n generalised coordinates.
    rigid_modes : int
        Modes that strain nothing elastic.
    """

    coordinates: tuple[str, ...]
    rigid_modes: int

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""


class BaseEvaluation:
    """The base model: nine coordinates."""

    def __init__(self, parameters: Parameters) -> None:
        self._parameters = parameters
        self.coordinates: tuple[str, ...] = generated.COORDINATES
        self.rigid_modes: int = generated.RIGID_MODES

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""
        M, K = generated.modal_matrices(p, self._parameters)
        return M, K

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""
        motion = np.zeros((*p.shape, len(self.coordinates)))
        motion[..., :3] = generated.platform_jacobian(p, self._parameters)
        return motion

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""
        torques, rotations = generated.static_equilibrium(p, self._parameters)
        return torques, rotations


class ExtendedEvaluation:
    """The extended model with the coordinates of the released joints that are not locked."""

    def __init__(self, parameters: Parameters, effects: Mapping[str, float]) -> None:
        from pkmodes_generated.linear_delta import extended

        self._generated, self._parameters = extended, parameters
        self._effects = extended.Effects(**{path.replace(".", "_"): value for path, value in effects.items()})
        with np.errstate(divide="ignore"):
            stiffness, _ = extended.joint_stiffness(self._effects)
        base = len(generated.COORDINATES)
        free = np.isfinite(stiffness)  # a joint without compliance is infinitely stiff: locked
        self._index = np.concatenate([np.arange(base), base + np.flatnonzero(free)])
        self._joints = np.concatenate([np.zeros(base), stiffness[free]])
        self.coordinates = tuple(extended.COORDINATES[i] for i in self._index)
        active = active_effects(effects)
        grounded = any(grounds and name in active for name, _, grounds, *_ in extended.EFFECTS)
        self.rigid_modes = 0 if grounded else generated.RIGID_MODES

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""
        M, K_el, K_g = self._generated.extended_matrices(p, self._parameters, self._effects)
        K = K_el + K_g
        rows, columns = np.ix_(self._index, self._index)
        K = K[..., rows, columns]
        diagonal = np.arange(len(self._index))
        K[..., diagonal, diagonal] += self._joints
        return M[..., rows, columns], K

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""
        motion = self._generated.extended_platform_motion(p, self._parameters)
        found: Array = motion[..., self._index]
        return found

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""
        torques, rotations = self._generated.extended_static_equilibrium(p, self._parameters, self._effects)
        return torques, rotations


def active_effects(effects: Mapping[str, float]) -> tuple[str, ...]:
    """Names of the effects that are not null; constants such as a frame's mass make none active."""
    if not effects:
        return ()
    from pkmodes_generated.linear_delta import extended

    return tuple(
        name
        for name, *_, described in extended.EFFECTS
        if any(
            fitted and effects.get(f"{name}.{parameter}", 0.0) != 0.0 for parameter, *_, fitted in described
        )
    )


def evaluation(parameters: Parameters, effects: Mapping[str, float]) -> Evaluation:
    """Choose the model: the base one when every effect is null."""
    return ExtendedEvaluation(parameters, effects) if active_effects(effects) else BaseEvaluation(parameters)
