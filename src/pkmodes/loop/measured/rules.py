"""The rules for modal measurements; violations are reported with row and column."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import DRIVES
from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.robot.units import MAX_MAGNITUDE, MIN_MAGNITUDE
from pkmodes.loop.measured.columns import Array, Columns, Integers
from pkmodes.loop.measured.quantities import (
    FREQUENCY,
    LEVEL,
    QUANTITIES,
    SHAPE_SIGMA,
    MeasuredQuantity,
    Range,
    quantity_number_columns,
)

#: Prefix of the columns that hold mode shapes.
SHAPE = "shape:"
#: Prefix of the columns that hold values of settings.
SET = "set:"
#: Remedy for an invalid label.
PRINTABLE_REMEDY = "write a name in printable characters"


class QuotedNumber(NamedTuple):
    """A number quoted in a message: its row and column, its value in SI units, and its format."""

    row: int
    column: str
    value: float
    digits: str = "g"


class Problem(NamedTuple):
    """A violated rule: row and column, what is wrong as text and numbers, and what to do."""

    row: int
    column: str
    what: str | tuple[str | QuotedNumber, ...]
    remedy: str


class BrokenRuleError(MeasurementError):
    """A violated rule; the reader of a file can replace the numbers in its message by the original cells."""

    def __init__(self, problem: Problem, where: str) -> None:
        super().__init__(
            message(problem, lambda number: format(number.value, number.digits)), where, problem.remedy
        )
        self.problem = problem

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problem, self.where)


def message(problem: Problem, show: Callable[[QuotedNumber], str]) -> str:
    """Return the message of a problem, with its numbers formatted by `show`."""
    parts = (problem.what,) if isinstance(problem.what, str) else problem.what
    return "".join(part if isinstance(part, str) else show(part) for part in parts)


def refuse(problems: Sequence[Problem], source: str, lines: Integers) -> None:
    """Raise the first problem by row, if there is any."""
    if problems:
        first = min(problems, key=lambda problem: problem.row)
        where = f"{source}: line {lines[first.row]}, column {first.column}"
        if len(problems) > 1:
            where += f", the first of {len(problems)} problems"
        raise BrokenRuleError(first, where)


def checked_band(band: Iterable[float], where: str) -> tuple[float, float]:
    """Check the band in which modes were identified [Hz]."""
    try:
        low, high = (float(limit) for limit in band)
    except (TypeError, ValueError):
        raise MeasurementError(
            "expected two frequencies", where, "give the lower and the higher frequency in Hz"
        ) from None
    if not MIN_MAGNITUDE <= low < high <= MAX_MAGNITUDE:
        problem = (
            f"expected a lower and a higher frequency, both above 0 Hz, found {low:g} Hz and {high:g} Hz"
        )
        raise MeasurementError(problem, where, "give the lower frequency first")
    return low, high


def checked_level_unit(unit: object, where: str) -> str:
    """Check the unit of the levels of excitation: any unit that is not logarithmic.

    Raises MeasurementError if it is no printable text, or a logarithm.
    """
    if not isinstance(unit, str) or not unit.isprintable() or set(unit) & {*"[]"}:
        raise MeasurementError(f"expected a unit, found {shown(unit)}", where, 'write for example "N"')
    if unit.casefold().startswith("db"):
        problem = f"expected levels that are not logarithmic, found the unit {shown(unit)}"
        raise MeasurementError(problem, where, "write the rms or the peak of the force or motion itself")
    return unit.strip()


def value_problems(data: Columns, first: Integers) -> Iterator[Problem]:
    """Yield numbers that are out of range; `first` holds the first row of each pose."""
    rows = np.arange(len(data.mode))
    for k, (name, unit) in enumerate(zip(data.components, data.component_units, strict=True)):
        coordinate_range = Range(
            -MAX_MAGNITUDE, MAX_MAGNITUDE, "a finite coordinate", f"write a number in {unit}", blank=False
        )
        yield from _range_problems(name, data.points[:, k], coordinate_range, first)
        requirement = f"a standard deviation of at least 0 {unit}"
        sigma_range = Range(0.0, MAX_MAGNITUDE, requirement, "leave it blank if unknown", blank=False)
        yield from _range_problems(f"sigma_{name}", data.point_sigma[:, k], sigma_range, first)
    for quantity in QUANTITIES.values():
        yield from _quantity_problems(quantity, data, rows)
    yield from _range_problems(SHAPE_SIGMA.column, data.shape_sigma, SHAPE_SIGMA.range, rows)
    if data.band is not None:
        low, high = data.band
        expected = f"a frequency in the band from {low:.10g} Hz to {high:.10g} Hz"
        band_range = Range(low, high, expected, "correct the row or the band", blank=False)
        is_in_band = band_range.holds(data.frequency) | ~FREQUENCY.value.range.holds(data.frequency)
        yield from _problems_where_not(FREQUENCY.value.column, data.frequency, is_in_band, band_range, rows)
    for k, name in enumerate(data.channels):
        component = Range(
            -MAX_MAGNITUDE, MAX_MAGNITUDE, "a finite shape component", "leave it blank if unknown"
        )
        yield from _range_problems(f"{SHAPE}{name}", data.shapes[:, k], component, rows)
    for k, name in enumerate(data.settings):
        setting = Range(
            -MAX_MAGNITUDE, MAX_MAGNITUDE, "a finite value", "leave it blank if it is as declared"
        )
        yield from _range_problems(f"{SET}{name}", data.set_values[:, k], setting, first)
    yield from _range_problems(LEVEL.column, data.level, LEVEL.range, first)
    for i in np.flatnonzero((data.shapes == 0.0).any(axis=1) & ~(np.abs(data.shapes) > 0.0).any(axis=1)):
        column = f"{SHAPE}{data.channels[int(np.argmax(data.shapes[i] == 0.0))]}"
        remedy = "leave the components blank if the shape was not measured"
        yield Problem(int(i), column, "expected a mode shape, found only zeros", remedy)


def _quantity_problems(quantity: MeasuredQuantity, data: Columns, rows: Integers) -> Iterator[Problem]:
    """Yield numbers of a quantity and standard deviations that are out of range."""
    value, sigma = quantity.value, quantity.sigma
    values, sigmas = data.numbers[value.argument], data.numbers[sigma.argument]
    valid, valid_sigmas = value.range.holds(values), sigma.range.holds(sigmas)
    yield from _problems_where_not(value.column, values, valid, value.range, rows)
    # The usual standard deviation of a bad number is bad too.
    is_stated = valid_sigmas if quantity.usual_sigma is None else valid_sigmas | ~valid
    yield from _problems_where_not(sigma.column, sigmas, is_stated, sigma.range, rows)
    if quantity.transformation.positive:
        is_below_value = (sigmas < values) | ~(valid & valid_sigmas) | np.isnan(values) | np.isnan(sigmas)
        requirement, remedy = f"a standard deviation below the {value.column}", sigma.range.remedy
        relative_range = Range(0.0, MAX_MAGNITUDE, requirement, f"{remedy}, and check the units of both")
        yield from _problems_where_not(sigma.column, sigmas, is_below_value, relative_range, rows)


def _range_problems(column: str, values: Array, allowed: Range, rows: Integers) -> Iterator[Problem]:
    """Yield numbers outside a range; `rows` holds their rows."""
    yield from _problems_where_not(column, values, allowed.holds(values), allowed, rows)


def _problems_where_not(
    column: str, values: Array, is_allowed: NDArray[np.bool_], allowed: Range, rows: Integers
) -> Iterator[Problem]:
    """Yield numbers that violate a range, with its messages."""
    of_quantity = column in {spec.column for spec in quantity_number_columns()}
    for i in np.flatnonzero(~is_allowed):
        exceeds_largest = of_quantity and allowed.maximum == MAX_MAGNITUDE < values[i] < np.inf
        expected = f"{allowed.expected} (at most {MAX_MAGNITUDE:g})" if exceeds_largest else allowed.expected
        row = int(rows[i])
        problem = (f"expected {expected}, found ", QuotedNumber(row, column, float(values[i])))
        yield Problem(row, column, problem, allowed.remedy)


def is_label(text: str) -> bool:
    """Return whether a text can be the label of a pose."""
    return bool(text.strip()) and text.isprintable()


def text_problems(data: Columns, first: Integers) -> Iterator[Problem]:
    """Yield labels and mode numbers that are not printable, labels that are repeated, and unknown `drives`."""
    earlier_labels: set[str] = set()
    for i, label in zip(first.tolist(), data.labels, strict=True):
        if not is_label(label):
            yield Problem(i, "pose", f"expected a label, found {shown(label)}", PRINTABLE_REMEDY)
        if label in earlier_labels:
            yield Problem(
                i, "pose", f"two poses have the label {shown(label)}", "give each pose a unique label"
            )
        earlier_labels.add(label)
    for i, word in zip(first.tolist(), data.drives, strict=True):
        if word not in DRIVES:
            problem = f'expected "free" or "held", found {shown(word)}'
            yield Problem(
                i, "drives", problem, "say whether the motors turned freely or position loops held them"
            )
    for i, number in enumerate(data.mode):
        if not number.isprintable():
            yield Problem(
                i, "mode", f"expected a number or name, found {shown(number)}", "use printable characters"
            )


def position_problems(data: Columns, points: Array, spreads: Array) -> Iterator[Problem]:
    """Yield rows whose position or its standard deviation differs from the first row of their pose."""
    first = np.unique(data.pose, return_index=True)[1]
    for kind, prefix, rows, poses in (
        ("positions", "", points, data.points),
        ("standard deviations", "sigma_", spreads, data.point_sigma),
    ):
        for i, k in np.argwhere(rows != poses[data.pose]):
            name, pose = f"{prefix}{data.components[k]}", data.pose[i]
            first_row = int(first[pose])
            yield Problem(
                int(i),
                name,
                (
                    f"pose {shown(data.labels[pose])} has two {kind}: {name} is ",
                    QuotedNumber(first_row, name, float(poses[pose, k]), ".10g"),
                    f" in line {data.lines[first_row]} and ",
                    QuotedNumber(int(i), name, float(rows[i, k]), ".10g"),
                    " here",
                ),
                "give each pose a unique label",
            )


def setting_problems(data: Columns, rows: Array) -> Iterator[Problem]:
    """Yield rows, of all rows (R, K), with a setting that differs from the first row of their pose."""
    for k, name in enumerate(data.settings):
        remedy = "give each load case a unique label"
        yield from _values_that_differ(data, f"{SET}{name}", data.set_values[:, k], rows[:, k], remedy)


def level_problems(data: Columns, rows: Array) -> Iterator[Problem]:
    """Yield rows, of all rows (R,), whose level differs from that of the first row of their pose."""
    remedy = 'give each level a label of its own, such as "P1 low" and "P1 high"'
    yield from _values_that_differ(data, LEVEL.column, data.level, rows, remedy)


def _values_that_differ(
    data: Columns, name: str, poses: Array, rows: Array, remedy: str
) -> Iterator[Problem]:
    """Yield rows (R,) whose value in a column differs from that of their pose (P,); a blank is a value, too."""
    first = np.unique(data.pose, return_index=True)[1]
    expected = poses[data.pose]
    for i in np.flatnonzero((rows != expected) & ~(np.isnan(rows) & np.isnan(expected))):
        pose = data.pose[i]
        first_row = int(first[pose])
        pair = [(first_row, float(expected[i])), (int(i), float(rows[i]))]
        first_value, row_value = (
            "blank" if np.isnan(v) else QuotedNumber(row, name, v, ".10g") for row, v in pair
        )
        problem = f"pose {shown(data.labels[pose])} has two values: {name} is "
        yield Problem(
            int(i),
            name,
            (problem, first_value, f" in line {data.lines[first_row]} and ", row_value, " here"),
            remedy,
        )


def drives_problems(data: Columns, rows: Sequence[str]) -> Iterator[Problem]:
    """Yield rows, of all rows (R,), in which the motors were in another state than in the first row of their pose."""
    first = np.unique(data.pose, return_index=True)[1]
    for i, (word, pose) in enumerate(zip(rows, data.pose.tolist(), strict=True)):
        if word != data.drives[pose]:
            problem = f"pose {shown(data.labels[pose])} has two values: drives is {data.drives[pose]}"
            problem += f" in line {data.lines[first[pose]]} and {word} here"
            remedy = "give the pose with free motors and the one with held motors a label each"
            yield Problem(i, "drives", problem, remedy)


def repetitions(data: Columns) -> Iterator[Problem]:
    """Yield repeated rows: one mode must not count as two measurements."""
    compared_columns = [
        n for q in QUANTITIES.values() for n in (q.value, q.sigma) if n is q.value or n.required
    ]
    columns = [data.numbers[spec.argument] for spec in compared_columns]
    numbers = np.column_stack([data.pose, *columns, data.shapes])
    first_rows: dict[tuple[bytes, str], int] = {}
    for i, row in enumerate(numbers):
        first_row = first_rows.setdefault((row.tobytes(), data.mode[i]), i)
        if first_row != i:
            yield Problem(
                i,
                "frequency",
                f"the row repeats line {data.lines[first_row]}",
                "remove one, or number them in the column mode where two modes coincide",
            )
