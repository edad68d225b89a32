"""What the diagnosis makes of cases on the virtual rig is frozen: verdict, classes, and values of causes.

A sample of every suite runs here, every case with ``pytest tests/golden/test_suites.py --whole-suites``: an hour and
a half on one core.  A change that is meant is written by ``--update-golden``, with or without it, and reviewed.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from helpers.golden.outcomes import GOLDEN
from pkmodes_rig.suites import (
    clear_cases,
    clear_suites,
    damping_cases,
    judging,
    mechanism_cases,
    mechanism_suites,
)
from pkmodes_rig.suites.suites import SUITES as DIAGNOSIS

#: Seed of the cases of damping; the others have theirs.
SEED = 20261230
#: Relative tolerance of an estimate and its standard deviation.
FITTED = 2e-3
#: Cases of each suite, how one is run, and which share of them runs in every test.
SUITES: dict[str, tuple[Callable[[], Iterator[Any]], Callable[[Any], Any], int]] = {
    "diagnosis": (lambda: (case for suite in DIAGNOSIS.values() for case in suite()), judging.run, 90),
    "mechanisms": (mechanism_suites.cases, mechanism_cases.run, 70),
    "damping": (lambda: damping_cases.cases(SEED), damping_cases.run, 80),
    "clear": (clear_suites.cases, clear_cases.run, 120),
}


def said(outcome: Any) -> dict[str, Any]:
    """Return what an outcome says of a case."""
    found = {"verdict": outcome.verdict, "classes": [list(members) for members in outcome.classes]}
    if hasattr(outcome, "of_damping"):
        return {**found, "damping": outcome.of_damping}
    return {**found, "values": {name: [value, sigma] for name, value, sigma, _ in outcome.values}}


def alike(old: dict[str, Any], new: dict[str, Any]) -> bool:
    """Whether two outcomes say the same, values to the tolerance of a fit."""
    close = {
        name: pytest.approx(pair, rel=FITTED, nan_ok=True) for name, pair in old.get("values", {}).items()
    }
    return new == {**old, **({"values": close} if "values" in old else {})}


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("suite", SUITES)
def test_cases_on_the_rig_are_diagnosed_as_they_were(suite: str, pytestconfig: pytest.Config) -> None:
    cases, run, every = SUITES[suite]
    chosen = list(enumerate(cases()))
    if not pytestconfig.getoption("whole_suites"):
        chosen = chosen[every // 2 :: every]
    found = {str(number): said(run(case)) for number, case in chosen}
    path = GOLDEN / "suites" / f"{suite}.json"
    frozen = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    if pytestconfig.getoption("update_golden"):
        both = sorted({**frozen, **found}.items(), key=lambda item: int(item[0]))
        lines = ",\n".join(f'"{number}": {json.dumps(one)}' for number, one in both)
        path.parent.mkdir(exist_ok=True)
        path.write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")
        return
    wrong = {number: one for number, one in found.items() if not alike(frozen[number], one)}
    assert not wrong, "\n".join(f"case {n}: {one} instead of {frozen[n]}" for n, one in wrong.items())
