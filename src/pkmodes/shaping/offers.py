"""Lines for each version of a firmware whose lines or impulses differ, with what each leaves of the vibration."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import NamedTuple

import numpy as np

from pkmodes.shaping.choice import relative, shaped_by
from pkmodes.shaping.firmware import NAMES, VERSIONS, name_of, setting
from pkmodes.shaping.firmware_impulses import as_made
from pkmodes.shaping.results import Candidate, Choice, Schedule
from pkmodes.shaping.schedule import each_setting
from pkmodes.shaping.shapers import Shaper

#: Decimal digits of amplitudes and delays [s] that tell impulses apart.
DIGITS = 9


class Offer(NamedTuple):
    """The lines of the versions of a firmware that make the same of the same lines.

    Attributes
    ----------
    firmware : str
        A key of `pkmodes.shaping.firmware.NAMES`.
    option : str
        The newest of the versions, a key of `pkmodes.shaping.firmware.VERSIONS`.
    version : str
        Its name with its dates; that of the firmware alone where all versions known make the same.
    lines : str or None
        None where it lacks a shaper.
    worst : float or None
        What its impulses leave, the largest value as `Amplitude.worst`; None without lines.
    """

    firmware: str
    option: str
    version: str
    lines: str | None
    worst: float | None


def offers(choice: Choice) -> list[Offer]:
    """Return the lines of the recommended shaper, for each firmware the newest versions first."""
    best = choice.candidates[choice.recommended]

    def offered(version: str, name: str) -> Offer:
        lines, worst = setting(version, *best.design), None
        if lines is not None:
            made = made_by(version, best)
            worst = relative(made, choice.ringing, shaped_by(made, choice.ringing)).worst
        return Offer(VERSIONS[version].firmware, version, name, lines, worst)

    return _grouped(lambda version: (setting(version, *best.design), _key(made_by(version, best))), offered)


def schedule_offers(choice: Choice, schedule: Schedule) -> list[Offer]:
    """Return the commands of a schedule, likewise; what is left is that over all settings."""
    every, at = [step.best for step in schedule.steps], choice.ringing

    def offered(version: str, name: str) -> Offer:
        lines, worst = schedule.commands(version), None
        if lines is not None:
            made = each_setting([made_by(version, one) for one in every], at)
            worst = relative(made, at, shaped_by(made, at)).worst
        return Offer(VERSIONS[version].firmware, version, name, lines, worst)

    return _grouped(
        lambda version: (schedule.commands(version), *(_key(made_by(version, one)) for one in every)), offered
    )


def made_by(version: str, one: Candidate) -> Shaper:
    """Return the impulses that a version of a firmware makes of the lines of a fixed shaper."""
    if len(one.frequencies) > 1:
        return one.shaper
    return as_made(version, one.kind, one.frequencies[0], one.damping_ratio)


def _key(shaper: Shaper) -> Hashable:
    """Return what tells impulses apart."""
    return tuple(map(float, np.round(np.concatenate(shaper), DIGITS)))


def _grouped(key: Callable[[str], Hashable], offered: Callable[[str, str], Offer]) -> list[Offer]:
    """Return one offer for successive versions of a firmware with the same key."""
    found = []
    for firmware in NAMES:
        versions = [version for version, one in VERSIONS.items() if one.firmware == firmware]
        groups: list[list[str]] = []
        for version in versions:
            if groups and key(groups[-1][0]) == key(version):
                groups[-1].append(version)
            else:
                groups.append([version])
        found += [offered(group[0], name_of(group[0], group[-1])) for group in groups]
    return found
