"""Frequency response functions as an analyser makes them: H1 over averages, with the ordinary coherence.

References
----------
Bendat, J. S. and Piersol, A. G. (2010). Random Data: Analysis and Measurement Procedures, 4th ed. Wiley, section 6.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True, eq=False)
class Functions:
    """Functions of one file.

    Attributes
    ----------
    frequencies : ndarray, shape (F,)
        [Hz].
    values : ndarray of complex128, shape (F, S, R)
        Accelerations per force [m/s^2/N, rad/s^2/N].
    coherence : ndarray, shape (F, S, R)
    """

    frequencies: np.ndarray
    values: np.ndarray
    coherence: np.ndarray


def averaged(step: float, force: np.ndarray, motion: np.ndarray, block: int, highest: float) -> Functions:
    """Return the functions of one force from blocks of a record, without window: each block is a period.

    Parameters
    ----------
    step : float
        [s].
    force : ndarray, shape (N,)
    motion : ndarray, shape (N, S)
    block : int
        Samples of a block.  Before each one that is used, an equal block lets the transient die out.
    highest : float
        Last line [Hz].
    """
    lines = np.fft.rfftfreq(block, step)
    kept = (lines > 0.0) & (lines <= highest)
    starts = range(block, len(force) - block + 1, 2 * block)
    F = np.array([np.fft.rfft(force[k : k + block])[kept] for k in starts])
    A = np.array([np.fft.rfft(motion[k : k + block], axis=0)[kept] for k in starts])
    power, response = np.sum(np.abs(F) ** 2, axis=0), np.sum(np.abs(A) ** 2, axis=0)
    crossed = np.sum(A * F.conj()[:, :, None], axis=0)
    H = crossed / power[:, None]
    coherence = np.abs(crossed) ** 2 / np.where(response, response * power[:, None], 1.0)
    return Functions(lines[kept], H[:, :, None], np.minimum(coherence, 1.0)[:, :, None])


def together(parts: list[Functions]) -> Functions:
    """Return functions that were measured one force after the other."""
    return Functions(
        parts[0].frequencies,
        np.concatenate([one.values for one in parts], axis=2),
        np.concatenate([one.coherence for one in parts], axis=2),
    )
