"""Measured frequency responses from files of signals, such as the tables that `pkmodes response` itself writes."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from os import PathLike, fspath

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, PkmodesError, nearest_name, shown
from pkmodes.modaltest.signals.functions import FunctionKind
from pkmodes.modaltest.signals.reading import read_signals

Array = NDArray[np.float64]
REMEDY = "a table has the columns frequency [Hz], and re:OUTPUT/INPUT and im:OUTPUT/INPUT for each channel"


@dataclass(frozen=True)
class MeasuredResponse:
    """Measured responses of F frequencies at a pose.

    Attributes
    ----------
    source : str
        The file.
    frequencies : ndarray, shape (F,)
        Ascending [Hz].
    channels : dict of str to ndarray, complex128, shape (F,)
        Responses by ``OUTPUT/INPUT``, in the units of the model's response.
    stated : mapping of str to str
        What the table's comments say of it: ``quantity``, ``drives``, and ``unit OUTPUT/INPUT``.
    notes : tuple of str
        What was assumed of it.
    """

    source: str
    frequencies: Array
    channels: dict[str, NDArray[np.complex128]]
    stated: Mapping[str, str] = field(default_factory=dict)
    notes: tuple[str, ...] = ()

    def check(self, expected: Mapping[str, str]) -> None:
        """Refuse a table that states that it is of something else.

        Parameters
        ----------
        expected : mapping of str to str
            What the model's response is, by the words of `stated`.

        Raises
        ------
        PkmodesError
            If the table states another unit, quantity or state of the motors.
        """
        for name, value in self.stated.items():
            if name in expected and value != expected[name]:
                problem = f"expected {name} {expected[name]} as in the model's response, found {shown(value)}"
                raise PkmodesError(problem, self.source, "ask the model for the same, or convert the table")

    def among(self, names: list[str]) -> dict[str, NDArray[np.complex128]]:
        """Return the channels that a response of the model has too.

        Raises
        ------
        PkmodesError
            If it has none of them.
        """
        common = {name: values for name, values in self.channels.items() if name in names}
        if not common:
            problem = f"expected a channel of {', '.join(names)}, found {', '.join(self.channels)}"
            raise PkmodesError(problem, self.source, nearest_name(next(iter(self.channels)), names))
        return common


def read_response(path: str | PathLike[str]) -> MeasuredResponse:
    """Read measured frequency responses.

    Parameters
    ----------
    path : path-like
        A universal file, a MATLAB file, or a table with a column ``frequency`` [Hz], and ``re:OUTPUT/INPUT`` and
        ``im:OUTPUT/INPUT`` for each channel; other columns are ignored.  Comments of a table may state ``# quantity:
        ...``, ``# drives: ...`` and ``# unit: OUTPUT/INPUT = ...``.

    Returns
    -------
    MeasuredResponse
        With all of its channels.

    Raises
    ------
    MeasurementError
        If the file cannot be read or is invalid, with the place in it, or has no frequency responses.
    """
    source = fspath(path)
    read = read_signals(path)
    functions = [function for function in read.functions if function.kind is FunctionKind.FRF]
    if not functions:
        raise MeasurementError("expected frequency response functions, found none", source, REMEDY)
    f, channels = functions[0].abscissa, {}
    for function in functions:
        name = f"{function.response}/{function.reference}"
        if not np.array_equal(function.abscissa, f):
            problem = f"the frequencies of {shown(name)} differ from those of the first function"
            raise MeasurementError(problem, source, "give functions of the same frequencies")
        channels[name] = np.asarray(function.values, dtype=complex)
    return MeasuredResponse(source, f, channels, read.stated)
