"""Golden outcomes of cases on the virtual rig: verdict, classes, and the values of causes.

The sign of a computed shape is that of LAPACK, which depends on the vector instructions of the processor, and the rig
adds its errors to the shape as it is.  So a case may have different errors on different processors: where its outcome
differs, the book has a list of those that were seen.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from typing import Any

import pytest

from helpers.golden.agreement import FITTED
from helpers.golden.outcomes import GOLDEN

FOLDER = GOLDEN / "suites"


def read(book: str) -> dict[str, Any]:
    """Return the golden outcomes of a book by case; empty if there is none."""
    path = FOLDER / f"{book}.json"
    return dict(json.loads(path.read_text(encoding="utf-8"))) if path.exists() else {}


def write(book: str, found: Mapping[str, Any]) -> None:
    """Add outcomes to a book, a line for each case, in place of former ones."""
    lines = ",\n".join(
        f"{json.dumps(key)}: {json.dumps(one)}" for key, one in {**read(book), **found}.items()
    )
    FOLDER.mkdir(exist_ok=True)
    (FOLDER / f"{book}.json").write_text(f"{{\n{lines}\n}}\n", encoding="utf-8")


def said(case: Any, outcome: Any) -> dict[str, dict[str, Any]]:
    """Return what an outcome says of a case, by the name of the case."""
    found = {"verdict": outcome.verdict, "classes": [list(members) for members in outcome.classes]}
    if hasattr(outcome, "of_damping"):
        found["damping"] = outcome.of_damping
    else:
        found["values"] = {name: [value, sigma] for name, value, sigma, _ in outcome.values}
    if hasattr(outcome, "status"):
        found["terms"] = outcome.status
    return {f"{case.label}, seed {case.seed}": found}


def check(book: str, found: Mapping[str, Any], config: pytest.Config) -> None:
    """Compare outcomes with the golden ones, or make them these with ``--update-golden``."""
    if config.getoption("update_golden"):
        write(book, found)
        return
    frozen = read(book)
    wrong = {
        key: outcome
        for key, outcome in found.items()
        if not any(_alike(seen, outcome) for seen in _seen(frozen[key]))
    }
    assert not wrong, "\n".join(f"{key}: {new} instead of {frozen[key]}" for key, new in wrong.items())


def frozen(run: Callable[[Any], Any], book: str, config: pytest.Config) -> Callable[[Any], Any]:
    """Return a function that runs cases of the suites and compares each outcome with the golden one."""

    def compared(case: Any) -> Any:
        outcome = run(case)
        check(book, said(case, outcome), config)
        return outcome

    return compared


def _seen(frozen: dict[str, Any] | list[dict[str, Any]]) -> list[dict[str, Any]]:
    return frozen if isinstance(frozen, list) else [frozen]


def _alike(old: dict[str, Any], new: dict[str, Any]) -> bool:
    """Whether two outcomes say the same, values to the tolerance of a fit."""
    close = {
        name: pytest.approx(pair, rel=FITTED, nan_ok=True) for name, pair in old.get("values", {}).items()
    }
    return bool(new == old | ({"values": close} if close else {}))
