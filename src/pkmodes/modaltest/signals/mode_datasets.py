"""Modes of universal files: datasets 55 and 2414.

A normal mode has its frequency and damping; a complex one its eigenvalue, from which both follow
(https://www.ceas3.uc.edu/sdrluff/files/55.asc and 2414.asc).  Of structural damping, half counts as ratio of critical
damping.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from pkmodes.core.base.errors import shown
from pkmodes.modaltest.signals.dataset58 import DIRECTIONS
from pkmodes.modaltest.signals.functions import Array, ModeShape
from pkmodes.modaltest.signals.scanning import Scanner, is_delimiter, numbers_in, text_of

#: Analysis types of modes: normal, and complex of first and second order.
NORMAL, MODES = 2, (2, 3, 7)
#: Data types of values, of single and double precision.
REAL, COMPLEX = (2, 4), (5, 6)
#: Components at a node by the data characteristic: translations, or translations and rotations.
COMPONENTS = {2: 3, 3: 6}
#: The code of data at nodes in dataset 2414.
NODES = 1


class Pole(NamedTuple):
    """The pole of a mode in a header: frequency [Hz] and dampings if it is normal, or its eigenvalue [1/s]."""

    frequency: float
    viscous: float
    structural: float
    eigenvalue: complex


def read_55(scanner: Scanner) -> ModeShape | str:
    """Read a dataset 55 to its end.

    - scanner: at the line after the number of the dataset

    Returns the mode, or why the dataset is none.
    Raises MeasurementError if it does not match what it declares.
    """
    for number in range(1, 6):
        scanner.line(f"line {number} of the header")
    kinds = _numbers(scanner, 6, "the kind of the data")
    analysis, characteristic, data_type, components = (int(kinds[i]) for i in (1, 2, 4, 5))
    sizes = _numbers(scanner, 2, "the numbers of integers and reals", allow_more=True)
    integers, reals = int(sizes[0]), int(sizes[1])
    if not (0 <= integers <= 1000 and 0 <= reals <= 1000):
        scanner.refuse(f"expected the numbers of integers and reals, found {integers} and {reals}")
    taken = sizes.size - 2
    while taken < integers:
        taken += _numbers(scanner, 1, "the integers of the header", allow_more=True).size
    specific = _collected(scanner, reals, "the reals of the header")
    needed = 1 if analysis == NORMAL else 2
    if analysis in MODES and specific.size < needed:
        scanner.refuse(f"expected the frequency or eigenvalue of the mode, found {specific.size} numbers")
    values = [float(number) for number in specific] + [0.0] * 4
    pole = Pole(values[0], values[2], values[3], complex(*values[:2]))
    return _mode(scanner, analysis, (characteristic, components, data_type), pole)


def read_2414(scanner: Scanner) -> ModeShape | str:
    """Read a dataset 2414 to its end: see `read_55`."""
    for number in range(1, 3):
        scanner.line(f"line {number} of the header")
    (location,) = _numbers(scanner, 1, "the location of the data")
    for number in range(4, 9):
        scanner.line(f"line {number} of the header")
    kinds = _numbers(scanner, 6, "the kind of the data")
    analysis, characteristic, data_type, components = (int(kinds[i]) for i in (1, 2, 4, 5))
    if location != NODES or analysis not in MODES:  # before reading its numbers, which may be missing
        scanner.skip_to_end()
        return f"analysis type {analysis} at location {location:g} is not a mode at nodes"
    _numbers(scanner, 8, "the integers of the analysis")
    _numbers(scanner, 2, "the integers of the history")
    _, frequency, _, _, viscous, structural = _numbers(scanner, 6, "the frequency and damping of the mode")
    eigenvalue = _numbers(scanner, 6, "the eigenvalue of the mode")
    pole = Pole(float(frequency), float(viscous), float(structural), complex(*eigenvalue[:2]))
    return _mode(scanner, analysis, (characteristic, components, data_type), pole)


def _mode(scanner: Scanner, analysis: int, form: tuple[int, int, int], pole: Pole) -> ModeShape | str:
    """Return the mode after a header with the characteristic, components and data type of its values."""
    characteristic, components, data_type = form
    if analysis not in MODES:
        scanner.skip_to_end()
        return f"analysis type {analysis} is not a mode"
    if COMPONENTS.get(characteristic) != components or data_type not in (*REAL, *COMPLEX):
        scanner.skip_to_end()
        return (
            f"{components} components of characteristic {characteristic} are not translations and rotations"
        )
    shape = _shape(scanner, components, data_type in COMPLEX)
    if analysis == NORMAL:
        frequency, damping = pole.frequency, pole.viscous or pole.structural / 2.0
    else:
        size = abs(pole.eigenvalue)
        frequency, damping = size / (2.0 * math.pi), -pole.eigenvalue.real / size if size else 0.0
    if frequency < 0.0:
        scanner.refuse(f"expected a frequency of 0 or above, found {frequency:g} Hz")
    if frequency == 0.0:
        return "a mode of frequency 0 is a rigid-body motion"
    return ModeShape(frequency, damping or None, shape)


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


def _collected(scanner: Scanner, count: int, subject: str) -> Array:
    """Return numbers that may fill several lines."""
    numbers = np.empty(0)
    while numbers.size < count:
        numbers = np.concatenate([numbers, _numbers(scanner, 1, subject, allow_more=True)])
    if numbers.size > count:
        scanner.refuse(f"expected {count} numbers for {subject}, found {numbers.size}")
    return numbers


def _numbers(scanner: Scanner, count: int, subject: str, allow_more: bool = False) -> Array:
    """Return the numbers in the next line: `count` of them, or at least as many."""
    line = scanner.line(subject)
    numbers = None if is_delimiter(line) else numbers_in(line)
    if numbers is None or numbers.size < count or (numbers.size > count and not allow_more):
        scanner.refuse(f"expected {subject}, found {shown(text_of(line).strip())}")
    if not np.all(np.isfinite(numbers)):
        scanner.refuse(f"expected {subject}, found a number that is not finite")
    return numbers
