"""Frequencies in another unit than that of the header, converted twice, or periods."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.columns import frequency_factor
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.readings.comparison import Apart, differences
from pkmodes.loop.measured.measurements import Measurements

#: Units in which frequencies are measured, and how many of each make 1 Hz.
UNITS = {unit: float(1 / frequency_factor(unit)) for unit in ("Hz", "rad/s", "1/min", "mHz", "kHz", "deg/s")}
#: Number of evenly spread setups from which the unit is determined.
ENOUGH = 200
#: Units that are often converted to Hz twice.
TWICE = ("rad/s", "1/min")


@dataclass(frozen=True)
class Unit:
    """A meaning of the frequency column: factor times the value read as Hz, or factor over it for periods."""

    meaning: str
    remedy: str
    factor: float
    inverse: bool = False

    def of(self, data: Measurements) -> Measurements:
        """Return the measurements in this unit."""
        frequency = self.factor / data.frequency if self.inverse else self.factor * data.frequency
        sigma = frequency * (data.sigma / data.frequency)
        return replace(data, numbers={**data.numbers, "frequency": frequency, "sigma": sigma}, band=None)


def others(unit: str) -> Iterator[Unit]:
    """Yield the other meanings of a frequency column whose header states a unit (Hz if empty)."""
    declared = float(1 / frequency_factor(unit)) if unit else 1.0
    for name, times in UNITS.items():
        if abs(declared / times - 1.0) > 1e-9:
            yield Unit(name, f"write frequency [{name}], and sigma in its own unit", declared / times)
    # A period n was read as the frequency n / declared [Hz], but the frequency is 1 / n.
    yield Unit("periods in s", "write frequencies, 1 / period", 1.0 / declared, inverse=True)
    for name in TWICE:
        yield Unit(f"{name}, converted twice", f"multiply them by {plain(UNITS[name], 4)}", UNITS[name])


def other_unit(fitter: Fitter) -> str:
    """The frequencies fit the declared model far better in another unit, or as periods."""
    c, count = fitter.criteria.readings, len(fitter.data.labels)
    sampled = sorted(set(np.linspace(0, count - 1, min(count, ENOUGH)).astype(int).tolist()))
    declared, data = fitter.structure.subset(sampled).predict(fitter.declared, ()), fitter.data.at(sampled)

    def usual(reading: Measurements) -> tuple[float, float]:
        """Return the median difference, since the model may lack some modes, and the part of the rows paired."""
        apart, paired = differences(fitter, declared, reading)
        return float(np.median(np.abs(apart))), float(paired.mean())

    there, paired, unit = min(
        ((*usual(unit.of(data)), unit) for unit in others(data.unit)), key=lambda trial: trial[0]
    )
    apart = Apart(usual(data)[0], there)
    if paired < c.unit_paired or not apart.far_better(c.unit_gain, c.unit_difference):
        return ""
    claim = f"the header says {data.unit}, but the numbers" if data.unit else "the frequencies"
    return f"{claim} fit the declared model as {unit.meaning} ({plain(100 * there, 2)} %): {unit.remedy}"
