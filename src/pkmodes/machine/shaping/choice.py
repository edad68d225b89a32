"""The choice of a shaper over operating points: the best fixed one of each kind, and those that follow the pose."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base import numbers
from pkmodes.core.base.arguments import Constraint, check_argument, is_number, one_of
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.support.ordering import joined
from pkmodes.core.support.progress import report_progress
from pkmodes.machine.shaping.at_poses import check_factors, shapers_following_pose
from pkmodes.machine.shaping.firmware import (
    FIRMWARE_TITLES,
    MIN_WRITTEN_RATIO,
    VERSIONS,
    configuration_lines,
    lines_by_firmware,
    ratio_in_use,
    version_name,
)
from pkmodes.machine.shaping.firmware_impulses import has_own_formulas
from pkmodes.machine.shaping.fixed import best_fixed
from pkmodes.machine.shaping.kinds import KINDS, PRODUCT, factors, plain
from pkmodes.machine.shaping.residual_vibration import residual
from pkmodes.machine.shaping.results import GOOD_ENOUGH_SHARE, Amplitude, Candidate, Choice, recommended_of
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.machine.shaping.shapers import Shaper

Array = NDArray[np.float64]
#: How the note begins that no fixed shaper is good enough.
NONE_GOOD_ENOUGH = "no fixed shaper"
#: Time between two commands of the controller [s].
TICK = 1e-3
#: Shortest shaper, in ticks: the impulses of a shorter one would coincide.
MIN_TICKS = 2
SHARE = Constraint("a share above 0 and at most 1", lambda value: is_number(value) and 0.0 < value <= 1.0)
TIME = Constraint("a positive time in s", lambda value: is_number(value) and 0.0 < value < np.inf)


def default_kinds(modes: int) -> tuple[str, ...]:
    """Return the kinds that are compared by default: all of one mode, and products of zv for several."""
    return (*KINDS, *(PRODUCT.join(["zv"] * count) for count in range(2, modes + 1)))


def choose(
    ringing: Ringing,
    kinds: Iterable[str] | None = None,
    *,
    left: float = GOOD_ENOUGH_SHARE,
    length: float | None = None,
    tick: float = TICK,
    firmware: str | None = None,
    follow: bool = True,
) -> Choice:
    """Compare shapers: see `pkmodes.Model.shapers`.

    - follow: whether to compare those that follow the pose as well
    """
    check_argument(left, SHARE, "left", "for example: 0.1")
    check_argument(tick, TIME, "tick", "for example: 0.001")
    if length is not None:
        check_argument(length, TIME, "length", "for example: 0.05")
    if firmware is not None and not (isinstance(firmware, str) and firmware in VERSIONS):
        older = ", ".join(name for name in VERSIONS if name not in FIRMWARE_TITLES)
        check_argument(
            firmware, one_of(FIRMWARE_TITLES), "firmware", f"for example: klipper; older versions: {older}"
        )
    if isinstance(kinds, str):
        kinds = (kinds,)
    names = default_kinds(ringing.modes) if kinds is None else tuple(dict.fromkeys(map(plain, kinds)))
    for name in names:
        check_factors(name, ringing, "kinds")
    if not names:
        raise PkmodesError(
            "expected at least one kind of shaper, found none", "kinds", f"known: {', '.join(KINDS)}"
        )
    compared: list[Candidate] = []
    all_names = (*names, *names) if follow and ringing.known_between else names
    for number, name in enumerate(all_names):
        report_progress(f"shaper {number + 1} of {len(all_names)}: {name}")
        if number < len(names):
            several_modes = firmware is None or len(factors(name)) > 1
            zeta = (
                ringing.mean_ratio
                if several_modes
                else ratio_in_use(firmware or "", name, ringing.mean_ratio)
            )
            frequencies, fixed = best_fixed(name, ringing, firmware, zeta)
            compared.append(_candidate(name, False, frequencies, zeta, fixed, ringing))
        else:
            followed = shapers_following_pose(name, ringing, compared[number - len(names)].shaper)
            compared.append(_candidate(name, True, (), np.nan, followed, ringing))
    too_short = [candidate for candidate in compared if np.min(candidate.shaper.durations) < MIN_TICKS * tick]
    candidates = tuple(
        candidate for candidate in compared if all(candidate is not excluded for excluded in too_short)
    )
    if not any(not candidate.follows_pose for candidate in candidates):
        longest = numbers.plain(1e3 * max(candidate.duration for candidate in compared), 3)
        two_ticks = f"two ticks of {numbers.plain(1e3 * tick, 3)} ms"
        problem = f"the shapers last {longest} ms at most, less than {two_ticks}"
        raise PkmodesError(problem, "tick", "shorten the tick, or choose a longer kind")
    recommended, notes = _recommended(candidates, left, length, firmware, ringing)
    if firmware is not None:
        notes += _own_formulas_note(candidates, firmware)
    if too_short:
        long_enough = {candidate.kind for candidate in candidates}
        descriptions: dict[str, None] = {}
        for candidate in too_short:
            qualifier = f" of the {ringing.point_is}" if candidate.follows_pose else ", fixed"
            descriptions[f"{candidate.kind}{qualifier if candidate.kind in long_enough else ''}"] = None
        notes.append(
            f"{', '.join(descriptions)}: left out, shorter than two ticks of {numbers.plain(1e3 * tick, 3)} ms"
        )
    unshaped = _amplitude(ringing, ringing.unshaped)
    designed_for = sorted({candidate.damping_ratio for candidate in candidates if not candidate.follows_pose})
    ratios = "none"
    if firmware is not None and designed_for[-1] >= MIN_WRITTEN_RATIO:
        listed_ratios = joined([f"{ratio:g}" for ratio in designed_for if ratio >= MIN_WRITTEN_RATIO])
        ratios = f"{listed_ratios}, which {FIRMWARE_TITLES[VERSIONS[firmware].firmware]} takes by default"
    all_notes = (*ringing.notes(ratios), *notes)
    return Choice(ringing, unshaped, candidates, recommended, all_notes, left, length, firmware)


def kinds_for(ringing: Ringing, kinds: Iterable[str] | None) -> Iterable[str] | None:
    """Return the kinds with no more factors than modes count; None for those compared by default."""
    if kinds is None:
        return None
    names = (kinds,) if isinstance(kinds, str) else kinds
    return tuple(name for name in names if len(factors(name)) <= ringing.modes)


def choices_by_axis(choice: Choice, kinds: Iterable[str] | None, tick: float) -> dict[str, Choice]:
    """Return the choice of fixed shapers for each axis by itself; empty where the axes are not independent.

    An axis has no products of more factors than it has modes.

    - choice: the choice for all axes together
    - kinds: as for `choose`
    - tick: tick of that choice [s]

    Empty as well if no kind is left for an axis, or none of them is long or short enough.
    """
    by_axis: dict[str, Choice] = {}
    limits: Any = {"left": choice.left, "length": choice.length, "firmware": choice.firmware, "tick": tick}
    for axis, ringing in choice.ringing.by_axis().items():
        try:
            by_axis[axis] = choose(ringing, kinds_for(ringing, kinds), follow=False, **limits)
        except PkmodesError:
            return {}
    return by_axis


def lines_of(candidate: Candidate) -> dict[str, str | None]:
    """Return the lines of a fixed shaper for the current version by firmware; None where it has no such shaper."""
    return lines_by_firmware(*candidate.design)


def _own_formulas_note(candidates: Sequence[Candidate], version: str) -> list[str]:
    """Return a note on the kinds whose impulses a version computes by its own formulas, which are those compared."""
    with_own_impulses = [
        candidate.kind
        for candidate in candidates
        if not candidate.follows_pose and has_own_formulas(version, candidate.kind, candidate.damping_ratio)
    ]
    if not with_own_impulses:
        return []
    are = "is" if len(with_own_impulses) == 1 else "are"
    return [
        f"the fixed {joined(with_own_impulses)} {are} compared with the impulses that "
        f"{version_name(version, version)} makes"
    ]


def _recommended(
    candidates: tuple[Candidate, ...],
    share: float,
    length: float | None,
    firmware: str | None,
    ringing: Ringing,
) -> tuple[int, list[str]]:
    """Return the index of the recommended shaper, and notes on it."""
    best, is_good_enough = recommended_of(candidates, share, length, firmware)
    notes: list[str] = []
    if best is None:
        fixed = [candidate for candidate in candidates if not candidate.follows_pose]
        available = [
            candidate
            for candidate in fixed
            if firmware is None or configuration_lines(firmware, *candidate.design) is not None
        ]
        if not available:
            kinds = ", ".join(candidate.kind for candidate in fixed)
            problem = f"{version_name(firmware or '')} has none of the shapers compared: {kinds}"
            raise PkmodesError(problem, "firmware", "compare others, such as zv, mzv and ei")
        of_firmware = "" if firmware is None else f" that {version_name(firmware)} has"
        problem = f"no fixed shaper{of_firmware} lasts at most {1e3 * (length or 0.0):.4g} ms"
        shortest = min(candidate.duration for candidate in available)
        raise PkmodesError(problem, "length", f"the shortest one lasts {1e3 * shortest:.4g} ms")
    if is_good_enough:
        return best, notes
    of_firmware = "" if firmware is None else f" of {version_name(firmware)}"
    notes.append(
        f"{NONE_GOOD_ENOUGH}{of_firmware} leaves at most {numbers.plain(100 * share, 3)} % {ringing.share_of}; "
        "the best one is recommended"
    )
    followers = [
        candidate
        for candidate in candidates
        if candidate.follows_pose and (length is None or candidate.duration <= length)
    ]
    if followers:
        follower = min(followers, key=lambda candidate: (round(candidate.left.worst, 6), candidate.duration))
        worst, uncertain = follower.left.worst, follower.left.rms_uncertain
        remaining_text = f"{numbers.plain(100 * worst, 2)} %" if worst >= 1e-6 else "nothing"
        spread = (
            ""
            if uncertain is None
            else f", {numbers.plain(100 * uncertain, 2)} % on average with uncertain frequencies"
        )
        notes.append(
            f"following the {ringing.point_is}, {follower.kind} leaves {remaining_text} "
            f"{ringing.share_of}{spread}, and more while the machine moves (pkmodes.Model.simulate)"
        )
    return best, notes


def _candidate(
    kind: str, follows: bool, frequencies: tuple[float, ...], zeta: float, shaper: Shaper, ringing: Ringing
) -> Candidate:
    shaped = shaped_by(shaper, ringing)
    return Candidate(
        kind,
        follows,
        frequencies,
        zeta,
        shaper,
        relative(shaper, ringing, shaped),
        shaped / ringing.unshaped,
        relative_at_pose(shaper, ringing, shaped),
    )


def shaped_by(shaper: Shaper, ringing: Ringing) -> Array:
    """Return the vibration that a shaper leaves, or one for each operating point, (N,) [s^2]."""
    return ringing.shaped(residual(shaper, ringing.frequencies, ringing.damping_ratios))


def relative(shaper: Shaper, ringing: Ringing, shaped: Array) -> Amplitude:
    """Return what a shaper leaves over all operating points, relative to no shaper."""
    amplitude, unshaped_rms = _amplitude(ringing, shaped), np.sqrt(np.mean(ringing.unshaped**2))
    uncertain = _rms_uncertain(shaper, ringing, np.ones_like(ringing.unshaped))
    return Amplitude(
        float(amplitude.rms / unshaped_rms),
        float(amplitude.worst / ringing.unshaped.max()),
        amplitude.pose,
        None if uncertain is None else float(uncertain / unshaped_rms),
        amplitude.setting,
    )


def relative_at_pose(shaper: Shaper, ringing: Ringing, shaped: Array) -> Amplitude:
    """Return what a shaper leaves at each operating point, relative to no shaper at the same one."""
    return replace(
        _amplitude(ringing, shaped / ringing.unshaped),
        rms_uncertain=_rms_uncertain(shaper, ringing, ringing.unshaped),
    )


def _rms_uncertain(shaper: Shaper, ringing: Ringing, reference: Array) -> float | None:
    """Return the root mean square left with frequencies spread by their standard deviations; None without any.

    - reference: that to which the vibration at each operating point is relative, (N,)
    """
    squares = [
        share * np.mean((ringing.shaped(residual(shaper, f, ringing.damping_ratios)) / reference) ** 2)
        for share, f in ringing.at_spread()
    ]
    return float(np.sqrt(sum(squares))) if squares else None


def _amplitude(ringing: Ringing, values: Array) -> Amplitude:
    worst = int(np.argmax(values))
    rms = float(np.sqrt(np.mean(values**2)))
    return Amplitude(rms, float(values[worst]), ringing.poses[worst], setting=ringing.setting_of(worst))
