"""Every way on one core, in one process: what `backends.py` runs first.  It writes JSON to the file it is given.

    python benchmarks/one_core.py [--keep]

Without a file it prints what calls take as ratios (`ratios.py`), and with ``--keep`` adds them to
docs/explanation/compiled.md. `backends.py` has limited the process to one core and one thread before NumPy and the
others are loaded.
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Callable, Iterator
from functools import partial
from pathlib import Path

import numpy as np

import backends
import operations
import ours
import ratios
from machine import Peak, parts
from peers import BLOCK, Array, MissingError, Way, ways
from pkmodes.core.base.errors import PkmodesError
from published import published, rigid_modes, valid_poses
from timing import REPETITIONS, affordable, interleaved, seconds

POSES = 10 * BLOCK
#: Each way must find the same vibration frequencies, and shapes that solve the problem, to this relative error.
SAME = 1e-8
#: Poses in a call from which a call may take no longer than this [s].
SIZES = [1, 3, 10, 30, 100, 300, 1000, 3000, *(int(m * 10**k) for k in (4, 5, 6) for m in (1, 3)), 10**7]
PATIENCE, PATIENCE_OURS = 0.7, 8.0
#: Option of the process that measures the ratios.
RATIOS = "--ratios"


def main(target: Path, quick: bool) -> None:
    poses = valid_poses(POSES // 10 if quick else POSES)
    repetitions = 3 if quick else REPETITIONS
    missing: list[str] = []
    found: dict[str, object] = {"poses": len(poses), "missing": missing}
    every: list[Way] = []
    for way in [*ways(), ours.compiled()]:
        if isinstance(way, MissingError):
            missing.append(str(way))
        else:
            every.append(way)
    errors = {way.label: checked(way, poses[:200]) for way in every}
    ours.check_gradients(poses[:20])
    found["rows"], found["gradients"] = compared(every, errors, poses, repetitions)
    with tempfile.TemporaryDirectory() as folder:
        found["machine"] = machine(poses, Path(folder), repetitions, missing)
    found["growth"] = dict(growth(every, poses, 10**5 if quick else 10**7))
    target.write_text(json.dumps(found, indent=1), encoding="utf-8")


def checked(way: Way, poses: Array) -> float:
    """Check that a way solves the same problem; return the largest relative error of its vibration frequencies.

    Raises
    ------
    AssertionError
        If it solves another one.
    """
    model = published()
    poses = poses[:8] if way.label == "MuJoCo" else poses
    n, (M, K) = len(model.coordinates), model.matrices(poses)
    alone, frequencies = np.empty((2, len(poses), n))
    shapes = np.empty((len(poses), n, n))
    expected = model.frequencies(poses, backend="numpy")[:, rigid_modes() :]
    way.run(poses, alone, None)
    way.run(poses, frequencies, shapes)
    error = max(np.abs(found[:, rigid_modes() :] / expected - 1).max() for found in (alone, frequencies))
    assert error < SAME, f"{way.name}: frequencies differ by {error:.1e}"
    columns = np.swapaxes(shapes, 1, 2)
    assert np.abs(shapes @ M @ columns - np.eye(n)).max() < SAME, way.name
    eigenvalues = (2 * np.pi * frequencies) ** 2 * np.sign(frequencies)
    left = shapes @ K @ columns - eigenvalues[:, :, None] * np.eye(n)
    assert (np.abs(left).max((1, 2)) < SAME * eigenvalues[:, -1]).all(), way.name
    return float(error)


def compared(
    every: list[Way], errors: dict[str, float], poses: Array, repetitions: int
) -> tuple[list[dict[str, object]], float]:
    """Time all ways, with and without shapes, and gradients, in turn [us per pose]."""
    n = len(published().coordinates)
    frequencies, shapes = np.zeros((len(poses), n)), np.zeros((len(poses), n, n))
    runs: dict[str, Callable[[int], None]] = {}
    for way in every:
        runs[way.label] = partial(first_ones, way, poses, frequencies, None)
        runs[f"{way.label}+"] = partial(first_ones, way, poses, frequencies, shapes)
    room = ours.room_for_gradients(len(poses))
    runs["gradients"] = lambda count: ours.gradients(poses[:count], room)
    counts = {name: in_whole_blocks(affordable(run, len(poses))) for name, run in runs.items()}
    for name, run in runs.items():
        run(counts[name])
    calls = {name: lambda run=run, count=counts[name]: run(count) for name, run in runs.items()}
    times = {name: 1e6 * time / counts[name] for name, time in interleaved(calls, repetitions).items()}
    rows = [
        {
            "label": way.label,
            "name": way.name,
            "frequencies": times[way.label],
            "shapes": times[f"{way.label}+"],
            "error": errors[way.label],
        }
        for way in every
    ]
    return rows, times["gradients"]


def in_whole_blocks(count: int) -> int:
    return count // BLOCK * BLOCK or count


def machine(poses: Array, folder: Path, repetitions: int, missing: list[str]) -> dict[str, object]:
    """Measure the peak of the core and the parts of the evaluator; count operations."""
    model = published()
    n, evaluator = len(model.coordinates), model.solver("compiled").evaluator
    width = evaluator._library.width
    some, same = poses, np.repeat(poses[:1], len(poses), axis=0)
    frequencies, joints = np.zeros((len(some), n)), np.zeros((len(some), 3))
    matrices = {name: np.zeros((BLOCK, n, n)) for name in ("mass_matrix", "stiffness_matrix")}

    def both_matrices() -> None:  # into arrays that stay in the cache
        for start in range(0, len(some) // BLOCK * BLOCK, BLOCK):
            evaluator.run(some[start : start + BLOCK], matrices)

    calls: dict[str, Callable[[], object]] = {
        "checked": lambda: evaluator.run(some, {}),
        "joints": lambda: evaluator.run(some, {"joint_positions": joints}),
        "matrices": both_matrices,
        "frequencies": lambda: evaluator.run(some, {"frequencies": frequencies}),
        "same": lambda: evaluator.run(same, {"frequencies": frequencies}),
    }
    found: dict[str, object] = {"width": width}
    together, best, peak = 3 * width, None, None
    try:
        peak = Peak(folder)
        calls["peak"] = peak.measure
        measure, best, together = parts(poses, folder, width)
        calls["parts"] = measure
    except MissingError as missed:
        missing.append(str(missed))
    times = interleaved(calls, repetitions)
    for name in ("checked", "joints", "matrices", "frequencies", "same"):
        found[name] = 1e6 * times[name] / len(poses)
    if peak is not None:
        found["fused"], found["separate"] = peak.fused, peak.separate
        found["rotation"], found["three_rotations"] = peak.rotation, peak.three_rotations
    if best is not None:
        found["reduction"], found["tridiagonal"], found["iteration"] = (1e6 * best).tolist()
    alone = operations.rotations_of(poses[: 20 * together], together)
    found["together"] = together
    found["iterations"], found["rotations"], found["rotations_together"] = alone
    found["operations"] = {
        "matrices": operations.of_matrices(),
        "reduction": operations.of_reduction(n),
        "tridiagonal": operations.of_tridiagonal(n),
        "iteration": operations.of_iteration(*alone[:2]),
        "vectors": operations.of_vectors(n)
        + operations.of_iteration(*alone[:2], n)
        - operations.of_iteration(*alone[:2]),
    }
    return found


def growth(every: list[Way], poses: Array, most: int) -> Iterator[tuple[str, list[tuple[int, float]]]]:
    """Measure the cost of a pose [us] against the number of poses in a call."""
    n, most_shapes = len(published().coordinates), min(most, 10**6)
    many, frequencies = np.resize(poses, (most, 3)), np.zeros((most, n))
    for way in every:
        own = way.label == ours.compiled().label
        patience = PATIENCE_OURS if own else PATIENCE
        run = partial(first_ones, way, many, frequencies, None)
        yield way.label, list(costs(run, most, patience))
        if own:
            run = partial(first_ones, way, many, frequencies, np.zeros((most_shapes, n, n)))
            yield f"{way.label}, with shapes", list(costs(run, most_shapes, patience))


def first_ones(way: Way, poses: Array, frequencies: Array, shapes: Array | None, count: int) -> None:
    way.run(poses[:count], frequencies[:count], None if shapes is None else shapes[:count])


def costs(run: Callable[[int], None], most: int, patience: float) -> Iterator[tuple[int, float]]:
    each = 0.0
    for size in SIZES:
        if size > most or each * size > patience:
            break
        run(size)  # compiles, and touches the arrays
        first = seconds(lambda size=size: run(size))
        repetitions = int(min(max(0.4 / first, 2), 30))
        each = min(first, *(seconds(lambda size=size: run(size)) for _ in range(repetitions))) / size
        yield size, 1e6 * each


def print_ratios(arguments: list[str]) -> None:
    repetitions = 3 if "--quick" in arguments else ratios.REPETITIONS
    ratios.commit()  # before the first table changes the document
    of_peers = ratios.peer_times(published(), valid_poses(ratios.BATCH), repetitions)
    print(ratios.peer_table(of_peers), "", sep="\n")
    if "--keep" in arguments:
        ratios.keep_peers(of_peers, ratios.ROOT / "docs" / "explanation/compiled.md")
    for name, (model, poses) in ratios.machines().items():
        found = ratios.times(model, poses, repetitions)
        print(f"{model.robot.name}:", *ratios.lines(found), "", sep="\n")
        if "--keep" in arguments:
            ratios.keep(found, ratios.ROOT / "docs" / "explanation/compiled.md", name)


if __name__ == "__main__":
    options = sys.argv[1:]
    files = [Path(one) for one in options if not one.startswith("--")]
    try:
        if RATIOS in options:
            print_ratios(options)
        elif files:
            main(files[0], "--quick" in options)
        else:  # in a process with one core and one thread
            print(
                backends.child("one_core.py", [RATIOS, *options], backends.ONE_THREAD, backends.alone), end=""
            )
    except PkmodesError as error:
        sys.exit(f"error: {error}")
