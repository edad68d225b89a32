"""Validation of poses: shape, numbers, and the conditions of the mechanism, checked before anything is solved.

The margins come from the generated model and their sentences from the mechanism's description; this module only
compares them with their bounds and formats the messages.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import groupby
from typing import Any, Literal, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import POSITIVE_NUMBER, check_argument
from pkmodes.core.base.errors import PoseError, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.described import Mechanism
from pkmodes.core.mechanism.generated import Generated
from pkmodes_description import Margin

Array = NDArray[np.float64]
OnError = Literal["raise", "nan"]
#: Indices of some poses in the array of all poses.
PoseIndices = slice | NDArray[np.intp]

#: Beyond this condition number the platform Jacobian has lost six digits, and the rigid-link model is not valid.
MAX_CONDITION = 1e6

#: Number of poses evaluated together, chosen so that matrices and temporaries fit in the cache.
CHUNK = 2048

#: The condition checked before the mechanism's margins: its code and what violating it means.
FINITE_CONDITION = ("finite", "a coordinate is NaN or infinite")
UNIT_NAMES = {"m": "metres", "rad": "radians"}


class LikelyUnit(NamedTuple):
    """The unit probably meant by bare numbers of at least a size: factor to SI, name, plural."""

    size: float
    factor: float
    unit: str
    plural: str


#: Units probably meant by large bare numbers, by SI unit.
LIKELY_UNITS = {
    "m": LikelyUnit(10.0, 1e-3, "mm", "millimetres"),
    "rad": LikelyUnit(np.pi / 2, np.pi / 180, "deg", "degrees"),
}
#: Smallest bare length that was probably meant in another unit [m].
LARGE_LENGTH = LIKELY_UNITS["m"].size
#: Rows of D_l are linearly dependent if a singular value is at most the first fraction of the largest; a row is
#: one of them if its share in the vanishing combination exceeds the second.
DEPENDENT_FRACTION, MIN_SHARE = 1e-4, 1e-3


def reason_meanings(mechanism: Mechanism) -> dict[str, str]:
    """Return the reasons why a pose cannot be evaluated, in the order of the checks: code and meaning."""
    meanings = dict([FINITE_CONDITION])
    for margin in mechanism.margins:
        meanings.setdefault(margin.code, margin.meaning)
    return meanings


def codes_of(mechanism: Mechanism) -> tuple[str, ...]:
    """Return the reasons that `CheckedPoses.codes` index; 0 is a pose that can be evaluated."""
    return ("", FINITE_CONDITION[0], *(margin.code for margin in mechanism.margins))


class CheckedPoses(NamedTuple):
    """Validated poses.

    - points: poses, d components each, in SI units, (N, d)
    - codes: indices into `reason_meanings`, (N,): 0 for a pose that can be evaluated, otherwise the reason why not
    - batch: leading axes of the poses as the caller gave them
    - reasons: the reasons that the codes index
    - unsolved: which poses NumPy evaluated because the solver could not
    """

    points: NDArray[np.float64]
    codes: NDArray[np.int8]
    batch: tuple[int, ...]
    reasons: tuple[str, ...]
    unsolved: NDArray[np.intp] | None = None

    @property
    def valid(self) -> NDArray[np.bool_]:
        """Mask of the poses that can be evaluated, (N,)."""
        return np.asarray(self.codes == 0)

    def parts(self, size: int, *, even: bool = False) -> Iterator[tuple[PoseIndices, NDArray[np.float64]]]:
        """Yield the valid poses part by part: their positions among all poses, and the poses, (n, d).

        If there are none, one empty part is yielded, so that results still get the right shapes.

        - size: largest number of poses in a part
        - even: whether to make parts of equal size instead of full parts and a remainder
        """
        valid_indices = np.flatnonzero(self.valid) if self.codes.any() else None
        count = len(self.points) if valid_indices is None else len(valid_indices)
        part_count = max(-(-count // size), 1)
        part_size, remainder = divmod(count, part_count)  # the first `remainder` parts have one pose more
        for i in range(part_count):
            start, stop = (
                (i * part_size + min(i, remainder), (i + 1) * part_size + min(i + 1, remainder))
                if even
                else (i * size, min((i + 1) * size, count))
            )
            indices: PoseIndices = slice(start, stop) if valid_indices is None else valid_indices[start:stop]
            yield indices, self.points[indices]


def check_poses(
    poses: ArrayLike,
    mechanism: Mechanism,
    parameters: Any,
    on_error: OnError = "raise",
    max_condition: float = MAX_CONDITION,
) -> CheckedPoses:
    """Check poses of the platform.

    - poses: in SI units, with the mechanism's pose components, (d,) or (..., d)
    - parameters: the robot's parameters for the generated model
    - on_error: whether a pose that cannot be evaluated raises an error or is marked invalid
    - max_condition: largest condition number that counts as regular

    Raises PoseError if the array does not hold poses; with ``on_error="raise"`` also if a pose is not finite or
    violates a condition of the mechanism.
    """
    points, batch = check_pose_array(poses, mechanism, on_error)
    codes = pose_codes(points, mechanism, parameters, max_condition)
    if on_error == "raise":
        raise_first_pose_error(points, codes, mechanism, parameters)
    return CheckedPoses(points, codes, batch, codes_of(mechanism))


def pose_codes(
    points: Array, mechanism: Mechanism, parameters: Any, max_condition: float
) -> NDArray[np.int8]:
    """Return the first condition that each pose, (N, d), violates, as an index into `codes_of`, chunk by chunk."""
    codes, generated = np.empty(len(points), dtype=np.int8), Generated(mechanism.model, parameters)
    for start in range(0, len(points), CHUNK):
        part = points[start : start + CHUNK]
        violations = [~np.isfinite(part).all(axis=-1)]
        with np.errstate(all="ignore"):  # the margins report the error; a NaN compares false and so fails
            for margin in mechanism.margins:
                values = evaluate_margin(generated, margin, part).reshape(len(part), -1)
                violations.append(~_is_met(margin, values, max_condition).all(axis=-1))
        codes[start : start + CHUNK] = np.select(violations, range(1, len(violations) + 1), 0)
    return codes


def check_pose_array(
    poses: ArrayLike, mechanism: Mechanism, on_error: OnError
) -> tuple[Array, tuple[int, ...]]:
    """Check the pose arguments of a method; return the poses as (N, d) and their leading axes.

    Raises PoseError if the array is not one of poses, or `on_error` is unknown.
    """
    if not (isinstance(on_error, str) and on_error in ("raise", "nan")):
        raise PoseError(
            f'expected on_error "raise" or "nan", found {shown(on_error)}',
            "on_error",
            "choose one of the two",
        )

    def remedy() -> str:
        units = [UNIT_NAMES.get(unit, "SI units") for unit in dict.fromkeys(c.unit for c in mechanism.pose)]
        names = ", ".join(component.name for component in mechanism.pose)
        return f"give poses [{names}] in {' and '.join(dict.fromkeys(units))}: {mechanism.pose_is}"

    return as_points(poses, "poses", len(mechanism.pose), remedy)


def raise_first_pose_error(
    points: Array, codes: NDArray[np.int8], mechanism: Mechanism, parameters: Any
) -> None:
    """Raise the error of the first pose that cannot be evaluated, if there is one.

    - points: (N, d)
    - codes: indices into `codes_of`, (N,)
    - parameters: the robot

    Raises PoseError, that of the first bad pose.
    """
    if not codes.any():
        return
    index = int(np.argmax(codes != 0))
    first_bad = slice(index, index + 1)
    ((problem, remedy),) = explain_codes(points[first_bad], codes[first_bad], mechanism, parameters)
    bad_count = int(np.count_nonzero(codes))
    where = f"pose {index} at {format_pose(mechanism, points[index])}" + (
        f", the first of {bad_count} bad poses" if bad_count > 1 else ""
    )
    if len(points) > 1:
        remedy += ', or use on_error="nan" to get NaN instead'
    raise PoseError(problem, where, remedy, index)


def check_max_condition(limit: float) -> float:
    """Check the largest condition number that counts as regular.

    Raises PkmodesError if it is not a positive number.
    """
    remedy = f"give the largest condition number to accept, such as {MAX_CONDITION:g}"
    check_argument(limit, POSITIVE_NUMBER, "max_condition", remedy)
    return limit


def as_points(
    values: ArrayLike, name: str, size: int, remedy: Callable[[], str]
) -> tuple[NDArray[np.float64], tuple[int, ...]]:
    """Check an array of tuples of numbers; return it as (N, size), and its leading axes.

    Raises PoseError if it is not a non-empty array of real numbers of shape (size,) or (..., size); `name` and
    `remedy()` go into the message.
    """
    try:
        if type(values) is not np.ndarray and np.ma.is_masked(values):
            raise TypeError("masked values")
        array = np.asarray(values)
        if array.dtype.kind not in "iuf":
            raise TypeError(f"values of type {array.dtype}")
        array = array.astype(float)
    except Exception as error:  # conversion of an arbitrary object may raise anything
        raise PoseError(f"expected an array of numbers, found {error}", name, remedy()) from None
    if array.ndim == 0 or array.shape[-1] != size:
        problem = f"expected {name} of shape ({size},) or (N, {size}), found {array.shape}"
        raise PoseError(problem, name, remedy())
    if array.size == 0:
        raise PoseError(f"expected at least one pose, found an array of shape {array.shape}", name, remedy())
    return array.reshape(-1, size), array.shape[:-1]


def format_pose(mechanism: Mechanism, point: Sequence[float] | Array, digits: str = ".6g") -> str:
    """Format a pose for messages and tables: ``[0.6, 0, -0.245] m``, or ``[0, 0, 0.5] m, [0.02, 0, 0] rad``."""
    numbers = iter([format(float(value), digits) for value in point])
    units = groupby(component.unit for component in mechanism.pose)
    return ", ".join(f"[{', '.join(next(numbers) for _ in components)}] {unit}" for unit, components in units)


def evaluate_margin(generated: Generated, margin: Margin, points: Array) -> Array:
    """Evaluate one of a mechanism's margins at poses; of several results, select the margin's output."""
    results = getattr(generated, margin.function)(points)
    return np.asarray(results[margin.output] if isinstance(results, tuple) else results)


def _is_met(margin: Margin, values: Array, max_condition: float) -> NDArray[np.bool_]:
    if margin.rule == "at_most_limit":
        return np.asarray(values <= max_condition)
    return np.asarray(values > 0.0 if margin.rule == "above_zero" else values >= 0.0)


def explain_codes(
    points: NDArray[np.float64], codes: NDArray[np.int8], mechanism: Mechanism, parameters: Any
) -> list[tuple[str, str]]:
    """Return what is wrong with poses that cannot be evaluated, and the remedies.

    - points: poses, (N, d)
    - codes: their codes from `check_poses`, all nonzero, (N,)
    - parameters: the robot's parameters
    """
    with np.errstate(all="ignore"):
        generated = Generated(mechanism.model, parameters)
        values = [evaluate_margin(generated, margin, points) for margin in mechanism.margins]
    explanations = []
    for i, code in enumerate(codes.tolist()):
        if code == 1:
            explanations.append(
                ("expected finite coordinates, found NaN or infinity", "give finite coordinates")
            )
            continue
        margin = mechanism.margins[code - 2]
        problem, remedy = _problem_and_remedy(margin, values[code - 2][i])
        if margin.rule == "at_most_limit" and mechanism.rotations:
            problem += _dependent_rows(generated, points[i])
        explanations.append((problem, remedy))
    return explanations


def _dependent_rows(generated: Generated, point: Array) -> str:
    """Name the rows of D_l, one for each leg, that depend on each other at a singular pose."""
    if not generated.has("constraint_jacobians"):
        return ""
    with np.errstate(all="ignore"):
        D_l, _ = generated.constraint_jacobians(point)
        column_sizes = np.abs(D_l).max(axis=0)
        scaled_rows = D_l / np.where(column_sizes > 0.0, column_sizes, 1.0)
        scaled_rows /= np.linalg.norm(scaled_rows, axis=1, keepdims=True)
    if not np.isfinite(scaled_rows).all():
        return ""
    U, values, _ = np.linalg.svd(scaled_rows)
    null_space = U[:, values <= DEPENDENT_FRACTION * values[0]]
    rows = np.flatnonzero(np.linalg.norm(null_space, axis=1) > MIN_SHARE) + 1
    if len(rows) < 2:
        return ""
    row_list = f"{', '.join(map(str, rows[:-1]))} and {rows[-1]}"
    return f"; its rows {row_list}, one for each leg, depend on each other"


def _problem_and_remedy(margin: Margin, values: Array) -> tuple[str, str]:
    """Return what is wrong with a pose that violates a margin, and the remedy, from the margin's values (...)."""
    if margin.rule == "at_most_limit":
        value = float(values.max())  # NaN if any value is NaN
        return margin.sentence.format(value=plain(np.inf if np.isnan(value) else value, 3)), margin.remedy
    worst_index = np.unravel_index(int(np.argmin(values)), values.shape)
    shortfall = -float(values[worst_index])
    shortfall_text = f"{shortfall:.4g} {margin.unit}".removesuffix(" 1")
    problem = margin.sentence.format(
        *(names[i] for names, i in zip(margin.names, worst_index, strict=True)),
        missing=shortfall_text if np.isfinite(shortfall) else "far",
        short="of no length" if shortfall == 0.0 else f"{shortfall_text} too short",
    )
    return problem, margin.remedy
