"""The fields of a map at poses of one robot: modes, statics and kinematics, NaN where a pose cannot be evaluated."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from pathlib import Path
from socket import gethostname
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import PkmodesError
from pkmodes.dataset.motion import parts_of
from pkmodes.maps.layout import Layout, tails
from pkmodes.mechanism.generated import Generated
from pkmodes.mechanism.poses import CHUNK
from pkmodes.mechanism.registry import Mechanism
from pkmodes.robot.robot import Robot
from pkmodes.solve.dynamics import Dynamics
from pkmodes.solve.kinematics import condition_number
from pkmodes.solve.results import JOINTS
from pkmodes.system.evaluation import evaluation

Array = NDArray[Any]


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
def code_of(mechanism: Mechanism) -> str:
    """Return a hash of the generated code of a mechanism, which may differ between two runs or machines."""
    files = (Path(str(module.__file__)) for module in (mechanism.model, mechanism.extended))
    return sha256(b"\0".join(path.read_bytes() for path in files)).hexdigest()


def evaluate(task: Task) -> dict[str, Array]:
    """Evaluate the rows of a task.

    Returns
    -------
    dict of str to ndarray, shape (rows, ...)
        As in `tails`; ``code`` indexes `pkmodes.mechanism.poses.codes_of`.

    Raises
    ------
    PkmodesError
        If the generated code here is not that of the task.
    """
    mechanism = task.pieces[0][0].mechanism
    if code_of(mechanism) != task.code:
        what = f"the generated code of {mechanism.name} differs from that of the map"
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
        motion, robot.mechanism.directions, task.normal
    )
    every = layout.coordinates if layout.shapes else robot.mechanism.independent
    independent = [every.index(name) for name in robot.mechanism.independent]
    arrays["joint_position"][:, independent] = found.joint_positions
    good = np.flatnonzero(found.valid)
    statics, jacobian = (
        evaluation(robot).statics,
        Generated(robot.mechanism.model, robot.parameters).platform_jacobian,
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
