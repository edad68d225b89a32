r"""Standard deviations of frequencies from those of the declared values.

The law of propagation of uncertainty, with exact derivatives g and independent values:

.. math:: \sigma_f^2 = g^T \Sigma \, g = \sum_i (\partial f / \partial p_i)^2 \sigma_i^2

It is exact to first order: good where the standard deviations are small against the values.

References
----------
JCGM 100:2008, Evaluation of measurement data: Guide to the expression of uncertainty in measurement, 5.1.2.
"""

from __future__ import annotations

from collections.abc import Collection

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.base.errors import PkmodesError
from pkmodes.robot.paths import paths
from pkmodes.robot.robot import Robot
from pkmodes.sensitivity.modes import groups
from pkmodes.sensitivity.relative import CLOSE, rates_of
from pkmodes.solve.dynamics import Dynamics

Array = NDArray[np.float64]


def stated_sigmas(robot: Robot) -> dict[str, float]:
    """Return the standard deviations of a robot file by path [SI], of those values that can change a frequency."""
    stated = {path: q.sigma for path, q in robot.quantities.items() if q.sigma}
    known = set(paths(robot)) if stated else set()  # damping ratios and loss factors change none
    return {path: sigma for path, sigma in stated.items() if path in known}


def spread_of(
    dynamics: Dynamics,
    poses: ArrayLike,
    drives: str,
    on_error: str = "raise",
    known: Collection[str] = (),
) -> Array | None:
    """Return the standard deviations of all frequencies, (..., m) [Hz]; None where the robot file states none.

    See `pkmodes.Model.frequency_sigmas`.

    Parameters
    ----------
    known : collection of str
        Paths of values that are known exactly all the same, such as those that a sweep sets.
    """
    sigmas = {path: sigma for path, sigma in stated_sigmas(dynamics.robot).items() if path not in known}
    if not sigmas:
        return None
    rates = rates_of(dynamics, poses, list(sigmas), drives, on_error)
    spread = np.asarray(np.linalg.norm(rates * np.array(list(sigmas.values()))[:, None], axis=-2))
    frequencies = dynamics.frequencies(poses, "nan", drives=drives)
    return _shared(spread, frequencies)


def needed_spread_of(dynamics: Dynamics, poses: ArrayLike, drives: str, on_error: str) -> Array:
    """Return the same, or refuse a robot that states no standard deviation."""
    spread = spread_of(dynamics, poses, drives, on_error)
    if spread is None:
        what = "no value of the robot that changes a frequency has a standard deviation"
        remedy = 'declare some, such as mass = { value = "1.5 kg", sigma = "1 %" }'
        raise PkmodesError(what, dynamics.robot.source, remedy)
    return spread


def _shared(spread: Array, frequencies: Array) -> Array:
    """Give repeated modes one standard deviation: the root mean square over their group.

    A group changes as the eigenvalues of sum_i dp_i A_i.  Their mean square is trace(A^2) over the size of the group,
    of which the expected value is the sum of sigma_i^2 trace(A_i^2); that of one branch alone has no such law.
    """
    flat, f = spread.reshape(-1, spread.shape[-1]), frequencies.reshape(-1, frequencies.shape[-1])
    eigenvalues = np.nan_to_num(f) * np.abs(np.nan_to_num(f))
    size = np.broadcast_to(np.abs(eigenvalues).max(axis=-1, initial=0.0)[:, None], eigenvalues.shape)
    group = groups(eigenvalues, CLOSE, size)
    for i in np.flatnonzero(group[:, -1] < group.shape[1] - 1).tolist():
        for number in np.unique(group[i]):
            members = np.flatnonzero(group[i] == number)
            if len(members) > 1:
                flat[i, members] = np.sqrt(np.mean(flat[i, members] ** 2))
    return flat.reshape(spread.shape)
