"""The quantities that are measured of each mode: their columns, units and errors, and how predictions are compared.

Another quantity is another entry of `QUANTITIES`: the reader of files, its units, `Measurements` and the checks of
their numbers follow, and so do the errors with which the stability of a verdict is tested.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.robot.units import MAX_MAGNITUDE, MIN_MAGNITUDE
from pkmodes.loop.measured.columns import Array, Columns

#: The largest number below 1.
BELOW_ONE = math.nextafter(1.0, 0.0)


@dataclass(frozen=True)
class Range:
    """The numbers that a column may hold, from the smallest to the largest.

    - expected, remedy: for messages about other numbers
    - blank: whether a number may be absent, NaN
    """

    minimum: float
    maximum: float
    expected: str
    remedy: str
    blank: bool = True

    def holds(self, numbers: Array) -> NDArray[np.bool_]:
        """Return a mask of the numbers that are allowed."""
        is_inside = (numbers >= self.minimum) & (numbers <= self.maximum)
        return np.asarray(is_inside | np.isnan(numbers) if self.blank else is_inside)

    def nearest(self, numbers: Array) -> Array:
        """Return the nearest numbers that are allowed; NaN stays."""
        return np.asarray(np.clip(numbers, self.minimum, self.maximum))


@dataclass(frozen=True)
class NumberColumn:
    """A column with one number for each mode.

    - column: its name in the header of a file
    - argument: its name in Python, in `Measurements.from_rows` and `Measurements.numbers`
    - unit: unit of the number in Python, and in a file whose header gives none
    - symbol: symbol of its columns in reports; by default the name
    """

    column: str
    argument: str
    unit: str
    range: Range
    symbol: str = ""

    @property
    def required(self) -> bool:
        """Whether every mode must have one."""
        return not self.range.blank

    @property
    def heading(self) -> str:
        """Heading of its columns in reports."""
        return f"{self.symbol or self.column} [{self.unit}]"


@dataclass(frozen=True)
class Transformation:
    """A function of a quantity whose errors are additive: residuals are differences of transformed numbers.

    - function: transformed numbers
    - sigma: standard deviations of the transformed numbers, from the numbers and their standard deviations
    - positive: whether it needs a standard deviation below the number itself
    """

    function: Callable[[Array], Array]
    sigma: Callable[[Array, Array], Array]
    positive: bool


LOGARITHM = Transformation(np.log, lambda values, sigmas: sigmas / values, positive=True)
IDENTITY = Transformation(np.asarray, lambda _, sigmas: sigmas, positive=False)


@dataclass(frozen=True)
class MeasuredQuantity:
    """A quantity measured of each mode, with its standard deviation.

    - transformation: transformation of measurements and predictions before they are compared
    - usual_sigma: standard deviations of numbers for which none is stated
    """

    value: NumberColumn
    sigma: NumberColumn
    transformation: Transformation
    usual_sigma: Callable[[Array], Array] | None = None

    def transformed(self, data: Columns) -> Array:
        """Return the transformed measurements, (R,)."""
        return self.transformation.function(data.numbers[self.value.argument])

    def transformed_sigma(self, data: Columns) -> Array:
        """Return the standard deviations of the transformed measurements, (R,)."""
        values, sigmas = (data.numbers[number.argument] for number in (self.value, self.sigma))
        return self.transformation.sigma(values, sigmas)

    @staticmethod
    def residual(measured: Array, predicted: Array) -> Array:
        """Return measured minus predicted, both transformed."""
        return np.asarray(measured - predicted)


FREQUENCY = MeasuredQuantity(
    NumberColumn(
        "frequency",
        "frequency",
        "Hz",
        Range(
            MIN_MAGNITUDE, MAX_MAGNITUDE, "a frequency above 0 Hz", "leave out rigid-body modes", blank=False
        ),
        symbol="f",
    ),
    NumberColumn(
        "sigma",
        "sigma",
        "Hz",
        Range(
            MIN_MAGNITUDE,
            MAX_MAGNITUDE,
            "a standard deviation above 0 Hz",
            "write the standard deviation of the frequency",
            blank=False,
        ),
        symbol="\u03c3",
    ),
    LOGARITHM,
)
DAMPING = MeasuredQuantity(
    NumberColumn(
        "damping",
        "damping",
        "1",
        Range(0.0, BELOW_ONE, "a damping ratio of at least 0 and below 1", "write 0.02 for 2 %"),
    ),
    NumberColumn(
        "sigma_damping",
        "damping_sigma",
        "1",
        Range(
            0.0,
            BELOW_ONE,
            "a standard deviation of at least 0 and below 1",
            "write the standard deviation of the damping ratio, or leave it blank",
        ),
    ),
    IDENTITY,  # a ratio may be 0
    usual_sigma=lambda ratios: 0.3 * ratios,
)
#: All quantities by name, in the order in which messages list their columns.
QUANTITIES = {quantity.value.column: quantity for quantity in (FREQUENCY, DAMPING)}
#: Standard deviation of the components of a mode shape, which are columns of their own.
SHAPE_SIGMA = NumberColumn(
    "sigma_shape",
    "shape_sigma",
    "1",
    Range(
        MIN_MAGNITUDE,
        BELOW_ONE,
        "a standard deviation above 0 and below 1, relative to the largest component",
        "write 0.05 for 5 %, or leave it blank",
    ),
)
#: Level of excitation of a pose, of any kind: only ratios matter.
LEVEL = NumberColumn(
    "level",
    "level",
    "",
    Range(
        MIN_MAGNITUDE,
        MAX_MAGNITUDE,
        "a level of excitation above 0",
        "write the rms or the peak of the force or motion, in one unit for all rows, or leave it blank",
    ),
)


def quantity_number_columns() -> Iterator[NumberColumn]:
    """Yield the columns of all quantities, each standard deviation after its quantity."""
    for quantity in QUANTITIES.values():
        yield from (quantity.value, quantity.sigma)


def number_columns() -> tuple[NumberColumn, ...]:
    """Return all columns with one number for each mode."""
    return (*quantity_number_columns(), SHAPE_SIGMA)


def required_columns() -> tuple[str, ...]:
    """Return the names of the columns of numbers that a file must have."""
    return tuple(spec.column for spec in number_columns() if spec.required)
