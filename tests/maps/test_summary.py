"""The summary of a map that is read part by part, against the whole."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.maps import fields
from pkmodes.maps.summary import summary_of

PUBLISHED = Path(__file__).parents[2] / "robots" / "linear-delta-2022.toml"


@pytest.mark.parametrize("chunk", [1, 7, 40, 16_384])
def test_extremes_and_counts_do_not_depend_on_the_parts(monkeypatch: pytest.MonkeyPatch, chunk: int) -> None:
    model = pkmodes.load(PUBLISHED)
    # In part beyond the limits and out of reach; extremes of different modes lie in different parts.
    grid = {"x": np.linspace(0.0, 0.8, 9), "y": np.linspace(-0.1, 0.1, 3), "z": [-0.5, -0.245]}
    found = model.map(grid, sweep={"platform.mass": [2.0, 1.0]})
    monkeypatch.setattr(fields, "CHUNK", chunk)
    summary = summary_of(found, None)
    frequency = found["frequency"].values.reshape(-1, 6)
    names = ("platform.mass", "z", "y", "x")
    assert found["frequency"].dims[:-1] == names
    poses = np.stack(np.meshgrid(*(found[name].values for name in names), indexing="ij"), -1).reshape(-1, 4)
    for mode, row in enumerate(summary["modes"]):
        low, high = np.nanargmin(frequency[:, mode]), np.nanargmax(frequency[:, mode])
        assert row["minimum_hz"] == frequency[low, mode]
        assert row["maximum_hz"] == frequency[high, mode]
        for end, at in (("minimum_at", low), ("maximum_at", high)):
            place = dict(zip(names, poses[at].tolist(), strict=True))
            # A robot that is symmetric to y = 0 has each extreme twice.
            given = {name: row[end][name] for name in names}
            assert {**given, "y": abs(given["y"])} == {**place, "y": abs(place["y"])}
    reasons = found["reason"].values.ravel().tolist()
    assert summary["valid"] == reasons.count("") == int(np.isfinite(frequency[:, 0]).sum())
    assert summary["reasons"] == {name: reasons.count(name) for name in ("limits", "reachable")}
    assert summary["poses"] == 2 * 2 * 3 * 9
