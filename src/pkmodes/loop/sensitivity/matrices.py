"""Derivatives of M and K along parameter paths, from the entries that the generated model evaluates."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import sample_parameters, sample_pose
from pkmodes.core.mechanism.stepped import COMPLEX_STEP
from pkmodes.core.robot.layout import Slot
from pkmodes.core.system.entry_rates import Entries, entries_of, rates_by_steps
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.locked import (
    LockedJoints,
    joints_of,
    locked_joints,
    released_changes,
    springs_along,
)
from pkmodes.loop.sensitivity.paths import ParameterPath

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Field name of slots for pose components: they are not parameters, but the matrices depend on them in the same way.
POSE = "pose"

#: Relative size of the rounding that remains when a spring is eliminated.
ELIMINATION_ROUNDING = 1e-12


def _differentiated_parameters(mechanism: Mechanism) -> tuple[Any, ...]:
    """Return the generated parameters with derivatives: field, index, entries of M and K; the geometry comes last."""
    return (*mechanism.extended.VALUE_SENSITIVITIES, *mechanism.extended.GEOMETRY_SENSITIVITIES)


@cache
def effect_fields(mechanism: Mechanism) -> dict[str, str]:
    """Return the dotted names of effect parameters, as slots have them, by their generated fields."""
    return {
        f"{effect.name}_{parameter.name}": f"{effect.name}.{parameter.name}"
        for effect in mechanism.effects.values()
        for parameter in effect.parameters
    }


@cache
def _slots(mechanism: Mechanism) -> dict[Slot, int]:
    """Return the index of each generated parameter with derivatives."""
    dotted = effect_fields(mechanism)
    return {
        (dotted.get(field, field), index): i
        for i, (field, index, *_) in enumerate(_differentiated_parameters(mechanism))
    }


@cache
def _entries(mechanism: Mechanism, matrix: int) -> Entries:
    return entries_of(_differentiated_parameters(mechanism), matrix)


@cache
def geometry_of(mechanism: Mechanism) -> frozenset[str]:
    """Return the generated parameters and effects that change the platform's motion with the coordinates."""
    fields = {field for field, *_ in mechanism.extended.GEOMETRY_SENSITIVITIES}
    fields |= {field for field, counterpart in mechanism.differences.items() if counterpart in fields}
    # Effect parameters that change that motion of the sample robot at a regular pose.
    parameters, extended, p = sample_parameters(mechanism), mechanism.extended, sample_pose(mechanism)
    for field, dotted in effect_fields(mechanism).items():
        stepped_effects = extended.Effects(**{field: COMPLEX_STEP * 1j})
        motion = Generated(extended, parameters, stepped_effects).extended_platform_motion(p)
        if np.imag(motion).any():
            fields.add(dotted)
    return frozenset(fields)


class MatrixDerivatives:
    """Matrices of a robot at some poses, and their derivatives along parameter paths.

    Several robots with the same free coordinates may be evaluated together.

    - system: one or B stacked robots, with N / B poses each
    - p: valid poses, robot by robot, (N, d)
    - paths: T paths for each robot, length B
    - matrices: M and K in all coordinates, if they were evaluated already
    - locked_paths: from `locked_joints`, if known

    Its attributes:
    - size: e, the number of base and all released coordinates
    - free: indices of the coordinates that are not locked, (n,)
    - locked_joints: the locked joints that paths would release; none for several robots
    """

    def __init__(
        self,
        system: ExtendedSystem,
        p: Array,
        paths: Sequence[Sequence[ParameterPath]],
        matrices: tuple[Array, Array] | None = None,
        locked: LockedJoints | None = None,
    ) -> None:
        self.system, self._p = system, p
        self.free, self.size = system.free, len(system.mechanism.extended.COORDINATES)
        self._matrices = matrices
        self.locked_joints = locked_joints(system, paths[0]) if locked is None else locked
        if self.locked_paths and len(paths) > 1:
            raise ValueError(
                "robots with derivatives with respect to locked joints must be evaluated one by one"
            )
        self._paths, self._robots_and_poses = paths, (len(paths), len(p) // len(paths))

    @property
    def locked_paths(self) -> tuple[int, ...]:
        """Indices of the paths that are compliances of locked joints."""
        return self.locked_joints.paths

    @cached_property
    def _directions(self) -> tuple[Array, Array, Array]:
        """Stiffness of springs, numbers with derivatives, and pose along each path of each robot."""
        system, paths = self.system, self._paths
        shape = len(paths), len(paths[0])
        springs, shift = np.zeros((*shape, self.size)), np.zeros((*shape, self._p.shape[-1]))
        slots, joints = _slots(system.mechanism), joints_of(system.mechanism)
        rates = np.atleast_2d(system.joint_rates)[:: self._robots_and_poses[1] or 1]
        free = frozenset(system.free.tolist())
        path_weights = np.zeros((shape[0], len(slots), shape[1]))
        for b, t in np.ndindex(shape):
            springs[b, t] = springs_along(paths[b][t], joints, free, rates[b])
            for slot, weight in paths[b][t].weights.items():
                if slot in joints:
                    continue
                if slot[0] == POSE:
                    shift[b, t, slot[1]] += weight
                elif slot in slots:
                    path_weights[b, slots[slot], t] += weight
                else:  # the field enters only as the difference from another field
                    path_weights[b, slots[system.mechanism.differences[slot[0]], slot[1]], t] -= weight
        return springs, path_weights, shift

    @property
    def _springs(self) -> Array:
        return self._directions[0]

    @property
    def _pose_shift(self) -> Array:
        return self._directions[2]

    @cached_property
    def _path_weights(self) -> tuple[Array, Array]:
        path_weights, mechanism = self._directions[1], self.system.mechanism
        return path_weights[:, _entries(mechanism, 0).slot], path_weights[:, _entries(mechanism, 1).slot]

    @cached_property
    def _entry_rates(self) -> tuple[Array, Array]:
        """Derivatives of the entries of M and K, each (N, entries).

        Those with respect to the geometry come last and take most of the time; they are zero if no path needs them.
        """
        extended = self.system.mechanism.extended
        if not self.system.generated.has("value_sensitivities"):
            changing = np.flatnonzero(self._directions[1].any(axis=(0, 2)))
            system, parameters = self.system, _differentiated_parameters(self.system.mechanism)
            return rates_by_steps(
                system.mechanism, system.parameters, system.effects, self._p, parameters, changing
            )
        values = self.system.evaluate_function("value_sensitivities", self._p)
        if self._directions[1][:, len(extended.VALUE_SENSITIVITIES) :].any():
            geometry = self.system.evaluate_function("geometry_sensitivities", self._p)
        else:
            counts = (sum(len(entry[k]) for entry in extended.GEOMETRY_SENSITIVITIES) for k in (2, 3))
            geometry = tuple(np.zeros((len(self._p), count)) for count in counts)
        of_M, of_K = (np.hstack(arrays) for arrays in zip(values, geometry, strict=True))
        return of_M, of_K

    @cached_property
    def _pose_rates(self) -> tuple[Array, Array] | None:
        """Derivatives of M and K in all coordinates with respect to the pose, each (N, d, e, e), if a path moves it.

        They are computed by complex step, which is exact to rounding: the generated functions accept complex poses.
        """
        if not self._pose_shift.any():
            return None
        stepped_poses = self._p + COMPLEX_STEP * 1j * np.eye(self._p.shape[-1])[:, None]
        M, K_el, K_g = self.system.generated.extended_matrices(stepped_poses)
        dM, dK = (np.moveaxis(np.imag(a) / COMPLEX_STEP, 0, 1) for a in (M, K_el + K_g))
        return dM, dK

    @property
    def mass(self) -> Array:
        """M in all coordinates, (N, e, e); locked joints are free in it."""
        return self._all_coordinates[0]

    @property
    def stiffness(self) -> Array:
        """K in all coordinates, (N, e, e); locked joints are free in it, without a spring."""
        return self._all_coordinates[1]

    @cached_property
    def _all_coordinates(self) -> tuple[Array, Array]:
        return self.system.all_coordinates(self._p) if self._matrices is None else self._matrices

    def dense(self, poses: Index | None = None) -> tuple[Array, Array]:
        """Evaluate dM and dK along each path, (N, T, n, n), in the free coordinates, at some or all poses.

        They are NaN for the compliance of a locked joint, which is not in the matrices.
        """
        return self._dense if poses is None else self._dense_at(poses)

    @cached_property
    def _dense(self) -> tuple[Array, Array]:
        return self._dense_at(slice(None))

    def _dense_at(self, poses: Index | slice) -> tuple[Array, Array]:
        robot = np.repeat(np.arange(self._robots_and_poses[0]), self._robots_and_poses[1])[poses]
        derivatives = []
        for matrix in (0, 1):
            _, row, column = _entries(self.system.mechanism, matrix)
            path_weights, entry_rates = self._path_weights[matrix], self._entry_rates[matrix][poses]
            full = np.zeros((len(entry_rates), path_weights.shape[-1], self.size, self.size))
            entry, t = np.nonzero(path_weights.any(axis=0))
            flat_index = (t * self.size + row[entry]) * self.size + column[entry]
            for pose_matrices, change in zip(
                full, entry_rates[:, entry] * path_weights[:, entry, t][robot], strict=True
            ):
                # Numbers that a path moves together may change one entry.
                pose_matrices[...] = np.bincount(flat_index, change, pose_matrices.size).reshape(
                    pose_matrices.shape
                )
            full += np.swapaxes(np.triu(full, 1), -1, -2)
            if self._pose_rates is not None:
                full += np.einsum("ntd,ndab->ntab", self._pose_shift[robot], self._pose_rates[matrix][poses])
            full = self.system.in_basis(full)
            if matrix == 1:
                diagonal = np.arange(full.shape[-1])
                full[..., diagonal, diagonal] += self._springs[robot]
            full[:, list(self.locked_paths)] = np.nan
            derivatives.append(full[..., self.free[:, None], self.free])
        return derivatives[0], derivatives[1]

    def eigenvalues(self, eigenvalues: Array, shapes: Array) -> Array:
        """Compute derivatives of simple eigenvalues, phi^T (dK - lambda dM) phi with phi^T M phi = 1.

        - eigenvalues: (N, m)
        - shapes: in the free coordinates, mass-normalised, (N, m, n)

        Returns (N, m, T).
        """
        phi = np.zeros((*shapes.shape[:-1], self.size))
        phi[..., self.free] = shapes
        phi = self.system.to_model_coordinates(phi)  # in all coordinates of the generated model, (N, m, e)
        parts = []
        for matrix in (0, 1):
            # The entries that change along any path.
            changing = np.flatnonzero(self._path_weights[matrix].any(axis=(0, 2)))
            _, row, column = (indices[changing] for indices in _entries(self.system.mechanism, matrix))
            products = phi[..., row] * phi[..., column] * np.where(row == column, 1.0, 2.0)
            products *= self._entry_rates[matrix][:, None, changing]
            part = self._by_robot(products) @ self._path_weights[matrix][:, changing]
            if self._pose_rates is not None:
                pose_products = np.einsum(
                    "nia,ndab,nib->nid", phi, self._pose_rates[matrix], phi, optimize=True
                )
                part += self._by_robot(pose_products) @ np.swapaxes(self._pose_shift, 1, 2)
            parts.append(part)
        spring_products = self._by_robot(phi**2) @ np.swapaxes(self._springs, 1, 2)
        rates = (parts[1] + spring_products).reshape(*shapes.shape[:2], self._springs.shape[1])
        rates -= eigenvalues[..., None] * parts[0].reshape(rates.shape)
        self._add_locked(rates, eigenvalues, shapes)
        return np.asarray(rates)

    def _add_locked(self, rates: Array, eigenvalues: Array, shapes: Array) -> None:
        """Add the derivatives of eigenvalues with respect to the compliances of locked joints, (N, m, T)."""
        if self.locked_paths:
            force, _, _ = self._released(eigenvalues, shapes)
            rates[..., list(self.locked_paths)] -= force**2 @ self.locked_joints.weights.T

    def changes(self, eigenvalues: Array, shapes: Array, poses: Index | None = None) -> tuple[Array, Array]:
        """Evaluate (dK - lambda dM) phi, (N, T, m, n), and phi^T dM phi, (N, T, m), along each path.

        - eigenvalues, shapes: (N, m) and (N, m, n)
        - poses: those requested, by default all
        """
        dM, dK = self.dense(poses)
        selected = slice(None) if poses is None else poses
        modes = np.swapaxes(shapes[selected], -1, -2)[:, None]
        inertia = dM @ modes
        change = np.swapaxes(dK @ modes - inertia * eigenvalues[selected, None, None], -1, -2)
        norm = np.einsum("nia,ntai->nti", shapes[selected], inertia)
        return self._with_locked(change, norm, eigenvalues, shapes, selected)

    def _with_locked(
        self,
        change: Array,
        norm: Array,
        eigenvalues: Array,
        shapes: Array,
        poses: Index | slice = slice(None),
    ) -> tuple[Array, Array]:
        """Insert the changes by compliances of locked joints into the results of `changes`."""
        if self.locked_paths:
            # -B^T B phi at each mode's eigenvalue, plus the springs of the path's joints that are not locked, and
            # the change of the modal mass due to the motion of the joint.
            _, locked_change, locked_norm = self._released(eigenvalues, shapes)
            springs = self.locked_joints.springs[:, self.free]
            locked_change = springs[:, None] * shapes[:, None] + locked_change
            locked = list(self.locked_paths)
            change[:, locked], norm[:, locked] = locked_change[poses], locked_norm[poses]
        return change, norm

    def motions(self, shapes: Array) -> Array | None:
        """Return the derivatives of the platform's motion in fixed shapes, (N, T, m, components), if known."""
        return None

    def locked_motions(self, eigenvalues: Array, shapes: Array) -> Array:
        """Compute the deflection of locked joints under their forces along the paths in `locked`, (N, L, m, e)."""
        force, locked = self._released(eigenvalues, shapes)[0], self.locked_joints
        motions = np.zeros((len(shapes), len(self.locked_paths), shapes.shape[1], self.size))
        motions[..., locked.joints] = -force[:, None] * locked.weights[:, None]
        return motions

    def _released(self, eigenvalues: Array, shapes: Array) -> tuple[Array, Array, Array]:
        matrices, locked = (self.mass, self.stiffness), self.locked_joints
        return released_changes(matrices, self.free, locked.joints, locked.weights, eigenvalues, shapes)

    def stiff_change(self, pose: int, eigenvalues: Array, shapes: Array, dM: Array, dK: Array) -> Array:
        """Compute (dK - lambda dM) phi for modes of stiff joints, up to a multiple of M phi, which rotates no shape.

        In the mode of a joint of compliance c, the derivative -1/c^2 of its spring cancels in the shape derivative,
        and the remainder is far smaller than the rounding of the cancelling terms.  Adding the multiple of
        K phi = lambda M phi that eliminates the spring puts the rest of K in its place.

        - pose: index of the pose
        - eigenvalues, shapes: (m,) and (m, n)
        - dM, dK: from `dense`, (T, n, n)

        Returns (T, m, n).
        """
        free, diagonal = self.free, np.arange(len(self.free))
        springs, joints = self._springs[0][:, free], self.system.joints[free]
        _, K = self.system.without_springs(self._p[pose : pose + 1])
        without_springs_force = shapes @ K[0][np.ix_(free, free)]
        without_springs = dK.copy()
        without_springs[:, diagonal, diagonal] -= springs
        strain = shapes**2 @ joints
        factor = -(shapes**2 @ springs.T) / np.where(strain > 0.0, strain, 1.0)[:, None]
        remainder = springs[:, None] + factor.T[..., None] * joints
        remainder[np.abs(remainder) < ELIMINATION_ROUNDING * np.abs(springs[:, None])] = 0.0
        change = np.einsum("tab,ib->tia", without_springs, shapes)
        change -= eigenvalues[:, None] * np.einsum("tab,ib->tia", dM, shapes)
        return np.asarray(change + remainder * shapes + factor.T[..., None] * without_springs_force)

    def _by_robot(self, values: Array) -> Array:
        """Reshape (N, m, ...) to (B, N m / B, ...), one block for each robot."""
        robots, poses = self._robots_and_poses
        return values.reshape(robots, poses * values.shape[1], values.shape[-1])
