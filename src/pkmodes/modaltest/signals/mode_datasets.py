"""Modes of universal files: datasets 55 and 2414.

A normal mode has its frequency and damping; a complex one its eigenvalue, from which both follow
(https://www.ceas3.uc.edu/sdrluff/files/55.asc and 2414.asc).  Half of a structural damping is the ratio of critical
damping.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from pkmodes.core.base.errors import shown
from pkmodes.modaltest.signals.dataset58 import DIRECTIONS
from pkmodes.modaltest.signals.functions import Array, ModeShape
from pkmodes.modaltest.signals.scanning import Scanner, decode_line, is_delimiter, parse_numbers

#: Analysis types of modes: normal, and complex of first and second order.
NORMAL_MODE, MODE_TYPES = 2, (2, 3, 7)
#: Data types of values, of single and double precision.
REAL_TYPES, COMPLEX_TYPES = (2, 4), (5, 6)
#: Components at a node by the data characteristic: translations, or translations and rotations.
COMPONENTS = {2: 3, 3: 6}
#: The code of data at nodes in dataset 2414.
AT_NODES = 1


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
    kinds = _read_numbers(scanner, 6, "the kind of the data")
    analysis, characteristic, data_type, components = (int(kinds[i]) for i in (1, 2, 4, 5))
    sizes = _read_numbers(scanner, 2, "the numbers of integers and reals", allow_more=True)
    integers, reals = int(sizes[0]), int(sizes[1])
    if not (0 <= integers <= 1000 and 0 <= reals <= 1000):
        scanner.refuse(f"expected the numbers of integers and reals, found {integers} and {reals}")
    integers_read = sizes.size - 2
    while integers_read < integers:
        integers_read += _read_numbers(scanner, 1, "the integers of the header", allow_more=True).size
    real_values = _collect_numbers(scanner, reals, "the reals of the header")
    min_reals = 1 if analysis == NORMAL_MODE else 2
    if analysis in MODE_TYPES and real_values.size < min_reals:
        scanner.refuse(f"expected the frequency or eigenvalue of the mode, found {real_values.size} numbers")
    values = [float(number) for number in real_values] + [0.0] * 4
    pole = Pole(values[0], values[2], values[3], complex(*values[:2]))
    return _read_mode(scanner, analysis, (characteristic, components, data_type), pole)


def read_2414(scanner: Scanner) -> ModeShape | str:
    """Read a dataset 2414 to its end: see `read_55`."""
    for number in range(1, 3):
        scanner.line(f"line {number} of the header")
    (location,) = _read_numbers(scanner, 1, "the location of the data")
    for number in range(4, 9):
        scanner.line(f"line {number} of the header")
    kinds = _read_numbers(scanner, 6, "the kind of the data")
    analysis, characteristic, data_type, components = (int(kinds[i]) for i in (1, 2, 4, 5))
    if location != AT_NODES or analysis not in MODE_TYPES:  # before reading its numbers, which may be missing
        scanner.skip_to_end()
        return f"analysis type {analysis} at location {location:g} is not a mode at nodes"
    _read_numbers(scanner, 8, "the integers of the analysis")
    _read_numbers(scanner, 2, "the integers of the history")
    _, frequency, _, _, viscous, structural = _read_numbers(
        scanner, 6, "the frequency and damping of the mode"
    )
    eigenvalue = _read_numbers(scanner, 6, "the eigenvalue of the mode")
    pole = Pole(float(frequency), float(viscous), float(structural), complex(*eigenvalue[:2]))
    return _read_mode(scanner, analysis, (characteristic, components, data_type), pole)


def _read_mode(scanner: Scanner, analysis: int, form: tuple[int, int, int], pole: Pole) -> ModeShape | str:
    """Return the mode after a header with the characteristic, components and data type of its values."""
    characteristic, components, data_type = form
    if analysis not in MODE_TYPES:
        scanner.skip_to_end()
        return f"analysis type {analysis} is not a mode"
    if COMPONENTS.get(characteristic) != components or data_type not in (*REAL_TYPES, *COMPLEX_TYPES):
        scanner.skip_to_end()
        return (
            f"{components} components of characteristic {characteristic} are not translations and rotations"
        )
    is_complex = data_type in COMPLEX_TYPES
    shape: dict[str, complex] = {}
    while not is_delimiter(line := scanner.line("a node, or a line -1 that closes the dataset")):
        try:
            node = int(line)
        except ValueError:
            scanner.refuse(f"expected the number of a node, found {shown(decode_line(line).strip())}")
        count, where = components * (2 if is_complex else 1), f"the values at node {node}"
        numbers = _collect_numbers(scanner, count, where)
        values = numbers.view(np.complex128) if is_complex else numbers
        names = [f"{node}{DIRECTIONS[number]}" for number in range(1, components + 1)]
        if names[0] in shape:
            problem = f"expected each node once, found node {node} again"
            scanner.refuse(problem, "export one mode in each dataset")
        shape |= {name: complex(value) for name, value in zip(names, values, strict=True)}
    if not shape:
        scanner.refuse("expected a node, found none")
    if analysis == NORMAL_MODE:
        frequency, damping = pole.frequency, pole.viscous or pole.structural / 2.0
    else:
        magnitude = abs(pole.eigenvalue)
        frequency, damping = (
            magnitude / (2.0 * math.pi),
            -pole.eigenvalue.real / magnitude if magnitude else 0.0,
        )
    if frequency < 0.0:
        scanner.refuse(f"expected a frequency of 0 or above, found {frequency:g} Hz")
    if frequency == 0.0:
        return "a mode of frequency 0 is a rigid-body motion"
    return ModeShape(frequency, damping or None, shape)


def _collect_numbers(scanner: Scanner, count: int, subject: str) -> Array:
    """Return numbers that may fill several lines."""
    numbers = np.empty(0)
    while numbers.size < count:
        numbers = np.concatenate([numbers, _read_numbers(scanner, 1, subject, allow_more=True)])
    if numbers.size > count:
        scanner.refuse(f"expected {count} numbers for {subject}, found {numbers.size}")
    return numbers


def _read_numbers(scanner: Scanner, count: int, subject: str, allow_more: bool = False) -> Array:
    """Return the numbers in the next line: `count` of them, or at least as many."""
    line = scanner.line(subject)
    numbers = None if is_delimiter(line) else parse_numbers(line)
    if numbers is None or numbers.size < count or (numbers.size > count and not allow_more):
        scanner.refuse(f"expected {subject}, found {shown(decode_line(line).strip())}")
    if not np.all(np.isfinite(numbers)):
        scanner.refuse(f"expected {subject}, found a number that is not finite")
    return numbers
