"""Modes of several files: which are the same, and what their means and standard deviations are."""

from __future__ import annotations

import time
from types import SimpleNamespace

import numpy as np
import pytest

from pkmodes.modaltest.campaign.averaging import mean_modes, mean_shape
from pkmodes.modaltest.campaign.grouping import _mode_distance, group_modes, match_visits
from pkmodes.modaltest.campaign.joining import join_setups
from pkmodes.modaltest.campaign.mode_estimates import ModeEstimate, mac
from pkmodes.modaltest.campaign.motion import parse_motion
from pkmodes.modaltest.campaign.revisits import estimate_repeatability
from pkmodes.modaltest.campaign.sensors import Transducer
from pkmodes.modaltest.campaign.shapes import combine_sensors


def test_neighbours_of_one_file_are_never_one_mode() -> None:
    files = [[ModeEstimate(50.0 + e), ModeEstimate(50.2 + e)] for e in (-0.02, 0.01, 0.03)]
    groups = group_modes(files)
    assert [len(group) for group in groups] == [3, 3]
    assert [round(float(np.mean([mode.frequency for mode in group.values()])), 1) for group in groups] == [
        50.0,
        50.2,
    ]


def test_shapes_tell_modes_that_cross_apart() -> None:
    """Frequencies alone would pair the lower ones of both files."""
    one, other = {"a": 1.0 + 0j, "b": 0.1 + 0j}, {"a": -0.1 + 0j, "b": 1.0 + 0j}
    groups = group_modes(
        [
            [ModeEstimate(50.0, shape=one), ModeEstimate(50.2, shape=other)],
            [ModeEstimate(50.1, shape=other), ModeEstimate(50.3, shape=one)],
        ]
    )
    found = sorted(tuple(mode.frequency for _, mode in sorted(group.items())) for group in groups)
    assert found == [(50.0, 50.3), (50.2, 50.1)]


@pytest.mark.parametrize("move", [0.0, 0.004, 0.006, 0.012, 0.02])
def test_what_moves_between_setups_is_one_mode_and_a_close_pair_stays_two(move: float) -> None:
    """A pair 1 % apart, which moves as far as that; no shape tells them apart."""
    f = np.array([40.0, 60.0, 60.6, 90.0])
    visits = [[ModeEstimate(value) for value in f], [ModeEstimate(value) for value in f * (1.0 - move)]]
    assert match_visits(visits) == [{0: k, 1: k} for k in range(4)]


@pytest.mark.parametrize(
    ("others", "shapes", "count"),
    [
        (
            [58.0, 63.0],
            ({"a": 1 + 0j}, {"a": -1 + 0j}),
            3,
        ),  # it alone moved, half as far as the next mode at most
        (
            [58.0, 62.0],
            ({"a": 1 + 0j}, {"a": -1 + 0j}),
            4,
        ),  # nearer: another mode that the other setup does not see
        ([58.0, 63.0], ({"a": 1 + 0j}, {"b": 1 + 0j}), 4),  # nothing joins them
        ([58.0, 63.0], ({"a": 1 + 0j, "b": 1 + 0j}, {"a": 1 + 0j, "b": -1 + 0j}), 4),  # other shapes
    ],
)
def test_a_mode_that_moves_alone_is_one_if_no_other_is_near(
    others: list[float], shapes: tuple[dict[str, complex], dict[str, complex]], count: int
) -> None:
    visits = [
        [*map(ModeEstimate, others), ModeEstimate(f, shape=shape)]
        for f, shape in zip((60.0, 60.9), shapes, strict=True)
    ]
    assert len(match_visits(visits)) == count


def by_definition(files: list[list[ModeEstimate]]) -> list[list[tuple[int, ModeEstimate]]]:
    """Merge the nearest pair of all groups until none is near: the definition, cubic in the number of modes."""
    groups = [{i: mode} for i, modes in enumerate(files) for mode in modes]
    groups.sort(key=lambda group: min((mode.frequency, i) for i, mode in group.items()))
    while True:
        pairs = [
            (
                float(
                    np.mean([_mode_distance(a, b) for a in groups[i].values() for b in groups[k].values()])
                ),
                i,
                k,
            )
            for k in range(len(groups))
            for i in range(k)
            if not groups[i].keys() & groups[k].keys()
        ]
        least, i, k = min(pairs, default=(2.0, 0, 0))
        if least > 1.0:
            break
        groups[i] |= groups.pop(k)
    groups.sort(key=lambda group: float(np.mean([mode.frequency for mode in group.values()])))
    return [sorted(group.items(), key=lambda one: one[0]) for group in groups]


@pytest.mark.parametrize("seed", range(8))
def test_groups_are_those_of_the_definition(seed: int) -> None:
    rng = np.random.default_rng(seed)
    f, shapes = 50.0 * np.exp(np.sort(rng.uniform(0.0, 0.08, 10))), rng.normal(size=(10, 3))
    files = [
        [
            ModeEstimate(
                f[k] * np.exp(rng.normal(0.0, 4e-3)),
                shape=dict(zip("abc", (shapes[k] + rng.normal(0.0, 0.2, 3)).astype(complex), strict=True)),
                resolution=float(rng.choice([0.0, 1.0])),
            )
            for k in range(10)
            if rng.uniform() < 0.85
        ]
        for _ in range(4)
    ]
    found = [sorted(group.items(), key=lambda one: one[0]) for group in group_modes(files)]
    assert found == by_definition(files)


def seconds(count: int) -> float:
    """Return the processor time that modes take to be grouped, averaged and reunited."""
    rng = np.random.default_rng(1)
    f, shapes = np.sort(rng.uniform(10.0, 400.0, count)), rng.normal(size=(count, 3)).astype(complex)
    modes = [
        ModeEstimate(value, shape=dict(zip("abc", of, strict=True)))
        for value, of in zip(f, shapes, strict=True)
    ]
    start = time.process_time()
    assert len(mean_modes(group_modes([modes]))) == count
    assert (
        len(group_modes([modes, [ModeEstimate(mode.frequency, shape=mode.shape) for mode in modes[::4]]]))
        == count
    )
    assert (
        len(match_visits([modes, [ModeEstimate(0.98 * mode.frequency, shape=mode.shape) for mode in modes]]))
        == count
    )
    return time.process_time() - start


def test_the_time_of_grouping_grows_with_the_pairs_of_close_modes() -> None:
    """Four times the modes of one band have sixteen times the close pairs; 64 times where groups are compared too."""
    few = min(seconds(500) for _ in range(2))
    assert seconds(2000) < 32.0 * few


def test_setups_are_weighted_by_their_variances_and_their_spread_counts_where_it_is_larger() -> None:
    def mode(frequency: float, sigma: float) -> ModeEstimate:
        return ModeEstimate(frequency, 0.01, {}, sigma, 1e-3, files=(0,))

    log: list[str] = []
    (near,) = join_setups({"x": [mode(50.0, 0.01)], "y": [mode(50.02, 0.02)]}, "P", 0.0, log)
    assert near.frequency == pytest.approx((50.0 * 4 + 50.02 * 1) / 5)
    assert near.sigma_frequency == pytest.approx(1.0 / np.sqrt(1e4 + 2.5e3))
    assert not log
    (apart,) = join_setups({"x": [mode(50.0, 0.01)], "y": [mode(50.2, 0.01)]}, "P", 0.0, [])
    assert apart.frequency * apart.scatter == pytest.approx(0.1)  # half their difference
    # A machine that warmed was as much the one as the other, however well each is known.
    setups = {"x": [mode(50.0, 0.001)], "y": [mode(50.4, 0.1)]}
    (warmed,) = join_setups(setups, "P", 0.0, log)
    assert warmed.frequency == pytest.approx(50.2)
    assert warmed.frequency * warmed.scatter == pytest.approx(0.2)
    (message,) = log
    assert message.startswith("P: the setups x, y differ by more than their standard deviations")
    assert "50 to 50.4 Hz" in message
    join_setups(setups, "P", 3e-3, log)  # which explains it
    assert log == [message]


def test_shapes_without_a_common_sensor_are_said() -> None:
    def mode(shape: dict[str, complex]) -> ModeEstimate:
        return ModeEstimate(50.0, shape=shape, files=(0,))

    log: list[str] = []
    setups = {"x": [mode({"a": 1 + 0j, "b": 2 + 0j})], "y": [mode({"c": 1 + 0j})]}
    (joined,) = join_setups(setups, "P", 0.0, log)
    assert set(joined.shape) == {"a", "b"}
    assert "share no sensor in the setups x, y" in log[0]


@pytest.mark.parametrize(("truth", "within"), [(2e-3, 1e-4), (5e-4, 2e-3)])
def test_scatter_within_visits_is_taken_off_that_between_them(truth: float, within: float) -> None:
    rng = np.random.default_rng(1)
    f = 50.0 + 10.0 * np.arange(12.0)
    records = []
    for _ in range(12):
        visit = f * np.exp(truth * rng.normal(size=f.size))
        files = [
            [ModeEstimate(value) for value in visit * np.exp(within * rng.normal(size=f.size))]
            for _ in range(4)
        ]
        record = SimpleNamespace(point={"x": 0.0}, settings={}, drives="free")
        records.append((record, mean_modes(group_modes(files))))
    value, message = estimate_repeatability(records, "c.toml")
    # 132 degrees of freedom; what is taken off has an error of its own.
    assert value == pytest.approx(truth, rel=0.2 if truth > within else 0.6)
    assert "12 modes" in message


def test_shapes_of_any_scale_and_phase_have_one_mean() -> None:
    rng = np.random.default_rng(2)
    truth = np.array([1.0, -0.6, 0.3, 0.0])
    scales = rng.normal(size=8) + 1j * rng.normal(size=8)
    shapes = [dict(zip("abcd", s * (truth + 0.01 * rng.normal(size=4)), strict=True)) for s in scales]
    mean, left = mean_shape(shapes)
    found = np.array([mean[name] for name in "abcd"])
    assert found[0] == pytest.approx(1.0)
    np.testing.assert_allclose(found.real, truth, rtol=0, atol=0.01)
    assert np.abs(left).max() < 0.05


def test_the_modal_assurance_criterion_counts_common_components() -> None:
    one = {"a": 1.0 + 0j, "b": 1.0 + 0j, "c": 5.0 + 0j}
    assert mac(one, {"a": 2j, "b": 2j}, {}) == pytest.approx(1.0)
    assert mac(one, {"a": 1 + 0j, "b": -1 + 0j}, {}) == pytest.approx(0.0)
    assert mac(one, {"a": 7 + 0j}, {}) == 1.0


def test_sensors_in_oblique_directions_give_the_platform_by_least_squares() -> None:
    def place(name: str, **weights: float) -> Transducer:
        return Transducer(name, None, weights)

    places = {
        "u": place("u", p_x=0.6, p_y=0.8),
        "v": place("v", p_x=-0.8, p_y=0.6),
        "w": place("w", p_z=1.0),
        "r": place("r", x_1=1.0),
        "s": place("s", x_1=1.0),
        "help": place("help"),
    }
    p = np.array([0.5, -1.0, 2.0])
    shape = {
        "u": 0.6 * p[0] + 0.8 * p[1],
        "v": -0.8 * p[0] + 0.6 * p[1],
        "w": p[2],
        "r": 3.0,
        "s": 4.0,
        "help": 9.0,
    }
    found = combine_sensors({name: complex(value) for name, value in shape.items()}, places).values
    assert set(found) == {"p_x", "p_y", "p_z", "x_1"}
    np.testing.assert_allclose([found[f"p_{axis}"] for axis in "xyz"], p, rtol=0, atol=1e-14)
    assert found["x_1"] == pytest.approx(3.5)
    # One oblique sensor determines neither component.
    assert set(combine_sensors({"u": 1 + 0j, "w": 1 + 0j}, places).values) == {"p_z"}


@pytest.mark.parametrize(
    ("unit", "factor", "derivative"),
    [("cm/s2", 0.01, 2), ("gn", 9.80665, 2), ("mg0", 9.80665e-3, 2), ("m/s²", 1.0, 2), ("um", 1e-6, 0)],
)
def test_units_of_campaigns_are_written_as_those_of_files(unit: str, factor: float, derivative: int) -> None:
    found = parse_motion(unit, "c.toml")
    assert (found.factor, found.derivative, found.angular) == (
        pytest.approx(factor, rel=1e-12),
        derivative,
        False,
    )


def test_a_weak_mode_does_not_blur_the_shapes_and_damping_of_strong_ones() -> None:
    """Scatter of known size, some modes a hundred times weaker: two standard deviations cover 95 % of each."""
    rng = np.random.default_rng(12)
    shape, noises = np.array([1.0, 0.6, -0.4, 0.2]), (1e-3, 1e-3, 2e-3, 0.1)
    inside = {noise: [0, 0, 0] for noise in noises}
    for _ in range(150):
        groups = []
        for number, noise in enumerate(noises):
            modes = [
                ModeEstimate(
                    50.0 + 20.0 * number,
                    float(0.01 * np.exp(noise * rng.standard_normal())),
                    dict(zip("abcd", (shape + noise * rng.standard_normal(4)).astype(complex), strict=True)),
                    sigma_damping=0.01 * noise,
                    sigma_shape=noise,
                )
                for _ in range(3)
            ]
            groups.append(dict(enumerate(modes)))
        for noise, mean in zip(noises, mean_modes(groups), strict=True):
            values = np.array([mean.shape[name].real for name in "abcd"])
            # No uncertainty of the identification is added here: the scatter alone.
            inside[noise][0] += int((np.abs(values / values[0] - shape)[1:] < 2.0 * mean.shape_scatter).sum())
            inside[noise][1] += abs(np.log(mean.damping / 0.01)) < 2.0 * mean.damping_scatter
            inside[noise][2] += 1
    for of_shape, of_damping, count in inside.values():
        assert 0.88 < of_shape / (3 * count) <= 0.99
        assert 0.90 < of_damping / count <= 0.99
