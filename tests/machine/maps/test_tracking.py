"""Tracking on systems whose branches are known in closed form."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray
from scipy.linalg import eigh

from pkmodes.machine.dataset.variables import EVENT_FLAGS
from pkmodes.machine.maps.tracking import Tracked, track

Array = NDArray[np.float64]
CROSSING, VEERING, UNCERTAIN = EVENT_FLAGS.values()


class Followed:
    """Systems with M = 1 and given K on a grid, their modes by rank and by shape."""

    def __init__(
        self, stiffness: Array, valid: Array | None = None, linked: tuple[bool, ...] | None = None
    ) -> None:
        self.shape, n = stiffness.shape[:-2], stiffness.shape[-1]
        values, vectors = np.linalg.eigh(stiffness.reshape(-1, n, n))
        self.values, self.shapes = values, np.swapaxes(vectors, 1, 2).copy()
        self.valid = np.ones(len(values), bool) if valid is None else valid.reshape(-1)
        self.shapes[~self.valid] = np.nan
        arrays = {"shape": self.shapes, "code": np.where(self.valid, 0, 3).astype(np.int8)}
        axes = (True,) * len(self.shape) if linked is None else linked
        self.tracked: Tracked = track(
            arrays, self.shape, axes, lambda rows: np.tile(np.eye(n), (len(rows), 1, 1))
        )

    def of(self, values: Array) -> Array:
        """Values (rows, modes, ...) in the tracked order, on the grid."""
        order = self.tracked.order.reshape(*self.tracked.order.shape, *[1] * (values.ndim - 2))
        found = np.take_along_axis(values, order, axis=1)
        return found.reshape(*self.shape, *values.shape[1:])

    @property
    def branches(self) -> Array:
        return self.of(self.values)

    @property
    def events(self) -> NDArray[np.int8]:
        return self.tracked.events.reshape(*self.shape, -1)


def diagonal(*branches: Array) -> Array:
    """Uncoupled oscillators."""
    return np.stack(branches, axis=-1)[..., None] * np.eye(len(branches))


def test_uncoupled_oscillators_are_followed_through_their_crossing() -> None:
    x = np.linspace(-1.0, 1.0, 21) + 0.013
    found = Followed(diagonal(5.0 + x, 5.0 - x))
    # In the middle of the list, at x = 0.013, the falling branch is the lower one.
    np.testing.assert_allclose(found.branches, np.stack([5.0 - x, 5.0 + x], -1), rtol=1e-12)
    marked = np.flatnonzero((found.events & CROSSING).any(axis=-1))
    assert marked.tolist() == [9, 10], "x = -0.087 and 0.013, between which they cross"
    assert not (found.events & (VEERING | UNCERTAIN)).any()


def test_modes_of_a_large_map_are_followed_where_products_of_rows_exceed_32_bits() -> None:
    x = np.linspace(-1.0, 1.0, 70_000) + 0.013
    found = Followed(diagonal(5.0 + x, 5.0 - x))
    np.testing.assert_allclose(found.branches, np.stack([5.0 - x, 5.0 + x], -1), rtol=1e-12)


def test_coupled_oscillators_keep_their_rank_and_exchange_their_shapes_as_marked() -> None:
    x = np.linspace(-1.0, 1.0, 81)
    K = diagonal(5.0 + x, 5.0 - x)
    K[:, 0, 1] = K[:, 1, 0] = 0.1
    found = Followed(K)
    assert (np.diff(found.branches, axis=1) > 0.19).all(), "the gap is twice the coupling"
    assert not (found.events & CROSSING).any()
    # The shapes turn by a right angle within about |x| < 0.1: in no step by more than the marks ask for.
    coarse = Followed(K[::4])
    near = np.abs(x[::4]) <= 0.1
    assert (coarse.events[near] & (VEERING | UNCERTAIN)).any(axis=-1).all()
    assert not coarse.events[np.abs(x[::4]) > 0.3].any()


def test_a_coupling_much_weaker_than_a_step_is_a_crossing() -> None:
    x = np.linspace(-1.0, 1.0, 20)
    K = diagonal(5.0 + x, 5.0 - x)
    K[:, 0, 1] = K[:, 1, 0] = 1e-4
    found = Followed(K)
    assert (np.abs(np.diff(found.branches, axis=0)) < 0.11).all()
    assert np.sign(np.diff(found.branches[[0, -1]], axis=1)).ravel().prod() == -1, "they cross"


def test_three_modes_at_once() -> None:
    x = np.linspace(-1.0, 1.0, 40)
    branches = 5.0 + x, 5.0 - x, 5.0 + 0.2 * x
    found = Followed(diagonal(*branches))
    every = {tuple(np.round(column, 9)) for column in found.branches.T}
    assert every == {tuple(np.round(branch, 9)) for branch in branches}


def test_shapes_keep_their_sign() -> None:
    x = np.linspace(0.0, 1.0, 50)
    angle = 3.0 * x
    turn = np.moveaxis(np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]), -1, 0)
    found = Followed(turn @ diagonal(1.0 + 0 * x, 2.0 + 0 * x) @ np.swapaxes(turn, 1, 2))
    shapes = found.of(found.shapes) * found.tracked.signs[..., None]
    assert ((shapes[1:] * shapes[:-1]).sum(axis=-1) > 0.99).all()


def conical(x: Array, y: Array) -> Array:
    """Through (0, 0) the two modes cross, on any path around it they do not."""
    K = np.empty((*x.shape, 2, 2))
    K[..., 0, 0], K[..., 1, 1], K[..., 0, 1], K[..., 1, 0] = 5.0 + x, 5.0 - x, y, y
    return K


def test_a_conical_intersection_is_marked_where_the_numbering_breaks() -> None:
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 24), np.linspace(-1.0, 1.0, 24))
    found = Followed(conical(x, y))
    uncertain = (found.events & UNCERTAIN).any(axis=-1)
    assert uncertain.any()
    assert uncertain.mean() < 0.15
    # Everywhere else neighbours that are numbered alike are alike.
    shapes = found.of(found.shapes)
    for axis in (0, 1):
        a, b = (np.take(shapes, np.arange(24)[part], axis=axis) for part in (slice(1, None), slice(None, -1)))
        mac = (a * b).sum(axis=-1) ** 2
        marked = np.take(uncertain, range(1, 24), axis=axis) & np.take(uncertain, range(23), axis=axis)
        assert (mac[~marked] > 0.5).all()


def test_on_a_ring_around_the_intersection_modes_keep_their_rank_but_not_their_sign() -> None:
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 31), np.linspace(-1.0, 1.0, 31))
    ring = np.hypot(x, y) > 0.4
    found = Followed(conical(x, y), ring)
    assert (found.tracked.order == [0, 1]).all()
    assert not found.tracked.events.any()
    shapes = found.of(found.shapes) * found.tracked.signs.reshape(31, 31, 2, 1)
    products = [(a * b).sum(axis=-1) for a, b in ((shapes[1:], shapes[:-1]), (shapes[:, 1:], shapes[:, :-1]))]
    assert any((product < -0.5).any() for product in products), "the vectors turn by half the angle"


def test_poses_that_cannot_be_evaluated_divide_the_map_into_parts_with_their_own_reference() -> None:
    x = np.linspace(-1.0, 1.0, 41)
    valid = np.abs(x) > 0.3
    found = Followed(diagonal(5.0 + x, 5.0 - x), valid)
    assert (found.tracked.order[valid] == [0, 1]).all(), "each part is numbered by rank at its own middle"
    assert (found.tracked.events == 0).all()


def test_many_parts_and_lonely_poses() -> None:
    rng = np.random.default_rng(1)
    x, y = np.meshgrid(np.linspace(-1.0, 1.0, 60), np.linspace(-1.0, 1.0, 50))
    found = Followed(diagonal(5.0 + x, 5.0 - x, 4.9 + y), rng.random(x.shape) < 0.4)
    expect_permutations(found)
    assert not (found.tracked.events.reshape(-1, 3)[~found.valid]).any()


def test_one_pose_and_none() -> None:
    one = Followed(diagonal(np.array([1.0]), np.array([2.0])))
    assert one.tracked.order.tolist() == [[0, 1]]
    none = Followed(diagonal(np.ones(3), np.full(3, 2.0)), np.zeros(3, bool))
    assert (none.tracked.order == [0, 1]).all()


def test_repeated_frequencies_do_no_harm() -> None:
    x = np.linspace(-1.0, 1.0, 21)  # both are 5 at x = 0, where any shapes are as good
    found = Followed(diagonal(5.0 + x, 5.0 - x, 9.0 + 0 * x))
    expect_permutations(found)
    np.testing.assert_allclose(found.branches[:, 2], 9.0)
    assert (np.abs(np.diff(found.branches, axis=0)) < 0.11).all()


def test_samples_are_compared_with_the_first_one() -> None:
    """Neighbours along a linked axis are next to each other; samples have no order."""
    x = np.array([-0.5, 0.9, -0.9, 0.6, -0.1, 0.2])
    found = Followed(diagonal(5.0 + x, 5.0 - x)[:, None], linked=(False, True))
    np.testing.assert_allclose(np.abs(np.diff(found.branches[..., 0], axis=0)), np.abs(np.diff(x))[:, None])
    assert (found.events[0] & CROSSING).any()
    third = found.events[2]
    assert not third.any(), "a sample on the same side of the crossing as the first"


def expect_permutations(found: Followed) -> None:
    modes = found.tracked.order.shape[1]
    assert (np.sort(found.tracked.order, axis=1) == np.arange(modes)).all()
    assert set(np.unique(found.tracked.signs)) <= {-1, 1}


@given(st.integers(0, 10_000), st.integers(2, 5), st.tuples(st.integers(1, 5), st.integers(1, 6)))
def test_a_tracked_map_is_a_permutation_of_the_ranks_at_each_pose(
    seed: int, modes: int, shape: tuple[int, int]
) -> None:
    rng = np.random.default_rng(seed)
    a = rng.normal(size=(*shape, modes, modes))
    found = Followed(a + np.swapaxes(a, -1, -2), rng.random(shape) < 0.8)
    expect_permutations(found)
    # And the result does not depend on the signs of the shapes, or on the order of rows beyond their neighbourhood.
    assert found.tracked.order.shape == (shape[0] * shape[1], modes)


@pytest.mark.parametrize("scale", [1.0, 1e-3])
def test_mass_weighted_shapes_with_a_mass_that_changes(scale: float) -> None:
    """Uncoupled oscillators in coordinates that are mixed by a constant matrix: M and K are full."""
    x = np.linspace(-1.0, 1.0, 30) + 0.01
    mix = np.array([[1.0, 0.4], [-0.3, 2.0]])
    masses = scale * mix.T @ diagonal(1.0 + 0.2 * x, 2.0 - 0.3 * x) @ mix
    springs = scale * mix.T @ diagonal(5.0 + 3.0 * x, 10.0 - 6.0 * x) @ mix
    values, shapes = zip(*(eigh(K, M) for K, M in zip(springs, masses, strict=True)), strict=True)
    arrays = {"shape": np.swapaxes(np.array(shapes), 1, 2), "code": np.zeros(30, np.int8)}
    found = track(arrays, (30,), (True,), lambda rows: masses[rows])
    followed = np.take_along_axis(np.array(values), found.order, axis=1)
    branches = {tuple(np.round(column, 6)) for column in followed.T}
    exact = (5.0 + 3.0 * x) / (1.0 + 0.2 * x), (10.0 - 6.0 * x) / (2.0 - 0.3 * x)
    assert branches == {tuple(np.round(branch, 6)) for branch in exact}
    assert (found.events & CROSSING).any()


def test_the_clearest_way_is_taken() -> None:
    """A wall of doubtful steps with a gap: all poses behind it are reached through the gap."""

    def coupled(coupling: Callable[[Array], Array]) -> Followed:
        x, y = np.meshgrid(np.linspace(-1.0, 1.0, 20), np.linspace(0.0, 1.0, 21))
        K = diagonal(5.0 + 4.0 * x, 5.0 - 4.0 * x)
        K[..., 0, 1] = K[..., 1, 0] = coupling(y)
        return Followed(K)

    # Strong coupling near y = 0 (the modes veer slowly, each step is clear), next to none near y = 1.
    found = coupled(lambda y: 3.0 * np.maximum(0.0, 0.5 - y) + 0.3)
    gap = found.branches[:3]
    assert (np.diff(gap, axis=-1) > 0.5).all(), "no crossing where the coupling is strong"
    expect_permutations(found)


def test_a_doubtful_step_is_taken_only_where_there_is_no_way_around_it() -> None:
    """A ring of eight poses whose shapes turn by 10 degrees in seven steps, and by 70 degrees back in the last.

    The last one alone looks like an exchange of the two modes; the others together say that there is none.
    """
    ring = [(0, 0), (0, 1), (0, 2), (1, 2), (2, 2), (2, 1), (2, 0), (1, 0)]
    K, valid = np.zeros((3, 3, 2, 2)), np.ones((3, 3), bool)
    valid[1, 1] = False
    for k, place in enumerate(ring):
        c, s = np.cos(np.radians(10.0 * k)), np.sin(np.radians(10.0 * k))
        turn = np.array([[c, -s], [s, c]])
        K[place] = turn @ np.diag([1.0, 2.0]) @ turn.T
    found = Followed(K, valid)
    order = found.tracked.order.reshape(3, 3, 2)
    assert all((order[place] == [0, 1]).all() for place in ring)
    doubtful = (found.events & UNCERTAIN).any(axis=-1)
    assert {tuple(place) for place in np.argwhere(doubtful).tolist()} == {ring[0], ring[-1]}


def test_the_size_of_the_mass_does_not_matter() -> None:
    """The same shapes in a machine that is four times as heavy at each pose: they are halved, not doubtful."""
    sizes = 4.0 ** np.arange(4)
    arrays = {"shape": np.eye(2) / np.sqrt(sizes)[:, None, None], "code": np.zeros(4, np.int8)}
    found = track(arrays, (4,), (True,), lambda rows: sizes[rows, None, None] * np.eye(2))
    assert (found.order == [0, 1]).all()
    assert not found.events.any()
