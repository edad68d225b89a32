"""Diagnoses of a frame of storeys, checked for what holds of every diagnosis."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from helpers.robots.small_structures import frame_measured, uncertain
from pkmodes.loop.diagnosis import Diagnosis, Measurements, diagnose

TWO = {"empty": 0.0, "loaded": 5.0}


SIX = {f"{load:g} kg": load for load in (0.0, 2.0, 4.0, 6.0, 8.0, 10.0)}


CANDIDATES = ["first floor", "brace 1", "brace 2", "brace 3", "brace 4"]


def checked(structure: Any, data: Measurements, holdout: Sequence[str] | None = ()) -> Diagnosis:
    """A diagnosis, checked for properties that hold for all of them."""
    found = diagnose(structure, data, holdout=holdout)
    content = json.loads(json.dumps(found.as_json(), allow_nan=False))
    keys = {
        "verdict",
        "reason",
        "effects",
        "survivors",
        "refitted",
        "error",
        "held_out_poses",
        "undetectable",
    }
    assert keys | {"next_measurement"} <= set(content)
    assert (found.after is not None) == (found.verdict == "effect_found") == bool(found.effects)
    assert bool(found.survivors) == (found.verdict == "ambiguous")
    assert all(found.reason.count(character) == 0 for character in "\n\t")
    assert [row.line for row in found.rows] == data.lines.tolist()
    # A mode of another shape counts with the nearest mode of the model, and bad shapes may be held out.
    has_no_mode = [row for row in found.unpaired if row.nearest is None]
    assert not has_no_mode or found.verdict not in ("adequate", "effect_found")
    for effect in found.effects:
        assert 0.0 <= effect.p_value < 0.05
        assert effect.name in effect.members
        assert set(effect.alternatives) == set(effect.members)
    return found


def causes(found: Diagnosis) -> list[str]:
    return sorted(effect.name for effect in found.effects)


def drawn(
    loads: dict[str, float], seed: int, truth: dict[str, float] | None = None, **options: Any
) -> Measurements:
    rng = np.random.default_rng([seed, 5])
    return frame_measured(loads, uncertain(rng) | (truth or {}), rng, **options)


def spoiled(data: Measurements, row: int, factor: float) -> Measurements:
    """One wrong frequency, with rows from a file with a header."""
    f = data.frequency.copy()
    f[row] *= factor
    return replace(data, frequency=f, lines=np.arange(len(f)) + 3)
