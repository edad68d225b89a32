"""Writes universal files, binary datasets 58b, by the letter of the format: nothing here uses the reader.

References
----------
University of Cincinnati, Structural Dynamics Research Laboratory. Universal file formats: dataset 58,
https://www.ceas3.uc.edu/sdrluff/files/58.asc and 58b.asc.
"""

from __future__ import annotations

import numpy as np

#: Function types, and specific data types of ordinates and abscissas.
TIME, FRF, COHERENCE = 1, 4, 6
ACCELERATION, FORCE, NOTHING = 12, 13, 0
TIMES, FREQUENCIES = 17, 18
#: Single precision, real and complex.
REAL, COMPLEX = 2, 5

Dof = tuple[int, int]


def dataset(
    function: int,
    response: Dof,
    reference: Dof,
    start: float,
    step: float,
    values: np.ndarray,
    quantity: int = ACCELERATION,
    unit: str = "m/s^2",
) -> bytes:
    """Return a dataset of a function with an even abscissa, in single precision, little-endian.

    Parameters
    ----------
    function : int
        `TIME`, `FRF` or `COHERENCE`.
    response, reference : tuple of two ints
        Node, and direction: 1 to 3 for x, y, z, negative for the opposite one.
    start, step : float
        Of the abscissa [s, Hz].
    values : ndarray, shape (N,)
    quantity, unit
        Of the ordinate.
    """
    is_complex = np.iscomplexobj(values)
    data = np.asarray(values, dtype="<c8" if is_complex else "<f4").tobytes()
    abscissa = (TIMES, "s") if function == TIME else (FREQUENCIES, "Hz")
    denominator = (FORCE, "N") if function == FRF else (NOTHING, "NONE")
    # Byte order 1 is little-endian, form 2 is IEEE 754; 11 lines of text, then so many bytes.
    head = f"    -1\n    58b{1:6d}{2:6d}{11:12d}{len(data):12d}{0:6d}{0:6d}{0:12d}{0:12d}\n"
    lines = ["NONE"] * 5
    lines.append(
        f"{function:5d}{1:10d}{0:5d}{0:10d} {'NONE':<10}{response[0]:10d}{response[1]:4d}"
        f" {'NONE':<10}{reference[0]:10d}{reference[1]:4d}"
    )
    form = COMPLEX if is_complex else REAL
    lines.append(f"{form:10d}{len(values):10d}{1:10d}{start:13.5e}{step:13.5e}{0.0:13.5e}")
    for data_type, label in (abscissa, (quantity, unit), denominator, (NOTHING, "NONE")):
        lines.append(f"{data_type:10d}{0:5d}{0:5d}{0:5d} {'NONE':<20} {label:<20}")
    return (head + "".join(f"{line}\n" for line in lines)).encode("ascii") + data + b"\n    -1\n"
