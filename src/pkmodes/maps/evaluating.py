"""The fields of a map at poses of one robot: modes, statics and kinematics, NaN where a pose cannot be evaluated."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from socket import gethostname
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.dynamics import Dynamics
from pkmodes.errors import PkmodesError
from pkmodes.evaluation import evaluation
from pkmodes.generated import Generated
from pkmodes.kinematics import condition_number
from pkmodes.mechanism import Mechanism
from pkmodes.poses import CHUNK
from pkmodes.results import JOINTS
from pkmodes.robot.robot import Robot

Array = NDArray[Any]


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


@dataclass(frozen=True)
class Task:
    """Consecutive rows of a map, row = robot * poses + pose.

    Attributes
    ----------
    pieces : tuple of (Robot, ndarray of shape (N, d))
        Robots, and the poses of each.
    code : str
        Hash of the generated code, from `code_of`.
    max_condition : float
        As for `pkmodes.Model`.
    normal : str or None
        Direction perpendicular to the plane of the grid.
    layout : Layout
    """

    pieces: tuple[tuple[Robot, Array], ...]
    code: str
    max_condition: float
    normal: str | None
    layout: Layout


@cache
def code_of(kind: Mechanism) -> str:
    """Return a hash of the generated code of a mechanism, which may differ between two runs or machines."""
    files = (Path(str(module.__file__)) for module in (kind.model, kind.extended))
    return sha256(b"\0".join(path.read_bytes() for path in files)).hexdigest()


def tails(robot: Robot, layout: Layout) -> dict[str, tuple[tuple[int, ...], str]]:
    """Return the shape at one pose, and the type, of each field."""
    kind = robot.kind
    found: dict[str, tuple[tuple[int, ...], str]] = {
        "frequency": ((layout.modes,), "f8"),
        "platform_shape": ((layout.modes, len(kind.directions)), "f8"),
        "in_plane": ((layout.modes,), "f8"),
        "out_of_plane": ((layout.modes,), "f8"),
        "joint_position": ((len(layout.coordinates if layout.shapes else kind.independent),), "f8"),
        "static_torque": ((len(kind.drives),), "f8"),
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
    released = [q.name for effect in robots[0].kind.effects.values() for q in effect.coordinates]
    every = [q.name for q in robots[0].kind.coordinates] + released
    return Layout(modes, tuple(sorted(order, key=every.index)), shapes, backend)


def evaluate(task: Task) -> dict[str, Array]:
    """Evaluate the rows of a task.

    Returns
    -------
    dict of str to ndarray, shape (rows, ...)
        As in `tails`; ``code`` indexes `pkmodes.poses.codes_of`.

    Raises
    ------
    PkmodesError
        If the generated code here is not that of the task.
    """
    kind = task.pieces[0][0].kind
    if code_of(kind) != task.code:
        what = f"the generated code of {kind.name} differs from that of the map"
        raise PkmodesError(
            what, gethostname(), "generate it there with the same pkmodes, and restart the worker"
        )
    parts = [_piece(*piece, task) for piece in task.pieces]
    if len(parts) == 1:
        return parts[0]
    return {name: np.concatenate([part[name] for part in parts]) for name in parts[0]}


def _piece(robot: Robot, points: Array, task: Task) -> dict[str, Array]:
    layout, model = task.layout, Dynamics(robot, task.max_condition)
    fields = ["frequencies", "platform_shapes", JOINTS, *(["shapes"] if layout.shapes else [])]
    # One thread: tasks run side by side.
    found = model.modes(points, "nan", fields=fields, backend=layout.backend, threads=1)
    rows, rigid = len(points), found.rigid_modes
    n = found.frequencies.shape[1] - rigid
    arrays = {
        name: np.full((rows, *tail), np.nan, dtype)
        for name, (tail, dtype) in tails(robot, layout).items()
        if dtype == "f8"
    }
    arrays["frequency"][:, :n] = found.frequencies[:, rigid:]
    motion = arrays["platform_shape"][:, :n] = found.platform_shapes[:, rigid:]
    arrays["in_plane"][:, :n], arrays["out_of_plane"][:, :n] = parts_of(
        motion, robot.kind.directions, task.normal
    )
    every = layout.coordinates if layout.shapes else robot.kind.independent
    independent = [every.index(name) for name in robot.kind.independent]
    arrays["joint_position"][:, independent] = found.joint_positions
    good = np.flatnonzero(found.valid)
    statics, jacobian = (
        evaluation(robot).statics,
        Generated(robot.kind.model, robot.parameters).platform_jacobian,
    )
    for start in range(0, len(good), CHUNK):
        part = good[start : start + CHUNK]
        arrays["static_torque"][part], _ = statics(points[part])
        arrays["condition"][part] = condition_number(jacobian(points[part]))
    if layout.shapes:
        columns = [layout.coordinates.index(name) for name in found.coordinates]
        # A joint that this robot does not release does not move.
        arrays["shape"][good, :n] = 0.0
        arrays["shape"][:, :n, columns] = found.shapes[:, rigid:]
    return {**arrays, "code": found.codes}


def parts_of(motion: Array, directions: Sequence[str], normal: str | None) -> tuple[Array, Array]:
    """Split motions of the platform into magnitudes in the plane of the grid and perpendicular to it.

    Parameters
    ----------
    motion : ndarray, shape (..., directions)
    directions : sequence of str
    normal : str or None

    Returns
    -------
    in_plane, out_of_plane : ndarray, shape (...)
        The second is zero for a mechanism that moves in a plane.
    """
    plane = [i for i, name in enumerate(directions) if name != normal]
    within = np.sqrt((motion[..., plane] ** 2).sum(axis=-1))
    return within, 0.0 * within if normal is None else np.abs(motion[..., directions.index(normal)])
