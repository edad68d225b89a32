"""The fields of a map at one pose: their names, shapes and types, the same for all of its robots."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pkmodes.core.robot.robot import Robot
from pkmodes.core.solve.fields import SHAPES, conditions_of, of_maps, sizes_of, tail
from pkmodes.core.system.evaluation import evaluation, number_of_modes
from pkmodes.core.system.motors import solved_system


@dataclass(frozen=True)
class Layout:
    """Lengths along the axes of a map that come after the poses; the same for all of its robots.

    Attributes
    ----------
    modes : int
        Largest number of vibration modes of any robot.
    coordinates : tuple of str
        All coordinates of any robot.
    conditions : frozenset of str
        Conditions under which fields are there, from `pkmodes.core.solve.fields.conditions_of`.
    backend, drives : str
        As for `pkmodes.Model.modes`.
    """

    modes: int
    coordinates: tuple[str, ...]
    conditions: frozenset[str]
    backend: str
    drives: str

    @property
    def shapes(self) -> bool:
        """Whether mode shapes are kept."""
        return SHAPES in self.conditions

    def without_shapes(self) -> Layout:
        """Return the layout of a map that does not keep mode shapes."""
        return replace(self, conditions=self.conditions - {SHAPES})


def tails(robot: Robot, layout: Layout) -> dict[str, tuple[tuple[int, ...], str]]:
    """Return the shape at one pose, and the type, of each field."""
    coordinates = len(layout.coordinates)
    independent = coordinates if layout.shapes else None
    sizes = sizes_of(robot.mechanism, layout.modes, coordinates, independent)
    fields = {field.variable: (tail(field, sizes), field.dtype) for field in of_maps(layout.conditions)}
    return {**fields, "code": ((), "i1")}


def layout_of(robots: Sequence[Robot], shapes: bool, backend: str, drives: str) -> Layout:
    """Return the layout that holds the modes of all robots."""
    modes, order = 0, {}
    for robot in robots:
        system = evaluation(robot)
        solved = solved_system(system, drives)
        modes = max(modes, number_of_modes(solved) - solved.rigid_modes)
        order.update(dict.fromkeys(system.coordinates))
    released = [q.name for effect in robots[0].mechanism.effects.values() for q in effect.coordinates]
    every = [q.name for q in robots[0].mechanism.coordinates] + released
    coordinates = tuple(sorted(order, key=every.index))
    return Layout(modes, coordinates, conditions_of(robots, shapes, drives), backend, drives)
