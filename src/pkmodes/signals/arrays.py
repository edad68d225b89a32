"""Files of named arrays, of MATLAB and of NumPy: which of them are times, frequencies, signals and functions.

A vector is a signal under its name; a column of a matrix ``NAME`` one under ``NAME_1``, ``NAME_2``, ..., and of
functions with several references ``NAME_1__2`` (frequencies x sensors x references).  Fields of structs,
``STRUCT.FIELD``, are called by the field alone where only one is called so.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from itertools import islice
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError
from pkmodes.signals.checks import FEWEST, check_abscissa, check_finite, within
from pkmodes.signals.functions import Array, Asked, Complex, Function, Kind, SignalFile, StoredFunction
from pkmodes.signals.sampling import even_times
from pkmodes.support.ordering import listed

T = TypeVar("T")
#: Numbers of any type, as files store them.
Values = NDArray[Any]
FORCE, REFERENCE = "force", "__"
#: Names of abscissas and of sampling rates, the first that a file has prevails.
TIMES = ("time", "Time", "t")
FREQUENCIES = ("frequency", "Frequency", "frequencies", "freq", "frequencyBand", "f")
RATES = ("fs", "Fs", "FS", "rate", "sampling_rate")
#: Values that are read of a file, in all.
MOST_VALUES = 100_000_000
#: Bytes that compressed arrays may become: some, and so many times the file.  Measured signals of double precision
#: that are compressed have a tenth of their size at least, but for channels that are constant.
ROOM, EXPANDED = 64_000_000, 20
#: Variables that a message names, and of a file, with the fields of its structs.
MOST_NAMED, MOST_VARIABLES = 20, 20_000
#: Letters of a name; MATLAB allows 63, and the fields of structs have those of all around them.
LONGEST_NAME = 1024
#: Rates are the same that differ by less, relative.
SAME = 1e-6
REMEDY = "save time or frequency, or fs, and a vector for each sensor or a matrix with a column for each"


class Variable(NamedTuple):
    """A variable.

    Attributes
    ----------
    what : str
        What it is, for messages.
    shape : tuple of int or None
        Of an array of numbers.
    load : callable
        Returns the values of an array, columns one after the other, while the file is open.  Raises `ValueError`.
    itemsize : int
        Bytes of a value as it is loaded.
    again : callable, optional
        Of whole numbers, returns the same when the file is closed.
    """

    name: str
    what: str
    shape: tuple[int, ...] | None
    load: Callable[[], Values]
    itemsize: int = 8
    again: Callable[[], Values] | None = None

    @property
    def size(self) -> int:
        """Number of values, 0 if it is no array of numbers."""
        return int(np.prod(self.shape, dtype=np.float64)) if self.shape else 0

    @property
    def lengths(self) -> tuple[int, ...]:
        """Its sizes along the dimensions that have more than one value."""
        return tuple(one for one in self.shape or () if one != 1)


def at_most(found: Iterable[Variable]) -> list[Variable]:
    """Return the variables of a file.

    Raises
    ------
    ValueError
        If there are more than any measurement has.
    """
    every = list(islice(found, MOST_VARIABLES + 1))
    if len(every) > MOST_VARIABLES:
        raise ValueError(f"expected at most {MOST_VARIABLES:,} variables, found more")
    return every


def loaded(load: Callable[[], T], source: str, what: str) -> T:
    """Return what is read, and say of any failure that the file cannot be.

    Raises
    ------
    MeasurementError
        If it cannot be read.
    """
    try:
        return load()
    except OSError as error:
        if error.errno is not None:
            raise
        reason: Exception = error
    except Exception as error:  # damage makes readers raise errors of many types
        reason = error
    text = f"cannot read the {what} file: {str(reason) or type(reason).__name__}"
    raise MeasurementError(text, source, f"the file is damaged or no {what} file: {REMEDY}") from None


class _Signal(NamedTuple):
    """A vector in a variable: its name, those of its sensor and reference, and how it is taken from all values."""

    name: str
    response: str
    reference: str
    variable: str
    pick: Callable[[Values], Values]


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
    named, kind = _abscissa_name(known, asked, source)
    rate = _rate(known, asked, source) if named is None else None
    count = None if named is None else known[named].size
    signals: list[_Signal] = []
    skipped: dict[str, str] = {}
    for name, one in known.items():
        if name == named or (named is None and name in RATES) or (name == FORCE and kind is not Kind.TIME):
            continue
        each = _signals(one, kind, count)
        if not each:
            skipped[name] = one.what
        if asked.sensors is not None and name in asked.sensors and name not in {e.name for e in each}:
            text = f"expected a vector of numbers, found {one.what}"
            remedy = f"name its columns: {', '.join(e.name for e in each[:3])}" if each else REMEDY
            raise MeasurementError(text, f"{source}: {name}", remedy)
        signals += each
    if named is None and (rate is None or not signals):
        others = [f"{name} ({skipped[name]})" if name in skipped else name for name in known]
        text = f"expected times, frequencies or a sampling rate, found {listed(others, MOST_NAMED) or 'no variables'}"
        raise MeasurementError(text, source, f"{REMEDY}; or give the rate in the record")
    forced = FORCE if kind is Kind.TIME else None
    wanted = [one for one in signals if one.name == forced or asked.wants(one.response, one.name)]
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
    if named is not None:
        abscissa = _abscissa(load(named), f"{source}: {named}")
    else:
        assert rate is not None
        first = (wanted or signals)[0]
        abscissa = even_times(max(known[first.variable].lengths), rate)
    functions = tuple(
        _function(one, known[one.variable], load, abscissa, kind, source, asked) for one in wanted
    )
    said = tuple(f"{source}: {name}: skipped: {one} holds no signals" for name, one in skipped.items())
    return SignalFile(source, functions, (), said)


def _signals(one: Variable, kind: Kind, count: int | None) -> list[_Signal]:
    """Return the signals in a variable, whose times or frequencies are `count` if known."""
    lengths = one.lengths
    if not lengths or max(lengths) < FEWEST:
        return []
    spectral = kind is not Kind.TIME
    if len(lengths) == 1:
        response, _, reference = one.name.partition(REFERENCE) if spectral else (one.name, "", "")
        return [_Signal(one.name, response, reference, one.name, np.ravel)]
    if len(lengths) > (3 if spectral else 2) or (count is not None and count not in lengths):
        return []
    axis = lengths.index(max(lengths) if count is None else count)

    def picked(at: tuple[int, ...]) -> Callable[[Values], Values]:
        def pick(values: Values) -> Values:
            table: Any = np.moveaxis(values.reshape(lengths, order="F"), axis, 0)
            column: Values = table[(slice(None), *at)]
            return column

        return pick

    found = []
    for at in np.ndindex(*(n for i, n in enumerate(lengths) if i != axis)):
        response, *references = f"{one.name}_{at[0] + 1}", *(str(i + 1) for i in at[1:])
        name = REFERENCE.join([response, *references])
        found.append(_Signal(name, response, "".join(references), one.name, picked(at)))
    return found


def _abscissa_name(known: Mapping[str, Variable], asked: Asked, source: str) -> tuple[str | None, Kind]:
    """Return the name of the vector of times or frequencies, None if there is none, and the kind of the signals."""
    sensors = asked.sensors or frozenset()
    named = [
        next((n for n in names if n in known and n not in sensors and len(known[n].lengths) == 1), None)
        for names in (TIMES, FREQUENCIES)
    ]
    if named[0] is not None and named[1] is not None:
        places = [names.index(str(name)) for names, name in zip((TIMES, FREQUENCIES), named, strict=True)]
        if places[0] == places[1]:
            text = f"expected a vector {named[0]} or {named[1]}, found both"
            raise MeasurementError(text, source, "leave one of them out")
        named[int(places[0] < places[1])] = None
    return named[0] or named[1], Kind.TIME if named[1] is None else Kind.FRF


def _rate(known: Mapping[str, Variable], asked: Asked, source: str) -> float | None:
    """Return the sampling rate [Hz] of the record or of the file."""
    name = next((one for one in RATES if one in known and known[one].size == 1), None)
    if name is None:
        return asked.rate
    rate = float(np.real(loaded(known[name].load, source, "signal")[0]))
    if not (np.isfinite(rate) and rate > 0.0):
        raise MeasurementError(
            f"expected a sampling rate above 0, found {rate:g}", f"{source}: {name}", REMEDY
        )
    if asked.rate is not None and abs(rate - asked.rate) > SAME * rate:
        text = f"the campaign says a rate of {asked.rate:g} Hz, and the file {rate:g} Hz"
        raise MeasurementError(text, f"{source}: {name}", "correct the campaign, or leave the rate out of it")
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
