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
#: A direction counts as vertical if the sine of its angle to the vertical is below this.  Nothing perpendicular to it
#: is upright, and `upright` points outwards instead.
VERTICAL_SINE = 0.3
Z = (0.0, 0.0, 1.0)


class Springs(NamedTuple):
    """The springs that a robot has: names, stiffnesses (N, S), and elongation or twist by coordinate (N, S, n)."""

    descriptions: tuple[Named, ...]
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
        return np.asarray(self._generated.drawing_points(p, *self._up_argument(p)), dtype=float)

    def motions(self, p: Array) -> Array:
        """Return the Jacobians with respect to the coordinates, (N, motions, 3, n); points share them."""
        motions = np.asarray(self._generated.drawing_motion(p, *self._up_argument(p)), dtype=float)
        return motions[..., self._system.free]

    def springs(self, p: Array) -> Springs:
        """Return the springs of the model and of the released joints, zero stiffness included."""
        stiffness, strain = (np.asarray(a, dtype=float) for a in self._generated.springs(p))
        free, first = self._system.free, self._system.base_count
        released = [c for effect in self._mechanism.effects.values() for c in effect.coordinates]
        joints = [i for i in free if i >= first]
        joint_descriptions = []
        for name in self.coordinates[first:]:
            joint = next(c for c in released if c.name == name)
            stiffness_unit = "N m/rad" if joint.unit == "rad" else "N/m"
            joint_descriptions.append(Named(joint.description, stiffness_unit, f"released joint {name}"))
        joint_strain = np.broadcast_to(np.eye(len(free))[first:], (len(p), len(joints), len(free)))
        joint_stiffness = np.broadcast_to(self._system.joints[joints], (len(p), len(joints)))
        return Springs(
            (*self.drawing.springs, *joint_descriptions),
            np.concatenate([stiffness, joint_stiffness], axis=1),
            np.concatenate([strain[..., free], joint_strain], axis=1),
        )

    def motors(self, p: Array) -> Array:
        """Return the centres of the wheels that motors drive, (N, motors, 3) [m]."""
        driven = np.asarray(self._generated.driven()).ravel() > 0.5
        names = {
            q.name for q, is_driven in zip(self._mechanism.coordinates, driven, strict=True) if is_driven
        }
        wheels = [e.points[0] for e in self.drawing.elements if e.shape == "wheel" and e.turns in names]
        return self.points(p)[:, wheels]

    def _up_argument(self, p: Array) -> tuple[Array, ...]:
        """Return the argument `up` of the generated functions; none if all directions follow from the robot."""
        if not self.drawing.uprights:
            return ()
        generated = np.asarray(self._generated.drawing_directions(p), dtype=float)
        uprights = [
            upright(directions, points, self.vertical)
            for directions, points in zip(generated[:, :, 0], generated[:, :, 1], strict=True)
        ]
        return (np.array(uprights).reshape(len(p), -1),)


def upright(directions: Array, points: Array, vertical: Array) -> Array:
    """Choose a unit vector perpendicular to each direction: as upright as possible; outwards for a vertical one.

    - directions, points: unit vectors, and the points [m] where they are used, (k, 3)
    - vertical: (3,)

    Returns (k, 3).
    """
    outwards = points - points.mean(axis=0)
    uprights = []
    for direction, outward in zip(directions, outwards, strict=True):
        preferences = (vertical, outward, *np.eye(3))
        perpendiculars = [preference - (preference @ direction) * direction for preference in preferences]
        lengths = [float(np.linalg.norm(vector)) for vector in perpendiculars]
        min_lengths = [VERTICAL_SINE, 1e-9, *([VERTICAL_SINE] * 3)]
        chosen = next(i for i, length in enumerate(lengths) if length > min_lengths[i])
        uprights.append(perpendiculars[chosen] / lengths[chosen])
    return np.array(uprights)


def springs_with_stiffness(springs: Springs) -> tuple[Springs, Sequence[int]]:
    """Return the springs with a stiffness at any pose, and for each spring its index among these, or -1."""
    has_stiffness = (springs.stiffness != 0.0).any(axis=0)
    index = np.where(has_stiffness, np.cumsum(has_stiffness) - 1, -1)
    descriptions = tuple(
        description
        for description, is_present in zip(springs.descriptions, has_stiffness, strict=True)
        if is_present
    )
    return Springs(
        descriptions, springs.stiffness[:, has_stiffness], springs.strain[:, has_stiffness]
    ), index.tolist()
