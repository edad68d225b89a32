"""Motors that were held although the measurements say free, or the reverse.

Held motors change every frequency, and no cause is needed to explain that.  It is reported if the declared model fits
far better, or only, with the motors in the other state, and no single cause does better.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.drives import other_drives as other
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import listed
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array, Driven
from pkmodes.loop.diagnosis.readings.comparison import Apart, differences
from pkmodes.loop.diagnosis.search.search import Search

#: Largest number of labels listed in the sentence.
MOST = 6
#: The other state is tried at some setups if it brings their declared frequencies nearer by this factor, perhaps by
#: chance.
PERHAPS = 2.0


def nearer_drives(fitter: Fitter) -> str:
    """The declared frequencies are far nearer with motors held instead of free, or free instead of held."""
    c = fitter.criteria.readings
    for setups, apart in _suspected(fitter).items():
        if apart.far_better(c.drives_gain, c.drives_difference):
            return _sentence(fitter, setups, apart)
    return ""


def other_drives(plain: FitStore) -> str:
    """The frequencies fit far better, or fit only, with motors held instead of free, or free instead of held."""
    fitter, c, structure = plain.fitter, plain.fitter.criteria, plain.fitter.structure
    first = plain.fit(Hypothesis())
    if not isinstance(structure, Driven) or (first is not None and plain.p_value(first) > c.gate.surely):
        return ""
    for setups, declared in _suspected(fitter).items():
        store = FitStore(Fitter(structure.with_other_drives(setups), fitter.data, c, fitter.shape_scatter))
        fit = store.fit(Hypothesis())
        if fit is None:
            continue
        explains = store.p_value(fit) > c.gate.level
        there = _mean(fitter, setups, fit.residual)
        apart = Apart(declared.here if first is None else _mean(fitter, setups, first.residual), there)
        if explains or apart.far_better(c.readings.drives_gain, c.readings.drives_difference):
            # A cause that holds the motors weakly, or makes them heavy, has nearly the same effect.
            singles = Search(plain, structure.candidates).additions.would_do()
            least = min((plain.criterion(single) for single in singles), default=np.inf)
            if store.criterion(fit) <= least + (c.search.survives if explains else 0.0):
                return _sentence(fitter, setups, None if explains else apart)
    return ""


def _suspected(fitter: Fitter) -> dict[tuple[int, ...], Apart]:
    """Return all setups, and those whose declared frequencies are nearer with the motors in the other state."""
    structure, data, all_setups = fitter.structure, fitter.data, tuple(range(len(fitter.data.labels)))
    if not isinstance(structure, Driven):
        return {}
    predictions = (
        variant.predict(fitter.declared, ())
        for variant in (structure, structure.with_other_drives(all_setups))
    )
    here, there = (differences(fitter, prediction, data)[0] for prediction in predictions)

    def apart(setups: Sequence[int]) -> Apart:
        return Apart(_mean(fitter, setups, here), _mean(fitter, setups, there))

    means = (
        np.bincount(data.pose, np.abs(difference)) / np.bincount(data.pose) for difference in (here, there)
    )
    nearer = tuple(
        k for k, pair in enumerate(zip(*means, strict=True)) if Apart(*map(float, pair)).far_better(PERHAPS)
    )
    enough = np.isin(data.pose, nearer).sum() >= fitter.criteria.readings.drives_rows
    return {setups: apart(setups) for setups in ((all_setups, nearer) if enough else (all_setups,))}


def _mean(fitter: Fitter, setups: Sequence[int], residual: Array) -> float:
    """Return the mean difference of the frequencies at some setups."""
    return float(
        np.abs(residual[fitter.observations.frequency_rows][np.isin(fitter.data.pose, setups)]).mean()
    )


def _sentence(fitter: Fitter, setups: Sequence[int], apart: Apart | None) -> str:
    """Return the finding, and what to write in the file.

    - apart: distances of the frequencies; None if the declared model explains them in the other state
    """
    data = fitter.data
    words = {data.drives[k] for k in setups}
    fits, size = "are explained by the declared model", ""
    if apart is not None:
        fits = "fit the declared model far better"
        size = f" ({plain(100 * apart.there, 2)} % instead of {plain(100 * apart.here, 2)} %)"
    if len(words) > 1:
        return f"the frequencies {fits} with free and held exchanged{size}: correct drives"
    everywhere = len(setups) == len(data.labels)
    of = "" if everywhere else f" at {listed([data.labels[k] for k in setups], MOST)}"
    (word,) = words
    says, than = other(word), ", not" if apart is None else " than"
    remedy = (
        f"write # drives: {says}, or --drives {says}" if everywhere else f"write {says} in the column drives"
    )
    return (
        f"the frequencies{of} {fits} with motors {says}{than} with motors {word}{size}: "
        f"if they were {says}, {remedy}"
    )
