"""Checks of what the paper writes about figures 9 to 20 and the tables: directions and sizes of the motion."""

from __future__ import annotations

import numpy as np

from answers import Answer, Check, percent
from working_area import Area


def symmetric_directions(area: Area) -> Answer:
    """Check that directions on both sides of the axis are mirror images."""
    mirrored = area.p[:, ::-1] * [1.0, -1.0, 1.0]
    same = np.abs((area.p * mirrored).sum(axis=-1))
    inside = np.isfinite(same)
    share = float((same[inside] > 1 - 1e-6).mean())
    return share > 0.99, f"{100 * share:.1f} % of the poses"


def driven_pulleys(area: Area) -> Answer:
    """Pulleys 1,1, 2,2 and 3,2 are driven; coordinates as in equation 32, lengths divided by the radius."""
    driven, free = [3, 7, 8], [6, 4, 5]
    size = np.abs(area.shape)[np.isfinite(area.f).all(axis=-1)][:, None]
    low = size[:, :, :3][..., driven].max(axis=-1) > size[:, :, :3][..., free].max(axis=-1)
    high = size[:, :, 3:][..., free].max(axis=-1) > size[:, :, 3:][..., driven].max(axis=-1)
    share = float(np.concatenate([low, high], axis=-1).mean())
    return share > 0.9, f"{percent(share)} of the modes"


def trucks(area: Area) -> Answer:
    """Compare trucks of shapes whose largest component is 1, as in the tables."""
    size = np.abs(area.shape)[np.isfinite(area.f).all(axis=-1)]
    size[..., :3] /= area.radius
    relative = (size / size.max(axis=-1, keepdims=True))[..., :3].max(axis=-1)
    ratio = float(np.median(relative[..., :3].max(axis=-1) / relative[..., 3:].max(axis=-1)))
    return ratio >= 10.0, f"{ratio:.0f} times, median"


def significant(area: Area) -> Answer:
    """Check that the platform moves at least twice as much in modes 1 to 3 as in any other."""
    every = np.sqrt(area.in_plane**2 + area.out_of_plane**2)
    ratio = float(np.nanmedian(every[..., :3].min(axis=-1) / every[..., 3:].max(axis=-1)))
    return ratio > 2.0, f"{ratio:.1f} times modes 4 to 6, median"


def negligible(area: Area) -> Answer:
    """Check that the platform moves less than a quarter as much in modes 4 to 6, at 90 % of the poses."""
    every = np.sqrt(area.in_plane**2 + area.out_of_plane**2)
    share = float(np.nanquantile(every[..., 3:].max(axis=-1) / every[..., :3].max(axis=-1), 0.9))
    return share < 0.25, f"below {percent(share)} of modes 1 to 3, at 90 % of the poses"


def compare(field: str, mode: int, larger: str) -> Check:
    """Check in which half of the area a component is larger."""

    def check(area: Area) -> Answer:
        lower, upper = area.halves(getattr(area, field), mode)
        holds = lower > upper if larger == "lower" else upper > lower
        return holds, f"lower {lower:.2f}, upper {upper:.2f}"

    return check


def sudden(field: str, mode: int) -> Check:
    """Check that a component changes by 40 % of its range within 5 % of the axis, near the middle."""

    def check(area: Area) -> Answer:
        change, at = area.jump(getattr(area, field), mode)
        return change > 0.4 and 0.3 <= at <= 0.7, f"{percent(change)} of the range at {percent(at)}"

    return check


def no_sudden(area: Area) -> Answer:
    """Check that mode 3 has no such change."""
    change, at = area.jump(area.in_plane, 3)
    return change <= 0.4, f"{percent(change)} of the range at {percent(at)}"


def uniform(area: Area) -> Answer:
    """Check that 80 % of the values are within half of the median."""
    values = area.out_of_plane[..., 2]
    spread = float((np.nanquantile(values, 0.9) - np.nanquantile(values, 0.1)) / np.nanmedian(values))
    return spread < 0.5, f"10 to 90 % quantiles within {percent(spread)} of the median"
