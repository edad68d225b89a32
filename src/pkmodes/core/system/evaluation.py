"""Matrices of one robot from the generated model: the base model, or the extended model with effects.

An effect whose parameters are all at their null value is absent: its coordinates are locked.  A robot without
effects is evaluated by the base model.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache, cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import NO_FOLD, Fold, Lanes, flattened
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import field_keys, sample_parameters, sample_pose
from pkmodes.core.robot.robot import Robot
from pkmodes.core.system.released import active_effects, released_joints

Array = NDArray[np.float64]
#: Dimensions of inertias.
INERTIAS = ("mass", "moment of inertia")


class Evaluation:
    """The matrices of a robot: here of the base model, without effects.

    - parameters: of the generated model

    Its attributes:
    - coordinates: names of the n generalised coordinates
    - base_count: index of the first coordinate of a released joint, which is the number of coordinates without
      effects
    - rigid_modes: number of modes that strain nothing elastic
    - held_motions: number of motions that strain only springs to ground: the rank of these springs
    - springs_to_ground: these springs, by path without ``effects.``
    """

    coordinates: tuple[str, ...]
    base_count: int
    rigid_modes: int
    held_motions: int
    springs_to_ground: Mapping[str, float]

    def __init__(self, mechanism: Mechanism, parameters: Any) -> None:
        self.mechanism, self.parameters = mechanism, parameters
        self.coordinates = tuple(q.name for q in mechanism.coordinates)
        self.base_count, self.rigid_modes = len(self.coordinates), mechanism.rigid_modes
        self.held_motions, self.springs_to_ground = 0, {}

    @property
    def loose_motions(self) -> int:
        """Number of motions that strain nothing of the machine, if springs to ground hold some of them; else 0."""
        return self.rigid_modes + self.held_motions if self.held_motions else 0

    @property
    def generated(self) -> Generated:
        """The generated functions, with the robot's numbers bound."""
        return Generated(self.mechanism.model, self.parameters)

    def all_coordinates(self, p: Array) -> tuple[Array, Array]:
        """Return M and K including the coordinates of locked joints, if the model has any, each (N, e, e)."""
        M, K = self.generated.modal_matrices(p)
        return M, K

    def free_part(self, matrix: Array) -> Array:
        """Return the rows and columns of a matrix in all coordinates that belong to `coordinates`, (N, n, n)."""
        return matrix

    @cached_property
    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have no inertia at any pose, (n,); every base coordinate needs some."""
        return np.zeros(len(self.coordinates), dtype=bool)

    def platform_motion(self, p: Array) -> Array:
        """Return the absolute platform motion per unit of each coordinate, (N, components, n)."""
        pose = [component.name for component in self.mechanism.pose]
        rows = [pose.index(name) for name in self.mechanism.components]
        columns = [self.coordinates.index(name) for name in self.mechanism.independent]
        motion = np.zeros((*p.shape[:-1], len(rows), len(self.coordinates)))
        motion[..., columns] = self.generated.platform_jacobian(p)[..., rows, :]
        return motion

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Return torques (N, drives) [N m] and static values of the dependent coordinates (N, ...)."""
        torques, values = self.generated.static_equilibrium(p)
        return torques, values

    def lanes(self) -> Lanes:
        """The robot as the compiled evaluator takes it."""
        empty = np.empty(0)
        return Lanes(flattened(self.parameters), empty, empty, empty.astype(np.int32), empty.astype(np.int8))


class ExtendedSystem(Evaluation):
    """The extended model of one robot, with the coordinates of released joints that are not locked.

    - parameters: the robot, as the generated model takes it
    - effects: by ``<effect>.<parameter>``; the additional compliance of a single joint of an effect is given by
      ``<effect>.<parameter>.<coordinate>``, such as ``gearbox_compliance.compliance.psi_2``

    Its attributes:
    - parameters, effects: arguments of the generated model
    - given_effects: the effects as given
    - free: indices of the coordinates of the extended model that are not locked, (n,)
    - coordinates: their names, length n
    - base_count, rigid_modes, held_motions, springs_to_ground: see `Evaluation`
    - joints, joint_rates: stiffnesses of the released joints and their derivatives with respect to the compliances,
      (e,); zero for other coordinates
    """

    #: The coordinates of the generated model per unit of all coordinates here, (e, e), if the two differ.
    basis: Array | None = None

    def __init__(self, mechanism: Mechanism, parameters: Any, effects: Mapping[str, float]) -> None:
        self.mechanism, self.parameters, self.given_effects = mechanism, parameters, effects
        self.base_count = len(mechanism.coordinates)
        release = released_joints(mechanism, tuple(effects.items()))
        self.effects, self.free, self.coordinates = release.effects, release.free, release.coordinates
        self.joints, self.joint_rates = release.joints, release.joint_rates
        self.springs_to_ground = release.springs_to_ground
        self.rigid_modes, self.held_motions = release.rigid_motions

    @classmethod
    def of(cls, robot: Robot) -> ExtendedSystem:
        """Return the system of a robot, with or without effects."""
        return cls(robot.mechanism, robot.parameters, robot.effects)

    @property
    def generated(self) -> Generated:
        """The generated functions, with the robot's numbers and effects bound."""
        return Generated(self.mechanism.extended, self.parameters, self.effects)

    def all_coordinates(self, p: Array) -> tuple[Array, Array]:
        """Return M and K in all coordinates, each (N, e, e); here locked joints are free and have no spring."""
        return self._with_springs(*self.without_springs(p))

    def from_generated_matrices(self, M: Array, K: Array) -> tuple[Array, Array]:
        """Return M and K in all coordinates from those of the generated model, each (N, e, e)."""
        return self._with_springs(self.in_basis(M), self.in_basis(K))

    def _with_springs(self, M: Array, K: Array) -> tuple[Array, Array]:
        diagonal = np.arange(K.shape[-1])
        K[..., diagonal, diagonal] += self.joints
        return M, K

    def free_part(self, matrix: Array) -> Array:
        """Return the rows and columns of the coordinates that are not locked."""
        rows, columns = np.ix_(self.free, self.free)
        return matrix[..., rows, columns]

    def without_springs(self, p: Array) -> tuple[Array, Array]:
        """Return M and K in all coordinates without the springs of the released joints."""
        M, K_el, K_g = self.evaluate_function("extended_matrices", p)
        return self.in_basis(M), self.in_basis(K_el + K_g)

    def in_basis(self, matrix: Array) -> Array:
        """Return a matrix in the coordinates of the generated model, (..., e, e), in all coordinates here."""
        return matrix if self.basis is None else np.asarray(self.basis.T @ matrix @ self.basis)

    def to_model_coordinates(self, vectors: Array) -> Array:
        """Return vectors in all coordinates here, (..., e), in the coordinates of the generated model."""
        return vectors if self.basis is None else np.asarray(vectors @ self.basis.T)

    @cached_property
    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have no inertia, (n,): only released ones may."""
        massless = np.zeros(len(self.free), dtype=bool)
        if len(self.free) > self.base_count:
            massless[self.base_count :] = self.without_inertia[self.base_count :]
        return massless

    @property
    def without_inertia(self) -> NDArray[np.bool_]:
        """Which coordinates that are not locked move no inertia, (n,): released or not."""
        return self._zero_inertia(self.free)

    def _zero_inertia(self, coordinates: NDArray[np.intp]) -> NDArray[np.bool_]:
        values = (*self.effects, *(getattr(self.parameters, name) for name in _inertias(self.mechanism)))
        zeros = b"".join((np.asarray(value) == 0.0).tobytes() for value in values)
        massless: NDArray[np.bool_] = _massless(self.mechanism, zeros)[coordinates]
        return massless

    def platform_motion(self, p: Array) -> Array:
        """Return the absolute platform motion per unit of each coordinate, (N, components, n)."""
        return self.full_platform_motion(p)[..., self.free]

    def full_platform_motion(self, p: Array, parameters: Any = None, effects: Any = None) -> Array:
        """Return `platform_motion` for all coordinates, (N, components, e), by default with the robot's numbers."""
        chosen_parameters = self.parameters if parameters is None else parameters
        chosen_effects = self.effects if effects is None else effects
        motion = np.asarray(
            Generated(self.mechanism.extended, chosen_parameters, chosen_effects).extended_platform_motion(p)
        )
        return motion if self.basis is None else motion @ self.basis

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Return torques (N, drives) [N m] and static values of the dependent coordinates (N, ...)."""
        torques, values = self.generated.extended_static_equilibrium(p)
        return torques, values

    def lanes(self) -> Lanes:
        """The robot as the compiled evaluator takes it."""
        return Lanes(
            flattened(self.parameters),
            flattened(self.effects),
            self.joints,
            self.free.astype(np.int32),
            self.massless.astype(np.int8),
            self.fold(),
        )

    def fold(self) -> Fold:
        """Return which coordinates of the generated model follow those that are free here."""
        if self.basis is None:
            return NO_FOLD
        following, leading = np.nonzero(self.basis - np.diag(np.diag(self.basis)))
        return Fold(
            leading.astype(np.int32), following.astype(np.int32), self.basis[following, leading].copy()
        )

    def evaluate_function(self, name: str, p: Array) -> tuple[Array, ...]:
        """Evaluate a generated function; a single pose uses scalars, several times faster than arrays of length 1."""
        function: Callable[[Array], tuple[Array, ...]] = getattr(self.generated, name)
        return tuple(values[None] for values in function(p[0])) if len(p) == 1 else function(p)


@cache
def _inertias(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the generated parameters that are inertias."""
    return tuple(dict.fromkeys(key.field for key in field_keys(mechanism) if key.dimension in INERTIAS))


@cache
def _massless(mechanism: Mechanism, zeros: bytes) -> NDArray[np.bool_]:
    """Return which of all coordinates have no inertia, (e,).

    This depends only on which effects and inertias are zero (`zeros`, in their order); it is read from M of the
    sample robot at a regular pose, with 1 for those that are not zero.
    """
    parameters, effects, names = (
        sample_parameters(mechanism),
        mechanism.extended.Effects(),
        _inertias(mechanism),
    )
    nonzero = 1.0 - np.frombuffer(zeros, dtype=np.bool_)
    shapes = [np.shape(value) for value in (*effects, *(getattr(parameters, name) for name in names))]
    ends = np.cumsum([int(np.prod(shape)) for shape in shapes])
    values = [part.reshape(shape) for part, shape in zip(np.split(nonzero, ends[:-1]), shapes, strict=True)]
    parameters = parameters._replace(**dict(zip(names, values[len(effects) :], strict=True)))
    generated = Generated(mechanism.extended, parameters, effects._make(values[: len(effects)]))
    M, _, _ = generated.extended_matrices(sample_pose(mechanism))
    return np.asarray((M == 0.0).all(axis=0))


def number_of_modes(system: Evaluation) -> int:
    """Return how many coordinates have inertia."""
    return len(system.coordinates) - int(np.count_nonzero(system.massless))


def matrices(system: Evaluation, p: Array) -> tuple[Array, Array]:
    """Return M and K of the free coordinates, each (N, n, n)."""
    M, K = (system.free_part(matrix) for matrix in system.all_coordinates(p))
    return M, K


def may_be_refused(system: Evaluation) -> bool:
    """Return whether a robot may be refused because its effects leave its modes too few digits.

    A robot without effects is refused only where its magnitudes are out of all proportion.
    """
    return len(system.coordinates) > system.base_count or system.held_motions > 0


def evaluation(robot: Robot) -> Evaluation:
    """Choose the model of a robot: the base model if no effect changes M or K, else the extended model."""
    mechanism = robot.mechanism
    active = {*active_effects(mechanism, robot.effects)} & mechanism.conservative_effects.keys()
    return ExtendedSystem.of(robot) if active else Evaluation(mechanism, robot.parameters)
