"""A mode in words: its frequency, the springs that hold most of its energy, and what moves; as in panel.js."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np

from pkmodes.core.support.ordering import joined
from pkmodes.pages.view.scene import Scene

#: Shares of the strain energy that differ by less count as equal, as in panel.js.
EQUAL_SHARE_TOLERANCE = 0.0005
#: Relative difference of frequencies that are one, as in panel.js: those of the page have four decimals.
SAME_FREQUENCY = 1e-5
#: What the frequency of a motion is that strains no spring, and of a mode that diverges instead of vibrating.
RIGID_FREQUENCY, UNSTABLE = "0 Hz", "unstable"
#: Maximum number of decimals of a frequency beside its standard deviation, and without one.
MAX_DECIMALS, DECIMALS = 4, 2


def signed_text(value: float, decimals: int) -> str:
    """Return a number with a minus sign as in print, and without a sign of a rounded zero."""
    return f"{round(value, decimals) + 0.0:.{decimals}f}".replace("-", "\u2212")


def frequency_text(scene: Scene, pose: int, mode: int, *, with_sigma: bool = False) -> str:
    """Return a frequency with its unit, rounded by its standard deviation where it has one.

    A rigid-body motion strains no spring: its frequency is 0, but for gravity.

    - with_sigma: whether the standard deviation stands beside it
    """
    if not np.isfinite(scene.shares[pose, mode]).any():
        return RIGID_FREQUENCY
    value = float(scene.frequencies[pose, mode])
    if value < 0.0:
        return UNSTABLE
    sigma = math.nan if scene.sigmas is None else float(scene.sigmas[pose, mode])
    if not sigma > 0.0:
        return f"{value:.{DECIMALS}f} Hz"
    decimals = max(0, min(MAX_DECIMALS, 1 - math.floor(math.log10(sigma))))
    sigma_text = f" \u00b1 {sigma:.{decimals}f}" if with_sigma else ""
    return f"{value:.{decimals}f}{sigma_text} Hz"


def sigma_note(scene: Scene) -> str:
    """Return where the standard deviations of the frequencies are from; empty without any."""
    return "" if scene.sigmas is None else "; \u00b1: from the standard deviations in the robot file"


def energy_text(scene: Scene, pose: int, mode: int) -> str:
    """Return the springs with the largest share of the strain energy: by symmetry there may be several."""
    shares = scene.shares[pose, mode]
    if not np.isfinite(shares).any():
        return "no spring is strained"
    largest = float(np.nanmax(shares))
    *preceding, last = (
        spring.name
        for spring, share in zip(scene.springs, shares, strict=True)
        if share > largest - EQUAL_SHARE_TOLERANCE
    )
    spring_names = f"each of {', '.join(preceding)} and {last}" if preceding else last
    text = f"{100 * largest:.0f} % of the strain energy in {spring_names}"
    return text + coincidence_text(scene.frequencies[pose].tolist(), scene.rigid_modes, mode)


def coincidence_text(frequencies: Sequence[float], rigid: int, mode: int) -> str:
    """Return which vibration modes have the frequency of one: their shapes are then only examples; empty for none."""
    tolerance = SAME_FREQUENCY * abs(frequencies[mode])
    partners = [
        str(k - rigid + 1)
        for k in range(rigid, len(frequencies))
        if k != mode and abs(frequencies[k] - frequencies[mode]) <= tolerance
    ]
    if not partners:
        return ""
    modes = f"mode{'s' if len(partners) > 1 else ''} {joined(partners)}"
    return (
        f"; {modes} {'have' if len(partners) > 1 else 'has'} the same frequency: any mixture is a mode, too"
    )


def motion_text(bodies: Sequence[str], components: Sequence[str], direction: Sequence[float]) -> str:
    """Return what moves, and where to: "tool head moves along x 0.60, y 0.80".

    What rounds to 0 is left out; a single component needs no number.

    - bodies: what moves along or about each component
    - components: "x", or "about x"
    - direction: unit vector
    """
    moving = [
        k for k, share in enumerate(direction) if signed_text(share, DECIMALS) != signed_text(0.0, DECIMALS)
    ]
    if not moving:
        names = list(dict.fromkeys(bodies))
        return f"{joined(names)} {'do' if len(names) > 1 else 'does'} not move"
    clauses = []
    for body in dict.fromkeys(bodies[k] for k in moving):
        verbs = []
        for verb, is_turn in (("moves along", False), ("turns about", True)):
            shares = [
                components[k].removeprefix("about ")
                + (f" {signed_text(direction[k], DECIMALS)}" if len(moving) > 1 else "")
                for k in moving
                if bodies[k] == body and components[k].startswith("about") == is_turn
            ]
            verbs += [f"{verb} {', '.join(shares)}"] if shares else []
        clauses.append(f"{body} {' and '.join(verbs)}")
    return "; ".join(clauses)
