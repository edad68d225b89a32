"""The same modes in two states: rows of a later state, with their modes of the model and rows of the trusted state.

Two states of a machine are more alike than a machine and its model.  If a mode was measured in the trusted state at
the same setup, that measurement is what is expected; otherwise it is the prediction of the model, with the error that
the trusted state shows.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.support.mac import mac_of_each
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import FREQUENCY
from pkmodes.loop.measured.same_modes import close_groups, pair_same_modes

Index = NDArray[np.intp]


class ExpectedModes(NamedTuple):
    """The modes of one setup as they were before, of the model or measured.

    - log_frequencies, sigma: logarithms of the frequencies, and their standard deviations, (m,)
    - shapes: at the channels of the later state, (m, C), NaN where not known
    - model_mode, trusted_row: mode of the model, and row of the trusted state, (m,); -1 where there is none
    """

    log_frequencies: Array
    sigma: Array
    shapes: Array
    model_mode: Index
    trusted_row: Index


def expected_modes(
    log: Array,
    sigma: float,
    shapes: Array,
    trusted: Measurements,
    channels: tuple[str, ...],
    partner: Index,
    setup: int,
) -> ExpectedModes:
    """Return the modes of a setup: as measured in the trusted state, those of the model where they were not.

    - log, shapes: logarithms of the frequencies of the modes of the model, with its error, (m,) and (m, C); shapes at
      some channels
    - sigma: standard deviation of the logarithms
    - channels: names of these channels
    - partner: mode of the model of each row of the trusted state, (R,); -1 for none
    - setup: index of the setup in the trusted state; -1 if it has none like this
    """
    count = len(log)
    rows = np.flatnonzero(trusted.pose == setup)
    unpaired_rows = rows[partner[rows] < 0]
    log_frequencies = np.concatenate([log, FREQUENCY.transformed(trusted)[unpaired_rows]])
    sigmas, row = (
        np.full(len(log_frequencies), sigma),
        np.concatenate([np.full(count, -1), unpaired_rows]).astype(np.intp),
    )
    all_shapes = np.vstack([shapes, np.full((len(unpaired_rows), len(channels)), np.nan)])
    mode = np.concatenate([np.arange(count), np.full(len(unpaired_rows), -1)]).astype(np.intp)
    for trusted_row in rows:
        is_paired = partner[trusted_row] >= 0
        index = int(partner[trusted_row])
        if not is_paired:
            index = count + int(np.flatnonzero(unpaired_rows == trusted_row)[0])
        log_frequencies[index], row[index] = FREQUENCY.transformed(trusted)[trusted_row], trusted_row
        sigmas[index] = FREQUENCY.transformed_sigma(trusted)[trusted_row]
        measured = dict(zip(trusted.channels, trusted.shapes[trusted_row], strict=True))
        measured_shape = np.array([measured.get(name, np.nan) for name in channels])
        if np.isfinite(measured_shape).sum() >= 2 or not is_paired:
            all_shapes[index] = measured_shape
    return ExpectedModes(log_frequencies, sigmas, all_shapes, mode, row)


def pair_with_expected(
    expected: ExpectedModes, later: Measurements, rows: Index, weights: Array
) -> list[tuple[int, int]]:
    """Return rows of one setup of a later state, each with its place among the modes that are expected there.

    - weights: factors by which the channels are comparable, (C,)
    """
    log_difference = np.abs(FREQUENCY.transformed(later)[rows][None, :] - expected.log_frequencies[:, None])
    macs = mac_of_each(expected.shapes * weights, later.shapes[rows] * weights)
    groups = close_groups(expected.log_frequencies, expected.sigma)
    return [(int(rows[k]), i) for i, k, _ in pair_same_modes(log_difference, macs, groups)]


def common_channels(trusted: Measurements, later: Measurements) -> tuple[list[int], list[int]]:
    """Return the channels that both have, as places in each."""
    names = [name for name in trusted.channels if name in later.channels]
    return [trusted.channels.index(name) for name in names], [later.channels.index(name) for name in names]
