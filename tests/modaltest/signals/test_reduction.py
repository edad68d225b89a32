"""Fewer samples of long records: sines, whose values at any time are known."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.modaltest.signals.reduction import MAX_SAMPLES, reduce_signal, reduction_factor

STEP = 1.0 / 12_800.0
TIME = STEP * np.arange(60_001)


def test_records_of_usual_length_are_left_as_they_are() -> None:
    assert reduction_factor(MAX_SAMPLES, STEP, 100.0) == 1
    assert reduction_factor(MAX_SAMPLES + 1, STEP, 100.0) == 32
    assert reduction_factor(MAX_SAMPLES + 1, STEP, 3000.0) == 1
    assert reduce_signal(TIME, 1) is TIME


@pytest.mark.parametrize("frequency", [0.0, 20.0, 100.0])
@pytest.mark.parametrize("factor", [2, 7, 16])
def test_what_is_of_interest_is_unchanged(frequency: float, factor: int) -> None:
    highest = 1.0 / (STEP * 4.0 * factor)
    signal = np.cos(2.0 * np.pi * min(frequency, highest) * TIME + 0.4)
    found = reduce_signal(signal, factor)
    assert len(found) == len(TIME[::factor])
    inside = slice(50, -50)  # beyond the ends nothing is known
    # 100 dB of ripple
    np.testing.assert_allclose(found[inside], signal[::factor][inside], rtol=0.0, atol=2e-5)


def test_nothing_is_aliased_into_what_is_of_interest() -> None:
    """A sine that would appear at 30 Hz without a filter, and one just above the new Nyquist frequency."""
    for frequency in (800.0 - 30.0, 1600.0 - 30.0, 5000.0):
        found = reduce_signal(np.cos(2.0 * np.pi * frequency * TIME), 16)
        line = np.abs(np.fft.rfft(found * np.hanning(len(found)))) / (0.25 * len(found))
        f = np.fft.rfftfreq(len(found), 16 * STEP)
        assert line[f < 200.0].max() < 2e-5


def test_a_constant_stays_one() -> None:
    np.testing.assert_allclose(reduce_signal(np.full(5000, 9.81), 16), 9.81, rtol=1e-12)
