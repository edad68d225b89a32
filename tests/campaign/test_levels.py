"""Frequencies that change with the level of excitation: said, and in sigma."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from modal_analysis.test_level import F0, RATE, ring_down
from pkmodes.campaign.found import Found
from pkmodes.campaign.levels import between_files
from pkmodes.cli import run

CAMPAIGN = """
format = 1
channels = ["x", "y"]
band = ["20 Hz", "150 Hz"]
repeatability = "0.01 %"
[[sensor]]
name = "a"
channel = "x"
unit = "m/s^2"
[[sensor]]
name = "b"
channel = "y"
unit = "m/s^2"
[[record]]
pose = "P1"
kind = "ambient"
files = ["r0.csv", "r1.csv", "r2.csv"]
"""


def identify(folder: Path, hardening: float) -> dict:
    for i in range(3):
        signals = ring_down(hardening, np.random.default_rng(40 + i))
        table = np.column_stack([np.arange(len(signals)) / RATE, signals])
        np.savetxt(folder / f"r{i}.csv", table, delimiter=",", header="time,a,b", comments="", fmt="%.9g")
    (folder / "c.toml").write_text(CAMPAIGN, encoding="utf-8")
    document = folder / "modes.json"
    code = run(["identify", str(folder / "c.toml"), "--out", str(folder / "m.csv"), "--json", str(document)])
    assert code == 0
    return json.loads(document.read_text(encoding="utf-8"))["records"][0]


def test_a_change_is_said_once_and_half_of_it_is_in_sigma(tmp_path: Path) -> None:
    record = identify(tmp_path, -0.004)
    said = [message for message in record["messages"] if "changes with the level" in message]
    assert len(said) == 1
    assert said[0].startswith("P1: the mode at 39.9")
    nonlinear, linear = record["modes"]
    assert nonlinear["sigma_parts"]["fit"] == pytest.approx(0.5 * 0.004 * F0 * 0.8, rel=0.15)
    assert linear["sigma_parts"]["fit"] < 0.01


def test_nothing_is_said_of_a_linear_structure(tmp_path: Path) -> None:
    record = identify(tmp_path, 0.0)
    assert not any("level" in message for message in record["messages"])
    assert record["modes"][0]["sigma_parts"]["fit"] < 0.01


def files(levels: list[float], slope: float, scatter: float, seed: int) -> list[dict[int, Found]]:
    """Three modes; the first changes by a slope in ln f over ln level, all scatter from file to file."""
    rng = np.random.default_rng(seed)
    return [
        {
            i: Found(
                f * (level ** (slope if f == 30.0 else 0.0)) * (1.0 + scatter * rng.normal()),
                sigma_frequency=scatter * f,
                level=level,
            )
            for i, level in enumerate(levels)
        }
        for f in (30.0, 50.0, 90.0)
    ]


def test_files_of_other_levels_show_a_change_beyond_their_scatter() -> None:
    shift, *others = between_files(files([1.0, 2.0, 4.0, 8.0, 1.5, 6.0], -0.002, 1e-4, 1))
    assert others == [None, None]
    assert shift is not None
    assert shift.low == pytest.approx(30.0, rel=3e-4)
    assert shift.high == pytest.approx(30.0 * 8.0**-0.002, rel=3e-4)
    assert shift.fall == pytest.approx(8.0)


def test_scatter_and_equal_levels_show_none() -> None:
    alarms = sum(
        shift is not None
        for seed in range(300)
        for shift in between_files(files([1.0, 2.0, 4.0, 8.0], 0.0, 1e-3, seed))
    )
    assert alarms <= 1  # 900 modes at one in ten thousand
    assert between_files(files([1.0, 1.1, 1.2, 1.05], -0.05, 1e-5, 2)) == [None, None, None]
    assert between_files(files([1.0, np.nan, 4.0, 8.0], -0.002, 1e-5, 2)) == [None, None, None]
