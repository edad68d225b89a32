r"""Derivatives of M and K along parameter paths, from the entries that the generated model evaluates.

A released joint that is locked is not in the matrices.  Its compliance c is felt all the same: to first order

.. math:: \frac{d}{dc} (K - \lambda M) = - B^T B, \qquad B(\lambda) = K_{rq} - \lambda M_{rq} ,

where r are the joint's coordinates, because in a mode the joint carries the force :math:`B \phi` and yields by
c times as much.  The derivative is finite at c = 0, where the joint's stiffness is not.
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.evaluation import SystemOfEffects
from pkmodes.robot.layout import Slot
from pkmodes.robot.paths import ParameterPath
from pkmodes_generated.linear_delta import extended

Array = NDArray[np.float64]
Index = NDArray[np.intp]


#: Generated parameters by which there are derivatives: field, index, entries of M and of K; the geometry comes last.
LISTED = (*extended.VALUE_SENSITIVITIES, *extended.GEOMETRY_SENSITIVITIES)

#: What rounding leaves of a spring that was taken out.
TAKEN_OUT = 1e-12


class Entries(NamedTuple):
    """Which entries of a symmetric matrix the generated derivatives are, in their order.

    Attributes
    ----------
    slot, row, column : ndarray of int, shape (E,)
        By which parameter, and the place in the upper triangle.
    """

    slot: Index
    row: Index
    column: Index


@cache
def _slots() -> dict[Slot, int]:
    """Generated parameters by which there are derivatives; effects by their dotted names."""
    return {(_dotted(field), index): i for i, (field, index, *_) in enumerate(LISTED)}


@cache
def _entries(matrix: int) -> Entries:
    places = [(i, *place) for i, entry in enumerate(LISTED) for place in entry[2 + matrix]]
    return Entries(*(np.array(column, dtype=np.intp) for column in zip(*places, strict=True)))


@cache
def _dotted(field: str) -> str:
    """Name of a field of the generated effects as the robot file has it."""
    for name, *_, parameters in extended.EFFECTS:
        for parameter, *_ in parameters:
            if field == f"{name}_{parameter}":
                return f"{name}.{parameter}"
    return field


@cache
def _joints() -> dict[Slot, tuple[int, ...]]:
    """Coordinates that each compliance releases in the extended model, of all joints or of a single one."""
    found: dict[Slot, tuple[int, ...]] = {}
    for name, _, _, coordinates, parameters in extended.EFFECTS:
        place = tuple(extended.COORDINATES.index(q) for q in coordinates)
        if place:
            found[f"{name}.{parameters[0][0]}", ()] = place
        for q, one in zip(coordinates, place, strict=True):
            found[f"{name}.{parameters[0][0]}.{q}", ()] = (one,)
    return found


def locked_joints(
    system: SystemOfEffects, paths: Sequence[ParameterPath]
) -> dict[int, list[tuple[tuple[int, ...], float]]]:
    """Locked joints that paths would release: by the number of the path, their coordinates and weights."""
    free = set(system.free)
    found: dict[int, list[tuple[tuple[int, ...], float]]] = {}
    for t, path in enumerate(paths):
        for slot, weight in path.weights.items():
            place = tuple(q for q in _joints().get(slot, ()) if q not in free)
            if place:
                found.setdefault(t, []).append((place, weight))
    return found


class MatrixDerivatives:
    """Matrices of a robot at some poses, and how they change along parameter paths.

    Several robots that have the same free coordinates may be evaluated together.

    Parameters
    ----------
    system : SystemOfEffects
        Of B robots, at N / B poses each.
    p : ndarray, shape (N, 3)
        Platform centres that can be evaluated [m], those of the first robot first.
    paths : sequence of sequence of ParameterPath, length B
        T of them for each robot.
    matrices : tuple of ndarray, optional
        M and K in all coordinates, where they were evaluated already.

    Attributes
    ----------
    M, K : ndarray, shape (N, e, e)
        In the base and all released coordinates; the rows of locked ones are those of free joints.
    free : ndarray of int, shape (n,)
        The coordinates that are not locked.
    locked : tuple of int
        Those of the paths that are compliances of locked joints; there may be such with one robot only.
    """

    def __init__(
        self,
        system: SystemOfEffects,
        p: Array,
        paths: Sequence[Sequence[ParameterPath]],
        matrices: tuple[Array, Array] | None = None,
    ) -> None:
        self._system, self._p = system, p
        self.free = system.free
        self.M, self.K = system.all_coordinates(p) if matrices is None else matrices
        self._locked = locked_joints(system, paths[0])
        self.locked = tuple(self._locked)
        if self.locked and len(paths) > 1:
            raise ValueError("robots with derivatives by locked joints are evaluated one by one")
        shape = len(paths), len(paths[0])
        each = len(p) // shape[0]
        rates = np.atleast_2d(system.joint_rates)[:: each or 1]
        springs = np.zeros((*shape, self.M.shape[-1]))
        slots, along, free = _slots(), np.zeros((shape[0], len(_slots()), shape[1])), set(system.free)
        for b, t in np.ndindex(shape):
            for (field, index), weight in paths[b][t].weights.items():
                if (field, index) in _joints():
                    place = [q for q in _joints()[field, index] if q in free]
                    springs[b, t, place] += weight * rates[b, place]
                elif field == "origin":  # it enters only through its difference from the platform joint
                    along[b, slots["joint", index], t] -= weight
                else:
                    along[b, slots[field, index], t] += weight
        self._springs, self._each = springs, (shape[0], each)
        self._along = tuple(along[:, _entries(matrix).slot] for matrix in (0, 1))
        geometry = bool(along[:, len(extended.VALUE_SENSITIVITIES) :].any())
        self._values = system.derivatives(p, geometry=geometry)

    def dense(self, poses: Index | slice = slice(None)) -> tuple[Array, Array]:
        """Evaluate dM and dK by each path, (N, T, n, n), in the free coordinates, at some or all of the poses.

        NaN for the compliance of a locked joint, which is not in the matrices.
        """
        robot = np.repeat(np.arange(self._each[0]), self._each[1])[poses]
        found = []
        for matrix in (0, 1):
            entries = _entries(matrix)
            values = self._values[matrix][poses]
            full = np.zeros((len(values), self._springs.shape[1], *self.M.shape[1:]))
            for t in range(full.shape[1]):
                along = self._along[matrix][..., t]
                some = np.flatnonzero(
                    along.any(axis=0)
                )  # numbers that a path moves together may change one entry
                change = (values[:, some] * along[:, some][robot]).T
                np.add.at(np.moveaxis(full[:, t], 0, -1), (entries.row[some], entries.column[some]), change)
            full += np.swapaxes(np.triu(full, 1), -1, -2)
            if matrix == 1:
                diagonal = np.arange(full.shape[-1])
                full[..., diagonal, diagonal] += self._springs[robot]
            full[:, list(self.locked)] = np.nan
            found.append(full[..., self.free[:, None], self.free])
        return found[0], found[1]

    def eigenvalues(self, eigenvalues: Array, shapes: Array) -> Array:
        """Derivatives of simple eigenvalues, phi^T (dK - lambda dM) phi with phi^T M phi = 1.

        Parameters
        ----------
        eigenvalues : ndarray, shape (N, m)
        shapes : ndarray, shape (N, m, n)
            In the free coordinates, mass-normalised.

        Returns
        -------
        ndarray, shape (N, m, T)
        """
        phi = self._embedded(shapes)
        parts = []
        for matrix in (0, 1):
            some = self._moving(matrix)
            row, column = _entries(matrix).row[some], _entries(matrix).column[some]
            both = phi[..., row] * phi[..., column] * np.where(row == column, 1.0, 2.0)
            both *= self._values[matrix][:, None, some]
            parts.append(self._of_each(both) @ self._along[matrix][:, some])
        strained = self._of_each(phi**2) @ np.swapaxes(self._springs, 1, 2)
        found = (parts[1] + strained).reshape(*shapes.shape[:2], self._springs.shape[1])
        found -= eigenvalues[..., None] * parts[0].reshape(found.shape)
        for t in self.locked:
            for joints, weight in self._locked[t]:
                force = self.joint_forces(eigenvalues, shapes, joints)
                found[..., t] -= weight * np.sum(force**2, axis=-1)
        return np.asarray(found)

    def joint_forces(self, eigenvalues: Array, shapes: Array, joints: Sequence[int]) -> Array:
        """Forces B(lambda) phi that locked joints carry in each mode, (N, m, r)."""
        K, M = (
            (a[:, list(joints)][..., self.free] @ np.swapaxes(shapes, -1, -2)).swapaxes(-1, -2)
            for a in (self.K, self.M)
        )
        return np.asarray(K - eigenvalues[..., None] * M)

    def locked_motion(self, t: int, eigenvalues: Array, shapes: Array) -> Array:
        """How locked joints yield to what they carry, per unit of their compliance, (N, m, e)."""
        found = np.zeros((*shapes.shape[:-1], self.M.shape[-1]))
        for joints, weight in self._locked[t]:
            found[..., list(joints)] -= weight * self.joint_forces(eigenvalues, shapes, joints)
        return found

    def locked_change(self, t: int, eigenvalues: Array, shapes: Array) -> tuple[Array, Array]:
        """For the compliance of a locked joint: what replaces (dK - lambda dM) phi, and phi^T dM phi.

        Returns
        -------
        change : ndarray, shape (N, m, n)
            -B^T B phi, at each mode's own eigenvalue, and the springs of its joints that are not locked.
        norm : ndarray, shape (N, m)
            Change of the modal mass by the motion of the joint.
        """
        change, norm = self._springs[0, t, self.free] * shapes, np.zeros_like(eigenvalues)
        for joints, weight in self._locked[t]:
            force = self.joint_forces(eigenvalues, shapes, joints)
            K, M = (a[:, list(joints)][..., self.free] for a in (self.K, self.M))
            change -= weight * (force @ K - eigenvalues[..., None] * (force @ M))
            norm -= weight * 2.0 * np.sum(force * (shapes @ np.swapaxes(M, -1, -2)), axis=-1)
        return change, norm

    def stiff_change(self, pose: int, eigenvalues: Array, shapes: Array, dM: Array, dK: Array) -> Array:
        """(dK - lambda dM) phi for the shapes of modes of stiff joints, up to a multiple of M phi, which turns none.

        In the mode of a joint of compliance c the spring's derivative -1/c^2 and what follows from it cancel, and
        what is left is smaller by far than their rounding.  The multiple of K phi = lambda M phi that takes the
        spring out leaves the rest of K in its place.

        Parameters
        ----------
        pose : int
            Which of the poses.
        eigenvalues, shapes : ndarray, shapes (m,) and (m, n)
        dM, dK : ndarray, shape (T, n, n)
            As from `dense`.

        Returns
        -------
        ndarray, shape (T, m, n)
        """
        free, diagonal = self.free, np.arange(len(self.free))
        springs, joints = self._springs[0][:, free], self._system.joints[free]
        _, K = self._system.without_springs(self._p[pose : pose + 1])
        rest = shapes @ K[0][np.ix_(free, free)]
        others = dK.copy()
        others[:, diagonal, diagonal] -= springs
        strained = shapes**2 @ joints
        factor = -(shapes**2 @ springs.T) / np.where(strained > 0.0, strained, 1.0)[:, None]
        left = springs[:, None] + factor.T[..., None] * joints
        left[np.abs(left) < TAKEN_OUT * np.abs(springs[:, None])] = 0.0
        change = np.einsum("tab,ib->tia", others, shapes)
        change -= eigenvalues[:, None] * np.einsum("tab,ib->tia", dM, shapes)
        return np.asarray(change + left * shapes + factor.T[..., None] * rest)

    def _moving(self, matrix: int) -> Index:
        """Entries of M or K that change along some path."""
        return np.flatnonzero(self._along[matrix].any(axis=(0, 2)))

    def _of_each(self, values: Array) -> Array:
        """(N, m, ...) to (B, N m / B, ...): what belongs to each robot."""
        robots, poses = self._each
        return values.reshape(robots, poses * values.shape[1], values.shape[-1])

    def _embedded(self, shapes: Array) -> Array:
        phi = np.zeros((*shapes.shape[:-1], self.M.shape[-1]))
        phi[..., self.free] = shapes
        return phi
