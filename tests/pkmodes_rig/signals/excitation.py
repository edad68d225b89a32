"""What sets a machine in motion: hammer blows, a shaker, ambient forces and a sweep of the motors; and what hums.

All return samples at even steps; forces are linear between them (`pkmodes_rig.signals.integration`).
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.signal import butter, sosfilt


def half_sines(
    step: float, count: int, starts: Sequence[float], sizes: Sequence[float], length: float
) -> np.ndarray:
    """Return a force of blows, half a sine each, shape (count,) [N].

    Parameters
    ----------
    step : float
        [s].
    starts, sizes : sequence of float
        When each blow begins [s], and its largest force [N].
    length : float
        How long each lasts [s].
    """
    t = step * np.arange(count)
    force = np.zeros(count)
    for start, size in zip(starts, sizes, strict=True):
        inside = (t >= start) & (t < start + length)
        force[inside] += size * np.sin(np.pi * (t[inside] - start) / length)
    return force


def multisine(
    rng: np.random.Generator, step: float, count: int, band: tuple[float, float], rms: float
) -> np.ndarray:
    """Return a period of a shaker's signal: all lines in a band, equally strong, at random phases, shape (count,)."""
    lines = np.fft.rfftfreq(count, step)
    inside = (lines >= band[0]) & (lines <= band[1])
    spectrum = np.where(inside, np.exp(2j * np.pi * rng.random(len(lines))), 0.0)
    force = np.fft.irfft(spectrum, count)
    return force * rms / force.std()


def broadband(
    rng: np.random.Generator, step: float, count: int, sizes: Sequence[float], cut: float
) -> np.ndarray:
    """Return independent random forces, flat in frequency up to a cut-off, shape (count, len(sizes)).

    Parameters
    ----------
    sizes : sequence of float
        One-sided power spectral density of each [N^2/Hz].
    cut : float
        [Hz].
    """
    white = rng.standard_normal((count, len(sizes))) * np.sqrt(np.asarray(sizes) * 0.5 / step)
    return np.asarray(sosfilt(butter(4, cut, fs=1.0 / step, output="sos"), white, axis=0))


def sweep(
    step: float, lowest: float, highest: float, rate: float, per_hertz: float, ramp: float = 0.05
) -> np.ndarray:
    """Return the acceleration of a sweep of the motors as Klipper commands it, shape (N,) [m/s^2].

    Parameters
    ----------
    step : float
        [s].
    lowest, highest : float
        [Hz].
    rate : float
        Of the frequency [Hz/s].
    per_hertz : float
        Acceleration per frequency [m/s^2/Hz].
    ramp : float
        Time to the full acceleration at the begin, and from it at the end [s].

    Notes
    -----
    Klipper commands pieces of constant acceleration of alternating sign; here its fundamental, a sine, is kept.
    """
    t = step * np.arange(round((highest - lowest) / rate / step))
    f = lowest + rate * t
    phase = 2.0 * np.pi * (lowest * t + 0.5 * rate * t**2)
    edge = np.minimum(1.0, np.minimum(t, t[-1] - t) / ramp)
    return per_hertz * f * np.sin(phase) * edge


def mains(t: np.ndarray, rng: np.random.Generator, size: float, frequency: float = 50.0) -> np.ndarray:
    """Return hum of the mains at its first three harmonics, shape of `t`."""
    parts = (1.0, 0.3, 0.5)
    phases = 2.0 * np.pi * rng.random(len(parts))
    return size * sum(
        part * np.sin(2.0 * np.pi * (k + 1) * frequency * t + phase)
        for k, (part, phase) in enumerate(zip(parts, phases, strict=True))
    )


def fan(
    t: np.ndarray, rng: np.random.Generator, size: float, frequency: float, drift: float = 2e-4
) -> np.ndarray:
    """Return the tone of a fan whose speed drifts slowly, shape of `t`.

    Parameters
    ----------
    drift : float
        Relative change of the speed over the record, up and down once.
    """
    span = t[-1] - t[0] if len(t) > 1 else 1.0
    begin, phase = 2.0 * np.pi * rng.random(2)
    slow = drift * span / (2.0 * np.pi) * np.sin(2.0 * np.pi * t / span + begin)
    return size * np.sin(2.0 * np.pi * frequency * (t + slow) + phase)
