r"""Standard deviations of frequencies from those of the declared values.

The law of propagation of uncertainty, with exact derivatives g and the covariance of the values:

.. math:: \sigma_f^2 = g^T C \, g

Values are independent unless a table ``[[covariance]]`` of the robot file correlates them
(`pkmodes.core.robot.covariance`).  It is exact to first order: good where the standard deviations are small compared
with the values.

References
----------
JCGM 100:2008, Evaluation of measurement data: Guide to the expression of uncertainty in measurement, 5.1.2.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.robot.layout import Slot, table_sources
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.covariance import covariance_of, covariance_root, sigmas_by_path
from pkmodes.loop.sensitivity.modes import group_modes
from pkmodes.loop.sensitivity.paths import ParameterPath, paths
from pkmodes.loop.sensitivity.relative import REPEATED_FRACTION, rates_of
from pkmodes.loop.sensitivity.sensitivities import ResolvedPaths

Array = NDArray[np.float64]


def stated_sigmas(robot: Robot) -> dict[str, float]:
    """Return the standard deviations of a robot file by path [SI], of those values that can change a frequency."""
    stated = sigmas_by_path(robot)
    varying = set(paths(robot)) if stated else set()  # damping ratios and loss factors change none
    return {path: sigma for path, sigma in stated.items() if path in varying}


def spread_of(
    model: Model, poses: ArrayLike, drives: str, on_error: str = "raise", exact: Collection[str] = ()
) -> Array | None:
    """Return the standard deviations of all frequencies, (..., m) [Hz]; None where the robot file states none.

    See `pkmodes.Model.frequency_sigmas`.

    - exact: paths of values that are exact although the file states a sigma, such as those that a sweep sets
    """
    lending_paths = {
        table_path for path, table_path in table_sources(model.robot.mechanism).items() if path in exact
    }
    names = [path for path in stated_sigmas(model.robot) if path not in exact and path not in lending_paths]
    if not names:
        return None
    directions, root = _independent_directions(model, names, drives)
    rates = rates_of(model, poses, directions, drives, on_error)
    spread = np.asarray(np.linalg.norm(np.swapaxes(root, -1, -2) @ rates, axis=-2))
    frequencies = model.frequencies(poses, "nan", drives=drives)
    return _average_repeated(spread, frequencies)


def _independent_directions(
    model: Model, names: list[str], drives: str
) -> tuple[Sequence[str | ParameterPath], Array]:
    """Return directions in the space of the values with independent errors, and a root of the covariance along them.

    Correlated values err along lines of their own, one for each column of a root L of their covariance C = L L^T, by
    independent numbers of variance 1: so a group of repeated modes splits as with independent values.
    """
    robot = model.robot
    root = covariance_root(covariance_of(robot, names))
    if not robot.covariance:
        return names, root
    resolved = ResolvedPaths(robot, names, drives)
    if resolved.locked.paths:
        # Derivatives of a group allow no line that both releases a locked joint and changes other values.
        return names, root
    lines: list[ParameterPath] = []
    for column in root.T:
        weights: dict[Slot, float] = {}
        for path, size in zip(resolved.paths, column.tolist(), strict=True):
            for slot, weight in path.weights.items() if size else ():
                weights[slot] = weights.get(slot, 0.0) + size * weight
        lines.append(ParameterPath("", 0.0, "1", weights))
    return lines, np.eye(len(lines))


def frequency_sigmas(
    model: Model, poses: ArrayLike, on_error: OnError = "raise", *, drives: str | None = None
) -> Array:
    """Compute the standard deviations of the frequencies from those that the robot file states.

    The law of propagation of uncertainty with exact derivatives, good to first order.  Values are independent
    unless a ``[[covariance]]`` of the robot file correlates them.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        In SI units.
    on_error : {"raise", "nan"}
        As for `modes`.
    drives : {"free", "held"}, optional
        As for `modes`.

    Returns
    -------
    ndarray, shape (..., m)
        In Hz, in the order of `frequencies`; NaN where a frequency is 0 to rounding.  Each of several repeated
        modes has the root mean square over their group.

    Raises
    ------
    PkmodesError
        If the robot file states no standard deviation of a value that changes a frequency.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml")
    >>> model = model.with_values({"belt.width": {"value": "15 mm", "sigma": "2 %"}})
    >>> model.frequency_sigmas([0.6, 0.0, -0.245])[3:].round(2)
    array([0.56, 0.6 , 0.62, 1.31, 1.34, 1.34])
    """
    spread = spread_of(model, poses, model.robot.resolve_drives(drives), on_error)
    if spread is None:
        problem = "no value of the robot that changes a frequency has a standard deviation"
        remedy = 'declare some, such as mass = { value = "1.5 kg", sigma = "1 %" }'
        raise PkmodesError(problem, model.robot.source, remedy)
    return spread


def _average_repeated(spread: Array, frequencies: Array) -> Array:
    """Give repeated modes one standard deviation: the root mean square over their group.

    A group changes as the eigenvalues of sum_i dp_i A_i.  Their mean square is trace(A^2) over the size of the group,
    of which the expected value is the sum of sigma_i^2 trace(A_i^2) for independent p_i; that of one branch alone has
    no such law.
    """
    flat, f = spread.reshape(-1, spread.shape[-1]), frequencies.reshape(-1, frequencies.shape[-1])
    eigenvalues = np.nan_to_num(f) * np.abs(np.nan_to_num(f))
    size = np.broadcast_to(np.abs(eigenvalues).max(axis=-1, initial=0.0)[:, None], eigenvalues.shape)
    group = group_modes(eigenvalues, REPEATED_FRACTION, size)
    for i in np.flatnonzero(group[:, -1] < group.shape[1] - 1).tolist():
        for number in np.unique(group[i]):
            members = np.flatnonzero(group[i] == number)
            if len(members) > 1:
                flat[i, members] = np.sqrt(np.mean(flat[i, members] ** 2))
    return flat.reshape(spread.shape)
