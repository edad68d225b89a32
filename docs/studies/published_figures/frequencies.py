"""Checks of what the paper writes about figures 7 and 8: condition number and frequencies."""

from __future__ import annotations

import numpy as np

from answers import Answer, Check, percent
from working_area import Area


def condition(area: Area) -> Answer:
    """Check that the mean condition number is between 3 and 4."""
    return 3.0 <= area.condition <= 4.0, f"{area.condition:.2f}"


def extreme(mode: int, which: str, low: float, high: float) -> Check:
    """Check where a frequency is extreme along the axis: between two places from 0 to 1."""

    def check(area: Area) -> Answer:
        line = area.line(area.f, mode)
        at = area.place(int(line.argmin() if which == "minimum" else line.argmax()))
        return low <= at <= high, f"{which} at {percent(at)}"

    return check


def falls_from_its_maximum(area: Area) -> Answer:
    """Check that mode 1 falls from its maximum towards both ends."""
    line = area.line(area.f, 1)
    top = int(line.argmax())
    wrong = max(np.diff(line[: top + 1]).min() * -1, np.diff(line[top:]).max(), 0.0)
    return bool(wrong <= 1e-9), f"{line[0]:.1f}, {line[top]:.1f}, {line[-1]:.1f} Hz"


def steeper(mode: int, half: str) -> Check:
    """Check that the mean slope of a frequency is larger in one half of the axis."""

    def check(area: Area) -> Answer:
        slope, middle = np.abs(np.diff(area.line(area.f, mode))), len(area.f) // 2
        lower, upper = float(slope[:middle].mean()), float(slope[middle:].mean())
        ratio = lower / upper if half == "lower" else upper / lower
        return ratio > 1.0, f"{ratio:.1f} times"

    return check


def changes(mode: int, sign: int) -> Check:
    """Check that a frequency rises (1) or falls (-1) from the lower to the upper end, on 99 % of the axis."""

    def check(area: Area) -> Answer:
        share = float((sign * np.diff(area.line(area.f, mode)) > 0).mean())
        return share > 0.99, f"on {percent(share)} of the axis"

    return check


def steep_near_the_ends(area: Area) -> Answer:
    """Check that mode 3 is at least twice as steep in the outer fifths of the axis as in the middle."""
    slope = np.abs(np.diff(area.line(area.f, 3)))
    fifth = len(slope) // 5
    ratio = float(
        np.concatenate([slope[:fifth], slope[-fifth:]]).mean() / slope[2 * fifth : -2 * fifth].mean()
    )
    return ratio > 2.0, f"{ratio:.0f} times the middle"


def symmetric_along(area: Area) -> Answer:
    """Check that mode 4 is the same within 5 % when the axis is reversed."""
    line = area.line(area.f, 4)
    difference = float(np.abs(line - line[::-1]).max() / line.mean())
    return difference < 0.05, f"within {100 * difference:.1f} %"


def symmetric(area: Area) -> Answer:
    """Check that all frequencies are the same on both sides of the axis."""
    difference = float(np.nanmax(np.abs(area.f - area.f[:, ::-1]) / area.f))
    return difference < 1e-9, "to 1e-9" if difference < 1e-9 else f"only to {difference:.0e}"
