"""Time of a diagnosis of a large model with matrices, in one process on one core.

    python benchmarks/large_models.py

The model is a footbridge of 235 beam elements and 472 coordinates, with 21 candidates: the bending stiffness of
sixteen parts, two bearings and three masses.  Eight sensors measure eight modes.
"""

from __future__ import annotations

import time
from collections.abc import Mapping
from typing import Any

import numpy as np
from scipy import sparse
from scipy.linalg import eigh

from pkmodes.diagnosis import Candidate, MatrixStructure, Measurements, Parameter, diagnose

LENGTH, ELEMENTS, PARTS, BENDING, MASS, BEARING = 40.0, 235, 16, 4e9, 1200.0, 2e7
SIZE = 2 * (ELEMENTS + 1)
ENDS, LOADS = (0, SIZE - 2), (116, 236, 354)
SIGMA, SCATTER, MODES = 0.003, 0.02, 8


def assembled(element: np.ndarray, elements: np.ndarray) -> sparse.csc_array:
    """Assemble the same two-node matrix for the given elements."""
    first = 2 * elements[:, None, None]
    rows, columns = np.broadcast_arrays(first + np.arange(4)[:, None], first + np.arange(4))
    values = np.broadcast_to(element, rows.shape)
    entries = values.ravel(), (rows.ravel(), columns.ravel())
    return sparse.csc_array(entries, shape=(SIZE, SIZE))


def at(place: int, value: float) -> sparse.csc_array:
    return sparse.csc_array(([value], ([place], [place])), shape=(SIZE, SIZE))


def bridge() -> tuple[list[Parameter], Any]:
    h, every = LENGTH / ELEMENTS, np.arange(ELEMENTS)
    bending = [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h]]
    bending += [[-12, -6 * h, 12, -6 * h], [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
    inertia = [[156, 22 * h, 54, -13 * h], [22 * h, 4 * h * h, 13 * h, -3 * h * h]]
    inertia += [[54, 13 * h, 156, -22 * h], [-13 * h, -3 * h * h, -22 * h, 4 * h * h]]
    part = every * PARTS // ELEMENTS
    stiff = {f"EI {g}": assembled(BENDING / h**3 * np.array(bending), every[part == g]) for g in range(PARTS)}
    bearings = {f"bearing {i}": at(place, BEARING) for i, place in enumerate(ENDS)}
    loads = {f"load {i}": at(place, 1.0) for i, place in enumerate(LOADS)}
    M0 = assembled(MASS * h / 420 * np.array(inertia), every)

    def matrices(values: Mapping[str, float], setup: str) -> tuple[Any, Any]:
        K = sum((values["E"] * values[name] * matrix for name, matrix in stiff.items()), start=at(0, 0.0))
        K = sum((values[name] * matrix for name, matrix in bearings.items()), start=K)
        return sum((values[name] * matrix for name, matrix in loads.items()), start=M0), K

    parameters = [Parameter("E", 1.0, sigma=0.05, lower=0.3, upper=3.0)]
    parameters += [Parameter(name, 1.0, lower=0.2, upper=4.0) for name in stiff]
    parameters += [Parameter(name, 1.0, lower=0.01, upper=100.0) for name in bearings]
    parameters += [Parameter(name, 0.0, "kg", lower=0.0) for name in loads]
    return parameters, matrices


def sensors(between: bool) -> np.ndarray:
    """Return the matrix of eight sensors along the bridge, at nodes or between them."""
    found = np.zeros((MODES, SIZE))
    for row, place in zip(found, np.linspace(0.06, 0.94, MODES) * ELEMENTS, strict=True):
        node, part = int(place), place % 1.0 if between else 0.0
        row[[2 * node, 2 * node + 2]] = 1.0 - part, part
    return found


def measured(matrices: Any, values: dict[str, float], places: np.ndarray, *, outside: bool) -> Measurements:
    rng = np.random.default_rng(5)
    M, K = (matrix.toarray() for matrix in matrices(values, ""))
    if outside:  # a column under the bridge and a bracket that holds a slope: neither is a candidate
        K[LOADS[0], LOADS[0]] += 4e6
        K[LOADS[2] + 1, LOADS[2] + 1] += 8e7
    eigenvalues, modes = eigh(K, M, subset_by_index=[0, MODES - 1])
    f = np.sqrt(eigenvalues) / (2 * np.pi) * (1 + SIGMA * rng.standard_normal(MODES))
    shapes = modes.T @ places.T
    shapes = shapes / np.abs(shapes).max(axis=1, keepdims=True) + SCATTER * rng.standard_normal(shapes.shape)
    return Measurements.from_rows(
        ["today"] * MODES,
        f,
        SIGMA * f,
        shapes={f"a{i}": shapes[:, i] for i in range(MODES)},
        shape_sigma=np.full(MODES, SCATTER),
    )


def main() -> None:
    parameters, matrices = bridge()
    print("| what | sensors | verdict | processor time | calls for M and K |\n|---|---|---|---|---|")
    for what, truth, between in (
        ("one cause", {"EI 5": 0.6}, False),
        ("one cause", {"EI 5": 0.6}, True),
        ("nothing missing", {}, False),
        ("no candidate", None, False),
    ):
        calls, places = 0, sensors(between)
        values = {p.name: p.value for p in parameters} | {"E": 1.03} | (truth or {})
        data = measured(matrices, values, places, outside=truth is None)

        def counted(values: Mapping[str, float], setup: str) -> tuple[Any, Any]:
            nonlocal calls
            calls += 1
            return matrices(values, setup)

        start = time.process_time()
        structure = MatrixStructure(
            parameters,
            [Candidate(p.name, (p.name,)) for p in parameters[1:]],
            counted,
            channels=data.channels,
            sensors=places,
        )
        verdict = diagnose(structure, data).verdict
        seconds = time.process_time() - start
        where = "between nodes" if between else "at nodes"
        print(f"| {what} | {where} | {verdict} | {seconds:.1f} s | {calls} |", flush=True)


if __name__ == "__main__":
    main()
