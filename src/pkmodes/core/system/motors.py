"""A robot whose motors are held: the coordinates that remain, and how the rotors follow them.

The angle of a motor, seen at the rotor that it drives, is a linear form in the coordinates that depends on no pose:
theta of that rotor, plus psi where the gearbox winds up.  With every motor at rest, the rotor is at rest too or
follows the wind-up, theta = -psi.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import cache, cached_property, lru_cache
from typing import NamedTuple, overload

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import FREE
from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.regular import field_keys, sample_parameters, sample_pose
from pkmodes.core.system.entry_rates import value_rates
from pkmodes.core.system.evaluation import INERTIAS, Evaluation, ExtendedSystem
from pkmodes.core.system.released import active_effects, spring_fields
from pkmodes.core.system.rigid_motions import rigid_motions

Array = NDArray[np.float64]
#: Derivatives below this fraction of the largest are zero.
RELATIVE_ZERO = 1e-12


class MotorsHeld(ExtendedSystem):
    """The evaluation of a robot with every motor at rest.

    The coordinates r, q = T r, are those of the robot with free motors, except that each driven rotor's coordinate is
    replaced by its motor angle, which is then locked.  The inertia of the motors and springs between them and ground
    have no influence, and are left out: nothing large cancels.

    - system: the robot with free motors

    Its attributes:
    - basis: T, in all coordinates, (e, e): 0, 1 or -1
    - free: indices of the coordinates that remain, (r,)
    - coordinates: their names, length r
    - rotors: index of the rotor that each motor drives
    """

    basis: Array

    def __init__(self, system: ExtendedSystem) -> None:
        mechanism, inert = system.mechanism, _without_influence(system.mechanism)
        parameters = system.parameters._replace(
            **{name: np.zeros_like(getattr(system.parameters, name)) for name in inert.parameters}
        )
        effects = {path: v for path, v in system.given_effects.items() if not path.startswith(inert.effects)}
        super().__init__(mechanism, parameters, effects)
        motion = np.asarray(self.generated.motor_motion())
        remaining = _held_coordinates(mechanism, motion.tobytes(), self.free.tobytes())
        self._unlocked_with_free_motors, self.free, self.basis = self.free, remaining.free, remaining.basis
        self.coordinates, self.rotors = remaining.coordinates, remaining.rotors
        self.base_count -= len(motion)
        springs = spring_fields(self.springs_to_ground)
        self.rigid_modes, self.held_motions = rigid_motions(mechanism, springs, tuple(self.rotors))

    @cached_property
    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have no inertia: released coordinates that remain and move no rotor that has inertia."""
        no_inertia = np.ones(len(self.basis), dtype=bool)
        no_inertia[self._unlocked_with_free_motors] = self.without_inertia
        massless: NDArray[np.bool_] = (no_inertia[:, None] | (self.basis == 0.0)).all(axis=0)[self.free]
        massless[: self.base_count] = False
        return massless

    @property
    def without_inertia(self) -> NDArray[np.bool_]:
        """Which coordinates with free motors move no inertia, (n,)."""
        return self._zero_inertia(self._unlocked_with_free_motors)

    def kept_and_motor_motions(self) -> tuple[Array, Array]:
        """Return all coordinates with free motors per unit of those that remain, (n, r), and of motors, (n, j)."""
        unlocked = self.basis[self._unlocked_with_free_motors]
        return unlocked[:, self.free], unlocked[:, self.rotors]

    @cached_property
    def _remaining_basis(self) -> Array:
        """The remaining coordinates, each row expressed in the free-motor coordinates, (r, n)."""
        return self.basis[np.ix_(self._unlocked_with_free_motors, self.free)].T

    def to_free_motor_coordinates(self, vectors: Array) -> Array:
        """Return vectors in the remaining coordinates, (..., r), converted to free-motor coordinates, (..., n)."""
        return np.asarray(vectors @ self._remaining_basis)


class _HeldCoordinates(NamedTuple):
    """The coordinates that remain: see `MotorsHeld`."""

    free: NDArray[np.intp]
    rotors: list[int]
    coordinates: tuple[str, ...]
    basis: Array


@lru_cache(256)  # a diagnosis requests the same few repeatedly
def _held_coordinates(mechanism: Mechanism, motion: bytes, unlocked: bytes) -> _HeldCoordinates:
    """Return the coordinates that remain where the motors are held.

    - motion: the angle of each motor per unit of each coordinate
    - unlocked: the coordinates that are not locked with free motors
    """
    first, names = len(mechanism.coordinates), mechanism.extended.COORDINATES
    motor_rows = np.frombuffer(motion).reshape(-1, len(names))
    rotors, basis = _motor_coordinates(motor_rows, first)
    free = np.setdiff1d(np.frombuffer(unlocked, dtype=np.intp), rotors)
    return _HeldCoordinates(free, rotors, tuple(names[i] for i in free), basis)


class _Inert(NamedTuple):
    """What has no influence if the motors are held: fields of the parameters, and prefixes of paths of effects."""

    parameters: tuple[str, ...]
    effects: tuple[str, ...]


def _motor_coordinates(motion: Array, first: int) -> tuple[list[int], Array]:
    """Return the driven rotors, and T, which has the angle of its motor in the place of each.

    - motion: the angle of each motor per unit of each coordinate, (drives, n)
    - first: number of coordinates without effects
    """
    rotors = [int(np.flatnonzero(row[:first])[0]) for row in motion]
    T = np.eye(motion.shape[1])
    for rotor, row in zip(rotors, motion, strict=True):
        T[rotor] = -row / row[rotor] + 0.0
        T[rotor, rotor] = 1.0 / row[rotor]
    return rotors, T


@cache
def _without_influence(mechanism: Mechanism) -> _Inert:
    """Return what changes neither M nor K of a sample robot with held motors."""
    extended, parameters = mechanism.extended, sample_parameters(mechanism)
    generated = Generated(extended, parameters, extended.Effects())
    p = sample_pose(mechanism)
    rotors, T = _motor_coordinates(np.asarray(generated.motor_motion()), len(mechanism.coordinates))
    T = np.delete(T, rotors, axis=1)
    rates = [
        matrix_rates[0] for matrix_rates in value_rates(mechanism, parameters, extended.Effects(), p[None])
    ]
    starts = [0, 0]
    influences: dict[str, set[bool]] = {}
    for field, _, *entry_lists in extended.VALUE_SENSITIVITIES:
        for k, (entries, all_rates) in enumerate(zip(entry_lists, rates, strict=True)):
            derivative = np.zeros(2 * (len(extended.COORDINATES),))
            for i, (row, column) in enumerate(entries, starts[k]):
                derivative[row, column] = derivative[column, row] = all_rates[i]
            starts[k] += len(entries)
            if derivative.any():
                reduced = np.abs(T.T @ derivative @ T).max()
                influences.setdefault(field, set()).add(
                    bool(reduced > RELATIVE_ZERO * np.abs(derivative).max())
                )
    ineffective = {field for field, outcomes in influences.items() if outcomes == {False}}
    inertias = {key.field for key in field_keys(mechanism) if key.dimension in INERTIAS}
    effects = [
        name
        for name, effect in mechanism.effects.items()
        if not effect.coordinates
        and all(f"{name}_{parameter.name}" in ineffective for parameter in effect.parameters)
    ]
    return _Inert(tuple(sorted(inertias & ineffective)), tuple(f"{name}." for name in effects))


def springs_on_motors(mechanism: Mechanism, effects: Mapping[str, float]) -> tuple[str, ...]:
    """Return the effects of a robot that mount its motors on springs (compliant motors).

    They tie the robot to ground, and have no influence once the motors are held.

    - effects: by ``<effect>.<parameter>``
    """
    return _springs_on_motors(mechanism, tuple(effects.items()))


@lru_cache(256)
def _springs_on_motors(mechanism: Mechanism, effects: tuple[tuple[str, float], ...]) -> tuple[str, ...]:
    return motor_springs_among(mechanism, active_effects(mechanism, dict(effects)))


def motor_springs_among(mechanism: Mechanism, names: Iterable[str]) -> tuple[str, ...]:
    """Return which of some names are effects that mount motors on springs."""
    grounding = [name for name in names if name in mechanism.effects and mechanism.effects[name].grounds]
    return tuple(name for name in grounding if f"{name}." in _without_influence(mechanism).effects)


class MotorEffects(NamedTuple):
    """Names of effects: those that mount motors on springs, and joints between motors and what they drive.

    Where motors are held, the springs have no influence, and the joints act like motors that give way.
    """

    springs: tuple[str, ...]
    joints: tuple[str, ...]


def motor_effects_among(mechanism: Mechanism, names: Sequence[str]) -> MotorEffects:
    """Return which of some names are effects by which motors, or what joins them to the machine, give way."""
    extended = mechanism.extended
    motion = Generated(extended, sample_parameters(mechanism), extended.Effects()).motor_motion()
    moved = {extended.COORDINATES[i] for i in np.flatnonzero(np.any(motion, axis=0))}
    of_effects = {name: {q.name for q in effect.coordinates} for name, effect in mechanism.effects.items()}
    joints = tuple(name for name in names if not moved.isdisjoint(of_effects.get(name, ())))
    return MotorEffects(motor_springs_among(mechanism, names), joints)


def motor_motion(system: Evaluation) -> Array:
    """Return the angle of each motor per unit of each coordinate with free motors, (drives, n)."""
    extended = extended_system(system)
    motion: Array = np.asarray(extended.generated.motor_motion())[:, extended.free]
    return motion


@overload
def solved_system(system: ExtendedSystem, drives: str) -> ExtendedSystem: ...
@overload
def solved_system(system: Evaluation, drives: str) -> Evaluation: ...


def solved_system(system: Evaluation, drives: str) -> Evaluation:
    """Return the system that is solved for a robot, with free or held motors.

    - system: the robot with free motors
    - drives: "free" or "held"
    """
    return system if drives == FREE else MotorsHeld(extended_system(system))


def extended_system(system: Evaluation) -> ExtendedSystem:
    """Return a system evaluated by the extended model, which alone represents motors."""
    if isinstance(system, ExtendedSystem):
        return system
    return ExtendedSystem(system.mechanism, system.parameters, {})
