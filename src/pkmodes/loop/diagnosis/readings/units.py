"""Frequencies in another unit than that of the header, converted twice, or periods."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.readings.comparison import ModelDistances, frequency_differences
from pkmodes.loop.measured.measurements import Measurements

#: Units in which frequencies are measured, and how many of each make 1 Hz.
UNITS = {unit: float(1 / frequency_factor(unit)) for unit in ("Hz", "rad/s", "1/min", "mHz", "kHz", "deg/s")}
#: Number of evenly spread setups from which the unit is determined.
MAX_SETUPS = 200
#: Units that are often converted to Hz twice.
UNITS_CONVERTED_TWICE = ("rad/s", "1/min")


@dataclass(frozen=True)
class FrequencyMeaning:
    """A meaning of the frequency column: factor times the value read as Hz, or factor over it for periods."""

    meaning: str
    remedy: str
    factor: float
    inverse: bool = False

    def applied_to(self, data: Measurements) -> Measurements:
        """Return the measurements in this unit."""
        frequency = self.factor / data.frequency if self.inverse else self.factor * data.frequency
        sigma = frequency * (data.sigma / data.frequency)
        return replace(data, numbers={**data.numbers, "frequency": frequency, "sigma": sigma}, band=None)


def other_meanings(unit: str) -> Iterator[FrequencyMeaning]:
    """Yield the other meanings of a frequency column whose header states a unit (Hz if empty)."""
    declared = float(1 / frequency_factor(unit)) if unit else 1.0
    for name, units_per_hz in UNITS.items():
        if abs(declared / units_per_hz - 1.0) > 1e-9:
            yield FrequencyMeaning(
                name, f"write frequency [{name}], and sigma in its own unit", declared / units_per_hz
            )
    # A period n was read as the frequency n / declared [Hz], but the frequency is 1 / n.
    yield FrequencyMeaning("periods in s", "write frequencies, 1 / period", 1.0 / declared, inverse=True)
    for name in UNITS_CONVERTED_TWICE:
        yield FrequencyMeaning(
            f"{name}, converted twice", f"multiply them by {plain(UNITS[name], 4)}", UNITS[name]
        )


def other_unit(fitter: Fitter) -> str:
    """The frequencies fit the declared model far better in another unit, or as periods."""
    c, count = fitter.criteria.readings, len(fitter.data.labels)
    sampled = sorted(set(np.linspace(0, count - 1, min(count, MAX_SETUPS)).astype(int).tolist()))
    declared, data = fitter.structure.subset(sampled).predict(fitter.declared, ()), fitter.data.at(sampled)

    def compare(reading: Measurements) -> tuple[float, float]:
        """Return the median difference, since the model may lack some modes, and the part of the rows paired."""
        distances, paired_part = frequency_differences(fitter, declared, reading)
        return float(np.median(np.abs(distances))), float(paired_part.mean())

    min_difference, paired_part, unit = min(
        ((*compare(unit.applied_to(data)), unit) for unit in other_meanings(data.unit)),
        key=lambda trial: trial[0],
    )
    distances = ModelDistances(compare(data)[0], min_difference)
    if paired_part < c.unit_paired or not distances.far_better(c.unit_gain, c.unit_difference):
        return ""
    claim = f"the header says {data.unit}, but the numbers" if data.unit else "the frequencies"
    return f"{claim} fit the declared model as {unit.meaning} ({plain(100 * min_difference, 2)} %): {unit.remedy}"
