"""The columns of modal measurements, before validation."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, shown

Array = NDArray[np.float64]
Integers = NDArray[np.int_]
#: Python syntax of what a file may state under a name.
EXAMPLES = {"priors": '{"parameter:link.length": "1 mm"}', "usable": '{"z": ["0 mm", "200 mm"]}'}
#: Default components of a pose and their units: a point in space.
POSITION: Mapping[str, str] = MappingProxyType({"x": "m", "y": "m", "z": "m"})


class Stated(NamedTuple):
    """A value stated for the whole test, text with a unit, a number, or several of these, and its place."""

    value: Any
    where: str

    @property
    def text(self) -> str:
        """The value as in a comment of a file."""
        return ", ".join(map(str, self.value if isinstance(self.value, list | tuple) else [self.value]))


def merge_stated(
    stated: Mapping[str, Stated], argument_values: Mapping[str, Any], argument: str
) -> dict[str, Stated]:
    """Return the stated values and those of an argument, which may not contradict them.

    Raises MeasurementError if it does, or is no mapping.
    """
    if not isinstance(argument_values, Mapping):
        problem = f"expected a mapping of names to values, found {shown(argument_values)}"
        raise MeasurementError(problem, argument, "write for example " + EXAMPLES[argument])
    values = {
        name: value if isinstance(value, Stated) else Stated(value, f"{argument}: {name}")
        for name, value in argument_values.items()
    }
    for name in stated.keys() & values.keys():
        if stated[name].text.replace(" ", "") != values[name].text.replace(" ", ""):
            problem = f"the file states {name} = {stated[name].text}, not {values[name].text}"
            raise MeasurementError(
                problem, stated[name].where, "leave it out of what you give, or correct the file"
            )
    return {**stated, **values}


class Numbers(Mapping[str, Array]):
    """Read-only columns of numbers by name."""

    def __init__(self, columns: Mapping[str, Array]) -> None:
        self._columns = dict(columns)

    def __getitem__(self, name: str) -> Array:
        return self._columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._columns)

    def __len__(self) -> int:
        return len(self._columns)

    def __repr__(self) -> str:
        return repr(self._columns)


@dataclass(frozen=True, eq=False)
class Columns:
    """Identified modes of a machine at P poses: R rows in the order of their file, C shape channels.

    Attributes
    ----------
    source : str
        The file, for messages.
    labels : tuple of str, length P
        Labels of the poses in the order of their first rows.
    points : ndarray, shape (P, d)
        The poses in SI units; zeros for a structure without positions.
    point_sigma : ndarray, shape (P, d)
        Their standard deviations, 0 where they are assumed exact.
    pose : ndarray of int, shape (R,)
        Index of each row's pose.
    numbers : mapping of str to ndarray of shape (R,)
        The measured quantities and their standard deviations, named as the arguments of
        ``Measurements.from_rows``, NaN where not given.
    mode : tuple of str, length R
        The experimenter's mode numbers, empty where not given.
    lines : ndarray of int, shape (R,)
        Line of each row in the file, from 1.
    channels : tuple of str, length C
        Coordinates at which shapes were measured.
    shapes : ndarray, shape (R, C)
        Components of the mode shapes, any scale per row, NaN where not measured.
    shape_sigma : ndarray, shape (R,)
        Standard deviation of the row's shape components relative to the largest, NaN where not given.
    band : tuple of float, or None
        Lowest and highest frequency of the band in which modes were identified [Hz]; None if not given.
    unit : str
        Unit of the frequencies in the source, for messages; empty if it gives none, which means Hz.
    components, component_units : tuple of str, length d
        Names of the components of a pose, and their SI units.
    drives : tuple of str, length P
        What the motors did at each pose: "free" or "held".
    settings : tuple of str, length K
        Paths of the parameters that were set to a known value at some poses: load cases.
    set_values : ndarray, shape (P, K)
        Those values in SI units, NaN where a pose has the declared value.
    level : ndarray, shape (P,)
        Level at which each pose was excited, of a kind and unit that all poses share; NaN where not given.
    level_unit : str
        Its unit in the source, for messages; empty if it gives none.
    state : str
        State of the machine, such as "before": of all rows; empty if the file names none.
    priors, usable : mapping of str to Stated
        Standard deviations of candidates, and limits of ``[usable]``: what the file states for a diagnosis.
    """

    source: str
    labels: tuple[str, ...]
    points: Array
    point_sigma: Array
    pose: Integers
    numbers: Mapping[str, Array]
    mode: tuple[str, ...]
    lines: Integers
    channels: tuple[str, ...]
    shapes: Array
    shape_sigma: Array
    band: tuple[float, float] | None
    unit: str = ""
    components: tuple[str, ...] = tuple(POSITION)
    component_units: tuple[str, ...] = tuple(POSITION.values())
    drives: tuple[str, ...] = ()
    settings: tuple[str, ...] = ()
    set_values: Array = field(default_factory=lambda: np.empty((0, 0)))
    level: Array = field(default_factory=lambda: np.empty(0))
    level_unit: str = ""
    priors: Mapping[str, Stated] = field(default_factory=dict)
    usable: Mapping[str, Stated] = field(default_factory=dict)
    state: str = ""

    @property
    def conditions(self) -> Integers:
        """Index of the conditions at each pose, (P,): equal if drives and set values are, at any level."""
        condition_of_pose = list(zip(self.drives, map(tuple, self.set_values.tolist()), strict=True))
        indices: dict[str, int] = {}  # a blank setting, NaN, equals nothing, but its text does
        return np.array(
            [indices.setdefault(repr(condition), len(indices)) for condition in condition_of_pose], dtype=int
        )

    @property
    def frequency(self) -> Array:
        """Natural frequency of each row [Hz], (R,)."""
        return self.numbers["frequency"]

    @property
    def sigma(self) -> Array:
        """Standard deviation of the frequency [Hz], (R,)."""
        return self.numbers["sigma"]

    @property
    def damping(self) -> Array:
        """Damping ratio, (R,), NaN where not given."""
        return self.numbers["damping"]

    @property
    def damping_sigma(self) -> Array:
        """Standard deviation of the damping ratio, (R,), NaN where there is no damping."""
        return self.numbers["damping_sigma"]
