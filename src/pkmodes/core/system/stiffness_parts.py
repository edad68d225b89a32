"""K of a robot in parts that may be of very different size: in their sum, the digits of the small ones are lost."""

from __future__ import annotations

from functools import cache
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.system.entry_rates import spring_rates
from pkmodes.core.system.evaluation import Evaluation, ExtendedSystem

Array = NDArray[np.float64]


class StiffnessParts(NamedTuple):
    """Parts of K in the free coordinates, each (N, n, n).

    - machine: belts, reducers and released joints
    - ground: springs to ground
    """

    machine: Array
    ground: Array
    gravity: Array


def stiffness_parts(system: Evaluation, p: Array) -> StiffnessParts:
    """Evaluate the parts of K of an extended system at N poses, (N, d)."""
    assert isinstance(system, ExtendedSystem)
    springs, extended = _springs_to_ground(system.mechanism), system.mechanism.extended
    effects = system.effects._replace(**dict.fromkeys(springs, 0.0))
    _, machine, gravity = Generated(extended, system.parameters, effects).extended_matrices(p)
    diagonal = np.arange(machine.shape[-1])
    machine[..., diagonal, diagonal] += system.joints
    ground = np.zeros_like(machine)
    for field, part in spring_rates(system.mechanism, system.parameters, system.effects, p, springs).items():
        ground += np.asarray(getattr(system.effects, field))[..., None, None] * part
    parts = (machine, ground, gravity)
    return StiffnessParts(*(system.free_part(system.in_basis(part)) for part in parts))


@cache
def _springs_to_ground(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the effect parameters, by generated field, that hold a robot to ground."""
    grounding = [effect for effect in mechanism.effects.values() if effect.grounds]
    return tuple(f"{effect.name}_{parameter.name}" for effect in grounding for parameter in effect.parameters)
