"""Time of a diagnosis of a robot, in one process on one core, beside a fixed piece of NumPy work.

    PYTHONPATH=tests python benchmarks/diagnosis.py

The measurements are those of the suites (`tests/studies`): every mechanism, complete, with one cause, and with a
cause that no candidate explains.  A ratio is to the fixed work, measured before and after each case: unlike seconds,
it can be compared with that of another machine.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Iterator
from dataclasses import dataclass

import numpy as np

from pkmodes import updating
from pkmodes.core.robot.robot import Robot
from pkmodes.core.support.threads import one_blas_thread
from pkmodes.loop.diagnosis.verdict.result import Diagnosis
from pkmodes.loop.measured.measurements import Measurements
from studies import mechanism_cases, mechanism_suites
from studies.cases import measured
from studies.specimens import measurements, measurements_of, robot_of
from studies.suites import SUITES
from timing import PROCESS, seconds

#: Suites, and the largest number of seconds for a case of each that the project aims at.
LIMITS = {"nothing missing": 1.0, "one effect": 1.0, "outside the catalogue": 5.0}
#: Cases of each mechanism and suite, by number.
NUMBERS = {
    "linear_delta": {
        "nothing missing": (0, 1),
        "one effect": (4, 22, 40),
        "outside the catalogue": (1, 6, 11),
    },
    "rotary_delta": {
        "nothing missing": (0, 1),
        "one effect": (4, 10, 13),
        "outside the catalogue": (3, 5, 8),
    },
    "corexy": {
        "nothing missing": (0, 1),
        "one effect": (4, 7, 10),
        "outside the catalogue": (3, 5, 8),
    },
}


@dataclass(frozen=True)
class Diagnosed:
    """A case: a declared robot and the modes measured on the specimen."""

    mechanism: str
    suite: str
    kind: str
    robot: Robot
    data: Measurements


def cases() -> Iterator[Diagnosed]:
    for suite, numbers in NUMBERS["linear_delta"].items():
        for n, case in enumerate(SUITES[suite]()):
            if n in numbers:
                robot = robot_of(case.truth.machine)
                yield Diagnosed("linear_delta", suite, case.kind, robot, measurements(measured(case)))
    for one in mechanism_suites.cases():
        name = one.specimen.machine
        if one.number in NUMBERS[name].get(one.suite, ()):
            robot = robot_of(name)
            data = measurements_of(mechanism_cases.measured(one)[1], robot)
            yield Diagnosed(name, one.suite, one.kind, robot, data)


def fixed_work() -> Callable[[], object]:
    """Return a fifth of a second of what a diagnosis does in NumPy: small eigenproblems, and arrays of a thousand."""
    rng = np.random.default_rng(1)
    matrices = rng.standard_normal((500, 12, 12))
    matrices = matrices + np.swapaxes(matrices, -1, -2)
    vector = rng.standard_normal(1000)

    @one_blas_thread()
    def work() -> None:
        for _ in range(20):
            np.linalg.eigh(matrices)
        for _ in range(20_000):
            np.sort(vector * vector + vector)

    return work


def timed(case: Diagnosed) -> tuple[Diagnosis, float]:
    start = PROCESS()
    found = updating.diagnose(case.robot, case.data)
    return found, PROCESS() - start


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument(
        "--only", default="", help="part of the mechanism, suite or kind of the cases to time"
    )
    only = parser.parse_args().only
    work = fixed_work()
    work()
    print(
        "| mechanism | case | cause | verdict | processor time | ratio | aim |\n|---|---|---|---|---|---|---|"
    )
    warm: set[str] = set()
    for case in cases():
        if only not in f"{case.mechanism}, {case.suite}, {case.kind}":
            continue
        if case.mechanism not in warm:  # libraries are loaded or built, and what is read once is read
            updating.diagnose(case.robot, case.data)
            warm.add(case.mechanism)
        before = seconds(work)
        found, took = timed(case)
        ratio = took / min(before, seconds(work))
        row = case.mechanism, case.suite, case.kind, found.verdict, f"{took:.2f} s", f"{ratio:.2f}"
        print(f"| {' | '.join(row)} | {LIMITS[case.suite]:g} s |", flush=True)


if __name__ == "__main__":
    main()
