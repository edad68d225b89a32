"""The summary of a map that is read part by part, against the whole."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

import pkmodes
from pkmodes.maps import fields
from pkmodes.maps.quantiles import quantiles
from pkmodes.maps.summary import quantiles_in_words, remark_on, shown_hertz, summary_of

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
        for key, share in (("quantile_2_hz", 0.02), ("median_hz", 0.5), ("quantile_98_hz", 0.98)):
            assert row[key] == pytest.approx(np.nanquantile(frequency[:, mode], share), rel=1e-15), key
    reasons = found["reason"].values.ravel().tolist()
    assert summary["valid"] == reasons.count("") == int(np.isfinite(frequency[:, 0]).sum())
    assert summary["reasons"] == {name: reasons.count(name) for name in ("limits", "reachable")}
    assert summary["poses"] == 2 * 2 * 3 * 9


@pytest.mark.parametrize("rows", [1, 2, 3, 51, 3000])
def test_quantiles_of_parts_are_those_of_the_whole(rows: int) -> None:
    """Also of negative, equal, tiny and missing values; against NumPy."""
    generator = np.random.default_rng(20261124)
    whole = 50.0 * np.exp(generator.normal(size=(rows, 6)))
    whole[:, 1] *= -1.0
    whole[:, 2] -= 50.0
    whole[generator.random(rows) < 0.4, 3] = np.nan
    whole[:, 4] = 7.0
    whole[:, 5] = np.nan
    whole[0, 0] = 9e9
    whole[-1, 3] = 1e-300
    shares = [0.0, 0.02, 0.5, 0.73, 0.98, 1.0]
    found = quantiles(lambda: np.array_split(whole, 7), shares)
    assert np.isnan(found[5]).all()
    expected = np.nanquantile(whole[:, :5], shares, axis=0).T
    np.testing.assert_allclose(found[:5], expected, rtol=1e-15, atol=0.0)


def test_large_frequencies_have_a_power_of_ten() -> None:
    shown = {0.0: "0.000", 72.3514: "72.351", 99_999.9: "99999.900", 9041462019.1: "9.04e9", -2e5: "-2.00e5"}
    assert {value: shown_hertz(value) for value in shown} == shown
    assert shown_hertz(None) == "-"


def test_only_highest_frequencies_far_above_the_rest_have_a_remark() -> None:
    def summary(*highest: float | None) -> dict[str, object]:
        return {
            "modes": [
                {"mode": i, "maximum_hz": high, "quantile_98_hz": None if high is None else 50.0}
                for i, high in enumerate(highest, 1)
            ]
        }

    assert remark_on(summary(60.0, 499.0, None)) == ""
    assert remark_on(summary(60.0, 501.0)).startswith(
        "The highest frequency of mode 2 is more than ten times"
    )
    assert remark_on(summary(1e3, 70.0, 1e9, 1e9)).startswith(
        "The highest frequencies of modes 1, 3 and 4 are"
    )


@pytest.mark.parametrize(
    ("count", "expected"),
    [
        (1, "Quantiles of each frequency over 1 pose, interpolated between its values there"),
        (49, "Quantiles of each frequency over 49 poses, interpolated between its values there"),
        (50, "At 96 % of the poses a frequency lies between its 2 % and its 98 % quantile"),
    ],
)
def test_two_per_cent_of_the_poses_are_one_at_least(count: int, expected: str) -> None:
    assert quantiles_in_words({"valid": count}) == expected
