"""Universal files: functions in datasets 58 and 58b, modes in 55, units in 164; other datasets are skipped.

The structure of the whole file is checked, so that a file that was cut off is refused.  A cut exactly between two
datasets leaves a complete file: nothing in this format says how many there should be.

A normal mode of dataset 55 has its frequency and damping; a complex one its eigenvalue, from which both follow
(https://www.ceas3.uc.edu/sdrluff/files/55.asc).  Of structural damping, half counts as ratio of critical damping.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import shown
from pkmodes.measured.formats import Format
from pkmodes.signals.dataset58 import DIRECTIONS, read_points
from pkmodes.signals.functions import Array, Asked, Function, ModeShape, SignalFile
from pkmodes.signals.functions58 import Abscissas, function_of
from pkmodes.signals.scanning import Binary, Scanner, begins_with_a_dataset, is_delimiter, numbers_in, text_of
from pkmodes.signals.units import FileUnits

#: Numbers of the datasets that are read.
MODES, FUNCTIONS, UNITS = 55, 58, 164
#: In dataset 55: the analysis types of modes, and the data types of their values.
NORMAL, COMPLEX_FIRST_ORDER, COMPLEX_SECOND_ORDER = 2, 3, 7
REAL, COMPLEX = 2, 5
#: Components at a node by the data characteristic of dataset 55: translations, or translations and rotations.
COMPONENTS = {2: 3, 3: 6}


def read_mode(scanner: Scanner) -> ModeShape | str:
    """Read a dataset 55 to its end.

    Parameters
    ----------
    scanner : Scanner
        At the line after the number of the dataset.

    Returns
    -------
    ModeShape or str
        The mode, or why the dataset is none.

    Raises
    ------
    MeasurementError
        If it is not what it declares to be.
    """
    for number in range(1, 6):
        scanner.line(f"line {number} of the header")
    kinds = _numbers(scanner, 6, "the kind of the data")
    analysis, characteristic, data_type, components = (int(kinds[i]) for i in (1, 2, 4, 5))
    sizes = _numbers(scanner, 2, "the numbers of integers and reals", more=True)
    integers, reals = int(sizes[0]), int(sizes[1])
    if not (0 <= integers <= 1000 and 0 <= reals <= 1000):
        scanner.refuse(f"expected the numbers of integers and reals, found {integers} and {reals}")
    taken = sizes.size - 2
    while taken < integers:
        taken += _numbers(scanner, 1, "the integers of the header", more=True).size
    specific = _collected(scanner, reals, "the reals of the header")
    if analysis not in (NORMAL, COMPLEX_FIRST_ORDER, COMPLEX_SECOND_ORDER):
        scanner.skip_to_end()
        return f"analysis type {analysis} is not a mode"
    if COMPONENTS.get(characteristic) != components or data_type not in (REAL, COMPLEX):
        scanner.skip_to_end()
        return (
            f"{components} components of characteristic {characteristic} are not translations and rotations"
        )
    shape = _shape(scanner, components, data_type == COMPLEX)
    frequency, damping = _pole(scanner, analysis, specific)
    if frequency == 0.0:
        return "a mode of frequency 0 is a motion of the whole body"
    return ModeShape(frequency, damping, shape)


def _pole(scanner: Scanner, analysis: int, specific: Array) -> tuple[float, float | None]:
    """Return the undamped frequency [Hz], and the damping ratio where there is one."""
    needed = 1 if analysis == NORMAL else 2
    if specific.size < needed:
        scanner.refuse(f"expected the frequency or eigenvalue of the mode, found {specific.size} numbers")
    if analysis == NORMAL:
        frequency = float(specific[0])
        viscous, structural = (float(specific[i]) if specific.size > i else 0.0 for i in (2, 3))
        damping = viscous or structural / 2.0
    else:
        real, imaginary = map(float, specific[:2])
        size = math.hypot(real, imaginary)
        frequency, damping = size / (2.0 * math.pi), -real / size if size else 0.0
    if frequency < 0.0:
        scanner.refuse(f"expected a frequency of 0 or above, found {frequency:g} Hz")
    return frequency, damping or None


def _shape(scanner: Scanner, components: int, is_complex: bool) -> dict[str, complex]:
    """Return the components at all nodes, and read the line that closes the dataset."""
    shape: dict[str, complex] = {}
    while not is_delimiter(line := scanner.line("a node, or a line -1 that closes the dataset")):
        try:
            node = int(line)
        except ValueError:
            scanner.refuse(f"expected the number of a node, found {shown(text_of(line).strip())}")
        numbers = _collected(scanner, components * (2 if is_complex else 1), f"the values at node {node}")
        values = numbers.view(np.complex128) if is_complex else numbers
        names = [f"{node}{DIRECTIONS[number]}" for number in range(1, components + 1)]
        if names[0] in shape:
            scanner.refuse(
                f"expected each node once, found node {node} again", "export one mode in each dataset"
            )
        shape |= {name: complex(value) for name, value in zip(names, values, strict=True)}
    if not shape:
        scanner.refuse("expected a node, found none")
    return shape


def _collected(scanner: Scanner, count: int, what: str) -> Array:
    """Return numbers that may fill several lines."""
    found = np.empty(0)
    while found.size < count:
        found = np.concatenate([found, _numbers(scanner, 1, what, more=True)])
    if found.size > count:
        scanner.refuse(f"expected {count} numbers for {what}, found {found.size}")
    return found


def _numbers(scanner: Scanner, count: int, what: str, more: bool = False) -> Array:
    """Return the numbers in the next line: `count` of them, or at least as many."""
    line = scanner.line(what)
    numbers = None if is_delimiter(line) else numbers_in(line)
    if numbers is None or numbers.size < count or (numbers.size > count and not more):
        scanner.refuse(f"expected {what}, found {shown(text_of(line).strip())}")
    if not np.all(np.isfinite(numbers)):
        scanner.refuse(f"expected {what}, found a number that is too large")
    return numbers


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
