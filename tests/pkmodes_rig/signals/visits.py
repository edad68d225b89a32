"""In which state a machine is when it is measured: the pose as it was approached, and its belts and reducers."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pkmodes_rig.engine import TrueModes
from pkmodes_rig.signals.small_motion import Losses, SmallMotion, small_motion

#: Parameters that carry the stiffness of a transmission, one for each axis, by name; the first that a machine has.
STIFFNESSES = ("belt_specific_stiffness", "reducer_stiffness")
#: Relative change of them for the share of the strain energy that they hold.
STEP = 0.01

Rig = Callable[..., TrueModes]


@dataclass(frozen=True, eq=False)
class Machine:
    """A machine on the rig.

    Attributes
    ----------
    rig : callable
        Returns the true modes for parameters, pose, effects and outside causes.
    parameters : Parameters
        True values.
    effects, outside : mapping of str to float
        As for `pkmodes_rig.true_modes`.
    losses : Losses
        Its `factor` is that of belts or reducers.
    held : bool
        Whether the motors are held.
    """

    rig: Rig
    parameters: Any
    effects: Mapping[str, float] = field(default_factory=dict)
    outside: Mapping[str, float] = field(default_factory=dict)
    losses: Losses = field(default_factory=Losses)
    held: bool = False

    def modes(self, pose: np.ndarray, stiffer: np.ndarray | float = 0.0) -> TrueModes:
        """Return the undamped modes, with the transmission of each axis stiffer by these shares."""
        name = stiffness_of(self.parameters)
        changed = np.asarray(getattr(self.parameters, name)) * (1.0 + np.asarray(stiffer))
        parameters = self.parameters._replace(**{name: changed})
        return self.rig(parameters, pose, self.effects, self.outside, held=self.held)

    def at(self, visit: Visit) -> SmallMotion:
        """Return its small motion about the pose of a visit."""
        modes = self.modes(visit.pose, visit.stiffer)
        shares = None
        if self.losses.factor:
            more, less = (self.modes(visit.pose, visit.stiffer + one) for one in (STEP, -STEP))
            squares = [np.sign(m.frequencies) * m.frequencies**2 for m in (more, less, modes)]
            shares = (squares[0] - squares[1]) / (2.0 * STEP * np.where(squares[2], squares[2], 1.0))
            shares = np.clip(shares, 0.0, 1.0)
        return small_motion(modes, self.losses, shares)


@dataclass(frozen=True, eq=False)
class Visit:
    """The state in which a record is measured: the pose [m], and how much stiffer the axes are, shape (axes,)."""

    pose: np.ndarray
    stiffer: np.ndarray


@dataclass(frozen=True)
class Wander:
    """How the state of a machine differs from that at rest in the morning.

    Attributes
    ----------
    approach : float
        Scatter of the frequencies from one approach to the next, relative: belts and reducers settle anew.
    place : float
        Scatter of the pose [m].
    warming : float
        Relative loss of stiffness over the whole campaign, as the room warms up.
    """

    approach: float = 0.002
    place: float = 0.0
    warming: float = 0.0

    def visits(
        self, machine: Machine, poses: np.ndarray, repeats: int, rng: np.random.Generator
    ) -> list[list[Visit]]:
        """Return the state at each repeat at each pose: approached once, measured while the room warms."""
        axes = len(np.atleast_1d(getattr(machine.parameters, stiffness_of(machine.parameters))))
        found, total = [], max(1, len(poses) * repeats - 1)
        for i, pose in enumerate(poses):
            reached = pose + self.place * rng.standard_normal(len(pose))
            # A frequency varies as the square root of the stiffness.
            settled = 2.0 * self.approach * rng.standard_normal(axes)
            found.append(
                [Visit(reached, settled - self.warming * (i * repeats + k) / total) for k in range(repeats)]
            )
        return found


def stiffness_of(parameters: Any) -> str:
    """Return the name of the parameter that carries the stiffness of the transmissions."""
    return next(name for name in STIFFNESSES if name in parameters._fields)
