"""Frequencies that change with the level of excitation: said, and in sigma."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from modaltest.campaign.structures import HEAD, identify, record, sensors
from modaltest.identification.test_level import F0, RATE, ring_down
from pkmodes.modaltest.campaign.levels import shifts_between_files
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate

CAMPAIGN = HEAD.replace('"200 Hz"', '"150 Hz"') + 'repeatability = "0.01 %"\n' + sensors("m/s^2", "m/s^2")


def identified(folder: Path, hardening: float) -> dict[str, Any]:
    files = [f"r{i}.csv" for i in range(3)]
    for i, name in enumerate(files):
        signals = ring_down(hardening, np.random.default_rng(40 + i))
        table = np.column_stack([np.arange(len(signals)) / RATE, signals])
        np.savetxt(folder / name, table, delimiter=",", header="time,a1,a2", comments="", fmt="%.9g")
    return identify(folder, CAMPAIGN + record("ambient", *files)).record


def test_a_change_is_said_once_and_half_of_it_is_in_sigma(tmp_path: Path) -> None:
    found = identified(tmp_path, -0.004)
    said = [message for message in found["messages"] if "changes with the level" in message]
    assert len(said) == 1
    assert said[0].startswith("P1: the mode at 39.9")
    nonlinear, linear = found["modes"]
    assert nonlinear["sigma_parts"]["fit"] == pytest.approx(0.5 * 0.004 * F0 * 0.8, rel=0.15)
    assert linear["sigma_parts"]["fit"] < 0.01


def test_nothing_is_said_of_a_linear_structure(tmp_path: Path) -> None:
    found = identified(tmp_path, 0.0)
    assert not any("level" in message for message in found["messages"])
    assert found["modes"][0]["sigma_parts"]["fit"] < 0.01


def files(levels: list[float], slope: float, scatter: float, seed: int) -> list[dict[int, ModeEstimate]]:
    """Three modes; the first changes by a slope in ln f over ln level, all scatter from file to file."""
    rng = np.random.default_rng(seed)
    return [
        {
            i: ModeEstimate(
                f * (level ** (slope if f == 30.0 else 0.0)) * (1.0 + scatter * rng.normal()),
                sigma_frequency=scatter * f,
                level=level,
            )
            for i, level in enumerate(levels)
        }
        for f in (30.0, 50.0, 90.0)
    ]


def test_files_of_other_levels_show_a_change_beyond_their_scatter() -> None:
    shift, *others = shifts_between_files(files([1.0, 2.0, 4.0, 8.0, 1.5, 6.0], -0.002, 1e-4, 1))
    assert others == [None, None]
    assert shift is not None
    assert shift.low == pytest.approx(30.0, rel=3e-4)
    assert shift.high == pytest.approx(30.0 * 8.0**-0.002, rel=3e-4)
    assert shift.fall == pytest.approx(8.0)


def test_scatter_and_equal_levels_show_none() -> None:
    alarms = sum(
        shift is not None
        for seed in range(300)
        for shift in shifts_between_files(files([1.0, 2.0, 4.0, 8.0], 0.0, 1e-3, seed))
    )
    assert alarms <= 1  # 900 modes at one in ten thousand
    assert shifts_between_files(files([1.0, 1.1, 1.2, 1.05], -0.05, 1e-5, 2)) == [None, None, None]
    assert shifts_between_files(files([1.0, np.nan, 4.0, 8.0], -0.002, 1e-5, 2)) == [None, None, None]
