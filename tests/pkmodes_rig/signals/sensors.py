"""Laboratory accelerometers: anti-aliasing, noise, hum, sensitivity and mounting; and a hammer's force cell."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.signal import decimate

from pkmodes_rig.signals.excitation import fan, mains

#: Integration steps in a sample of the laboratory.
OVERSAMPLED = 4


@dataclass(frozen=True)
class Sensor:
    """One measured direction.

    Attributes
    ----------
    channel : str
        Coordinate or platform direction that it is meant to measure.
    gain : float
        What it reads per what it measures, by the sensitivity that the laboratory states.
    across : mapping of str to float
        Other directions that it measures too, because it is mounted askew.
    """

    channel: str
    gain: float = 1.0
    across: Mapping[str, float] | None = None

    def row(self, shapes: Mapping[str, np.ndarray]) -> np.ndarray:
        """Return what it reads of modes with these shapes."""
        row = shapes[self.channel] + sum(part * shapes[name] for name, part in (self.across or {}).items())
        return np.asarray(self.gain * row)


@dataclass(frozen=True)
class Room:
    """Noise at the sensors of a laboratory.

    Attributes
    ----------
    noise : float
        One-sided power spectral density [(m/s^2)^2/Hz].
    hum : float
        Amplitude of the mains [m/s^2].
    fan : float
        Amplitude of a fan's tone [m/s^2].
    fan_frequency : float
        [Hz].
    """

    noise: float
    hum: float = 0.0
    fan: float = 0.0
    fan_frequency: float = 87.0


def sampled(signals: np.ndarray) -> np.ndarray:
    """Return every `OVERSAMPLED`-th sample along the first axis, after a filter of linear phase."""
    return np.asarray(decimate(signals, OVERSAMPLED, ftype="fir", axis=0, zero_phase=True))


def heard(
    motion: np.ndarray, step: float, sensors: Sequence[Sensor], room: Room, rng: np.random.Generator
) -> np.ndarray:
    """Return what sensors record of sampled accelerations, shape (N, S).

    Parameters
    ----------
    motion : ndarray, shape (N, S)
        What each sensor reads, without noise.
    step : float
        Between samples [s].
    """
    t = step * np.arange(len(motion))
    found = motion + rng.standard_normal(motion.shape) * np.sqrt(room.noise * 0.5 / step)
    for column, _ in enumerate(sensors):  # cables and feet differ, so the tones do too
        found[:, column] += mains(t, rng, room.hum * rng.uniform(0.3, 1.0))
        found[:, column] += fan(t, rng, room.fan * rng.uniform(0.3, 1.0), room.fan_frequency)
    return found
