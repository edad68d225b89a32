"""How the places of a machine move: MuJoCo moves frame, carriages, arms, links and platform with closed loops.

The engine supplies the velocity of every place for every coordinate, and the acceleration of every place at constant
rates of the coordinates: the second derivatives of its position, on which the stiffness of weight depends.  It has no
masses and no springs here: those are put on its places (`machines`).
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import mujoco
import numpy as np

from pkmodes_rig.mujoco_engine import _add, _mass, carriage_positions
from pkmodes_rig.mujoco_rotary_delta import arm_angles
from pkmodes_rig.mujoco_six_legged import universal

SITE, JOINT, BODY = mujoco.mjtObj.mjOBJ_SITE, mujoco.mjtObj.mjOBJ_JOINT, mujoco.mjtObj.mjOBJ_BODY
UP = np.array([0.0, 0.0, 1.0])
#: Directions of the base frame.
AXES = dict(zip("xyz", np.eye(3), strict=True))
#: Frame, and a coordinate of a bearing that yields.
FRAME, MOUNT = tuple(f"u_{name}" for name in AXES), "mount"


@dataclass(frozen=True)
class Point:
    """How a point moves.

    Attributes
    ----------
    motion : array, shape (3, n)
        Velocity per rate of each coordinate.
    curvature : array, shape (3, n, n)
        Second derivatives of its position.
    """

    motion: np.ndarray
    curvature: np.ndarray

    def combined(self, other: Point, share: float) -> Point:
        """Return the point that lies on the straight line from this one to another one, by its share of the way."""
        return Point(
            (1 - share) * self.motion + share * other.motion,
            (1 - share) * self.curvature + share * other.curvature,
        )


class Linkage:
    """The moving bodies of a machine at one pose.

    Parameters
    ----------
    mechanism : str
    q : Parameters
        One machine, without batch axes.
    p : array
        Pose.
    mount : tuple of (int, str), optional
        The leg whose base bearing yields, from 0, and the direction.
    """

    def __init__(self, mechanism: str, q: Any, p: np.ndarray, mount: tuple[int, str] | None = None) -> None:
        legs = {
            "linear_delta": _on_rails,
            "hexaglide": _on_rails,
            "rotary_delta": _on_arms,
            "hexapod": _extending,
        }
        self.turns = len(p) == 6
        root, self.coordinates = _described(q, np.asarray(p, dtype=float), legs[mechanism], mount)
        self.model = mujoco.MjModel.from_xml_string(ET.tostring(root, encoding="unicode"))
        self.data = mujoco.MjData(self.model)
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        self._count = len(q.joint)
        names = [mujoco.mj_id2name(self.model, SITE, i) for i in range(self.model.nsite)]
        self._sites = {name: i for i, name in enumerate(names)}
        pins = [(self._sites[f"end_{j}"], self._sites[f"joint_{j}"]) for j in range(self._count)]
        if max(np.linalg.norm(self.data.site_xpos[a] - self.data.site_xpos[b]) for a, b in pins) > 1e-10:
            raise ValueError("a link does not reach its platform joint")
        self._pins = pins
        closure = np.vstack([self._velocity(a) - self._velocity(b) for a, b in pins])
        dofs = [self.model.jnt_dofadr[self._id(JOINT, joint)] for joint in self.coordinates.values()]
        self._solved = np.linalg.inv(np.vstack([closure, np.eye(self.model.nv)[dofs]]))
        self._motions = self._solved[:, len(closure) :]
        curved = self._curvatures()
        self.points = {
            name: Point(self._velocity(i) @ self._motions, curved[i]) for name, i in self._sites.items()
        }

    @property
    def names(self) -> tuple[str, ...]:
        """Coordinates."""
        return tuple(self.coordinates)

    def turning(self) -> np.ndarray:
        """Return the angular velocity of the platform per rate of each coordinate, (3, n)."""
        jacobian = np.empty((3, self.model.nv))
        mujoco.mj_jacBody(self.model, self.data, None, jacobian, self._id(BODY, "platform"))
        return np.asarray(jacobian @ self._motions)

    def _curvatures(self) -> np.ndarray:
        """Return the second derivatives of the positions of all sites, (sites, 3, n, n).

        At constant rates of the coordinates the acceleration of a place is a quadratic form in the rates.
        """
        n = len(self.coordinates)
        every = np.array([self._velocity(i) for i in range(self.model.nsite)])

        def acceleration(rates: np.ndarray) -> np.ndarray:
            self.data.qvel[:], self.data.qacc[:] = self._motions @ rates, 0
            mujoco.mj_comVel(self.model, self.data)
            mujoco.mj_rnePostConstraint(self.model, self.data)
            drift = np.array([self._acceleration(i) for i in range(self.model.nsite)])
            apart = np.ravel([drift[a] - drift[b] for a, b in self._pins])
            return np.asarray(drift - every @ (self._solved[:, : len(apart)] @ apart))

        units, found = np.eye(n), np.zeros((self.model.nsite, 3, n, n))
        # All bodies translate with the frame: its own coordinates bend nothing.
        bending = [i for i, name in enumerate(self.coordinates) if name not in FRAME]
        for i in bending:
            found[..., i, i] = acceleration(units[i])
        for a, i in enumerate(bending):
            for k in bending[:a]:
                mixed = acceleration(units[i] + units[k]) - found[..., i, i] - found[..., k, k]
                found[..., i, k] = found[..., k, i] = mixed / 2
        return found

    def _velocity(self, site: int) -> np.ndarray:
        jacobian = np.empty((3, self.model.nv))
        mujoco.mj_jacSite(self.model, self.data, jacobian, None, site)
        return jacobian

    def _acceleration(self, site: int) -> np.ndarray:
        acceleration = np.empty(6)
        mujoco.mj_objectAcceleration(self.model, self.data, SITE, site, acceleration, 0)
        return acceleration[3:]

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        return int(mujoco.mj_name2id(self.model, kind, name))


# Descriptions ------------------------------------------------------------------------------------------------


class _Bodies:
    """Frame and platform, to which the legs of a machine are added."""

    def __init__(self, q: Any, p: np.ndarray, mount: tuple[int, str] | None) -> None:
        self.q, self.p, self.mount = q, p, mount
        self.root = ET.Element("mujoco")
        _add(self.root, "compiler", angle="radian", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
        _add(self.root, "option", gravity=np.zeros(3))
        world = ET.SubElement(self.root, "worldbody")
        self.frame = _body(world, "frame", np.zeros(3))
        for name, axis in AXES.items():
            _slide(self.frame, f"u_{name}", axis)
        self.coordinates: dict[str, str] = {}
        quaternion = np.array([1.0, 0, 0, 0])
        if len(p) == 6 and (angle := float(np.linalg.norm(p[3:]))):
            mujoco.mju_axisAngle2Quat(quaternion, p[3:] / angle, angle)
        platform = _body(world, "platform", p[:3], quat=quaternion)
        if len(p) == 6:
            _add(platform, "freejoint", name="platform")
            _site(platform, "platform_mass", q.platform_center)
        else:
            for name, axis in AXES.items():
                _slide(platform, f"platform_{name}", axis)
        _site(platform, "platform", np.zeros(3))
        #: Joints of the platform in the base frame.
        self.ends = np.empty((len(q.joint), 3))
        for j, joint in enumerate(q.joint):
            _site(platform, f"joint_{j}", joint)
            mujoco.mju_rotVecQuat(self.ends[j], joint, quaternion)
        self.ends += p[:3]

    def bearing(self, j: int, name: str, where: np.ndarray) -> ET.Element:
        """Add the first body of a leg, whose bearing at the frame may yield."""
        body = _body(self.frame, name, where)
        if self.mount is not None and self.mount[0] == j:
            _slide(body, MOUNT, AXES[self.mount[1]])
        return body

    def link(
        self, j: int, parent: ET.Element, at: np.ndarray, begin: np.ndarray, coordinate: str
    ) -> ET.Element:
        """Add a link from a place `at` of its parent, which is `begin` in the base frame, to the platform's joint.

        Returns
        -------
        Element
            The body of the far end, which slides along the link.
        """
        span = self.ends[j] - begin
        rod = universal(parent, f"link_{j}", at, span)
        _mass(rod, 1.0, np.ones(3))
        _site(rod, f"begin_{j}", np.zeros(3))
        _site(rod, f"unit_{j}", UP)
        far = _body(rod, f"far_{j}", float(np.linalg.norm(span)) * UP)
        self.slide(far, coordinate, UP)
        _site(far, f"end_{j}", np.zeros(3))
        return far

    def slide(self, body: ET.Element, coordinate: str, axis: np.ndarray) -> None:
        """Give a body a coordinate along an axis."""
        _slide(body, coordinate, axis)
        self.coordinates[coordinate] = coordinate


def _described(
    q: Any, p: np.ndarray, legs: Any, mount: tuple[int, str] | None
) -> tuple[ET.Element, dict[str, str]]:
    bodies = _Bodies(q, p, mount)
    legs(bodies)
    released = [*FRAME, *([MOUNT] if mount else [])]
    return bodies.root, bodies.coordinates | {name: name for name in released}


def _on_rails(bodies: _Bodies) -> None:
    q = bodies.q
    for j, x in enumerate(rail_positions(q, bodies.ends)):
        start = q.origin[j] + x * q.direction[j]
        carriage = bodies.bearing(j, f"carriage_{j}", start)
        bodies.slide(carriage, f"x_{j + 1}", q.direction[j])
        bodies.link(j, carriage, np.zeros(3), start, f"delta_{j + 1}")


def rail_positions(q: Any, ends: np.ndarray) -> np.ndarray:
    """Return the positions of carriages on their rails, from the platform's joints in the base frame.

    Raises
    ------
    ValueError
        If a link cannot reach its rail.
    """
    with np.errstate(invalid="ignore"):
        positions = carriage_positions(q._replace(joint=ends), np.zeros(3))
    if not np.isfinite(positions).all():
        raise ValueError("beyond what the links can reach")
    return positions


def _on_arms(bodies: _Bodies) -> None:
    q = bodies.q
    for j, angle in enumerate(arm_angles(q, bodies.p)):
        ray = np.cos(angle) * q.zero[j] + np.sin(angle) * np.cross(q.axis[j], q.zero[j])
        arm = bodies.bearing(j, f"arm_{j}", q.origin[j])
        name = f"theta_{j + 1}"
        _add(arm, "joint", name=name, type="hinge", axis=q.axis[j])
        bodies.coordinates[name] = name
        _site(arm, f"arm_{j}", q.arm_center[j] * ray)
        end = q.arm_length[j] * ray
        bodies.link(j, arm, end, q.origin[j] + end, f"delta_{j + 1}")


def _extending(bodies: _Bodies) -> None:
    q = bodies.q
    for j, base in enumerate(q.base):
        foot = bodies.bearing(j, f"foot_{j}", base)
        _site(foot, f"foot_{j}", np.zeros(3))
        far = bodies.link(j, foot, np.zeros(3), base, f"l_{j + 1}")
        _site(far, f"rod_{j}", -q.leg_rod_center[j] * UP)


def _body(parent: ET.Element, name: str, where: Sequence[float] | np.ndarray, **others: object) -> ET.Element:
    """Add a body; the engine requires a mass, which counts nowhere."""
    body = _add(parent, "body", name=name, pos=where, **others)
    _mass(body, 1.0, np.ones(3))
    return body


def _slide(body: ET.Element, name: str, axis: np.ndarray) -> None:
    _add(body, "joint", name=name, type="slide", axis=axis)


def _site(body: ET.Element, name: str, where: np.ndarray) -> None:
    _add(body, "site", name=name, pos=where)
