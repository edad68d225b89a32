"""Points, motions and springs of one robot, from the functions generated for the drawing of its mechanism."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes_description import Named

Array = NDArray[np.float64]
#: A direction counts as vertical below this sine of its angle to the vertical; upright then means outwards.
VERTICAL = 0.3
Z = (0.0, 0.0, 1.0)


class Springs(NamedTuple):
    """The springs that a robot has: names, stiffnesses (N, S), and elongation or twist by coordinate (N, S, n)."""

    named: tuple[Named, ...]
    stiffness: Array
    strain: Array


class RobotDrawing:
    """The drawing of one robot.

    - drawing: elements, and the motion that each point has
    - coordinates: names of the robot's coordinates, released joints included
    - vertical: unit vector against gravity, (3,); z without gravity
    """

    def __init__(self, robot: Robot) -> None:
        mechanism = robot.mechanism
        self.drawing = mechanism.drawing
        self._mechanism, self._system = mechanism, ExtendedSystem.of(robot)
        self.coordinates = self._system.coordinates
        self._generated = Generated(mechanism.drawn, robot.parameters, self._system.effects)
        gravity = np.asarray(getattr(robot.parameters, "gravity", np.zeros(3)), dtype=float)
        size = float(np.linalg.norm(gravity))
        self.vertical = -gravity / size if size > 0.0 else np.array(Z)

    def points(self, p: Array) -> Array:
        """Return the positions of the points, (N, points, 3) [m]; the first is the platform."""
        return np.asarray(self._generated.drawing_points(p, *self._upright(p)), dtype=float)

    def motions(self, p: Array) -> Array:
        """Return the Jacobians with respect to the coordinates, (N, motions, 3, n); points share them."""
        motions = np.asarray(self._generated.drawing_motion(p, *self._upright(p)), dtype=float)
        return motions[..., self._system.free]

    def springs(self, p: Array) -> Springs:
        """Return the springs of the model and of the released joints, zero stiffness included."""
        stiffness, strain = (np.asarray(a, dtype=float) for a in self._generated.springs(p))
        free, first = self._system.free, self._system.base_count
        released = [c for effect in self._mechanism.effects.values() for c in effect.coordinates]
        joints = [i for i in free if i >= first]
        named = []
        for name in self.coordinates[first:]:
            joint = next(c for c in released if c.name == name)
            symbol = "N m/rad" if joint.unit == "rad" else "N/m"
            named.append(Named(joint.description, symbol, f"released joint {name}"))
        unit = np.broadcast_to(np.eye(len(free))[first:], (len(p), len(joints), len(free)))
        joint_stiffness = np.broadcast_to(self._system.joints[joints], (len(p), len(joints)))
        return Springs(
            (*self.drawing.springs, *named),
            np.concatenate([stiffness, joint_stiffness], axis=1),
            np.concatenate([strain[..., free], unit], axis=1),
        )

    def motors(self, p: Array) -> Array:
        """Return the centres of the wheels that motors drive, (N, motors, 3) [m]."""
        driven = np.asarray(self._generated.driven()).ravel() > 0.5
        names = {
            q.name for q, is_driven in zip(self._mechanism.coordinates, driven, strict=True) if is_driven
        }
        wheels = [e.points[0] for e in self.drawing.elements if e.shape == "wheel" and e.turns in names]
        return self.points(p)[:, wheels]

    def _upright(self, p: Array) -> tuple[Array, ...]:
        """Return the argument `up` of the generated functions, none if the robot leaves no direction open."""
        if not self.drawing.uprights:
            return ()
        generated = np.asarray(self._generated.drawing_directions(p), dtype=float)
        uprights = [
            upright(directions, places, self.vertical)
            for directions, places in zip(generated[:, :, 0], generated[:, :, 1], strict=True)
        ]
        return (np.array(uprights).reshape(len(p), -1),)


def upright(directions: Array, places: Array, vertical: Array) -> Array:
    """Choose a unit vector perpendicular to each direction: as upright as possible; outwards for a vertical one.

    - directions, places: unit vectors, and the points [m] where they are used, (k, 3)
    - vertical: (3,)

    Returns (k, 3).
    """
    outwards = places - places.mean(axis=0)
    uprights = []
    for n, out in zip(directions, outwards, strict=True):
        preferences = (vertical, out, *np.eye(3))
        across = [w - (w @ n) * n for w in preferences]
        sizes = [float(np.linalg.norm(a)) for a in across]
        least = [VERTICAL, 1e-9, *([VERTICAL] * 3)]
        chosen = next(i for i, size in enumerate(sizes) if size > least[i])
        uprights.append(across[chosen] / sizes[chosen])
    return np.array(uprights)


def present(springs: Springs) -> tuple[Springs, Sequence[int]]:
    """Return the springs with a stiffness at any pose, and for each spring its index among them, -1 for none."""
    there = (springs.stiffness != 0.0).any(axis=0)
    index = np.where(there, np.cumsum(there) - 1, -1)
    named = tuple(name for name, here in zip(springs.named, there, strict=True) if here)
    return Springs(named, springs.stiffness[:, there], springs.strain[:, there]), index.tolist()
