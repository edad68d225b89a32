"""Configuration or G-code lines that set a fixed shaper in firmware, for each version whose lines or impulses differ.

Klipper: ``[input_shaper]`` of printer.cfg (docs/Config_Reference.md of its repository), and ``SET_INPUT_SHAPER``,
which changes it during a print (docs/G-Codes.md).  Marlin: ``M593`` for zv, ``M493`` of fixed-time motion for others
(Marlin/src/gcode/feature/ft_motion/M493.cpp).  The letters of M493 changed in October 2025 (pull request 28127),
since when ``M493 V`` answers; before that, X and Y gave the shaper and Y had its own letters (pull request 26848),
and earlier still S gave it, by numbers that changed.  RepRapFirmware: ``M593`` (src/Movement/AxisShaper.cpp), with
the impulses themselves where it has no name for the shaper: amplitudes and delays from 3.6 on (tag 3.6.0-beta.1),
before that their partial sums and the times between them (tag 3.5.3).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from pkmodes.machine.shaping.shapers import Shaper
from pkmodes_description.shapers import TOLERANCE

#: Official spelling of the names.
FIRMWARE_TITLES = {"klipper": "Klipper", "marlin": "Marlin", "reprapfirmware": "RepRapFirmware"}


class Version(NamedTuple):
    """A version of a firmware.

    - firmware: a key of `FIRMWARE_TITLES`
    - since: the date or version from which it applies; "" for the oldest that is known here
    """

    firmware: str
    since: str


#: Versions by the name that selects them; for each firmware the newest comes first, under the name of the firmware.
#: Klipper changed ei, 2hump_ei and 3hump_ei on 22 September 2025 (commit 5da026a33, pull request 7048;
#: docs/Config_Changes.md dates it 20250916), and a missing comma left the terms of third order out of 3hump_ei until
#: 31 March 2026 (commit 0d1445a72, pull request 7235).  The numbers are from ``git describe``, as Klipper logs them.
VERSIONS = {
    "klipper": Version("klipper", "31 March 2026 (v0.13.0-594)"),
    "klipper-2025-09": Version("klipper", "22 September 2025 (v0.13.0-273)"),
    "klipper-2025-08": Version("klipper", ""),
    "marlin": Version("marlin", "October 2025 (fixed-time motion 2)"),
    "marlin-2025-09": Version("marlin", ""),
    "reprapfirmware": Version("reprapfirmware", "3.6"),
    "reprapfirmware-3.5": Version("reprapfirmware", ""),
}
#: How to ask a machine for its version.
HOW_TO_FIND_VERSION = {
    "klipper": "Klipper writes its version at the start of klippy.log, and web interfaces show it; forks have their "
    "own numbers.",
    "marlin": 'Send M493 V: Marlin from October 2025 answers "FTM V2", an older one only "ok". Afterwards M493 by '
    "itself reports the shaper: S1 with letters of another version turns fixed-time motion on without one. Still "
    "older ones choose the shaper by S10 and above; there are no lines for these.",
    "reprapfirmware": "M115 reports the version of RepRapFirmware.",
}
#: Largest damping ratio that Klipper accepts for each of its shapers (since 4 October 2025, commit 768b19e8b).
KLIPPER_MAX_RATIOS = {"zv": 0.99, "mzv": 0.99, "zvd": 0.99, "ei": 0.4, "2hump_ei": 0.3, "3hump_ei": 0.2}
#: Numbers of the shapers of Marlin's fixed-time motion.
MARLIN_NUMBERS = {"zvd": 2, "zvdd": 3, "ei": 5, "2hump_ei": 6, "3hump_ei": 7, "mzv": 8}
#: Kinds of shapers that have a tolerance.
KINDS_WITH_TOLERANCE = ("ei", "2hump_ei", "3hump_ei")
#: Smallest and largest damping ratio, and lowest frequency [Hz], that fixed-time motion accepts.
MARLIN_MIN_RATIO, MARLIN_MAX_RATIO, MARLIN_MIN_FREQUENCY = 0.01, 0.25, 20.0
#: Names of the shapers of RepRapFirmware.
REPRAP_NAMES = {"zvd": "zvd", "zvdd": "zvdd", "mzv": "mzv", "2hump_ei": "ei2", "3hump_ei": "ei3"}
#: Largest damping ratio for which RepRapFirmware makes nearly the impulses of the design under these names.  Those of
#: its mzv are in reverse order (tags 3.5.3 and 3.6.0-beta.1): the smallest one first.
REPRAP_MAX_RATIOS = {"zvd": 0.99, "zvdd": 0.99, "mzv": 0.001, "2hump_ei": 0.03, "3hump_ei": 0.03}
#: A smaller ratio would be written as 0, which no machine has: the line omits it, or gives the impulses.
MIN_WRITTEN_RATIO = 5e-5
#: Damping ratio of a shaper whose line has none: the default of Klipper (DEFAULT_DAMPING_RATIO) and of Marlin's
#: fixed-time motion (FTM_SHAPING_ZETA_X), and of its M593 (SHAPING_ZETA_X), unless its configuration has another.
DEFAULT_RATIO, MARLIN_ZV_RATIO = 0.1, 0.15
#: Axes that the configuration and G-code lines are for unless others are given.
AXES = "xy"
#: Maximum number of impulses of a custom shaper, and minimum difference of their delays [s].
MAX_IMPULSES, MIN_DELAY_DIFFERENCE = 5, 1e-5


def version_name(version: str, oldest: str | None = None) -> str:
    """Return the name of a version with its dates; the bare firmware name for the newest alone.

    - version: a key of `VERSIONS`
    - oldest: another version of the same firmware; the name then covers all versions from `oldest` to `version`
    """
    firmware = VERSIONS[version].firmware
    keys = [key for key, release in VERSIONS.items() if release.firmware == firmware]
    newer = keys[: keys.index(version)]
    title = FIRMWARE_TITLES[firmware]
    since = VERSIONS[oldest or version].since if newer or oldest else ""
    if not newer:
        return f"{title} from {since}" if since else title
    end = VERSIONS[newer[-1]].since
    return f"{title} from {since}, before {end}" if since else f"{title} before {end}"


def lines_by_firmware(
    kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper
) -> dict[str, str | None]:
    """Return the lines for the current version by firmware; None where it has no such shaper.

    - frequencies: design frequencies [Hz]
    - zeta: design damping ratio
    - shaper: its impulses, (n,)
    """
    return {name: configuration_lines(name, kind, frequencies, zeta, shaper) for name in FIRMWARE_TITLES}


def commands_by_firmware(
    kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper, axes: str = AXES
) -> dict[str, str | None]:
    """Return the G-code that changes the shaper during a print, by firmware; None where it has no such shaper.

    - kind, frequencies, zeta, shaper, axes: as for `configuration_lines`
    """
    return {name: runtime_command(name, kind, frequencies, zeta, shaper, axes) for name in FIRMWARE_TITLES}


def configuration_lines(
    version: str,
    kind: str,
    frequencies: tuple[float, ...],
    zeta: float,
    shaper: Shaper,
    axes: str = AXES,
) -> str | None:
    """Return the lines of a configuration; None where the version has no such shaper.

    - version: a key of `VERSIONS`
    - kind, frequencies, zeta, shaper: as for `lines_by_firmware`
    - axes: axes that the shaper is for
    """
    if VERSIONS[version].firmware != "klipper":
        return runtime_command(version, kind, frequencies, zeta, shaper, axes)
    if not _klipper_accepts(version, kind, zeta):
        return None
    kinds = [f"shaper_type: {kind}"] if axes == AXES else [f"shaper_type_{axis}: {kind}" for axis in axes]
    lines = ["[input_shaper]", *kinds, *(f"shaper_freq_{axis}: {frequencies[0]:.2f}" for axis in axes)]
    ratios = [] if zeta < MIN_WRITTEN_RATIO else [f"damping_ratio_{axis}: {zeta:.4f}" for axis in axes]
    return "\n".join(lines + ratios)


def runtime_command(
    version: str,
    kind: str,
    frequencies: tuple[float, ...],
    zeta: float,
    shaper: Shaper,
    axes: str = AXES,
) -> str | None:
    """Return the G-code that changes the shaper during a print; None where the version has no such shaper.

    - version, kind, frequencies, zeta, shaper, axes: as for `configuration_lines`
    """
    f, firmware = frequencies[0], VERSIONS[version].firmware
    if firmware == "klipper":
        if not _klipper_accepts(version, kind, zeta):
            return None
        letters = axes.upper()
        kinds = (
            [f"SHAPER_TYPE={kind}"] if axes == AXES else [f"SHAPER_TYPE_{axis}={kind}" for axis in letters]
        )
        values = [f"SHAPER_FREQ_{axis}={f:.2f}" for axis in letters]
        if zeta >= MIN_WRITTEN_RATIO:
            values += [f"DAMPING_RATIO_{axis}={zeta:.4f}" for axis in letters]
        return " ".join(["SET_INPUT_SHAPER", *kinds, *values])
    if firmware == "marlin":
        return _marlin_command(kind, f, zeta, axes.upper(), shared_letters=version == "marlin")
    if axes != AXES:
        return None  # its shaper is for all axes
    if has_reprap_name(kind, zeta):
        return f'M593 P"{REPRAP_NAMES[kind]}" F{f:.2f} S{zeta:.4f}'
    times = np.diff(shaper.delays)
    if len(shaper.delays) > MAX_IMPULSES or (times < MIN_DELAY_DIFFERENCE).any():
        return None
    # The impulses, or in older versions their partial sums and the times between them.
    amplitudes, delays = (
        (shaper.amplitudes, shaper.delays[1:])
        if version == "reprapfirmware"
        else (np.cumsum(shaper.amplitudes), times)
    )
    amplitude_text = ":".join(f"{a:.4f}" for a in amplitudes[:-1])
    return f'M593 P"custom" H{amplitude_text} T{":".join(f"{t:.5f}" for t in delays)}'


def ratio_in_use(version: str, kind: str, zeta: float) -> float:
    """Return the damping ratio for which a version makes the shaper of a line: its default where the line has none.

    - version: a key of `VERSIONS`
    - kind: kind of shaper for one mode
    - zeta: design damping ratio
    """
    firmware = VERSIONS[version].firmware
    if zeta >= MIN_WRITTEN_RATIO or firmware == "reprapfirmware":
        return zeta
    return MARLIN_ZV_RATIO if firmware == "marlin" and kind == "zv" else DEFAULT_RATIO


def has_reprap_name(kind: str, zeta: float) -> bool:
    """Return whether RepRapFirmware is given a shaper by name: it then makes nearly the impulses of the design."""
    return MIN_WRITTEN_RATIO <= zeta <= REPRAP_MAX_RATIOS.get(kind, -1.0)


def _klipper_accepts(version: str, kind: str, zeta: float) -> bool:
    """Return whether a version of Klipper accepts a shaper; the oldest has no limit of its own below 1."""
    return kind in KLIPPER_MAX_RATIOS and (version == "klipper-2025-08" or zeta <= KLIPPER_MAX_RATIOS[kind])


def _marlin_command(kind: str, f: float, zeta: float, axes: str, *, shared_letters: bool) -> str | None:
    """Return the command of Marlin; None where it has no such shaper.

    With shared letters X and Y select the axes; in older versions they carry the shaper number.

    - axes: upper-case letters of the axes
    - shared_letters: whether the letters of a value are the same for all axes, as from October 2025 on
    """
    damped = zeta >= MIN_WRITTEN_RATIO
    if kind == "zv":
        words = ["M593", *([] if axes == AXES.upper() else axes), f"F{f:.2f}"]
        return " ".join([*words, *([f"D{zeta:.4f}"] if damped else [])])
    if kind not in MARLIN_NUMBERS or f < MARLIN_MIN_FREQUENCY or zeta > MARLIN_MAX_RATIO:
        return None
    number, ratio, tolerance = MARLIN_NUMBERS[kind], f"{max(zeta, MARLIN_MIN_RATIO):.4f}", f"{TOLERANCE:g}"
    # Letters of frequency, damping ratio and tolerance: in older versions Y has its own.
    if shared_letters:
        letters = [("A", "I", "Q")]
        words = ["M493", "S1", *axes, f"C{number}"]
    else:
        letters = [("A", "I", "Q") if axis == "X" else ("B", "J", "R") for axis in axes]
        words = ["M493", "S1", *(f"{axis}{number}" for axis in axes)]
    words += [f"{letter}{f:.2f}" for letter, _, _ in letters]
    words += [f"{letter}{ratio}" for _, letter, _ in letters] if damped else []
    words += [f"{letter}{tolerance}" for _, _, letter in letters] if kind in KINDS_WITH_TOLERANCE else []
    return " ".join(words)
