"""The choice of a shaper over the workspace: the best fixed one of each kind, and those that follow the pose."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import Constraint, check_argument, is_number, one_of
from pkmodes.core.base.attached import Attached
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.model import Model
from pkmodes.shaping.at_poses import check_factors, following
from pkmodes.shaping.firmware import NAMES
from pkmodes.shaping.firmware import firmware as lines
from pkmodes.shaping.fixed import best_fixed
from pkmodes.shaping.kinds import KINDS, PRODUCT, plain
from pkmodes.shaping.residual_vibration import residual
from pkmodes.shaping.ringing import Ringing, ringing
from pkmodes.shaping.shapers import Shaper
from pkmodes.support.progress import say

Array = NDArray[np.float64]
#: A fixed shaper is good enough if it leaves this share of the vibration at the worst pose.
LEFT = 0.1
#: Time between two commands of the controller [s].
TICK = 1e-3
#: A shaper needs as many ticks at least: its impulses would fall together.
TICKS = 2
SHARE = Constraint("a share above 0 and at most 1", lambda value: is_number(value) and 0.0 < value <= 1.0)
TIME = Constraint("a positive time in s", lambda value: is_number(value) and 0.0 < value < np.inf)


@dataclass(frozen=True)
class Amplitude:
    """Vibration over all poses.

    Attributes
    ----------
    rms, worst : float
        Root mean square and largest value.
    pose : ndarray, shape (d,)
        Where it is largest.
    rms_uncertain : float or None
        The root mean square with frequencies spread by the standard deviations of the robot file, where it has any.
    """

    rms: float
    worst: float
    pose: Array
    rms_uncertain: float | None = None


@dataclass(frozen=True)
class Candidate:
    """A shaper for all poses, or one for each.

    Attributes
    ----------
    kind : str
    follows_pose : bool
    frequencies : tuple of float
        Of the design [Hz], one for each factor; empty if it follows the pose.
    damping_ratio : float
        Of the design; NaN if it follows the pose.
    shaper : Shaper
        Impulses (n,), or (N, n) if it follows the pose.
    left : Amplitude
        Relative to no shaper: the root mean square and the largest value over those without a shaper.
    left_at : ndarray, shape (N,)
        The same at each pose, relative to no shaper there.
    """

    kind: str
    follows_pose: bool
    frequencies: tuple[float, ...]
    damping_ratio: float
    shaper: Shaper
    left: Amplitude
    left_at: Array

    @property
    def duration(self) -> float:
        """How much longer a command takes [s], at most."""
        return float(np.max(self.shaper.durations))

    @property
    def rounding(self) -> float:
        """Distance of a path of constant acceleration from its command, for 1 m/s^2 [s^2]; fixed shapers only.

        The command is delayed by the mean of the impulses, and half their variance remains.
        """
        amplitudes, delays = self.shaper
        return float(
            0.5 * np.average((delays - np.average(delays, weights=amplitudes)) ** 2, weights=amplitudes)
        )


@dataclass(frozen=True)
class Choice:
    """Shapers for a machine, and the one that is recommended.

    Attributes
    ----------
    ringing : Ringing
        Of the machine.
    unshaped : Amplitude
        In s^2: m of platform vibration for a step of 1 m/s^2.
    candidates : tuple of Candidate
        The fixed ones, then those that follow the pose, if modes are known between poses.
    recommended : int
        Index of a fixed one.
    notes : tuple of str
    left : float
        Share of the vibration at the worst pose that is good enough.
    length : float or None
        Longest duration allowed [s].
    firmware : str or None
        That has the recommended one; None for any.
    """

    ringing: Ringing
    unshaped: Amplitude
    candidates: tuple[Candidate, ...]
    recommended: int
    notes: tuple[str, ...]
    left: float = LEFT
    length: float | None = None
    firmware: str | None = None

    _repr_html_ = Attached("pkmodes.report.notebook:of_shapers")


def default_kinds(modes: int) -> tuple[str, ...]:
    """Return the kinds that are compared by default: all of one mode, and products of zv for several."""
    return (*KINDS, *(PRODUCT.join(["zv"] * count) for count in range(2, modes + 1)))


def shapers_over(
    model: Model,
    poses: ArrayLike,
    kinds: Sequence[str] | None = None,
    *,
    modes: int | None = None,
    left: float = LEFT,
    length: float | None = None,
    tick: float = TICK,
    firmware: str | None = None,
) -> Choice:
    """Compare shapers over poses: the best fixed one of each kind, and those that follow the pose.

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (..., d)
        Such as a grid over the workspace; those that cannot be evaluated, or at which a mode does not oscillate,
        are left out.
    kinds : str or sequence of str, optional
        By default all for one mode, and products of zv up to the number of modes.
    modes : int, optional
        The lowest modes that count; by default three.
    left : float
        Share of the vibration that a fixed shaper may leave at the worst pose to be good enough.
    length : float, optional
        Longest duration of a shaper [s].
    tick : float
        Time between two commands of the controller [s]; shapers shorter than two ticks are left out.
    firmware : {"klipper", "marlin", "reprapfirmware"}, optional
        Recommend only a shaper that it has.

    Returns
    -------
    Choice
        ``candidates``, and ``recommended``: the index of the shortest fixed shaper that is good enough, else of
        the one that leaves least at its worst pose.  At no pose those that follow it leave more than fixed ones.

    Raises
    ------
    PkmodesError
        If an argument is invalid, no fixed shaper is long or short enough, or the firmware has none of them.
    PoseError
        If no pose can be evaluated.
    """
    at = ringing(model, poses, modes)
    return choose(at, kinds, left=left, length=length, tick=tick, firmware=firmware)


def choose(
    at: Ringing,
    kinds: Iterable[str] | None = None,
    *,
    left: float = LEFT,
    length: float | None = None,
    tick: float = TICK,
    firmware: str | None = None,
) -> Choice:
    """Compare shapers: see `pkmodes.Model.shapers`."""
    check_argument(left, SHARE, "left", "for example: 0.1")
    check_argument(tick, TIME, "tick", "for example: 0.001")
    if length is not None:
        check_argument(length, TIME, "length", "for example: 0.05")
    if firmware is not None:
        check_argument(firmware, one_of(NAMES), "firmware", "for example: klipper")
    if isinstance(kinds, str):
        kinds = (kinds,)
    names = default_kinds(at.modes) if kinds is None else tuple(dict.fromkeys(map(plain, kinds)))
    for name in names:
        check_factors(name, at, "kinds")
    if not names:
        raise PkmodesError(
            "expected at least one kind of shaper, found none", "kinds", f"known: {', '.join(KINDS)}"
        )
    both: list[Candidate] = []
    every = (*names, *names) if at.known_between else names
    for number, name in enumerate(every):
        say(f"shaper {number + 1} of {len(every)}: {name}")
        if number < len(names):
            frequencies, fixed = best_fixed(name, at)
            both.append(_candidate(name, False, frequencies, at.mean_ratio, fixed, at))
        else:
            followed = following(name, at, both[number - len(names)].shaper)
            both.append(_candidate(name, True, (), np.nan, followed, at))
    short = [one for one in both if np.min(one.shaper.durations) < TICKS * tick]
    candidates = tuple(one for one in both if all(one is not each for each in short))
    if not any(not one.follows_pose for one in candidates):
        longest = max(one.duration for one in both)
        what = f"the shapers last {1e3 * longest:.3g} ms at most, less than two ticks of {1e3 * tick:.3g} ms"
        raise PkmodesError(what, "tick", "shorten the tick, or choose a longer kind")
    recommended, notes = _recommended(candidates, left, length, firmware, at.where_most)
    if short:
        kept = {one.kind for one in candidates}
        listed = dict.fromkeys(f"{one.kind}{_variant(one) if one.kind in kept else ''}" for one in short)
        notes.append(f"{', '.join(listed)}: left out, shorter than two ticks of {1e3 * tick:.3g} ms")
    unshaped = _amplitude(at, at.unshaped)
    return Choice(at, unshaped, candidates, recommended, (*at.notes(), *notes), left, length, firmware)


def _per_cent(share: float) -> str:
    return f"{100 * share:.2g} %" if share >= 1e-6 else "nothing"


def _variant(one: Candidate) -> str:
    return " of the pose" if one.follows_pose else ", fixed"


def lines_of(one: Candidate) -> dict[str, str | None]:
    """Return the lines of a fixed shaper by firmware; None where it has no such shaper."""
    return lines(one.kind, one.frequencies, one.damping_ratio, one.shaper)


def recommended_of(
    candidates: Sequence[Candidate], left: float, length: float | None, firmware: str | None
) -> tuple[int | None, bool]:
    """Return the index of the shortest fixed shaper that is good enough, or else of the best one.

    Parameters
    ----------
    left : float
        Share at the worst pose that is good enough.
    length : float or None
        Longest duration allowed [s].
    firmware : str or None
        That has it; None for any.

    Returns
    -------
    index : int or None
        None if none lasts at most `length`, or the firmware has none.
    good : bool
        Whether it is good enough.
    """
    allowed = [
        i
        for i, one in enumerate(candidates)
        if not one.follows_pose
        and (length is None or one.duration <= length)
        and (firmware is None or lines_of(one)[firmware] is not None)
    ]
    good = [i for i in allowed if candidates[i].left.worst <= left]
    if good:
        return min(good, key=lambda i: candidates[i].duration), True
    return min(allowed, key=lambda i: candidates[i].left.worst, default=None), False


def _recommended(
    candidates: tuple[Candidate, ...],
    left: float,
    length: float | None,
    firmware: str | None,
    where: str,
) -> tuple[int, list[str]]:
    """Return the index of the recommended shaper, and what is to be said of it."""
    best, good = recommended_of(candidates, left, length, firmware)
    notes: list[str] = []
    if best is None:
        fixed = [one for one in candidates if not one.follows_pose]
        has = [one for one in fixed if firmware is None or lines_of(one)[firmware] is not None]
        if not has:
            what = f"{NAMES[firmware or '']} has none of the shapers compared: {', '.join(one.kind for one in fixed)}"
            raise PkmodesError(what, "firmware", "compare others, such as zv, mzv and ei")
        of = "" if firmware is None else f" that {NAMES[firmware]} has"
        what = f"no fixed shaper{of} lasts at most {1e3 * (length or 0.0):.4g} ms"
        shortest = min(one.duration for one in has)
        raise PkmodesError(what, "length", f"the shortest one lasts {1e3 * shortest:.4g} ms")
    if good:
        return best, notes
    of = "" if firmware is None else f" of {NAMES[firmware]}"
    notes.append(
        f"no fixed shaper{of} leaves at most {100 * left:.3g} % {where}; the best one is recommended"
    )
    following = [one for one in candidates if one.follows_pose and (length is None or one.duration <= length)]
    if following:
        one = min(following, key=lambda each: (round(each.left.worst, 6), each.duration))
        uncertain = one.left.rms_uncertain
        spread = (
            "" if uncertain is None else f", {100 * uncertain:.2g} % on average with uncertain frequencies"
        )
        notes.append(
            f"following the pose, {one.kind} leaves {_per_cent(one.left.worst)} at the worst pose{spread}, and more "
            "while the machine moves (pkmodes.Model.simulate)"
        )
    return best, notes


def _candidate(
    kind: str, follows: bool, frequencies: tuple[float, ...], zeta: float, one: Shaper, at: Ringing
) -> Candidate:
    left = residual(one, at.frequencies, at.damping_ratios)
    shaped, before = at.shaped(left), np.sqrt(np.mean(at.unshaped**2))
    amplitude = _amplitude(at, shaped)
    squares = [
        share * np.mean(at.shaped(residual(one, f, at.damping_ratios)) ** 2) for share, f in at.at_spread()
    ]
    return Candidate(
        kind,
        follows,
        frequencies,
        zeta,
        one,
        Amplitude(
            float(amplitude.rms / before),
            float(amplitude.worst / at.unshaped.max()),
            amplitude.pose,
            float(np.sqrt(sum(squares)) / before) if squares else None,
        ),
        shaped / at.unshaped,
    )


def _amplitude(at: Ringing, values: Array) -> Amplitude:
    where = int(np.argmax(values))
    return Amplitude(float(np.sqrt(np.mean(values**2))), float(values[where]), at.poses[where])
