"""Universal files: functions in datasets 58 and 58b, modes in 55, units in 164; other datasets are skipped.

The structure of the whole file is checked, so that a file that was cut off is refused.  A cut exactly between two
datasets leaves a complete file: nothing in this format says how many there should be.
"""

from __future__ import annotations

from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.signals.ascii_numbers import numbers_in
from pkmodes.signals.dataset55 import read_mode
from pkmodes.signals.dataset58 import read_points
from pkmodes.signals.formats import Asked, SignalFormat
from pkmodes.signals.functions import Function, ModeShape, SignalFile
from pkmodes.signals.functions58 import Abscissas, function_of
from pkmodes.signals.scanning import Binary, Scanner, begins_with_a_dataset
from pkmodes.signals.units import FileUnits

MODES, FUNCTIONS, UNITS = 55, 58, 164


def read(path: Path, asked: Asked) -> SignalFile:
    """Read a universal file.

    Raises
    ------
    MeasurementError
        If a dataset is damaged or incomplete.
    """
    source = fspath(path)
    functions: list[Function] = []
    modes: list[ModeShape] = []
    messages: list[str] = []
    units, abscissas = FileUnits(), Abscissas()
    with path.open("rb") as file:
        scanner = Scanner(file, path.stat().st_size, source)
        for dataset in scanner.datasets():
            found: Function | ModeShape | str | None = None
            if dataset.number == FUNCTIONS:
                points = read_points(scanner, dataset.binary, path)
                found = function_of(points, units, abscissas, asked)
            elif dataset.binary is not None:
                _skip(scanner, dataset.binary)
            elif dataset.number == MODES:
                found = read_mode(scanner)
            elif dataset.number == UNITS:
                units = _units(scanner)
            else:
                scanner.skip_to_end()
            if isinstance(found, Function):
                functions.append(found)
            elif isinstance(found, ModeShape):
                modes.append(found)
            elif found is not None:
                messages.append(f"{dataset.where}: skipped: {found}")
    return SignalFile(source, tuple(functions), tuple(modes), tuple(messages))


def _skip(scanner: Scanner, binary: Binary) -> None:
    """Skip a binary dataset."""
    for number in range(binary.lines):
        scanner.line(f"line {number + 1} of the header")
    scanner.skip_bytes(binary.bytes)
    scanner.close()


def _units(scanner: Scanner) -> FileUnits:
    """Read dataset 164: how many of the file's units of length and of force make one of SI."""
    scanner.line("the code of the units")
    factors = numbers_in(scanner.line("the factors of the units"))
    if factors is None or factors.size < 2 or not np.all(np.isfinite(factors) & (factors > 0.0)):
        scanner.refuse("expected the factors of the units of length and force")
    scanner.skip_to_end()
    return FileUnits.of(float(factors[0]), float(factors[1]))


UNIVERSAL_FILE = SignalFormat("universal file", (".uff", ".unv", ".ufb", ".uf"), begins_with_a_dataset, read)
