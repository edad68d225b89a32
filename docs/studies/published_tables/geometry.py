"""The declared robot with unknown geometry, and the poses of the tables.

Only the difference between the rail and the joint of an axis enters the model.  The geometry therefore has three
unknowns: the distance of rails 2 and 3 from their joints across the rails, the distance by which rail 1 starts ahead,
and the height of the plane.  Here joints 2 and 3 and the start of rails 2 and 3 are placed at x = 0; the positions of
rails and joints in the robot file are a choice, made in `in_robot_file`.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, fields, replace

import numpy as np

import pkmodes
from printed import Array

#: The middle carriage ahead of the platform and the outer two behind it; and all on the same side.
OPPOSITE, SAME = (1.0, -1.0, -1.0), (1.0, 1.0, 1.0)


@dataclass(frozen=True)
class Geometry:
    """Geometry that the paper leaves open [m].

    Attributes
    ----------
    span : float
        max(x_j) - min(x_j).
    across : float
        Distance from rails 2 and 3 to their joints, along y.
    offset : float
        min(x_1) - min(x_2) - (joint_1x - joint_2x).
    z : float
        Height of the plane above the rails, minus the height of the joints above the platform's centre.
    first, step : float
        Point k of the grid is at x_p = first + k step, measured from min(x_2) and with joint_2x = 0.
    sides : tuple of float
        Branch of each axis.
    instead : mapping
        Values that replace declared ones, by name of the generated parameter.
    """

    span: float
    across: float
    offset: float
    z: float
    first: float
    step: float
    sides: tuple[float, ...] = OPPOSITE
    instead: Mapping[str, float] = field(default_factory=dict)

    def moved(self, **values: float) -> Geometry:
        """Return the geometry with other values of unknowns or declared parameters."""
        own = {f.name: values.pop(f.name) for f in fields(self) if f.name in values}
        return replace(self, **own, instead={**self.instead, **values})

    def value(self, name: str, declared: pkmodes.Robot) -> float:
        """Return the current value of an unknown or a declared parameter (of axis 1; vertical gravity)."""
        if name in self.__dataclass_fields__:
            return float(getattr(self, name))
        known = np.ravel(getattr(declared.parameters, name))
        return float(self.instead.get(name, known[2] if name == "gravity" else known[0]))

    def robot(self, declared: pkmodes.Robot) -> pkmodes.Robot:
        """Return the declared robot with this geometry."""
        p = declared.parameters
        origin, joint = np.array(p.origin), np.zeros((3, 3))
        origin[:, 1] = np.sign(origin[:, 1]) * self.across
        joint[0, 0] = -self.offset
        changed = {name: np.full_like(getattr(p, name), value) for name, value in self.instead.items()}
        if "gravity" in changed:
            changed["gravity"] = np.array([0.0, 0.0, self.instead["gravity"]])
        limits, branch = np.tile([0.0, self.span], (3, 1)), np.array(self.sides)
        parameters = p._replace(origin=origin, joint=joint, limits=limits, branch=branch, **changed)
        return replace(declared, parameters=parameters)

    def poses(self, index: Array) -> Array:
        """Return points of the grid on the centre line, (N, 3)."""
        x = self.first + self.step * np.asarray(index, dtype=float)
        return np.column_stack([x, np.zeros_like(x), np.full_like(x, self.z)])

    def modes(self, declared: pkmodes.Robot, index: Array) -> tuple[Array, Array]:
        """Compute frequencies (N, 6) [Hz] and shapes (N, 6, 9) of vibration modes 1 to 6; NaN out of reach."""
        found = pkmodes.Model(self.robot(declared)).modes(self.poses(index), on_error="nan")
        return found.frequencies[:, found.rigid_modes :], found.shapes[:, found.rigid_modes :]

    def reaches(self, declared: pkmodes.Robot) -> tuple[float, float]:
        """Return how far carriage 1 is ahead of the platform along x, and 2 and 3 behind it (branch +1 -1 -1)."""
        squared = float(declared.parameters.link_length[0]) ** 2 - self.z**2
        return float(np.sqrt(squared)), float(np.sqrt(squared - self.across**2))

    def mirrored(self, declared: pkmodes.Robot) -> Geometry:
        """Swap all sides, with rails and poses moved so that the carriages stay in place."""
        ahead, behind = (self.sides[0] * reach for reach in self.reaches(declared))
        return replace(
            self,
            sides=tuple(-side for side in self.sides),
            offset=self.offset - 2.0 * (ahead + behind),
            first=self.first - 2.0 * behind,
        )


def joint_radius(across: float, apart: float) -> float:
    """Compute the radius of the circle of the platform's joints, if they are at 0 and +-120 degrees.

    Parameters
    ----------
    across : float
        Distance from rails 2 and 3 to their joints [m].
    apart : float
        Distance from rails 2 and 3 to rail 1, l_r [m].
    """
    return (apart - across) / np.sin(np.pi / 3.0)


def in_robot_file(found: Geometry, radius: float) -> tuple[Array, Array, float]:
    """Return joints (3, 3), limits (3, 2) and x of point 0 in the frame of the robot file [m].

    The joints are on a circle, each facing its carriage; rails 2 and 3 start at x = 0.
    """
    angle = np.radians([0.0, -120.0, 120.0])
    joint = radius * np.column_stack([np.cos(angle), np.sin(angle), np.zeros(3)])
    begin = np.array([found.offset + joint[0, 0] - joint[1, 0], 0.0, 0.0])
    return joint, np.column_stack([begin, begin + found.span]), found.first - float(joint[1, 0])
