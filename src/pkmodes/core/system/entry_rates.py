"""Derivatives of the entries of M and K that the generated model lists for each parameter.

The model may evaluate them itself; otherwise they are computed by complex step of its matrices, which is exact to
rounding.
"""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.mechanism.stepped import COMPLEX_STEP, with_complex_steps

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Maximum number of poses times parameters that are differentiated in one block.
MAX_BLOCK_SIZE = 4096


class Entries(NamedTuple):
    """The matrix entries to which the derivatives belong, in the order of the derivatives; the matrix is symmetric.

    - slot, row, column: index of the parameter, and position in the upper triangle, (E,)
    """

    slot: Index
    row: Index
    column: Index


def entries_of(parameters: Sequence[Any], matrix: int) -> Entries:
    """Return the entries of M (0) or K (1) to which the derivatives of listed parameters belong."""
    entries = [(i, *position) for i, parameter in enumerate(parameters) for position in parameter[2 + matrix]]
    return Entries(*np.array(entries, dtype=np.intp).reshape(-1, 3).T)


def value_rates(
    mechanism: Mechanism, parameters: Any, effects: Any, p: Array, fields: Collection[str] | None = None
) -> tuple[Array, Array]:
    """Evaluate the derivatives with respect to numbers that move no coordinate, at N poses, (N, d).

    - parameters, effects: of the robot; numbers may have a leading axis for the poses
    - fields: the requested fields; derivatives with respect to others may be 0

    Returns of_M and of_K, (N, entries), as ``VALUE_SENSITIVITIES`` lists them.
    """
    generated = Generated(mechanism.extended, parameters, effects)
    if generated.has("value_sensitivities"):
        of_M, of_K = generated.value_sensitivities(p)
        return of_M, of_K
    listed_parameters = mechanism.extended.VALUE_SENSITIVITIES
    requested = [i for i, entry in enumerate(listed_parameters) if fields is None or entry[0] in fields]
    return rates_by_steps(mechanism, parameters, effects, p, listed_parameters, requested)


def spring_rates(
    mechanism: Mechanism, parameters: Any, effects: Any, p: Array, springs: Collection[str]
) -> dict[str, Array]:
    """Evaluate K per unit of each spring to ground at N poses, in all coordinates, (N, e, e) by generated field.

    The energy of an effect that ties the robot to ground is proportional to its parameters, so these are parts of K
    without a difference.
    """
    _, rates = value_rates(mechanism, parameters, effects, p, springs)
    size = len(mechanism.extended.COORDINATES)
    stiffnesses, start = {}, 0
    for field, _, _, entries in mechanism.extended.VALUE_SENSITIVITIES:
        if field in springs:
            part = np.zeros((len(p), size, size))
            for k, (i, j) in enumerate(entries, start):
                part[:, i, j] = part[:, j, i] = rates[:, k]
            stiffnesses[field] = part
        start += len(entries)
    return stiffnesses


def rates_by_steps(
    mechanism: Mechanism,
    parameters: Any,
    effects: Any,
    p: Array,
    listed_parameters: Sequence[Any],
    requested: Sequence[int] | Index,
) -> tuple[Array, Array]:
    """Evaluate derivatives by complex step at N poses, (N, d), block by block of parameters.

    - listed_parameters: the parameters with derivatives: field, index, entries of M and of K
    - requested: indices of the requested parameters; derivatives with respect to others are 0

    Returns of_M and of_K, (N, entries).
    """
    entries = [entries_of(listed_parameters, matrix) for matrix in (0, 1)]
    values = tuple(np.zeros((len(p), len(matrix_entries.slot))) for matrix_entries in entries)
    size = max(1, MAX_BLOCK_SIZE // max(1, len(p)))
    for block in (requested[i : i + size] for i in range(0, len(requested), size)):
        slots = [listed_parameters[slot][:2] for slot in block]
        generated = Generated(
            mechanism.extended, with_complex_steps(parameters, slots), with_complex_steps(effects, slots)
        )
        M, K_el, K_g = generated.extended_matrices(p)
        for matrix_entries, matrix, rates_of_matrix in zip(entries, (M, K_el + K_g), values, strict=True):
            rates = np.broadcast_to(np.imag(matrix) / COMPLEX_STEP, (len(block), len(p), *matrix.shape[-2:]))
            for k, slot in enumerate(block):
                selected = np.flatnonzero(matrix_entries.slot == slot)
                rates_of_matrix[:, selected] = rates[k][
                    :, matrix_entries.row[selected], matrix_entries.column[selected]
                ]
    return values[0], values[1]
