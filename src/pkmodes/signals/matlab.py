"""MATLAB files up to version 7: ``time`` or ``frequency``, ``force``, and one vector for each sensor under its name.

A complex vector with ``frequency`` is a frequency response, ``NAME`` or ``NAME__REF``; a real one a spectrum.
"""

from __future__ import annotations

from os import fspath
from pathlib import Path
from typing import Any

import numpy as np

from pkmodes.base.errors import MeasurementError
from pkmodes.signals.checks import FEWEST, check_abscissa, check_finite
from pkmodes.signals.formats import Asked, SignalFormat
from pkmodes.signals.functions import Array, Complex, Function, Kind, SignalFile
from pkmodes.signals.matlab_arrays import Variable, variables

TIME, FREQUENCY, FORCE = "time", "frequency", "force"
REFERENCE = "__"
HDF5 = b"\x89HDF\r\n\x1a\n"
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
    skipped: dict[str, str] = {}
    vectors: dict[str, Array | Complex] = {}
    for name, what, values in _variables(path, head, source):
        if name in vectors:
            raise MeasurementError("expected each name once, found it again", f"{source}: {name}", REMEDY)
        if values is not None and values.size >= FEWEST:
            vectors[name] = values
        elif asked.sensors is not None and name in asked.sensors:
            message = f"expected a vector of numbers, found {what}"
            raise MeasurementError(message, f"{source}: {name}", "save one vector for each sensor")
        else:
            skipped[name] = what
    kind, abscissa = _abscissa(vectors, skipped, source, asked)
    functions = []
    for name, vector in vectors.items():
        if name in (TIME, FREQUENCY) or (name == FORCE and kind is not Kind.TIME):
            continue
        response, _, reference = name.partition(REFERENCE) if kind is not Kind.TIME else (name, "", "")
        if not (asked.wants(response, name) or (name == FORCE and kind is Kind.TIME)):
            continue
        functions.append(_function(name, response, reference, vector, abscissa, kind, source))
    messages = [
        f"{source}: {name}: skipped: {what} is not a vector of numbers" for name, what in skipped.items()
    ]
    return SignalFile(source, tuple(functions), (), tuple(messages))


def _variables(path: Path, head: bytes, source: str) -> list[Variable]:
    """Return all variables of a file."""
    try:
        if b"\0" in head[:4]:  # version 4 has no text at its beginning
            from scipy.io import loadmat

            content = loadmat(path, appendmat=False)
            return [
                _of_version_4(name, value) for name, value in content.items() if not name.startswith("__")
            ]
        return list(variables(path.read_bytes()))
    except OSError as error:
        if error.errno is not None:
            raise
        reason: Exception = error
    except Exception as error:  # damage makes SciPy raise errors of many types
        reason = error
    what = f"cannot read the MATLAB file: {str(reason) or type(reason).__name__}"
    raise MeasurementError(what, source, f"the file is damaged or no MATLAB file: {REMEDY}") from None


def _of_version_4(name: str, value: Any) -> Variable:
    """Return a variable of a file of version 4, which has matrices only."""
    numeric = isinstance(value, np.ndarray) and value.dtype.kind in "biufc"
    what = f"an array of {' x '.join(map(str, np.shape(value)))} values" if numeric else "text"
    if not numeric or value.ndim != 2 or min(value.shape) != 1:
        return Variable(name, what, None)
    if value.dtype.kind == "c":
        return Variable(name, what, value.ravel().astype(np.complex128))
    return Variable(name, what, value.ravel().astype(np.float64))


def _abscissa(
    vectors: dict[str, Array | Complex], skipped: dict[str, str], source: str, asked: Asked
) -> tuple[Kind, Array]:
    """Return whether the file is of time signals or functions of frequency, and their abscissa."""
    named = [name for name in (TIME, FREQUENCY) if name in vectors]
    if len(named) == 2:
        raise MeasurementError(
            "expected a vector time or frequency, found both", source, "leave one of them out"
        )
    if not named:
        if asked.rate is None or not vectors:
            found = [*vectors, *(f"{name} ({what})" for name, what in skipped.items())]
            what = f"expected a vector time or frequency, found {', '.join(found) or 'no variables'}"
            remedy = f"{REMEDY}; or give the rate in the record"
            raise MeasurementError(what, source, remedy)
        wanted = [vector for name, vector in vectors.items() if asked.wants(name)] or list(vectors.values())
        return Kind.TIME, np.arange(wanted[0].size) / asked.rate
    abscissa = vectors[named[0]]
    where = f"{source}: {named[0]}"
    if np.iscomplexobj(abscissa):
        raise MeasurementError("expected real numbers, found complex ones", where, REMEDY)
    check_abscissa(np.real(abscissa), where)
    return Kind.TIME if named[0] == TIME else Kind.FRF, np.real(abscissa)


def _function(
    name: str,
    response: str,
    reference: str,
    vector: Array | Complex,
    abscissa: Array,
    kind: Kind,
    source: str,
) -> Function:
    where = f"{source}: {name}"
    if vector.size != abscissa.size:
        what = f"expected {abscissa.size} values, one for each time or frequency, found {vector.size}"
        raise MeasurementError(what, where, "save vectors of one length, or remove this one")
    check_finite(vector, where)
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


MATLAB = SignalFormat("MATLAB", (".mat",), recognises, read)
