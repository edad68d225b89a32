"""Every pose gets the same bits: alone or among others, good or bad, on any width, in any number of threads."""

from __future__ import annotations

import itertools

import numpy as np
import pytest

import pkmodes
from helpers.robots.lane_samples import NAMES, SIX_LEGGED, case, evaluator, results
from helpers.robots.one_of_each import EVERY, ROBOTS
from pkmodes.core.compiled import build
from pkmodes.core.compiled.evaluator import POSES_PER_SHARE
from pkmodes.core.compiled.loader import load
from pkmodes.core.mechanism.poses import check_poses

pytestmark = pytest.mark.compiler


def widths(name: str) -> list[int]:
    library = load(f"pkmodes_generated.{name}", name)
    widths = build.WIDTHS.get(build.machine(), {2: ()})
    return [width for width in widths if width <= library.width and library.has(width)]


def same_bits(a: np.ndarray, b: np.ndarray) -> bool:
    return a.shape == b.shape and a.tobytes() == b.tobytes()


@pytest.mark.parametrize(
    ("name", "effects"),
    [
        *itertools.product(NAMES, ["none", "clamps with belt mass", "everything"]),
        *itertools.product(SIX_LEGGED, ["everything"]),
    ],
)
def test_all_widths_give_the_same_bits(name: str, effects: str) -> None:
    given = case(name, 2, effects, count=50)
    given.poses[[3, 20, 21, 44]] = np.array([np.nan, 9.0, -np.inf, 1e300])[:, None]
    first, *others = [results(given, given.poses, width) for width in widths(name)]
    for codes, arrays in others:
        assert same_bits(codes, first[0])
        for field, array in arrays.items():
            assert same_bits(array, first[1][field]), field


@pytest.mark.parametrize("name", NAMES)
def test_a_pose_has_the_same_bits_in_a_batch_of_any_size(name: str) -> None:
    given = case(name, 2, count=53)
    _, whole = results(given, given.poses)
    for count in (1, 2, 7, 8, 9, 16, 17, 23, 24, 25, 31, 48, 49):
        _, part = results(given, given.poses[-count:])
        for field, array in part.items():
            assert same_bits(array, whole[field][-count:]), (field, count)


@pytest.mark.parametrize("effects", ["none", "everything"])
@pytest.mark.parametrize("name", NAMES)
def test_a_bad_pose_leaves_its_neighbours_alone(name: str, effects: str) -> None:
    """Each kind of bad pose in each lane: not finite, far away, beyond limits."""
    given = case(name, 3, effects, count=24)
    codes, good = results(given, given.poses)
    assert not codes.any()
    for bad, place in itertools.product((np.nan, np.inf, -np.inf, 1e300, 1e4, 5.0), range(0, 24, 5)):
        poses = given.poses.copy()
        poses[place, place % poses.shape[1]] = bad
        found, arrays = results(given, poses)
        assert found[place] == check_poses(poses, given.mechanism, given.parameters, "nan").codes[place] != 0
        others = np.arange(24) != place
        assert not found[others].any()
        for field, array in arrays.items():
            assert np.isnan(array[place]).all(), field
            assert same_bits(array[others], good[field][others]), (field, bad, place)


@pytest.mark.parametrize("name", NAMES)
def test_codes_are_those_of_the_margins_all_over_space(name: str) -> None:
    model = pkmodes.load(ROBOTS / EVERY[name])
    rng = np.random.default_rng(5)
    poses = rng.uniform(-1.5, 1.5, (20_000, len(model.mechanism.pose)))
    expected = model.check(poses)
    found = model.modes(poses, "nan", fields=["frequencies"], backend="compiled")
    np.testing.assert_array_equal(found.codes, expected.codes)
    assert len(set(expected.reason.tolist())) > 1


def test_a_singular_pose_is_named_as_by_numpy() -> None:
    model = pkmodes.load("robots/linear-delta-2022.toml")
    strict = pkmodes.Model(model.robot, 3.6)
    poses = np.random.default_rng(6).uniform([0.2, -0.2, -0.35], [1.0, 0.2, -0.1], (500, 3))
    found, expected = strict.modes(poses, "nan", backend="compiled"), strict.check(poses)
    np.testing.assert_array_equal(found.codes, expected.codes)
    assert "singular" in expected.reason


@pytest.mark.parametrize("name", NAMES)
def test_threads_do_not_change_a_bit(name: str) -> None:
    given = case(name, 2, count=4 * POSES_PER_SHARE + 11)
    run = evaluator(given)
    found = []
    for threads in (1, 2, 3, 4):
        frequencies = np.empty((len(given.poses), run.modes))
        codes = run.run(given.poses, {"frequencies": frequencies}, threads)
        found.append(codes.tobytes() + frequencies.tobytes())
    assert len(set(found)) == 1


@pytest.mark.parametrize("name", NAMES)
def test_frequencies_alone_have_the_bits_of_those_with_shapes(name: str) -> None:
    model = pkmodes.load(ROBOTS / EVERY[name])
    poses = case(name, 2).poses
    both = model.modes(poses, "nan", backend="compiled").frequencies
    assert same_bits(both, model.frequencies(poses, "nan", backend="compiled"))
