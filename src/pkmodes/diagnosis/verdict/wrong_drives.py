"""Motors that were held although the measurements say free, or the reverse: noticed like a wrong unit.

Held motors change every frequency, and no cause is needed to explain that.  Where the declared model fits far better
with the other word, or only with it, and no single cause does better, that is what is reported.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import other_drives
from pkmodes.diagnosis.criteria import Criteria
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Hypothesis
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.match.pairing import Pairer
from pkmodes.diagnosis.problem import Array, Driven, Structure
from pkmodes.diagnosis.search.search import Search
from pkmodes.support.ordering import listed

#: Labels that the sentence lists.
MOST = 6


class _Apart(NamedTuple):
    """Mean differences of the logarithms of the frequencies: as the measurements say, and with the other drives."""

    here: float
    there: float

    @classmethod
    def of(cls, here: Array, there: Array, rows: NDArray[np.bool_]) -> _Apart:
        return cls(*(float(np.abs(each[rows]).mean()) for each in (here, there)))

    def clearly(self, c: Criteria) -> bool:
        """Return whether the other drives are far better."""
        return self.there <= c.readings.drives_difference and self.there * c.readings.drives_gain <= self.here

    @property
    def nearer(self) -> bool:
        """Return whether the other drives are nearer, perhaps by chance."""
        return 2.0 * self.there <= self.here


def seemingly_wrong_drives(fitter: Fitter) -> str:
    """Return a sentence if the frequencies of the declared model are far nearer with the other drives; empty if not.

    Nothing is fitted.
    """
    if not isinstance(fitter.structure, Driven):
        return ""
    for setups in _suspected(fitter):
        here, there = (_declared(fitter, one) for one in (fitter.structure, _other(fitter, setups)))
        apart = _Apart.of(here, there, np.isin(fitter.data.pose, setups))
        if apart.clearly(fitter.criteria):
            return _sentence(fitter, setups, apart)
    return ""


def wrong_drives(plain: FitStore) -> str:
    """Return a sentence if the motors seem to have done something else than the measurements say; empty if not.

    Parameters
    ----------
    plain : FitStore
        Of the structure at the fitted setups, as declared.
    """
    fitter, c = plain.fitter, plain.fitter.criteria
    first = plain.fit(Hypothesis())
    if not isinstance(fitter.structure, Driven) or (
        first is not None and plain.p_value(first) > c.gate.surely
    ):
        return ""
    for setups in _suspected(fitter):
        other = FitStore(Fitter(_other(fitter, setups), fitter.data, c, fitter.shape_scatter))
        fit = other.fit(Hypothesis())
        if fit is None:
            continue
        explains, rows = other.p_value(fit) > c.gate.level, np.isin(fitter.data.pose, setups)
        here = _declared(fitter, fitter.structure) if first is None else first.residual[fitter.frequency_rows]
        apart = _Apart.of(here, fit.residual[fitter.frequency_rows], rows)
        if explains or apart.clearly(c):
            # What holds the motors a little, or makes them heavy, is a cause, and nearly the same.
            singles = Search(plain, fitter.structure.candidates).additions.would_do()
            least = min((plain.criterion(single) for single in singles), default=np.inf)
            if other.criterion(fit) <= least + (c.search.survives if explains else 0.0):
                return _sentence(fitter, setups, None if explains else apart)
    return ""


def _suspected(fitter: Fitter) -> list[list[int]]:
    """Return all setups, and those whose declared frequencies are nearer with the motors doing something else."""
    data, every = fitter.data, list(range(len(fitter.data.labels)))
    here, there = (_declared(fitter, one) for one in (fitter.structure, _other(fitter, every)))
    some = [k for k in every if _Apart.of(here, there, data.pose == k).nearer]
    enough = np.isin(data.pose, some).sum() >= fitter.criteria.readings.drives_rows
    return [every, some] if enough and some != every else [every]


def _other(fitter: Fitter, setups: Sequence[int]) -> Structure:
    assert isinstance(fitter.structure, Driven)
    return fitter.structure.with_other_drives(setups)


def _declared(fitter: Fitter, structure: Structure) -> Array:
    """Return the differences of the logarithms of the frequencies, measured and declared; infinite without modes."""
    data = fitter.data
    prediction = structure.predict(fitter.declared, ())
    if not np.isfinite(prediction.eigenvalues).all():
        return np.full(len(data.frequency), np.inf)
    pairer = Pairer(data, structure.channels, prediction, fitter.criteria)
    pairing = pairer.pair(prediction, np.ones(len(data.frequency), dtype=bool), compare=False)
    return pairer.differences(prediction, pairing)


def _sentence(fitter: Fitter, setups: Sequence[int], apart: _Apart | None) -> str:
    """Return what was noticed, and what to write.

    Parameters
    ----------
    apart : _Apart, optional
        How much nearer the frequencies are; None if the declared model explains them.
    """
    data = fitter.data
    words = {data.drives[k] for k in setups}
    fits, size = "are explained by the declared model", ""
    if apart is not None:
        fits = "fit the declared model far better"
        size = f" ({100 * apart.there:.2g} % instead of {100 * apart.here:.2g} %)"
    if len(words) > 1:
        return f"the frequencies {fits} with free and held exchanged{size}: correct drives"
    every = len(setups) == len(data.labels)
    of = "" if every else f" at {listed([data.labels[k] for k in setups], MOST)}"
    (word,) = words
    says, than = other_drives(word), ", not" if apart is None else " than"
    remedy = f"write # drives: {says}, or --drives {says}" if every else f"write {says} in the column drives"
    return (
        f"the frequencies{of} {fits} with motors {says}{than} with motors {word}{size}: "
        f"if they were {says}, {remedy}"
    )
