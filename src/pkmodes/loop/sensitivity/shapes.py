"""Derivatives of mode shapes by modal expansion (`support.expansion`), for fits that need them many times.

Coordinates without inertia follow the others statically, and a locked joint with a compliance deflects under its
force.  `sensitivity.modes` computes the same from one linear system for each mode: slower, but accurate to the last
digit even for nearly coincident modes.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.expansion import modal_expansion
from pkmodes.loop.sensitivity.matrices import MatrixDerivatives

Array = NDArray[np.float64]


def shape_derivatives(
    derivatives: MatrixDerivatives,
    eigenvalues: Array,
    shapes: Array,
    motions: Array | None = None,
    motion: Callable[[], Array] | None = None,
) -> Array:
    """Compute derivatives of all mode shapes along parameter paths.

    - derivatives: for N poses and T paths
    - eigenvalues: (N, m)
    - shapes: in the free coordinates, mass-normalised, (N, m, n)
    - motions: motions in each mode that are linear in the coordinates, such as those of the platform, (N, m, d)
    - motion: returns these motions per unit of all coordinates, (N, d, e); called only if there are coordinates
      without inertia, or locked joints

    Returns (N, T, m, e + d): in all coordinates of the generated model, including those of locked joints, which
    deflect; then the motions, per unit of the coordinates as they are.
    """
    change, norm = derivatives.changes(eigenvalues, shapes)
    expansion = modal_expansion(change, norm, eigenvalues, shapes)
    free, size = derivatives.free, derivatives.size
    channels = np.zeros((*shapes.shape[:2], size + (0 if motions is None else motions.shape[-1])))
    channels[..., free] = shapes
    if motions is not None:
        channels[..., size:] = motions
    rates: Array = expansion @ channels[:, None]
    massless = np.flatnonzero(derivatives.system.massless)
    if not (len(massless) or derivatives.locked_paths):
        rates[..., :size] = derivatives.system.to_model_coordinates(rates[..., :size])
        return rates
    static_motion = np.zeros((*expansion.shape[:3], size))
    if len(massless):
        K = derivatives.stiffness[:, free[massless][:, None], free[massless]]
        static_motion[..., free[massless]] -= np.swapaxes(
            np.linalg.solve(K[:, None], np.swapaxes(change[..., massless], -1, -2)), -1, -2
        )
    if derivatives.locked_paths:
        static_motion[:, list(derivatives.locked_paths)] += derivatives.locked_motions(eigenvalues, shapes)
    rates[..., :size] = derivatives.system.to_model_coordinates(rates[..., :size] + static_motion)
    if motion is not None:
        rates[..., size:] += static_motion @ np.swapaxes(motion(), -1, -2)[:, None]
    return rates
