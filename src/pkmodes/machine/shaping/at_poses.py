"""Shapers that follow the pose: designed for the modes of the machine in use at each pose."""

from __future__ import annotations

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.machine.shaping.fixed import FREQUENCY_ACCURACY, RANGE_FACTOR
from pkmodes.machine.shaping.kinds import factors
from pkmodes.machine.shaping.residual_vibration import residual, residual_of_even
from pkmodes.machine.shaping.ringing import Ringing, evaluate_ringing
from pkmodes.machine.shaping.shapers import Shaper, shaper

Array = NDArray[np.float64]
#: Step in log frequency of the frequencies tried at each pose: zv leaves 3 % of a mode half a step away.
LOG_FREQUENCY_STEP = 0.04
#: Number of poses evaluated at once.
BATCH_SIZE = 2000
#: Fraction of an interval that a golden-section step keeps.
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)


def shaper_at(
    model: Model,
    kind: str,
    poses: ArrayLike,
    *,
    modes: int | None = None,
    continuous: bool = True,
    drives: str | None = None,
) -> Shaper:
    """Design shapers for the modes of the machine in use at poses (docs/how-to/shapers.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    kind : str
        One of `pkmodes.shaping.KINDS`, or a product such as "zv*zv*zv", factor k of which is for mode k.
    poses : array_like, shape (d,) or (..., d)
        Poses in SI units.
    modes : int, optional
        For a single kind: how many of the lowest modes count; by default three.
    continuous : bool
        For a single kind: the mean frequency of these modes, weighted by the squared ``vibration_amplitudes``,
        which has no jump along a path, as a move needs; or, if False, the frequency that leaves least at each
        pose, as in the comparison of `shapers`.
    drives : {"free", "held"}, optional
        As for `shapers`: by default as the robot file has the motors.

    Returns
    -------
    Shaper
        ``amplitudes`` and ``delays`` with the leading axes of the poses, then the impulses.

    Raises
    ------
    PkmodesError
        If the kind is unknown, or has more factors than the machine has modes; or a mode does not oscillate; or if
        motors that nothing holds are to be free.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022-identified.toml")
    >>> (1e3 * model.shaper("zv*zv*zv", [0.6, 0.0, -0.244]).durations).round(1)  # ms
    np.float64(47.8)
    """
    count = len(factors(kind))
    checked = model.checked(poses, "raise")
    ringing = evaluate_ringing(
        model, checked.points, count if modes is None and count > 1 else modes, drives=drives
    )
    if ringing.left_out:
        problem = f"at {ringing.left_out} of the poses a mode does not oscillate"
        raise PkmodesError(
            problem, "poses", f"pkmodes modes --drives {ringing.drives} shows its frequency and damping ratio"
        )
    designs = own_shapers(kind, ringing, continuous=continuous)
    return Shaper(*(part.reshape(*checked.batch, -1) for part in designs))


def own_shapers(kind: str, ringing: Ringing, *, continuous: bool = False) -> Shaper:
    """Return the shaper of each pose, (N, n).

    Factor k of a product is for mode k.  A shaper without factors has the mean damping ratio of all modes that count,
    and the frequency that leaves least of them, both weighted by the squared amplitudes.  That frequency may jump
    between neighbouring poses.

    - continuous: use the mean frequency instead, which has no jump: a command that changes from one shaper to another
      one is smooth only if they differ little

    Raises PkmodesError if a product has more factors than the machine has modes that count.
    """
    count = check_factors(kind, ringing, "kind")
    if count > 1:
        return shaper(kind, ringing.frequencies[:, :count], ringing.damping_ratios[:, :count])
    share = ringing.weights**2
    zeta = np.average(ringing.damping_ratios, axis=-1, weights=share)
    if continuous:
        return shaper(kind, np.average(ringing.frequencies, axis=-1, weights=share), zeta)
    batches = [slice(start, start + BATCH_SIZE) for start in range(0, len(zeta), BATCH_SIZE)]
    frequencies = [
        _best_frequencies(
            kind,
            zeta[batch],
            ringing.frequencies[batch],
            ringing.damping_ratios[batch],
            ringing.weights[batch],
        )
        for batch in batches
    ]
    return shaper(kind, np.concatenate(frequencies), zeta)


def check_factors(kind: str, ringing: Ringing, where: str) -> int:
    """Return the number of factors of a kind, each of which is for a mode that counts.

    Raises PkmodesError if it has more factors than modes count.
    """
    count = len(factors(kind))
    if count > ringing.modes:
        problem = f"{kind} is for {count} modes, but only {ringing.modes} count"
        raise PkmodesError(problem, where, "leave out a factor, or count more modes")
    return count


def _best_frequencies(kind: str, zeta: Array, f: Array, ratios: Array, weights: Array) -> Array:
    """Return the frequency of the design that leaves least at each pose, (N,) [Hz].

    The best of frequencies apart by less than what a shaper of two impulses notices, and between its neighbours by
    golden sections.
    """
    unit_shaper = shaper(kind, np.ones_like(zeta), zeta)
    amplitudes, step = unit_shaper.amplitudes[:, None, None], unit_shaper.delays[:, 1, None]

    def squared_vibration(logs: Array) -> Array:
        """Return the squared vibration for c designs at each pose, (N, c)."""
        steps = (step * np.exp(-logs))[..., None]
        return np.asarray(
            ((weights[:, None] * residual_of_even(amplitudes, steps, f[:, None], ratios[:, None])) ** 2).sum(
                axis=-1
            )
        )

    low, high = np.log(f.min(axis=1) / RANGE_FACTOR), np.log(f.max(axis=1) * RANGE_FACTOR)
    count = 2 + int(np.ceil((high - low).max() / LOG_FREQUENCY_STEP))
    trial_logs = low[:, None] + (high - low)[:, None] * np.linspace(0.0, 1.0, count)
    best = np.argmin(squared_vibration(trial_logs), axis=1)
    middle = np.take_along_axis(trial_logs, best[:, None], 1)
    width = ((high - low) / (count - 1))[:, None]
    a, b = middle - width, middle + width
    for _ in range(int(np.ceil(np.log(2.0 * LOG_FREQUENCY_STEP / FREQUENCY_ACCURACY) / -np.log(GOLDEN)))):
        inner_logs = np.hstack([b - GOLDEN * (b - a), a + GOLDEN * (b - a)])
        values = squared_vibration(inner_logs)
        is_first_lower = values[:, :1] <= values[:, 1:]
        a, b = np.where(is_first_lower, a, inner_logs[:, :1]), np.where(is_first_lower, inner_logs[:, 1:], b)
    finalists = np.hstack([middle, 0.5 * (a + b)])
    best_logs = np.take_along_axis(finalists, np.argmin(squared_vibration(finalists), axis=1)[:, None], 1)
    return np.asarray(np.exp(best_logs[:, 0]))


def shapers_following_pose(kind: str, ringing: Ringing, fixed: Shaper) -> Shaper:
    """Return the best shaper of each pose, (N, n): that for its own modes, or a fixed one where this leaves less."""
    followed = own_shapers(kind, ringing)
    left_by_own, left_by_fixed = (
        ringing.shaped(residual(design, ringing.frequencies, ringing.damping_ratios))
        for design in (followed, fixed)
    )
    is_fixed_better = (left_by_own > left_by_fixed)[:, None]
    return Shaper(
        *(
            np.where(is_fixed_better, fixed_part, own_part)
            for own_part, fixed_part in zip(followed, fixed, strict=True)
        )
    )
