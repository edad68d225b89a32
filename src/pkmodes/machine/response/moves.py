"""A move of a robot whose motors follow a command: how far the platform is from where it should be."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import Constraint, check_argument, is_number, real_numbers
from pkmodes.core.base.attached import Attached
from pkmodes.core.base.drives import HELD
from pkmodes.core.base.errors import PkmodesError, PoseError, shown
from pkmodes.core.mechanism.poses import format_pose
from pkmodes.core.model import Model
from pkmodes.core.robot.pose_table import poses_by_name
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.motors import drives_in_use
from pkmodes.machine.response.path_vibration import deviation_along
from pkmodes.machine.shaping.arguments import checked_impulses
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]
#: Longest step between two poses whose matrices are evaluated [m], rotations times the characteristic length: errors
#: below 0.1 % of the vibration.
MAX_STEP = 3e-3
RATIO = Constraint(
    "a damping ratio of at least 0 and below 1", lambda value: is_number(value) and 0.0 <= value < 1.0
)


@dataclass(frozen=True, eq=False)
class Move:
    """A move of a robot whose motors follow a command, at T times.

    Attributes
    ----------
    time : ndarray, shape (T,)
        Times [s].
    poses : ndarray, shape (T, d)
        What the motors are told: the command, after the shaper.  The platform is at ``poses + deviation``.
    deviation : ndarray, shape (T, d)
        Deviation of the platform from `poses` [m]; where it turns, by small rotations about base axes [rad].  Static
        sag under gravity is not part of it.
    robot : Robot
        The robot that moves.
    drives : {"free", "held"}
        What the motors do: held to the command, or free against springs that are.
    """

    time: Array
    poses: Array
    deviation: Array
    robot: Robot = field(repr=False)
    drives: str = HELD

    _repr_html_ = Attached("pkmodes.pages.report.notebook:move_html")

    def largest(self, after: float = -np.inf) -> float:
        """Return the largest distance of the platform from `poses` [m], from a time [s] on."""
        mechanism = self.robot.mechanism
        linear = [i for i, component in enumerate(mechanism.pose) if component.name in mechanism.directions]
        distance = np.linalg.norm(self.deviation[self.time >= after][:, linear], axis=-1)
        return float(distance.max(initial=0.0))


def simulate(
    model: Model,
    time: ArrayLike,
    poses: ArrayLike,
    *,
    shaper: Shaper | None = None,
    damping: float | None = None,
    drives: str | None = None,
) -> Move:
    """Simulate how the platform rings while the motors follow a command (docs/how-to/shapers.md).

    Modes, inertia and motion are those of the commanded pose of each moment; vibrations are small, and forces
    that grow with the square of the speed are left out.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    time : array_like, shape (T,)
        Ascending [s].  Before the first sample the machine is at rest; between samples the command is a straight
        line, so sample it as the controller does.
    poses : array_like, shape (T, d)
        The command, in SI units.
    shaper : Shaper, optional
        Shaper with which the command is convolved: one, amplitudes and delays (n,), or one for each time, (T, n),
        which splits what the command moves up to this time: `shaper` designs them for the commanded poses.
    damping : float, optional
        Damping ratio of every mode, instead of that of the robot file.
    drives : {"free", "held"}, optional
        What the motors do: "held", exactly what they are told; "free", with the springs that the robot file has for
        them (``[effects.servo_stiffness]``), whose other ends do what they are told.  By default the latter where
        the file has such springs.

    Returns
    -------
    Move
        ``poses``, what the motors are told: the command after the shaper; and ``deviation``, how far the platform
        is from them [m, rad], both (T, d).

    Raises
    ------
    PkmodesError
        If the times do not ascend, or shapes do not go together; or if motors that nothing holds are to be free.
    PoseError
        If the path leaves the workspace; the message says when and where.

    Examples
    --------
    >>> import numpy as np, pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022-identified.toml")
    >>> t = np.arange(0.0, 0.4, 0.001)  # 0.1 m/s within 10 ms, then on
    >>> x = 0.5 + np.where(t < 0.01, 5.0 * t**2, 0.1 * t - 0.0005)
    >>> move = model.simulate(t, np.stack([x, 0.0 * x, 0.0 * x - 0.245], axis=-1), damping=0.01)
    >>> bool(move.largest(after=0.05) > 1e-4)
    True
    """
    drives_used = drives_in_use(model.robot, drives)
    t = _times(time)
    command = _command(model, poses, t)
    shaped = command if shaper is None else shaped_command(t, command, shaper)
    fine_time, path, indices = _refined(t, shaped, model)
    _check_path(model, fine_time, path)
    if damping is not None:
        check_argument(damping, RATIO, "damping", "give the ratio of every mode, such as 0.01")
        model = model.with_values({"damping.ratio": float(damping)})
    if rigid := model.solved(HELD).rigid_modes:
        problem = f"with motors held the machine still has {rigid} rigid modes: they would drift away"
        raise PkmodesError(problem, model.robot.source, "check the drives of the mechanism")
    return Move(
        t, shaped, deviation_along(model, fine_time, path, drives_used)[indices], model.robot, drives_used
    )


def shaped_command(time: Array, command: Array, shaper: Shaper) -> Array:
    """Return a command after a shaper, (T, d).

    Every increment of the command is split into parts that arrive later.  A shaper for each time splits the increment
    up to this time, while the machine is still underway: in the middle of the impulses it has about the commanded
    pose of that time.  All parts arrive, so the shaped command ends where the command does.

    - time: before the first one the machine rests, (T,)
    - command: a straight line between times, (T, d)
    - shaper: one for all times, amplitudes and delays (n,), or one for each, (T, n)

    Raises PkmodesError if the shaper has neither shape, or its delays shorten faster than time passes.
    """
    amplitudes, delays = checked_impulses(shaper)
    if delays.ndim > 2 or (delays.ndim == 2 and len(delays) != len(time)):
        problem = (
            f"expected impulses of shape (n,), or ({len(time)}, n) for as many times, found {delays.shape}"
        )
        raise PkmodesError(problem, "shaper", "design one shaper, or one for each time")
    arrival = time[:, None] + delays  # T, n
    overtaken = np.flatnonzero((np.diff(arrival, axis=0) < 0.0).any(axis=1))
    if len(overtaken):
        problem = f"the delays shorten faster than time passes at {time[overtaken[0]]:.6g} s"
        raise PkmodesError(problem, "shaper", "move more slowly, or sample the command more finely")
    increments = np.diff(command, axis=0, prepend=command[:1])
    parts = np.cumsum(amplitudes[..., None] * increments[:, None, :], axis=0)  # T, n, d
    shaped = np.repeat(command[:1], len(time), axis=0)
    for i, k in np.ndindex(*parts.shape[1:]):
        shaped[:, k] += np.interp(time, arrival[:, i], parts[:, i, k])
    return shaped


def _times(time: ArrayLike) -> Array:
    remedy = "give an array of shape (T,)"
    t = real_numbers(time, "times in s", "time", remedy)
    if t.ndim != 1 or len(t) < 2:
        raise PkmodesError(f"expected at least two times in s, found {shown(time)}", "time", remedy)
    if not np.isfinite(t).all():
        k = int(np.argmin(np.isfinite(t)))
        raise PkmodesError(f"expected finite times in s, found {t[k]} at index {k}", "time", remedy)
    not_ascending = np.flatnonzero(np.diff(t) <= 0.0)
    if len(not_ascending):
        k = int(not_ascending[0])
        problem = f"expected ascending times, found {t[k + 1]:.9g} s after {t[k]:.9g} s, at index {k + 1}"
        raise PkmodesError(problem, "time", "sort the samples, and give each time once")
    return t


def _command(model: Model, poses: ArrayLike, time: Array) -> Array:
    mechanism = model.robot.mechanism
    names = [component.name for component in mechanism.pose]
    remedy = f"give {', '.join(names)} at every time"
    p = real_numbers(
        poses_by_name(poses, mechanism), f"a pose {', '.join(names)} for each time", "poses", remedy
    )
    if p.shape != (len(time), len(names)):
        problem = f"expected poses of shape ({len(time)}, {len(names)}), one for each time, found {p.shape}"
        raise PkmodesError(problem, "poses", remedy)
    fixed_components = [i for i, name in enumerate(names) if name not in mechanism.components]
    if fixed_components and np.ptp(p[:, fixed_components], axis=0).any():
        problem = (
            f"{names[fixed_components[0]]} changes along the move; only {', '.join(mechanism.components)} may"
        )
        raise PkmodesError(problem, "poses", "keep the other components constant")
    return p


def _refined(time: Array, poses: Array, model: Model) -> tuple[Array, Array, NDArray[np.intp]]:
    """Divide long steps, along which the machine changes, and return where the given times are."""
    length = model.characteristic_length
    lengths = [length if component.unit == "rad" else 1.0 for component in model.mechanism.pose]
    distance = np.linalg.norm(np.diff(poses * lengths, axis=0), axis=1)
    pieces = np.maximum(1, np.ceil(distance / MAX_STEP)).astype(np.intp)
    indices = np.concatenate([[0], np.cumsum(pieces)])
    fine_indices = np.arange(indices[-1] + 1)
    if len(fine_indices) == len(time):
        return time, poses, indices
    fine_time = np.interp(fine_indices, indices, time)
    path = np.stack([np.interp(fine_indices, indices, component) for component in poses.T], axis=-1)
    return fine_time, path, indices


def _check_path(model: Model, time: Array, poses: Array) -> None:
    """Refuse a path that leaves the workspace.

    Raises PoseError with the time at which it does, the pose and the reason.
    """
    codes = model.checked(poses, "nan").codes
    outside = np.flatnonzero(codes)
    if not len(outside):
        return
    k = int(outside[0])
    try:
        model.checked(poses[k], "raise")
    except PoseError as error:
        pose_text = format_pose(model.robot.mechanism, poses[k], ".6g")
        problem = f"the path leaves the workspace at {time[k]:.6g} s, {pose_text}: {error.what}"
        raise PoseError(problem, "poses", error.remedy) from None
