"""Dataset 55 of universal files, data at nodes: normal and complex modes.

A normal mode has its frequency and damping; a complex one its eigenvalue, from which both follow
(https://www.ceas3.uc.edu/sdrluff/files/55.asc).  Of structural damping, half counts as ratio of critical damping.
"""

from __future__ import annotations

import math

import numpy as np

from pkmodes.core.base.errors import shown
from pkmodes.signals.ascii_numbers import numbers_in
from pkmodes.signals.functions import Array, ModeShape
from pkmodes.signals.header58 import DIRECTIONS
from pkmodes.signals.scanning import Scanner, is_delimiter, text_of

NORMAL, COMPLEX_FIRST_ORDER, COMPLEX_SECOND_ORDER = 2, 3, 7
REAL, COMPLEX = 2, 5
#: Numbers of components at a node by what the dataset calls their characteristic: translations, with rotations.
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
