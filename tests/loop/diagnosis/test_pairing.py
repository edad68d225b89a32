"""Mode pairing: properties that must hold for any order, scale and missing modes.

Modes that are alike at the sensors: a subspace of them counts only directions that differ measurably.
"""

from __future__ import annotations

import itertools
from dataclasses import replace

import numpy as np
import pytest

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.mac import INDEPENDENCE_TOLERANCE, explained_difference, subspace_basis
from pkmodes.loop.diagnosis import Measurements, Prediction
from pkmodes.loop.diagnosis.match.pairing import Pairer, Pairing
from pkmodes.loop.diagnosis.match.predicted import PartnerPredictions

CHANNELS = ("a", "b", "c", "d", "e")


def predicted(frequencies: list[float], shapes: np.ndarray | None = None, rigid: int = 0) -> Prediction:
    f = np.array(frequencies)[None]
    C = np.eye(f.shape[1], len(CHANNELS)) if shapes is None else shapes
    return Prediction((2 * np.pi * f) ** 2, np.zeros((*f.shape, 0)), C[None], rigid)


def measured(frequencies: list[float], shapes: np.ndarray | None = None, channels=CHANNELS) -> Measurements:
    f = np.array(frequencies)
    columns = None if shapes is None else dict(zip(channels, shapes.T, strict=True))
    mode = range(len(f))  # or rows with the same frequency would be repetitions
    return Measurements.from_rows(["A"] * len(f), f, 0.001 * f, shapes=columns, mode=mode)


def pair(data: Measurements, prediction: Prediction) -> Pairing:
    return Pairer(data, CHANNELS).pair(prediction, np.ones(len(data.frequency), dtype=bool))


def told(data: Measurements, prediction: Prediction) -> PartnerPredictions:
    pairer = Pairer(data, CHANNELS)
    pairing = pairer.pair(prediction, np.ones(len(data.frequency), dtype=bool))
    return PartnerPredictions.from_pairing(pairer, data, prediction, pairing, np.full(len(pairing.mac), 1e-3))


def random_shapes(seed: int, count: int = 5) -> np.ndarray:
    return np.random.default_rng(seed).standard_normal((count, len(CHANNELS)))


def test_without_shapes_the_sum_of_squares_is_the_least_of_all_one_to_one_assignments() -> None:
    rng = np.random.default_rng(0)
    for _ in range(50):
        model = np.sort(10.0 * np.exp(rng.uniform(0.0, 0.5, 5)))
        logs = np.log(rng.permutation(10.0 * np.exp(rng.uniform(0.0, 0.5, 4))))
        found = pair(measured(list(np.exp(logs))), predicted(list(model))).partner
        assert len(set(found)) == 4
        least = min(
            np.sum((logs - np.log(model[list(order)])) ** 2) for order in itertools.permutations(range(5), 4)
        )
        assert np.sum((logs - np.log(model[found])) ** 2) == pytest.approx(least)


def test_modes_of_the_model_are_assigned_once_although_more_were_measured() -> None:
    found = pair(measured([10.0, 10.2, 10.4]), predicted([10.3, 20.0])).partner
    assert sorted(found) == [-1, -1, 0]
    assert found[2] == 0 or found[1] == 0


def test_shapes_decide_where_the_order_of_frequencies_is_exchanged() -> None:
    shapes = random_shapes(1, 3)
    model = predicted([10.0, 10.6, 20.0], shapes)
    assert pair(measured([10.0, 10.6, 20.0]), model).partner.tolist() == [0, 1, 2]
    found = pair(measured([10.0, 10.6, 20.0], shapes[[1, 0, 2]]), model)
    assert found.partner.tolist() == [1, 0, 2]
    assert found.mac == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("mac", "sigma", "is_pair"), [(0.51, 0.001, True), (0.49, 0.001, False), (0.49, 0.3, True)]
)
def test_a_partner_of_another_shape_is_told_as_none(mac: float, sigma: float, is_pair: bool) -> None:
    """A shape with a component sqrt(mac) along its mode has that MAC with it; large errors of the shape explain more.

    The fit keeps the partner, whose frequency and MAC are told as those of the nearest mode.
    """
    shapes = np.eye(2, len(CHANNELS))
    shapes[1, [1, 4]] = np.sqrt([mac, 1.0 - mac])
    data = replace(measured([10.0, 20.2], shapes), shape_sigma=np.full(2, sigma))
    prediction = predicted([10.0, 20.0, 60.0, 70.0, 80.0])
    assert pair(data, prediction).partner.tolist() == [0, 1]
    answer = told(data, prediction)
    assert answer.partner_mode.tolist() == [1, 2 if is_pair else 0]
    assert np.isfinite(answer.frequency).tolist() == [True, is_pair]
    assert np.isfinite(answer.normalised_differences).tolist() == [True, is_pair]
    expected, missing = (20.0, mac), (np.nan, np.nan)
    np.testing.assert_allclose((answer.frequency[1], answer.partner_mac[1]), expected if is_pair else missing)
    np.testing.assert_allclose(
        (answer.nearest_frequency[1], answer.nearest_mac[1]), missing if is_pair else expected
    )
    assert np.isnan(answer.nearest_frequency[0])


def test_a_shape_that_close_modes_of_the_model_can_form_is_no_other_one() -> None:
    """Turned by 80 degrees in the plane of two modes 0.2 % apart: the machine's modes are 6 % apart, and theirs."""
    turn = np.radians(80.0)
    shapes = np.zeros((2, len(CHANNELS)))
    shapes[:, :2] = [[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]]
    data, prediction = measured([9.8, 10.4], shapes), predicted([10.0, 10.02, 60.0, 70.0, 80.0])
    np.testing.assert_allclose(pair(data, prediction).mac, np.cos(turn) ** 2)
    answer = told(data, prediction)
    assert answer.partner_mode.tolist() == [1, 2]
    np.testing.assert_allclose(answer.partner_mac, 1.0)
    np.testing.assert_allclose(answer.fitted_mac, np.cos(turn) ** 2)
    apart = told(data, predicted([10.0, 10.2, 60.0, 70.0, 80.0]))  # 2 %: each shape is its own
    np.testing.assert_allclose(apart.partner_mac, np.sin(turn) ** 2)
    assert apart.partner_mode.tolist() == [2, 1]


def test_without_shapes_every_partner_is_told() -> None:
    answer = told(measured([10.0, 20.2]), predicted([10.0, 20.0]))
    assert answer.partner_mode.tolist() == [1, 2]
    assert np.isnan(answer.nearest_frequency).all()


def test_the_same_shape_at_twice_the_frequency_is_another_mode() -> None:
    shapes = random_shapes(2, 2)
    found = pair(measured([10.0], shapes[[1]]), predicted([10.0, 20.0], shapes))
    assert found.partner.tolist() == [0]
    assert found.mac[0] < 0.9


@pytest.mark.parametrize(("sigma", "partner"), [(0.01, 1), (0.1, 0)])
def test_within_its_errors_a_shape_does_not_tell_modes_apart(sigma: float, partner: int) -> None:
    """The shape is a little more like that of the mode whose frequency is 1.5 % off."""
    shapes = np.eye(3, len(CHANNELS))
    row = shapes[0] + shapes[1] * [0.0, 1.02, 0.0, 0.0, 0.0]
    halves = np.array([[1.0, 0.8, 0.0, 0.0, 0.0], [0.9, 1.0, 0.0, 0.0, 0.0], shapes[2]])
    both = (halves[:2] @ row) ** 2 / (halves[:2] ** 2).sum(axis=1) / (row @ row)
    assert 0.98 < both[0] < both[1] - 4e-3
    data = measured([10.0], row[None])
    given = Measurements.from_rows(
        ["A"],
        data.frequency,
        data.sigma,
        shapes=dict(zip(CHANNELS, row[:, None], strict=True)),
        shape_sigma=sigma,
    )
    assert pair(given, predicted([10.0, 10.15, 20.0], halves)).partner.tolist() == [partner]


def test_what_errors_explain_of_the_mac_is_what_many_noisy_shapes_have() -> None:
    rng = np.random.default_rng(11)
    shape = np.array([1.0, -0.6, 0.3, 0.0, 0.8])
    errors = np.array([0.02, 0.05, 0.04, 0.03, 0.0])
    noisy = shape + errors * rng.standard_normal((200_000, 5))
    loss = 1.0 - (noisy @ shape) ** 2 / (noisy**2).sum(axis=1) / (shape @ shape)
    for sigmas in (0.0, 3.0):  # the rest is of fourth order in the errors, and of the number of shapes
        expected = loss.mean() + sigmas * loss.std()
        assert explained_difference(shape, errors, sigmas) == pytest.approx(expected, rel=0.02)


@pytest.mark.parametrize("turn", [0.0, 0.3, np.pi / 4, 1.2])
def test_close_modes_are_compared_as_a_subspace(turn: float) -> None:
    shapes = np.eye(4, 5)
    rotated = shapes.copy()
    c, s = np.cos(turn), np.sin(turn)
    rotated[:2] = np.array([[c, s], [-s, c]]) @ shapes[:2]
    together = pair(
        measured([10.0, 10.05, 20.0, 30.0], rotated), predicted([10.0, 10.05, 20.0, 30.0], shapes)
    )
    assert together.partner.tolist() == [0, 1, 2, 3]
    assert together.mac == pytest.approx(1.0)  # any combination of two close modes is in their space
    apart = pair(measured([10.0, 10.5, 20.0, 30.0], rotated), predicted([10.0, 10.5, 20.0, 30.0], shapes))
    # At separate frequencies they are two shapes.  All channels have the same weight here, for any angle.
    larger = max(c**2, s**2)
    assert apart.mac == pytest.approx([larger, larger, 1.0, 1.0])


def test_a_shape_outside_the_space_of_close_modes_does_not_agree_with_them() -> None:
    other = np.eye(5)[[4, 4, 2, 3]]
    model = predicted([10.0, 10.05, 20.0, 30.0, 70.0], np.eye(5))
    found = pair(measured([10.0, 10.05, 20.0, 30.0], other), model)
    assert found.partner.tolist() == [0, 1, 2, 3]
    assert found.mac == pytest.approx([0.0, 0.0, 1.0, 1.0])


def test_close_modes_that_the_sensors_cannot_tell_apart_span_no_more_than_they_show() -> None:
    # They differ at channel d only, which was not measured: at a, b and c both are along a.
    shapes = np.array([[1, 0, 0, 1, 0], [1, 0, 0, -1, 0], [0, 1, 1, 0, 0], [0, 1, -1, 0, 1]]) / np.sqrt(2)
    rows = np.array([[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    found = pair(
        measured([10.0, 10.05], rows, channels=("a", "b", "c")), predicted([10.0, 10.05, 30.0, 50.0], shapes)
    )
    assert found.mac == pytest.approx([0.5, 0.0])


@pytest.mark.parametrize("size", [1.0, 1e-6, 1e20, 1e-170])
def test_scale_and_sign_of_a_row_are_irrelevant(size: float) -> None:
    rng = np.random.default_rng(30)
    shapes = random_shapes(3)
    noisy = shapes + 0.1 * rng.standard_normal(shapes.shape)
    f = [10.0, 10.4, 11.0, 11.5, 12.0]
    plain = pair(measured(f, noisy), predicted(f, shapes))
    rows = size * np.array([1.0, -2.0, 0.3, -5.0, 7.0])[:, None] * noisy
    scaled = pair(measured(f, rows), predicted(f, shapes))
    assert scaled.partner.tolist() == plain.partner.tolist()
    assert scaled.mac == pytest.approx(plain.mac, rel=1e-12)
    assert ((plain.mac > 0.8) & (plain.mac < 1.0)).all()


def test_a_subset_of_the_channels_in_any_order_is_enough() -> None:
    shapes = random_shapes(4, 3)
    f = [10.0, 10.6, 20.0]
    some = measured(f, shapes[[1, 0, 2]][:, [3, 0, 2]], channels=("d", "a", "c"))
    found = pair(some, predicted(f, shapes))
    assert found.partner.tolist() == [1, 0, 2]
    assert found.mac == pytest.approx(1.0)


def test_blank_components_are_left_out_of_the_comparison() -> None:
    shapes = random_shapes(5, 3)
    rows = shapes[[1, 0, 2]].copy()
    rows[0, [0, 3]] = rows[1, 4] = np.nan
    f = [10.0, 10.6, 20.0]
    found = pair(measured(f, rows), predicted(f, shapes))
    assert found.partner.tolist() == [1, 0, 2]
    assert found.mac == pytest.approx(1.0)


def test_one_component_is_not_a_shape() -> None:
    shapes = random_shapes(6, 3)
    rows = np.full((3, 5), np.nan)
    rows[:, 2] = [1.0, 2.0, 3.0]
    f = [10.0, 10.6, 20.0]
    found = pair(measured(f, rows), predicted(f, shapes))
    assert found.partner.tolist() == [0, 1, 2]
    assert np.isnan(found.mac).all()


@pytest.mark.parametrize("with_shapes", [False, True])
@pytest.mark.parametrize("extra", [4.0, 5.0, 45.0])
def test_a_measured_mode_that_the_model_lacks_stays_unpaired(extra: float, with_shapes: bool) -> None:
    model = [10.0, 13.5, 18.2, 24.6]
    shapes = random_shapes(7, 5)
    frequencies = [extra, *model]
    data = measured(frequencies, shapes[[4, 0, 1, 2, 3]] if with_shapes else None)
    # The model has more modes than were measured, so the stray one could shift the others.
    prediction = predicted([*model, 110.0], np.vstack([shapes[:4], random_shapes(8, 1)]))
    assert pair(data, prediction).partner.tolist() == [-1, 0, 1, 2, 3]


def test_missed_modes_are_skipped() -> None:
    shapes = random_shapes(9)
    f = [10.0, 12.0, 14.4, 17.3, 20.7]
    found = pair(measured([f[4], f[1], f[2]], shapes[[4, 1, 2]]), predicted(f, shapes))
    assert found.partner.tolist() == [4, 1, 2]


def test_rigid_modes_are_never_partners() -> None:
    shapes = random_shapes(10)
    prediction = predicted([9.8, 10.0, 10.1, 12.0, 20.0], shapes, rigid=3)
    found = pair(measured([10.0, 20.0], shapes[[1, 4]]), prediction)
    assert found.partner.tolist() == [3, 4]


@pytest.mark.parametrize("unit", [1.0, 1e3, 1e-3])
def test_metres_and_radians_have_equal_weight(unit: float) -> None:
    # Modes 0 and 1 differ in the small channel only; beside metres a plain MAC would call them the same shape.
    shapes = np.array([[1.0, 0.5, 0.2, 0.1, 1e-4], [1.0, 0.5, 0.2, 0.1, -1e-4], [0.1, 0.9, -0.8, 0.3, 1e-4]])
    shapes *= np.array([1.0, 1.0, 1.0, 1.0, unit])
    f = [10.0, 10.6, 20.0]
    found = pair(measured(f, shapes[[1, 0, 2]]), predicted(f, shapes))
    assert found.partner.tolist() == [1, 0, 2]
    assert found.mac == pytest.approx(1.0)
    other = pair(measured([10.0, 20.0], shapes[[1, 2]]), predicted([10.0, 20.0], shapes[[0, 2]]))
    assert other.mac[0] < 0.8


def test_each_setup_is_paired_on_its_own_and_rows_may_be_in_any_order() -> None:
    f = np.array([[10.0, 20.0], [14.0, 28.0]])
    prediction = Prediction((2 * np.pi * f) ** 2, np.zeros((2, 2, 0)), np.zeros((2, 2, 5)))
    data = Measurements.from_rows(["A", "B", "B", "A"], [20.1, 28.1, 14.1, 10.1], [0.1] * 4)
    assert pair(data, prediction).partner.tolist() == [1, 1, 0, 0]


def test_rows_that_are_not_used_have_no_partner_and_take_none() -> None:
    data = measured([10.0, 10.3])
    pairer = Pairer(data, CHANNELS)
    found = pairer.pair(predicted([10.1]), np.array([False, True]))
    assert found.partner.tolist() == [-1, 0]


def test_a_setup_that_cannot_be_evaluated_has_no_partners() -> None:
    f = np.array([[10.0, 20.0], [np.nan, np.nan]])
    prediction = Prediction((2 * np.pi * f) ** 2, np.zeros((2, 2, 0)), np.zeros((2, 2, 5)))
    data = Measurements.from_rows(["A", "B"], [10.0, 10.0], [0.1, 0.1])
    assert pair(data, prediction).partner.tolist() == [0, -1]


def test_a_mode_at_zero_frequency_is_not_a_partner() -> None:
    assert pair(measured([10.0, 20.0]), predicted([0.0, 10.0, 20.0])).partner.tolist() == [1, 2]


def test_a_channel_that_the_model_lacks_is_refused() -> None:
    with pytest.raises(PkmodesError, match=r'no channel "roof".*channels are: a, b, c, d, e'):
        Pairer(measured([10.0], np.ones((1, 2)), channels=("a", "roof")), CHANNELS)


def test_a_hypothesis_that_adds_modes_is_compared_with_the_same_weights() -> None:
    """A high mode with a large motion at one channel would reduce the weight of errors there."""
    shapes = random_shapes(8, 2)
    noisy = shapes.copy()
    noisy[:, 0] += 0.5
    data, every = measured([10.0, 20.0], noisy), np.ones(2, dtype=bool)
    heavy = np.zeros((1, len(CHANNELS)))
    heavy[0, 0] = 50.0
    plain = predicted([10.0, 20.0], shapes)
    more = predicted([10.0, 20.0, 500.0], np.vstack([shapes, heavy]))
    own = [Pairer(data, CHANNELS).pair(prediction, every).mac for prediction in (plain, more)]
    assert (own[1] > own[0] + 0.01).all()
    pairer = Pairer(data, CHANNELS, plain)
    same = [pairer.pair(prediction, every).mac for prediction in (plain, more)]
    np.testing.assert_array_equal(same[1], same[0])
    np.testing.assert_allclose(same[0], own[0])


def test_a_hypothesis_that_brings_two_modes_together_is_not_judged_less_strictly() -> None:
    """Shapes measured at well-separated frequencies are compared one by one, whatever the model's frequencies."""
    shapes = random_shapes(9, 2)
    turned = shapes @ np.eye(len(CHANNELS)) + 0.3 * shapes[::-1]
    data, every = measured([10.0, 11.0], turned), np.ones(2, dtype=bool)
    apart, together = predicted([10.0, 11.0], shapes), predicted([10.4, 10.6], shapes)
    pairer = Pairer(data, CHANNELS, apart)
    assert (pairer.pair(apart, every).mac < 0.99).all()
    np.testing.assert_allclose(pairer.pair(together, every).mac, pairer.pair(apart, every).mac)
    # Measured close together, they may mix.
    close = measured([10.0, 10.1], turned)
    np.testing.assert_allclose(Pairer(close, CHANNELS, apart).pair(apart, every).mac, 1.0)


@pytest.mark.parametrize(("apart", "dimension"), [(1e-4, 2), (3e-6, 2), (3e-7, 1), (0.0, 1)])
def test_modes_span_two_directions_if_they_differ_by_a_millionth(apart: float, dimension: int) -> None:
    """By the components, not by their squares."""
    basis, _ = subspace_basis(np.array([[[1.0, 0.0], [0.0, apart]]]))
    assert np.linalg.matrix_rank(basis[0]) == dimension


def test_a_difference_of_exactly_the_limit_does_not_count() -> None:
    basis, back = subspace_basis(np.array([[[1.0, 0.0], [0.0, INDEPENDENCE_TOLERANCE]]]))
    assert basis.shape == back.shape == (1, 2, 2)
    np.testing.assert_array_equal(basis[0, 0], 0.0)
    np.testing.assert_array_equal(np.abs(basis[0, 1]), [1.0, 0.0])
