"""The rules for modal measurements; violations are reported with row and column."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.base.errors import MeasurementError, shown
from pkmodes.measured.columns import Array, Columns, Integers
from pkmodes.robot.units import LARGEST, SMALLEST

#: Prefix of the columns that hold mode shapes.
SHAPE = "shape:"
#: Prefix of the columns that hold values of settings.
SET = "set:"


class Found(NamedTuple):
    """A number quoted in a message: its row and column, its value in SI units, and its format."""

    row: int
    column: str
    value: float
    digits: str = "g"


class Problem(NamedTuple):
    """A violated rule: row and column, what is wrong as text and numbers, and what to do."""

    row: int
    column: str
    what: str | tuple[str | Found, ...]
    remedy: str


class BrokenRuleError(MeasurementError):
    """A violated rule; the reader of a file can replace the numbers in its message by the original cells."""

    def __init__(self, problem: Problem, where: str) -> None:
        super().__init__(told(problem, _plainly), where, problem.remedy)
        self.problem = problem

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.problem, self.where)


def told(problem: Problem, show: Callable[[Found], str]) -> str:
    """Return the message of a problem, with its numbers formatted by `show`."""
    parts = (problem.what,) if isinstance(problem.what, str) else problem.what
    return "".join(part if isinstance(part, str) else show(part) for part in parts)


def _plainly(found: Found) -> str:
    return format(found.value, found.digits)


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
    if not SMALLEST <= low < high <= LARGEST:
        what = f"expected a lower and a higher frequency, both above 0 Hz, found {low:g} Hz and {high:g} Hz"
        raise MeasurementError(what, where, "give the lower frequency first")
    return low, high


def value_problems(given: Columns, first: Integers) -> Iterator[Problem]:
    """Yield numbers that are out of range; `first` holds the first row of each pose."""
    rows = np.arange(len(given.mode))

    def broken(
        column: str, values: Array, good: NDArray[np.bool_], expected: str, remedy: str, at: Integers = rows
    ) -> Iterator[Problem]:
        for i in np.flatnonzero(~good):
            large = column in ("frequency", "sigma") and LARGEST < values[i] < np.inf
            wanted = f"{expected} (at most {LARGEST:g})" if large else expected
            row = int(at[i])
            yield Problem(
                row, column, (f"expected {wanted}, found ", Found(row, column, float(values[i]))), remedy
            )

    # A NaN compares false and so fails.
    for k, (name, unit) in enumerate(zip(given.components, given.component_units, strict=True)):
        point, spread = given.points[:, k], given.point_sigma[:, k]
        remedy = f"write a number in {unit}"
        yield from broken(name, point, np.abs(point) <= LARGEST, "a finite coordinate", remedy, first)
        good = (spread >= 0.0) & (spread <= LARGEST)
        expected = f"a standard deviation of at least 0 {unit}"
        yield from broken(f"sigma_{name}", spread, good, expected, "leave it blank if unknown", first)
    frequency, sigma, damping = given.frequency, given.sigma, given.damping
    positive = (frequency >= SMALLEST) & (frequency <= LARGEST)
    yield from broken(
        "frequency", frequency, positive, "a frequency above 0 Hz", "leave out rigid-body modes"
    )
    known = (sigma >= SMALLEST) & (sigma <= LARGEST)
    remedy = "write the standard deviation of the frequency"
    yield from broken("sigma", sigma, known, "a standard deviation above 0 Hz", remedy)
    small = (sigma < frequency) | ~(positive & known)
    remedy = "write the standard deviation of the frequency, and check the units of both"
    yield from broken("sigma", sigma, small, "a standard deviation below the frequency", remedy)
    ratio = np.isnan(damping) | ((damping >= 0.0) & (damping < 1.0))
    yield from broken(
        "damping", damping, ratio, "a damping ratio of at least 0 and below 1", "write 0.02 for 2 %"
    )
    unsure = (
        ~ratio | np.isnan(given.damping_sigma) | ((given.damping_sigma >= 0.0) & (given.damping_sigma < 1.0))
    )
    yield from broken(
        "sigma_damping",
        given.damping_sigma,
        unsure,
        "a standard deviation of at least 0 and below 1",
        "write the standard deviation of the damping ratio, or leave it blank",
    )
    rough = np.isnan(given.shape_sigma) | ((given.shape_sigma >= SMALLEST) & (given.shape_sigma < 1.0))
    yield from broken(
        "sigma_shape",
        given.shape_sigma,
        rough,
        "a standard deviation above 0 and below 1, relative to the largest component",
        "write 0.05 for 5 %, or leave it blank",
    )
    if given.band is not None:
        low, high = given.band
        inside = ((frequency >= low) & (frequency <= high)) | ~positive
        expected = f"a frequency in the band from {low:.10g} Hz to {high:.10g} Hz"
        yield from broken("frequency", frequency, inside, expected, "correct the row or the band")
    for k, name in enumerate(given.channels):
        part = given.shapes[:, k]
        good = np.isnan(part) | (np.abs(part) <= LARGEST)
        yield from broken(
            f"{SHAPE}{name}", part, good, "a finite shape component", "leave it blank if unknown"
        )
    for k, name in enumerate(given.settings):
        part = given.set_values[:, k]
        good = np.isnan(part) | (np.abs(part) <= LARGEST)
        yield from broken(
            f"{SET}{name}", part, good, "a finite value", "leave it blank if it is as declared", first
        )
    for i in np.flatnonzero((given.shapes == 0.0).any(axis=1) & ~(np.abs(given.shapes) > 0.0).any(axis=1)):
        column = f"{SHAPE}{given.channels[int(np.argmax(given.shapes[i] == 0.0))]}"
        remedy = "leave the components blank if the shape was not measured"
        yield Problem(int(i), column, "expected a mode shape, found only zeros", remedy)


def text_problems(given: Columns, first: Integers) -> Iterator[Problem]:
    """Yield labels and mode numbers that are not printable, and labels that are missing or repeated."""
    seen: set[str] = set()
    for i, label in zip(first.tolist(), given.labels, strict=True):
        if not label.strip() or not label.isprintable():
            yield Problem(
                i, "pose", f"expected a label, found {shown(label)}", "write a name in printable characters"
            )
        if label in seen:
            yield Problem(
                i, "pose", f"two poses have the label {shown(label)}", "give each pose a unique label"
            )
        seen.add(label)
    for i, number in enumerate(given.mode):
        if not number.isprintable():
            yield Problem(
                i, "mode", f"expected a number or name, found {shown(number)}", "use printable characters"
            )


def position_problems(found: Columns, points: Array, spreads: Array) -> Iterator[Problem]:
    """Yield rows whose position or its standard deviation differs from the first row of their pose."""
    first = np.unique(found.pose, return_index=True)[1]
    for kind, prefix, rows, poses in (
        ("positions", "", points, found.points),
        ("standard deviations", "sigma_", spreads, found.point_sigma),
    ):
        for i, k in np.argwhere(rows != poses[found.pose]):
            name, number = f"{prefix}{found.components[k]}", found.pose[i]
            before = int(first[number])
            yield Problem(
                int(i),
                name,
                (
                    f"pose {shown(found.labels[number])} has two {kind}: {name} is ",
                    Found(before, name, float(poses[number, k]), ".10g"),
                    f" in line {found.lines[before]} and ",
                    Found(int(i), name, float(rows[i, k]), ".10g"),
                    " here",
                ),
                "give each pose a unique label",
            )


def setting_problems(found: Columns, rows: Array) -> Iterator[Problem]:
    """Yield rows, of all rows (R, K), with a setting that differs from the first row of their pose."""
    first = np.unique(found.pose, return_index=True)[1]
    poses = found.set_values[found.pose]
    for i, k in np.argwhere((rows != poses) & ~(np.isnan(rows) & np.isnan(poses))):
        name, number = f"{SET}{found.settings[k]}", found.pose[i]
        before = int(first[number])
        pair = [(before, float(poses[i, k])), (int(i), float(rows[i, k]))]
        there, here = ("blank" if np.isnan(v) else Found(row, name, v, ".10g") for row, v in pair)
        what = f"pose {shown(found.labels[number])} has two values: {name} is "
        yield Problem(
            int(i),
            name,
            (what, there, f" in line {found.lines[before]} and ", here, " here"),
            "give each load case a unique label",
        )


def repetitions(found: Columns) -> Iterator[Problem]:
    """Yield repeated rows: one mode must not count as two measurements."""
    numbers = np.column_stack([found.pose, found.frequency, found.sigma, found.damping, found.shapes])
    seen: dict[tuple[bytes, str], int] = {}
    for i, row in enumerate(numbers):
        before = seen.setdefault((row.tobytes(), found.mode[i]), i)
        if before != i:
            yield Problem(
                i,
                "frequency",
                f"the row repeats line {found.lines[before]}",
                "remove one, or number them in the column mode where two modes coincide",
            )
