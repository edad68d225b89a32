"""The fields of a map at poses: names, shapes and types, which all of its robots share, and the values for one robot.

Modes, statics and kinematics are NaN where a pose cannot be evaluated.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cache
from hashlib import sha256
from pathlib import Path
from socket import gethostname
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.poses import codes_of
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.core.robot.usable import USABLE
from pkmodes.core.robot.usable_poses import within_limits
from pkmodes.core.solve.fields import (
    COORDINATE,
    DIRECTION,
    INDEPENDENT,
    LINEAR,
    MODE,
    SHAPES,
    axis_lengths,
    conditions_of,
    map_fields,
    missing_value,
    pose_shape,
)
from pkmodes.core.system.evaluation import evaluation, number_of_modes
from pkmodes.core.system.motors import solved_system

Array = NDArray[Any]


@dataclass(frozen=True)
class MapLayout:
    """Lengths along the axes of a map that come after the poses; the same for all of its robots.

    - modes: largest number of vibration modes of any robot
    - coordinates: all coordinates of any robot
    - conditions: conditions under which fields are there, from `pkmodes.core.solve.fields.conditions_of`
    - backend, drives: as for `pkmodes.Model.modes`
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

    def without_shapes(self) -> MapLayout:
        """Return the layout of a map that does not keep mode shapes."""
        return replace(self, conditions=self.conditions - {SHAPES})


def field_layouts(robot: Robot, layout: MapLayout) -> dict[str, tuple[tuple[int, ...], str]]:
    """Return the shape at one pose, and the type, of each field."""
    coordinates = len(layout.coordinates)
    independent = coordinates if layout.shapes else None
    sizes = axis_lengths(robot.mechanism, layout.modes, coordinates, independent)
    sizes[LINEAR] = sizes[DIRECTION]
    fields = {
        field.variable: (pose_shape(field, sizes), field.dtype) for field in map_fields(layout.conditions)
    }
    return {**fields, "code": ((), "i1")}


def layout_of(robots: Sequence[Robot], shapes: bool, backend: str, drives: str) -> MapLayout:
    """Return the layout that holds the modes of all robots."""
    modes, all_coordinates = 0, {}
    for robot in robots:
        system = evaluation(robot)
        solved = solved_system(system, drives)
        modes = max(modes, number_of_modes(solved) - solved.rigid_modes)
        all_coordinates.update(dict.fromkeys(system.coordinates))
    released_coordinates = [
        q.name for effect in robots[0].mechanism.effects.values() for q in effect.coordinates
    ]
    declared_order = [q.name for q in robots[0].mechanism.coordinates] + released_coordinates
    coordinates = tuple(sorted(all_coordinates, key=declared_order.index))
    return MapLayout(modes, coordinates, conditions_of(robots, shapes, drives), backend, drives)


@dataclass(frozen=True)
class Task:
    """Consecutive rows of a map, row = robot * poses + pose.

    - pieces: robots, and the poses of each, each (N, d)
    - generated_code_hash: from `code_hash`
    - max_condition: as for `pkmodes.Model`
    - normal: direction perpendicular to the plane of the grid
    - usable_only: whether poses beyond the usable limits of a robot are left out
    """

    pieces: tuple[tuple[Robot, Array], ...]
    generated_code_hash: str
    max_condition: float
    normal: str | None
    layout: MapLayout
    usable_only: bool = False


@cache
def code_hash(mechanism: Mechanism) -> str:
    """Return a hash of the generated code of a mechanism: the code may differ between two runs or machines."""
    files = (Path(str(module.__file__)) for module in (mechanism.model, mechanism.extended))
    return sha256(b"\0".join(path.read_bytes() for path in files)).hexdigest()


def evaluate(task: Task) -> dict[str, Array]:
    """Evaluate the rows of a task.

    Returns arrays, each (rows, ...): as in `field_layouts`; ``code`` indexes `code_reasons`.
    Raises PkmodesError if the generated code here is not that of the task.
    """
    mechanism = task.pieces[0][0].mechanism
    if code_hash(mechanism) != task.generated_code_hash:
        problem = f"the generated code of {mechanism.name} differs from that of the map"
        raise PkmodesError(
            problem, gethostname(), "generate it there with the same pkmodes, and restart the worker"
        )
    results = [_evaluate_piece(*piece, task) for piece in task.pieces]
    if len(results) == 1:
        return results[0]
    return {name: np.concatenate([part[name] for part in results]) for name in results[0]}


def _evaluate_piece(robot: Robot, points: Array, task: Task) -> dict[str, Array]:
    """Evaluate a robot at its poses; the fields have room for the modes and coordinates of all robots."""
    layout, model = task.layout, Model(robot, task.max_condition)
    fields = map_fields(layout.conditions)
    # One thread: tasks run side by side.
    checked, values = model.fields_at(
        points,
        "nan",
        [field.name for field in fields],
        layout.backend,
        drives=layout.drives,
        given={"normal": task.normal},
    )
    arrays = {"code": checked.codes.copy()}
    layouts, independent = field_layouts(robot, layout), robot.mechanism.independent
    for field in fields:
        shape, dtype = layouts[field.variable]
        array = arrays[field.variable] = np.full((len(points), *shape), missing_value(dtype), dtype)
        robot_values = values[field.name]
        if field.dims[:1] == (MODE,):
            robot_values = robot_values[:, model.solved(layout.drives).rigid_modes :]
            array = array[:, : robot_values.shape[1]]
        if COORDINATE in field.dims:
            array[checked.valid] = 0.0  # a joint that this robot does not release does not move
            array[..., [layout.coordinates.index(name) for name in model.coordinates]] = robot_values
        elif INDEPENDENT in field.dims:
            coordinate_names = layout.coordinates if layout.shapes else independent
            array[..., [coordinate_names.index(name) for name in independent]] = robot_values
        elif LINEAR in field.dims:
            array[..., : robot_values.shape[-1]] = robot_values
        else:
            array[...] = robot_values
    if task.usable_only:
        unusable = checked.valid & ~within_limits(robot, points)
        for array in arrays.values():
            array[unusable] = missing_value(array.dtype.str)
        arrays["code"][unusable] = code_reasons(robot.mechanism).index(USABLE)
    return arrays


def code_reasons(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the reason for each code of a map: those for which a pose cannot be evaluated, and the usable limits."""
    return (*codes_of(mechanism), USABLE)
