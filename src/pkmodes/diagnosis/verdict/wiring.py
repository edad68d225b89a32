"""Sensors wired or mounted otherwise than the file says.

If the shapes disagree with the model, every wiring that a single mistake gives is tried, each with the modes paired
anew (`rewired`).  A mistake is reported if some wiring fits far better than the file's; it is named if no other
wiring fits nearly as well.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.match.mounting import described, remedy, simplicity, words
from pkmodes.diagnosis.match.wirings import Wiring, as_in_file, wirings
from pkmodes.diagnosis.problem import Instrumented, Sensor
from pkmodes.diagnosis.verdict.rewired import Misfit, misfits, promising

#: Largest number of wirings that a sentence names.
MOST = 4


@dataclass(frozen=True)
class Rewired:
    """Wirings that fit far better than that of the file.

    Attributes
    ----------
    wirings : tuple of Wiring
        Up to the sign of all columns, the best one first.
    mistakes : tuple of tuple of str
        For each of them, the mistakes that give it, which shapes cannot tell apart.
    change : str
        What to change in the file for the first one.
    before, after : Misfit
        As in the file, and with the best wiring.
    certain : bool
        Whether the best one brings the shapes near to the errors of the measurement.
    explained : bool
        Whether it does so with the frequencies too.
    hint : str
        What else to check.
    """

    wirings: tuple[Wiring, ...]
    mistakes: tuple[tuple[str, ...], ...]
    change: str
    before: Misfit
    after: Misfit
    certain: bool
    explained: bool
    hint: str = ""

    @property
    def sentence(self) -> str:
        """What is wrong, how the misfit changes, and what to do."""
        size = (
            f"the shapes differ from the model by {_percent(self.before)} of their largest component as in the file, "
            f"by {_percent(self.after)} with this corrected"
        )
        some = [words(mistakes, "or") for mistakes in self.mistakes[:MOST]]
        if len(self.mistakes) == 1:
            seems = "" if self.certain else "it seems that "
            also = "" if self.explained else "; something else is wrong too: correct this, and diagnose again"
            same = " (for shapes, which have any sign, the same)" if len(self.mistakes[0]) > 1 else ""
            return f"{seems}{some[0]}{same}: {size}; {self.change}{self.hint}{also}"
        if len(self.mistakes) > MOST:
            some.append(f"{len(self.mistakes) - MOST} others")
        return (
            "sensors are exchanged, reversed or turned, and these data do not tell which: "
            f"{'; '.join(some[:-1])}; or {some[-1]} ({size}); "
            "check cables and mountings, then correct the columns of the shapes"
        )


def rewired(fitter: Fitter, fit: Fit) -> Rewired | None:
    """Return the wirings that fit far better than that of the file; None if there is none.

    Parameters
    ----------
    fit : Fit
        Of the file as it is.
    """
    if not _doubtful(fitter, fit):
        return None
    c, columns = fitter.criteria, fitter.data.channels
    sensors = tuple(fitter.structure.sensors) if isinstance(fitter.structure, Instrumented) else ()
    tried = wirings(columns, sensors)
    if not tried or not promising(fitter, fit, tuple(tried), c.rewired_perhaps):
        return None
    found = misfits(fitter, fit, tuple(tried), c.rewired_refits, c.rewired_near)
    here = found.pop(as_in_file(columns))
    complete = min(misfit.per_value[0] for misfit in (here, *found.values())) < c.rewired_noise
    evidence = {wiring: misfit.evidence(complete) for wiring, misfit in found.items()}
    order = sorted(evidence, key=evidence.__getitem__)
    best = found[order[0]]
    gain = here.evidence(complete) - evidence[order[0]]
    if here.shapes < c.rewired * best.shapes or gain < c.rewired_certain:
        return None
    remaining = [w for w in order if evidence[w] - evidence[order[0]] < c.rewired_told_apart]
    mistakes = tuple(_mistakes(tried[wiring], columns, sensors) for wiring in remaining)
    certain = best.per_value[1] < c.rewired_noise and best.difference < c.most_shape_scatter / 2.0
    simplest = min(tried[order[0]], key=lambda wiring: simplicity(wiring, columns))
    return Rewired(
        tuple(remaining),
        mistakes,
        remedy(simplest, columns),
        here,
        best,
        certain,
        certain and best.per_value[0] < c.rewired_noise,
        _hint(simplest, columns, sensors) if len(remaining) == 1 else "",
    )


def _mistakes(same: Sequence[Wiring], columns: Sequence[str], sensors: Sequence[Sensor]) -> tuple[str, ...]:
    """Return what is wrong: the simplest of several mistakes that shapes cannot tell apart, and turned sensors."""
    first, *others = sorted(same, key=lambda wiring: simplicity(wiring, columns))
    texts = [described(first, columns, sensors)]
    texts += [text for other in others if " is turned by " in (text := described(other, columns, sensors))]
    return tuple(texts)


def _doubtful(fitter: Fitter, fit: Fit) -> bool:
    """Return whether the shapes differ from the model by more than their stated errors, or visibly."""
    for stated, most in ((True, fitter.criteria.rewired_misfit), (False, None)):
        squares, degrees = fitter.shape_misfit(fit, stated=stated)
        if degrees < 1.0:
            continue
        ratio = squares / degrees
        visible = (fitter.criteria.rewired_scatter / fitter.shape_scatter) ** 2
        if ratio > (visible if most is None else most):
            return True
    return False


def _hint(wiring: Wiring, columns: Sequence[str], sensors: Sequence[Sensor]) -> str:
    """Return what else to check if one axis of a sensor is reversed."""
    if wiring.channels != tuple(columns) or sum(np.array(wiring.signs) < 0) != 1:
        return ""
    name = columns[wiring.signs.index(-1)]
    for sensor in sensors:
        if name in sensor.channels and sensor.place:
            axis = sensor.axes[sensor.channels.index(name)]
            return f", or check the sensor's direction and the sign of {axis} in the poses"
    return ", or check the sensor's direction"


def _percent(misfit: Misfit) -> str:
    return f"{100 * misfit.difference:.2g} %"
