"""Round numbers near fitted values, and the probability that they match by chance."""

from __future__ import annotations

import itertools
from dataclasses import dataclass

#: A round number must be within this many standard errors.
WITHIN = 3.0
#: Roundness in descending order: multiples of 500, 250, 100, 50, 25, 10, 5, 2.5, 1, 0.5 ... [mm].
GRAINS = tuple(m * 10.0**e for e, m in itertools.product(range(2, -6, -1), (5.0, 2.5, 1.0)))


@dataclass(frozen=True)
class Round:
    """The roundest number within the errors of a value, all in the unit of the value.

    Attributes
    ----------
    value : float
    grain : float
        The value is a multiple of this.
    chance : float
        Probability that a random value is as close to an equally round number.
    """

    value: float
    grain: float
    chance: float


def roundest(value: float, sigma: float) -> Round:
    """Find the roundest number within the errors.

    Parameters
    ----------
    value, sigma : float
        In millimetres, the unit in which a person would have rounded.
    """
    for grain in GRAINS:
        nearest = round(value / grain) * grain
        if abs(nearest - value) <= WITHIN * sigma:
            break
    return Round(nearest, grain, min(1.0, 2.0 * WITHIN * sigma / grain))
