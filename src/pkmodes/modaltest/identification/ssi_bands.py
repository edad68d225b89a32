r"""Records of responses as spectral lines, and their correlation functions in narrow parts of a band.

The lines Y(f) of a record in a part of the band are those of an analytic signal, and after a shift by its lower end
f0 this signal has a low rate: its correlations are

.. math:: R(\tau) = \Delta f \sum_f w(f)\, Y(f)\, Y(f)^H e^{2 \pi i (f - f_0) \tau} ,

with a window w that falls smoothly to zero over guards on either side.  The record is padded with zeros, so that
nothing wraps around.  A free decay in R remains one, but for the first lags, which the window widens and which sensor
noise enters: they are left out.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Ratio of the upper to the lower end of a part of the band.
PART_RATIO = 1.4
#: Minimum width of a part in lines of the longest piece.
MIN_LINES = 100
#: Width of a guard relative to the part.
GUARD_SHARE = 0.3
#: Shortest piece of a record, in periods of the lower end of the band.
MIN_PERIODS = 8.0


@dataclass(frozen=True)
class BandPart:
    """A part of the band.

    - low, high: where its modes are taken [Hz]
    - start, stop: ends of its lines, which include the guards [Hz]
    """

    low: float
    high: float
    start: float
    stop: float

    @property
    def rate(self) -> float:
        """Sampling rate of the analytic signal [Hz]."""
        return self.stop - self.start

    def window(self, frequencies: Array) -> Array:
        """Return w(f): 1 between the guards, and a squared cosine over each guard."""
        lower_guard = (frequencies - self.start) / max(self.low - self.start, 1e-12)
        upper_guard = (self.stop - frequencies) / max(self.stop - self.high, 1e-12)
        position = np.clip(np.minimum(lower_guard, upper_guard), 0.0, 1.0)
        return np.asarray(np.sin(0.5 * math.pi * position) ** 2)

    def pole(self, value: Complex) -> Complex:
        """Return poles [1/s] of eigenvalues of one step of the analytic signal."""
        turn = np.mod(np.angle(value), 2.0 * math.pi)  # the lines are above the start
        return np.asarray((np.log(np.abs(value)) + 1j * turn) * self.rate + 2j * math.pi * self.start)


@dataclass(frozen=True, eq=False)
class SpectralLines:
    """Spectral lines of one piece of a record.

    - frequencies: in Hz, (F,)
    - values: values of a transform that is normalised such that the sum of |Y|^2 over the lines times their step is
      a mean square, weighted by the share of the piece in the record, (F, S)
    """

    frequencies: Array
    values: Complex

    def select(self, part: BandPart) -> SpectralLines:
        """Return the lines of a part of the band."""
        line_range = slice(*np.searchsorted(self.frequencies, [part.start, part.stop]))
        return SpectralLines(self.frequencies[line_range], self.values[line_range])

    @property
    def step(self) -> float:
        """Distance of the lines [Hz]."""
        return float(self.frequencies[1] - self.frequencies[0])


def split_band(low: float, high: float, nyquist: float, seconds: float) -> list[BandPart]:
    """Return the parts of a band [Hz] with guards that stay below the Nyquist frequency, for a length of record."""
    min_width = min(MIN_LINES / seconds, high - low)
    ends = [low]
    while ends[-1] < high:
        ends.append(max(PART_RATIO * ends[-1], ends[-1] + min_width))
    if len(ends) > 2 and high - ends[-2] < 0.5 * (ends[-1] - ends[-2]):
        del ends[-2]
    ends[-1] = high
    band_parts = []
    for a, b in pairwise(ends):
        guard = GUARD_SHARE * (b - a)
        band_parts.append(BandPart(a, b, max(a - guard, 0.0), min(b + guard, nyquist)))
    return band_parts


def spectral_lines(pieces: Sequence[Array], t_step: float, padded_length: int = 0) -> list[SpectralLines]:
    """Return spectral lines of pieces of a record, without their means.

    - pieces: each (N, S)
    - t_step: in s
    - padded_length: samples to which each piece is padded with zeros; 0: no padding, so that the lines of noise are
      independent
    """
    total = sum(len(piece) for piece in pieces) * t_step
    spectra = []
    for piece in pieces:
        n = padded_length or len(piece)
        spectrum = np.fft.rfft(piece - piece.mean(axis=0), n, axis=0) * t_step / math.sqrt(0.5 * total)
        spectra.append(SpectralLines(np.asarray(np.fft.rfftfreq(n, t_step), float), spectrum))
    return spectra


def zero_lag_correlations(padded: Sequence[SpectralLines], part: BandPart) -> Complex:
    """Return the correlations (S, S) of a part of the band at the lag 0, between all responses.

    Products of all pairs of responses at each line would not fit into memory with hundreds of sensors.
    """
    weighted = (
        (selected.values * (part.window(selected.frequencies) * selected.step)[:, None]).T
        @ selected.values.conj()
        for selected in (piece.select(part) for piece in padded)
    )
    return np.asarray(sum(weighted))


def correlations(
    padded: Sequence[SpectralLines], part: BandPart, references: Array, lags: NDArray[np.int64]
) -> Complex:
    """Return correlations (K, S, r) of a part of the band at lags in samples of its analytic signal.

    - padded: lines of pieces padded to the same length
    - references: combinations of the responses, (S, r)
    - lags: (K,)
    """
    total: Complex = np.zeros((), dtype=complex)
    for selected in (piece.select(part) for piece in padded):
        weighted = selected.values * (part.window(selected.frequencies) * selected.step)[:, None]
        total = total + weighted[:, :, None] * (selected.values.conj() @ references)[:, None, :]
    turns = np.exp(2j * math.pi * np.outer(lags, (selected.frequencies - part.start) / part.rate))
    return np.asarray(np.tensordot(turns, total, 1))


@dataclass(frozen=True, eq=False)
class PreparedRecord:
    """A record prepared for identification: its sensors relative to their rms, its lines padded and not."""

    padded: list[SpectralLines]
    unpadded: list[SpectralLines]
    scales: Array
    seconds: float


def usable_pieces(t_step: float, pieces: list[Array], band: tuple[float, float]) -> list[Array]:
    """Return the pieces (N, S) of a record that are long enough for a band.

    Raises MeasurementError if the band is not below the Nyquist frequency, or no piece is long enough.
    """
    if band[1] >= 0.5 / t_step:
        raise MeasurementError(
            f"the band ends at {band[1]:g} Hz, the Nyquist frequency is {0.5 / t_step:g} Hz",
            "band",
            "end it below",
        )
    usable = [piece for piece in pieces if len(piece) * t_step * band[0] >= MIN_PERIODS]
    if not usable:
        raise MeasurementError(
            f"a record without gaps is shorter than eight periods of {band[0]:g} Hz",
            "band",
            "record for longer, or start the band higher",
        )
    return usable


def prepare_record(t_step: float, pieces: list[Array]) -> PreparedRecord:
    """Return pieces of a record without their means, relative to the rms of each sensor, as spectral lines."""
    total = sum(len(piece) for piece in pieces)
    centred = [piece - piece.mean(axis=0) for piece in pieces]
    scales = np.sqrt(sum(((piece**2).sum(axis=0) for piece in centred), np.zeros(pieces[0].shape[1])) / total)
    alive = np.where(scales > 0.0, scales, np.inf)
    scaled = [piece / alive for piece in centred]
    max_length = max(len(piece) for piece in scaled)
    return PreparedRecord(
        spectral_lines(scaled, t_step, 2 * max_length),
        spectral_lines(scaled, t_step),
        scales,
        max_length * t_step,
    )
