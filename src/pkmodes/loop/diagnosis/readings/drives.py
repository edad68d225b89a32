"""Motors that were held although the file declares them free, or the reverse.

Held motors change every frequency, and no cause is needed to explain that.  The mistake is reported if the declared
model fits far better, or fits only, with the motors in the other state, and no single cause does better.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from pkmodes.core.base.drives import other_drives
from pkmodes.core.base.numbers import plain
from pkmodes.core.support.ordering import listed
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array, Driven
from pkmodes.loop.diagnosis.readings.comparison import ModelDistances, frequency_differences
from pkmodes.loop.diagnosis.search.search import Search

#: Largest number of labels listed in the sentence.
MAX_LABELS = 6
#: The other state is tried at some setups if it brings their declared frequencies nearer by this factor, perhaps by
#: chance.
MIN_GAIN_TO_TRY = 2.0


def other_drives_as_declared(fitter: Fitter) -> str:
    """The declared frequencies are far nearer with motors held instead of free, or free instead of held."""
    c = fitter.criteria.readings
    for setups, distances in _suspected_setups(fitter).items():
        if distances.far_better(c.drives_gain, c.drives_difference):
            return _sentence(fitter, setups, distances)
    return ""


def other_drives_refitted(store: FitStore) -> str:
    """The frequencies fit far better, or fit only, with motors held instead of free, or free instead of held."""
    fitter, c, structure = store.fitter, store.fitter.criteria, store.fitter.structure
    declared_fit = store.fit(Hypothesis())
    if not isinstance(structure, Driven) or (
        declared_fit is not None and store.p_value(declared_fit) > c.gate.surely
    ):
        return ""
    for setups, declared_distances in _suspected_setups(fitter).items():
        other_store = FitStore(
            Fitter(structure.with_other_drives(setups), fitter.data, c, fitter.shape_scatter)
        )
        fit = other_store.fit(Hypothesis())
        if fit is None:
            continue
        is_explained = other_store.p_value(fit) > c.gate.level
        other_distance = _mean_difference(fitter, setups, fit.residual)
        distance = declared_distances.as_filed
        if declared_fit is not None:
            distance = _mean_difference(fitter, setups, declared_fit.residual)
        distances = ModelDistances(distance, other_distance)
        if is_explained or distances.far_better(c.readings.drives_gain, c.readings.drives_difference):
            # A cause that holds the motors weakly, or makes them heavy, has nearly the same effect.
            single_causes = Search(store, structure.candidates).additions.sufficient_causes()
            lowest_criterion = min(
                (store.criterion(fit_of_cause) for fit_of_cause in single_causes), default=np.inf
            )
            if other_store.criterion(fit) <= lowest_criterion + (c.search.survives if is_explained else 0.0):
                return _sentence(fitter, setups, None if is_explained else distances)
    return ""


def _suspected_setups(fitter: Fitter) -> dict[tuple[int, ...], ModelDistances]:
    """Return all setups, and those whose declared frequencies are nearer with the motors in the other state."""
    structure, data, all_setups = fitter.structure, fitter.data, tuple(range(len(fitter.data.labels)))
    if not isinstance(structure, Driven):
        return {}
    predictions = (
        variant.predict(fitter.declared, ())
        for variant in (structure, structure.with_other_drives(all_setups))
    )
    as_filed, switched = (frequency_differences(fitter, prediction, data)[0] for prediction in predictions)

    def distances_at(setups: Sequence[int]) -> ModelDistances:
        return ModelDistances(
            _mean_difference(fitter, setups, as_filed), _mean_difference(fitter, setups, switched)
        )

    means = (
        np.bincount(data.pose, np.abs(difference)) / np.bincount(data.pose)
        for difference in (as_filed, switched)
    )
    nearer_setups = tuple(
        k
        for k, pair in enumerate(zip(*means, strict=True))
        if ModelDistances(*map(float, pair)).far_better(MIN_GAIN_TO_TRY)
    )
    has_enough_rows = np.isin(data.pose, nearer_setups).sum() >= fitter.criteria.readings.drives_rows
    return {
        setups: distances_at(setups)
        for setups in ((all_setups, nearer_setups) if has_enough_rows else (all_setups,))
    }


def _mean_difference(fitter: Fitter, setups: Sequence[int], residual: Array) -> float:
    """Return the mean difference of the frequencies at some setups."""
    return float(
        np.abs(residual[fitter.observations.frequency_slice][np.isin(fitter.data.pose, setups)]).mean()
    )


def _sentence(fitter: Fitter, setups: Sequence[int], distances: ModelDistances | None) -> str:
    """Return the finding, and what to write in the file.

    - distances: distances of the frequencies; None if the declared model explains them in the other state
    """
    data = fitter.data
    states = {data.drives[k] for k in setups}
    predicate, sizes = "are explained by the declared model", ""
    if distances is not None:
        predicate = "fit the declared model far better"
        sizes = f" ({plain(100 * distances.other_reading, 2)} % instead of {plain(100 * distances.as_filed, 2)} %)"
    if len(states) > 1:
        return f"the frequencies {predicate} with free and held exchanged{sizes}: correct drives"
    at_all_setups = len(setups) == len(data.labels)
    location = "" if at_all_setups else f" at {listed([data.labels[k] for k in setups], MAX_LABELS)}"
    (state,) = states
    other_state, comparison = other_drives(state), ", not" if distances is None else " than"
    remedy = (
        f"write # drives: {other_state}, or --drives {other_state}"
        if at_all_setups
        else f"write {other_state} in the column drives"
    )
    return (
        f"the frequencies{location} {predicate} with motors {other_state}{comparison} with motors {state}{sizes}: "
        f"if they were {other_state}, {remedy}"
    )
