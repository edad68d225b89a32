"""One robot's matrices from the generated model, and their modes: the base model, or the extended one with effects.

Effects whose parameters are all at their null value are not there: their coordinates are locked, and the
base model evaluates the robot.
"""

from __future__ import annotations

import copy
from collections.abc import Callable, Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from pkmodes_generated import linear_delta as generated
from pkmodes_generated.linear_delta import Parameters

Array = NDArray[np.float64]


class Evaluation(Protocol):
    """What the solver needs of a robot.

    Attributes
    ----------
    coordinates : tuple of str
        Names of the n generalised coordinates.
    rigid_modes : int
        Modes that strain nothing elastic.
    """

    coordinates: tuple[str, ...]
    rigid_modes: int

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""

    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have no inertia at any pose, (n,): where no pose is given to tell by M."""

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""


class BaseEvaluation:
    """The base model: nine coordinates."""

    def __init__(self, parameters: Parameters) -> None:
        self._parameters = parameters
        self.coordinates: tuple[str, ...] = generated.COORDINATES
        self.rigid_modes: int = generated.RIGID_MODES

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""
        M, K = generated.modal_matrices(p, self._parameters)
        return M, K

    def massless(self) -> NDArray[np.bool_]:
        """None of them: without inertia in the base coordinates there is no eigenproblem."""
        return np.zeros(len(self.coordinates), dtype=bool)

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""
        motion = np.zeros((*p.shape, len(self.coordinates)))
        motion[..., :3] = generated.platform_jacobian(p, self._parameters)
        return motion

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""
        torques, rotations = generated.static_equilibrium(p, self._parameters)
        return torques, rotations


class SystemOfEffects:
    """The extended matrices of one robot, and which of their coordinates are free.

    Parameters
    ----------
    parameters : Parameters
    effects : mapping of str to float
        By ``<effect>.<parameter>``; a compliance that one joint has beyond the others of its effect by
        ``<effect>.<parameter>.<coordinate>``, such as ``gearbox_compliance.compliance.psi_2``.

    Attributes
    ----------
    parameters, effects : Parameters and Effects
        Of the generated model.
    free : ndarray of int, shape (n,)
        Coordinates that are not locked, in the extended model.
    joints, joint_rates : ndarray, shape (e,)
        Stiffnesses of the released joints, and their derivatives by the compliances, zero where there is none.
        Of several robots (`stacked`), (N, e) for their N poses.
    """

    def __init__(self, parameters: Parameters, effects: Mapping[str, float]) -> None:
        from pkmodes_generated.linear_delta import extended

        self._generated, self.parameters = extended, parameters
        shared, single = _told_apart(effects)
        self.effects = extended.Effects(**shared)
        base = len(generated.COORDINATES)
        with np.errstate(divide="ignore"):
            stiffness, rates = extended.joint_stiffness(self.effects)
            for coordinate, name, value in single:
                place = extended.COORDINATES.index(coordinate) - base
                beyond = extended.Effects(**{**shared, name: shared.get(name, 0.0) + value})
                stiffness[place], rates[place] = (a[place] for a in extended.joint_stiffness(beyond))
        free = np.isfinite(stiffness)  # a joint without compliance is infinitely stiff: locked
        self.free = np.concatenate([np.arange(base), base + np.flatnonzero(free)])
        self.joints = np.concatenate([np.zeros(base), np.where(free, stiffness, 0.0)])
        self.joint_rates = np.concatenate([np.zeros(base), np.where(free, rates, 0.0)])

    @classmethod
    def stacked(cls, systems: Sequence[SystemOfEffects], count: int) -> SystemOfEffects:
        """Several robots as one, to be evaluated at as many poses for each, those of the first robot first.

        Parameters
        ----------
        systems : sequence of SystemOfEffects
            With the same free coordinates.
        count : int
            Poses of each.
        """
        first = systems[0]
        if len(systems) == 1:
            return first
        found = copy.copy(first)
        found.parameters = first.parameters._replace(**_different([s.parameters for s in systems], count))
        found.effects = first.effects._replace(**_different([s.effects for s in systems], count))
        found.joints = np.repeat([s.joints for s in systems], count, axis=0)
        found.joint_rates = np.repeat([s.joint_rates for s in systems], count, axis=0)
        return found

    def all_coordinates(self, p: Array) -> tuple[Array, Array]:
        """M and K in all coordinates, each (N, e, e); locked joints are free in them, without a spring."""
        M, K = self.without_springs(p)
        diagonal = np.arange(K.shape[-1])
        K[..., diagonal, diagonal] += self.joints
        return M, K

    def without_springs(self, p: Array) -> tuple[Array, Array]:
        """The same without the springs of any released joint."""
        M, K_el, K_g = self._single(self._generated.extended_matrices, p)
        return M, K_el + K_g

    def derivatives(self, p: Array, *, geometry: bool) -> tuple[Array, Array]:
        """Derivatives of the entries of M and of K that the generated model lists, each (N, entries).

        Those by the geometry come last and take most of the time: zeros where they are not asked for.
        """
        M_theta, K_theta = self._single(self._generated.value_sensitivities, p)
        if geometry:
            also = self._single(self._generated.geometry_sensitivities, p)
        else:
            also = tuple(np.zeros((len(p), count)) for count in self._entries_of_geometry())
        return np.hstack([M_theta, also[0]]), np.hstack([K_theta, also[1]])

    def _entries_of_geometry(self) -> tuple[int, int]:
        listed = self._generated.GEOMETRY_SENSITIVITIES
        return sum(len(entry[2]) for entry in listed), sum(len(entry[3]) for entry in listed)

    def _single(self, function: Callable[..., tuple[Array, ...]], p: Array) -> tuple[Array, ...]:
        """One pose is evaluated in numbers, which is several times faster than in arrays of one."""
        if p.shape == (1, 3):
            return tuple(found[None] for found in function(p[0], self.parameters, self.effects))
        return function(p, self.parameters, self.effects)


class ExtendedEvaluation:
    """The extended model with the coordinates of the released joints that are not locked."""

    def __init__(self, parameters: Parameters, effects: Mapping[str, float]) -> None:
        from pkmodes_generated.linear_delta import extended

        self._generated, self._parameters = extended, parameters
        self._system = SystemOfEffects(parameters, effects)
        self.coordinates = tuple(extended.COORDINATES[i] for i in self._system.free)
        active = active_effects(effects)
        grounded = any(grounds and name in active for name, _, grounds, *_ in extended.EFFECTS)
        self.rigid_modes = 0 if grounded else generated.RIGID_MODES

    def matrices(self, p: Array) -> tuple[Array, Array]:
        """M and K, each (N, n, n)."""
        M, K = self._system.all_coordinates(p)
        rows, columns = np.ix_(self._system.free, self._system.free)
        return M[..., rows, columns], K[..., rows, columns]

    def massless(self) -> NDArray[np.bool_]:
        """Which released coordinates have no inertia: at any pose those of a plain geometry, masses as they are."""
        plain = self._parameters._replace(
            origin=np.zeros((3, 3)), direction=np.eye(3), joint=np.zeros((3, 3)), link_length=np.ones(3)
        )
        plain = plain._replace(limits=np.tile([-2.0, 2.0], (3, 1)), carriage_length=np.zeros(3))
        M, _, _ = self._generated.extended_matrices(np.zeros(3), plain, self._system.effects)
        found: NDArray[np.bool_] = (M == 0.0).all(axis=0)[self._system.free]
        found[: len(generated.COORDINATES)] = False
        return found

    def platform_motion(self, p: Array) -> Array:
        """Absolute motion of the platform by the coordinates, (N, 3, n)."""
        motion = self._generated.extended_platform_motion(p, self._parameters)
        found: Array = motion[..., self._system.free]
        return found

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Torques (N, 3) [N m] and pulley rotations (N, 6) [rad]."""
        torques, rotations = self._generated.extended_static_equilibrium(
            p, self._parameters, self._system.effects
        )
        return torques, rotations


def active_effects(effects: Mapping[str, float]) -> tuple[str, ...]:
    """Names of the effects that are not null; constants such as a frame's mass make none active."""
    present = {".".join(path.split(".")[:2]) for path, value in effects.items() if value != 0.0}
    if not present:
        return ()
    from pkmodes_generated.linear_delta import extended

    return tuple(
        name
        for name, *_, described in extended.EFFECTS
        if any(fitted and f"{name}.{parameter}" in present for parameter, *_, fitted in described)
    )


def _different(sets: Sequence[tuple[Any, ...]], count: int) -> dict[str, Array]:
    """Fields in which named tuples of numbers differ, with an axis in front that repeats each so many times."""
    found = {}
    for name in sets[0]._fields:  # type: ignore[attr-defined]
        values = np.array([getattr(one, name) for one in sets], dtype=float)
        if (values != values[0]).any():
            found[name] = np.repeat(values, count, axis=0)
    return found


def _told_apart(effects: Mapping[str, float]) -> tuple[dict[str, float], list[tuple[str, str, float]]]:
    """Parameters of the generated effects, and (coordinate, parameter, value) of those of one joint."""
    shared: dict[str, float] = {}
    single = []
    for path, value in effects.items():
        effect, parameter, *coordinate = path.split(".")
        if coordinate:
            single.append((coordinate[0], f"{effect}_{parameter}", value))
        else:
            shared[f"{effect}_{parameter}"] = value
    return shared, single


def evaluation(parameters: Parameters, effects: Mapping[str, float]) -> Evaluation:
    """Choose the model: the base one when every effect is null."""
    return ExtendedEvaluation(parameters, effects) if active_effects(effects) else BaseEvaluation(parameters)
