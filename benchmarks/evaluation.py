"""Speed of evaluation and solution: ratios between several implementations, measured in one run.

    python benchmarks/evaluation.py

Each implementation evaluates the same poses of the published robot; times are the best of several interleaved
repetitions, so a disturbance of the machine affects all of them equally.  Quote ratios, not times.
"""

from __future__ import annotations

import ctypes
import importlib.util
import os
import shutil
import subprocess
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

import numpy as np

from pkmodes.codegen.generation import generate
from pkmodes.core.linalg.eigen import generalised_eigh
from pkmodes_generated import linear_delta
from published import ROBOT, published, valid_poses

POSES = 20_000
REPETITIONS = 7


def main() -> None:
    model, poses = published(), valid_poses(POSES)
    parameters = model.robot.parameters
    M, K = model.matrices(poses)
    with tempfile.TemporaryDirectory() as folder:
        generate(ROBOT, Path(folder))
        specialised = load(Path(folder) / "linear_delta_2022.py")
        ways: dict[str, tuple[int, Callable[[], object]]] = {
            "M and K, parametric NumPy, one pose at a time": (
                200,
                lambda: [linear_delta.modal_matrices(p, parameters) for p in poses[:200]],
            ),
            "M and K, parametric NumPy, all poses at once": (
                POSES,
                lambda: linear_delta.modal_matrices(poses, parameters),
            ),
            "M and K, parametric NumPy, in chunks, poses checked": (POSES, lambda: model.matrices(poses)),
            "M and K, specialised NumPy, all poses at once": (
                POSES,
                lambda: specialised.modal_matrices(poses),
            ),
            "eigenproblem, scaled and batched": (POSES, lambda: generalised_eigh(M, K)),
            "eigenproblem, one pose at a time (scipy.linalg.eigh)": (
                500,
                lambda: scipy_loop(M[:500], K[:500]),
            ),
            "modes, one pose at a time, NumPy": (
                100,
                lambda: [model.modes(p, backend="numpy") for p in poses[:100]],
            ),
            "modes, one pose at a time, compiled": (
                500,
                lambda: [model.modes(p, backend="compiled") for p in poses[:500]],
            ),
            "frequencies, one pose at a time, compiled": (
                500,
                lambda: [model.frequencies(p, backend="compiled") for p in poses[:500]],
            ),
            "extended M and K, all sensitivities, one pose at a time": (
                20,
                lambda: [model.sensitivities(p) for p in poses[:20]],
            ),
            "extended M and K, all sensitivities, in batches": (
                200,
                lambda: model.sensitivities(poses[:200]),
            ),
        }
        c_way = compiled(Path(folder), poses)
        if c_way is not None:
            ways["M and K, specialised C99, one call for each pose"] = (POSES, c_way)
        report(ways)


def report(ways: dict[str, tuple[int, Callable[[], object]]]) -> None:
    best = dict.fromkeys(ways, np.inf)
    for _ in range(REPETITIONS):
        for name, (count, way) in ways.items():
            start = time.perf_counter()
            way()
            best[name] = min(best[name], (time.perf_counter() - start) / count)
    reference = best["M and K, parametric NumPy, in chunks, poses checked"]
    print(f"{POSES} poses, best of {REPETITIONS}; 1.00 is the way pkmodes computes M and K")
    for name, seconds in sorted(best.items(), key=lambda item: item[1]):
        print(f"{name:56} {seconds / reference:9.2f}   {1e6 * seconds:8.2f} us/pose")


def scipy_loop(M: np.ndarray, K: np.ndarray) -> list:
    from scipy.linalg import eigh

    return [eigh(k, m) for k, m in zip(K, M, strict=True)]


def load(path: Path) -> object:
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def compiled(folder: Path, poses: np.ndarray) -> Callable[[], object] | None:
    """Return a C loop over the poses, to keep the interpreter out of the measurement."""
    compiler = os.environ.get("CC") or shutil.which("cc")
    if compiler is None:
        print("no C compiler found; the C99 row is left out")
        return None
    (folder / "loop.c").write_text(
        '#include "linear_delta_2022.h"\n'
        "void loop(long n, const double (*p)[3], double (*M)[9][9], double (*K)[9][9])\n"
        "{ for (long i = 0; i < n; ++i) linear_delta_2022_modal_matrices(p[i], M[i], K[i]); }\n"
    )
    library = folder / "loop.so"
    sources = [str(folder / "loop.c"), str(folder / "linear_delta_2022.c")]
    subprocess.run(
        [compiler, "-std=c99", "-O3", "-march=native", "-fPIC", "-shared", *sources, "-o", library, "-lm"],
        check=True,
    )
    loop = ctypes.CDLL(str(library)).loop
    M, K = (np.empty((len(poses), 9, 9)) for _ in range(2))
    # The arrays are looked up at every call, so the closure keeps them alive.
    return lambda: loop(ctypes.c_long(len(poses)), *(ctypes.c_void_p(a.ctypes.data) for a in (poses, M, K)))


if __name__ == "__main__":
    main()
