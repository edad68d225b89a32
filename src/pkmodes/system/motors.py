"""A robot whose motors are held: the coordinates that remain, and how the rotors follow them.

The angle of a motor, seen at the rotor that it drives, is a linear form in the coordinates that depends on no pose:
theta of that rotor, plus psi where the gearbox winds up.  If every motor is at rest, the rotor is at rest too or
follows the wind-up, theta = -psi, so that the coordinates are q = T r with a constant T.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.compiled.lanes import Fold, Lanes
from pkmodes.mechanism.generated import Generated
from pkmodes.mechanism.registry import Mechanism
from pkmodes.mechanism.regular import declared, regular_poses, sample
from pkmodes.system.evaluation import INERTIAS, Evaluation, ExtendedSystem

Array = NDArray[np.float64]
#: An eigenvalue below this fraction of the largest is that of a motion that strains nothing.
RIGID = 1e-9
#: Derivatives below this fraction of the largest are zero.
ZERO = 1e-12


class MotorsHeld:
    """The evaluation of a robot with every motor at rest (`pkmodes.system.evaluation.Evaluation`).

    The inertia of the motors and springs between them and ground have no influence, and are left out: nothing large
    cancels.

    Parameters
    ----------
    system : ExtendedSystem
        The robot with free motors.

    Attributes
    ----------
    T : ndarray, shape (n, r)
        The n coordinates with free motors per unit of each that remains: 0, 1 or -1.
    coordinates : tuple of str, length r
        The coordinates that remain.
    system : ExtendedSystem
        The robot with free motors, without what has no influence.
    """

    def __init__(self, system: ExtendedSystem) -> None:
        inert = _inert(system.mechanism)
        parameters = system.parameters._replace(
            **{name: np.zeros_like(getattr(system.parameters, name)) for name in inert.parameters}
        )
        effects = {path: v for path, v in system.given.items() if not path.startswith(inert.effects)}
        self.system = ExtendedSystem(system.mechanism, parameters, effects)
        self.mechanism, self.parameters = system.mechanism, system.parameters
        motion = Generated(self.mechanism.extended, parameters, self.system.effects).motor_motion()
        self._kept, self.T = _following(np.asarray(motion)[:, self.system.free], self.system.first)
        self.coordinates = tuple(system.coordinates[i] for i in self._kept)
        self.first = int(np.count_nonzero(self._kept < self.system.first))
        loose = _loose(self.mechanism, np.asarray(motion)[:, : self.system.first].tobytes())
        self.springs_to_ground: Mapping[str, float] = self.system.springs_to_ground
        self.rigid_modes = 0 if self.springs_to_ground else loose
        self.held_motions = loose - self.rigid_modes

    def all_coordinates(self, p: Array) -> tuple[Array, Array]:
        """Return M and K in all coordinates, with motors that have no inertia, each (N, e, e)."""
        return self.system.all_coordinates(p)

    def free_part(self, matrix: Array) -> Array:
        """Return such a matrix in the coordinates that remain, (N, r, r)."""
        return np.asarray(self.T.T @ self.system.free_part(matrix) @ self.T)

    def massless(self) -> NDArray[np.bool_]:
        """Return which coordinates that remain have no inertia, (r,)."""
        none = self.system.without_inertia
        moved = self.T != 0.0
        massless: NDArray[np.bool_] = (none[:, None] | ~moved).all(axis=0)
        massless[: self.first] = False
        return massless

    def platform_motion(self, p: Array) -> Array:
        """Return the absolute platform motion per unit of each coordinate that remains, (N, directions, r)."""
        return np.asarray(self.system.platform_motion(p) @ self.T)

    def statics(self, p: Array) -> tuple[Array, Array]:
        """Return torques (N, drives) [N m] and static values of the dependent coordinates (N, ...)."""
        return self.system.statics(p)

    def in_all(self, shapes: Array) -> Array:
        """Return shapes, (N, m, r), in the coordinates with free motors, (N, m, n)."""
        return np.asarray(shapes @ self.T.T)

    def lanes(self) -> Lanes:
        """The robot as the compiled evaluator takes it."""
        free = self.system.free
        rotors, columns = np.nonzero(self.T)
        folded = rotors != self._kept[columns]
        fold = Fold(
            free[self._kept[columns[folded]]].astype(np.int32),
            free[rotors[folded]].astype(np.int32),
            self.T[rotors[folded], columns[folded]],
        )
        return self.system.lanes()._replace(
            free=free[self._kept].astype(np.int32), massless=self.massless().astype(np.int8), fold=fold
        )


class _Inert(NamedTuple):
    """What has no influence if the motors are held: fields of the parameters, and prefixes of paths of effects."""

    parameters: tuple[str, ...]
    effects: tuple[str, ...]


def _following(motion: Array, first: int) -> tuple[NDArray[np.intp], Array]:
    """Return the coordinates that remain, and T.

    Parameters
    ----------
    motion : ndarray, shape (drives, n)
        The angle of each motor per unit of each coordinate.
    first : int
        Number of coordinates without effects.
    """
    rotors = [int(np.flatnonzero(row[:first])[0]) for row in motion]
    kept = np.array([i for i in range(motion.shape[1]) if i not in rotors], dtype=np.intp)
    T = np.eye(motion.shape[1])[:, kept]
    for rotor, row in zip(rotors, motion, strict=True):
        T[rotor] = -row[kept] / row[rotor] + 0.0
    return kept, T


@cache
def _loose(mechanism: Mechanism, motion: bytes) -> int:
    """Return how many motions strain nothing elastic although the motors are held.

    Parameters
    ----------
    motion : bytes
        The angles of the motors per unit of each coordinate without effects.
    """
    plain, base = sample(mechanism), len(mechanism.coordinates)
    p = regular_poses(Generated(mechanism.model, plain), mechanism, plain, 1)
    M, K, _ = Generated(mechanism.extended, plain, mechanism.extended.Effects()).extended_matrices(p[0])
    _, T = _following(np.frombuffer(motion).reshape(-1, base), base)
    M, K = (T.T @ matrix[:base, :base] @ T for matrix in (M, K))
    scale = 1.0 / np.sqrt(np.diag(M))
    levels = np.linalg.eigvalsh(K * np.outer(scale, scale))
    return int(np.count_nonzero(levels < RIGID * levels[-1]))


@cache
def _inert(mechanism: Mechanism) -> _Inert:
    """Return what changes neither M nor K of a sample robot with held motors."""
    extended, plain = mechanism.extended, sample(mechanism)
    generated = Generated(extended, plain, extended.Effects())
    p = regular_poses(Generated(mechanism.model, plain), mechanism, plain, 1)[0]
    _, T = _following(np.asarray(generated.motor_motion()), len(mechanism.coordinates))
    rates = generated.value_sensitivities(p)
    starts = [0, 0]
    seen: dict[str, set[bool]] = {}
    for field, _, *places in extended.VALUE_SENSITIVITIES:
        for k, (entries, all_rates) in enumerate(zip(places, rates, strict=True)):
            part = np.zeros(2 * (len(extended.COORDINATES),))
            for i, (row, column) in enumerate(entries, starts[k]):
                part[row, column] = part[column, row] = all_rates[i]
            starts[k] += len(entries)
            if part.any():
                left = np.abs(T.T @ part @ T).max()
                seen.setdefault(field, set()).add(bool(left > ZERO * np.abs(part).max()))
    without = {field for field, moves in seen.items() if moves == {False}}
    inertias = {key.field for key in declared(mechanism) if key.dimension in INERTIAS}
    effects = [name for name, effect in mechanism.effects.items() if _all_of(name, effect, without)]
    return _Inert(tuple(sorted(inertias & without)), tuple(f"{name}." for name in effects))


def _all_of(name: str, effect: Any, without: set[str]) -> bool:
    fields = [f"{name}_{parameter.name}" for parameter in effect.parameters]
    return not effect.coordinates and all(field in without for field in fields)


def motors_held(system: Evaluation) -> MotorsHeld:
    """Return a robot with held motors.

    Parameters
    ----------
    system : Evaluation
        The robot with free motors; without effects it is evaluated by the extended model.
    """
    if isinstance(system, ExtendedSystem):
        return MotorsHeld(system)
    return MotorsHeld(ExtendedSystem(system.mechanism, system.parameters, {}))
