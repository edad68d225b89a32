r"""Derivatives of eigenvalues and mode shapes, with groups for repeated and close eigenvalues.

With :math:`Z = K - \lambda M` and :math:`z_i = (dK - \lambda_i dM) \phi_i`, a simple mode with
:math:`\phi^T M \phi = 1` has

.. math::
    d\lambda_i = \phi_i^T z_i, \qquad
    Z_i \, d\phi_i = d\lambda_i M \phi_i - z_i, \qquad
    \phi_i^T M \, d\phi_i = - \tfrac12 \phi_i^T dM \phi_i ,

which is one bordered linear system for each mode (Nelson, AIAA Journal 14(9), 1976).  No other modes are needed, so
coordinates without inertia cause no problem.  In a group of equal eigenvalues the individual shapes are arbitrary:
the eigenvalue derivatives are the eigenvalues of :math:`\Phi^T (dK - \lambda dM) \Phi` over the group, and only the
part of the shape derivatives outside the group is determined (Dailey, AIAA Journal 27(4), 1989).
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Rounding of the eigenvalues, as a fraction of their magnitude.
ROUNDING = 1e-13


def group_modes(eigenvalues: Array, close: float, magnitude: Array) -> Index:
    """Number the groups of modes whose eigenvalues differ by less than a fraction of their size.

    - eigenvalues: ascending, (..., m)
    - close: the fraction; gaps below rounding are also ignored
    - magnitude: magnitude to which the rounding of each eigenvalue is relative
      (`pkmodes.core.linalg.eigen.rounding_scale`), (..., m)

    Returns (..., m): the same number for the members of a group, ascending from 0.
    """
    is_separate = are_separate(eigenvalues, close, magnitude)
    first = np.zeros((*eigenvalues.shape[:-1], 1), dtype=np.intp)
    return np.concatenate([first, np.cumsum(is_separate, axis=-1)], axis=-1)


def are_separate(eigenvalues: Array, close: float, magnitude: Array) -> NDArray[np.bool_]:
    """Return which neighbouring modes do not belong to one group, (..., m - 1); see `group_modes`."""
    size = np.abs(eigenvalues)
    rounding = ROUNDING * magnitude[..., 1:]
    larger = np.maximum(size[..., 1:], size[..., :-1])
    return np.asarray(np.diff(eigenvalues, axis=-1) > np.maximum(close * larger, rounding))


def branch_rates(change: Array, shapes: Array, group: Index) -> Array:
    """Compute the eigenvalue derivatives of one system; in each group those of its branches, ascending.

    - change: (dK - lambda_i dM) phi_i for each parameter, (T, m, n)
    - shapes: (m, n)
    - group: from `group_modes`, (m,)

    Returns (T, m).
    """
    rates = np.empty(change.shape[:2])
    for number in np.unique(group):
        members = np.flatnonzero(group == number)
        rates[:, members] = np.linalg.eigvalsh(_symmetric(_projected_change(change, shapes, members)))
    return rates


def _projected_change(change: Array, shapes: Array, members: Index) -> Array:
    """Compute Phi^T (dK - lambda dM) Phi over a group of r modes, (T, r, r)."""
    return np.asarray(np.einsum("tin,jn->tij", change[:, members], shapes[members]))


def _symmetric(matrices: Array) -> Array:
    return 0.5 * (matrices + np.swapaxes(matrices, 1, 2))


def mode_derivatives(
    M: Array,
    K: Array,
    eigenvalues: Array,
    shapes: Array,
    change: Array,
    norm: Array,
    group: Index,
    magnitude: Array,
) -> tuple[Array, Array]:
    """Compute derivatives of the modes of one system with respect to several parameters.

    - M, K: (n, n)
    - eigenvalues: (m,)
    - shapes: mass-normalised, (m, n)
    - change: (dK - lambda_i dM) phi_i for each parameter, (T, m, n)
    - norm: phi_i^T dM phi_i, (T, m)
    - group: from `group_modes`, (m,)
    - magnitude: as for `group_modes`, (m,); each mode's equations are scaled with it

    Returns, in this order:
    - d_eigenvalues: in a group, those of the branches, ascending, (T, m)
    - d_shapes: in a group, the part that is M-orthogonal to the other members, (T, m, n)
    """
    sizes = np.bincount(group)
    if len(sizes) == len(group):
        return _simple_mode_derivatives(M, K, eigenvalues, shapes, change, norm, magnitude)
    d_eigenvalues, d_shapes = np.empty(change.shape[:2]), np.empty(change.shape)
    simple = np.flatnonzero(sizes[group] == 1)
    d_eigenvalues[:, simple], d_shapes[:, simple] = _simple_mode_derivatives(
        M, K, eigenvalues[simple], shapes[simple], change[:, simple], norm[:, simple], magnitude[simple]
    )
    for number in np.flatnonzero(sizes > 1):
        members = np.flatnonzero(group == number)
        projected = _projected_change(change, shapes, members)
        d_eigenvalues[:, members] = np.linalg.eigvalsh(_symmetric(projected))
        scale = 1.0 / np.sqrt(np.abs(np.diagonal(K)) + magnitude[members].max() * np.diagonal(M))
        momenta = shapes[members] @ M
        border = momenta * scale
        border /= np.linalg.norm(border, axis=1, keepdims=True)
        size = len(scale) + len(members)
        for k, i in enumerate(members):
            system = np.zeros((size, size))
            system[: len(scale), : len(scale)] = (K - eigenvalues[i] * M) * scale[:, None] * scale
            system[: len(scale), len(scale) :] = border.T
            system[len(scale) :, : len(scale)] = border
            right_sides = np.zeros((size, len(change)))
            right_sides[: len(scale)] = (projected[:, k] @ momenta - change[:, i]).T * scale[:, None]
            particular = np.linalg.solve(system, right_sides)[: len(scale)].T * scale
            d_shapes[:, i] = particular - 0.5 * norm[:, i, None] * shapes[i]
    return d_eigenvalues, d_shapes


def _simple_mode_derivatives(
    M: Array, K: Array, eigenvalues: Array, shapes: Array, change: Array, norm: Array, magnitude: Array
) -> tuple[Array, Array]:
    """Compute derivatives of k modes that form no group, from their bordered systems together."""
    rates = np.einsum("tin,in->ti", change, shapes)
    scale = 1.0 / np.sqrt(np.abs(np.diagonal(K)) + magnitude[:, None] * np.diagonal(M))
    momenta = shapes @ M
    border = momenta * scale
    border /= np.linalg.norm(border, axis=1, keepdims=True)
    k, n = shapes.shape
    system, right_sides = np.zeros((k, n + 1, n + 1)), np.zeros((k, n + 1, len(change)))
    system[:, :n, :n] = (K - eigenvalues[:, None, None] * M) * scale[:, :, None] * scale[:, None]
    system[:, :n, n] = system[:, n, :n] = border
    right_sides[:, :n] = np.moveaxis((rates[..., None] * momenta - change) * scale, 0, -1)
    particular = np.moveaxis(np.linalg.solve(system, right_sides)[:, :n], -1, 0) * scale
    return rates, particular - 0.5 * norm[..., None] * shapes
