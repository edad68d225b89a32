"""The modal assurance criterion (MAC) of two shapes, or of a shape with several modes together.

Measured shapes may be at any of the model's channels, blank where not measured, with any scale and sign (Allemang,
Sound and Vibration 37(8), 2003).  Modes whose frequencies nearly agree may mix: a measured shape is then compared
with the subspace that they span.  Two shapes of a model are compared with its mass matrix.  Shapes with components in
metres and in radians are compared in one unit: times `channel_weights`, or with rotations times a length.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Modes whose measured components differ by less than this fraction are indistinguishable.
INDEPENDENCE_TOLERANCE = 1e-6
#: Shapes with a smaller MAC are not of one mode: no pair, in any comparison.  A shape can have a larger one with only
#: one of several orthogonal modes.
MIN_MAC_OF_PAIR = 0.5


def normalised(shapes: Array) -> Array:
    """Return measured shapes (..., C), NaN where not measured, relative to the largest component and without NaN."""
    values = np.where(np.isfinite(shapes), shapes, 0.0)
    largest = np.abs(values).max(axis=-1, initial=0.0, keepdims=True)
    return np.asarray(values / np.where(largest > 0.0, largest, 1.0))


def rotation_weights(channels: Sequence[str], shapes: Array) -> Array:
    """Return the factors by which measured shapes are in one unit where no length of the machine is known, (C,).

    The rotations of a platform are made as large as its displacements, in the median over all shapes, so that their
    unit does not matter.  All factors are 1 where the shapes do not have both.

    - channels: names, ``p_x`` for a displacement of a platform and ``r_x`` for a rotation
    - shapes: (R, C), NaN where not measured
    """
    moves, turns = (
        np.array([name.startswith(kind) for name in channels], dtype=bool) for kind in ("p_", "r_")
    )
    weights = np.ones(len(channels))
    moved, turned = (np.sqrt(np.nansum(shapes[:, kind] ** 2, axis=1)) for kind in (moves, turns))
    both = (moved > 0.0) & (turned > 0.0)
    if both.any():
        weights[turns] = np.median(moved[both] / turned[both])
    return weights


def channel_weights(model: Array, motion: Array) -> Array:
    """Return the factors by which shapes are in units of each channel's motion, (..., 1, C).

    - model: (..., m, C)
    - motion: see `channel_motion`, (..., C); for channels that do not move in the reference, this model's motion is
      used
    """
    if not (motion > 0.0).all():
        motion = np.where(motion > 0.0, motion, channel_motion(model))
    return motion_weights(motion)[..., None, :]


def motion_weights(motion: Array) -> Array:
    """Return the factors that make channels comparable: 1 / motion, 0 for a channel that does not move."""
    return np.asarray(np.where(motion > 0.0, 1.0 / np.where(motion > 0.0, motion, 1.0), 0.0))


def mac(shapes: Array | Complex, model: Array | Complex, measured: NDArray[np.bool_]) -> Array:
    """Return the MAC of each shape with each mode, at the measured components; NaN if there are fewer than two.

    - shapes, model: in one unit, such as times `channel_weights`, (..., r, C) and (..., m, C)
    - measured: (..., r, C)

    Returns (..., r, m).
    """
    norms = (np.abs(shapes) ** 2).sum(axis=-1)
    mode_norms = measured.astype(float) @ np.swapaxes(np.abs(model) ** 2, -1, -2)
    projections = np.abs(shapes @ np.swapaxes(model, -1, -2).conj()) ** 2
    comparable = (measured.sum(axis=-1) >= 2) & (norms > 0.0)
    with np.errstate(invalid="ignore", divide="ignore"):
        values = projections / (np.where(mode_norms > 0.0, mode_norms, 1.0) * norms[..., None])
    return np.where(comparable[..., None], values, np.nan)


def mac_of_each(first: Array, second: Array) -> Array:
    """Return the MAC of measured shapes with others, (m, r); NaN where they share fewer than two components.

    - first, second: in one unit, NaN where not measured, (m, C) and (r, C)
    """
    macs = np.full((len(first), len(second)), np.nan)
    for k, shape in enumerate(second):
        shared = np.isfinite(first) & np.isfinite(shape)
        shapes = normalised(np.where(shared, first, np.nan))
        macs[:, k] = mac(shapes, normalised(shape)[None, :], shared)[:, 0]
    return macs


def explained_difference(shapes: Array, errors: Array, sigmas: float) -> Array:
    """Return what the errors of measured shapes explain of one minus their MAC with their own modes, (...).

    To second order this is the square of the errors perpendicular to the shape, a quadratic form with known mean and
    standard deviation; errors along the shape change its scale only.

    - shapes, errors: times `channel_weights`, (..., C); independent standard deviations, zero where not measured
    - sigmas: the result is the mean plus this many standard deviations
    """
    squares = shapes**2
    norms = squares.sum(axis=-1)
    norms = np.where(norms > 0.0, norms, 1.0)
    shares, variances = squares / norms[..., None], errors**2
    along_shape = (variances * shares).sum(axis=-1)
    mean = variances.sum(axis=-1) - along_shape
    spread = (variances**2 * (1.0 - 2.0 * shares)).sum(axis=-1) + along_shape**2
    return np.asarray((mean + sigmas * np.sqrt(2.0 * np.maximum(spread, 0.0))) / norms)


def subspace_mac(
    shapes: Array, model: Array, members: NDArray[np.bool_], measured: NDArray[np.bool_]
) -> Array:
    """Return the MAC of each shape with a subspace of modes, (B,); NaN if these would span any shape.

    - shapes, model: times `channel_weights`, (B, C) and (B, m, C)
    - members: modes that span the subspace, (B, m)
    - measured: (B, C)
    """
    largest_group = int(members.sum(axis=1).max(initial=1))
    order = np.argsort(~members, axis=1, kind="stable")[:, :largest_group]
    batch = np.arange(len(shapes))[:, None]
    selected = model[batch, order] * measured[:, None] * members[batch, order][..., None]
    basis, _ = subspace_basis(selected)
    norms = (shapes**2).sum(axis=-1)
    comparable = (measured.sum(axis=-1) > members.sum(axis=-1)) & (measured.sum(axis=-1) >= 2) & (norms > 0.0)
    projections = ((basis @ shapes[..., None]) ** 2).sum(axis=(-1, -2))
    return np.where(comparable, projections / np.where(norms > 0.0, norms, 1.0), np.nan)


def mass_weighted_mac(products: Array, shapes: Array, masses: Array) -> Array:
    """Return the MAC of mass-normalised shapes phi with other shapes psi, by the mass matrix M of phi.

    - products: phi^T M psi, (..., r, m)
    - shapes: the shapes psi, (..., m, n)
    - masses: (..., n, n)
    """
    norms = ((shapes @ masses) * shapes).sum(axis=-1)
    values: Array = products**2 / norms[..., None, :]
    return values


def subspace_basis(shapes: Array) -> tuple[Array, Array]:
    """Return orthonormal bases of the subspaces of several modes at their sensors, for a batch.

    - shapes: times `channel_weights`, zero at components that were not measured, (B, g, C); rows of zeros are ignored

    Returns, in this order:
    - basis: orthonormal rows, and rows of zeros if the modes are not independent at the sensors, (B, g, C)
    - transformation: T such that basis = T @ shapes, (B, g, g)
    """
    shapes = np.where(np.isfinite(shapes), shapes, 0.0)  # of a setup that cannot be evaluated
    values, vectors = np.linalg.eigh(shapes @ np.swapaxes(shapes, -1, -2))
    independent = values > INDEPENDENCE_TOLERANCE**2 * np.maximum(values[:, -1:], 1e-300)
    scale = np.where(independent, 1.0 / np.sqrt(np.where(independent, values, 1.0)), 0.0)
    transformation = np.swapaxes(vectors, -1, -2) * scale[..., None]
    return transformation @ shapes, transformation


def channel_motion(shapes: Array) -> Array:
    """Return the root sum of squares of each channel's motion over all modes, (..., C), to scale metres and radians.

    For mass-normalised shapes it is the inverse square root of the channel's effective mass.  Hypotheses must be
    compared with the motion of the same model, otherwise one that adds modes would seem to fit better.

    - shapes: (..., m, C)
    """
    motion: Array = np.sqrt(np.nansum(shapes**2, axis=-2))
    return motion
