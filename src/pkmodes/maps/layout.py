"""The fields of a map at one pose: their names, shapes and types, the same for all of its robots."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from pkmodes.robot.robot import Robot
from pkmodes.system.evaluation import evaluation


@dataclass(frozen=True)
class Layout:
    """Lengths along the axes of a map that come after the poses; the same for all of its robots.

    Attributes
    ----------
    modes : int
        Largest number of vibration modes of any robot.
    coordinates : tuple of str
        All coordinates of any robot.
    shapes : bool
        Whether mode shapes are kept.
    backend : str
        As for `pkmodes.Model.modes`.
    """

    modes: int
    coordinates: tuple[str, ...]
    shapes: bool
    backend: str


def tails(robot: Robot, layout: Layout) -> dict[str, tuple[tuple[int, ...], str]]:
    """Return the shape at one pose, and the type, of each field."""
    mechanism = robot.mechanism
    found: dict[str, tuple[tuple[int, ...], str]] = {
        "frequency": ((layout.modes,), "f8"),
        "platform_shape": ((layout.modes, len(mechanism.directions)), "f8"),
        "in_plane": ((layout.modes,), "f8"),
        "out_of_plane": ((layout.modes,), "f8"),
        "joint_position": ((len(layout.coordinates if layout.shapes else mechanism.independent),), "f8"),
        "static_torque": ((len(mechanism.drives),), "f8"),
        "condition": ((), "f8"),
        "code": ((), "i1"),
    }
    if layout.shapes:
        found["shape"] = ((layout.modes, len(layout.coordinates)), "f8")
    return found


def layout_of(robots: Sequence[Robot], shapes: bool, backend: str) -> Layout:
    """Return the layout that holds the modes of all robots."""
    modes, order = 0, {}
    for robot in robots:
        found = evaluation(robot)
        modes = max(modes, len(found.coordinates) - int(found.massless().sum()) - found.rigid_modes)
        order.update(dict.fromkeys(found.coordinates))
    released = [q.name for effect in robots[0].mechanism.effects.values() for q in effect.coordinates]
    every = [q.name for q in robots[0].mechanism.coordinates] + released
    return Layout(modes, tuple(sorted(order, key=every.index)), shapes, backend)
