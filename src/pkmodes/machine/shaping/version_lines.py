"""Lines for each version of a firmware whose lines or impulses differ, with what each leaves of the vibration."""

from __future__ import annotations

from collections.abc import Callable, Hashable
from typing import Annotated

import numpy as np
from msgspec import Meta

from pkmodes.core.support.documents import Document, Size
from pkmodes.machine.shaping.choice import relative, shaped_by
from pkmodes.machine.shaping.firmware import NAMES, VERSIONS, setting, version_name
from pkmodes.machine.shaping.firmware_impulses import as_made
from pkmodes.machine.shaping.results import Candidate, Choice, Schedule
from pkmodes.machine.shaping.schedule import each_setting
from pkmodes.machine.shaping.shapers import Shaper

#: Decimals of amplitudes and delays [s] to which impulses are compared.
DIGITS = 9


class VersionLines(Document, frozen=True):
    """Lines for the versions of a firmware that make the same impulses of the same lines."""

    firmware: Annotated[str, Meta(description="klipper, marlin or reprapfirmware.")]
    option: Annotated[str, Meta(description="Value of --firmware that chooses the newest of them.")]
    version: Annotated[
        str,
        Meta(description="Their name and dates; the firmware alone where all known versions make the same."),
    ]
    lines: Annotated[
        str | None, Meta(description="The lines; null where they lack the shaper, or one of them.")
    ]
    worst: Annotated[
        Size | None,
        Meta(
            description="What the impulses that they make leave, as worst of left (of measured modes: "
            "worst_uncertain); null without lines."
        ),
    ]


def lines_by_version(choice: Choice) -> list[VersionLines]:
    """Return the lines of the recommended shaper, for each firmware the newest versions first."""
    best = choice.candidates[choice.recommended]

    def written(version: str, name: str) -> VersionLines:
        lines, worst = setting(version, *best.design), None
        if lines is not None:
            made = made_by(version, best)
            worst = relative(made, choice.ringing, shaped_by(made, choice.ringing)).worst
        return VersionLines(VERSIONS[version].firmware, version, name, lines, worst)

    return _grouped(lambda version: (setting(version, *best.design), _key(made_by(version, best))), written)


def schedule_lines_by_version(choice: Choice, schedule: Schedule) -> list[VersionLines]:
    """Return the commands of a schedule in the same way; the remaining vibration is that over all settings."""
    scheduled, at = [step.best for step in schedule.steps], choice.ringing

    def written(version: str, name: str) -> VersionLines:
        lines, worst = schedule.commands(version), None
        if lines is not None:
            made = each_setting([made_by(version, candidate) for candidate in scheduled], at)
            worst = relative(made, at, shaped_by(made, at)).worst
        return VersionLines(VERSIONS[version].firmware, version, name, lines, worst)

    return _grouped(
        lambda version: (
            schedule.commands(version),
            *(_key(made_by(version, candidate)) for candidate in scheduled),
        ),
        written,
    )


def made_by(version: str, candidate: Candidate) -> Shaper:
    """Return the impulses that a version of a firmware makes of the lines of a fixed shaper."""
    if len(candidate.frequencies) > 1:
        return candidate.shaper
    return as_made(version, candidate.kind, candidate.frequencies[0], candidate.damping_ratio)


def _key(shaper: Shaper) -> Hashable:
    """Return a key by which impulses are compared."""
    return tuple(map(float, np.round(np.concatenate(shaper), DIGITS)))


def _grouped(
    key: Callable[[str], Hashable], written: Callable[[str, str], VersionLines]
) -> list[VersionLines]:
    """Return the lines of successive versions of a firmware with the same key."""
    version_lines = []
    for firmware in NAMES:
        versions = [version for version, release in VERSIONS.items() if release.firmware == firmware]
        groups: list[list[str]] = []
        for version in versions:
            if groups and key(groups[-1][0]) == key(version):
                groups[-1].append(version)
            else:
                groups.append([version])
        version_lines += [written(group[0], version_name(group[0], group[-1])) for group in groups]
    return version_lines
