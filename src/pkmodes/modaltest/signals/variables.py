"""Variables in files of named arrays, of MATLAB and of NumPy, and the errors of reading their values."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from itertools import islice
from typing import Any, NamedTuple, NoReturn, TypeVar

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError

T = TypeVar("T")
#: Numbers of any type, as stored in files.
Values = NDArray[Any]
#: Maximum number of values read from a file, in all.
MAX_VALUES = 100_000_000
#: Maximum size of unpacked arrays in bytes: a base, and this multiple of the file's size.  Measured signals of double
#: precision compress to no less than a tenth of their size, except for constant channels.
BASE_SIZE, MAX_EXPANSION = 64_000_000, 20
#: Maximum number of variables of a file, including the fields of its structs.
MAX_VARIABLES = 20_000
#: Maximum number of letters of a name; MATLAB allows 63, and names of fields include those of all enclosing structs.
MAX_NAME_LENGTH = 1024
REMEDY = "save time or frequency, or fs, and a vector for each sensor or a matrix with a column for each"


class FileVariable(NamedTuple):
    """A variable.

    - description: description for messages
    - shape: shape of an array of numbers
    - load: returns the values of an array, columns one after the other, while the file is open.  Raises `ValueError`.
    - itemsize: bytes of a loaded value
    - reload: for whole numbers: returns the values again after the file was closed
    """

    name: str
    description: str
    shape: tuple[int, ...] | None
    load: Callable[[], Values]
    itemsize: int = 8
    reload: Callable[[], Values] | None = None

    @property
    def size(self) -> int:
        """Number of values, 0 if it is not an array of numbers."""
        return int(np.prod(self.shape, dtype=np.float64)) if self.shape else 0

    @property
    def lengths(self) -> tuple[int, ...]:
        """Its sizes along the dimensions that have more than one value."""
        return tuple(length for length in self.shape or () if length != 1)


def refuse_values(name: str) -> NoReturn:
    """Raise the error of a variable that is not an array of numbers.

    Raises ValueError.
    """
    raise ValueError(f"{name} is not an array of numbers")


def collect_variables(variables: Iterable[FileVariable]) -> list[FileVariable]:
    """Return the variables of a file.

    Raises ValueError if there are more than any measurement has.
    """
    collected = list(islice(variables, MAX_VARIABLES + 1))
    if len(collected) > MAX_VARIABLES:
        raise ValueError(f"expected at most {MAX_VARIABLES:,} variables, found more")
    return collected


def load_or_refuse(load: Callable[[], T], source: str, file_kind: str) -> T:
    """Return the result of `load`, turning any failure into the error of an unreadable file.

    Raises MeasurementError if it cannot be read.
    """
    try:
        return load()
    except OSError as error:
        if error.errno is not None:
            raise
        reason: Exception = error
    except Exception as error:  # damage makes readers raise errors of many types
        reason = error
    text = f"cannot read the {file_kind} file: {str(reason) or type(reason).__name__}"
    raise MeasurementError(text, source, f"the file is damaged or no {file_kind} file: {REMEDY}") from None
