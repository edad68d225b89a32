"""Universal files: functions in datasets 58 and 58b, modes in 55 and 2414, units in 164; other datasets are skipped.

The structure of the whole file is checked, so that a file that was cut off is refused.  A cut exactly between two
datasets leaves a complete file: nothing in this format says how many there should be.
"""

from __future__ import annotations

from collections.abc import Sequence
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.measured.formats import Format
from pkmodes.signals.dataset58 import read_points
from pkmodes.signals.functions import Asked, Function, ModeShape, SignalFile
from pkmodes.signals.functions58 import Abscissas, function_of
from pkmodes.signals.mode_datasets import read_55, read_2414
from pkmodes.signals.scanning import Binary, Scanner, begins_with_a_dataset, numbers_in
from pkmodes.signals.units import FileUnits

#: Numbers of the datasets that are read.
FUNCTIONS, UNITS = 58, 164
#: Those of modes, and their readers.
MODES = {55: read_55, 2414: read_2414}


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
    skipped: dict[str, list[str]] = {}
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
            elif dataset.number in MODES:
                found = MODES[dataset.number](scanner)
            elif dataset.number == UNITS:
                units = _units(scanner)
            else:
                scanner.skip_to_end()
            if isinstance(found, Function):
                functions.append(found)
            elif isinstance(found, ModeShape):
                modes.append(found)
            elif found is not None:
                skipped.setdefault(found, []).append(dataset.where)
    messages = tuple(f"{places[0]}: skipped: {_counted(why, places)}" for why, places in skipped.items())
    whys = tuple(_counted(why, places) for why, places in skipped.items())
    return SignalFile(source, tuple(functions), tuple(modes), messages, skipped=whys)


def _counted(why: str, places: Sequence[str]) -> str:
    """Return why datasets were skipped, and how many if it is several."""
    return why if len(places) == 1 else f"{why} ({len(places)} datasets)"


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


UNIVERSAL_FILE = Format("universal file", (".uff", ".unv", ".ufb", ".uf"), begins_with_a_dataset, read)
