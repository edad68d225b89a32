"""Notes on held-out measurements: rows without a mode, and errors that grow with a claim."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.verdict.rows import Error
from pkmodes.measured.measurements import Measurements


def remarks(
    data: Measurements,
    held: NDArray[np.bool_],
    predicted: Array,
    before: Error,
    after: Error | None,
    worse: float,
) -> Iterator[str]:
    """Yield sentences about the held-out rows.

    Parameters
    ----------
    held : ndarray of bool, shape (R,)
        Rows of held-out poses.
    predicted : ndarray, shape (R,)
        Frequencies of the last stage [Hz], NaN where the model has no mode.
    before, after : Error
        Errors after refitting the nuisance parameters, and with the claimed causes.
    worse : float
        Factor by which the held-out error must grow to contradict the claim.
    """
    for i in np.flatnonzero(held & np.isnan(predicted)):
        yield f"{_row(data, int(i))} is unmatched: the held-out error does not include it"
    if after is None or before.held_out_rms_relative is None or after.held_out_rms_relative is None:
        return
    if after.held_out_rms_relative > worse * before.held_out_rms_relative:
        apart = np.where(held, np.nan_to_num(np.abs(np.log(predicted / data.frequency))), 0.0)
        yield (
            "the held-out poses contradict the claim: their error grows from "
            f"{100 * before.held_out_rms_relative:.2g} to {100 * after.held_out_rms_relative:.2g} %; "
            f"the worst is {_row(data, int(apart.argmax()))}"
        )


def _row(data: Measurements, i: int) -> str:
    return f"line {data.lines[i]} (held-out {data.labels[data.pose[i]]}, {data.frequency[i]:g} Hz)"
