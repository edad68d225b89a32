"""Impulses that firmware generates for a shaper kind, frequency and damping ratio, by its own formulas if it has any.

Until 22 September 2025 Klipper made the impulses of `pkmodes.shaping.shaper`, and since then ei, 2hump_ei and
3hump_ei satisfy their conditions (pkmodes_description.shapers) for the damped mode as well: their impulses are
polynomials of the damping ratio, fitted to numerical solutions for a tolerance of 5 % (klippy/extras/shaper_defs.py,
commit 5da026a33).  RepRapFirmware has the same for the humps, with times in periods of the damped mode
(src/Movement/AxisShaper.cpp, tag 3.6.0-beta.1).

Marlin's fixed-time motion (Marlin/src/module/ft_motion/shaping.cpp) makes those of `pkmodes.shaping.shaper`,
but a whole number of its samples apart, and lets the amplitudes of mzv decay as if its impulses were half a period
apart.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import NDArray

from pkmodes.machine.shaping.firmware import (
    KINDS_WITH_TOLERANCE,
    KLIPPER_MAX_RATIOS,
    MARLIN_MIN_RATIO,
    MARLIN_NUMBERS,
    VERSIONS,
    has_reprap_name,
)
from pkmodes.machine.shaping.shapers import Shaper, shaper
from pkmodes_description.shapers import SHAPERS, TOLERANCE

Array = NDArray[np.float64]
#: Sampling rate of fixed-time motion [Hz]: the default of FTM_FS.
FTM_SAMPLE_RATE = 1000.0
#: Coefficients of the powers of the damping ratio for each impulse: times, in periods of the undamped mode, and
#: amplitudes.
HUMP_COEFFICIENTS = {
    "2hump_ei": (
        [
            (0.0, 0.0, 0.0, 0.0),
            (0.49890, 0.16270, -0.54262, 6.16180),
            (0.99748, 0.18382, -1.58270, 8.17120),
            (1.49920, -0.09297, -0.28338, 1.85710),
        ],
        [
            (0.16054, 0.76699, 2.26560, -1.22750),
            (0.33911, 0.45081, -2.58080, 1.73650),
            (0.34089, -0.61533, -0.68765, 0.42261),
            (0.15997, -0.60246, 1.00280, -0.93145),
        ],
    ),
    "3hump_ei": (
        [
            (0.0, 0.0, 0.0, 0.0),
            (0.49974, 0.23834, 0.44559, 12.4720),
            (0.99849, 0.29808, -2.36460, 23.3990),
            (1.49870, 0.10306, -2.01390, 17.0320),
            (1.99960, -0.28231, 0.61536, 5.40450),
        ],
        [
            (0.11275, 0.76632, 3.29160, -1.44380),
            (0.23698, 0.61164, -2.57850, 4.85220),
            (0.30008, -0.19062, -2.14560, 0.13744),
            (0.23775, -0.73297, 0.46885, -2.08650),
            (0.11244, -0.45439, 0.96382, -1.46000),
        ],
    ),
}


def firmware_shaper(version: str, kind: str, frequency: float, zeta: float) -> Shaper:
    """Return the shaper that a version of a firmware makes; that of the design where it has no formulas of its own.

    - version: a key of `pkmodes.machine.shaping.firmware.VERSIONS`
    - kind: kind of shaper for one mode
    - frequency: design frequency [Hz]
    - zeta: design damping ratio
    """
    firmware = VERSIONS[version].firmware
    if not has_own_formulas(version, kind, zeta):
        return shaper(kind, frequency, zeta)
    if firmware == "marlin":
        return _marlin_shaper(kind, frequency, max(zeta, MARLIN_MIN_RATIO))
    if kind == "ei":
        return _klipper_ei_shaper(frequency, zeta)
    period = 1.0 / (frequency * (np.sqrt(1.0 - zeta**2) if firmware == "reprapfirmware" else 1.0))
    # A missing comma merged two coefficients into one; that row then had three, which truncated all rows to second
    # order.
    return _hump_shaper(
        kind, period, zeta, missing_third_order=version == "klipper-2025-09" and kind == "3hump_ei"
    )


def has_own_formulas(version: str, kind: str, zeta: float) -> bool:
    """Return whether a version has formulas of its own for a shaper.

    - version, kind, zeta: as for `firmware_shaper`
    """
    firmware = VERSIONS[version].firmware
    if firmware == "klipper":
        if version == "klipper-2025-08":
            return False
        return kind in KINDS_WITH_TOLERANCE and zeta <= KLIPPER_MAX_RATIOS[kind]
    if firmware == "marlin":
        return kind in MARLIN_NUMBERS
    return kind in HUMP_COEFFICIENTS and has_reprap_name(kind, zeta)


def centre_of_equal_impulses(version: str, kind: str, frequency: float, zeta: float) -> float:
    """Return the middle of the interval of frequencies for which a version makes the same impulses [Hz].

    - version, kind, frequency, zeta: as for `firmware_shaper`
    """
    if VERSIONS[version].firmware != "marlin" or not has_own_formulas(version, kind, zeta):
        return frequency
    version_shaper = firmware_shaper(version, kind, frequency, zeta)
    if version_shaper.delays[1] == 0.0:
        return frequency
    design = shaper(kind, frequency, max(zeta, MARLIN_MIN_RATIO))
    return float(frequency * design.delays[1] / version_shaper.delays[1])


def _klipper_ei_shaper(frequency: float, zeta: float) -> Shaper:
    """Return the three impulses of Klipper's ei for a damped mode."""
    tol = TOLERANCE
    first = polyval(zeta, [0.24968 + 0.24961 * tol, 0.80008 + 1.23328 * tol, 0.49599 + 3.17316 * tol])
    last = polyval(zeta, [0.25149 + 0.21474 * tol, -0.83249 + 1.41498 * tol, 0.85181 - 4.90094 * tol])
    rising = [0.46159 + 8.57843 * tol, 4.26169 - 108.644 * tol, 1.75601 + 336.989 * tol]
    middle = 0.4999 + zeta * tol * polyval(zeta, rising)
    period = 1.0 / (frequency * np.sqrt(1.0 - zeta**2))
    return Shaper(np.array([first, 1.0 - first - last, last]), period * np.array([0.0, middle, 1.0]))


def _hump_shaper(kind: str, period: float, zeta: float, *, missing_third_order: bool) -> Shaper:
    """Return the impulses of 2hump_ei or 3hump_ei.

    - missing_third_order: without the third-order terms, which Klipper lacked for a time
    """
    times, amplitudes = (np.array(part) for part in HUMP_COEFFICIENTS[kind])
    if missing_third_order:
        amplitudes[0, 2] += amplitudes[0, 3]
        times[:, 3] = amplitudes[:, 3] = 0.0
    raw_amplitudes = polyval(zeta, amplitudes.T)
    return Shaper(raw_amplitudes / raw_amplitudes.sum(), period * polyval(zeta, times.T))


def _marlin_shaper(kind: str, frequency: float, zeta: float) -> Shaper:
    """Return the impulses of Marlin's fixed-time motion."""
    design = shaper(kind, frequency, zeta)
    count = np.arange(len(design.delays))
    amplitudes = design.amplitudes
    if kind == "mzv":
        decay = np.exp(-np.pi * zeta / np.sqrt(1.0 - zeta**2))
        amplitudes = np.array(SHAPERS[kind].weights) * decay**count
        amplitudes = amplitudes / amplitudes.sum()
    # Halves are rounded away from zero, as lround does.
    return Shaper(amplitudes, np.floor(design.delays[1] * FTM_SAMPLE_RATE + 0.5) / FTM_SAMPLE_RATE * count)
