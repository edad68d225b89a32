"""Poses at the boundary: shape, numbers, reach, limits and singularity, checked before anything is solved.

The margins come from the generated model; here they are only compared with zero and put into words.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.errors import PoseError
from pkmodes_generated import linear_delta as generated
from pkmodes_generated.linear_delta import Parameters

OnError = Literal["raise", "nan"]

#: Beyond this Frobenius condition number of D_l, D_p has lost six digits, and rigid links are no model.
MAX_CONDITION = 1e6

#: Poses evaluated together: as many as keep the matrices and the temporaries in the cache.
CHUNK = 2048

SPANS = ("between its pulleys", "between its carriage and pulley 2", "between its carriage and pulley 1")


@dataclass(frozen=True)
class CheckedPoses:
    """Poses that passed the door.

    Attributes
    ----------
    points : ndarray, shape (N, 3)
        Platform centres [m].
    valid : ndarray of bool, shape (N,)
        Which of them can be evaluated.
    batch : tuple of int
        Shape of the poses as the caller gave them, without the last axis.
    """

    points: NDArray[np.float64]
    valid: NDArray[np.bool_]
    batch: tuple[int, ...]

    def scatter(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Put the results of the valid poses in the caller's shape, NaN for the others."""
        out = np.full((len(self.points), *values.shape[1:]), np.nan)
        out[self.valid] = values
        return out.reshape(self.batch + values.shape[1:])


def check_poses(
    poses: ArrayLike,
    parameters: Parameters,
    on_error: OnError = "raise",
    max_condition: float = MAX_CONDITION,
) -> CheckedPoses:
    """Check poses of the platform.

    Parameters
    ----------
    poses : array_like, shape (3,) or (..., 3)
        Platform centres in the base frame [m].
    parameters : Parameters
        The robot.
    on_error : {"raise", "nan"}
        Whether a pose that cannot be evaluated is an error or is marked invalid.
    max_condition : float
        Largest condition number of D_l that counts as regular.

    Raises
    ------
    PoseError
        If the array is not one of poses; with ``on_error="raise"`` also if a pose is not finite, out of
        reach, singular, or has a carriage beyond its limits.
    """
    if on_error not in ("raise", "nan"):
        raise PoseError(
            f'expected on_error "raise" or "nan", found {on_error!r}', "on_error", "choose one of the two"
        )
    points, batch = as_points(poses, "poses", "give platform centres [x, y, z] in metres")
    valid = np.empty(len(points), dtype=bool)
    for start in range(0, len(points), CHUNK):
        part = slice(start, start + CHUNK)
        valid[part] = _examined(points[part], parameters, max_condition)[-1]
    if on_error == "raise" and not valid.all():
        index = int(np.argmin(valid))
        what, remedy = _reason(points[index], parameters, max_condition)
        position = ", ".join(f"{c:.6g}" for c in points[index])
        bad = int((~valid).sum())
        where = f"pose {index} at [{position}] m" + (f", the first of {bad} bad poses" if bad > 1 else "")
        if len(points) > 1:
            remedy += ', or ask for NaN in its place with on_error="nan"'
        raise PoseError(what, where, remedy, index)
    return CheckedPoses(points, valid, batch)


def as_points(given: ArrayLike, name: str, remedy: str) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """Check an array of triples; return it as (N, 3), and its shape without the last axis.

    Raises
    ------
    PoseError
        If it is not a non-empty array of real numbers of shape (3,) or (..., 3); `name` and `remedy` say so.
    """
    try:
        if np.ma.is_masked(given):
            raise TypeError("masked values")
        array = np.asarray(given)
        if array.dtype.kind not in "iuf":
            raise TypeError(f"values of type {array.dtype}")
        array = array.astype(float)
    except (TypeError, ValueError, OverflowError) as error:
        raise PoseError(f"expected an array of numbers, found {error}", name, remedy) from None
    if array.ndim == 0 or array.shape[-1] != 3:
        raise PoseError(f"expected {name} of shape (3,) or (N, 3), found {array.shape}", name, remedy)
    if array.size == 0:
        raise PoseError(f"expected at least one pose, found an array of shape {array.shape}", name, remedy)
    return array.reshape(-1, 3), array.shape[:-1]


def _examined(
    points: NDArray[np.float64], parameters: Parameters, max_condition: float
) -> tuple[NDArray[np.bool_], ...]:
    """Which poses are finite, reachable as well, regular as well, and within the limits as well."""
    with np.errstate(all="ignore"):  # the margins say what is wrong; a NaN compares false and so fails
        finite = np.isfinite(points).all(axis=-1)
        reachable = finite & (generated.reach_margin(points, parameters) >= 0.0).all(axis=-1)
        _, condition = generated.jacobian_condition(points, parameters)
        regular = reachable & (condition <= max_condition)
        valid = regular & (generated.belt_spans(points, parameters) > 0.0).all(axis=(-2, -1))
    return tuple(np.asarray(found) for found in (finite, reachable, regular, valid))


def _reason(point: NDArray[np.float64], parameters: Parameters, max_condition: float) -> tuple[str, str]:
    """What is wrong with a pose, and the remedy."""
    finite, reachable, regular, _ = (found[0] for found in _examined(point[None], parameters, max_condition))
    if not finite:
        return "expected finite coordinates, found NaN or infinity", "give finite coordinates"
    if not reachable:
        with np.errstate(all="ignore"):  # squares of absurd coordinates overflow
            reach = generated.reach_margin(point, parameters)
        j = int(np.argmin(reach))
        missing = f"{-reach[j]:.4g} m" if np.isfinite(reach[j]) else "far"
        return (
            f"the pose is out of reach: link {j + 1} is {missing} too short",
            "choose a pose closer to the rails",
        )
    if not regular:
        with np.errstate(all="ignore"):
            _, condition = generated.jacobian_condition(point, parameters)
        condition = np.inf if np.isnan(condition) else condition
        return (
            f"the pose is singular: the condition number of D_l is {condition:.3g}",
            "choose a pose farther from the singularity",
        )
    spans = generated.belt_spans(point, parameters)
    j, k = divmod(int(np.argmin(spans)), spans.shape[1])
    where = "of no length" if spans[j, k] == 0.0 else f"{-spans[j, k]:.4g} m too short"
    return (
        f"carriage {j + 1} is beyond its limits: the belt span {SPANS[k]} would be {where}",
        "choose a pose within the travel of the carriages, or check limits and carriage length",
    )
