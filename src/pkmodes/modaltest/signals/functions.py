"""The content of a file of measured signals: functions of time or frequency, and mode shapes; and requests for it."""

from __future__ import annotations

import enum
from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.support.ordering import listed

#: The signal in time besides sensors, and the names that a file may replace: see `SignalRequest.names`.
FORCE = "force"
RESERVED_NAMES = ("time", "frequency", FORCE)
#: Maximum number of names in a file that an error shows.
MAX_NAMES = 12

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


class FunctionKind(enum.StrEnum):
    """What a function is."""

    TIME = "time"
    FRF = "frf"
    COHERENCE = "coherence"
    SPECTRUM = "spectrum"


@dataclass(frozen=True, eq=False)
class Function:
    """A measured function of time or frequency, in the numbers and units of its file.

    - kind: kind of function
    - response: name of the sensor: of the column, or of the degree of freedom of a universal file, such as ``12:+X``;
      ``12`` without a direction
    - reference: name of the excitation, likewise; empty where there is none, or it has no name
    - abscissa: strictly ascending, (n,): time [s], or frequency [Hz]
    - values: complex128 for a frequency response, float64 otherwise, (n,)
    - unit: unit of the values; of a frequency response, that of its numerator; None where the file does not state it
    - reference_unit: unit of the denominator of a frequency response; None where the file does not state it
    - force: whether this is the excitation, in time
    - unit_assumed: whether the file states the kind of its values but no unit: ``unit`` is then that of SI
    """

    kind: FunctionKind
    response: str
    reference: str
    abscissa: Array
    values: Array | Complex
    unit: str | None
    reference_unit: str | None
    force: bool
    unit_assumed: bool = False


@dataclass(frozen=True, eq=False)
class StoredFunction(Function):
    """A function whose values stay in its file: each access to ``values`` reads them again.

    A file of single precision would otherwise need twice its size in memory.

    - load: reads the values.  Raises `MeasurementError` if the file has changed.
    """

    load: Callable[[], Array | Complex] = field(kw_only=True)
    values: Array | Complex = field(init=False, repr=False)

    def __getattr__(self, name: str) -> Array | Complex:
        # Called only for missing attributes; `values` is never set.
        if name == "values":
            return self.load()
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")


def derived_function(
    function: Function,
    compute: Callable[[Array | Complex], Array | Complex],
    units: Sequence[str | None] | None = None,
) -> Function:
    """Return a function whose values are computed from those of another, at each access.

    - compute: computes the values from those of `function`
    - units: its unit and that of its denominator, if they differ
    """
    unit, reference_unit = units or (function.unit, function.reference_unit)
    return StoredFunction(
        function.kind,
        function.response,
        function.reference,
        function.abscissa,
        unit,
        reference_unit,
        function.force,
        function.unit_assumed,
        load=lambda: compute(function.values),
    )


@dataclass(frozen=True, eq=False)
class ModeShape:
    """An identified mode.

    - frequency: undamped natural frequency [Hz]
    - damping: ratio of critical damping; None where the file does not state it
    - shape: components by degree of freedom, ``12:+X`` or ``12:+RX``
    """

    frequency: float
    damping: float | None
    shape: dict[str, complex]


@dataclass(frozen=True, eq=False)
class SignalFile:
    """The content of a file.

    - source: the file, for messages
    - functions: in the order of the file
    - modes: in the order of the file
    - messages: what the user must know of a readable file: lost samples that it states, parts that were skipped
    - stated: statements in comments of a table: ``quantity``, ``drives``, and ``unit OUTPUT/INPUT``
    - skipped: reasons why functions of the file are not included
    """

    source: str
    functions: tuple[Function, ...]
    modes: tuple[ModeShape, ...]
    messages: tuple[str, ...]
    stated: Mapping[str, str] = field(default_factory=dict)
    skipped: tuple[str, ...] = ()


@dataclass(frozen=True)
class SignalRequest:
    """A request for the content of a file.

    - rate: sampling rate [Hz] of signals without a column of times
    - sensors: names of the sensors whose functions are requested; all by default.  Forces in time are always read.
    - columns: names of the columns of a table, instead of its header; it may have none
    - band: frequencies [Hz] outside of which functions of frequency may have gaps, NaN; by default they may have none
    - member: record in a file that holds several; "" for the only one
    - names: names that the file uses for ``time``, ``frequency``, ``force`` and sensors, by these names
    - force: whether signals in time need a force
    """

    rate: float | None = None
    sensors: frozenset[str] | None = None
    columns: tuple[str, ...] = ()
    band: tuple[float, float] | None = None
    member: str = ""
    names: Mapping[str, str] = field(default_factory=dict)
    force: bool = False

    def wants(self, *names: str) -> bool:
        """Return whether a sensor with any of these names is requested."""
        return self.sensors is None or not self.sensors.isdisjoint(names)

    def own_names(self, names_in_file: Collection[str], where: str) -> dict[str, str]:
        """Return the names used here for those in a file, "" for those that another one replaces.

        They follow `names`; otherwise a name that differs from a sensor's or ``force`` only in case is taken for it,
        if there is just one.

        - where: place in the file, for messages

        Raises MeasurementError if the file lacks a name that `names` gives, other than of a sensor.
        """
        own_names: dict[str, str] = {}
        for name, requested_name in self.names.items():
            match = _matching_name(requested_name, names_in_file)
            if match is not None:
                own_names[match] = name
            elif name in RESERVED_NAMES:
                listing = (
                    listed([shown(candidate) for candidate in names_in_file if candidate], MAX_NAMES)
                    or "none"
                )
                problem = (
                    f"expected {shown(requested_name)}, which the record names as its {name}, found {listing}"
                )
                raise MeasurementError(
                    problem,
                    where,
                    nearest_name(requested_name, names_in_file, "correct the names of the record"),
                )
        assigned = set(own_names.values())
        own_names |= {name: "" for name in names_in_file if name in assigned and name not in own_names}
        for name in (*sorted(self.sensors or ()), FORCE):
            candidates = [
                candidate
                for candidate in names_in_file
                if candidate not in own_names and not (self.sensors and candidate in self.sensors)
            ]
            if (
                name not in names_in_file
                and name not in assigned
                and (match := _matching_name(name, candidates)) is not None
            ):
                own_names[match] = name
        return own_names


def _matching_name(name: str, names_in_file: Collection[str]) -> str | None:
    """Return the name equal to this one, or the only one that differs from it only in case."""
    matches = {candidate for candidate in names_in_file if candidate.casefold() == name.casefold()}
    return name if name in names_in_file else matches.pop() if len(matches) == 1 else None
