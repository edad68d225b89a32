"""The largest acceleration that Klipper would suggest for a shaper, against its manual and a closed form."""

from __future__ import annotations

import numpy as np
import pytest

from pkmodes.machine.shaping import Shaper, shaper
from pkmodes.machine.shaping.choice import choose
from pkmodes.machine.shaping.results import Amplitude, Candidate
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.pages.report.shaper import acceleration_cell

#: Frequency [Hz] and suggested max_accel [mm/s^2] of each shaper in docs/Measuring_Resonances.md of Klipper, made
#: before its ei and humps changed, with the damping ratio that it takes by default.
MANUAL = {
    "zv": (34.4, 4500),
    "mzv": (34.6, 3500),
    "ei": (41.4, 3200),
    "2hump_ei": (51.8, 3000),
    "3hump_ei": (61.8, 2800),
}
DEFAULT_RATIO = 0.1


def candidate(kind: str, impulses: Shaper, *, follows: bool = False) -> Candidate:
    nothing = Amplitude(0.0, 0.0, np.zeros(2))
    return Candidate(kind, follows, (1.0,), 0.0, impulses, nothing, np.zeros(1), nothing)


@pytest.mark.parametrize("kind", MANUAL)
def test_it_is_that_of_klippers_manual(kind: str) -> None:
    frequency, suggested = MANUAL[kind]
    found = candidate(kind, shaper(kind, frequency, DEFAULT_RATIO)).max_acceleration
    assert found is not None
    assert round(1e3 * found, -2) == pytest.approx(suggested, abs=100)


@pytest.mark.parametrize("frequency", [20.0, 60.0, 150.0])
def test_zv_without_damping_has_a_closed_form(frequency: float) -> None:
    """Impulses of one half at 0 and T: smoothing a T^2/8 where a move turns back, and at a corner that after T/2."""
    T = 0.5 / frequency
    turning = 8.0 * 0.12e-3 / T**2
    corner = (0.12e-3 / np.sqrt(2.0) - 5e-3 * 0.25 * T) / (T**2 / 16.0)
    found = candidate("zv", shaper("zv", frequency, 0.0)).max_acceleration
    assert found == pytest.approx(min(turning, corner), rel=1e-12)


def test_a_shaper_that_smooths_too_much_at_speed_alone_has_none() -> None:
    slow = candidate("zv", Shaper(np.array([0.5, 0.5]), np.array([0.0, 0.2])))
    assert slow.max_acceleration == 0.0
    assert acceleration_cell(slow).text == "none: corners are smoothed by more at any"  # not "0 mm/s^2"
    assert acceleration_cell(slow, unit=False).text == "none"
    assert candidate("zv", shaper("zv", 40.0, 0.0), follows=True).max_acceleration is None


def test_at_each_pose_the_largest_share_is_never_below_the_root_mean_square() -> None:
    """A pose that hardly rings keeps nearly everything: relative to the largest anywhere it is next to nothing."""
    f = np.array([[20.0], [21.0], [40.0]])
    at = Ringing(np.zeros((3, 1)), f, np.zeros((3, 1)), np.array([[1.0], [0.9], [0.01]]), None, 0)
    best = choose(at, ["zv"], follow=False).best
    # Two impulses of one half, T apart, leave |cos(pi f T)|.
    expected = np.abs(np.cos(np.pi * f[:, 0] * best.shaper.delays[1]))
    assert best.left_at_pose.worst == pytest.approx(expected.max(), rel=1e-9)
    assert best.left_at_pose.rms == pytest.approx(np.sqrt(np.mean(expected**2)), rel=1e-9)
    assert best.left_at_pose.worst > 0.9
    assert best.left.worst < 0.1
