"""Lines that set a fixed shaper in the firmware of a printer: formats as their manuals describe them.

Klipper: ``[input_shaper]`` of printer.cfg (klipper3d.org/Config_Reference.html), and ``SET_INPUT_SHAPER``, which
changes it during a print (klipper3d.org/G-Codes.html).  Marlin: ``M593`` for zv, ``M493`` of fixed-time motion for
the others (marlinfw.org/docs/gcode; the letters of ``M493`` changed between versions, and are those of its source in
2026).  RepRapFirmware: ``M593``, with the impulses themselves where it has no name for the shaper (version 3.6 and
later; docs.duet3d.com).
"""

from __future__ import annotations

import numpy as np

from pkmodes.shaping.shapers import Shaper
from pkmodes_description.shapers import TOLERANCE

#: Names as they are written.
NAMES = {"klipper": "Klipper", "marlin": "Marlin", "reprapfirmware": "RepRapFirmware"}
#: The largest damping ratio that Klipper accepts, by shaper.
KLIPPER = {"zv": 0.99, "mzv": 0.99, "zvd": 0.99, "ei": 0.4, "2hump_ei": 0.3, "3hump_ei": 0.2}
#: Numbers of the shapers of fixed-time motion, and those that have a tolerance.
MARLIN = {"zvd": 2, "zvdd": 3, "ei": 5, "2hump_ei": 6, "3hump_ei": 7, "mzv": 8}
TOLERANT = ("ei", "2hump_ei", "3hump_ei")
#: The least and the largest damping ratio, and the least frequency [Hz], that fixed-time motion accepts.
LEAST, MOST, LOWEST = 0.01, 0.25, 20.0
#: Damping ratio from which on firmware with formulas of its own for the humps makes other impulses of them.
DAMPED = 0.03
REPRAPFIRMWARE = {"zvd": "zvd", "zvdd": "zvdd", "mzv": "mzv", "2hump_ei": "ei2", "3hump_ei": "ei3"}
#: Impulses of a shaper of its own at most, and delays that it can tell apart [s].
IMPULSES, APART = 5, 1e-5


def firmware(kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper) -> dict[str, str | None]:
    """Return the lines by firmware; None where it has no such shaper.

    Parameters
    ----------
    kind : str
    frequencies : tuple of float
        Of the design [Hz].
    zeta : float
        Damping ratio of the design.
    shaper : Shaper
        Its impulses, (n,).
    """
    return {
        **command(kind, frequencies, zeta, shaper),
        "klipper": _klipper(kind, frequencies[0], zeta) if _in_klipper(kind, zeta) else None,
    }


def command(kind: str, frequencies: tuple[float, ...], zeta: float, shaper: Shaper) -> dict[str, str | None]:
    """Return the G-code that changes the shaper during a print, by firmware; None where it has no such shaper.

    Parameters
    ----------
    kind, frequencies, zeta, shaper
        As for `firmware`.
    """
    f = frequencies[0]
    return {
        "klipper": _klipper_command(kind, f, zeta) if _in_klipper(kind, zeta) else None,
        "marlin": _marlin(kind, f, zeta),
        "reprapfirmware": _reprapfirmware(kind, f, zeta, shaper),
    }


def _in_klipper(kind: str, zeta: float) -> bool:
    return zeta <= KLIPPER.get(kind, -1.0)


def _klipper(kind: str, f: float, zeta: float) -> str:
    lines = ["[input_shaper]", f"shaper_type: {kind}"]
    lines += [f"shaper_freq_{axis}: {f:.2f}" for axis in "xy"]
    return "\n".join(lines + [f"damping_ratio_{axis}: {zeta:.4f}" for axis in "xy"])


def _klipper_command(kind: str, f: float, zeta: float) -> str:
    axes = [f"SHAPER_FREQ_{axis}={f:.2f}" for axis in "XY"]
    axes += [f"DAMPING_RATIO_{axis}={zeta:.4f}" for axis in "XY"]
    return " ".join(["SET_INPUT_SHAPER", f"SHAPER_TYPE={kind}", *axes])


def _marlin(kind: str, f: float, zeta: float) -> str | None:
    if kind == "zv":
        return f"M593 F{f:.2f} D{zeta:.4f}"
    if kind not in MARLIN or f < LOWEST or zeta > MOST:
        return None
    tolerance = f" Q{TOLERANCE:g}" if kind in TOLERANT else ""
    return f"M493 S1 X Y C{MARLIN[kind]} A{f:.2f} I{max(zeta, LEAST):.4f}{tolerance}"


def _reprapfirmware(kind: str, f: float, zeta: float, shaper: Shaper) -> str | None:
    if kind in REPRAPFIRMWARE and not (kind in TOLERANT and zeta > DAMPED):
        return f'M593 P"{REPRAPFIRMWARE[kind]}" F{f:.2f} S{zeta:.4f}'
    if len(shaper.delays) > IMPULSES or (np.diff(shaper.delays) < APART).any():
        return None
    amplitudes = ":".join(f"{a:.4f}" for a in shaper.amplitudes[:-1])
    delays = ":".join(f"{t:.5f}" for t in shaper.delays[1:])
    return f'M593 P"custom" H{amplitudes} T{delays}'
