"""What a file of measured signals holds: functions of time or frequency, and mode shapes; and what is asked of it."""

from __future__ import annotations

import enum
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


class Kind(enum.StrEnum):
    """What a function is."""

    TIME = "time"
    FRF = "frf"
    COHERENCE = "coherence"
    SPECTRUM = "spectrum"


@dataclass(frozen=True, eq=False)
class Function:
    """A measured function of time or frequency, in the numbers and units of its file.

    Attributes
    ----------
    kind : Kind
        What it is.
    response : str
        Name of the sensor: of the column, or of the degree of freedom of a universal file, such as ``12:+X``; ``12``
        without a direction.
    reference : str
        Name of the excitation, likewise; empty where there is none, or it has no name.
    abscissa : ndarray, shape (n,)
        Strictly ascending: time [s], or frequency [Hz].
    values : ndarray, shape (n,)
        complex128 for a frequency response, float64 otherwise.
    unit : str or None
        Of the values, of a frequency response that of its numerator; None where the file does not say.
    reference_unit : str or None
        Of the denominator of a frequency response; None where the file does not say.
    force : bool
        Whether this is the excitation, in time.
    assumed : bool
        Whether the file gives the kind of its values and no unit: ``unit`` is then that of SI.
    """

    kind: Kind
    response: str
    reference: str
    abscissa: Array
    values: Array | Complex
    unit: str | None
    reference_unit: str | None
    force: bool
    assumed: bool = False


@dataclass(frozen=True, eq=False)
class StoredFunction(Function):
    """A function whose values stay in its file: each access to ``values`` reads them again.

    A file of single precision would otherwise need twice its size in memory.

    Attributes
    ----------
    load : callable
        Reads the values.  Raises `MeasurementError` if the file has changed.
    """

    load: Callable[[], Array | Complex] = field(kw_only=True)
    values: Array | Complex = field(init=False, repr=False)

    def __getattr__(self, name: str) -> Array | Complex:
        # Called only for what the instance does not have; `values` is never set.
        if name == "values":
            return self.load()
        raise AttributeError(f"{type(self).__name__!r} object has no attribute {name!r}")


def computed(
    one: Function, of: Callable[[Array | Complex], Array | Complex], units: Sequence[str | None] | None = None
) -> Function:
    """Return a function whose values are computed from those of another, at each access.

    Parameters
    ----------
    of : callable
        From the values of the one to those of the other.
    units : sequence of str or None, optional
        Its unit and that of its denominator, if they are others.
    """
    unit, reference_unit = units or (one.unit, one.reference_unit)
    return StoredFunction(
        one.kind,
        one.response,
        one.reference,
        one.abscissa,
        unit,
        reference_unit,
        one.force,
        one.assumed,
        load=lambda: of(one.values),
    )


@dataclass(frozen=True, eq=False)
class ModeShape:
    """An identified mode.

    Attributes
    ----------
    frequency : float
        Undamped natural frequency [Hz].
    damping : float or None
        Ratio of critical damping; None where the file does not say.
    shape : dict of str to complex
        Components by degree of freedom, ``12:+X`` or ``12:+RX``.
    """

    frequency: float
    damping: float | None
    shape: dict[str, complex]


@dataclass(frozen=True, eq=False)
class SignalFile:
    """The content of a file.

    Attributes
    ----------
    source : str
        The file, for messages.
    functions : tuple of Function
        In the order of the file.
    modes : tuple of ModeShape
        In the order of the file.
    messages : tuple of str
        What the user must know of a file that could be read: lost samples that it states, parts that were skipped.
    stated : mapping of str to str
        What comments of a table state of it: ``quantity``, ``drives``, and ``unit OUTPUT/INPUT``.
    skipped : tuple of str
        Why functions of the file are not among them.
    """

    source: str
    functions: tuple[Function, ...]
    modes: tuple[ModeShape, ...]
    messages: tuple[str, ...]
    stated: Mapping[str, str] = field(default_factory=dict)
    skipped: tuple[str, ...] = ()


@dataclass(frozen=True)
class Asked:
    """What is wanted of a file.

    Attributes
    ----------
    rate : float, optional
        Sampling rate [Hz] of signals without a column of times.
    sensors : frozenset of str, optional
        Names of the sensors whose functions are wanted; all by default.  Forces in time are always read.
    columns : tuple of str
        Names of the columns of a table, instead of its header; it may have none.
    band : tuple of float, optional
        Frequencies [Hz] outside of which functions of frequency may have gaps, NaN; by default they may have none.
    member : str
        Which of the records in a file that holds several; "" for the only one.
    """

    rate: float | None = None
    sensors: frozenset[str] | None = None
    columns: tuple[str, ...] = ()
    band: tuple[float, float] | None = None
    member: str = ""

    def wants(self, *names: str) -> bool:
        """Return whether a sensor that has any of these names is wanted."""
        return self.sensors is None or not self.sensors.isdisjoint(names)
