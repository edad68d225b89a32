"""Derivatives of the entries of M and K by complex step, for a mechanism that has no generated ones."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.generated import Generated
from pkmodes.core.mechanism.stepped import STEP, stepped
from pkmodes.core.system.evaluation import ExtendedSystem

Array = NDArray[np.float64]
Index = NDArray[np.intp]
#: Poses times parameters that are differentiated at once.
AT_ONCE = 4096


class Entries(NamedTuple):
    """The entries of a symmetric matrix to which the generated derivatives belong, in their order.

    Attributes
    ----------
    slot, row, column : ndarray of int, shape (E,)
        Index of the parameter, and position in the upper triangle.
    """

    slot: Index
    row: Index
    column: Index


def rates_by_steps(
    system: ExtendedSystem, p: Array, listed: Sequence[Any], entries: Sequence[Entries], moved: Index
) -> tuple[Array, Array]:
    """Evaluate derivatives of the entries of M and K at N poses, (N, d): a block of parameters at once.

    Parameters
    ----------
    listed : sequence
        The parameters with derivatives: field, index, and more.
    entries : sequence of Entries
        Of M and of K.
    moved : ndarray of int
        Indices of the parameters that are wanted; derivatives with respect to others are 0.

    Returns
    -------
    of_M, of_K : ndarray, shape (N, entries)
    """
    values = tuple(np.zeros((len(p), len(some.slot))) for some in entries)
    size = max(1, AT_ONCE // max(1, len(p)))
    for block in (moved[i : i + size] for i in range(0, len(moved), size)):
        names = [listed[slot][:2] for slot in block]
        generated = Generated(
            system.mechanism.extended, stepped(system.parameters, names), stepped(system.effects, names)
        )
        M, K_el, K_g = generated.extended_matrices(p)
        for one, matrix, out in zip(entries, (M, K_el + K_g), values, strict=True):
            rates = np.broadcast_to(np.imag(matrix) / STEP, (len(block), len(p), *matrix.shape[-2:]))
            for k, slot in enumerate(block):
                some = np.flatnonzero(one.slot == slot)
                out[:, some] = rates[k][:, one.row[some], one.column[some]]
    return values[0], values[1]
