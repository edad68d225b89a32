"""How many motions strain nothing of a machine, and how many of them springs to ground hold: a rank, not all of them.

A cable at the origin of a platform that turns holds its displacements, not its rotations.  Both numbers are those of
the sample robot at a regular pose, where nothing vanishes by symmetry; they are the same at all other regular poses.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import sample_parameters, sample_pose
from pkmodes.core.system.entry_rates import spring_rates

#: An eigenvalue below this fraction of the largest is that of a motion that strains nothing.
RIGID = 1e-9


class RigidMotions(NamedTuple):
    """Numbers of motions that strain nothing of the machine.

    - rigid: those that strain no spring to ground, either
    - held: those that springs to ground hold
    """

    rigid: int
    held: int


@cache
def rigid_motions(
    mechanism: Mechanism, springs: tuple[str, ...], locked: tuple[int, ...] = ()
) -> RigidMotions:
    """Count the motions that strain nothing of a machine.

    - springs: the effect parameters that hold it to ground, by generated field
    - locked: coordinates without effects that are at rest, such as those of held motors
    """
    plain, pose, base = sample_parameters(mechanism), sample_pose(mechanism), len(mechanism.coordinates)
    none = mechanism.extended.Effects()
    kept = np.setdiff1d(np.arange(base), locked)
    place = np.ix_(kept, kept)
    M, K, _ = Generated(mechanism.extended, plain, none).extended_matrices(pose)
    scale = 1.0 / np.sqrt(np.diag(M)[kept])
    both = np.outer(scale, scale)
    levels, modes = np.linalg.eigh(K[place] * both)
    loose = modes[:, levels < RIGID * levels.max(initial=0.0)]
    if not springs or not loose.size:
        return RigidMotions(loose.shape[1], 0)
    ground = np.zeros_like(both)
    for part in spring_rates(mechanism, plain, none, pose[None], springs).values():
        scaled = part[0][place] * both
        if (size := np.linalg.norm(scaled)) > 0.0:  # 0 for a spring on what is at rest
            ground += scaled / size
    held = int(np.count_nonzero(np.linalg.eigvalsh(loose.T @ ground @ loose) > RIGID))
    return RigidMotions(loose.shape[1] - held, held)
