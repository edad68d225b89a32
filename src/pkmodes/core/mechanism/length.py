"""The characteristic length of a platform that turns: it makes rotations comparable with displacements.

It is the root mean square distance of the platform's joints from its origin: a rotation times this length is about
how far they move.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated

Array = NDArray[np.float64]


def characteristic_length(mechanism: Mechanism, parameters: Any) -> float:
    """Return the characteristic length of a robot [m]; 1 for a platform that does not turn."""
    if not mechanism.rotations:
        return 1.0
    return float(Generated(mechanism.model, parameters).platform_joints()[0])


def middle_of_joints(mechanism: Mechanism, parameters: Any) -> Array:
    """Return the centre of the joints of a platform that turns, from its origin in platform axes, (3,) [m]."""
    return np.asarray(Generated(mechanism.model, parameters).platform_joints()[1])


def lengths_of(mechanism: Mechanism, parameters: Any) -> Array:
    """Return a factor for each component of the platform's motion: 1, or the characteristic length of a rotation."""
    length = characteristic_length(mechanism, parameters)
    return np.array([1.0] * len(mechanism.directions) + [length] * len(mechanism.rotations))


def unit_vector_headings(mechanism: Mechanism) -> list[str]:
    """Return the headings of `unit_vectors` in tables: L is the characteristic length."""
    return [
        f"{component.name}*L" if component.unit == "rad" else component.name
        for component in mechanism.platform
    ]


def unit_vectors(motions: Array, lengths: Array) -> Array:
    """Return motions of the platform, (..., components), as unit vectors, rotations times the characteristic length.

    - lengths: from `lengths_of`, (components,)

    A vector is 0 where the platform does not move.
    """
    scaled = motions * lengths
    norms = np.linalg.norm(scaled, axis=-1, keepdims=True)
    return np.asarray(scaled / np.where(norms > 0.0, norms, 1.0))
