"""Universal files: functions in datasets 58 and 58b, modes in 55 and 2414, units in 164, nodes in 15 and 2411.

Of nodes, only their axes are used: a direction is along an axis of its node.  The campaign states where sensors are.
Other datasets are skipped.

Functions that occur several times, with the same kind and degrees of freedom, are numbered in the order of the file:
``1:+Z#2`` is the second.

The structure of the whole file is checked, so that a file that was cut off is refused.  A cut exactly between two
datasets leaves a complete file: this format does not state how many there should be.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import replace
from os import fspath
from pathlib import Path

import numpy as np

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.support.ordering import listed
from pkmodes.loop.measured.formats import Format
from pkmodes.modaltest.signals.dataset58 import read_points
from pkmodes.modaltest.signals.functions import Function, ModeShape, SignalFile, SignalRequest
from pkmodes.modaltest.signals.functions58 import SharedAbscissas, to_function
from pkmodes.modaltest.signals.mode_datasets import read_55, read_2414
from pkmodes.modaltest.signals.scanning import (
    Scanner,
    is_delimiter,
    is_universal_file,
    parse_numbers,
)
from pkmodes.modaltest.signals.units import FileUnits

#: The name of a function that occurs several times.
NUMBERED = re.compile(r"(.+)#[0-9]+")
#: Numbers of the datasets of functions and of units.
FUNCTION_DATASET, UNIT_DATASET = 58, 164
#: Readers of the datasets of modes, by number.
MODE_READERS = {55: read_55, 2414: read_2414}
#: Lines for each node in the datasets of nodes, by number.
LINES_PER_NODE = {15: 1, 2411: 2}
#: Content of other datasets, reported if a file has nothing else.
OTHER_DATASETS = {
    15: "nodes",
    18: "coordinate systems",
    82: "trace lines, which are for drawing",
    151: "a header",
}
OTHER_DATASETS |= {2411: "nodes", 2412: "elements", 2420: "coordinate systems"}


def read_universal(path: Path, request: SignalRequest) -> SignalFile:
    """Read a universal file.

    Raises MeasurementError if a dataset is damaged or incomplete.
    """
    sensors = request.sensors
    if sensors is not None:
        bases = (match[1] for name in sensors if (match := NUMBERED.fullmatch(name)) is not None)
        request = replace(request, sensors=sensors.union(bases))
    content, late_units = _read_file(path, request, FileUnits())
    if late_units is not None:
        del content  # its functions, which may be large, were read before their units were known
        content, _ = _read_file(path, request, late_units)
    # The names of sensors may have numbers; without one, a name stands for all functions of that name.  Without
    # sensors, all but the first of each name get their numbers.
    counts = Counter[tuple[str, str, str, bool]]()
    functions: list[Function] = []
    for function in content.functions:
        key = (function.kind, function.response, function.reference, function.force)
        counts[key] += 1
        number = f"{function.response}#{counts[key]}"
        if function.force or (sensors is None and counts[key] == 1):
            functions.append(function)
        elif sensors is None or number in sensors:
            functions.append(replace(function, response=number))
        elif function.response in sensors and (
            counts[key] == 1 or not any(name.startswith(f"{function.response}#") for name in sensors)
        ):
            functions.append(function)
    return replace(content, functions=tuple(functions))


def _read_file(path: Path, request: SignalRequest, units: FileUnits) -> tuple[SignalFile, FileUnits | None]:
    """Read a universal file that is in these units until it states others.

    Returns, in this order:
    - content
    - has_late_units: units that it states only after functions, to which they also apply
    """
    source = fspath(path)
    functions: list[Function] = []
    modes: list[ModeShape] = []
    skipped: dict[str, list[str]] = {}
    stated_units: FileUnits | None = None
    has_late_units = False
    contradictions: list[tuple[str, FileUnits, FileUnits]] = []
    abscissas = SharedAbscissas()
    other_datasets: dict[int, None] = {}
    axes: dict[str, str] = {}
    with path.open("rb") as file:
        scanner = Scanner(file, path.stat().st_size, source)
        for dataset in scanner.datasets():
            outcome: Function | ModeShape | str | None = None
            if dataset.number == FUNCTION_DATASET:
                points = read_points(scanner, dataset.binary, path)
                outcome = to_function(points, units, abscissas, request)
            elif dataset.binary is not None:
                scanner.skip_binary(dataset.binary)
            elif dataset.number in MODE_READERS:
                outcome = MODE_READERS[dataset.number](scanner)
            elif dataset.number == UNIT_DATASET:
                previous, stated_units = stated_units, _read_units(scanner)
                has_late_units |= bool(functions) and stated_units != units
                units = stated_units
                if previous is not None and previous != stated_units:
                    contradictions.append((scanner.where, previous, stated_units))
            elif dataset.number in LINES_PER_NODE:
                axes |= _read_axes(scanner, LINES_PER_NODE[dataset.number])
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
    messages = tuple(
        f"{locations[0]}: skipped: {_with_count(reason, locations)}" for reason, locations in skipped.items()
    )
    reasons = [_with_count(reason, locations) for reason, locations in skipped.items()]
    reasons += [
        f"dataset {number} holds {OTHER_DATASETS.get(number, 'what is not read')}"
        for number in other_datasets
    ]
    used = [function.response for function in functions] + [name for mode in modes for name in mode.shape]
    all_messages = (*messages, *_axes_message(used, axes, source))
    content = SignalFile(source, tuple(functions), tuple(modes), all_messages, skipped=tuple(reasons))
    return content, stated_units if has_late_units else None


def _read_axes(scanner: Scanner, lines: int) -> dict[str, str]:
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


def _axes_message(names: Sequence[str], axes: Mapping[str, str], source: str) -> list[str]:
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


def _with_count(reason: str, locations: Sequence[str]) -> str:
    """Return why datasets were skipped, and their number if there are several."""
    return reason if len(locations) == 1 else f"{reason} ({len(locations)} datasets)"


def _read_units(scanner: Scanner) -> FileUnits:
    """Read dataset 164: the numbers of the file's units of length and force in one of SI."""
    scanner.line("the code of the units")
    factors = parse_numbers(scanner.line("the factors of the units"))
    if factors is None or factors.size < 2 or not np.all(np.isfinite(factors) & (factors > 0.0)):
        scanner.refuse("expected the factors of the units of length and force")
    scanner.skip_to_end()
    return FileUnits.from_factors(float(factors[0]), float(factors[1]))


UNIVERSAL_FILE = Format("universal file", (".uff", ".unv", ".ufb", ".uf"), is_universal_file, read_universal)
