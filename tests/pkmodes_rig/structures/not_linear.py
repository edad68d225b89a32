"""Frequency responses of a machine that is not linear, or is measured by what is not: three modes at five points.

Lines, damping and noise are those of a milling tool that is hit by a hammer: 1 Hz, 2.5 to 3.4 %, 0.1 to 0.2 % of the
highest peak.
"""

from __future__ import annotations

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
#: Lines over which errors of a function are alike.
ALIKE = 30


def responses(
    rng: np.random.Generator,
    *,
    softens: float = 0.0,
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
    error : float
        Root mean square of an error in proportion to the function, which varies over some `ALIKE` lines.
    common : bool
        Whether this error is the same at all points, as that of a force sensor.
    noise : float
        Standard deviation, as a part of the largest value.
    """
    H = sum(
        _mode(f, zeta, softens)[:, None] * shape
        for f, zeta, shape in zip(FREQUENCIES, DAMPING, SHAPES, strict=True)
    )
    H = -((LINES / FREQUENCIES[0]) ** 2)[:, None] * np.asarray(H)
    parts = rng.standard_normal((2, len(LINES), 1 if common else H.shape[1]))
    slow = gaussian_filter1d(parts, ALIKE, axis=1)
    slow = slow[0] + 1j * slow[1]
    H = H * (1.0 + error * slow / np.sqrt((np.abs(slow) ** 2).mean()))
    white = rng.standard_normal((2, *H.shape)) / np.sqrt(2.0)
    return np.asarray(H + noise * np.abs(H).max() * (white[0] + 1j * white[1]))[..., None]


def _mode(frequency: float, zeta: float, softens: float) -> Complex:
    """Return the receptance of a mode, of height 1 at the peak of the linear one."""
    w, s = 2.0 * np.pi * frequency, 2j * np.pi * LINES

    def receptance(amplitude: Array) -> Complex:
        wa, damped = w * (1.0 - softens * amplitude), zeta * (1.0 + 2.0 * softens * amplitude)
        return np.asarray(2.0 * zeta * w**2 / (wa**2 + s**2 + 2.0 * damped * wa * s))

    amplitude = np.zeros(len(LINES))
    for _ in range(ITERATIONS):
        amplitude = 0.5 * amplitude + 0.5 * np.abs(receptance(amplitude))
    return receptance(amplitude)
