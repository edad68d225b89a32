"""The virtual test rig: the true modes of a robot with any effects, including causes outside the catalogue.

MuJoCo models the robot as bodies, joints and springs (`pkmodes_rig.description`) and supplies positions, Jacobians,
inertia, spring forces and accelerations.  This module closes the loops, projects onto the motions that they allow,
and solves.  No formula of the derived model and no finite differences are used: the second derivatives of the
gravity potential follow from the engine's accelerations at constant rates of the coordinates.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

import mujoco
import numpy as np

from pkmodes_generated.linear_delta import Parameters
from pkmodes_rig.description import AXES, EFFECTS, OUTSIDE, describe

__all__ = ["EFFECTS", "OUTSIDE", "Rig", "TrueModes", "true_modes"]

JOINT, SITE, BODY, TENDON = (
    mujoco.mjtObj.mjOBJ_JOINT,
    mujoco.mjtObj.mjOBJ_SITE,
    mujoco.mjtObj.mjOBJ_BODY,
    mujoco.mjtObj.mjOBJ_TENDON,
)

#: Coordinates that do not move the centre of mass of any body with weight.
WEIGHTLESS = ("theta", "psi", "eps", "mount")

#: A mode with a ratio of strain to kinetic energy below this fraction of the largest is a rigid-body mode.
RIGID = 1e-12


@dataclass(frozen=True)
class TrueModes:
    """The result of an ideal modal analysis of the robot at one pose.

    Attributes
    ----------
    frequencies : ndarray, shape (m,)
        sqrt(abs(lambda)) / (2 pi) with the sign of lambda [Hz], ascending.
    rigid : int
        Number of rigid-body modes, which come first: 3, or fewer if something ties the robot to ground.
    shapes : dict of str to ndarray, shape (m,)
        Mass-normalised component of each mode at every coordinate and at ``p_x p_y p_z``, the absolute motion of
        the platform.
    mass_matrix, stiffness_matrix : ndarray, shape (n, n)
        In the order of `coordinates`, including coordinates without inertia.
    coordinates : tuple of str, length n
        The coordinates of the software, then those that exist only on the rig; without rotors that follow others.
    held : bool
        Whether the rotors of the motors were locked.
    """

    frequencies: np.ndarray
    rigid: int
    shapes: dict[str, np.ndarray]
    mass_matrix: np.ndarray
    stiffness_matrix: np.ndarray
    coordinates: tuple[str, ...]
    held: bool = False


def true_modes(
    parameters: Parameters,
    p: np.ndarray,
    effects: Mapping[str, float] = {},
    outside: Mapping[str, float] = {},
    *,
    held: bool = False,
) -> TrueModes:
    """Compute the modes of one robot at one pose.

    Parameters
    ----------
    parameters : Parameters
        One robot, without batch axes.
    p : array, shape (3)
        Platform centre [m].
    effects : mapping
        Parameters of effects in SI units, by ``"<effect>.<parameter>"``.
    outside : mapping
        Strengths of causes in `OUTSIDE`; ``thermal_drift`` affects the measurement only and is ignored here.
    held : bool
        Whether the rotors of the motors are locked.
    """
    return Rig(parameters, p, effects, outside, held=held).modes()


class Rig:
    """A robot on the rig at one pose; the arguments are those of `true_modes`."""

    def __init__(
        self,
        parameters: Parameters,
        p: np.ndarray,
        effects: Mapping[str, float] = {},
        outside: Mapping[str, float] = {},
        *,
        held: bool = False,
    ) -> None:
        self.gravity, self.held = np.asarray(parameters.gravity, dtype=float), held
        self._description = describe(parameters, p, effects, outside)
        self.model = mujoco.MjModel.from_xml_string(self._description.xml)
        for name in self._description.points:
            self.model.body_inertia[self._id(BODY, name)] = 0
        for name in self._description.massless:
            self.model.body_mass[self._id(BODY, name)] = 0
        self.data = mujoco.MjData(self.model)
        # A locked rotor takes the place of the pulley that it turns, and then has no motion.
        joints, locked = self._description.coordinates, self._description.motors if held else {}
        self._dofs = [self._dof(locked.get(name, joint)) for name, joint in joints.items()]
        self._free = [i for i, name in enumerate(joints) if name not in locked]
        self.coordinates = tuple(name for name in joints if name not in locked)
        self._followers = {name: self._dof(joints[name]) for name in locked}
        self._platform = [self._dof(f"platform_{i}") for i in "xyz"]
        self._ends = [self._id(SITE, f"rod_end_{j}") for j in AXES]
        self._joints = [self._id(SITE, f"platform_joint_{j}") for j in AXES]
        self._elongations, self._springs = self._tendons_and_springs()
        self._place()
        if np.abs(self.gaps()).max() > 1e-12:
            raise ValueError("the rods do not reach their platform joints")

    # Quantities from the engine ----------------------------------------------------------------------------

    def move(self, q: np.ndarray) -> None:
        """Displace the coordinates to `q` from the pose, at rest, and close the loops by Newton's method."""
        addresses = [self.model.jnt_qposadr[self.model.dof_jntid[i]] for i in self._dofs]
        for _ in range(20):
            left = np.concatenate([-np.ravel(self.gaps()), q - self.data.qpos[addresses]])
            if np.abs(left).max() < 1e-14:
                return
            rows = np.r_[0:9, -len(q) : 0]
            mujoco.mj_integratePos(self.model, self.data.qpos, self._solved[:, rows] @ left, 1.0)
            self._place()
        raise ValueError(f"the loops do not close: residual {np.abs(left).max():.1e} m")

    def weight_energy(self) -> float:
        """Return the gravity potential of all bodies."""
        return -float(self.model.body_mass @ self.data.xipos @ self.gravity)

    def _place(self) -> None:
        """Update positions and inertia at rest; the engine's full step would require inertia in every joint."""
        mujoco.mj_kinematics(self.model, self.data)
        mujoco.mj_comPos(self.model, self.data)
        getattr(mujoco, "mj_makeM", mujoco.mj_crb)(self.model, self.data)  # renamed in MuJoCo 3.3
        self.__dict__.pop("motions", None)
        self.__dict__.pop("_solved", None)

    def gaps(self) -> np.ndarray:
        """Return the vectors from each platform joint to the end of its rod."""
        return np.array([self.data.site_xpos[a] - self.data.site_xpos[b] for a, b in self._pins])

    @cached_property
    def _pins(self) -> list[tuple[int, int]]:
        return list(zip(self._ends, self._joints, strict=True))

    def _tendons_and_springs(self) -> tuple[np.ndarray, np.ndarray]:
        """Return tendon lengths and resisting spring forces per joint displacement; all are linear."""
        lengths = np.zeros((self.model.ntendon, self.model.nv))
        forces = np.zeros((self.model.nv, self.model.nv))
        rest = self.data.qpos.copy()
        for joint in range(self.model.njnt):
            if self.model.jnt_type[joint] != mujoco.mjtJoint.mjJNT_BALL:
                self.data.qpos[self.model.jnt_qposadr[joint]] = 1.0
                mujoco.mj_tendon(self.model, self.data)
                mujoco.mj_passive(self.model, self.data)
                dof = self.model.jnt_dofadr[joint]
                lengths[:, dof], forces[:, dof] = self.data.ten_length, -self.data.qfrc_passive
                self.data.qpos[:] = rest
        return lengths, forces

    @cached_property
    def _solved(self) -> np.ndarray:
        """Joint velocities per rate of the gaps (9), spin of the rods (3), and rates of ties and coordinates."""
        ahead, behind = np.zeros((2, 3, self.model.nv))
        closure = []
        for end, joint in self._pins:
            mujoco.mj_jacSite(self.model, self.data, ahead, None, end)
            mujoco.mj_jacSite(self.model, self.data, behind, None, joint)
            closure.append(ahead - behind)
        rows = np.eye(self.model.nv)
        # The engine expresses the velocity of a ball joint in the frame of the rod, whose z axis is along the rod.
        spin = rows[[self._dof(f"ball_{j}") + 2 for j in AXES]]
        ties = self._elongations[[self._id(TENDON, name) for name in self._description.ties]]
        return np.linalg.inv(np.vstack([*closure, spin, ties, rows[self._dofs]]))

    @cached_property
    def motions(self) -> np.ndarray:
        """Joint velocities that loops and gears allow, per rate of each coordinate."""
        return self._solved[:, -len(self._dofs) :][:, self._free]

    def mass_matrix(self) -> np.ndarray:
        """Compute the mass matrix in the coordinates: bodies and lumps of belt."""
        N = self.motions
        columns = np.zeros((len(self.coordinates), self.model.nv))
        for column, motion in zip(columns, np.ascontiguousarray(N.T), strict=True):
            mujoco.mj_mulM(self.model, self.data, column, motion)
        M = N.T @ columns.T
        for name, mass in self._description.belt_lumps.items():
            rate = self._elongations[self._id(TENDON, name)] @ N
            M += mass * np.outer(rate, rate)
        return (M + M.T) / 2

    def elastic_stiffness(self) -> np.ndarray:
        """Compute the stiffness of all springs, relaxed at the pose."""
        K = self.motions.T @ self._springs @ self.motions
        return (K + K.T) / 2

    def weight_hessian(self) -> np.ndarray:
        """Compute the second derivatives of the gravity potential.

        At constant rates of the coordinates, the second time derivative of the potential is the quadratic form of the
        Hessian in the rates, and it equals minus the weights times the accelerations of their bodies.
        """
        n = len(self.coordinates)
        moving = [i for i, name in enumerate(self.coordinates) if not name.startswith(WEIGHTLESS)]
        weighty = (np.flatnonzero(self.model.body_mass[1:]) + 1).tolist()
        forces, jacobian = np.zeros(self.model.nv), np.zeros((3, self.model.nv))
        for body in weighty:
            mujoco.mj_jacBodyCom(self.model, self.data, jacobian, None, body)
            forces += self.model.body_mass[body] * self.gravity @ jacobian
        holding = forces @ self._solved[:, :9]  # forces carried by the pins

        def energy_rate(rates: np.ndarray) -> float:
            self.data.qvel[:], self.data.qacc[:] = self.motions @ rates, 0
            mujoco.mj_comVel(self.model, self.data)
            mujoco.mj_rnePostConstraint(self.model, self.data)
            drift = [self._acceleration(SITE, a) - self._acceleration(SITE, b) for a, b in self._pins]
            falling = sum(self.model.body_mass[b] * self._acceleration(BODY, b) for b in weighty)
            return float(holding @ np.ravel(drift) - self.gravity @ falling)

        H, units = np.zeros((n, n)), np.eye(n)
        for i in moving:
            H[i, i] = energy_rate(units[i])
        for a, i in enumerate(moving):
            for k in moving[:a]:
                H[i, k] = H[k, i] = (energy_rate(units[i] + units[k]) - H[i, i] - H[k, k]) / 2
        self.data.qvel[:] = 0
        return H

    # Modes -------------------------------------------------------------------------------------------------

    def modes(self) -> TrueModes:
        """Solve the eigenproblem; coordinates without inertia follow the others statically."""
        M, elastic = self.mass_matrix(), self.elastic_stiffness()
        K = elastic + self.weight_hessian()
        light = np.diag(M) == 0
        if np.any(M[light]):
            raise ValueError("a coordinate without inertia is coupled to others by inertia")
        follow = np.eye(len(M))[:, ~light]
        follow[light] = -np.linalg.solve(K[np.ix_(light, light)], K[np.ix_(light, ~light)])
        scale = 1 / np.sqrt(np.diag(M)[~light])
        root = np.linalg.inv(np.linalg.cholesky(M[np.ix_(~light, ~light)] * np.outer(scale, scale))).T
        basis = follow @ (scale[:, None] * root)  # all coordinates in terms of orthonormal ones
        eigenvalues, vectors = np.linalg.eigh(basis.T @ K @ basis)
        strains = np.linalg.eigvalsh(basis.T @ elastic @ basis)
        shapes = basis @ vectors
        named, moved = dict(zip(self.coordinates, shapes, strict=True)), self.motions @ shapes
        named |= {name: moved[dof] for name, dof in self._followers.items()}
        named |= dict(zip(("p_x", "p_y", "p_z"), moved[self._platform], strict=True))
        return TrueModes(
            frequencies=np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2 * np.pi),
            rigid=int(np.sum(strains < RIGID * strains[-1])),
            shapes=named,
            mass_matrix=M,
            stiffness_matrix=K,
            coordinates=self.coordinates,
            held=self.held,
        )

    # -------------------------------------------------------------------------------------------------------

    def _acceleration(self, kind: mujoco.mjtObj, index: int) -> np.ndarray:
        acceleration = np.empty(6)
        mujoco.mj_objectAcceleration(self.model, self.data, kind, index, acceleration, 0)
        return acceleration[3:]

    def _id(self, kind: mujoco.mjtObj, name: str) -> int:
        return int(mujoco.mj_name2id(self.model, kind, name))

    def _dof(self, joint: str) -> int:
        return int(self.model.jnt_dofadr[self._id(JOINT, joint)])
