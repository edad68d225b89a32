"""Universal files: functions in datasets 58 and 58b, modes in 55 and 2414, units in 164, nodes in 15 and 2411.

Of nodes, only their axes are used: a direction is along those of its node.  The campaign states where sensors are.
Other datasets are skipped.

Functions that occur several times, alike in kind and degrees of freedom, are told apart by their place in the file:
``1:+Z#2`` is the second.

The structure of the whole file is checked, so that a file that was cut off is refused.  A cut exactly between two
datasets leaves a complete file: nothing in this format says how many there should be.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.support.ordering import listed
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.dataset58 import read_points
from pkmodes.modaltest.signals.functions import Function, ModeShape, SignalFile, SignalRequest
from pkmodes.modaltest.signals.functions58 import Abscissas, function_of
from pkmodes.modaltest.signals.mode_datasets import read_55, read_2414
from pkmodes.modaltest.signals.scanning import (
    Scanner,
    begins_with_a_dataset,
    is_delimiter,
    numbers_in,
)
from pkmodes.modaltest.signals.units import FileUnits

#: The name of a function that occurs several times.
NUMBERED = re.compile(r"(.+)#[0-9]+")
#: Numbers of the datasets of functions and of units.
FUNCTIONS, UNITS = 58, 164
#: Readers of the datasets of modes, by number.
MODES = {55: read_55, 2414: read_2414}
#: Lines for each node in the datasets of nodes, by number.
NODES = {15: 1, 2411: 2}
#: Content of other datasets, reported if a file has nothing else.
OTHERS = {15: "nodes", 18: "coordinate systems", 82: "trace lines, which are for drawing", 151: "a header"}
OTHERS |= {2411: "nodes", 2412: "elements", 2420: "coordinate systems"}


def read_universal(path: Path, request: SignalRequest) -> SignalFile:
    """Read a universal file.

    Raises MeasurementError if a dataset is damaged or incomplete.
    """
    sensors = request.sensors
    if sensors is not None:
        bases = (match[1] for name in sensors if (match := NUMBERED.fullmatch(name)) is not None)
        request = replace(request, sensors=sensors.union(bases))
    content, late = _read(path, request, FileUnits())
    if late is not None:
        del content  # its functions, which may be large, were read before their units were known
        content, _ = _read(path, request, late)
    return replace(content, functions=tuple(_numbered(content.functions, sensors)))


def _numbered(functions: Sequence[Function], sensors: Collection[str] | None) -> Iterator[Function]:
    """Yield functions by the names of sensors, which may have numbers; without a number, all functions of that name.

    If `sensors` is None, all but the first of each name get their numbers.
    """
    counts = Counter[tuple[str, str, str, bool]]()
    for function in functions:
        key = (function.kind, function.response, function.reference, function.force)
        counts[key] += 1
        number = f"{function.response}#{counts[key]}"
        if function.force or (sensors is None and counts[key] == 1):
            yield function
        elif sensors is None or number in sensors:
            yield replace(function, response=number)
        elif function.response in sensors and (
            counts[key] == 1 or not any(name.startswith(f"{function.response}#") for name in sensors)
        ):
            yield function


def _read(path: Path, request: SignalRequest, units: FileUnits) -> tuple[SignalFile, FileUnits | None]:
    """Read a universal file that is in these units until it states others.

    Returns, in this order:
    - content
    - late: units that it states only after functions, to which they also apply
    """
    source = fspath(path)
    functions: list[Function] = []
    modes: list[ModeShape] = []
    skipped: dict[str, list[str]] = {}
    stated: FileUnits | None = None
    late = False
    contradictions: list[tuple[str, FileUnits, FileUnits]] = []
    abscissas = Abscissas()
    other_datasets: dict[int, None] = {}
    axes: dict[str, str] = {}
    with path.open("rb") as file:
        scanner = Scanner(file, path.stat().st_size, source)
        for dataset in scanner.datasets():
            outcome: Function | ModeShape | str | None = None
            if dataset.number == FUNCTIONS:
                points = read_points(scanner, dataset.binary, path)
                outcome = function_of(points, units, abscissas, request)
            elif dataset.binary is not None:
                scanner.skip_binary(dataset.binary)
            elif dataset.number in MODES:
                outcome = MODES[dataset.number](scanner)
            elif dataset.number == UNITS:
                before, stated = stated, _units(scanner)
                late |= bool(functions) and stated != units
                units = stated
                if before is not None and before != stated:
                    contradictions.append((scanner.where, before, stated))
            elif dataset.number in NODES:
                axes |= _axes(scanner, NODES[dataset.number])
                other_datasets[dataset.number] = None
            else:
                scanner.skip_to_end()
                other_datasets[dataset.number] = None
            if isinstance(outcome, Function):
                functions.append(outcome)
            elif isinstance(outcome, ModeShape):
                modes.append(outcome)
            elif outcome is not None:
                skipped.setdefault(outcome, []).append(dataset.where)
    # Units apply to the whole file, wherever they are stated; shapes of modes have none.
    if functions and contradictions:
        where, *systems = contradictions[0]
        first, second = (
            f"{system.length or 'another length'} and {system.force or 'another force'}" for system in systems
        )
        problem = f"expected one system of units, found {second} after {first}"
        raise MeasurementError(problem, where, "write the functions in each system into a file of their own")
    messages = tuple(f"{places[0]}: skipped: {_counted(why, places)}" for why, places in skipped.items())
    whys = [_counted(why, places) for why, places in skipped.items()]
    whys += [f"dataset {number} holds {OTHERS.get(number, 'what is not read')}" for number in other_datasets]
    used = [function.response for function in functions] + [name for mode in modes for name in mode.shape]
    all_messages = (*messages, *_different_axes(used, axes, source))
    content = SignalFile(source, tuple(functions), tuple(modes), all_messages, skipped=tuple(whys))
    return content, stated if late else None


def _axes(scanner: Scanner, lines: int) -> dict[str, str]:
    """Read nodes: return the coordinate system of the displacements at each; empty if any line is no node.

    https://www.ceas3.uc.edu/sdrluff/files/15.asc and 2411.asc.
    """
    systems: dict[str, str] = {}
    count, damaged = 0, False
    while not is_delimiter(line := scanner.line("a node, or a line -1 that closes the dataset")):
        node, _, system = (line[start : start + 10].strip().decode("latin-1") for start in (0, 10, 20))
        if count % lines == 0:
            damaged |= not (node.isdigit() and system.isdigit())
            systems[node] = system
        count += 1
    return {} if damaged else systems


def _different_axes(names: Sequence[str], axes: Mapping[str, str], source: str) -> list[str]:
    """Return a message if the directions of a file are along different axes."""
    nodes = dict.fromkeys(name.partition(":")[0] for name in names)
    systems = {node: axes[node] for node in nodes if node in axes}
    if len(set(systems.values())) < 2:
        return []
    listing = listed([f"{system} at node {node}" for node, system in systems.items()], 4)
    return [
        f"{source}: directions are along axes that differ from node to node, those of coordinate system {listing}: a "
        "direction in the campaign has to be that of its node's axis"
    ]


def _counted(why: str, places: Sequence[str]) -> str:
    """Return why datasets were skipped, and their number if there are several."""
    return why if len(places) == 1 else f"{why} ({len(places)} datasets)"


def _units(scanner: Scanner) -> FileUnits:
    """Read dataset 164: the numbers of the file's units of length and force in one of SI."""
    scanner.line("the code of the units")
    factors = numbers_in(scanner.line("the factors of the units"))
    if factors is None or factors.size < 2 or not np.all(np.isfinite(factors) & (factors > 0.0)):
        scanner.refuse("expected the factors of the units of length and force")
    scanner.skip_to_end()
    return FileUnits.of(float(factors[0]), float(factors[1]))


UNIVERSAL_FILE = Format(
    "universal file", (".uff", ".unv", ".ufb", ".uf"), begins_with_a_dataset, read_universal
)
