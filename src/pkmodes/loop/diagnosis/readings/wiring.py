"""Sensors wired or mounted differently from the file, or not connected.

If the shapes disagree with the model, every wiring that a single mistake gives is tried, each with the modes paired
anew (`misfits_by_wiring`).  A mistake is reported if some wiring fits far better than the file's; it is named if no
other wiring fits nearly as well.
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
from pkmodes.loop.diagnosis.readings.comparison import ModelDistances
from pkmodes.loop.diagnosis.readings.misfits import WiringMisfit, is_rewiring_promising, misfits_by_wiring
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
MAX_WIRINGS_NAMED = 4


class BetterWirings(NamedTuple):
    """Wirings that fit far better than that of the file, up to the sign of all columns, the best one first.

    - certain: whether the best one brings the shapes near to the errors of the measurement
    """

    wirings: list[Wiring]
    certain: bool
    sentence: str


def certain_wiring(store: FitStore) -> str:
    """Another wiring of the sensors brings the shapes near to their errors."""
    fitter, fit = store.fitter, store.fit(Hypothesis())
    rewiring = None if fit is None or dead_channels(fitter, fit) else find_better_wirings(fitter, fit)
    return rewiring.sentence if rewiring is not None and rewiring.certain else ""


def other_wiring(fitter: Fitter, fit: Fit) -> str:
    """The shapes fit far better with another wiring of the sensors."""
    rewiring = find_better_wirings(fitter, fit)
    return "" if rewiring is None else rewiring.sentence


def dead_channels(fitter: Fitter, fit: Fit) -> str:
    """A channel is exactly 0 in every row although the model clearly moves it in some."""
    if not fitter.observations.shapes.known.any():
        return ""
    data, pairing = fitter.data, fit.pairing
    rows_with_shape = (pairing.partner >= 0) & np.nan_to_num(data.shapes).any(axis=1)
    measured = np.isfinite(data.shapes) & rows_with_shape[:, None]
    columns = fitter.observations.pairer.columns
    model = np.abs(fit.prediction.shapes[data.pose, np.maximum(pairing.partner, 0)][:, columns])
    units = np.array([fitter.structure.channel_units[i] for i in columns])
    min_motion, min_share = fitter.criteria.readings.dead
    dead_names = []
    for k, name in enumerate(data.channels):
        rows = measured[:, k]
        if not rows.any() or np.nan_to_num(data.shapes[:, k]).any():
            continue
        max_motions = np.where(measured & (units == units[k]), model, 0.0).max(axis=1)
        if (model[rows, k] > min_motion * max_motions[rows]).mean() >= min_share and max_motions[rows].any():
            dead_names.append(name)
    if len(dead_names) == 1:
        return f"channel {dead_names[0]} is 0 in every row: is the sensor connected? If not, leave the column out"
    predicate = "are 0 in every row: are the sensors connected? If not, leave the columns out"
    return f"channels {', '.join(dead_names)} {predicate}" if dead_names else ""


def find_better_wirings(fitter: Fitter, fit: Fit) -> BetterWirings | None:
    """Return the wirings that fit far better than that of the file; None if there is none.

    - fit: fit with the wiring of the file
    """
    c, columns = fitter.criteria.readings, fitter.data.channels
    sensors = tuple(fitter.structure.sensors) if isinstance(fitter.structure, Instrumented) else ()
    mistakes_by_wiring = wirings(columns, sensors) if _shapes_disagree(fitter, fit) else {}
    if not mistakes_by_wiring or not is_rewiring_promising(fitter, fit, tuple(mistakes_by_wiring)):
        return None
    by_wiring = misfits_by_wiring(fitter, fit, tuple(mistakes_by_wiring))
    as_filed = by_wiring.pop(as_in_file(columns))
    model_is_complete = (
        min(misfit.squares_per_value[0] for misfit in (as_filed, *by_wiring.values())) < c.rewired_noise
    )
    deviance = {wiring: misfit.deviance(model_is_complete) for wiring, misfit in by_wiring.items()}
    ranked = sorted(deviance, key=deviance.__getitem__)
    min_deviance, best_misfit = deviance[ranked[0]], by_wiring[ranked[0]]
    is_far_better = ModelDistances(as_filed.shape_squares, best_misfit.shape_squares).far_better(c.rewired)
    if not is_far_better or as_filed.deviance(model_is_complete) - min_deviance < c.rewired_certain:
        return None
    remaining_wirings = [w for w in ranked if deviance[w] - min_deviance < c.rewired_told_apart]
    certain = (
        best_misfit.squares_per_value[1] < c.rewired_noise
        and best_misfit.difference < fitter.criteria.shapes.most_scatter / 2.0
    )
    mistakes = []
    for wiring in remaining_wirings:
        # The simplest of several mistakes that shapes cannot tell apart, and turned sensors.
        equivalent_mistakes = sorted(
            mistakes_by_wiring[wiring], key=lambda mistake: simplicity(mistake, columns)
        )
        first, *alternatives = (wiring_in_words(mistake, columns, sensors) for mistake in equivalent_mistakes)
        mistakes.append([first, *(text for text in alternatives if " is turned by " in text)])
    simplest = min(mistakes_by_wiring[ranked[0]], key=lambda wiring: simplicity(wiring, columns))
    change = remedy(simplest, columns) + hint(simplest, columns, sensors)
    if not (certain and best_misfit.squares_per_value[0] < c.rewired_noise):
        change += "; something else is wrong too: correct this, and diagnose again"
    return BetterWirings(
        remaining_wirings, certain, _sentence(mistakes, as_filed, best_misfit, certain, change)
    )


def _shapes_disagree(fitter: Fitter, fit: Fit) -> bool:
    """Return whether the shapes differ from the model by more than their stated errors, or scatter visibly."""
    c = fitter.criteria.readings
    max_visible_misfit = (c.rewired_scatter / fitter.shape_scatter) ** 2
    parts = (
        (fitter.misfit(fit, SHAPE, stated=stated), limit)
        for stated, limit in ((True, c.rewired_misfit), (False, max_visible_misfit))
    )
    return any(degrees >= 1.0 and squares / degrees > limit for (squares, degrees), limit in parts)


def _sentence(
    mistakes: Sequence[Sequence[str]],
    as_filed: WiringMisfit,
    best: WiringMisfit,
    certain: bool,
    instruction: str,
) -> str:
    """Return what is wrong, how the misfit changes, and what to do."""
    sizes = (
        f"the shapes differ from the model by {plain(100 * as_filed.difference, 2)} % of their largest component as "
        f"in the file, by {plain(100 * best.difference, 2)} % with this corrected"
    )
    descriptions = [joined(equivalent, "or") for equivalent in mistakes[:MAX_WIRINGS_NAMED]]
    if len(mistakes) == 1:
        prefix = "" if certain else "it seems that "
        remark = " (for shapes, which have any sign, the same)" if len(mistakes[0]) > 1 else ""
        return f"{prefix}{descriptions[0]}{remark}: {sizes}; {instruction}"
    if len(mistakes) > MAX_WIRINGS_NAMED:
        descriptions.append(f"{len(mistakes) - MAX_WIRINGS_NAMED} others")
    return (
        "sensors are exchanged, reversed or turned, and these data do not tell which: "
        f"{'; '.join(descriptions[:-1])}; or {descriptions[-1]} ({sizes}); "
        "check cables and mountings, then correct the columns of the shapes"
    )
