"""Modes of several robots from the compiled evaluator, for a diagnosis: each robot at the same number of poses."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from pkmodes.mechanism.poses import MAX_CONDITION
from pkmodes.solve.backends import AUTO, NUMPY, chosen, compiled
from pkmodes.solve.compiled_modes import EIGENVALUES, left_to_numpy
from pkmodes.solve.solving import solve
from pkmodes.system.evaluation import SystemOfEffects

Array = NDArray[np.float64]
SHAPES, MOTIONS = "shapes", "platform_shapes"


def modes_of_systems(systems: Sequence[SystemOfEffects], points: Array) -> tuple[Array, Array, Array] | None:
    """Evaluate the modes of robots with the same free coordinates.

    Parameters
    ----------
    systems : sequence of SystemOfEffects, length B
    points : ndarray, shape (B n, d)
        n poses of each robot, robot by robot.

    Returns
    -------
    eigenvalues : ndarray, shape (B n, m)
    shapes : ndarray, shape (B n, m, n)
    motions : ndarray, shape (B n, m, directions)
        Of the platform.

    None instead of the three if there is no compiled library, or if a pose cannot be evaluated.
    """
    if chosen(AUTO) == NUMPY:
        return None
    first, each = systems[0], len(points) // len(systems)
    points = np.ascontiguousarray(points)
    arrays: dict[str, Array] = {}
    codes = np.empty(len(points), dtype=np.int8)
    for b, system in enumerate(systems):
        evaluator = compiled(system.mechanism, system, MAX_CONDITION, AUTO)
        if evaluator is None:
            return None
        if not arrays:
            n, m = evaluator.coordinates, evaluator.modes
            tails = {EIGENVALUES: (m,), SHAPES: (m, n), MOTIONS: (m, len(first.mechanism.directions))}
            arrays = {name: np.empty((len(points), *tail)) for name, tail in tails.items()}
        if evaluator.modes != arrays[EIGENVALUES].shape[1]:
            return None
        part = slice(b * each, (b + 1) * each)
        codes[part] = evaluator.run(points[part], {name: array[part] for name, array in arrays.items()})
    if (codes > 0).any():
        return None
    left = np.unique(left_to_numpy(first, codes, arrays[EIGENVALUES]) // each)
    if len(left):  # all poses of these robots
        rows = (left[:, None] * each + np.arange(each)).ravel()
        some = SystemOfEffects.stacked([systems[b] for b in left], each)
        try:
            at = solve(some, points[rows])
        except np.linalg.LinAlgError:
            return None
        motion = np.swapaxes(some.platform_motion(points[rows]), -1, -2)
        arrays[EIGENVALUES][rows], arrays[SHAPES][rows] = at.eigenvalues, at.shapes
        arrays[MOTIONS][rows] = at.shapes @ motion
    return arrays[EIGENVALUES], arrays[SHAPES], arrays[MOTIONS]
