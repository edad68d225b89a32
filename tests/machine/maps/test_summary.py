"""The summary of a map that is read part by part, against the whole."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.linalg import eigvalsh

import pkmodes
from pkmodes.machine.maps import dataset
from pkmodes.machine.maps.left_out import exclusion_sentences
from pkmodes.machine.maps.quantiles import quantiles
from pkmodes.machine.maps.spread import typical_spread
from pkmodes.machine.maps.summary import quantiles_sentence, summary_of
from pkmodes.pages.report.map_summary import _headline, range_table

PUBLISHED = Path(__file__).parents[3] / "robots" / "linear-delta-2022.toml"


@pytest.mark.parametrize("chunk", [1, 7, 40, 16_384])
def test_extremes_and_counts_do_not_depend_on_the_parts(monkeypatch: pytest.MonkeyPatch, chunk: int) -> None:
    model = pkmodes.load(PUBLISHED)
    # In part beyond the limits and out of reach; extremes of different modes lie in different parts.
    grid = {"x": np.linspace(0.0, 0.8, 9), "y": np.linspace(-0.1, 0.1, 3), "z": [-0.5, -0.245]}
    found = model.map(grid, sweep={"platform.mass": [2.0, 1.0]})
    monkeypatch.setattr(dataset, "CHUNK_POSES", chunk)
    summary = summary_of(found, None).as_json()
    values = found["frequency"].values.reshape(2, -1, 6)
    # A belt span of some mm: its frequency is beyond ten times the median of the robot, of which there are two.
    beyond = (values > 10.0 * np.nanmedian(values, axis=1, keepdims=True)).any(axis=-1)
    assert beyond.sum() == summary["near_singular"]["poses"] == 4
    frequency = np.where(beyond[..., None], np.nan, values).reshape(-1, 6)
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
    assert summary["valid"] == reasons.count("") == int(np.isfinite(values[..., 0]).sum())
    assert summary["counted"] == int(np.isfinite(frequency[:, 0]).sum())
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


#: Of the published robot with motors held: three poses of the working plane; then one where the links lie almost in
#: the plane of the rails, so that the platform falls through it; one nearer to that plane, which is singular.
HELD = np.array(
    [[0.5, 0.05, -0.245], [0.6, 0.0, -0.245], [0.6, 0.05, -0.2], [0.62, -0.15, 0.02], [0.63, -0.158, 2e-4]]
)


def test_an_unstable_pose_and_a_singular_one_are_counted_and_left_out() -> None:
    """Two eigenvalues are negative, by SciPy's eigensolver; the second pose has a condition number of thousands."""
    model = pkmodes.load(PUBLISHED)
    found = model.map(HELD, drives="held")
    M, K = model.matrices(HELD)
    kept = [
        i for i, name in enumerate(model.coordinates) if name not in ("theta_1_1", "theta_2_2", "theta_3_2")
    ]
    lowest = [eigvalsh(k[np.ix_(kept, kept)], m[np.ix_(kept, kept)])[0] for m, k in zip(M, K, strict=True)]
    assert [value < 0.0 for value in lowest] == [False, False, False, True, True]
    assert (found["condition"].values > 100.0).tolist() == [False, False, False, False, True]
    summary = summary_of(found, None).as_json()
    assert (summary["valid"], summary["counted"]) == (5, 3)
    assert (summary["unstable"]["poses"], summary["near_singular"]["poses"]) == (2, 1)
    assert [summary["unstable"]["at"][name] for name in "xyz"] == HELD[4].tolist()
    assert [summary["near_singular"]["at"][name] for name in "xyz"] == HELD[4].tolist()
    first = found["frequency"].values[:, 0]
    assert (summary["modes"][0]["minimum_hz"], summary["modes"][0]["maximum_hz"]) == (
        first[:3].min(),
        first[:3].max(),
    )
    assert summary["modes"][0]["median_hz"] == pytest.approx(np.median(first[:3]))
    assert (first[3:] < 0.0).all()  # the dataset keeps its values
    near, moving = exclusion_sentences(summary, dict.fromkeys("xyz", ("m", 1.0)))
    assert near.startswith("1 pose is near-singular and not in these numbers: the condition number")
    assert near.endswith("; at pose = 4, x = 0.63 m, y = -0.158 m, z = 0.0002 m.")
    assert moving.startswith("2 poses are unstable and not in these numbers: the machine diverges instead")


def test_rounding_beside_a_vanishing_span_is_no_instability() -> None:
    """At x = 0.28 m a belt span vanishes but for rounding, which leaves nothing of the lowest eigenvalue."""
    model = pkmodes.load(PUBLISHED.with_name("linear-delta-2022-identified.toml"))
    found = model.map({"x": [0.28, 0.6, 0.7, 0.8], "y": 0.0, "z": -0.32}, drives="held")
    summary = summary_of(found, None).as_json()
    assert float(found["frequency"].max()) > 1e7
    assert (summary["near_singular"]["poses"], summary["unstable"]["poses"]) == (1, 0)
    assert summary["near_singular"]["at"]["x"] == 0.28
    assert all(row["maximum_hz"] < 1e3 for row in summary["modes"])


def test_the_robots_of_a_sweep_are_judged_each_by_itself() -> None:
    """A servo ten thousand times as stiff multiplies frequencies, at no singular pose."""
    model = pkmodes.load(PUBLISHED)
    stiffness = {"effects.servo_stiffness.stiffness": [0.01, 0.1, 100.0]}
    summary = summary_of(model.map({"x": [0.5, 0.6], "y": 0.0, "z": -0.245}, sweep=stiffness), None).as_json()
    first = summary["modes"][0]
    assert first["maximum_hz"] > 10.0 * first["median_hz"]
    assert (summary["valid"], summary["counted"]) == (6, 6)


def test_few_poses_that_all_move_away_have_no_extremes() -> None:
    summary = summary_of(pkmodes.load(PUBLISHED).map(HELD[3:4], drives="held"), None).as_json()
    assert summary["counted"] == 0
    assert {summary["modes"][0][key] for key in ("minimum_hz", "maximum_at", "median_hz")} == {None}
    assert _headline(summary) == "The machine is not stable at any pose"


@pytest.mark.parametrize(
    ("count", "expected"),
    [
        (1, "Quantiles of each frequency over 1 pose, interpolated between its values there"),
        (49, "Quantiles of each frequency over 49 poses, interpolated between its values there"),
        (50, "At 96 % of the poses a frequency lies between its 2 % and its 98 % quantile"),
    ],
)
def test_two_per_cent_of_the_poses_are_one_at_least(count: int, expected: str) -> None:
    assert quantiles_sentence({"counted": count}) == expected


def test_frequencies_have_the_standard_deviations_of_the_robot_file() -> None:
    """f = sqrt(k / m) / (2 pi): 10 % of a stiffness and 2 % of a mass are 5.1 % of f, at every pose."""
    model = pkmodes.load(PUBLISHED.with_name("bed-slinger.toml"))
    found = model.map({"x": np.linspace(0.05, 0.2, 9), "y": np.linspace(0.05, 0.15, 7)})
    sigmas = typical_spread(model.robot, found, model.max_condition)
    content = summary_of(found, None, sigmas).as_json()
    for mode in content["modes"]:
        expected = 0.5 * np.hypot(0.1, 0.02) * mode["median_hz"]
        assert mode["sigma_hz"] == pytest.approx(expected, rel=1e-9)
    first = content["modes"][0]
    assert _headline(content) == (
        f"The lowest frequency of vibration lies between {first['quantile_2_hz']:.1f} and "
        f"{first['quantile_98_hz']:.1f} Hz at 96 % of the poses, each \u00b1 {first['sigma_hz']:.1f} Hz (from the "
        "standard deviations in the robot file)"
    )
    headings = [column.title for column in range_table(model, content).columns]
    assert headings[4] == "\u00b1 [Hz]"


def test_swept_values_are_known_and_samples_show_their_scatter_themselves() -> None:
    """Of the bed's mode, a sweep of its mass leaves the 10 % of the stiffness: 5 % of f, of the tool head's 5.1 %."""
    model = pkmodes.load(PUBLISHED.with_name("bed-slinger.toml"))
    grid = {"x": 0.1, "y": 0.1}
    swept, sampled = model.map(grid, sweep={"bed.mass": [1.0, 2.0]}), model.map(grid, samples=60)
    first, second = swept["frequency"].values.reshape(2, 2).T
    expected = [0.05 * np.median(first), 0.5 * np.hypot(0.1, 0.02) * np.median(second)]
    np.testing.assert_allclose(typical_spread(model.robot, swept, model.max_condition), expected, rtol=1e-9)
    assert typical_spread(model.robot, sampled, model.max_condition) is None
    content = summary_of(sampled, None).as_json()
    assert content["modes"][0]["sigma_hz"] is None
    assert _headline(content).endswith(
        "Hz at 96 % of the poses of all robots, sampled from the standard deviations in the robot file"
    )
