r"""Locked joints: derivatives with respect to their compliances, which are not part of the matrices.

To first order in the compliance c

.. math:: \frac{d}{dc} (K - \lambda M) = - B^T B, \qquad B(\lambda) = K_{rq} - \lambda M_{rq} ,

where r are the joint's coordinates, because in a mode the joint carries the force :math:`B \phi` and deflects by c
times that force.  The derivative is finite at c = 0, where the joint's stiffness is not.
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.layout import Slot
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.paths import ParameterPath

Array = NDArray[np.float64]
Index = NDArray[np.intp]


@cache
def joints_of(mechanism: Mechanism) -> dict[Slot, tuple[int, ...]]:
    """Return the coordinates that each compliance, of all joints or a single one, releases in the extended model."""
    joints: dict[Slot, tuple[int, ...]] = {}
    for effect in mechanism.effects.values():
        coordinate_index = {q.name: mechanism.extended.COORDINATES.index(q.name) for q in effect.coordinates}
        for parameter in effect.parameters:
            if parameter.releases:
                joints[f"{effect.name}.{parameter.name}", ()] = tuple(
                    coordinate_index[name] for name in parameter.releases
                )
        for name, coordinate in coordinate_index.items():
            joints[f"{effect.name}.{effect.parameters[0].name}.{name}", ()] = (coordinate,)
    return joints


class LockedJoints(NamedTuple):
    """The locked joints that parameter paths would release.

    - paths: indices of these paths, length L
    - joints: their locked coordinates, (r,)
    - weights: the compliance of each along each path, (L, r)
    - springs: the stiffness, along each path, of the springs of joints that are not locked, (L, e)
    """

    paths: tuple[int, ...]
    joints: Index
    weights: Array
    springs: Array


def locked_joints(system: ExtendedSystem, paths: Sequence[ParameterPath]) -> LockedJoints:
    """Return the locked joints that paths would release."""
    free, joints_of_slot = frozenset(system.free.tolist()), joints_of(system.mechanism)
    weights_by_path: dict[int, dict[int, float]] = {}
    for t, path in enumerate(paths):
        for slot, weight in path.weights.items():
            for q in joints_of_slot.get(slot, ()):
                if q not in free:
                    joint_weights = weights_by_path.setdefault(t, {})
                    joint_weights[q] = joint_weights.get(q, 0.0) + weight
    joints = sorted({q for joint_weights in weights_by_path.values() for q in joint_weights})
    weights = np.zeros((len(weights_by_path), len(joints)))
    springs = np.zeros((len(weights_by_path), system.joint_rates.shape[-1]))
    for row, spring, (t, joint_weights) in zip(weights, springs, weights_by_path.items(), strict=True):
        row[:] = [joint_weights.get(q, 0.0) for q in joints]
        spring[:] = springs_along(paths[t], joints_of_slot, free, np.atleast_2d(system.joint_rates)[0])
    return LockedJoints(tuple(weights_by_path), np.array(joints, dtype=np.intp), weights, springs)


def springs_along(
    path: ParameterPath, joints: Mapping[Slot, tuple[int, ...]], free: Collection[int], rates: Array
) -> Array:
    """Return the stiffness of springs along a path, (e,), of joints that are not locked."""
    springs = np.zeros(len(rates))
    for slot, weight in path.weights.items():
        for q in joints.get(slot, ()):
            if q in free:
                springs[q] += weight * rates[q]
    return springs


def released_changes(
    matrices: tuple[Array, Array],
    free: Index,
    joints: Index,
    weights: Array,
    eigenvalues: Array,
    shapes: Array,
) -> tuple[Array, Array, Array]:
    """Return the changes due to compliances of locked joints.

    - matrices: M and K in all coordinates, each (N, e, e)
    - free: (n,)
    - joints: (r,)
    - weights: the compliance of each joint along L paths, (L, r)
    - eigenvalues, shapes: (N, m) and (N, m, n)

    Returns, in this order:
    - force: B(lambda) phi, minus the deflection of a joint per unit of its compliance, (N, m, r)
    - change: of (K - lambda M) phi, -B^T B phi, (N, L, m, n)
    - norm: of phi^T M phi, by the motion of the joints, (N, L, m)
    """
    M, K = (matrix[:, joints][..., free] for matrix in matrices)
    inertia = shapes @ np.swapaxes(M, -1, -2)
    force = shapes @ np.swapaxes(K, -1, -2) - eigenvalues[..., None] * inertia
    deflection = -force[:, None] * weights[:, None]
    change = deflection @ K[:, None] - eigenvalues[:, None, :, None] * (deflection @ M[:, None])
    return force, change, 2.0 * np.sum(deflection * inertia[:, None], axis=-1)
