"""Hundreds of random hexapods and hexaglides: pkmodes against 60 digits, and these against MuJoCo.

    PYTHONPATH=src:generated:tests python benchmarks/six_legs.py --count 200
    PYTHONPATH=src:generated:tests python benchmarks/six_legs.py --count 200 --engine

Each machine has other effects.  The largest error of each result is printed with the machine that has it, and
whatever exceeds rounding; the exit code is 1 then.  `tests/generated/test_hexapod_oracle.py` tries a few of them.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from helpers.references.six_legs_compared import ENGINE_TOLERANCES, TOLERANCES, engine_errors, errors
from helpers.robots.six_legged import MACHINES, Case, drawn


def main() -> int:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=200, help="machines of each kind")
    parser.add_argument("--first", type=int, default=0, help="the first seed")
    parser.add_argument("--mechanism", choices=tuple(MACHINES), action="append", help="only this one")
    parser.add_argument("--engine", action="store_true", help="the oracle against MuJoCo")
    given = parser.parse_args()
    seeds = range(given.first, given.first + given.count)
    exceeded = False
    with TemporaryDirectory() as folder:

        def of_pkmodes(case: Case) -> dict[str, float]:
            return errors(case, Path(folder))

        one: Callable[[Case], dict[str, float]] = engine_errors if given.engine else of_pkmodes
        tolerances = ENGINE_TOLERANCES if given.engine else TOLERANCES
        for name in given.mechanism or MACHINES:
            worst = dict.fromkeys(tolerances, (0.0, -1))
            for seed in seeds:
                for result, error in one(drawn(name, seed)).items():
                    worst[result] = max(worst[result], (error, seed))
                    if not error <= tolerances[result]:
                        exceeded = True
                        print(f"{name} {seed}: {result} differs by {error:.1e}", file=sys.stderr, flush=True)
            print(f"{name}, {given.count} machines, largest errors")
            for result, (error, seed) in worst.items():
                print(f"  {result:24} {error:8.1e}  (machine {seed})", flush=True)
    return int(exceeded)


if __name__ == "__main__":
    sys.exit(main())
