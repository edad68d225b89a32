"""The ADXL345 of a printer's owner: noise, coarse steps, a rate that is not the nominal one, lost samples.

Figures measured on real boards: 170 to 260 mm/s^2 rms at rest, steps of 74 mm/s^2, a rate of 3208 to 3272 Hz instead
of 3200 Hz, times in the file rounded to 1 microsecond.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from scipy.interpolate import make_interp_spline

AXES = ("x", "y", "z")
NOMINAL = 3200.0


@dataclass(frozen=True)
class Chip:
    """One board.

    Attributes
    ----------
    rate : float
        True sampling rate [Hz].
    noise : float
        At rest, rms [m/s^2].
    step : float
        Of the numbers [m/s^2].
    offsets : tuple of three floats
        Gravity and zero errors [m/s^2].
    """

    rate: float
    noise: float
    step: float = 0.074
    offsets: tuple[float, float, float] = (0.2, -0.1, 9.8)

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> Chip:
        """Draw a board."""
        rate = NOMINAL * (1.0 + rng.uniform(0.003, 0.023))
        x, y, z = rng.normal(0.0, 0.3, 3)
        return cls(float(rate), float(rng.uniform(0.17, 0.26)), offsets=(float(x), float(y), float(9.8 + z)))


@dataclass(frozen=True, eq=False)
class Recording:
    """A recording: times [s], shape (N,), and accelerations [m/s^2], shape (N, 3)."""

    times: np.ndarray
    accelerations: np.ndarray


def record(
    chip: Chip,
    step: float,
    motion: np.ndarray,
    rng: np.random.Generator,
    dropped: tuple[float, int] | None = None,
) -> Recording:
    """Record accelerations.

    Parameters
    ----------
    chip : Chip
    step : float
        Between samples of the motion [s].
    motion : ndarray, shape (N, 3)
        [m/s^2].
    rng : numpy.random.Generator
    dropped : tuple of float and int, optional
        When a block of samples is lost [s], and how many.
    """
    t = np.arange(int((len(motion) - 1) * step * chip.rate)) / chip.rate
    moved = make_interp_spline(step * np.arange(len(motion)), motion, k=3)(t)
    noisy = moved + chip.offsets + chip.noise * rng.standard_normal(moved.shape)
    values = chip.step * np.round(noisy / chip.step)
    kept = np.ones(len(t), dtype=bool)
    if dropped:
        first = int(np.searchsorted(t, dropped[0]))
        kept[first : first + dropped[1]] = False
    return Recording(np.round(t[kept], 6), values[kept])


def write_raw(path: Path, recording: Recording, begin: float = 100.0) -> None:
    """Write the raw table of Klipper, ``#time,accel_x,accel_y,accel_z`` [s, mm/s^2], from a time of the host."""
    lines = ["#time,accel_x,accel_y,accel_z"]
    lines += [
        f"{begin + t:.6f},{a[0]:.6f},{a[1]:.6f},{a[2]:.6f}"
        for t, a in zip(recording.times, 1e3 * recording.accelerations, strict=True)
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def write_spectrum(path: Path, recording: Recording, highest: float = 200.0) -> None:
    """Write the table of Klipper's resonance test, ``freq,psd_x,psd_y,psd_z,psd_xyz`` [Hz, (mm/s^2)^2/Hz]."""
    f, power = spectrum(recording)
    kept = f <= highest
    lines = ["freq,psd_x,psd_y,psd_z,psd_xyz"]
    lines += [
        ",".join([f"{line:.1f}", *(f"{one:.3e}" for one in (*values, values.sum()))])
        for line, values in zip(f[kept], 1e6 * power[kept], strict=True)
    ]
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def spectrum(recording: Recording) -> tuple[np.ndarray, np.ndarray]:
    """Return frequencies [Hz] and powers, shape (F, 3), as Klipper's `shaper_calibrate` computes them.

    Kaiser windows (beta 6) of half a second, rounded up to a power of two samples and half overlapping, each without
    its mean, are averaged.  The rate is the mean one of the file.
    """
    count = len(recording.times)
    rate = (count - 1) / (recording.times[-1] - recording.times[0])
    length = 1 << int(0.5 * rate - 1).bit_length()
    window = np.kaiser(length, 6.0)
    starts = range(0, count - length + 1, length // 2)
    total = np.zeros((length // 2 + 1, 3))
    for first in starts:
        piece = recording.accelerations[first : first + length]
        lines = np.fft.rfft(window[:, None] * (piece - piece.mean(axis=0)), axis=0)
        total += np.abs(lines) ** 2
    total *= 1.0 / (rate * (window**2).sum() * len(starts))
    total[1:-1] *= 2.0
    return np.fft.rfftfreq(length, 1.0 / rate), total


def columns(recording: Recording) -> Mapping[str, np.ndarray]:
    """Return its columns by their names in Klipper's files, without the time [mm/s^2]."""
    return {f"accel_{axis}": 1e3 * recording.accelerations[:, i] for i, axis in enumerate(AXES)}
