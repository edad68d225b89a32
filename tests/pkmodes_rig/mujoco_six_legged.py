"""Hexapod and hexaglide in MuJoCo, with bodies that turn, to check the generated models against another engine.

No formula of the generated models or of their oracle is used.  A machine is only described: a frame that slides, a
platform free to move and turn, a leg on a universal joint as two bodies of which one slides in the other, or a rod on
a universal joint on a carriage that slides.  Pins hold the far ends at the platform.  Rods yield along their axes, as
three lumps of mass (Simpson's rule, exact for what follows two ends).  The engine supplies positions, velocities,
inertia, weight and the forces of springs; this module closes the loops with the engine's constraint rows and projects
onto the velocities that these rows allow.

Coordinates: `q` are displacements, from the pose at which the engine was built, of what `names` lists.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Mapping
from types import SimpleNamespace
from typing import Any

import mujoco
import numpy as np

from pkmodes_rig.mujoco_engine import FIRST, _add, _mass, _transmission

LEGS = range(6)
#: What the engine needs where there is none: mass and inertia of a lump, inertia of a slender body about its axis.
NOTHING = 1e-14

Machine = Mapping[str, Any]


class Engine:
    """A machine, as in its robot file in SI units, assembled in MuJoCo at one pose.

    Of its effects, `payload`, the mass of the frame and the elongation of the rods are there; the springs are those
    of the base model.

    Parameters
    ----------
    machine : mapping
        What the robot file contains.
    pose : sequence of float
        Position [m] and rotation vector [rad] of the platform.
    """

    def __init__(self, machine: Machine, pose: Any) -> None:
        self._joints_of_platform = np.array([axis["joint"] for axis in machine["axis"]])
        self.names: tuple[str, ...]
        describe = {"hexapod": _hexapod, "hexaglide": _hexaglide}[machine["mechanism"]]
        xml, self.names = describe(machine, np.asarray(pose, dtype=float))
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self._joints = [self._id(mujoco.mjtObj.mjOBJ_JOINT, name) for name in self.names]
        # a rod has a slide in its middle and one behind it, each of which yields by half the elongation
        self._share = np.array([0.5 if name.startswith("delta") else 1.0 for name in self.names])
        self.move(np.zeros(len(self.names)))

    def move(self, q: np.ndarray) -> None:
        """Displace the coordinates to `q`, at rest, and close the loops by Newton's method."""
        places = self.model.jnt_qposadr[self._joints]
        residual = np.inf
        for _ in range(20):
            self.data.qvel[:] = 0
            mujoco.mj_fwdPosition(self.model, self.data)
            error = np.concatenate([-self.data.efc_pos, q * self._share - self.data.qpos[places]])
            before, residual = residual, float(np.abs(error).max())
            if residual < 1e-16 or before / 2 <= residual < 1e-12:  # closed to rounding
                break
            mujoco.mj_integratePos(self.model, self.data.qpos, np.linalg.solve(self._square(), error), 1.0)
        else:
            raise ValueError(f"the loops do not close: residual {residual:.1e} m")
        mujoco.mj_fwdVelocity(self.model, self.data)

    def allowed(self) -> np.ndarray:
        """Return the joint velocities per q_dot: the null space of the constraints."""
        return np.asarray(np.linalg.inv(self._square())[:, -len(self.names) :] * self._share)

    def mass_matrix(self) -> np.ndarray:
        columns = np.zeros((self.model.nv, self.model.nv))
        for column, unit in zip(columns, np.eye(self.model.nv), strict=True):
            mujoco.mj_mulM(self.model, self.data, column, unit)  # mj_fullM changed its arguments in 4.0
        N = self.allowed()
        return np.asarray(N.T @ columns @ N)

    def platform_motion(self) -> np.ndarray:
        """Return the absolute velocity of the platform's origin, and its angular velocity, per q_dot."""
        J = np.empty((6, self.model.nv))
        body = self._id(mujoco.mjtObj.mjOBJ_BODY, "platform")
        mujoco.mj_jac(self.model, self.data, J[:3], J[3:], self.data.xpos[body], body)
        return np.asarray(J @ self.allowed())

    def elastic_hessian(self) -> np.ndarray:
        """Return the stiffness of the springs, from the rows that say how each becomes longer.

        A spring's elongation is a constant combination of joint displacements.
        """
        rows = np.zeros((self.model.ntendon, self.model.nv))
        for row, (start, count) in zip(
            rows, zip(self.model.tendon_adr, self.model.tendon_num, strict=True), strict=True
        ):
            joints = self.model.wrap_objid[start : start + count]
            row[self.model.jnt_dofadr[joints]] = self.model.wrap_prm[start : start + count]
        strain = rows @ self.allowed()
        stiffness = np.reshape(self.model.tendon_stiffness, (self.model.ntendon, -1))[:, 0]
        return np.asarray(strain.T @ (stiffness[:, None] * strain))

    def gravity_gradient(self) -> np.ndarray:
        """Return the derivatives of the potential energy of gravity, from the engine's forces at rest."""
        return np.asarray(self.allowed().T @ self.data.qfrc_bias)

    def gravity_hessian(self, travel: float = 0.002) -> np.ndarray:
        """Return the stiffness of gravity from eighth-order differences of its forces.

        Each step moves the platform's joints by `travel`, as a part of their distance from its origin.
        """
        motion, size = self.platform_motion(), float(np.abs(self._joints_of_platform).max())
        gain = np.linalg.norm(motion[:3], axis=0) / size + np.linalg.norm(motion[3:], axis=0)
        found = np.zeros((len(self.names), len(self.names)))
        for column, unit, moved in zip(found.T, np.eye(len(self.names)), gain, strict=True):
            if moved == 0:  # pulleys and motors
                continue
            step = travel / moved
            for k, weight in enumerate(FIRST, start=1):
                for sign in (1, -1):
                    self.move(sign * k * step * unit)
                    column += sign * weight / step * self.gravity_gradient()
        self.move(np.zeros(len(self.names)))
        return found

    def _square(self) -> np.ndarray:
        """Return the rows that determine a motion: the engine's constraints and the coordinates."""
        constraints = np.reshape(self.data.efc_J, (self.data.nefc, self.model.nv))
        return np.vstack([constraints, np.eye(self.model.nv)[self.model.jnt_dofadr[self._joints]]])

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        return int(mujoco.mj_name2id(self.model, kind, name))


def of(machine: Machine, j: int, table: str, key: str) -> float:
    """A value of an axis, its own or the shared one."""
    own = machine["axis"][j].get(table, {})
    return float(own[key] if key in own else machine[table][key])


class _World:
    """What both machines have: frame, platform with payload, and the elements to which legs are added."""

    def __init__(self, machine: Machine, pose: np.ndarray) -> None:
        self.root = ET.Element("mujoco")
        _add(self.root, "compiler", angle="radian", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
        _add(self.root, "option", gravity=np.array(machine["gravity"]), jacobian="dense")
        self.world = ET.SubElement(self.root, "worldbody")
        self.equality = ET.SubElement(self.root, "equality")
        self.springs = ET.SubElement(self.root, "tendon")

        self.frame = _add(self.world, "body", name="frame")
        for name, axis in zip("xyz", np.eye(3), strict=True):
            _add(self.frame, "joint", name=f"u_{name}", type="slide", axis=axis)
        _mass(self.frame, machine.get("frame", {}).get("mass", 50.0), np.ones(3))  # does not turn

        quaternion = np.empty(4)
        angle = float(np.linalg.norm(pose[3:]))
        mujoco.mju_axisAngle2Quat(quaternion, pose[3:] / angle if angle else np.array([1.0, 0, 0]), angle)
        self.platform = _add(self.world, "body", name="platform", pos=pose[:3], quat=quaternion)
        _add(self.platform, "freejoint", name="platform")
        table = machine["platform"]
        xy, xz, yz = table.get("products", [0.0, 0.0, 0.0])
        tensor = np.array([*table["inertia"], xy, xz, yz])
        _add(self.platform, "inertial", pos=np.array(table["center"]), mass=table["mass"], fullinertia=tensor)
        payload = machine.get("effects", {}).get("payload", {})
        if payload:
            lump(self.platform, payload["mass"], np.array(payload.get("offset", [0.0, 0.0, 0.0])))
        rotated = np.empty((6, 3))
        self.joints = np.array([axis["joint"] for axis in machine["axis"]])
        for j in LEGS:
            mujoco.mju_rotVecQuat(rotated[j], self.joints[j], quaternion)
        #: Joints of the platform in the base frame.
        self.ends = pose[:3] + rotated

    def pin(self, j: int, body: str) -> None:
        """Hold the end of a leg at its joint; both coincide as assembled."""
        _add(self.equality, "connect", body1="platform", body2=body, anchor=self.joints[j])

    def spring(self, stiffness: float, elongation: Mapping[str, float]) -> None:
        spring = _add(self.springs, "fixed", stiffness=stiffness, springlength=0.0)
        for name, coefficient in elongation.items():
            _add(spring, "joint", joint=name, coef=coefficient)

    def text(self) -> str:
        return ET.tostring(self.root, encoding="unicode")


def lump(parent: ET.Element, mass: float, where: np.ndarray) -> None:
    """Add a point mass, fixed to a body."""
    body = _add(parent, "body", pos=where)
    _mass(body, mass, np.full(3, NOTHING))


def universal(parent: ET.Element, name: str, where: np.ndarray, along: np.ndarray) -> ET.Element:
    """Add a body on a universal joint; its z axis is `along`, and at the pose it cannot spin about it."""
    body = _add(parent, "body", name=name, pos=where, zaxis=along)
    _add(body, "joint", name=f"{name}_x", type="hinge", axis=np.array([1.0, 0, 0]))
    _add(body, "joint", name=f"{name}_y", type="hinge", axis=np.array([0, 1.0, 0]))
    return body


def slender(inertia: float) -> np.ndarray:
    return np.array([inertia, inertia, NOTHING])


def _hexapod(machine: Machine, pose: np.ndarray) -> tuple[str, tuple[str, ...]]:
    it = _World(machine, pose)
    along_z = np.array([0, 0, 1.0])
    for j in LEGS:
        base = np.array(machine["axis"][j]["base"])
        length = float(np.linalg.norm(it.ends[j] - base))
        leg = universal(it.frame, f"leg_{j}", base, it.ends[j] - base)
        _mass(
            leg,
            of(machine, j, "leg", "base_mass"),
            slender(of(machine, j, "leg", "base_inertia")),
            of(machine, j, "leg", "base_center") * along_z,
        )
        rod = _add(leg, "body", name=f"rod_{j}", pos=length * along_z)  # its origin is the platform's joint
        _add(rod, "joint", name=f"l_{j + 1}", type="slide", axis=along_z)
        _mass(
            rod,
            of(machine, j, "leg", "rod_mass"),
            slender(of(machine, j, "leg", "rod_inertia")),
            -of(machine, j, "leg", "rod_center") * along_z,
        )
        it.pin(j, f"rod_{j}")
        motor = _add(it.world, "body", name=f"motor_{j}", gravcomp=1.0)  # only its inertia counts
        _add(motor, "joint", name=f"s_{j + 1}", type="slide", axis=along_z)
        reflected = of(machine, j, "motor", "inertia") / of(machine, j, "motor", "travel") ** 2
        _mass(motor, reflected, np.ones(3))
        it.spring(of(machine, j, "leg", "stiffness"), {f"l_{j + 1}": 1.0, f"s_{j + 1}": -1.0})
    names = [f"{kind}_{j + 1}" for kind in "ls" for j in LEGS]
    return it.text(), (*names, "u_x", "u_y", "u_z")


def _hexaglide(machine: Machine, pose: np.ndarray) -> tuple[str, tuple[str, ...]]:
    it = _World(machine, pose)
    positions = []
    for j in LEGS:
        axis, length = machine["axis"][j], of(machine, j, "link", "length")
        direction = np.array(axis["direction"]) / np.linalg.norm(axis["direction"])
        across = it.ends[j] - axis["origin"]
        x = float(across @ direction)
        across = across - x * direction
        x += axis["branch"] * float(np.sqrt(length**2 - across @ across))
        positions.append(x)
        start = axis["origin"] + x * direction
        carriage = _add(it.frame, "body", name=f"carriage_body_{j}", pos=start)
        _add(carriage, "joint", name=f"carriage_{j}", type="slide", axis=direction)
        mass = of(machine, j, "link", "mass")
        _mass(carriage, of(machine, j, "carriage", "mass") + mass / 6, np.ones(3))  # does not turn
        rod = universal(carriage, f"rod_{j}", np.zeros(3), it.ends[j] - start)
        _mass(rod, NOTHING, np.full(3, NOTHING))
        half, along_z = np.array([0, 0, length / 2]), np.array([0, 0, 1.0])
        middle = _add(rod, "body", name=f"middle_{j}", pos=half)
        _add(middle, "joint", name=f"delta_{j + 1}", type="slide", axis=along_z)
        _mass(middle, mass * 4 / 6, np.full(3, NOTHING))
        end = _add(middle, "body", name=f"end_{j}", pos=half)
        _add(end, "joint", name=f"far_{j}", type="slide", axis=along_z)
        _mass(end, mass / 6, np.full(3, NOTHING))
        it.pin(j, f"end_{j}")
    for j in LEGS:  # after the pins
        proportional = np.array([0, 1.0, 0, 0, 0])
        _add(it.equality, "joint", joint1=f"far_{j}", joint2=f"delta_{j + 1}", polycoef=proportional)
        _transmission(it.world, it.equality, it.springs, _belts(machine), np.array(positions), j)
    names = [f"carriage_{j}" for j in LEGS] + [f"pulley_{j}_{k}" for k in (1, 2) for j in LEGS]
    return it.text(), (*names, *(f"delta_{j + 1}" for j in LEGS), "u_x", "u_y", "u_z")


def _belts(machine: Machine) -> Any:
    """Values of the belts as arrays, one entry for each axis."""

    def each(table: str, key: str) -> np.ndarray:
        return np.array([of(machine, j, table, key) for j in LEGS])

    return SimpleNamespace(
        pulley_inertia=each("pulley", "inertia"),
        pulley_radius=each("pulley", "radius"),
        motor_inertia=each("motor", "inertia"),
        gear_ratio=each("motor", "gear_ratio"),
        carriage_length=each("carriage", "length"),
        belt_width=each("belt", "width"),
        belt_specific_stiffness=each("belt", "specific_stiffness"),
        limits=np.array([axis["limits"] for axis in machine["axis"]]),
        drive=np.array([[axis["driven_pulley"] == k for k in (1, 2)] for axis in machine["axis"]]),
    )
