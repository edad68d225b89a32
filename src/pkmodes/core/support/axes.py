"""Values along an axis: of a grid of poses, of a swept parameter."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.arguments import Constraint, check_argument, is_number
from pkmodes.core.base.errors import PkmodesError, checked_list, shown

Array = NDArray[np.float64]
VALUES_BY_PATH = Constraint("values by path", lambda value: isinstance(value, Mapping))
SWEEP_EXAMPLE = 'for example: {"platform.mass": [1.0, 1.5, 2.0]}'


def check_axis_values(
    values: Any,
    name: str,
    where: str,
    example: str,
    error: type[PkmodesError] = PkmodesError,
    *,
    strictly: bool = True,
) -> Array:
    """Check the values along an axis; one number is an axis of one value.

    - name: of the axis, for messages
    - where: of the argument, for messages
    - example: a remedy
    - error: the error to raise
    - strictly: whether they have to ascend; otherwise they only have to differ

    Returns (N,).
    Raises PkmodesError.
    """
    if isinstance(values, np.ndarray) and values.ndim == 0:
        values = values.item()
    elements = checked_list(
        [values] if isinstance(values, int | float | np.number) else values, f"values of {name}", where, "0.1"
    )
    if not all(map(is_number, elements)):
        raise error(f"expected numbers in SI units, found {shown(elements[0])}", where, example)
    axis = np.array(elements, dtype=float)
    if not len(axis):
        raise error("expected at least one value, found none", where, "give one number or several")
    if not np.isfinite(axis).all():
        raise error("expected finite values, found NaN or infinity", where, "give finite numbers")
    if strictly and (np.diff(axis) < 0).any():
        raise error(
            "expected ascending values, found descending ones", where, "sort them, the smallest first"
        )
    distinct, counts = np.unique(axis, return_counts=True)
    if (counts > 1).any():
        raise error(f"the value {distinct[counts > 1][0]:g} is repeated", where, "give each value once")
    return axis


def swept_values(sweep: Any, where: str) -> dict[str, Array]:
    """Check the values of swept parameters, which only have to differ.

    - sweep: values in SI units by path; one number is a single value
    - where: of the argument, for messages

    Returns them in the order given.
    Raises PkmodesError if it is not such a mapping.  `pkmodes.Robot.with_values` checks that the parameters exist.
    """
    check_argument(sweep, VALUES_BY_PATH, where, SWEEP_EXAMPLE)
    return {
        path: check_axis_values(values, str(path), f"{where}: {path}", SWEEP_EXAMPLE, strictly=False)
        for path, values in sweep.items()
    }
