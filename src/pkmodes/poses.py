"""Poses at the boundary: shape, numbers, reach, limits and singularity, checked before anything is solved.

The margins come from the generated model; here they are only compared with zero and put into words.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.errors import PkmodesError, PoseError, shown
from pkmodes_generated import linear_delta as generated
from pkmodes_generated.linear_delta import Parameters

OnError = Literal["raise", "nan"]
#: Places of some poses among all of them.
Where = slice | NDArray[np.intp]

#: Beyond this Frobenius condition number of D_l, D_p has lost six digits, and rigid links are no model.
MAX_CONDITION = 1e6

#: Poses evaluated together: as many as keep the matrices and the temporaries in the cache.
CHUNK = 2048

#: Why a pose cannot be evaluated, in the order in which it is asked: a short code, and what it means.
REASONS: dict[str, str] = {
    "finite": "a coordinate is NaN or infinite",
    "reachable": "the pose is out of reach: a link is too short",
    "singular": "the pose is singular",
    "limits": "a carriage is beyond its limits: a belt span would not be positive",
}
#: What the numbers of `CheckedPoses.codes` stand for: 0 is a pose that can be evaluated.
CODES: tuple[str, ...] = ("", *REASONS)

SPANS = ("between its pulleys", "between its carriage and pulley 2", "between its carriage and pulley 1")


@dataclass(frozen=True)
class CheckedPoses:
    """Poses that passed the door.

    Attributes
    ----------
    points : ndarray, shape (N, 3)
        Platform centres [m].
    codes : ndarray of int8, shape (N,)
        Which of them can be evaluated, and why the others cannot: indices into `CODES`.
    batch : tuple of int
        Shape of the poses as the caller gave them, without the last axis.
    """

    points: NDArray[np.float64]
    codes: NDArray[np.int8]
    batch: tuple[int, ...]

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Which poses can be evaluated, (N,)."""
        return np.asarray(self.codes == 0)

    def parts(self, size: int, *, even: bool = False) -> Iterator[tuple[Where, NDArray[np.float64]]]:
        """Give the valid poses part by part: where they are among all, and the poses, (n, 3).

        One empty part when there are none: what is evaluated at it has the right shapes.

        Parameters
        ----------
        size : int
            The most poses in a part.
        even : bool
            Parts of even size, instead of full ones and a rest.
        """
        places = np.flatnonzero(self.valid) if self.codes.any() else None
        count = len(self.points) if places is None else len(places)
        number = max(-(-count // size), 1)
        least, more = divmod(count, number)  # as many parts as there are poses left over have one more
        for i in range(number):
            start, stop = (
                (i * least + min(i, more), (i + 1) * least + min(i + 1, more))
                if even
                else (i * size, min((i + 1) * size, count))
            )
            where: Where = slice(start, stop) if places is None else places[start:stop]
            yield where, self.points[where]


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
    if not (isinstance(on_error, str) and on_error in ("raise", "nan")):
        raise PoseError(
            f'expected on_error "raise" or "nan", found {shown(on_error)}',
            "on_error",
            "choose one of the two",
        )
    points, batch = as_points(poses, "poses", "give platform centres [x, y, z] in metres")
    codes = np.empty(len(points), dtype=np.int8)
    for start in range(0, len(points), CHUNK):
        part = slice(start, start + CHUNK)
        codes[part] = _codes(points[part], parameters, max_condition)
    if on_error == "raise" and codes.any():
        index = int(np.argmax(codes != 0))
        one = slice(index, index + 1)
        ((what, remedy),) = explained(points[one], codes[one], parameters)
        position = ", ".join(f"{c:.6g}" for c in points[index])
        bad = int(np.count_nonzero(codes))
        where = f"pose {index} at [{position}] m" + (f", the first of {bad} bad poses" if bad > 1 else "")
        if len(points) > 1:
            remedy += ', or ask for NaN in its place with on_error="nan"'
        raise PoseError(what, where, remedy, index)
    return CheckedPoses(points, codes, batch)


def largest_condition(given: float) -> float:
    """Check the largest condition number of D_l that counts as regular.

    Raises
    ------
    PkmodesError
        If it is not a positive number.
    """
    number = isinstance(given, int | float | np.integer | np.floating) and not isinstance(given, bool)
    if not (number and given > 0.0):
        raise PkmodesError(
            f"expected a positive number, found {shown(given)}",
            "max_condition",
            f"give the largest condition number of D_l to accept, such as {MAX_CONDITION:g}",
        )
    return given


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
    except Exception as error:  # what is not an array may raise anything on the way to become one
        raise PoseError(f"expected an array of numbers, found {error}", name, remedy) from None
    if array.ndim == 0 or array.shape[-1] != 3:
        raise PoseError(f"expected {name} of shape (3,) or (N, 3), found {array.shape}", name, remedy)
    if array.size == 0:
        raise PoseError(f"expected at least one pose, found an array of shape {array.shape}", name, remedy)
    return array.reshape(-1, 3), array.shape[:-1]


def _codes(points: NDArray[np.float64], parameters: Parameters, max_condition: float) -> NDArray[np.int8]:
    """The first of the `REASONS` that holds for each pose, as an index into `CODES`."""
    with np.errstate(all="ignore"):  # the margins say what is wrong; a NaN compares false and so fails
        finite = np.isfinite(points).all(axis=-1)
        reachable = (generated.reach_margin(points, parameters) >= 0.0).all(axis=-1)
        _, condition = generated.jacobian_condition(points, parameters)
        spans = (generated.belt_spans(points, parameters) > 0.0).all(axis=(-2, -1))
    failed = [~finite, ~reachable, ~(condition <= max_condition), ~spans]
    return np.select(failed, range(1, len(CODES)), 0).astype(np.int8)


def explained(
    points: NDArray[np.float64], codes: NDArray[np.int8], parameters: Parameters
) -> list[tuple[str, str]]:
    """What is wrong with poses that cannot be evaluated, and the remedy.

    Parameters
    ----------
    points : ndarray, shape (N, 3)
        Platform centres [m].
    codes : ndarray of int8, shape (N,)
        Why, from `check_poses`; none is 0.
    parameters : Parameters
        The robot.
    """
    with np.errstate(all="ignore"):
        reach = generated.reach_margin(points, parameters)
        _, condition = generated.jacobian_condition(points, parameters)
        spans = generated.belt_spans(points, parameters)
    return [
        _sentence(CODES[code], *margins)
        for code, *margins in zip(codes.tolist(), reach, condition, spans, strict=True)
    ]


def _sentence(
    code: str, reach: NDArray[np.float64], condition: float, spans: NDArray[np.float64]
) -> tuple[str, str]:
    if code == "finite":
        return "expected finite coordinates, found NaN or infinity", "give finite coordinates"
    if code == "reachable":
        j = int(np.argmin(reach))
        missing = f"{-reach[j]:.4g} m" if np.isfinite(reach[j]) else "far"
        return (
            f"the pose is out of reach: link {j + 1} is {missing} too short",
            "choose a pose closer to the rails",
        )
    if code == "singular":
        condition = np.inf if np.isnan(condition) else condition
        return (
            f"the pose is singular: the condition number of D_l is {condition:.3g}",
            "choose a pose farther from the singularity",
        )
    j, k = divmod(int(np.argmin(spans)), spans.shape[1])
    where = "of no length" if spans[j, k] == 0.0 else f"{-spans[j, k]:.4g} m too short"
    return (
        f"carriage {j + 1} is beyond its limits: the belt span {SPANS[k]} would be {where}",
        "choose a pose within the travel of the carriages, or check limits and carriage length",
    )
