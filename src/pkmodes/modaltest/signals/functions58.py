"""From dataset 58 to functions: kinds, names, units, and what each kind requires."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.checks import MIN_POINTS, band_slice, check_abscissa, check_coherence
from pkmodes.modaltest.signals.dataset58 import Axis, Header, Points, StoredPoints, dof_name, is_rotation
from pkmodes.modaltest.signals.functions import (
    Array,
    Complex,
    Function,
    FunctionKind,
    SignalRequest,
    StoredFunction,
)
from pkmodes.modaltest.signals.units import (
    NO_UNIT,
    FileUnits,
    hertz_in,
    quotient_units,
    seconds_in,
    unit_text,
)

#: Function types that can be read.
KINDS = {
    1: FunctionKind.TIME,
    2: FunctionKind.SPECTRUM,
    3: FunctionKind.SPECTRUM,
    4: FunctionKind.FRF,
    6: FunctionKind.COHERENCE,
    9: FunctionKind.SPECTRUM,
}
#: Function types that cannot be read, where a reason can be given.
UNREADABLE_TYPES = {
    0: "general, which does not say what it is",
    5: "a transmissibility, whose poles are not those of the structure: the force must be measured",
    7: "an auto correlation",
    8: "a cross correlation",
    10: "an energy spectral density",
    11: "a probability density",
    12: "a spectrum without averages",
}
#: Specific data type of the ordinate.
FORCE_DATA_TYPE = 13
#: Specific data types of the abscissa, where 0 and 1 (unknown, general) leave the quantity open.
TIME_DATA_TYPES, FREQUENCY_DATA_TYPES = (0, 1, 17), (0, 1, 18)


@dataclass
class SharedAbscissas:
    """Even abscissas in s or Hz by start, step and number of points, so that functions share one array."""

    by_grid: dict[tuple[float, float, int], Array] = field(default_factory=dict)

    def get(self, points: Points, factor: float) -> Array:
        """Return the abscissa of a dataset, times a factor.

        Raises MeasurementError if an even abscissa does not ascend, because adding the step to so large a
        start is lost in rounding.
        """
        if points.abscissa is not None:
            return points.abscissa * factor
        header = points.header
        key = (header.start * factor, header.step * factor, header.count)
        if key not in self.by_grid:
            abscissa = np.arange(header.count, dtype=np.float64)
            with np.errstate(over="ignore"):
                abscissa *= key[1]  # in place: a long record fills much of the memory
                abscissa += key[0]
            check_abscissa(abscissa[:2], points.where)  # rounding is worst at the ends, farthest from 0
            check_abscissa(abscissa[-2:], points.where)
            abscissa.flags.writeable = False
            self.by_grid[key] = abscissa
        return self.by_grid[key]


def convert_values(values: Array | Complex, kind: FunctionKind) -> Array | Complex:
    """Return values in the form of their kind: NaN for gaps, the magnitude of a cross spectrum, a real coherence."""
    if kind is not FunctionKind.TIME and not (finite := np.isfinite(values)).all():
        values = np.where(finite, values, np.nan)
    if kind is FunctionKind.FRF or not np.iscomplexobj(values):
        return values
    return np.abs(values) if kind is FunctionKind.SPECTRUM else np.real(values).copy()


def to_function(
    points: Points, units: FileUnits, abscissas: SharedAbscissas, request: SignalRequest
) -> Function | str | None:
    """Return the function in a dataset 58.

    - points: the dataset
    - units: units of the file
    - abscissas: abscissas of the functions before it; that of this function is added
    - request: the request for the file

    Returns the function, None if its sensor is not requested, or why it is skipped.
    Raises MeasurementError if it does not satisfy the requirements of its type.
    """
    header = points.header
    kind = KINDS.get(header.function)
    if kind is None:
        kinds = "none of time, frequency response, coherence and power spectrum"
        return f"function type {header.function} is {UNREADABLE_TYPES.get(header.function, kinds)}"
    if header.abscissa.data_type not in (
        TIME_DATA_TYPES if kind is FunctionKind.TIME else FREQUENCY_DATA_TYPES
    ):
        data_type = header.abscissa.data_type
        return f"its abscissa has data type {data_type}, which does not suit a {kind} function"
    is_force_ordinate = header.ordinate.data_type == FORCE_DATA_TYPE
    if is_force_ordinate and kind is FunctionKind.SPECTRUM:
        return "it is the spectrum of a force"
    response = dof_name(header.response)
    is_force_signal = is_force_ordinate and kind is FunctionKind.TIME
    if not (is_force_signal or request.wants(response)):
        return None
    factor = (seconds_in if kind is FunctionKind.TIME else hertz_in)(header.abscissa.label) or 1.0
    abscissa = abscissas.get(points, factor)
    points.check_finite(band_slice(abscissa, None if kind is FunctionKind.TIME else request.band))
    _check_kind(points, kind)
    unit, reference_unit = _units(header, kind, units)
    unit_assumed = not units.stated and header.ordinate.label.lower() in NO_UNIT
    # An auto spectrum states its own sensor as its reference, which is no excitation.
    is_auto_spectrum = kind is FunctionKind.SPECTRUM and header.reference == header.response
    lacks_reference = kind is FunctionKind.TIME or is_auto_spectrum or header.reference == (0, 0)
    fields: dict[str, Any] = {
        "kind": kind,
        "response": response,
        "reference": "" if lacks_reference else dof_name(header.reference),
        "abscissa": abscissa,
        "unit": unit,
        "reference_unit": reference_unit,
        "force": is_force_signal,
        "unit_assumed": unit_assumed,
    }
    values = points.values
    if isinstance(values, StoredPoints):
        return StoredFunction(load=lambda: convert_values(values.read("y"), kind), **fields)
    return Function(values=convert_values(values, kind), **fields)


def _check_kind(points: Points, kind: FunctionKind) -> None:
    """Refuse data that do not suit the kind of function."""
    header, remedy = points.header, "export it again as what it is"
    if kind is FunctionKind.FRF and not header.complex:
        problem = "expected complex values of a frequency response, found real ones, which have no phase"
        raise MeasurementError(problem, points.where, remedy)
    if kind is FunctionKind.TIME and header.complex:
        raise MeasurementError(
            "expected real values of a time signal, found complex ones", points.where, remedy
        )
    if header.count < MIN_POINTS:
        problem = f"expected at least {MIN_POINTS} points, found {header.count}"
        raise MeasurementError(problem, points.where, "export the whole measurement")
    if kind is FunctionKind.COHERENCE:
        values = points.values.read("y") if isinstance(points.values, StoredPoints) else points.values
        check_coherence(convert_values(values, kind), points.where)


def _units(header: Header, kind: FunctionKind, units: FileUnits) -> tuple[str | None, str | None]:
    """Return the units of the values, and of the force of a frequency response.

    A label states the unit of the numbers; the units of the file apply to functions without one.
    """

    def axis_unit(axis: Axis, dof: tuple[int, int]) -> str | None:
        if axis.label.lower() not in NO_UNIT:
            return unit_text(axis.label)
        return units.unit_of(axis.data_type, is_rotation(dof))

    if kind is FunctionKind.COHERENCE:
        return None, None
    if kind is FunctionKind.SPECTRUM:
        return unit_text(header.ordinate.label), None
    unit = axis_unit(header.ordinate, header.response)
    if kind is FunctionKind.TIME:
        return unit, None
    reference = axis_unit(header.denominator, header.reference)
    quotient = quotient_units(header.ordinate.label)
    return (quotient[0], quotient[1]) if quotient[1] is not None else (unit, reference)
