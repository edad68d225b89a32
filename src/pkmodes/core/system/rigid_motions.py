"""Number of motions that strain nothing of a machine, and how many of them springs to ground hold.

The springs hold as many as their rank, which may not be all.  A cable at the origin of a platform that turns holds
its displacements, not its rotations.  Both numbers are those of the sample robot at a regular pose, where nothing
vanishes by symmetry; they are the same at all other regular poses.
"""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np

from pkmodes.core.base.errors import PkmodesError
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

    Raises PkmodesError if the description has a sample without inertia.
    """
    parameters, pose, base_count = (
        sample_parameters(mechanism),
        sample_pose(mechanism),
        len(mechanism.coordinates),
    )
    no_effects = mechanism.extended.Effects()
    unlocked = np.setdiff1d(np.arange(base_count), locked)
    block = np.ix_(unlocked, unlocked)
    M, K, _ = Generated(mechanism.extended, parameters, no_effects).extended_matrices(pose)
    inertia = np.diag(M)[unlocked]
    if not (inertia > 0.0).all():
        problem = f"the sample robot of {mechanism.name} has a coordinate without positive inertia"
        raise PkmodesError(problem, "description.json: sample", "restore the file, or generate it again")
    scale = 1.0 / np.sqrt(inertia)
    scaling = np.outer(scale, scale)
    eigenvalues, modes = np.linalg.eigh(K[block] * scaling)
    loose_modes = modes[:, eigenvalues < RIGID * eigenvalues.max(initial=0.0)]
    if not springs or not loose_modes.size:
        return RigidMotions(loose_modes.shape[1], 0)
    ground = np.zeros_like(scaling)
    for stiffness in spring_rates(mechanism, parameters, no_effects, pose[None], springs).values():
        scaled = stiffness[0][block] * scaling
        if (norm := np.linalg.norm(scaled)) > 0.0:  # 0 for a spring on a body at rest
            ground += scaled / norm
    held = int(np.count_nonzero(np.linalg.eigvalsh(loose_modes.T @ ground @ loose_modes) > RIGID))
    return RigidMotions(loose_modes.shape[1] - held, held)
