"""Poles of a robot at poses, and where the ratio of light damping is not that of the pole."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.drives import FREE, checked_drives
from pkmodes.core.linalg.damping import poles, ratios_of_poles
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.response.linearised import LinearisedRobot, nan_in_both_parts

#: A ratio that differs from that of its pole by more than this fraction is named.
DIFFERENT = 0.1


def poles_at(
    model: Model,
    poses: ArrayLike,
    on_error: OnError = "raise",
    *,
    drives: str = FREE,
    backend: str = AUTO,
) -> NDArray[np.complex128]:
    """Compute the poles of small vibrations, whatever the damping (docs/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        In SI units.
    on_error : {"raise", "nan"}
        As for `modes`.
    drives : {"free", "held"}
        As for `modes`.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`: what solves the undamped eigenproblem.

    Returns
    -------
    ndarray of complex128, shape (..., 2 m)
        In 1/s, by ascending magnitude; of a pair, the one with positive imaginary part first.  They are exact for
        viscous friction and damping ratios; a loss factor is the viscous damping that it is at the frequency of
        each mode.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
    >>> model.poles([0.6, 0.0, -0.245], drives="held")[:2].round(2)
    array([-4.05+202.7j, -4.05-202.7j])
    """
    checked_drives(drives)

    def at(points: NDArray[np.float64]) -> NDArray[np.complex128]:
        return poles(LinearisedRobot(model, points, drives, backend).damping)

    (values,) = model.evaluated(at, model.checked(poses, on_error))
    return nan_in_both_parts(np.asarray(values, dtype=complex))


def notes_on_damping(linearised: LinearisedRobot, ratios: NDArray[np.float64]) -> list[str]:
    """Return sentences on the modes at a pose whose ratio of light damping is not that of their pole.

    Parameters
    ----------
    linearised : LinearisedRobot
        At the one pose.
    ratios : ndarray, shape (m,)
        Of `pkmodes.Modes.damping_ratios`.
    """
    if not np.nan_to_num(ratios).any():
        return []
    exact = ratios_of_poles(linearised.damping)[0]
    notes = []
    for i in range(linearised.rigid, len(ratios)):
        if abs(ratios[i] - exact[i]) > DIFFERENT * exact[i]:
            notes.append(
                f"mode {i + 1 - linearised.rigid}: the damping ratio {ratios[i]:.3g} is that of light damping, but "
                f"that of the pole is {exact[i]:.3g}: use the poles"
            )
    return notes
