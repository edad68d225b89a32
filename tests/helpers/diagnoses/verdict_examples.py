"""Measurements that lead to each verdict of a diagnosis."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from functools import cache, partial

import pytest

from helpers.diagnoses.diagnose_command import UNEQUAL, WIND_UP, bare, csv_of, measured, rows_of
from pkmodes.loop.diagnosis.criteria import ClaimCriteria, Criteria

VERDICTS = ("adequate", "effect_found", "ambiguous", "unexplained", "insufficient_data")


@cache
def given(verdict: str) -> tuple[str, str]:
    """Return measurements that lead to a verdict inside `judged`, and the candidates to try."""
    return {
        "adequate": (measured(), "payload,belt_mass"),
        "effect_found": (measured(poses=7, effects=WIND_UP), "gearbox_compliance,payload"),
        "ambiguous": (
            measured(poses=3, shapes=(), effects={"gearbox_compliance.compliance": 1.5e-4}),
            "gearbox_compliance,clamp_compliance,belt_end_compliance",
        ),
        "unexplained": (measured(poses=2, effects=UNEQUAL), "payload"),
        "insufficient_data": (csv_of(bare(rows_of(measured())[:2])), "payload"),
    }[verdict]


@contextmanager
def judged(verdict: str) -> Iterator[None]:
    """Let nothing be one class where the verdict is to be ambiguous: whatever survives is a rival."""
    with pytest.MonkeyPatch.context() as patch:
        if verdict == "ambiguous":
            patch.setattr(
                "pkmodes.loop.diagnosis.fit.fitter.Criteria",
                partial(Criteria, claim=ClaimCriteria(told_apart=0.0)),
            )
        yield
