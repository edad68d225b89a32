"""What the diagnosis makes of cases on the virtual rig is frozen: verdict, classes, and values of causes.

Here a few of each suite are run; in tests/diagnosis, where outcomes are held against the truth, each of them
is compared, too.  With ``--whole-suites`` every case runs: an hour and a half on one core.
A change that is meant is written by ``--update-golden``, and reviewed.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

import pytest

from helpers.golden.case_book import check, said
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
#: Cases of each suite, how one is run, and which share of them is run every time.
SUITES: dict[str, tuple[Callable[[], Iterator[Any]], Callable[[Any], Any], int]] = {
    "diagnosis": (lambda: (case for suite in DIAGNOSIS.values() for case in suite()), judging.run, 400),
    "mechanisms": (mechanism_suites.cases, mechanism_cases.run, 200),
    "damping": (lambda: damping_cases.cases(SEED), damping_cases.run, 80),
    "clear": (clear_suites.cases, clear_cases.run, 120),
}


@pytest.mark.slow
@pytest.mark.compiler
@pytest.mark.parametrize("suite", SUITES)
def test_cases_on_the_rig_are_diagnosed_as_they_were(suite: str, pytestconfig: pytest.Config) -> None:
    cases, run, every = SUITES[suite]
    chosen = list(cases())
    if not pytestconfig.getoption("whole_suites"):
        chosen = chosen[every // 2 :: every]
    found: dict[str, Any] = {}
    for case in chosen:
        found |= said(case, run(case))
    assert len(found) == len(chosen)
    check(suite, found, pytestconfig)
