"""Measurements whose errors are scaled."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.measured.quantities import QUANTITIES, SHAPE_SIGMA


def with_errors(data: Measurements, factor: float) -> Measurements:
    """Return measurements whose standard deviations are a multiple of the stated ones.

    A standard deviation outside the range that a file may state is set to the nearest end of that range.

    - factor: multiple for the standard deviations of all quantities, of shapes and of positions
    """
    numbers = dict(data.numbers)
    for quantity in QUANTITIES.values():
        sigma = quantity.sigma
        scaled = sigma.range.nearest(factor * numbers[sigma.argument])
        if quantity.transformation.positive:
            scaled = np.fmin(scaled, np.nextafter(numbers[quantity.value.argument], 0.0))
        numbers[sigma.argument] = scaled
    return replace(
        data,
        numbers=numbers,
        shape_sigma=SHAPE_SIGMA.range.nearest(factor * data.shape_sigma),
        point_sigma=factor * data.point_sigma,
    )
