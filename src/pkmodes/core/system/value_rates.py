"""Derivatives of M and K with respect to numbers that move no coordinate, as ``VALUE_SENSITIVITIES`` lists them."""

from __future__ import annotations

from collections.abc import Collection
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.stepped import STEP, stepped

Array = NDArray[np.float64]


def value_rates(
    mechanism: Mechanism, parameters: Any, effects: Any, p: Array, fields: Collection[str] | None = None
) -> tuple[Array, Array]:
    """Evaluate the derivatives of the listed entries of M and K at N poses, (N, d).

    They are those that the generated model has, or by complex step of its matrices, which is exact to rounding.

    Parameters
    ----------
    parameters, effects : Parameters and Effects
        Of the robot; numbers may have a leading axis for the poses.
    fields : collection of str, optional
        The fields that are wanted; derivatives with respect to others may be 0.

    Returns
    -------
    of_M, of_K : ndarray, shape (N, entries)
    """
    extended = mechanism.extended
    generated = Generated(extended, parameters, effects)
    if generated.has("value_sensitivities"):
        of_M, of_K = generated.value_sensitivities(p)
        return of_M, of_K
    listed = [one for one in extended.VALUE_SENSITIVITIES if fields is None or one[0] in fields]
    names = [(field, index) for field, index, *_ in listed]
    moved = Generated(extended, stepped(parameters, names), stepped(effects, names))
    M, K_el, K_g = moved.extended_matrices(p)
    found = []
    for matrix, sum_of in ((2, M), (3, K_el + K_g)):
        rates = np.broadcast_to(np.imag(sum_of) / STEP, (len(names), len(p), *sum_of.shape[-2:]))
        columns = []
        for one in extended.VALUE_SENSITIVITIES:
            rows, places = (
                (rates[names.index(one[:2])], one[matrix]) if one[:2] in names else (None, one[matrix])
            )
            for place in places:
                columns.append(np.zeros(len(p)) if rows is None else rows[:, place[0], place[1]])
        found.append(np.stack(columns, axis=-1))
    return found[0], found[1]
