"""MATLAB files up to version 7: ``time`` or ``frequency``, ``force``, and one vector for each sensor under its name.

A complex vector with ``frequency`` is a frequency response, ``NAME`` or ``NAME__REF``; a real one a spectrum.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from functools import partial
from os import fspath
from pathlib import Path
from typing import Any, BinaryIO, TypeVar

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.measured.formats import Format
from pkmodes.signals.checks import FEWEST, check_abscissa, check_finite, within
from pkmodes.signals.functions import Array, Asked, Complex, Function, Kind, SignalFile
from pkmodes.signals.matlab_arrays import Variable, variables

T = TypeVar("T")
TIME, FREQUENCY, FORCE = "time", "frequency", "force"
REFERENCE = "__"
HDF5 = b"\x89HDF\r\n\x1a\n"
#: Values that are read of a file, in all: together with what they are unpacked from they take 2 GB of memory.
MOST_VALUES = 100_000_000
#: Classes of variables of version 4 that are not arrays of numbers, in words.
TEXTS = {"char": "text", "sparse": "a sparse matrix"}
REMEDY = "save time or frequency and one vector for each sensor, with save -v7"


def read(path: Path, asked: Asked) -> SignalFile:
    """Read a MATLAB file.

    Raises
    ------
    MeasurementError
        If it is of version 7.3, damaged, or its vectors do not belong together.
    """
    source = fspath(path)
    with path.open("rb") as file:
        head = file.read(1024)
    if HDF5 in head or head.startswith(b"MATLAB 7.3"):
        what = "expected a MATLAB file of version 7 or older, found version 7.3"
        raise MeasurementError(what, source, "save it again in MATLAB with save -v7")
    with path.open("rb") as file:
        return _content(_variables(file, path, head, source), source, asked)


def _content(found: Sequence[Variable], source: str, asked: Asked) -> SignalFile:
    """Return the functions that the variables are; only the values of those asked for are read."""
    skipped: dict[str, str] = {}
    vectors: dict[str, Variable] = {}
    for one in found:
        name = one.name
        if name in vectors:
            raise MeasurementError("expected each name once, found it again", f"{source}: {name}", REMEDY)
        if one.size is not None and one.size >= FEWEST:
            vectors[name] = one
        elif asked.sensors is not None and name in asked.sensors:
            message = f"expected a vector of numbers, found {one.what}"
            raise MeasurementError(message, f"{source}: {name}", "save one vector for each sensor")
        else:
            skipped[name] = one.what
    named = _abscissa_name(vectors, skipped, source, asked)
    kind = Kind.TIME if named in ("", TIME) else Kind.FRF
    wanted: dict[str, tuple[str, str]] = {}
    for name in vectors:
        if name in (TIME, FREQUENCY) or (name == FORCE and kind is not Kind.TIME):
            continue
        response, _, reference = name.partition(REFERENCE) if kind is not Kind.TIME else (name, "", "")
        if asked.wants(response, name) or (name == FORCE and kind is Kind.TIME):
            wanted[name] = response, reference
    read = [vectors[name] for name in (named, *wanted) if name]
    _check_size(read, source)
    values = {one.name: _loaded(one.load, source) for one in read}
    abscissa = _abscissa(named, values, wanted, vectors, source, asked)
    functions = tuple(
        _function(name, response, reference, values.pop(name), abscissa, kind, source, asked)
        for name, (response, reference) in wanted.items()
    )
    messages = [
        f"{source}: {name}: skipped: {what} is not a vector of numbers" for name, what in skipped.items()
    ]
    return SignalFile(source, functions, (), tuple(messages))


def _check_size(read: Sequence[Variable], source: str) -> None:
    """Refuse vectors that would not fit into memory, before they are unpacked."""
    values = sum(one.size or 0 for one in read)
    if values > MOST_VALUES:
        what = f"cannot read the vectors: they have {values:,} values, more than {MOST_VALUES:,}"
        raise MeasurementError(what, source, "split the record, or give a binary universal file")


def _loaded(load: Callable[[], T], source: str) -> T:
    """Return what is read, and say of any failure that the file cannot be."""
    try:
        return load()
    except OSError as error:
        if error.errno is not None:
            raise
        reason: Exception = error
    except Exception as error:  # damage makes SciPy raise errors of many types
        reason = error
    what = f"cannot read the MATLAB file: {str(reason) or type(reason).__name__}"
    raise MeasurementError(what, source, f"the file is damaged or no MATLAB file: {REMEDY}") from None


def _variables(file: BinaryIO, path: Path, head: bytes, source: str) -> list[Variable]:
    """Return all variables of a file; their values are read later."""
    if b"\0" in head[:4]:  # version 4 has no text at its beginning
        return _loaded(lambda: _of_version_4(path), source)
    return _loaded(lambda: list(variables(file, path.stat().st_size)), source)


def _of_version_4(path: Path) -> list[Variable]:
    """Return the variables of a file of version 4, which has matrices only."""
    from scipy.io import loadmat, whosmat

    def values(name: str) -> Array | Complex:
        vector: Any = loadmat(path, appendmat=False, variable_names=[name])[name].ravel()
        if vector.dtype.kind == "c":
            return np.asarray(vector, np.complex128)
        return np.asarray(vector, np.float64)

    found = []
    for name, shape, of in whosmat(path, appendmat=False):
        numeric = of not in TEXTS
        what = f"an array of {' x '.join(map(str, shape))} values" if numeric else TEXTS[of]
        size = max(shape) if numeric and len(shape) == 2 and min(shape) == 1 else None
        found.append(Variable(name, what, size, partial(values, name)))
    return found


def _abscissa_name(
    vectors: Mapping[str, Variable], skipped: Mapping[str, str], source: str, asked: Asked
) -> str:
    """Return the name of the vector of times or frequencies; "" where a rate stands in for it."""
    named = [name for name in (TIME, FREQUENCY) if name in vectors]
    if len(named) == 2:
        raise MeasurementError(
            "expected a vector time or frequency, found both", source, "leave one of them out"
        )
    if not named and (asked.rate is None or not vectors):
        found = [*vectors, *(f"{name} ({what})" for name, what in skipped.items())]
        what = f"expected a vector time or frequency, found {', '.join(found) or 'no variables'}"
        remedy = f"{REMEDY}; or give the rate in the record"
        raise MeasurementError(what, source, remedy)
    return named[0] if named else ""


def _abscissa(
    named: str,
    values: Mapping[str, Array | Complex],
    wanted: Collection[str],
    vectors: Mapping[str, Variable],
    source: str,
    asked: Asked,
) -> Array:
    """Return the times or frequencies."""
    if not named:
        assert asked.rate is not None
        first = next(iter([*wanted, *vectors]))
        return np.arange(vectors[first].size or 0) / asked.rate
    abscissa = values[named]
    where = f"{source}: {named}"
    if np.iscomplexobj(abscissa):
        raise MeasurementError("expected real numbers, found complex ones", where, REMEDY)
    check_abscissa(np.real(abscissa), where)
    return np.real(abscissa)


def _function(
    name: str,
    response: str,
    reference: str,
    vector: Array | Complex,
    abscissa: Array,
    kind: Kind,
    source: str,
    asked: Asked,
) -> Function:
    where = f"{source}: {name}"
    if vector.size != abscissa.size:
        what = f"expected {abscissa.size} values, one for each time or frequency, found {vector.size}"
        raise MeasurementError(what, where, "save vectors of one length, or remove this one")
    inside = within(abscissa, None if kind is Kind.TIME else asked.band)
    check_finite(vector[inside], where, inside.start)
    if kind is not Kind.TIME:
        vector = np.where(np.isfinite(vector), vector, np.nan)
    if kind is Kind.TIME and np.iscomplexobj(vector):
        what = "expected a real signal, found complex values"
        raise MeasurementError(what, where, 'name the abscissa "frequency" if these are frequency responses')
    if kind is not Kind.TIME:
        kind = Kind.FRF if np.iscomplexobj(vector) else Kind.SPECTRUM
    force = kind is Kind.TIME and name == FORCE
    return Function(kind, response, reference, abscissa, vector, None, None, force)


def recognises(head: bytes) -> bool:
    """Return whether a file is one of MATLAB from version 5 on, also one that cannot be read here."""
    return head.startswith((b"MATLAB 5.0 MAT-file", b"MATLAB 7.3 MAT-file", HDF5))


MATLAB = Format("MATLAB", (".mat",), recognises, read)
