r"""Changes of M and K of a robot at poses by a term: one form at one place, beyond the effects of the catalogue.

With the displacements J of the place (generated as ``place_motion``), a mass adds :math:`m \sum J^T J` and the
Hessian of its weight, a spring :math:`k\,J^T J`.  A mount and a resonator add a coordinate of their own: the rows of
a mount are generated (``mount_matrices``), and a resonator is a mass that follows its place but for a displacement on
its spring.  All of it is evaluated with numbers that may be complex, so that complex steps differentiate it exactly.

These few products are here and not in the generated code because hundreds of terms share the displacements of some
tens of places: emitted one by one, their matrices would be several times as long as the mechanism itself.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.stepped import COMPLEX_STEP
from pkmodes.core.system.evaluation import ExtendedSystem
from pkmodes.loop.sensitivity.matrices import POSE, geometry_of
from pkmodes.loop.sensitivity.paths import ParameterPath
from pkmodes.loop.updating.predictions import stepped_along
from pkmodes_description import Term

Array = NDArray[Any]
#: Values of the parameters of a term, which may be complex.
Values = Sequence[Any] | Array
#: Forms that add a coordinate.
FORMS_WITH_COORDINATE = ("mount", "resonator")
#: The generated parameter on which weights depend.
GRAVITY = "gravity"
#: A resonance closer to a mode than this fraction of its eigenvalue is treated as being this far away.
NEAREST_RESONANCE = 1e-3


class TermContribution(NamedTuple):
    """What a term adds to M and K, (N, e + a, e + a): in all coordinates and a = 0 or 1 of its own, the last."""

    M: Array
    K: Array

    def rates(self) -> TermContribution:
        """Return the derivatives, after a complex step."""
        return TermContribution(np.imag(self.M) / COMPLEX_STEP, np.imag(self.K) / COMPLEX_STEP)


class Mounts(NamedTuple):
    """Rows of M and K of W mounts, and the motion of the platform with them.

    - M, K: beside all coordinates, (N, W, e)
    - M_own, K_own: of the mounts themselves, without their springs, (N, W)
    - platform: (N, W, components)
    """

    M: Array
    M_own: Array
    K: Array
    K_own: Array
    platform: Array


class Surroundings:
    """Quantities of a robot at N poses on which terms depend, each evaluated when it is first needed.

    - system: the robot, with free or held motors
    - points: (N, d)
    - path: a path along which the robot and the poses take a complex step
    """

    def __init__(self, system: ExtendedSystem, points: Array, path: ParameterPath | None = None) -> None:
        self.system, self.points = system, points
        self._parameters, self._effects = system.parameters, system.effects
        if path is not None:
            numbers = stepped_along(system.mechanism, self._parameters, self._effects, path)
            self._parameters, self._effects, shift = numbers
            self.points = points + COMPLEX_STEP * 1j * shift
        self._count = len(points)
        self._inertias: dict[tuple[str, int], tuple[Array, Array]] = {}

    @property
    def _generated(self) -> Generated:
        return Generated(self.system.mechanism.placed, self._parameters, self._effects)

    def _at_poses(self, values: Any, tail: tuple[int, ...]) -> Array:
        return np.broadcast_to(values, (self._count, *tail))

    @cached_property
    def motion(self) -> Array:
        """Displacements of the places per unit of every coordinate, (N, rows, e)."""
        J = np.asarray(self._generated.place_motion(self.points))
        return self._rows(self._at_poses(J, J.shape[-2:]))

    def _rows(self, rows: Array) -> Array:
        return rows if self.system.basis is None else rows @ self.system.basis

    @cached_property
    def mounts(self) -> Mounts:
        """The rows of all mounts."""
        rows, diagonal, stiff_rows, stiff_own, platform = map(
            np.asarray, self._generated.mount_matrices(self.points)
        )
        return Mounts(
            self._rows(self._at_poses(rows, rows.shape[-2:])),
            self._at_poses(diagonal, diagonal.shape[-1:]),
            self._rows(self._at_poses(stiff_rows, stiff_rows.shape[-2:])),
            self._at_poses(stiff_own, stiff_own.shape[-1:]),
            self._at_poses(platform, platform.shape[-2:]),
        )

    @cached_property
    def of_masses(self) -> tuple[Array, Array]:
        """Derivatives of M_wq (W, e) and M_ww (W,) with respect to the mass that moves with each mount."""
        rows, diagonal = map(np.asarray, self._generated.mount_inertia())
        return self._rows(rows), diagonal

    @cached_property
    def platform(self) -> Array:
        """Motion of the platform per unit of every coordinate, (N, components, e)."""
        motion = self.system.full_platform_motion(self.points, self._parameters, self._effects)
        return self._at_poses(motion, motion.shape[-2:])

    def of_inertia(self, declared: tuple[str, int]) -> tuple[Array, Array]:
        """Return M and the Hessian of gravity per unit of a declared inertia, (N, e, e), in which both are linear."""
        if declared not in self._inertias:
            M, G = self._mass_and_weight(self._parameters, self._effects)
            raised_numbers = (
                _with_unit_more(numbers, *declared) for numbers in (self._parameters, self._effects)
            )
            more_M, more_G = self._mass_and_weight(*raised_numbers)
            self._inertias[declared] = more_M - M, more_G - G
        return self._inertias[declared]

    def _mass_and_weight(self, parameters: Any, effects: Any) -> tuple[Array, Array]:
        generated = Generated(self.system.mechanism.extended, parameters, effects)
        M, _, G = generated.extended_matrices(self.points)
        shape = M.shape[-2:]
        return self.system.in_basis(self._at_poses(M, shape)), self.system.in_basis(self._at_poses(G, shape))


def _with_unit_more(numbers: Any, field: str, index: int) -> Any:
    if field not in numbers._fields:
        return numbers
    value = np.array(getattr(numbers, field))
    value.reshape(-1)[index] += 1.0
    return numbers._replace(**{field: value if value.ndim else value[()]})


def changes_along(term: Term, system: ExtendedSystem, path: ParameterPath) -> bool:
    """Return whether the change by a term, or the motion of the platform, varies along a path."""
    moving = {*geometry_of(system.mechanism), POSE, GRAVITY}
    return term.form == "mount" or any(field in moving for field, _ in path.weights)


def change_of(term: Term, values: Values, surroundings: Surroundings) -> TermContribution:
    """Return the change of M and K by a term with given values of its parameters."""
    return _FORMS[term.form](term, values, surroundings)


def _mass(term: Term, values: Values, surroundings: Surroundings) -> TermContribution:
    (m,) = values
    M, G = _inertia(term, surroundings)
    return TermContribution(m * M, m * G)


def _inertia(term: Term, surroundings: Surroundings) -> tuple[Array, Array]:
    """Return M and the Hessian of gravity per unit of the inertia of a mass or resonator, (N, e, e)."""
    rows = surroundings.motion[:, list(term.rows)]
    M = np.swapaxes(rows, -1, -2) @ rows
    if term.declared is None:
        return M, np.zeros_like(M)
    of_M, G = surroundings.of_inertia(term.declared)
    return (M if term.rows else of_M), G


def strains(term: Term, surroundings: Surroundings) -> Array:
    """Return the strain of a spring per unit of every coordinate, (N, directions, e)."""
    motion = surroundings.motion
    rows = [motion[:, s[0]] - motion[:, s[1]] if len(s) == 2 else motion[:, s[0]] for s in term.strains]
    return np.stack(rows, axis=1)


def _spring(term: Term, values: Values, surroundings: Surroundings) -> TermContribution:
    (k,) = values
    rows = strains(term, surroundings)
    K = k * (np.swapaxes(rows, -1, -2) @ rows)
    return TermContribution(np.zeros_like(K), K)


def _mount(term: Term, values: Values, surroundings: Surroundings) -> TermContribution:
    """Return the rows of a mount with its spring 1/c; without it for an infinite one."""
    c, mounts, w = values[0], surroundings.mounts, term.mount
    M, M_own = mounts.M[:, w], mounts.M_own[:, w]
    if len(values) > 1:
        of_M, of_M_own = surroundings.of_masses
        M, M_own = M + values[1] * of_M[w], M_own + values[1] * of_M_own[w]
    spring = 1.0 / c if c != 0.0 else 0.0
    return TermContribution(_bordered(M, M_own), _bordered(mounts.K[:, w], mounts.K_own[:, w] + spring))


def _bordered(row: Array, diagonal: Array) -> Array:
    """Return symmetric matrices with a last row, (N, e) and (N,), and zeros elsewhere."""
    e = row.shape[-1]
    matrix = np.zeros((len(row), e + 1, e + 1), dtype=np.result_type(row, diagonal))
    matrix[:, e, :e] = matrix[:, :e, e] = row
    matrix[:, e, e] = diagonal
    return matrix


def _resonator(term: Term, values: Values, surroundings: Surroundings) -> TermContribution:
    m, f = values
    M, G = _inertia(term, surroundings)
    swing = surroundings.motion[:, term.swings]
    unit, e = np.ones(len(swing)), M.shape[-1]
    inertia = _bordered(m * swing, m * unit)
    stiffness = _bordered(0.0 * m * G[:, 0], m * (2.0 * np.pi * f) ** 2 * unit)
    inertia[:, :e, :e], stiffness[:, :e, :e] = m * M, m * G
    return TermContribution(inertia, stiffness)


_FORMS: dict[str, Callable[[Term, Values, Surroundings], TermContribution]] = {
    "mass": _mass,
    "spring": _spring,
    "mount": _mount,
    "resonator": _resonator,
}


class AbsentTermRates(NamedTuple):
    """The rates of (K - lambda M) phi and of phi^T M phi with the size of a term that is absent.

    - change: (N, m, e)
    - norm: (N, m)
    - motion: rates of the platform's motion in fixed coordinates, (N, m, components): what a mount deflects moves it
    """

    change: Array
    norm: Array
    motion: Array | None


def absent_term_rates(
    term: Term, values: Values, surroundings: Surroundings, eigenvalues: Array, shapes: Array
) -> AbsentTermRates:
    """Return the rates with respect to the size of an absent term.

    - values: of its parameters; the first is 0
    - eigenvalues: (N, m)
    - shapes: in all coordinates, mass-normalised, (N, m, e)
    """
    if term.form == "mount":
        mounts, w = surroundings.mounts, term.mount
        row = mounts.M[:, w] + (values[1] * surroundings.of_masses[0][w] if len(values) > 1 else 0.0)
        stiff = mounts.K[:, w]
        force = np.einsum("nie,ne->ni", shapes, stiff) - eigenvalues * np.einsum("nie,ne->ni", shapes, row)
        change = -force[..., None] * (stiff[:, None] - eigenvalues[..., None] * row[:, None])
        norm = -2.0 * force * np.einsum("nie,ne->ni", shapes, row)
        return AbsentTermRates(change, norm, -force[..., None] * mounts.platform[:, w][:, None])
    if term.form == "resonator":
        M, G = _inertia(term, surroundings)
        swing = surroundings.motion[:, term.swings]
        resonance = (2.0 * np.pi * values[1]) ** 2
        distance, min_distance = resonance - eigenvalues, NEAREST_RESONANCE * resonance
        distance = np.where(
            np.abs(distance) < min_distance, np.where(distance < 0.0, -min_distance, min_distance), distance
        )
        displacement = np.einsum("nie,ne->ni", shapes, swing)
        displacement_rows = displacement[..., None] * swing[:, None]
        inertia = shapes @ M
        factor = eigenvalues / distance
        change = shapes @ G - eigenvalues[..., None] * (inertia + factor[..., None] * displacement_rows)
        slope = (2.0 * eigenvalues * distance + eigenvalues**2) / distance**2
        norm = np.einsum("nie,nie->ni", inertia, shapes) + slope * displacement**2
        return AbsentTermRates(change, norm, None)
    unit = change_of(term, (1.0,), surroundings)
    inertia = shapes @ unit.M
    change = shapes @ unit.K - eigenvalues[..., None] * inertia
    return AbsentTermRates(change, np.einsum("nie,nie->ni", inertia, shapes), None)
