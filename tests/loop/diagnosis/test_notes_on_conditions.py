"""Notes compare only poses that were measured alike: with the same motors and the same set values."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import pkmodes
from helpers.robots.small_structures import some_rows
from pkmodes import updating
from pkmodes.loop.diagnosis import Diagnosis, Measurements

ROBOT = Path(__file__).parents[3] / "robots" / "corexy-printer.toml"
PLACES = [[0.05, 0.05], [0.15, 0.20], [0.25, 0.10], [0.10, 0.28], [0.28, 0.27]]
PAYLOAD = "effects.payload.mass"


@cache
def measured() -> Measurements:
    """Return both vibration modes at each place: motors held, free, and held with a payload of 0.2 kg."""
    robot = pkmodes.read_robot(ROBOT)
    loaded = robot.with_values({PAYLOAD: 0.2})
    rows = []
    for letter, machine, drives, load in (
        ("H", robot, "held", np.nan),
        ("F", robot, "free", np.nan),
        ("L", loaded, "held", 0.2),
    ):
        modes = pkmodes.Model(machine).modes(PLACES, drives=drives)
        rows += [
            (f"{letter}{k}", place, f, drives, load)
            for k, place in enumerate(PLACES)
            for f in modes.frequencies[k, modes.rigid_modes :]
        ]
    labels, points, frequencies, drives, loads = zip(*rows, strict=True)
    noise = np.random.default_rng(5).normal(0.0, 0.001, len(rows))
    return Measurements.from_rows(
        labels,
        np.array(frequencies) * (1.0 + noise),
        0.001 * np.array(frequencies),
        points=points,
        drives=drives,
        settings={PAYLOAD: loads},
        components={"x": "m", "y": "m"},
    )


def diagnosed(data: Measurements) -> Diagnosis:
    return updating.diagnose(pkmodes.read_robot(ROBOT), data, candidates=["payload"], holdout=(), terms=False)


def test_motors_held_and_free_and_a_payload_at_one_place_are_no_contradiction() -> None:
    data = measured()
    held, free, loaded = (data.labels.index(label) for label in ("H0", "F0", "L0"))
    first = [data.frequency[data.pose == pose][0] for pose in (held, free, loaded)]
    assert first[1] > 1.3 * first[0]  # far more than what is remarked among poses measured alike
    assert first[0] > 1.05 * first[2]
    found = diagnosed(data)
    assert found.verdict == "adequate"
    assert found.notes == ()


@pytest.mark.parametrize("letter", ["H", "F", "L"])
def test_poses_measured_alike_at_one_place_are_compared_beside_all_others(letter: str) -> None:
    data = measured()
    one, other = (data.labels.index(f"{letter}{k}") for k in (1, 2))
    points = data.points.copy()
    points[other] = points[one]
    notes = [note for note in diagnosed(replace(data, points=points)).notes if "same position" in note]
    assert [note.partition(" are ")[0] for note in notes] == [f"poses {letter}1 and {letter}2"]


def test_conditions_are_the_motors_and_all_set_values() -> None:
    data = measured().at(range(15))
    conditions = {label[0]: set(data.conditions[k::15]) for k, label in enumerate(data.labels)}
    assert data.conditions.tolist() == [0] * 5 + [1] * 5 + [2] * 5
    assert len(conditions) == 3
    none = Measurements.from_rows(["a", "b"], [1.0, 2.0], [0.1, 0.1])
    assert none.conditions.tolist() == [0, 0]


def test_a_mode_that_was_never_measured_with_held_motors_is_named_though_it_was_with_free_ones() -> None:
    data = measured()
    modes = np.arange(len(data.frequency)) % 2
    held = np.array([data.drives[pose] == "held" for pose in data.pose])
    missing = held & (modes == 1)
    poses = data.pose[~missing]
    kept = some_rows(
        data,
        ~missing,
        points=data.points[poses],
        drives=[data.drives[pose] for pose in poses],
        settings={PAYLOAD: data.set_values[poses, 0]},
        components={"x": "m", "y": "m"},
        band=(1.0, 1000.0),
    )
    notes = [note for note in diagnosed(kept).notes if "never measured" in note]
    (note,) = [note for note in notes if "with motors held" in note]
    assert "was expected at 10 poses with motors held but never measured" in note
    low, high = (float(text) for text in note.split(" Hz was")[0].removeprefix("a mode at ").split(" to "))
    assert low == pytest.approx(data.frequency[missing].min(), rel=0.01)
    assert high == pytest.approx(data.frequency[missing].max(), rel=0.01)
