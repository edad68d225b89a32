"""Lines that set a fixed shaper in the firmware of a printer, for each version whose lines or impulses differ.

Klipper: ``[input_shaper]`` of printer.cfg (docs/Config_Reference.md of its repository), and ``SET_INPUT_SHAPER``,
which changes it during a print (docs/G-Codes.md).  Marlin: ``M593`` for zv, ``M493`` of fixed-time motion for others
(Marlin/src/gcode/feature/ft_motion/M493.cpp).  Its letters changed with pull request 28127 of October 2025, which has
``M493 V`` answer; before, X and Y took the shaper and Y had letters of its own (pull request 26848), and in still
older ones S took it, by numbers that changed.  RepRapFirmware: ``M593`` (src/Movement/AxisShaper.cpp), with the
impulses themselves where it has no name for the shaper: amplitudes and delays from 3.6 on (tag 3.6.0-beta.1), before
that their partial sums and the times between them (tag 3.5.3).
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from pkmodes.machine.shaping.shapers import Shaper
from pkmodes_description.shapers import TOLERANCE

#: Official spelling of the names.
NAMES = {"klipper": "Klipper", "marlin": "Marlin", "reprapfirmware": "RepRapFirmware"}


class Version(NamedTuple):
    """A version of a firmware.

    - firmware: a key of `NAMES`
    - since: with what it begins; "" for the oldest that is known here
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
#: The shapers of Klipper, and the largest damping ratio that it accepts for each (since 4 October 2025, commit
#: 768b19e8b).
KLIPPER = {"zv": 0.99, "mzv": 0.99, "zvd": 0.99, "ei": 0.4, "2hump_ei": 0.3, "3hump_ei": 0.2}
#: Numbers of the shapers of fixed-time motion; then those that have a tolerance.
MARLIN = {"zvd": 2, "zvdd": 3, "ei": 5, "2hump_ei": 6, "3hump_ei": 7, "mzv": 8}
TOLERANT = ("ei", "2hump_ei", "3hump_ei")
#: Smallest and largest damping ratio, and lowest frequency [Hz], that fixed-time motion accepts.
LEAST, MOST, LOWEST = 0.01, 0.25, 20.0
REPRAPFIRMWARE = {"zvd": "zvd", "zvdd": "zvdd", "mzv": "mzv", "2hump_ei": "ei2", "3hump_ei": "ei3"}
#: Damping ratio up to which RepRapFirmware makes nearly the impulses of the design under these names.  Those of its
#: mzv are in reverse order (tags 3.5.3 and 3.6.0-beta.1): the smallest one first.
SAME = {"zvd": 0.99, "zvdd": 0.99, "mzv": 0.001, "2hump_ei": 0.03, "3hump_ei": 0.03}
#: Smaller damping ratios are 0 in a line, and no machine has none: the line leaves it out, or has the impulses.
NO_DAMPING = 5e-5
#: Damping ratio of a shaper whose line has none: the default of Klipper (DEFAULT_DAMPING_RATIO) and of Marlin's
#: fixed-time motion (FTM_SHAPING_ZETA_X), and of its M593 (SHAPING_ZETA_X), unless its configuration has another.
DEFAULT_RATIO, MARLIN_ZV_RATIO = 0.1, 0.15
#: Axes that the lines are for unless others are given.
AXES = "xy"
#: Most impulses of a custom shaper, and smallest difference of delays that is resolved [s].
IMPULSES, APART = 5, 1e-5


def version_name(version: str, oldest: str | None = None) -> str:
    """Return the name of a version with its dates; that of the firmware for the newest, unless an oldest is given.

    - version: a key of `VERSIONS`
    - oldest: another one of the same firmware: the name is that of all from it up to `version`
    """
    name = VERSIONS[version].firmware
    keys = [key for key, release in VERSIONS.items() if release.firmware == name]
    newer = keys[: keys.index(version)]
    since = VERSIONS[oldest or version].since if newer or oldest else ""
    begins = f" from {since}" if since else ""
    ends = f"{',' if since else ''} before {VERSIONS[newer[-1]].since}" if newer else ""
    return f"{NAMES[name]}{begins}{ends}"


def firmware(kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper) -> dict[str, str | None]:
    """Return the lines for the current version by firmware; None where it has no such shaper.

    - frequencies: of the design [Hz]
    - zeta: damping ratio of the design
    - shaper: its impulses, (n,)
    """
    return {name: setting(name, kind, frequencies, zeta, shaper) for name in NAMES}


def command(
    kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper, axes: str = AXES
) -> dict[str, str | None]:
    """Return the G-code that changes the shaper during a print, by firmware; None where it has no such shaper.

    - kind, frequencies, zeta, shaper, axes: as for `setting`
    """
    return {name: change(name, kind, frequencies, zeta, shaper, axes) for name in NAMES}


def setting(
    version: str,
    kind: str,
    frequencies: tuple[float, ...],
    zeta: float,
    shaper: Shaper,
    axes: str = AXES,
) -> str | None:
    """Return the lines of a configuration; None where the version has no such shaper.

    - version: a key of `VERSIONS`
    - kind, frequencies, zeta, shaper: as for `firmware`
    - axes: those that the shaper is for
    """
    if VERSIONS[version].firmware != "klipper":
        return change(version, kind, frequencies, zeta, shaper, axes)
    if not _in_klipper(version, kind, zeta):
        return None
    kinds = [f"shaper_type: {kind}"] if axes == AXES else [f"shaper_type_{axis}: {kind}" for axis in axes]
    lines = ["[input_shaper]", *kinds, *(f"shaper_freq_{axis}: {frequencies[0]:.2f}" for axis in axes)]
    ratios = [] if zeta < NO_DAMPING else [f"damping_ratio_{axis}: {zeta:.4f}" for axis in axes]
    return "\n".join(lines + ratios)


def change(
    version: str,
    kind: str,
    frequencies: tuple[float, ...],
    zeta: float,
    shaper: Shaper,
    axes: str = AXES,
) -> str | None:
    """Return the G-code that changes the shaper during a print; None where the version has no such shaper.

    - version, kind, frequencies, zeta, shaper, axes: as for `setting`
    """
    f, name = frequencies[0], VERSIONS[version].firmware
    if name == "klipper":
        if not _in_klipper(version, kind, zeta):
            return None
        letters = axes.upper()
        kinds = (
            [f"SHAPER_TYPE={kind}"] if axes == AXES else [f"SHAPER_TYPE_{axis}={kind}" for axis in letters]
        )
        values = [f"SHAPER_FREQ_{axis}={f:.2f}" for axis in letters]
        if zeta >= NO_DAMPING:
            values += [f"DAMPING_RATIO_{axis}={zeta:.4f}" for axis in letters]
        return " ".join(["SET_INPUT_SHAPER", *kinds, *values])
    if name == "marlin":
        return _marlin(kind, f, zeta, axes.upper(), by_axis=version == "marlin")
    if axes != AXES:
        return None  # its shaper is for all axes
    if named(kind, zeta):
        return f'M593 P"{REPRAPFIRMWARE[kind]}" F{f:.2f} S{zeta:.4f}'
    times = np.diff(shaper.delays)
    if len(shaper.delays) > IMPULSES or (times < APART).any():
        return None
    # The impulses, or in older versions their partial sums and the times between them.
    amplitudes, delays = (
        (shaper.amplitudes, shaper.delays[1:])
        if version == "reprapfirmware"
        else (np.cumsum(shaper.amplitudes), times)
    )
    heights = ":".join(f"{a:.4f}" for a in amplitudes[:-1])
    return f'M593 P"custom" H{heights} T{":".join(f"{t:.5f}" for t in delays)}'


def ratio_in_use(version: str, kind: str, zeta: float) -> float:
    """Return the damping ratio for which a version makes a shaper of its line: its default where the line has none.

    - version: a key of `VERSIONS`
    - kind: of one mode
    - zeta: damping ratio of the design
    """
    name = VERSIONS[version].firmware
    if zeta >= NO_DAMPING or name == "reprapfirmware":
        return zeta
    return MARLIN_ZV_RATIO if name == "marlin" and kind == "zv" else DEFAULT_RATIO


def named(kind: str, zeta: float) -> bool:
    """Return whether RepRapFirmware gets its name for a shaper: where it makes impulses near those of the design."""
    return NO_DAMPING <= zeta <= SAME.get(kind, -1.0)


def _in_klipper(version: str, kind: str, zeta: float) -> bool:
    """Return whether it has a shaper: the oldest version has no limit of its own below 1."""
    return kind in KLIPPER and (version == "klipper-2025-08" or zeta <= KLIPPER[kind])


def _marlin(kind: str, f: float, zeta: float, axes: str, *, by_axis: bool) -> str | None:
    """Return the command of Marlin, with X and Y as the axes that it is for, or in older ones with their shapers.

    - axes: their letters
    - by_axis: whether the letters of a value are the same for all axes, as from October 2025 on
    """
    damped = zeta >= NO_DAMPING
    if kind == "zv":
        words = ["M593", *([] if axes == AXES.upper() else axes), f"F{f:.2f}"]
        return " ".join([*words, *([f"D{zeta:.4f}"] if damped else [])])
    if kind not in MARLIN or f < LOWEST or zeta > MOST:
        return None
    number, ratio, tolerance = MARLIN[kind], f"{max(zeta, LEAST):.4f}", f"{TOLERANCE:g}"
    # Letters of frequency, damping ratio and tolerance: in older versions Y has its own.
    letters = (
        [("A", "I", "Q")]
        if by_axis
        else [("A", "I", "Q") if axis == "X" else ("B", "J", "R") for axis in axes]
    )
    words = ["M493", "S1", *(axes if by_axis else (f"{axis}{number}" for axis in axes))]
    words += [f"C{number}"] if by_axis else []
    words += [f"{frequency}{f:.2f}" for frequency, _, _ in letters]
    words += [f"{letter}{ratio}" for _, letter, _ in letters] if damped else []
    words += [f"{letter}{tolerance}" for _, _, letter in letters] if kind in TOLERANT else []
    return " ".join(words)
