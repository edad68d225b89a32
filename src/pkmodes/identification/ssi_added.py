"""Modes of responses alone that the user asks for: fitted to the spectra around a frequency, beside those found.

The poles of all model orders near the frequency give shapes, each of which separates the power of a mode from that of
its neighbours; the fit is that of `ssi_selection`.  As it is tried at a few places and not over the whole band, less
evidence is needed than for a mode that a search finds.
"""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pkmodes.identification.asked import REACH, Asked, replaced, struck, within_reach
from pkmodes.identification.clusters import usable_poles
from pkmodes.identification.lscf import OrderPoles
from pkmodes.identification.ssi_bands import Lines
from pkmodes.identification.ssi_selection import Refined, refined, start

#: Logarithm of the ratio of likelihoods above which a peak is more than a bump of noise: as in `ssi_selection`, but
#: tried at some ten places instead of some hundred.
SIGNIFICANT = 9.0
#: Fits that end nearer than this part of their half bandwidth are one.
SAME = 0.1


def added(
    by_order: Sequence[OrderPoles],
    modes: Sequence[Refined],
    asked: Asked,
    lines: Sequence[Lines],
    ends: tuple[float, float],
    wanted: float,
) -> Refined | str:
    """Return the mode that is fitted from a frequency [Hz], or why there is none.

    Parameters
    ----------
    by_order : sequence of OrderPoles
    modes : sequence of Refined
        Those found: those struck out, and the one that it replaces, are not fitted beside it.
    asked : Asked
    lines : sequence of Lines
        Of pieces without padding.
    ends : tuple of float
        Of the lines that may be used [Hz].
    """
    others = _others(modes, asked, wanted)
    near = [
        start(complex(one.poles[k]), one.shapes[k])
        for one in by_order
        for k in np.flatnonzero(usable_poles(one.poles, (1.0 - REACH) * wanted, (1.0 + REACH) * wanted))
    ]
    if not near:
        return "no model order has a pole within 3 % of it"
    found: list[Refined] = []
    for one in near:
        mode = refined(one, others, lines, ends, SIGNIFICANT)
        if mode is not None and within_reach(abs(mode.pole) / (2.0 * math.pi), wanted):
            found.append(mode)
    if not found:
        return "no fit to the spectra converges within 3 % of it to a peak above the noise"
    first = min(found, key=lambda one: abs(one.frequency - wanted))
    same = SAME * first.rate / (2.0 * math.pi)
    return max(
        (one for one in found if abs(one.frequency - first.frequency) < same), key=lambda one: one.gain
    )


def orders_with(by_order: Sequence[OrderPoles], mode: Refined) -> int:
    """Return in how many orders a pole is within the half bandwidth of a mode."""
    return sum(bool((np.abs(one.poles - mode.pole) < mode.rate).any()) for one in by_order)


def _others(modes: Sequence[Refined], asked: Asked, wanted: float) -> list[Refined]:
    """Return the modes that stay beside one that is added."""
    f = np.array([abs(mode.pole) / (2.0 * math.pi) for mode in modes])
    gone = struck(f, asked)
    before = replaced(f, asked, wanted)
    return [mode for i, mode in enumerate(modes) if not gone[i] and i != before]
