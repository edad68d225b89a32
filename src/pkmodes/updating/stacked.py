"""Several robots as one system: they have the same free coordinates, and differ only in numbers."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import Lanes, flat
from pkmodes.core.system.evaluation import ExtendedSystem

Array = NDArray[np.float64]


class StackedSystems(ExtendedSystem):
    """Several robots, evaluated at equally many poses each, robot by robot.

    Parameters
    ----------
    systems : sequence of ExtendedSystem, length B
        With the same free coordinates and rigid-body modes.
    count : int
        Number of poses of each robot.

    Attributes
    ----------
    parameters, effects : Parameters and Effects
        Numbers that differ between the robots have a leading axis for the N poses.
    joints, joint_rates : ndarray, shape (N, e)
        As for `ExtendedSystem`, at each pose.
    """

    def __init__(self, systems: Sequence[ExtendedSystem], count: int) -> None:
        first = systems[0]
        self.mechanism, self.first, self.rigid_modes = first.mechanism, first.first, first.rigid_modes
        self.free, self.coordinates = first.free, first.coordinates
        self.held_motions, self.springs_to_ground = first.held_motions, first.springs_to_ground
        self.basis = first.basis
        self._systems, self._count = tuple(systems), count

    @cached_property
    def parameters(self) -> Any:
        """The robots, as the generated model takes them."""
        sets = [s.parameters for s in self._systems]
        return sets[0]._replace(**_different(sets, self._count))

    @cached_property
    def effects(self) -> Any:
        """Their effects."""
        sets = [s.effects for s in self._systems]
        return sets[0]._replace(**_different(sets, self._count))

    @cached_property
    def joints(self) -> Array:  # type: ignore[override]
        """Stiffnesses of the released joints."""
        return np.repeat([s.joints for s in self._systems], self._count, axis=0)

    @cached_property
    def joint_rates(self) -> Array:  # type: ignore[override]
        """Their derivatives with respect to the compliances."""
        return np.repeat([s.joint_rates for s in self._systems], self._count, axis=0)

    @cached_property
    def massless(self) -> NDArray[np.bool_]:
        """Which coordinates have inertia in none of the robots."""
        return np.asarray(np.all([s.massless for s in self._systems], axis=0))

    def lanes(self) -> Lanes:
        """The robots as the compiled evaluator takes them."""
        return Lanes(
            _flat_of_each([s.parameters for s in self._systems]),
            _flat_of_each([s.effects for s in self._systems]),
            np.array([s.joints for s in self._systems]),
            self.free.astype(np.int32),
            self.massless.astype(np.int8),
            self.fold(),
        )


def stacked(systems: Sequence[ExtendedSystem], count: int) -> ExtendedSystem:
    """Combine robots, see `StackedSystems`; a single one is returned as it is."""
    return systems[0] if len(systems) == 1 else StackedSystems(systems, count)


def _different(sets: Sequence[tuple[Any, ...]], count: int) -> dict[str, Array]:
    """Return the fields in which the named tuples differ, each value repeated `count` times along a leading axis."""
    repeated = {}
    for name in sets[0]._fields:  # type: ignore[attr-defined]
        values = np.array([getattr(one, name) for one in sets], dtype=float)
        if (values != values[0]).any():
            repeated[name] = np.repeat(values, count, axis=0)
    return repeated


def _flat_of_each(sets: Sequence[tuple[Any, ...]]) -> Array:
    """Return the fields of each named tuple in a row; most of them are the same objects."""
    rows = np.tile(flat(sets[0]), (len(sets), 1))
    ends = np.cumsum([np.size(value) for value in sets[0]]).tolist()
    for row, one in zip(rows[1:], sets[1:], strict=True):
        for value, first, end in zip(one, sets[0], ends, strict=True):
            if value is not first:
                row[end - np.size(value) : end] = np.ravel(value)
    return rows
