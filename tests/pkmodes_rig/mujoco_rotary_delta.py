"""The rotary delta in MuJoCo, to check the generated model against an independent engine.

No formula of the generated model is used.  The robot is only described: a frame that slides, arms and motor rotors on
hinges, rods on ball joints at the ends of the arms, a platform that translates and is pinned to the far ends of the
rods, reducers as springs between two joints.  The engine supplies positions, velocities, inertia, weight and energy;
this module closes the loops with the engine's constraint rows and projects onto the velocities that these rows allow.

Coordinates: `q` are displacements of theta_1..3, phi_1..3 and u from the pose at which the engine was built.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET

import mujoco
import numpy as np

from pkmodes_generated.rotary_delta import Parameters
from pkmodes_rig.mujoco_engine import FIRST

AXES = range(3)
SIZE = 9


class Engine:
    """A robot assembled in MuJoCo at one pose, with a frame mass and a payload.

    Parameters
    ----------
    parameters : Parameters
        One robot, without batch axes.
    p : array, shape (3)
        Platform centre.
    frame, payload : float
        Masses [kg].
    """

    def __init__(
        self, parameters: Parameters, p: np.ndarray, *, frame: float = 50.0, payload: float = 0.0
    ) -> None:
        self.parameters, self.p = parameters, np.asarray(p, dtype=float)
        self.theta = arm_angles(parameters, self.p)
        xml = _description(parameters, self.p, self.theta, frame, payload)
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self._arms, self._motors = ([self._dof(f"{kind}_{j}") for j in AXES] for kind in ("arm", "motor"))
        self._frame = [self._dof(f"frame_{i}") for i in "xyz"]
        for j in AXES:
            # The engine takes the second anchor of a pin from the assembled pose, whatever that pose is.  Set it
            # to the true rod length, so that closing the loop is left to the engine.
            rod_end = np.array([0.0, 0.0, parameters.link_length[j]])
            if not np.allclose(self.model.eq_data[j, 3:6], rod_end, rtol=0, atol=1e-9):
                raise ValueError(f"rod {j + 1} does not reach its platform joint")
            self.model.eq_data[j, 3:6] = rod_end
        self.move(np.zeros(SIZE))

    # Quantities from the engine

    def move(self, q: np.ndarray) -> None:
        """Displace arms, motors and frame to `q`, at rest, and close the loops by Newton's method."""
        ratio = self.parameters.gear_ratio
        wanted = np.concatenate([q[:3], ratio * q[3:6], q[6:]])
        residual = np.inf
        for _ in range(20):
            self.data.qvel[:] = 0
            mujoco.mj_fwdPosition(self.model, self.data)
            error = np.concatenate([-self.data.efc_pos, np.zeros(3), wanted - self._displacements()])
            before, residual = residual, float(np.abs(error).max())
            if residual < 1e-16 or before / 2 <= residual < 1e-13:  # closed to rounding
                break
            step = np.linalg.solve(self._square(), error)
            mujoco.mj_integratePos(self.model, self.data.qpos, step, 1.0)
        else:
            raise ValueError(f"the loops do not close: residual {residual:.1e} m")
        mujoco.mj_fwdVelocity(self.model, self.data)

    def closure(self) -> float:
        """Return the largest distance between a rod end and its platform joint, computed from their positions."""
        gaps = [
            self.data.site(f"rod_end_{j}").xpos - self.data.site(f"platform_joint_{j}").xpos for j in AXES
        ]
        return float(np.linalg.norm(gaps, axis=1).max())

    def platform(self) -> np.ndarray:
        """Return the absolute position of the platform centre."""
        return np.array(self.data.body("platform").xpos)

    def allowed(self) -> np.ndarray:
        """Return the joint velocities per q_dot: the null space of the constraints, without spin of the rods."""
        by_joints = np.linalg.inv(self._square())[:, -SIZE:]
        return by_joints * np.concatenate([np.ones(3), self.parameters.gear_ratio, np.ones(3)])

    def platform_motion(self) -> np.ndarray:
        """Return the absolute velocity of the platform per q_dot."""
        jacobian = np.empty((3, self.model.nv))
        body = self._id(mujoco.mjtObj.mjOBJ_BODY, "platform")
        mujoco.mj_jacBody(self.model, self.data, jacobian, None, body)
        return np.asarray(jacobian @ self.allowed())

    def mass_matrix(self) -> np.ndarray:
        """Return the mass matrix in the nine coordinates."""
        columns = np.zeros((self.model.nv, self.model.nv))
        for column, unit in zip(columns, np.eye(self.model.nv), strict=True):
            mujoco.mj_mulM(self.model, self.data, column, unit)  # mj_fullM changed its arguments in 4.0
        N = self.allowed()
        return np.asarray(N.T @ columns @ N)

    def potential(self) -> float:
        """Return the potential energy of gravity and reducers reported by the engine."""
        mujoco.mj_energyPos(self.model, self.data)
        return float(self.data.energy[0])

    def gradient(self) -> np.ndarray:
        """Return the gradient of the potential energy, from the engine's forces at rest."""
        return np.asarray(self.allowed().T @ (self.data.qfrc_bias - self.data.qfrc_passive))

    def relax(self) -> None:
        """Remove the springs of the reducers."""
        self.model.tendon_stiffness[:] = 0
        self.move(np.zeros(SIZE))

    # Derivatives by moving the mechanism

    def hessian(self, step: float) -> np.ndarray:
        """Compute the Hessian of the potential energy from differences of `gradient` along each coordinate."""
        columns = []
        for unit in np.eye(SIZE):
            column = np.zeros(SIZE)
            for k, weight in enumerate(FIRST, start=1):
                for sign in (1, -1):
                    self.move(sign * k * step * unit)
                    column += sign * weight / step * self.gradient()
            columns.append(column)
        self.move(np.zeros(SIZE))
        return np.array(columns).T

    def slopes(self, step: float) -> np.ndarray:
        """Compute the gradient of the potential energy from differences of the energy."""
        gradient = np.zeros(SIZE)
        for i, unit in enumerate(np.eye(SIZE)):
            for k, weight in enumerate(FIRST, start=1):
                for sign in (1, -1):
                    self.move(sign * k * step * unit)
                    gradient[i] += sign * weight / step * self.potential()
        self.move(np.zeros(SIZE))
        return gradient

    def _displacements(self) -> np.ndarray:
        joints = [self.model.dof_jntid[i] for i in (*self._arms, *self._motors, *self._frame)]
        return np.asarray(self.data.qpos[[self.model.jnt_qposadr[joint] for joint in joints]])

    def _square(self) -> np.ndarray:
        """Return the rows that determine a motion: the engine's constraints, spin of the rods, the coordinates."""
        constraints = np.reshape(self.data.efc_J, (self.data.nefc, self.model.nv))
        coordinates = np.eye(self.model.nv)[[*self._arms, *self._motors, *self._frame]]
        return np.vstack([constraints, *self._spins(), coordinates])

    def _spins(self) -> list[np.ndarray]:
        """Return the spin of each rod about its axis per joint velocity; it is constrained to zero.

        The spin is absolute, not relative to the rotating arm: the engine requires some inertia about the rod.
        """
        spins = []
        for j in AXES:
            turning = np.empty((3, self.model.nv))
            body = self._id(mujoco.mjtObj.mjOBJ_BODY, f"rod_{j}")
            mujoco.mj_jacBody(self.model, self.data, None, turning, body)
            spins.append(self.data.xmat[body].reshape(3, 3)[:, 2] @ turning)
        return spins

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        return int(mujoco.mj_name2id(self.model, kind, name))

    def _dof(self, joint: str) -> int:
        return int(self.model.jnt_dofadr[self._id(mujoco.mjtObj.mjOBJ_JOINT, joint)])


def arm_angles(parameters: Parameters, p: np.ndarray) -> np.ndarray:
    """Compute the arm angles at which the circle of the arm's end meets the sphere around the platform joint.

    They only assemble the engine near the pose; the engine's closure verifies them.
    """
    angles = []
    for j in AXES:
        r = p + parameters.joint[j] - parameters.origin[j]
        z, y = parameters.zero[j], np.cross(parameters.axis[j], parameters.zero[j])
        L, reach = parameters.arm_length[j], np.hypot(r @ z, r @ y)
        cosine = (r @ r + L**2 - parameters.link_length[j] ** 2) / (2 * L * reach)
        angles.append(np.arctan2(r @ y, r @ z) + parameters.branch[j] * np.arccos(cosine))
    return np.array(angles)


def _description(
    parameters: Parameters, p: np.ndarray, theta: np.ndarray, frame_mass: float, payload: float
) -> str:
    """Return the MJCF of the robot, assembled at the pose with every joint at zero."""
    root = ET.Element("mujoco")
    _add(root, "compiler", angle="radian", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
    option = _add(root, "option", gravity=parameters.gravity, jacobian="dense")
    _add(option, "flag", energy="enable")
    world = ET.SubElement(root, "worldbody")
    equality = ET.SubElement(root, "equality")
    reducers = ET.SubElement(root, "tendon")

    frame = _add(world, "body", name="frame")
    for name, axis in zip("xyz", np.eye(3), strict=True):
        _add(frame, "joint", name=f"frame_{name}", type="slide", axis=axis)
    _mass(frame, frame_mass, np.ones(3))  # does not rotate: any inertia will do
    platform = _add(frame, "body", name="platform", pos=p)
    for name, axis in zip("xyz", np.eye(3), strict=True):
        _add(platform, "joint", name=f"platform_{name}", type="slide", axis=axis)
    _mass(platform, float(parameters.platform_mass) + payload, np.ones(3))  # does not rotate either

    for j in AXES:
        axis, zero = parameters.axis[j], parameters.zero[j]
        ray = np.cos(theta[j]) * zero + np.sin(theta[j]) * np.cross(axis, zero)
        arm = _add(frame, "body", name=f"arm_{j}", pos=parameters.origin[j])
        _add(arm, "joint", name=f"arm_{j}", type="hinge", axis=axis)
        mass, centre = parameters.arm_mass[j], parameters.arm_center[j]
        # rotates about its axis only, so the inertia about other axes has no effect
        _mass(arm, mass, np.full(3, parameters.arm_inertia[j] - mass * centre**2), centre * ray)

        end, joint = parameters.arm_length[j] * ray, parameters.joint[j]
        length, rod_mass = float(parameters.link_length[j]), parameters.link_mass[j]
        rod = _add(arm, "body", name=f"rod_{j}", pos=end, zaxis=p + joint - parameters.origin[j] - end)
        _add(rod, "joint", name=f"ball_{j}", type="ball")
        across = rod_mass * length**2 / 12
        _mass(rod, rod_mass, np.array([across, across, 1e-9]), np.array([0, 0, length / 2]))
        _add(rod, "site", name=f"rod_end_{j}", pos=np.array([0, 0, length]))
        _add(platform, "site", name=f"platform_joint_{j}", pos=joint)
        _add(equality, "connect", body1="platform", body2=f"rod_{j}", anchor=joint)

        rotor = _add(world, "body", name=f"motor_{j}")  # only rotates: its mass is part of the frame's
        _add(rotor, "joint", name=f"motor_{j}", type="hinge", axis=axis)
        _mass(rotor, 1.0, np.full(3, parameters.motor_inertia[j]))
        reducer = _add(reducers, "fixed", stiffness=parameters.reducer_stiffness[j], springlength=0.0)
        _add(reducer, "joint", joint=f"arm_{j}", coef=1.0)
        _add(reducer, "joint", joint=f"motor_{j}", coef=-1 / parameters.gear_ratio[j])
    return ET.tostring(root, encoding="unicode")


def _mass(body: ET.Element, mass: float, inertia: np.ndarray, centre: np.ndarray | None = None) -> None:
    _add(body, "inertial", pos=np.zeros(3) if centre is None else centre, mass=mass, diaginertia=inertia)


def _add(parent: ET.Element, tag: str, **attributes: object) -> ET.Element:
    """Add an element, with numbers in full precision."""

    def text(value: object) -> str:
        if isinstance(value, str):
            return value
        return " ".join(repr(float(number)) for number in np.atleast_1d(np.asarray(value, dtype=float)))

    return ET.SubElement(parent, tag, {key: text(value) for key, value in attributes.items()})
