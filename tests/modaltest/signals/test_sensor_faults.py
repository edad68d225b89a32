"""What a signal shows of its sensor: cut off at its range, or stopped; and neither where its numbers are only few."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from scipy import signal

from pkmodes.modaltest.signals.sensor_faults import find_clipping, find_stop

COUNT, RATE = 20_000, 1344.0
TIME = np.arange(COUNT) / RATE


def vibrations(rng: np.random.Generator) -> Iterator[tuple[str, np.ndarray]]:
    """Yield signals whose extreme values are no limit, none of them at rest for long."""
    noise = rng.normal(size=COUNT)
    modes = sum(
        signal.lfilter([1.0], [1.0, -2.0 * r * np.cos(w), r * r], noise)
        for w, r in ((2.0 * np.pi * f / RATE, 1.0 - f / RATE * 0.06) for f in rng.uniform(5.0, 300.0, 3))
    )
    yield "ambient", modes + 0.05 * rng.normal(size=COUNT)
    yield "noise", rng.normal(size=COUNT)
    yield "heavy tails", rng.standard_t(3, size=COUNT)
    yield "motor", np.sin(2.0 * np.pi * rng.uniform(3.0, 100.0) * TIME)
    yield "motor in step with the sampling", np.sin(2.0 * np.pi * 25.0 * np.arange(COUNT) / 1000.0)
    yield "beat", np.sin(2.0 * np.pi * 21.0 * TIME) + np.sin(2.0 * np.pi * 21.3 * TIME)
    yield "sweep", signal.chirp(TIME, 5.0, TIME[-1], 120.0) * (1.0 + 0.5 * np.sin(TIME))


def digits(values: np.ndarray, bits: int, part: float) -> np.ndarray:
    """Return the numbers of a sensor with so many bits, of whose range a part is used, in m/s^2."""
    return 0.0039 * 9.80665 * np.round(values / np.abs(values).max() * part * 2.0 ** (bits - 1))


CASES = [(bits, part) for bits in (8, 10, 12, 16) for part in (0.9, 0.3, 0.05)]


def test_extreme_values_that_are_no_limit_are_no_overload() -> None:
    rng = np.random.default_rng(5)
    for _ in range(4):
        for name, values in vibrations(rng):
            assert find_clipping(values) == ((), 0.0), name
            for bits, part in CASES:
                assert find_clipping(digits(values, bits, part)) == ((), 0.0), (name, bits, part)


@pytest.mark.parametrize("share", [0.05, 0.005])
def test_a_range_that_was_exceeded_is_found_with_its_share(share: float) -> None:
    rng = np.random.default_rng(6)
    for name, values in list(vibrations(rng))[:3]:
        limit = float(np.quantile(np.abs(values), 1.0 - share))
        for cut in (np.clip(values, -limit, limit), digits(np.clip(values, -limit, limit), 12, 0.98)):
            levels, found = find_clipping(cut)
            assert levels == (cut.max(), cut.min()), name
            assert found == pytest.approx(share, rel=0.2)
        levels, found = find_clipping(np.minimum(values, limit))
        assert levels == (limit,)
        assert found == pytest.approx(np.mean(values >= limit), rel=0.01)


def test_a_signal_that_rests_at_its_least_value_is_not_cut_off() -> None:
    force = np.where(np.arange(COUNT) % 5000 < 40, np.sin(np.pi * (np.arange(COUNT) % 5000) / 40.0), 0.0)
    assert find_clipping(force) == ((), 0.0)


def test_a_sensor_that_stops_is_told_from_one_with_few_digits() -> None:
    rng = np.random.default_rng(7)
    for name, values in vibrations(rng):
        for used in (values, digits(values, 8, 0.9)):
            assert find_stop(used) is None, name
            dead = used.copy()
            dead[12_000:15_000] = dead[12_000]
            found = find_stop(dead)
            assert found is not None, name
            assert abs(found.start - 12_000) + abs(found.stop - 15_000) <= 2, (
                name
            )  # its neighbours may be as large
    assert find_stop(np.round(0.2 * rng.normal(size=COUNT))) is None
    assert find_stop(np.full(COUNT, 9.81)) == slice(0, COUNT)


def test_a_long_signal_is_looked_at_in_parts(monkeypatch: pytest.MonkeyPatch) -> None:
    rng = np.random.default_rng(8)
    cut = np.clip(rng.normal(size=COUNT), -2.0, np.inf)
    cut[3_000:9_000] = 0.5
    whole = find_clipping(cut)
    monkeypatch.setattr("pkmodes.modaltest.signals.sensor_faults.PART_SIZE", 1000)
    assert find_clipping(cut) == whole
    assert whole[0] == (-2.0,)
    assert find_stop(cut) == slice(3_000, 9_000)
    assert find_stop(rng.normal(size=COUNT)) is None
