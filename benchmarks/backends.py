"""Every way to the modes of the published robot, in one run: table and plot in docs/explanation/compiled.md.

    python benchmarks/backends.py [--quick] [--out docs] [--machine "one core of ..."] [--report-only]

On one core: `sympy.lambdify` and SciPy, generated NumPy and batched LAPACK, CasADi, JAX, numba, MuJoCo and the
compiled evaluator, at the same poses, in turn, the smallest time of each.  Then the cost against the number of
poses, the peak of the core, the parts of the evaluator, memory, and all cores.  Peers that are not installed are
left out.  Results are kept in build/backends.json.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import backends_report

HERE = Path(__file__).parent
#: Every library that has threads of its own gets one.
ONE_THREAD = dict.fromkeys(
    [
        "OMP_NUM_THREADS",
        "OPENBLAS_NUM_THREADS",
        "MKL_NUM_THREADS",
        "NUMBA_NUM_THREADS",
        "VECLIB_MAXIMUM_THREADS",
    ],
    "1",
) | {"XLA_FLAGS": "--xla_cpu_multi_thread_eigen=false intra_op_parallelism_threads=1"}
MEMORY_AT = (10**4, 10**5, 10**6, 10**7)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer poses and repetitions, for a first look")
    parser.add_argument("--out", type=Path, default=HERE.parent / "docs", help="the documentation")
    parser.add_argument("--machine", help="what measured, for the text")
    parser.add_argument("--results", type=Path, default=HERE.parent / "build" / "backends.json")
    parser.add_argument(
        "--report-only", action="store_true", help="write table and plot from these results again"
    )
    given = parser.parse_args()
    if not given.report_only:
        found = measured(["--quick"] if given.quick else [], MEMORY_AT[: 2 if given.quick else None])
        given.results.parent.mkdir(parents=True, exist_ok=True)
        given.results.write_text(json.dumps(found, indent=1), encoding="utf-8")
    found = json.loads(given.results.read_text(encoding="utf-8"))
    text = backends_report.text(found, given.machine)
    print(text)
    for line in sorted({*found["one"]["missing"], *found["all"]["missing"]}):
        print(f"note: {line}")
    backends_report.put(given.out / "explanation/compiled.md", text)
    try:
        import figure
    except ModuleNotFoundError as error:
        print(f"note: {error.name} is not installed, the plot is left out: pip install '.[benchmark]'")
    else:
        figure.write(found["one"]["growth"], given.out / "figures" / "backends.svg")


def measured(quick: list[str], sizes: tuple[int, ...]) -> dict[str, object]:
    """Run the measurements one after the other, each in its own process."""
    with tempfile.TemporaryDirectory() as folder:
        one, every = Path(folder) / "one.json", Path(folder) / "all.json"
        child("check_peers.py", [], {})
        child("one_core.py", [str(one), *quick], ONE_THREAD, alone)
        child("all_cores.py", [str(every), *quick], {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"})
        memory = [json.loads(child("memory.py", [str(size)], {})) for size in sizes]
        return {
            "one": json.loads(one.read_text(encoding="utf-8")),
            "all": json.loads(every.read_text(encoding="utf-8")),
            "memory": [found for found in memory if found],
        }


def alone() -> None:
    """Keep this process on one core; the first is busier with the system than others."""
    if hasattr(os, "sched_setaffinity"):
        os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


def child(
    script: str, arguments: list[str], environment: dict[str, str], before: Callable[[], None] | None = None
) -> str:
    command = [sys.executable, str(HERE / script), *arguments]
    done = subprocess.run(
        command,
        env=os.environ | environment,
        preexec_fn=before,
        check=False,
        text=True,
        stdout=subprocess.PIPE,
    )
    if done.returncode:
        sys.exit(done.returncode)  # it has said why
    return done.stdout


if __name__ == "__main__":
    main()
