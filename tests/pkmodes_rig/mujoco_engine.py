"""The linear delta in MuJoCo, to check the generated model against an independent engine.

No formula of the generated model is used.  The robot is only described: sliding carriages, rods on ball joints, a
platform that translates and is pinned to the far ends of the rods, pulleys and motor rotors on hinges, gearboxes as
joint equalities, belt spans as springs.  The engine supplies positions, velocities, accelerations, inertia, weight
and energy; this module closes the loops with the engine's constraint rows and projects onto the velocities that
these rows allow.

Coordinates: `q` are the nine displacements (carriages, then pulleys, as in the generated model) from the pose at
which the engine was built.
"""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from contextlib import contextmanager

import mujoco
import numpy as np

from pkmodes_generated.linear_delta import Parameters

AXES = range(3)

#: Central differences of a first derivative, eighth order: weights of f(+k h) - f(-k h), divided by h.
FIRST = (4 / 5, -1 / 5, 4 / 105, -1 / 280)

#: Central differences of a second derivative, eighth order: weights of f(+k h) + f(-k h) - 2 f(0), over h^2.
SECOND = (8 / 5, -1 / 5, 8 / 315, -1 / 560)


class Engine:
    """A robot assembled in MuJoCo at one pose.

    Parameters
    ----------
    parameters : Parameters
        One robot, without batch axes.
    p : array, shape (3)
        Platform centre.
    axial_inertia : float
        Inertia of each rod about its axis [kg m^2]: zero for a slender rod, but the engine rejects zero.  It has no
        effect, because in `allowed` the rods do not spin about their axes.
    rod_radius : float, optional
        Radius over length of each rod.  The engine then computes the inertia of a uniform cylinder itself.
    """

    def __init__(
        self,
        parameters: Parameters,
        p: np.ndarray,
        *,
        axial_inertia: float = 1e-9,
        rod_radius: float | None = None,
    ) -> None:
        self.parameters = parameters
        self.x = carriage_positions(parameters, p)
        xml = _description(parameters, np.asarray(p, dtype=float), self.x, axial_inertia, rod_radius)
        #: Computed once for each position.
        self._motions: np.ndarray | None = None
        self._inertia: np.ndarray | None = None
        self.model = mujoco.MjModel.from_xml_string(xml)
        self.data = mujoco.MjData(self.model)
        self._carriages = [self._dof(f"carriage_{j}") for j in AXES]
        self._pulleys = [self._dof(f"pulley_{j}_{k}") for k in (1, 2) for j in AXES]
        self._balls = [self._dof(f"ball_{j}") for j in AXES]
        self._platform = [self._dof(f"platform_{i}") for i in "xyz"]
        self._rods = [self._id(mujoco.mjtObj.mjOBJ_BODY, f"rod_{j}") for j in AXES]
        self._coordinates = self._carriages + self._pulleys
        self._places = np.array([self.model.jnt_qposadr[self.model.dof_jntid[i]] for i in self._coordinates])
        # The engine expresses the velocity of a ball joint in the frame of the rod, whose z axis is along the rod.
        spins_and_coordinates = [i + 2 for i in self._balls] + self._coordinates
        #: What `_square` returns; the engine's constraints, which come first, change with the position.
        self._rows = np.zeros((self.model.nv, self.model.nv))
        self._rows[-len(spins_and_coordinates) :] = np.eye(self.model.nv)[spins_and_coordinates]
        for j in AXES:
            # The engine takes the second anchor of a pin from the assembled pose, whatever that pose is.  Set it
            # to the true rod length, so that closing the loop is left to the engine.
            rod_end = np.array([0.0, 0.0, parameters.link_length[j]])
            if not np.allclose(self.model.eq_data[j, 3:6], rod_end, rtol=0, atol=1e-9):
                raise ValueError(f"rod {j + 1} does not reach its platform joint")
            self.model.eq_data[j, 3:6] = rod_end
        self.move(np.zeros(9))

    # Quantities from the engine --------------------------------------------------------------------------

    def move(self, q: np.ndarray) -> None:
        """Displace carriages and pulleys to `q`, at rest, and close the loops by Newton's method."""
        residual = np.inf
        self._motions = self._inertia = None
        error = np.zeros(self.model.nv)
        self.data.qvel[:] = 0
        for _ in range(20):
            # Of the engine's stages, those that the constraints need.
            mujoco.mj_kinematics(self.model, self.data)
            mujoco.mj_comPos(self.model, self.data)
            mujoco.mj_makeConstraint(self.model, self.data)
            error[: -len(q) - len(AXES)] = -self.data.efc_pos
            error[-len(q) :] = q - self._displacements()
            before, residual = residual, float(np.abs(error).max())
            if residual < 1e-16 or before / 2 <= residual < 1e-13:  # closed to rounding
                break
            step = np.linalg.solve(self._square(), error)
            mujoco.mj_integratePos(self.model, self.data.qpos, step, 1.0)
        else:
            raise ValueError(f"the loops do not close: residual {residual:.1e} m")
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def closure(self) -> float:
        """Return the largest distance between a rod end and its platform joint, computed from their positions."""
        gaps = [
            self.data.site(f"rod_end_{j}").xpos - self.data.site(f"platform_joint_{j}").xpos for j in AXES
        ]
        return float(np.linalg.norm(gaps, axis=1).max())

    def platform(self) -> np.ndarray:
        """Return the platform centre."""
        return self.data.body("platform").xpos.copy()

    def links(self) -> np.ndarray:
        """Return the vectors from each carriage to its platform joint, one row per axis."""
        ends = [(self.data.site(f"platform_joint_{j}").xpos, self.data.body(f"rod_{j}").xpos) for j in AXES]
        return np.array([joint - carriage for joint, carriage in ends])

    def motions(self) -> np.ndarray:
        """Return the joint velocities that the constraints allow, per spin of each rod, then per q_dot."""
        if self._motions is None:
            self._motions = np.linalg.inv(self._square())[:, -12:]
        return self._motions

    def allowed(self) -> np.ndarray:
        """Return the joint velocities per q_dot: the null space of the constraints, without spin of the rods."""
        return self.motions()[:, 3:]

    def platform_jacobian(self) -> np.ndarray:
        """Return the platform velocity per carriage velocity."""
        return self.allowed()[self._platform, :3]

    def link_jacobians(self) -> tuple[np.ndarray, np.ndarray]:
        """Return the velocity of the centre of mass and the angular velocity of each rod, per carriage velocity."""
        linear, angular = np.empty((2, 3, 3, self.model.nv))
        for j in AXES:
            mujoco.mj_jacBodyCom(self.model, self.data, linear[j], angular[j], self._rods[j])
        N = self.allowed()[:, :3]
        return linear @ N, angular @ N

    def inertia(self) -> np.ndarray:
        """Return the inertia matrix of all joints with the loops open."""
        if self._inertia is None:
            self._inertia = np.zeros((self.model.nv, self.model.nv))
            for column, unit in zip(self._inertia, np.eye(self.model.nv), strict=True):
                mujoco.mj_mulM(self.model, self.data, column, unit)  # mj_fullM changed its arguments in 4.0
        return self._inertia

    def mass_matrix(self) -> np.ndarray:
        """Return the mass matrix in the nine coordinates."""
        N = self.allowed()
        return N.T @ self.inertia() @ N

    def kinetic_energy(self, q_dot: np.ndarray) -> float:
        """Return the kinetic energy reported by the engine."""
        with self._moving(q_dot):
            mujoco.mj_energyVel(self.model, self.data)
            return float(self.data.energy[1])

    def potential(self) -> float:
        """Return the potential energy of gravity and belts reported by the engine."""
        mujoco.mj_energyPos(self.model, self.data)
        return float(self.data.energy[0])

    def gradient(self) -> np.ndarray:
        """Return the gradient of the potential energy, from the engine's forces at rest."""
        return self.allowed().T @ (self.data.qfrc_bias - self.data.qfrc_passive)

    def out_of_balance(self, torques: np.ndarray) -> np.ndarray:
        """Return the residual generalised force at rest with these torques on the driven pulleys."""
        applied = np.zeros(self.model.nv)
        for j in AXES:
            driven = int(np.argmax(self.parameters.drive[j])) + 1
            applied[self._dof(f"pulley_{j}_{driven}")] = torques[j]
        return self.allowed().T @ applied - self.gradient()

    def velocity_forces(self, x_dot: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
        """Return the forces that keep the carriage velocities constant, without gravity, and the acceleration.

        Returns
        -------
        h : array, shape (3)
            Coriolis and centrifugal forces at the carriages.
        acceleration : array, shape (3)
            Acceleration of the platform in this motion.
        """
        at_rest = self.data.qfrc_bias.copy()
        with self._moving(np.concatenate([x_dot, np.zeros(6)])):
            # Joint accelerations that keep the pins together while the coordinates do not accelerate: they
            # compensate the drift of the pins without joint accelerations.
            self.data.qacc[:] = 0
            mujoco.mj_rnePostConstraint(self.model, self.data)
            wanted = np.zeros(self.model.nv)
            wanted[:9] = np.ravel([self._acceleration(j, "rod_end") for j in AXES])
            wanted[:9] -= np.ravel([self._acceleration(j, "platform_joint") for j in AXES])
            acceleration = np.linalg.solve(self._square(), wanted)
            forces = self.inertia() @ acceleration + self.data.qfrc_bias - at_rest
        return (self.allowed().T @ forces)[:3], acceleration[self._platform]

    def length_scale(self) -> float:
        """Return the smallest radius of curvature of the platform path for motion of one carriage, for step sizes."""
        return 1 / max(float(np.linalg.norm(self.velocity_forces(x_dot)[1])) for x_dot in np.eye(3))

    # Derivatives by moving the mechanism -------------------------------------------------------------------

    def hessian(self, steps: np.ndarray) -> np.ndarray:
        """Compute the Hessian of the potential energy from differences of `gradient` along each coordinate."""
        columns = []
        for unit, h in zip(np.eye(9), steps, strict=True):
            column = np.zeros(9)
            for k, weight in enumerate(FIRST, start=1):
                for sign in (1, -1):
                    self.move(sign * k * h * unit)
                    column += sign * weight / h * self.gradient()
            columns.append(column)
        self.move(np.zeros(9))
        return np.array(columns).T

    def energy_along(self, direction: np.ndarray, h: float) -> tuple[float, float]:
        """Compute the first and second derivative of the potential energy along a line in the nine coordinates."""
        self.move(np.zeros(9))
        here = self.potential()
        first = second = 0.0
        for k, (odd, even) in enumerate(zip(FIRST, SECOND, strict=True), start=1):
            self.move(k * h * direction)
            ahead = self.potential() - here
            self.move(-k * h * direction)
            behind = self.potential() - here
            first += odd / h * (ahead - behind)
            second += even / h**2 * (ahead + behind)
        self.move(np.zeros(9))
        return first, second

    @contextmanager
    def without_belts(self) -> Iterator[None]:
        """Remove the belt springs, leaving only gravity."""
        stiffness = self.model.tendon_stiffness.copy()
        self.model.tendon_stiffness[:] = 0
        try:
            yield
        finally:
            self.model.tendon_stiffness[:] = stiffness
            self.move(np.zeros(9))

    # --------------------------------------------------------------------------------------------------------

    @contextmanager
    def _moving(self, q_dot: np.ndarray) -> Iterator[None]:
        self.data.qvel[:] = self.allowed() @ q_dot
        mujoco.mj_fwdVelocity(self.model, self.data)
        try:
            yield
        finally:
            self.data.qvel[:] = 0
            mujoco.mj_fwdVelocity(self.model, self.data)

    def _acceleration(self, j: int, name: str) -> np.ndarray:
        site, acceleration = mujoco.mjtObj.mjOBJ_SITE, np.empty(6)
        mujoco.mj_objectAcceleration(
            self.model, self.data, site, self._id(site, f"{name}_{j}"), acceleration, 0
        )
        return acceleration[3:]

    def _displacements(self) -> np.ndarray:
        return self.data.qpos[self._places]

    def _square(self) -> np.ndarray:
        """Return the rows that determine a motion: the engine's constraints, spin of the rods, the coordinates."""
        self._rows[: self.data.nefc] = np.reshape(self.data.efc_J, (self.data.nefc, self.model.nv))
        return self._rows

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        return int(mujoco.mj_name2id(self.model, kind, name))

    def _dof(self, joint: str) -> int:
        return int(self.model.jnt_dofadr[self._id(mujoco.mjtObj.mjOBJ_JOINT, joint)])


def carriage_positions(parameters: Parameters, p: np.ndarray) -> np.ndarray:
    """Compute the carriage positions from the rod lengths, on the given side of the platform joints.

    They only assemble the engine near the pose; the engine's closure verifies them.
    """
    to_joint = p + parameters.joint - parameters.origin
    along = np.sum(to_joint * parameters.direction, axis=1)
    distance = np.linalg.norm(to_joint - along[:, None] * parameters.direction, axis=1)
    return along + parameters.branch * np.sqrt(parameters.link_length**2 - distance**2)


def _description(
    parameters: Parameters, p: np.ndarray, x: np.ndarray, axial_inertia: float, rod_radius: float | None
) -> str:
    """Return the MJCF of the robot, assembled at the pose with every joint at zero."""
    root = ET.Element("mujoco")
    _add(root, "compiler", angle="radian", boundmass=0.0, boundinertia=0.0, balanceinertia="false")
    option = _add(root, "option", gravity=parameters.gravity, jacobian="dense")
    _add(option, "flag", energy="enable")
    world = ET.SubElement(root, "worldbody")
    equality = ET.SubElement(root, "equality")
    belts = ET.SubElement(root, "tendon")

    platform = _add(world, "body", name="platform", pos=p)
    for name, axis in zip("xyz", np.eye(3), strict=True):
        _add(platform, "joint", name=f"platform_{name}", type="slide", axis=axis)
    _mass(platform, float(parameters.platform_mass), np.ones(3))  # does not rotate: any inertia will do

    for j in AXES:
        direction, length = parameters.direction[j], float(parameters.link_length[j])
        end = parameters.origin[j] + x[j] * direction
        joint = parameters.joint[j]
        carriage = _add(world, "body", name=f"carriage_{j}", pos=end)
        _add(carriage, "joint", name=f"carriage_{j}", type="slide", axis=direction)
        _mass(carriage, parameters.carriage_mass[j], np.ones(3))  # does not rotate either

        rod = _add(carriage, "body", name=f"rod_{j}", zaxis=p + joint - end)
        _add(rod, "joint", name=f"ball_{j}", type="ball")
        middle, mass = np.array([0, 0, length / 2]), parameters.link_mass[j]
        if rod_radius is None:
            across = mass * length**2 / 12
            _mass(rod, mass, np.array([across, across, axial_inertia]), middle)
        else:
            size = np.array([rod_radius * length, length / 2])
            _add(rod, "geom", type="cylinder", size=size, pos=middle, mass=mass, contype="0", conaffinity="0")
        _add(rod, "site", name=f"rod_end_{j}", pos=np.array([0, 0, length]))
        _add(platform, "site", name=f"platform_joint_{j}", pos=joint)
        _add(equality, "connect", body1="platform", body2=f"rod_{j}", anchor=joint)
    for j in AXES:  # after the pins, whose rows are the first nine
        _transmission(world, equality, belts, parameters, x, j)
    return ET.tostring(root, encoding="unicode")


def _transmission(
    world: ET.Element, equality: ET.Element, belts: ET.Element, parameters: Parameters, x: np.ndarray, j: int
) -> None:
    """Add pulleys, motor and belt of axis j."""
    for k in (1, 2):
        name = f"pulley_{j}_{k}"
        pulley = _add(world, "body", name=name)
        _add(pulley, "joint", name=name, type="hinge", axis=np.eye(3)[k])
        _mass(pulley, 1.0, np.full(3, parameters.pulley_inertia[j]))  # centred at the base: no potential
        if parameters.drive[j, k - 1]:
            rotor = _add(world, "body", name=f"motor_{j}")
            _add(rotor, "joint", name=f"motor_{j}", type="hinge", axis=np.eye(3)[k])
            _mass(rotor, 1.0, np.full(3, parameters.motor_inertia[j]))
            ratio = np.array([0, parameters.gear_ratio[j], 0, 0, 0])
            _add(equality, "joint", joint1=f"motor_{j}", joint2=name, polycoef=ratio)

    low, high = parameters.limits[j]
    half, radius = parameters.carriage_length[j] / 2, parameters.pulley_radius[j]
    carriage, pulley_1, pulley_2 = f"carriage_{j}", f"pulley_{j}_1", f"pulley_{j}_2"
    for length, elongation in (
        (high - low, {pulley_2: radius, pulley_1: -radius}),
        (x[j] - low - half, {carriage: 1.0, pulley_2: -radius}),
        (high - x[j] - half, {pulley_1: radius, carriage: -1.0}),
    ):
        if length <= 0:
            raise ValueError(f"carriage {j + 1} is beyond its limits")
        stiffness = parameters.belt_width[j] * parameters.belt_specific_stiffness[j] / length
        span = _add(belts, "fixed", stiffness=stiffness, springlength=0.0)
        for name, coefficient in elongation.items():
            _add(span, "joint", joint=name, coef=coefficient)


def _mass(body: ET.Element, mass: float, inertia: np.ndarray, centre: np.ndarray | None = None) -> None:
    _add(body, "inertial", pos=np.zeros(3) if centre is None else centre, mass=mass, diaginertia=inertia)


def _add(parent: ET.Element, tag: str, **attributes: object) -> ET.Element:
    """Add an element, with numbers in full precision."""

    def text(value: object) -> str:
        if isinstance(value, str):
            return value
        return " ".join(repr(float(number)) for number in np.atleast_1d(np.asarray(value, dtype=float)))

    return ET.SubElement(parent, tag, {key: text(value) for key, value in attributes.items()})
