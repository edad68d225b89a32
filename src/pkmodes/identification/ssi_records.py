"""Records of responses prepared for subspace identification, and the spectra that are drawn of them."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.identification.estimates import Mode
from pkmodes.identification.ssi_bands import Lines, lines

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Periods of the lower end of the band that a piece of a record has at least.
FEWEST_PERIODS = 8.0
#: Lines averaged for what is drawn.
DRAWN = 400


@dataclass(frozen=True, eq=False)
class PreparedRecord:
    """A record prepared for identification: its sensors relative to their rms, its lines padded and not."""

    padded: list[Lines]
    plain: list[Lines]
    scales: Array
    seconds: float


def usable_pieces(t_step: float, pieces: list[Array], band: tuple[float, float]) -> list[Array]:
    """Return the pieces (N, S) of a record that are long enough for a band.

    Raises
    ------
    MeasurementError
        If the band is not below the Nyquist frequency, or no piece is long enough.
    """
    if band[1] >= 0.5 / t_step:
        raise MeasurementError(
            f"the band ends at {band[1]:g} Hz, the Nyquist frequency is {0.5 / t_step:g} Hz",
            "band",
            "end it below",
        )
    usable = [piece for piece in pieces if len(piece) * t_step * band[0] >= FEWEST_PERIODS]
    if not usable:
        raise MeasurementError(
            f"a record without gaps is shorter than eight periods of {band[0]:g} Hz",
            "band",
            "record for longer, or start the band higher",
        )
    return usable


def prepared(t_step: float, pieces: list[Array]) -> PreparedRecord:
    """Return pieces of a record without their means, relative to the rms of each sensor, as spectral lines."""
    total = sum(len(piece) for piece in pieces)
    centred = [piece - piece.mean(axis=0) for piece in pieces]
    scales = np.sqrt(sum(((piece**2).sum(axis=0) for piece in centred), np.zeros(pieces[0].shape[1])) / total)
    alive = np.where(scales > 0.0, scales, np.inf)
    scaled = [piece / alive for piece in centred]
    longest = max(len(piece) for piece in scaled)
    return PreparedRecord(lines(scaled, t_step, 2 * longest), lines(scaled, t_step), scales, longest * t_step)


def drawn(
    record: PreparedRecord, modes: Sequence[Mode], band: tuple[float, float]
) -> tuple[Array, Complex, Complex]:
    """Return averaged spectral densities of the responses in the band, and the modes' share of them."""
    piece = max(record.plain, key=lambda one: len(one.frequencies))
    inside = slice(*np.searchsorted(piece.frequencies, band))
    f, power = piece.frequencies[inside], np.abs(piece.values[inside]) ** 2 * record.scales**2 * piece.step
    group = max(len(f) // DRAWN, 1)
    rows = len(f) // group * group
    f = f[:rows].reshape(-1, group).mean(axis=1)
    power = power[:rows].reshape(len(f), group, -1).mean(axis=1)
    peaks = np.array([1.0 / np.abs(2j * math.pi * f - mode.pole) ** 2 for mode in modes]).reshape(
        len(modes), len(f)
    )
    at = [int(np.argmin(np.abs(f - mode.frequency))) for mode in modes]
    heights = np.array([power[k] / peaks[j, k] for j, k in enumerate(at)])
    heights = heights.reshape(len(modes), power.shape[1])
    return f, power[:, :, None].astype(complex), (peaks.T @ heights)[:, :, None].astype(complex)
