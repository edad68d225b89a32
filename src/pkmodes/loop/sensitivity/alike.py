"""Parameters that act as one: their relative changes change all frequencies alike, at every pose.

Where only the product of two parameters enters the equations, such as the stiffness of a belt per width and its
width, one per cent of either has the same effect.  No measurement of frequencies separates
them, and which of them "has the larger influence" is rounding.  So they are one in tables and figures.

Parameters whose relative influences differ by another constant factor, such as the inertia of a motor and its gear
ratio, which enters squared, stay apart: a per cent of the one is worth two of the other, and the tables show this.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
#: Difference of two relative influences that is rounding, as a fraction of the larger one of all modes at the pose.
#: Both are phi^T A phi with the same phi, and the same A up to the last digits of its entries: over the workspaces of
#: the robots here they agree to 1e-14, also where modes nearly coincide.  All other pairs differ by more than 1e-2.
ROUNDING_FRACTION = 1e-9
#: Relative influences below this are rounding of zero: such a parameter acts on nothing, and is like no other.
MIN_INFLUENCE = 1e-9
#: Influences of different parameters on a frequency that differ by less, as a fraction of the largest, are told as
#: alike: pages show them with two digits.
TIE_FRACTION = 0.01


@dataclass(frozen=True)
class EquivalentParameters:
    """Parameters that act as one.

    - members: their indices, ascending
    - signs: 1 where a rise acts like a rise of the first member, -1 where it acts like a fall
    """

    members: tuple[int, ...]
    signs: tuple[int, ...]

    def names(self, paths: Sequence[str]) -> list[str]:
        """Return the names of the members: the reciprocal of one whose fall acts like a rise of the first."""
        return [
            paths[i] if sign > 0 else f"1/{paths[i]}"
            for i, sign in zip(self.members, self.signs, strict=True)
        ]

    def name(self, paths: Sequence[str]) -> str:
        """Return the name of all, such as ``belt.specific_stiffness, belt.width``."""
        return ", ".join(self.names(paths))


def equivalent_parameters(relative: Array) -> list[EquivalentParameters]:
    """Group the parameters that act as one.

    - relative: d ln f / d ln p at some poses, (..., T, m); poses with NaN are left out.  A single pose may have a
      symmetry that makes different parameters equal there: give several.

    Each of the T parameters is in one group, which may have a single member; in the order of the first members.
    """
    poses = relative.reshape(-1, *relative.shape[-2:])
    poses = poses[np.isfinite(poses).all(axis=(1, 2))]
    size = np.abs(poses).max(axis=2, initial=0.0)  # (N, T), over the modes
    has_influence = size.max(axis=0, initial=0.0) > MIN_INFLUENCE
    groups: list[tuple[list[int], list[int]]] = []
    for i in range(relative.shape[-2]):
        for members, signs in groups:
            first = members[0]
            sign = (
                _sign(poses[:, first], poses[:, i], size[:, [first, i]])
                if has_influence[i] and has_influence[first]
                else 0
            )
            if sign:
                members.append(i)
                signs.append(sign)
                break
        else:
            groups.append(([i], [1]))
    return [EquivalentParameters(tuple(members), tuple(signs)) for members, signs in groups]


def _sign(first: Array, second: Array, size: Array) -> int:
    """Return 1 if two influences, (N, m), are equal, -1 if they are opposite, 0 if they are neither."""
    rounding = ROUNDING_FRACTION * size.max(axis=1)[:, None]
    for sign in (1, -1):
        if (np.abs(second - sign * first) <= rounding).all():
            return sign
    return 0
