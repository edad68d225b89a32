"""A robot of one load case at its poses with one term: matrices and modes.

M and K are those of the robot in all coordinates with what the term changes (`term_changes`); a mount and a resonator
add a coordinate, the last one.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.linalg.eigen import condensed_eigh
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.updating.term_changes import FORMS_WITH_COORDINATE, Surroundings, change_of, strains
from pkmodes_description import Term

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: A spring strains a rigid motion if by more than this fraction of its strain in other motions.
MIN_STRAIN = 1e-7
#: Ratio of the largest to the lowest eigenvalue up to which the lowest has the accuracy that a fit needs.
MAX_EIGENVALUE_RATIO = 1e9


@dataclass(frozen=True)
class PlacedTerm:
    """A term with the indices of its parameters among those of the structure; the first determines its size."""

    term: Term
    index: tuple[int, ...]


class PresentTerm(NamedTuple):
    """A term that is present, and the values of its parameters."""

    placed_term: PlacedTerm
    values: Array


class Site(NamedTuple):
    """The robot of one load case at its setups: matrices in all coordinates, (N, e, e), and what terms need."""

    setups: Index
    system: ExtendedSystem
    points: Array
    matrices: tuple[Array, Array]
    surroundings: Surroundings


class TermMatrices(NamedTuple):
    """M and K of a site with a term.

    - M, K: in all coordinates and a = 0 or 1 of the term, (N, e + a, e + a)
    - free: coordinates that are not locked, (n,)
    - massless: (n,)
    - rigid: number of rigid modes
    """

    M: Array
    K: Array
    free: Index
    massless: NDArray[np.bool_]
    rigid: int

    def in_free(self) -> tuple[Array, Array]:
        """Return M and K in the free coordinates, (N, n, n)."""
        M, K = (matrix[:, self.free[:, None], self.free] for matrix in (self.M, self.K))
        return M, K


class TermModes(NamedTuple):
    """Modes of a site: eigenvalues (N, m), and mass-normalised shapes in the free coordinates, (N, m, n)."""

    matrices: TermMatrices
    eigenvalues: Array
    shapes: Array


def without_term(site: Site) -> TermModes | None:
    """Return the modes of the robot itself; None where its M and K are not those of a machine."""
    system = site.system
    matrices = TermMatrices(*site.matrices, system.free.astype(np.intp), system.massless, system.rigid_modes)
    try:
        solution = condensed_eigh(*matrices.in_free(), system.base_count, system.rigid_modes, system.massless)
    except np.linalg.LinAlgError:  # a fit tried a mass of zero
        return None
    return TermModes(matrices, *solution)


def matrices_with(site: Site, present: PresentTerm, held_count: int) -> TermMatrices:
    """Return M and K of a site with a term, which holds some of the rigid motions (`held_motions`)."""
    system = site.system
    change = change_of(present.placed_term.term, present.values, site.surroundings)
    e = site.matrices[0].shape[-1]  # coordinates of the robot; the term may add further ones
    M, K = (
        np.array(np.broadcast_to(contribution, (len(matrix), *contribution.shape[1:])), dtype=float)
        for matrix, contribution in zip(site.matrices, change, strict=True)
    )
    M[:, :e, :e] += site.matrices[0]
    K[:, :e, :e] += site.matrices[1]
    term_coordinates = np.arange(e, M.shape[-1])
    free = np.concatenate([system.free, term_coordinates]).astype(np.intp)
    massless = np.concatenate([system.massless, ~change.M[:, term_coordinates].any(axis=(0, 2))])
    return TermMatrices(M, K, free, massless, system.rigid_modes - held_count)


def held_motions(site: Site, term: Term) -> int | None:
    """Return the number of rigid motions of a site that a spring holds; None if the robot itself is not a machine."""
    system = site.system
    if term.form != "spring" or not system.rigid_modes:
        return 0
    modes = without_term(site)
    if modes is None:
        return None
    strain = strains(term, site.surroundings)[0][:, system.free] @ modes.shapes[0].T
    size = np.abs(strain).max(initial=0.0)
    singular_values = np.linalg.svd(strain[:, : system.rigid_modes], compute_uv=False)
    return int((singular_values > MIN_STRAIN * size).sum()) if size > 0.0 else 0


def eigenmodes(first: int, matrices: TermMatrices, M: Array, K: Array) -> tuple[Array, Array] | None:
    """Solve the eigenproblem with the digits that a fit needs: a stiff joint only where it costs those.

    - first: number of coordinates without joints
    - matrices: whose free coordinates M and K have
    - M, K: (N, n, n)

    Returns eigenvalues (N, m) and shapes (N, m, n); None where M and K are not those of a machine.
    """
    rigid, massless = matrices.rigid, matrices.massless
    try:
        eigenvalues, shapes = condensed_eigh(M, K, M.shape[-1], rigid, massless)
        if rigid < eigenvalues.shape[1]:
            is_inaccurate = eigenvalues[:, -1] > MAX_EIGENVALUE_RATIO * np.abs(eigenvalues[:, rigid])
            if is_inaccurate.any():
                eigenvalues[is_inaccurate], shapes[is_inaccurate] = condensed_eigh(
                    M[is_inaccurate], K[is_inaccurate], first, rigid, massless
                )
    except np.linalg.LinAlgError:
        return None
    return (eigenvalues, shapes) if np.isfinite(eigenvalues).all() else None


def term_modes(site: Site, matrices: TermMatrices) -> TermModes | None:
    """Return the modes of a site with a term; None where M and K are not those of a machine."""
    solution = eigenmodes(site.system.base_count, matrices, *matrices.in_free())
    return None if solution is None else TermModes(matrices, *solution)


def platform_with(term: Term | None, surroundings: Surroundings) -> NDArray[Any]:
    """Return the motion of the platform per unit of all coordinates and that of a term, (N, components, e + a)."""
    if term is None or term.form not in FORMS_WITH_COORDINATE:
        return surroundings.platform
    term_motion = np.zeros((*surroundings.platform.shape[:-1], 1))
    if term.form == "mount":
        term_motion = surroundings.mounts.platform[:, term.mount][..., None]
    return np.concatenate([surroundings.platform, term_motion], axis=-1)


def in_all_coordinates(matrices: TermMatrices, shapes: Array) -> Array:
    """Return shapes in the free coordinates, (..., n), in all of them, (..., e + a)."""
    in_all = np.zeros((*shapes.shape[:-1], matrices.M.shape[-1]))
    in_all[..., matrices.free] = shapes
    return in_all


def channels_of(system: ExtendedSystem, platform: Array, motions: Array) -> Array:
    """Return the channels of motions in all coordinates, (N, ..., C).

    - platform: as returned by `platform_with`, (N, components, e + a)
    - motions: (N, ..., e + a)
    """
    transposed_platform = np.swapaxes(platform, -1, -2)
    transposed_platform = transposed_platform.reshape(
        len(transposed_platform), *(1,) * (motions.ndim - 3), *transposed_platform.shape[1:]
    )
    coordinates = system.to_model_coordinates(motions[..., : len(system.mechanism.extended.COORDINATES)])
    return np.concatenate([coordinates, motions @ transposed_platform], axis=-1)
