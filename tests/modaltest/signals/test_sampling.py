"""Times of samples: even steps, rounding to microseconds, and gaps."""

from __future__ import annotations

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from pkmodes.core.base.errors import MeasurementError
from pkmodes.modaltest.signals.sampling import even_pieces, stated_pieces


@pytest.mark.parametrize("rate", [3208.0, 3272.0, 12800.0, 25600.0])
@pytest.mark.parametrize("start", [0.0, 2712.154836])
def test_times_rounded_to_microseconds_are_even(rate: float, start: float) -> None:
    time = np.round(start + np.arange(20_000) / rate, 6)
    pieces, messages = even_pieces(time, "record")
    assert [piece.samples for piece in pieces] == [slice(0, 20_000)]
    assert pieces[0].step == pytest.approx(1.0 / rate, rel=1e-5)
    assert messages == ()


@given(
    at=st.integers(2, 97), missing=st.integers(1, 50), rate=st.floats(10.0, 20_000.0), rounded=st.booleans()
)
@settings(max_examples=100, deadline=None)
def test_a_gap_of_any_number_of_samples_splits_the_record(
    at: int, missing: int, rate: float, rounded: bool
) -> None:
    numbers = np.arange(100)
    numbers[at:] += missing
    time = numbers / rate
    if rounded:
        time = np.round(time, 6)
    pieces, messages = even_pieces(time, "record")
    assert [piece.samples for piece in pieces] == [slice(0, at), slice(at, 100)]
    assert len(messages) == 1
    assert messages[0].startswith("record: ")


def test_steps_within_one_per_cent_are_even_and_beyond_are_not() -> None:
    steps = np.full(100, 1e-3)
    steps[50] *= 1.0099
    assert len(even_pieces(np.cumsum(steps), "record")[0]) == 1
    steps[50] = 1.0112345e-3
    assert len(even_pieces(np.cumsum(steps), "record")[0]) == 2


def test_a_single_sample_between_two_gaps_is_left_out() -> None:
    time = np.array([0, 1, 2, 3, 4, 9, 14, *range(15, 60)]) * 1e-3
    pieces, messages = even_pieces(time, "record")
    assert [piece.samples for piece in pieces] == [slice(0, 5), slice(6, 52)]
    assert len(messages) == 2


@pytest.mark.parametrize("spread", [0.05, 0.5])
def test_uneven_sampling_is_refused(spread: float) -> None:
    time = np.cumsum(1e-3 * np.random.default_rng(0).uniform(1.0 - spread, 1.0 + spread, 100))
    with pytest.raises(MeasurementError, match="even sampling"):
        even_pieces(time, "record")
    with pytest.raises(MeasurementError, match="at least 2"):
        even_pieces(time[:1], "record")


def test_short_gaps_are_bridged_where_whole_samples_are_missing() -> None:
    """A sum of two sines, of which 3 samples in a hundred are lost; the longest gap is a tenth of a period."""
    step, number = 1e-3, np.arange(5000)
    gone = (100 * np.arange(1, 50)[:, None] + np.arange(3)).ravel()
    kept = np.delete(number, gone)

    def signal(n: np.ndarray) -> np.ndarray:
        return np.sin(2 * np.pi * 25.0 * step * n) + 0.3 * np.cos(2 * np.pi * 11.0 * step * n)

    pieces, messages = even_pieces(step * kept, "record", max_bridged=3.1e-3)
    (piece,) = pieces
    assert messages == (
        "record: 49 gaps of 3 ms, 2.9 % of the record, the first at 0.099 s: 147 samples are interpolated",
    )
    assert piece.step == pytest.approx(step)
    # A cubic spline errs by up to 5/384 (omega h)^4 of an amplitude: 0.002 for 25 Hz and steps of 4 ms.
    np.testing.assert_allclose(piece.fill_gaps(signal(kept)), signal(number), atol=2e-3)
    assert len(even_pieces(step * kept, "record")[0]) == 50
    uneven = step * kept + 0.4 * step * (kept > 1000)
    pieces, messages = even_pieces(uneven, "record", max_bridged=4.5e-3)
    assert len(pieces) == 2, "half a sample cannot be missing"
    with pytest.raises(MeasurementError, match="expected a whole record, found 624 samples missing"):
        even_pieces(step * number[number % 8 != 0], "record", max_bridged=4e-3)


def test_gaps_are_found_in_long_records_too() -> None:
    numbers = np.arange(2_100_000)
    numbers[1_000_000:] += 1
    numbers[2_000_001:] += 3
    pieces, messages = even_pieces(numbers / 3200.0, "record")
    assert [piece.samples.start for piece in pieces] == [0, 1_000_000, 2_000_001]
    assert len(messages) == 2


def test_times_with_six_digits_as_in_universal_files_are_even() -> None:
    time = np.array([float(f"{k / 1024:.5E}") for k in range(20_000)])  # to 19.5 s, the last ones in 0.1 ms
    pieces, messages = even_pieces(time, "record")
    assert [piece.samples for piece in pieces] == [slice(0, 20_000)]
    assert pieces[0].step == pytest.approx(1 / 1024, rel=1e-5)
    assert messages == ()
    with_gap = np.concatenate([time[:5000], time[5010:]])
    assert [piece.samples for piece in even_pieces(with_gap, "record")[0]] == [
        slice(0, 5000),
        slice(5000, 19_990),
    ]


def test_times_of_single_precision_are_even() -> None:
    time = (10.0 + np.arange(20_000) / 12800.0).astype(np.float32).astype(float)
    assert len(even_pieces(time, "record")[0]) == 1


def test_one_step_longer_by_a_tenth_is_a_gap_although_times_are_round() -> None:
    time = np.arange(200) * 1e-3
    time[100:] += 1e-4
    assert [piece.samples for piece in even_pieces(time, "record")[0]] == [slice(0, 100), slice(100, 200)]


@pytest.mark.parametrize(("burst", "lost"), [(1, 0), (1, 30), (32, 0), (32, 1500), (512, 0), (512, 1500)])
@pytest.mark.parametrize("clock", [0.98, 1.0, 1.02])
def test_times_of_arrival_show_samples_that_are_missing(burst: int, clock: float, lost: int) -> None:
    """Samples arrive in bursts, with delays, and their clock is not as stated: only what is lost stays late."""
    rng, count, at = np.random.default_rng(4), 20_000, 12_000
    number = np.arange(count) + np.where(np.arange(count) < at, 0, lost)
    sent = np.repeat(number[burst - 1 :: burst], burst)  # all with the last of their burst
    time = sent / (1000.0 * clock) + 1e-6 * np.arange(len(sent))
    time[7000:7040] = time[7000] + 0.04 + 1e-6 * np.arange(40)  # a delay that is made up for
    time = np.maximum.accumulate(time + 1e-9 * rng.uniform(size=len(time)))
    pieces, said = stated_pieces(time, 1000.0, "record")
    assert len(pieces) == len(said) + 1 == (2 if lost else 1)
    if lost:
        assert abs(pieces[1].samples.start - at) <= burst
    assert all(piece.step == 1e-3 for piece in pieces)


def test_interpolating_once_more_shows_what_interpolation_misses() -> None:
    """Noise and a vibration above the band: the spline misses as much of other samples as of those lost."""
    rng = np.random.default_rng(8)
    n, step = 20_000, 1e-3
    time = step * np.arange(n)
    lost = rng.choice(np.arange(20, n - 20, 12), 900, replace=False)
    kept = np.delete(np.arange(n), lost)
    signal = np.sin(2.0 * np.pi * 150.0 * time) + 0.1 * rng.normal(size=n)
    (piece,), _ = even_pieces(time[kept], "here", 1.5 * step)
    filled = piece.fill_gaps(signal[kept])
    again = piece.reinterpolated(filled)
    changed = np.flatnonzero(again != filled)
    assert 0.98 * len(lost) < len(changed) <= len(lost)
    assert not np.isin(changed, lost).any()
    truly = np.sqrt(np.mean((filled - signal)[lost] ** 2))
    assert np.sqrt(np.mean((again - filled)[changed] ** 2)) == pytest.approx(truly, rel=0.1)
