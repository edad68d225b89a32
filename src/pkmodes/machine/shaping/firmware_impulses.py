"""Impulses that firmware makes of a kind, a frequency and a damping ratio, by formulas of its own where it has any.

Klipper until 22 September 2025 makes those of `pkmodes.shaping.shaper`.  Since then ei, 2hump_ei and 3hump_ei
satisfy their conditions (pkmodes_description.shapers) for the damped mode as well: their impulses are polynomials of
the damping ratio, fitted to numerical solutions for a tolerance of 5 % (klippy/extras/shaper_defs.py, commit
5da026a33). RepRapFirmware has the same for the humps, with times in periods of the damped mode
(src/Movement/AxisShaper.cpp, tag 3.6.0-beta.1).

Marlin's fixed-time motion (Marlin/src/module/ft_motion/shaping.cpp) makes those of `pkmodes.shaping.shaper`,
but a whole number of its samples apart, and lets the amplitudes of mzv decay as if its impulses were half a period
apart.
"""

from __future__ import annotations

import numpy as np
from numpy.polynomial.polynomial import polyval
from numpy.typing import NDArray

from pkmodes.machine.shaping.firmware import KLIPPER, LEAST, MARLIN, TOLERANT, VERSIONS, named
from pkmodes.machine.shaping.shapers import Shaper, shaper
from pkmodes_description.shapers import SHAPERS, TOLERANCE

Array = NDArray[np.float64]
#: Sampling rate of fixed-time motion [Hz]: the default of FTM_FS.
SAMPLES = 1000.0
#: Coefficients of the powers of the damping ratio for each impulse: times, in periods of the undamped mode, and
#: amplitudes.
HUMPS = {
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


def as_made(version: str, kind: str, frequency: float, zeta: float) -> Shaper:
    """Return the shaper that a version of a firmware makes; that of the design where it has no formulas of its own.

    - version: a key of `pkmodes.machine.shaping.firmware.VERSIONS`
    - kind: of one mode
    - frequency: of the design [Hz]
    - zeta: damping ratio of the design
    """
    name = VERSIONS[version].firmware
    if not has_own(version, kind, zeta):
        return shaper(kind, frequency, zeta)
    if name == "marlin":
        return _sampled(kind, frequency, max(zeta, LEAST))
    if kind == "ei":
        return _ei(frequency, zeta)
    period = 1.0 / (frequency * (np.sqrt(1.0 - zeta**2) if name == "reprapfirmware" else 1.0))
    # The missing comma made one coefficient of two, and its row, which had three then, set the order of all.
    return _humps(kind, period, zeta, lacking=version == "klipper-2025-09" and kind == "3hump_ei")


def has_own(version: str, kind: str, zeta: float) -> bool:
    """Return whether a version has formulas of its own for a shaper.

    - version, kind, zeta: as for `as_made`
    """
    name = VERSIONS[version].firmware
    if name == "klipper":
        return version != "klipper-2025-08" and kind in TOLERANT and zeta <= KLIPPER[kind]
    return kind in MARLIN if name == "marlin" else kind in HUMPS and named(kind, zeta)


def settled(version: str, kind: str, frequency: float, zeta: float) -> float:
    """Return the frequency in the middle of those for which a version makes the same impulses [Hz].

    - version, kind, frequency, zeta: as for `as_made`
    """
    if VERSIONS[version].firmware != "marlin" or not has_own(version, kind, zeta):
        return frequency
    made, design = as_made(version, kind, frequency, zeta), shaper(kind, frequency, max(zeta, LEAST))
    return frequency if made.delays[1] == 0.0 else float(frequency * design.delays[1] / made.delays[1])


def _ei(frequency: float, zeta: float) -> Shaper:
    """Return the three impulses of ei with a damped mode."""
    V = TOLERANCE
    first = polyval(zeta, [0.24968 + 0.24961 * V, 0.80008 + 1.23328 * V, 0.49599 + 3.17316 * V])
    last = polyval(zeta, [0.25149 + 0.21474 * V, -0.83249 + 1.41498 * V, 0.85181 - 4.90094 * V])
    rising = [0.46159 + 8.57843 * V, 4.26169 - 108.644 * V, 1.75601 + 336.989 * V]
    middle = 0.4999 + zeta * V * polyval(zeta, rising)
    period = 1.0 / (frequency * np.sqrt(1.0 - zeta**2))
    return Shaper(np.array([first, 1.0 - first - last, last]), period * np.array([0.0, middle, 1.0]))


def _humps(kind: str, period: float, zeta: float, *, lacking: bool) -> Shaper:
    """Return the impulses of 2hump_ei or 3hump_ei, also without the terms of third order that Klipper once lacked."""
    times, amplitudes = (np.array(part) for part in HUMPS[kind])
    if lacking:
        amplitudes[0, 2] += amplitudes[0, 3]
        times[:, 3] = amplitudes[:, 3] = 0.0
    sizes = polyval(zeta, amplitudes.T)
    return Shaper(sizes / sizes.sum(), period * polyval(zeta, times.T))


def _sampled(kind: str, frequency: float, zeta: float) -> Shaper:
    """Return the impulses of fixed-time motion."""
    design = shaper(kind, frequency, zeta)
    count = np.arange(len(design.delays))
    amplitudes = design.amplitudes
    if kind == "mzv":
        decay = np.exp(-np.pi * zeta / np.sqrt(1.0 - zeta**2))
        amplitudes = np.array(SHAPERS[kind].weights) * decay**count
        amplitudes = amplitudes / amplitudes.sum()
    # Halves are rounded away from zero, as lround does.
    return Shaper(amplitudes, np.floor(design.delays[1] * SAMPLES + 0.5) / SAMPLES * count)
