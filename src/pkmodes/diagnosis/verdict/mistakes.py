"""Experimenter's mistakes visible in the data: wrong unit, exchanged or dead sensors, identical shapes."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from pkmodes.core.robot.columns import frequency_factor
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.match.pairing import Pairer
from pkmodes.diagnosis.problem import Array, Prediction
from pkmodes.diagnosis.verdict.wiring import rewired
from pkmodes.measured.measurements import Measurements
from pkmodes.support.mac import mac

#: Units in which frequencies are measured, each with its number per Hz.
UNITS = {unit: float(1 / frequency_factor(unit)) for unit in ("Hz", "rad/s", "1/min", "mHz", "kHz", "deg/s")}
#: Number of evenly spread setups from which the unit is determined.
ENOUGH = 200
#: Units that are often converted to Hz twice.
TWICE = ("rad/s", "1/min")


@dataclass(frozen=True)
class Reading:
    """Another reading of the frequency column: factor times the value read as Hz, or factor over it for periods."""

    what: str
    remedy: str
    factor: float
    inverse: bool = False

    def of(self, data: Measurements) -> Measurements:
        """Return the measurements with this reading."""
        frequency = self.factor / data.frequency if self.inverse else self.factor * data.frequency
        sigma = frequency * (data.sigma / data.frequency)
        return replace(data, numbers={**data.numbers, "frequency": frequency, "sigma": sigma}, band=None)


def readings(unit: str) -> list[Reading]:
    """Return the other readings of a frequency column whose header states a unit (Hz if empty)."""
    declared = float(1 / frequency_factor(unit)) if unit else 1.0
    others = [
        Reading(name, f"write frequency [{name}], and sigma in its own unit", declared / times)
        for name, times in UNITS.items()
        if abs(declared / times - 1.0) > 1e-9
    ]
    # A period n was read as n / said Hz, and 1 / n is the frequency.
    others.append(Reading("periods in s", "write frequencies, 1 / period", 1.0 / declared, inverse=True))
    others += [
        Reading(
            f"{name}, converted twice",
            f"multiply them by {UNITS[name]:.4g}",
            UNITS[name],
        )
        for name in TWICE
    ]
    return others


def other_unit(fitter: Fitter) -> str:
    """Return a sentence if all frequencies seem to be in another unit; empty if not."""
    count = len(fitter.data.labels)
    some = sorted(set(np.linspace(0, count - 1, min(count, ENOUGH)).astype(int).tolist()))
    structure, data = fitter.structure.subset(some), fitter.data.at(some)
    declared = structure.predict(fitter.declared, ())
    if not np.isfinite(declared.eigenvalues).all():
        return ""
    c = fitter.criteria
    here, _ = _usual(fitter, declared, data)
    others = [(*_usual(fitter, declared, reading.of(data)), reading) for reading in readings(data.unit)]
    least, paired, reading = min(others, key=lambda other: other[0])
    if (
        least > c.readings.unit_difference
        or least * c.readings.unit_gain > here
        or paired < c.readings.unit_paired
    ):
        return ""
    claim = f"the header says {data.unit}, but the numbers" if data.unit else "the frequencies"
    return f"{claim} fit the declared model as {reading.what} ({100 * least:.2g} %): {reading.remedy}"


def _usual(fitter: Fitter, prediction: Prediction, data: Measurements) -> tuple[float, float]:
    """Return the median difference between measured and model frequencies, and the part of the rows with a partner.

    The model may lack some modes.
    """
    pairer = Pairer(data, fitter.structure.channels, prediction, fitter.criteria)
    pairing = pairer.pair(prediction, np.ones(len(data.frequency), dtype=bool), compare=False)
    usual = float(np.median(np.abs(pairer.differences(prediction, pairing))))
    return usual, float((pairing.partner >= 0).mean())


def other_wiring(fitter: Fitter, fit: Fit) -> str:
    """Return a sentence on a dead channel, or on shapes that fit far better with another wiring of the sensors."""
    if not fitter.shapes.known.any():
        return ""
    dead = dead_channels(fitter, fit)
    if dead:
        if len(dead) == 1:
            return (
                f"channel {dead[0]} is 0 in every row: is the sensor connected? If not, leave the column out"
            )
        return (
            f"channels {', '.join(dead)} are 0 in every row: are the sensors connected? "
            "If not, leave the columns out"
        )
    found = rewired(fitter, fit)
    return "" if found is None else found.sentence


def certain_wiring(fitter: Fitter, fit: Fit) -> str:
    """Return a sentence if another wiring brings the shapes near to their errors; empty if not.

    Parameters
    ----------
    fit : Fit
        Of the declared model with its nuisances.
    """
    if not fitter.shapes.known.any() or dead_channels(fitter, fit):
        return ""
    found = rewired(fitter, fit)
    return "" if found is None or not found.certain else found.sentence


def dead_channels(fitter: Fitter, fit: Fit) -> list[str]:
    """Return the channels that are exactly 0 in every row although the model clearly moves them in some."""
    data, pairing = fitter.data, fit.pairing
    shaped = (pairing.partner >= 0) & np.nan_to_num(data.shapes).any(axis=1)
    measured = np.isfinite(data.shapes) & shaped[:, None]
    model = np.abs(fit.prediction.shapes[data.pose, np.maximum(pairing.partner, 0)][:, fitter.pairer.columns])
    units = np.array([fitter.structure.channel_units[i] for i in fitter.pairer.columns])
    moved, some = fitter.criteria.readings.dead
    dead = []
    for k, name in enumerate(data.channels):
        rows = measured[:, k]
        if not rows.any() or np.nan_to_num(data.shapes[:, k]).any():
            continue
        alike = np.where(measured & (units == units[k]), model, 0.0).max(axis=1)
        if (model[rows, k] > moved * alike[rows]).mean() >= some and alike[rows].any():
            dead.append(name)
    return dead


def all_alike(data: Measurements, same: float) -> tuple[str, ...]:
    """Return the labels of setups with three or more shapes whose mutual MAC is always above a limit."""
    labels = []
    for setup, label in enumerate(data.labels):
        shapes = data.shapes[data.pose == setup]
        common = np.isfinite(shapes).all(axis=0)
        some: Array = shapes[:, common]
        if len(some) < 3 or common.sum() < 2:
            continue
        largest = np.abs(some).max(axis=1, keepdims=True)  # shapes have any scale
        some = some / np.where(largest > 0.0, largest, 1.0)
        if mac(some, some, np.ones(some.shape, dtype=bool)).min() > same:
            labels.append(label)
    return tuple(labels)
