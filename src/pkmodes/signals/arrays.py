"""Files of named arrays, of MATLAB and of NumPy: which of them are times, frequencies, signals and functions.

A vector is a signal under its name; a column of a matrix ``NAME`` one under ``NAME_1``, ``NAME_2``, ..., and of
functions with several references ``NAME_1__2`` (frequencies x sensors x references).  Fields of structs,
``STRUCT.FIELD``, are called by the field alone where only one is called so.  Signals may be several measurements
(times x sensors x measurements, with forces times x measurements), of which one is read.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from functools import cache, partial
from typing import Any, NamedTuple, NoReturn

import numpy as np

from pkmodes.core.base.errors import MeasurementError, shown
from pkmodes.signals.checks import FEWEST, check_abscissa, check_finite, within
from pkmodes.signals.functions import (
    FORCE,
    MOST_NAMES,
    Array,
    Asked,
    Complex,
    Function,
    Kind,
    SignalFile,
    StoredFunction,
)
from pkmodes.signals.sampling import counts_samples, even_times
from pkmodes.signals.variables import EXPANDED, MOST_VALUES, REMEDY, ROOM, Values, Variable, loaded
from pkmodes.support.ordering import listed

REFERENCE = "__"
#: Names of abscissas and of sampling rates, in capitals or not; the first that a file has prevails.
TIMES = ("time", "t", "time_domain")
FREQUENCIES = ("frequency", "frequencies", "freq", "frequencyband", "f")
RATES = ("fs", "rate", "sampling_rate", "sample_rate")
#: What a record may call otherwise: these two are variables, all others signals.
ABSCISSAS = ("time", "frequency")
#: Rates are the same that differ by less, relative.
SAME = 1e-6
NAMES = 'say in the record which it is, names = { time = "NAME" } or { frequency = "NAME" }, or give the rate there'


class _Signal(NamedTuple):
    """A vector in a variable.

    Attributes
    ----------
    name, response, reference : str
        Its own, and those of its sensor and reference.
    variable : str
    pick : callable
        How it is taken from all values.
    length : int
        Number of its values.
    measurement : int or None
        Which of the measurements in its variable, from 0; None if this has no several.
    """

    name: str
    response: str
    reference: str
    variable: str
    pick: Callable[[Values], Values]
    length: int
    measurement: int | None = None


def functions_of(
    found: Sequence[Variable], source: str, asked: Asked, what: str, size: int | None = None
) -> SignalFile:
    """Return the functions that variables are; only the values of those asked for are read.

    Parameters
    ----------
    what : str
        Kind of the file, for messages.
    size : int, optional
        Of the file [bytes], of which compressed arrays become a multiple at most.

    Raises
    ------
    MeasurementError
        If there are no times, frequencies or rate, or arrays do not belong together.
    """
    known: dict[str, Variable] = {}
    fields = Counter(one.name.rpartition(".")[2] for one in found)
    for one in found:
        field = one.name.rpartition(".")[2]
        name = field if fields[field] == 1 else one.name
        if name in known:
            raise MeasurementError("expected each name once, found it again", f"{source}: {name}", REMEDY)
        known[name] = one._replace(name=name)
    own = _naming(asked, of_abscissa=True).own_names(known, source)
    known = {own.get(name, name): one._replace(name=own.get(name, name)) for name, one in known.items()}
    known.pop("", None)
    named, kind = _abscissa_name(known, asked, source)
    rate_of = _first(RATES, [name for name, one in known.items() if one.size == 1])
    count = None if named is None else known[named].size
    every: list[_Signal] = []
    skipped: dict[str, str] = {}
    several = _several(known, kind)
    forces = {FORCE, asked.names.get(FORCE, "").lower()}
    for name, one in known.items():
        if name == named or (named is None and name == rate_of) or (name == FORCE and kind is not Kind.TIME):
            continue
        each = _signals(one, kind, count, several if name.lower() in forces else None)
        if not each:
            skipped[name] = one.what
        if asked.sensors is not None and name in asked.sensors and name not in {e.name for e in each}:
            text = f"expected a vector of numbers, found {one.what}"
            remedy = f"name its columns: {', '.join(e.name for e in each[:3])}" if each else REMEDY
            raise MeasurementError(text, f"{source}: {name}", remedy)
        every += each
    rate = _rate(None if rate_of is None else known[rate_of], asked, source) if named is None else None
    if named is None and (rate is None or not every):
        _refuse_nothing(known, skipped, source)
    signals = _called(every, asked, source)
    forced = FORCE if kind is Kind.TIME else None
    wanted = [one for one in signals if one.name == forced or asked.wants(one.response, one.name)]
    if wanted or all(one.measurement is None for one in signals):
        wanted, source = _of_measurement(wanted, asked, source)
    read = [
        known[name] for name in dict.fromkeys([*([named] if named else []), *(s.variable for s in wanted)])
    ]
    total = sum(one.size for one in read)
    if total > MOST_VALUES:
        text = f"cannot read the arrays: they have {total:,} values, more than {MOST_VALUES:,}"
        raise MeasurementError(text, source, "split the record, or give a binary universal file")
    bytes_of_all = sum(one.size * one.itemsize for one in read)
    if size is not None and bytes_of_all > ROOM + EXPANDED * size:
        text = f"cannot read the arrays: they have {bytes_of_all:,} bytes, and the file {size:,}"
        remedy = (
            f"save the signals that were measured: compressed, they have more than 1/{EXPANDED} of their size"
        )
        raise MeasurementError(text, source, remedy)
    load = cache(lambda name: loaded(known[name].load, source, what))
    said = [f"{source}: {name}: skipped: {one} holds no signals" for name, one in skipped.items()]
    abscissa = None if named is None else _abscissa(load(named), f"{source}: {named}")
    if abscissa is not None and kind is Kind.TIME and counts_samples(abscissa):
        rate = _rate(None if rate_of is None else known[rate_of], asked, source)
        said += [] if rate is None else [f"{source}: {named} counts samples, of {rate:g} Hz"]
    if rate is not None:
        abscissa = even_times((wanted or signals)[0].length, rate)
    assert abscissa is not None
    functions = tuple(
        _function(one, known[one.variable], load, abscissa, kind, source, asked) for one in wanted
    )
    return SignalFile(source, functions, (), tuple(said))


def _refuse_nothing(known: Mapping[str, Variable], skipped: Mapping[str, str], source: str) -> NoReturn:
    others = [f"{name} ({skipped[name]})" if name in skipped else name for name in known]
    found = listed(others, MOST_NAMES) or "no variables"
    text = f"expected times, frequencies or a sampling rate, found {found}"
    raise MeasurementError(text, source, f"{NAMES}; or {REMEDY}")


def _naming(asked: Asked, *, of_abscissa: bool) -> Asked:
    """Return what is asked with the names of abscissas alone, or those of signals alone."""
    names = {own: name for own, name in asked.names.items() if (own in ABSCISSAS) is of_abscissa}
    return replace(asked, names=names)


def _called(signals: Sequence[_Signal], asked: Asked, source: str) -> list[_Signal]:
    """Return signals by the names that they have here, without those that stand back for others."""
    own = _naming(asked, of_abscissa=False).own_names(dict.fromkeys(s.response for s in signals), source)
    found = []
    for one in signals:
        response = own.get(one.response, one.response)
        if response:
            found.append(one._replace(name=response + one.name[len(one.response) :], response=response))
    return found


def _several(known: Mapping[str, Variable], kind: Kind) -> int | None:
    """Return how many measurements arrays of times, sensors and measurements hold; None if they do not agree."""
    found = {one.shape[2] for one in known.values() if one.shape is not None and len(one.shape) == 3}
    return found.pop() if kind is Kind.TIME and len(found) == 1 else None


def _of_measurement(signals: Sequence[_Signal], asked: Asked, source: str) -> tuple[list[_Signal], str]:
    """Return the signals of the measurement that is asked for, the only one where none is, and its place."""
    numbers = list(dict.fromkeys(one.measurement for one in signals if one.measurement is not None))
    if not numbers:
        if asked.member:
            what = "expected an array of times, sensors and measurements, found none"
            raise MeasurementError(what, source, f"leave {shown(asked.member)} out of its name")
        return list(signals), source
    names = [str(number + 1) for number in numbers]
    if not asked.member and len(names) > 1:
        file = source.rpartition("/")[2]
        example = ", ".join(shown(f"{file}/{name}") for name in names[:2])
        what = f"expected one measurement, found {len(names)}"
        raise MeasurementError(what, source, f"name each that is meant: files = [{example}]")
    chosen = asked.member or names[0]
    if chosen not in names:
        what = f"expected a measurement from {names[0]} to {names[-1]}, found {shown(chosen)}"
        raise MeasurementError(what, source, "correct the number after the name of the file")
    number = numbers[names.index(chosen)]
    place = f"{source}/{chosen}" if asked.member else source
    return [one for one in signals if one.measurement in (None, number)], place


def _signals(one: Variable, kind: Kind, count: int | None, blows: int | None = None) -> list[_Signal]:
    """Return the signals in a variable.

    Parameters
    ----------
    count : int or None
        Of the times or frequencies, if known.
    blows : int or None
        If it is the force: how many measurements the file holds.
    """
    shape, lengths = one.shape or (), one.lengths
    if not lengths or max(lengths) < FEWEST:
        return []
    spectral = kind is not Kind.TIME
    if len(lengths) == 2 and lengths[1] == blows:
        shape = (lengths[0], 1, lengths[1])  # times x measurements
    of_measurements = not spectral and len(shape) == 3
    if len(lengths) == 1 and not of_measurements:
        response, _, reference = one.name.partition(REFERENCE) if spectral else (one.name, "", "")
        return [_Signal(one.name, response, reference, one.name, np.ravel, lengths[0])]
    sizes = shape if of_measurements else lengths
    if len(sizes) > 3 or (count is not None and count not in sizes):
        return []
    axis = sizes.index((sizes[0] if of_measurements else max(sizes)) if count is None else count)

    def picked(at: tuple[int, ...]) -> Callable[[Values], Values]:
        def pick(values: Values) -> Values:
            table: Any = np.moveaxis(values.reshape(sizes, order="F"), axis, 0)
            column: Values = table[(slice(None), *at)]
            return column

        return pick

    found = []
    single = of_measurements and blows is not None and sizes[1 if axis == 0 else 0] == 1
    for at in np.ndindex(*(n for i, n in enumerate(sizes) if i != axis)):
        response, *references = f"{one.name}_{at[0] + 1}", *(str(i + 1) for i in at[1:])
        if of_measurements:
            response, references = one.name if single else response, []
        name = REFERENCE.join([response, *references])
        measurement = at[1] if of_measurements else None
        pick, length = picked(at), sizes[axis]
        found.append(_Signal(name, response, "".join(references), one.name, pick, length, measurement))
    return found


def _abscissa_name(known: Mapping[str, Variable], asked: Asked, source: str) -> tuple[str | None, Kind]:
    """Return the name of the vector of times or frequencies, None if there is none, and the kind of the signals."""
    vectors = [
        name for name, one in known.items() if len(one.lengths) == 1 and name not in (asked.sensors or ())
    ]
    time, frequency = _first(TIMES, vectors), _first(FREQUENCIES, vectors)
    if time is not None and frequency is not None:
        own = [name in asked.names for name in ABSCISSAS]
        places = [names.index(name.lower()) for names, name in ((TIMES, time), (FREQUENCIES, frequency))]
        if own[0] is own[1] and places[0] == places[1]:
            text = f"expected a vector {time} or {frequency}, found both"
            raise MeasurementError(text, source, "leave one of them out")
        of_time = own[0] if own[0] is not own[1] else places[0] < places[1]
        time, frequency = (time, None) if of_time else (None, frequency)
    return time or frequency, Kind.TIME if frequency is None else Kind.FRF


def _first(names: Sequence[str], given: Sequence[str]) -> str | None:
    """Return the first of some names that a file has, perhaps in capitals; but T and F are usually something else."""
    for name in names:
        alike = [one for one in given if one == name or (len(name) > 1 and one.lower() == name)]
        if alike:
            return name if name in alike else alike[0]
    return None


def _rate(variable: Variable | None, asked: Asked, source: str) -> float | None:
    """Return the sampling rate [Hz] of the record or of the file."""
    if variable is None:
        return asked.rate
    rate = float(np.real(loaded(variable.load, source, "signal")[0]))
    if not (np.isfinite(rate) and rate > 0.0):
        where = f"{source}: {variable.name}"
        raise MeasurementError(f"expected a sampling rate above 0, found {rate:g}", where, REMEDY)
    if asked.rate is not None and abs(rate - asked.rate) > SAME * rate:
        text = f"the campaign says a rate of {asked.rate:g} Hz, and the file {rate:g} Hz"
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
    one: _Signal,
    variable: Variable,
    load: Callable[[str], Values],
    abscissa: Array,
    kind: Kind,
    source: str,
    asked: Asked,
) -> Function:
    """Return the function that a signal is; numbers that are not of double precision stay as they are."""
    where = f"{source}: {one.name}"
    length = max(variable.lengths) if len(variable.lengths) == 1 else None
    vector = None
    if length is None or variable.again is None:
        vector = one.pick(load(one.variable))
        length = vector.size
    if length != abscissa.size:
        what = f"expected {abscissa.size} values, one for each time or frequency, found {length}"
        raise MeasurementError(what, where, "save vectors of one length, or remove this one")
    inside = within(abscissa, None if kind is Kind.TIME else asked.band)
    is_complex = vector is not None and vector.dtype.kind == "c"
    if vector is not None and vector.dtype.kind not in "iu":
        check_finite(vector[inside], where, inside.start)
        if kind is not Kind.TIME and not (finite := np.isfinite(vector)).all():
            vector = np.where(finite, vector, np.nan)
    if kind is Kind.TIME and is_complex:
        what = "expected a real signal, found complex values"
        raise MeasurementError(what, where, 'name the abscissa "frequency" if these are frequency responses')
    if kind is not Kind.TIME:
        kind = Kind.FRF if is_complex else Kind.SPECTRUM
    force = kind is Kind.TIME and one.name == FORCE
    precision = np.complex128 if is_complex else np.float64
    if vector is not None and vector.dtype == precision:
        return Function(kind, one.response, one.reference, abscissa, vector, None, None, force)
    stored = variable.again if vector is None else partial(np.asarray, vector)
    assert stored is not None
    load_again = partial(_in_double_precision, stored, precision)
    return StoredFunction(kind, one.response, one.reference, abscissa, None, None, force, load=load_again)


def _in_double_precision(stored: Callable[[], Values], precision: type) -> Array | Complex:
    return np.asarray(stored(), precision)
