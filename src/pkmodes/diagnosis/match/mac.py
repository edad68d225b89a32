"""The modal assurance criterion of measured shapes with modes of a model, of one mode or of several together.

Measured shapes may be at any of the model's channels, blank where they were not measured, and of any scale and sign
(MAC; Allemang, Sound and Vibration 37(8), 2003).  Modes whose frequencies nearly agree may be any combination of
each other: a measured shape is then compared with the space that they span.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

#: Modes whose measured components differ by less than this fraction are seen alike.
ALIKE = 1e-6


def weighted(shapes: Array, model: Array, moves: Array) -> tuple[Array, Array]:
    """Measured shapes, zero where not measured, and the model's, in units of what each channel moves.

    Parameters
    ----------
    shapes : ndarray, shape (..., r, C)
        NaN where not measured.
    model : ndarray, shape (..., m, C)
    moves : ndarray, shape (..., C)
        See `channel_motion`; what moves in none of the modes that all models are measured by counts by this model.
    """
    moves = np.where(moves > 0.0, moves, channel_motion(model))
    weights = np.where(moves > 0.0, 1.0 / np.where(moves > 0.0, moves, 1.0), 0.0)[..., None, :]
    values = np.where(np.isfinite(shapes), shapes, 0.0)
    largest = np.abs(values).max(axis=-1, initial=0.0, keepdims=True)
    return values / np.where(largest > 0.0, largest, 1.0) * weights, model * weights


def mac(shapes: Array, model: Array, measured: NDArray[np.bool_]) -> Array:
    """MAC of each measured shape with each mode, at the components that were measured; NaN without two of them.

    Parameters
    ----------
    shapes, model : ndarray, shape (..., r, C) and (..., m, C)
        From `weighted`.
    measured : ndarray of bool, shape (..., r, C)

    Returns
    -------
    ndarray, shape (..., r, m)
    """
    lengths = (shapes**2).sum(axis=-1)
    sizes = measured.astype(float) @ np.swapaxes(model**2, -1, -2)
    along = (shapes @ np.swapaxes(model, -1, -2)) ** 2
    known = (measured.sum(axis=-1) >= 2) & (lengths > 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        found = along / (np.where(sizes > 0.0, sizes, 1.0) * lengths[..., None])
    return np.where(known[..., None], found, np.nan)


def space(shapes: Array) -> tuple[Array, Array]:
    """Orthonormal bases of the spaces of several modes at their sensors, for a batch.

    Parameters
    ----------
    shapes : ndarray, shape (B, g, C)
        From `weighted`, zero at components that were not measured; rows of zeros count for nothing.

    Returns
    -------
    basis : ndarray, shape (B, g, C)
        Orthonormal rows, and rows of zeros where the modes span less: sensors may see two modes alike.
    back : ndarray, shape (B, g, g)
        With basis = back @ shapes.
    """
    shapes = np.where(np.isfinite(shapes), shapes, 0.0)  # of a setup that cannot be evaluated
    values, vectors = np.linalg.eigh(shapes @ np.swapaxes(shapes, -1, -2))
    kept = values > ALIKE**2 * np.maximum(values[:, -1:], 1e-300)
    scale = np.where(kept, 1.0 / np.sqrt(np.where(kept, values, 1.0)), 0.0)
    back = np.swapaxes(vectors, -1, -2) * scale[..., None]
    return back @ shapes, back


def channel_motion(shapes: Array) -> Array:
    """How much each channel moves in all modes together, (..., C): metres beside radians count by that.

    For mass-normalised shapes it is the root of the inverse of the channel's effective mass.  Hypotheses that are to
    be compared must be measured by the same model's, or one that adds modes would seem to fit better.

    Parameters
    ----------
    shapes : ndarray, shape (..., m, C)
    """
    moves: Array = np.sqrt(np.nansum(shapes**2, axis=-2))
    return moves
