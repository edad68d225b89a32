"""Frequency responses of a machine that is not linear, or is measured by what is not: three modes at five points.

Lines, damping and noise are those of a milling tool that is hit by a hammer: 1 Hz, 2.5 to 3.4 %, 0.1 to 0.2 % of the
highest peak.
"""

from __future__ import annotations

import math

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import gaussian_filter1d

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

LINES = np.arange(300.0, 3500.0)
BAND = (500.0, 3200.0)
FREQUENCIES, DAMPING = (1074.0, 1961.0, 2617.0), (0.034, 0.030, 0.025)
SHAPES = np.array([[1.0, 0.7, 0.4, 0.2, 0.1], [-0.6, 0.2, 0.7, 0.6, 0.3], [0.3, -0.5, 0.1, 0.6, 0.5]])
#: Iterations of the amplitudes of a joint: each changes them by a few per cent of the step before.
ITERATIONS = 200
#: Amplitude at which a Jenkins element begins to slip, as a part of that at the peak of the linear mode.
SLIPS = 0.3
#: Lines over which errors of a function are alike.
ALIKE = 30


def responses(
    rng: np.random.Generator,
    *,
    softens: float = 0.0,
    cubic: float = 0.0,
    jenkins: float = 0.0,
    transducer: float = math.inf,
    second: float = 1.0,
    error: float = 0.0,
    common: bool = False,
    noise: float = 0.002,
) -> Complex:
    """Return accelerances, (F, 5, 1).

    Parameters
    ----------
    softens : float
        Part by which a frequency is lower at the peak than at small amplitudes; the damping rises by twice as much,
        as in joints that slip (harmonic balance).
    cubic : float
        Part by which a cubic spring raises the stiffness at the peak of the linear mode.
    jenkins : float
        Part of the stiffness that a Jenkins element has, which slips above an amplitude.
    transducer : float
        Frequency of the transducer's own resonance [Hz].
    second : float
        Size of the second mode, as a part of what it is otherwise.
    error : float
        Root mean square of an error in proportion to the function, which varies over some `ALIKE` lines.
    common : bool
        Whether this error is the same at all points, as that of a force sensor.
    noise : float
        Standard deviation, as a part of the largest value.
    """
    H = sum(
        size * _mode(f, zeta, softens, cubic, jenkins)[:, None] * shape
        for f, zeta, shape, size in zip(FREQUENCIES, DAMPING, SHAPES, (1.0, second, 1.0), strict=True)
    )
    H = -((LINES / FREQUENCIES[0]) ** 2)[:, None] * np.asarray(H)
    H = H * (1.0 / (1.0 - (LINES / transducer) ** 2 + 0.04j * LINES / transducer))[:, None]
    parts = rng.standard_normal((2, len(LINES), 1 if common else H.shape[1]))
    slow = gaussian_filter1d(parts, ALIKE, axis=1)
    slow = slow[0] + 1j * slow[1]
    H = H * (1.0 + error * slow / np.sqrt((np.abs(slow) ** 2).mean()))
    white = rng.standard_normal((2, *H.shape)) / np.sqrt(2.0)
    return np.asarray(H + noise * np.abs(H).max() * (white[0] + 1j * white[1]))[..., None]


def _mode(frequency: float, zeta: float, softens: float, cubic: float, jenkins: float) -> Complex:
    """Return the receptance of a mode, of height 1 at the peak of the linear one, by harmonic balance."""
    w, s = 2.0 * np.pi * frequency, 2j * np.pi * LINES

    def receptance(amplitude: Array) -> Complex:
        slipping = np.maximum(amplitude, SLIPS)
        angle = np.arccos(1.0 - 2.0 * SLIPS / slipping)
        sticks = (angle - 0.5 * np.sin(2.0 * angle)) / np.pi
        lost = 4.0 * SLIPS * (slipping - SLIPS) / (np.pi * slipping**2)
        slip = jenkins * (1.0 - sticks - 1j * lost)
        stiffness = (1.0 - softens * amplitude) ** 2 + cubic * amplitude**2 - slip
        damped = zeta * (1.0 + 2.0 * softens * amplitude) * (1.0 - softens * amplitude)
        return np.asarray(2.0 * zeta * w**2 / (w**2 * stiffness + s**2 + 2.0 * damped * w * s))

    amplitude = np.zeros(len(LINES))
    for _ in range(ITERATIONS):
        amplitude = 0.7 * amplitude + 0.3 * np.abs(receptance(amplitude))
    return receptance(amplitude)
