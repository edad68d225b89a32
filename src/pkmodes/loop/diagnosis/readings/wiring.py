"""Sensors wired or mounted differently from the file, or not connected.

If the shapes disagree with the model, every wiring that a single mistake gives is tried, each with the modes paired
anew (`misfits`).  A mistake is reported if some wiring fits far better than the file's; it is named if no other
wiring fits nearly as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import joined
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.observations import SHAPE
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Instrumented
from pkmodes.loop.diagnosis.readings.comparison import Apart
from pkmodes.loop.diagnosis.readings.misfits import WiringMisfit, misfits, promising
from pkmodes.loop.diagnosis.readings.wirings import (
    Wiring,
    as_in_file,
    hint,
    remedy,
    simplicity,
    wiring_in_words,
    wirings,
)

#: Largest number of wirings named in a sentence.
MOST = 4


class Rewired(NamedTuple):
    """Wirings that fit far better than that of the file, up to the sign of all columns, the best one first.

    It is certain if that one brings the shapes near to the errors of the measurement.
    """

    wirings: list[Wiring]
    certain: bool
    sentence: str


def certain_wiring(plain: FitStore) -> str:
    """Another wiring of the sensors brings the shapes near to their errors."""
    fitter, fit = plain.fitter, plain.fit(Hypothesis())
    rewiring = None if fit is None or dead_channels(fitter, fit) else rewired(fitter, fit)
    return rewiring.sentence if rewiring is not None and rewiring.certain else ""


def other_wiring(fitter: Fitter, fit: Fit) -> str:
    """The shapes fit far better with another wiring of the sensors."""
    rewiring = rewired(fitter, fit)
    return "" if rewiring is None else rewiring.sentence


def dead_channels(fitter: Fitter, fit: Fit) -> str:
    """A channel is exactly 0 in every row although the model clearly moves it in some."""
    if not fitter.observations.shapes.known.any():
        return ""
    data, pairing = fitter.data, fit.pairing
    shaped = (pairing.partner >= 0) & np.nan_to_num(data.shapes).any(axis=1)
    measured = np.isfinite(data.shapes) & shaped[:, None]
    columns = fitter.observations.pairer.columns
    model = np.abs(fit.prediction.shapes[data.pose, np.maximum(pairing.partner, 0)][:, columns])
    units = np.array([fitter.structure.channel_units[i] for i in columns])
    moved, share = fitter.criteria.readings.dead
    dead = []
    for k, name in enumerate(data.channels):
        rows = measured[:, k]
        if not rows.any() or np.nan_to_num(data.shapes[:, k]).any():
            continue
        alike = np.where(measured & (units == units[k]), model, 0.0).max(axis=1)
        if (model[rows, k] > moved * alike[rows]).mean() >= share and alike[rows].any():
            dead.append(name)
    if len(dead) == 1:
        return f"channel {dead[0]} is 0 in every row: is the sensor connected? If not, leave the column out"
    are = "are 0 in every row: are the sensors connected? If not, leave the columns out"
    return f"channels {', '.join(dead)} {are}" if dead else ""


def rewired(fitter: Fitter, fit: Fit) -> Rewired | None:
    """Return the wirings that fit far better than that of the file; None if there is none.

    - fit: of the file as it is
    """
    c, columns = fitter.criteria.readings, fitter.data.channels
    sensors = tuple(fitter.structure.sensors) if isinstance(fitter.structure, Instrumented) else ()
    tried = wirings(columns, sensors) if _doubtful(fitter, fit) else {}
    if not tried or not promising(fitter, fit, tuple(tried)):
        return None
    by_wiring = misfits(fitter, fit, tuple(tried))
    here = by_wiring.pop(as_in_file(columns))
    complete = min(misfit.per_value[0] for misfit in (here, *by_wiring.values())) < c.rewired_noise
    deviance = {wiring: misfit.deviance(complete) for wiring, misfit in by_wiring.items()}
    order = sorted(deviance, key=deviance.__getitem__)
    least, best = deviance[order[0]], by_wiring[order[0]]
    better = Apart(here.shapes, best.shapes).far_better(c.rewired)
    if not better or here.deviance(complete) - least < c.rewired_certain:
        return None
    remaining = [w for w in order if deviance[w] - least < c.rewired_told_apart]
    certain = (
        best.per_value[1] < c.rewired_noise and best.difference < fitter.criteria.shapes.most_scatter / 2.0
    )
    mistakes = []
    for wiring in remaining:
        # The simplest of several mistakes that shapes cannot tell apart, and turned sensors.
        same = sorted(tried[wiring], key=lambda mistake: simplicity(mistake, columns))
        first, *alternatives = (wiring_in_words(mistake, columns, sensors) for mistake in same)
        mistakes.append([first, *(text for text in alternatives if " is turned by " in text)])
    simplest = min(tried[order[0]], key=lambda wiring: simplicity(wiring, columns))
    change = remedy(simplest, columns) + hint(simplest, columns, sensors)
    if not (certain and best.per_value[0] < c.rewired_noise):
        change += "; something else is wrong too: correct this, and diagnose again"
    return Rewired(remaining, certain, _sentence(mistakes, here, best, certain, change))


def _doubtful(fitter: Fitter, fit: Fit) -> bool:
    """Return whether the shapes differ from the model by more than their stated errors, or scatter visibly."""
    c = fitter.criteria.readings
    visible = (c.rewired_scatter / fitter.shape_scatter) ** 2
    parts = (
        (fitter.misfit(fit, SHAPE, stated=s), limit)
        for s, limit in ((True, c.rewired_misfit), (False, visible))
    )
    return any(degrees >= 1.0 and squares / degrees > limit for (squares, degrees), limit in parts)


def _sentence(
    mistakes: Sequence[Sequence[str]], here: WiringMisfit, best: WiringMisfit, certain: bool, change: str
) -> str:
    """Return what is wrong, how the misfit changes, and what to do."""
    size = (
        f"the shapes differ from the model by {plain(100 * here.difference, 2)} % of their largest component as in "
        f"the file, by {plain(100 * best.difference, 2)} % with this corrected"
    )
    named = [joined(equivalent, "or") for equivalent in mistakes[:MOST]]
    if len(mistakes) == 1:
        seems = "" if certain else "it seems that "
        same = " (for shapes, which have any sign, the same)" if len(mistakes[0]) > 1 else ""
        return f"{seems}{named[0]}{same}: {size}; {change}"
    if len(mistakes) > MOST:
        named.append(f"{len(mistakes) - MOST} others")
    return (
        "sensors are exchanged, reversed or turned, and these data do not tell which: "
        f"{'; '.join(named[:-1])}; or {named[-1]} ({size}); "
        "check cables and mountings, then correct the columns of the shapes"
    )
