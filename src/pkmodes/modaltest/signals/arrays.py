"""Files of named arrays, of MATLAB and of NumPy: which of them are times, frequencies, signals and functions.

A vector is a signal under its name; a column of a matrix ``NAME`` one under ``NAME_1``, ``NAME_2``, ..., and of
functions with several references ``NAME_1__2`` (frequencies x sensors x references).  Fields of structs,
``STRUCT.FIELD``, go by the name of the field alone if it is unique.  Signals may be several measurements
(times x sensors x measurements, with forces times x measurements), of which one is read.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any, NamedTuple

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.core.support.ordering import listed
from pkmodes.modaltest.signals.checks import MIN_POINTS, band_slice, check_abscissa, check_finite
from pkmodes.modaltest.signals.functions import (
    FORCE,
    MAX_NAMES,
    Array,
    Complex,
    Function,
    FunctionKind,
    SignalFile,
    SignalRequest,
    StoredFunction,
)
from pkmodes.modaltest.signals.sampling import counts_samples, even_times
from pkmodes.modaltest.signals.variables import (
    BASE_SIZE,
    MAX_EXPANSION,
    MAX_VALUES,
    REMEDY,
    FileVariable,
    Values,
    load_or_refuse,
)

REFERENCE = "__"
#: Names of abscissas and of sampling rates, in any case; the first that a file has prevails.
TIMES = ("time", "t", "time_domain")
FREQUENCIES = ("frequency", "frequencies", "freq", "frequencyband", "f")
RATES = ("fs", "rate", "sampling_rate", "sample_rate")
#: Names that a record may replace: these two are variables, all others signals.
ABSCISSAS = ("time", "frequency")
#: Rates that differ by less, relative, are the same.
RATE_TOLERANCE = 1e-6
GIVE_NAMES = (
    'state in the record which it is, names = { time = "NAME" } or { frequency = "NAME" }, or give '
    "the rate there"
)


class _Signal(NamedTuple):
    """A vector in a variable.

    - name, response, reference: its own, and those of its sensor and reference
    - pick: extracts it from all values
    - length: number of its values
    - measurement: index of the measurement in its variable, from 0; None if this does not hold several
    """

    name: str
    response: str
    reference: str
    variable: str
    pick: Callable[[Values], Values]
    length: int
    measurement: int | None = None


def find_functions(
    variables: Sequence[FileVariable],
    source: str,
    request: SignalRequest,
    file_kind: str,
    size: int | None = None,
) -> SignalFile:
    """Return the functions that variables hold; only the values of requested ones are read.

    - file_kind: kind of the file, for messages
    - size: size of the file [bytes], which limits the size of its unpacked arrays

    Raises MeasurementError if there are no times, frequencies or rate, or arrays do not belong together.
    """
    by_name = _variables_by_name(variables, request, source)
    abscissa_name, kind = _abscissa_name(by_name, request, source)
    rate_name = _first_present(RATES, [name for name, variable in by_name.items() if variable.size == 1])
    rate_variable = None if rate_name is None else by_name[rate_name]
    count = None if abscissa_name is None else by_name[abscissa_name].size
    signals, skipped = _find_signals(by_name, abscissa_name or rate_name, kind, count, request, source)
    rate = _rate(rate_variable, request, source) if abscissa_name is None else None
    if abscissa_name is None and (rate is None or not signals):
        labels = [f"{name} ({skipped[name]})" if name in skipped else name for name in by_name]
        text = f"expected times, frequencies or a sampling rate, found {listed(labels, MAX_NAMES) or 'no variables'}"
        raise MeasurementError(text, source, f"{GIVE_NAMES}; or {REMEDY}")
    signals = _rename_signals(signals, request, source)
    force_name = FORCE if kind is FunctionKind.TIME else None
    requested = [
        signal
        for signal in signals
        if signal.name == force_name or request.wants(signal.response, signal.name)
    ]
    if requested or all(signal.measurement is None for signal in signals):
        requested, source = _select_measurement(requested, request, source)
    names = dict.fromkeys(
        [*([abscissa_name] if abscissa_name else []), *(signal.variable for signal in requested)]
    )
    _check_size([by_name[name] for name in names], size, source)
    load = cache(lambda name: load_or_refuse(by_name[name].load, source, file_kind))
    messages = [
        f"{source}: {name}: skipped: {description} holds no signals" for name, description in skipped.items()
    ]
    abscissa = None if abscissa_name is None else _abscissa(load(abscissa_name), f"{source}: {abscissa_name}")
    if abscissa is not None and kind is FunctionKind.TIME and counts_samples(abscissa):
        rate = _rate(rate_variable, request, source)
        if rate is not None:
            note = f"{abscissa_name} counts samples: the rate of {rate:g} Hz gives the times"
            messages.append(f"{source}: {note}")
    if rate is not None:
        abscissa = even_times((requested or signals)[0].length, rate)
    assert abscissa is not None
    functions = tuple(
        _function(signal, by_name[signal.variable], load, abscissa, kind, source, request)
        for signal in requested
    )
    return SignalFile(source, functions, (), tuple(messages))


def _variables_by_name(
    variables: Sequence[FileVariable], request: SignalRequest, source: str
) -> dict[str, FileVariable]:
    """Return variables by name; a field of a struct goes by its own name alone if no other field has that name."""
    by_name: dict[str, FileVariable] = {}
    fields = Counter(variable.name.rpartition(".")[2] for variable in variables)
    for variable in variables:
        field = variable.name.rpartition(".")[2]
        name = field if fields[field] == 1 else variable.name
        if name in by_name:
            raise MeasurementError("expected each name once, found it again", f"{source}: {name}", REMEDY)
        by_name[name] = variable._replace(name=name)
    own_names = _limit_names(request, of_abscissa=True).own_names(by_name, source)
    by_name = {
        own_names.get(name, name): variable._replace(name=own_names.get(name, name))
        for name, variable in by_name.items()
    }
    by_name.pop("", None)
    return by_name


def _find_signals(
    variables: Mapping[str, FileVariable],
    abscissa: str | None,
    kind: FunctionKind,
    count: int | None,
    request: SignalRequest,
    source: str,
) -> tuple[list[_Signal], dict[str, str]]:
    """Return the signals in variables, and descriptions of those without any.

    - abscissa: name of the times, frequencies or rate, which are no signals
    - count: number of times or frequencies, if known
    """
    # Of arrays of times, sensors and measurements: the number of measurements, if they agree.
    counts = {v.shape[2] for v in variables.values() if v.shape is not None and len(v.shape) == 3}
    measurement_count = counts.pop() if kind is FunctionKind.TIME and len(counts) == 1 else None
    forces = {FORCE, request.names.get(FORCE, "").lower()}
    signals: list[_Signal] = []
    skipped: dict[str, str] = {}
    for name, variable in variables.items():
        if name == abscissa or (name == FORCE and kind is not FunctionKind.TIME):
            continue
        in_variable = _signals_of_variable(
            variable, kind, count, measurement_count if name.lower() in forces else None
        )
        if not in_variable:
            skipped[name] = variable.description
        names = [signal.name for signal in in_variable]
        if name in (request.sensors or ()) and name not in names:
            text = f"expected a vector of numbers, found {variable.description}"
            remedy = f"name its columns: {', '.join(names[:3])}" if names else REMEDY
            raise MeasurementError(text, f"{source}: {name}", remedy)
        signals += in_variable
    return signals, skipped


def _check_size(variables: Sequence[FileVariable], size: int | None, source: str) -> None:
    """Refuse arrays that are too large, or much larger than the file of this size [bytes]."""
    total = sum(variable.size for variable in variables)
    if total > MAX_VALUES:
        text = f"cannot read the arrays: they have {total:,} values, more than {MAX_VALUES:,}"
        raise MeasurementError(text, source, "split the record, or give a binary universal file")
    bytes_of_all = sum(variable.size * variable.itemsize for variable in variables)
    if size is not None and bytes_of_all > BASE_SIZE + MAX_EXPANSION * size:
        text = f"cannot read the arrays: they have {bytes_of_all:,} bytes, and the file {size:,}"
        smallest = f"1/{MAX_EXPANSION} of their size"
        remedy = f"save the signals that were measured: compressed, they have more than {smallest}"
        raise MeasurementError(text, source, remedy)


def _limit_names(request: SignalRequest, *, of_abscissa: bool) -> SignalRequest:
    """Return a request with the names of abscissas only, or of signals only."""
    names = {
        own_name: name for own_name, name in request.names.items() if (own_name in ABSCISSAS) is of_abscissa
    }
    return replace(request, names=names)


def _rename_signals(signals: Sequence[_Signal], request: SignalRequest, source: str) -> list[_Signal]:
    """Return signals by their names here, without those that give way to others."""
    own_names = _limit_names(request, of_abscissa=False).own_names(
        dict.fromkeys(s.response for s in signals), source
    )
    renamed = []
    for signal in signals:
        response = own_names.get(signal.response, signal.response)
        if response:
            renamed.append(
                signal._replace(name=response + signal.name[len(signal.response) :], response=response)
            )
    return renamed


def _select_measurement(
    signals: Sequence[_Signal], request: SignalRequest, source: str
) -> tuple[list[_Signal], str]:
    """Return the signals of the requested measurement, or of the only one, and its name for messages."""
    numbers = list(dict.fromkeys(signal.measurement for signal in signals if signal.measurement is not None))
    if not numbers:
        if request.member:
            problem = "expected an array of times, sensors and measurements, found none"
            raise MeasurementError(problem, source, f"leave {shown(request.member)} out of its name")
        return list(signals), source
    names = [str(number + 1) for number in numbers]
    if not request.member and len(names) > 1:
        file = source.rpartition("/")[2]
        example = ", ".join(shown(f"{file}/{name}") for name in names[:2])
        problem = f"expected one measurement, found {len(names)}"
        raise MeasurementError(problem, source, f"name each that is meant: files = [{example}]")
    selected = request.member or names[0]
    if selected not in names:
        problem = f"expected a measurement from {names[0]} to {names[-1]}, found {shown(selected)}"
        raise MeasurementError(problem, source, "correct the number after the name of the file")
    number = numbers[names.index(selected)]
    where = f"{source}/{selected}" if request.member else source
    return [signal for signal in signals if signal.measurement in (None, number)], where


def _signals_of_variable(
    variable: FileVariable, kind: FunctionKind, count: int | None, measurement_count: int | None = None
) -> list[_Signal]:
    """Return the signals in a variable.

    - count: number of times or frequencies, if known
    - measurement_count: if it is the force: number of measurements in the file
    """
    shape, lengths = variable.shape or (), variable.lengths
    if not lengths or max(lengths) < MIN_POINTS:
        return []
    spectral = kind is not FunctionKind.TIME
    if len(lengths) == 2 and lengths[1] == measurement_count:
        shape = (lengths[0], 1, lengths[1])  # times x measurements
    of_measurements = not spectral and len(shape) == 3
    if len(lengths) == 1 and not of_measurements:
        response, _, reference = variable.name.partition(REFERENCE) if spectral else (variable.name, "", "")
        return [_Signal(variable.name, response, reference, variable.name, np.ravel, lengths[0])]
    sizes = shape if of_measurements else lengths
    if len(sizes) > 3 or (count is not None and count not in sizes):
        return []
    axis = sizes.index((sizes[0] if of_measurements else max(sizes)) if count is None else count)

    def picker(index: tuple[int, ...]) -> Callable[[Values], Values]:
        def pick(values: Values) -> Values:
            table: Any = np.moveaxis(values.reshape(sizes, order="F"), axis, 0)
            column: Values = table[(slice(None), *index)]
            return column

        return pick

    signals = []
    is_single = of_measurements and measurement_count is not None and sizes[1 if axis == 0 else 0] == 1
    for index in np.ndindex(*(n for i, n in enumerate(sizes) if i != axis)):
        response, *references = f"{variable.name}_{index[0] + 1}", *(str(i + 1) for i in index[1:])
        if of_measurements:
            response, references = variable.name if is_single else response, []
        name = REFERENCE.join([response, *references])
        measurement = index[1] if of_measurements else None
        pick, length = picker(index), sizes[axis]
        signals.append(_Signal(name, response, "".join(references), variable.name, pick, length, measurement))
    return signals


def _abscissa_name(
    by_name: Mapping[str, FileVariable], request: SignalRequest, source: str
) -> tuple[str | None, FunctionKind]:
    """Return the name of the vector of times or frequencies, None if there is none, and the kind of the signals."""
    vectors = [
        name
        for name, variable in by_name.items()
        if len(variable.lengths) == 1 and name not in (request.sensors or ())
    ]
    time, frequency = _first_present(TIMES, vectors), _first_present(FREQUENCIES, vectors)
    if time is not None and frequency is not None:
        declared = [name in request.names for name in ABSCISSAS]
        ranks = [names.index(name.lower()) for names, name in ((TIMES, time), (FREQUENCIES, frequency))]
        if declared[0] is declared[1] and ranks[0] == ranks[1]:
            text = f"expected a vector {time} or {frequency}, found both"
            raise MeasurementError(text, source, "leave one of them out")
        is_time = declared[0] if declared[0] is not declared[1] else ranks[0] < ranks[1]
        time, frequency = (time, None) if is_time else (None, frequency)
    return time or frequency, FunctionKind.TIME if frequency is None else FunctionKind.FRF


def _first_present(names: Sequence[str], present_names: Sequence[str]) -> str | None:
    """Return the first of some names that a file has, in any case; but T and F are usually something else."""
    for name in names:
        matches = [
            candidate
            for candidate in present_names
            if candidate == name or (len(name) > 1 and candidate.lower() == name)
        ]
        if matches:
            return name if name in matches else matches[0]
    return None


def _rate(variable: FileVariable | None, request: SignalRequest, source: str) -> float | None:
    """Return the sampling rate [Hz] of the record or of the file."""
    if variable is None:
        return request.rate
    rate = float(np.real(load_or_refuse(variable.load, source, "signal")[0]))
    if not (np.isfinite(rate) and rate > 0.0):
        where = f"{source}: {variable.name}"
        raise MeasurementError(f"expected a sampling rate above 0, found {rate:g}", where, REMEDY)
    if request.rate is not None and abs(rate - request.rate) > RATE_TOLERANCE * rate:
        text = f"the campaign says a rate of {request.rate:g} Hz, and the file {rate:g} Hz"
        where = f"{source}: {variable.name}"
        raise MeasurementError(text, where, "correct the campaign, or leave the rate out of it")
    return rate


def _abscissa(values: Values, where: str) -> Array:
    if np.iscomplexobj(values):
        raise MeasurementError("expected real numbers, found complex ones", where, REMEDY)
    abscissa = np.asarray(values, np.float64)
    check_abscissa(abscissa, where)
    return abscissa


def _function(
    signal: _Signal,
    variable: FileVariable,
    load: Callable[[str], Values],
    abscissa: Array,
    kind: FunctionKind,
    source: str,
    request: SignalRequest,
) -> Function:
    """Return the function of a signal; numbers that are not of double precision are kept as stored."""
    where = f"{source}: {signal.name}"
    length = max(variable.lengths) if len(variable.lengths) == 1 else None
    vector = None
    if length is None or variable.reload is None:
        vector = signal.pick(load(signal.variable))
        length = vector.size
    if length != abscissa.size:
        problem = f"expected {abscissa.size} values, one for each time or frequency, found {length}"
        raise MeasurementError(problem, where, "save vectors of one length, or remove this one")
    in_band = band_slice(abscissa, None if kind is FunctionKind.TIME else request.band)
    is_complex = vector is not None and vector.dtype.kind == "c"
    if vector is not None and vector.dtype.kind not in "iu":
        check_finite(vector[in_band], where, in_band.start)
        if kind is not FunctionKind.TIME and not (finite := np.isfinite(vector)).all():
            vector = np.where(finite, vector, np.nan)
    if kind is FunctionKind.TIME and is_complex:
        problem = "expected a real signal, found complex values"
        raise MeasurementError(
            problem, where, 'name the abscissa "frequency" if these are frequency responses'
        )
    if kind is not FunctionKind.TIME:
        kind = FunctionKind.FRF if is_complex else FunctionKind.SPECTRUM
    force = kind is FunctionKind.TIME and signal.name == FORCE
    precision = np.complex128 if is_complex else np.float64
    if vector is not None and vector.dtype == precision:
        return Function(kind, signal.response, signal.reference, abscissa, vector, None, None, force)
    stored = variable.reload if vector is None else partial(np.asarray, vector)
    assert stored is not None
    load_stored = partial(_in_double_precision, stored, precision)
    return StoredFunction(
        kind, signal.response, signal.reference, abscissa, None, None, force, load=load_stored
    )


def _in_double_precision(stored: Callable[[], Values], precision: type) -> Array | Complex:
    return np.asarray(stored(), precision)
