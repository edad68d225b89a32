"""Lines for each version of a firmware whose lines or impulses differ, with what each leaves of the vibration."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Mapping
from typing import Annotated

import numpy as np
from msgspec import Meta

from pkmodes.core.support.documents import Document, Size
from pkmodes.core.support.ordering import joined
from pkmodes.machine.shaping.choice import relative, relative_at_pose, shaped_by
from pkmodes.machine.shaping.firmware import (
    AXES,
    FIRMWARE_TITLES,
    VERSIONS,
    configuration_lines,
    ratio_in_use,
    version_name,
)
from pkmodes.machine.shaping.firmware_impulses import firmware_shaper
from pkmodes.machine.shaping.results import Candidate, Choice, Schedule, shapers_in
from pkmodes.machine.shaping.ringing import Ringing
from pkmodes.machine.shaping.schedule import each_setting
from pkmodes.machine.shaping.shapers import Shaper

#: Decimals of amplitudes and delays [s] to which impulses are compared.
IMPULSE_DECIMALS = 9


class VersionLines(Document, frozen=True):
    """Lines for the versions of a firmware that make the same impulses of the same lines."""

    firmware: Annotated[str, Meta(description="klipper, marlin or reprapfirmware.")]
    option: Annotated[str, Meta(description="Value of --firmware that chooses the newest of them.")]
    version: Annotated[
        str,
        Meta(description="Their name and dates; the firmware alone where all known versions make the same."),
    ]
    lines: Annotated[
        str | None,
        Meta(
            description="The lines; of the best shaper that they have where they lack the recommended one, or one of "
            "a schedule; null where they have none."
        ),
    ]
    worst: Annotated[
        Size | None,
        Meta(
            description="What the impulses that they make leave, as worst of left (of measured modes: "
            "worst_uncertain); null without lines."
        ),
    ]
    worst_at_pose: Annotated[
        Size | None,
        Meta(
            description="The same as worst of left_at_pose (of measured modes: worst_uncertain); null without lines."
        ),
    ]
    shaper: Annotated[
        str | None,
        Meta(description="Kind of shaper of the lines, for each axis if they differ; null without lines."),
    ]
    instead: Annotated[
        bool,
        Meta(description="Whether that is another shaper than the recommended one, or one of a schedule."),
    ]


def lines_by_version(choice: Choice) -> list[VersionLines]:
    """Return the lines of the recommended shapers, for each firmware the newest versions first.

    Where the axes are independent, they are those of each axis; for a firmware that has one shaper for all axes,
    those of the best shaper for all of them.
    """

    def lines_of_version(version: str, name: str) -> VersionLines:
        shapers = recommended_in(version, choice)
        firmware = VERSIONS[version].firmware
        if not shapers:
            return VersionLines(firmware, version, name, None, None, None, None, instead=False)
        made = {axis: made_by(version, shapers.get(axis) or shapers[""]) for axis in choice.parts}
        remaining = [_worst(made[axis], part.ringing) for axis, part in choice.parts.items()]
        worst, worst_at_pose = (max(values) for values in zip(*remaining, strict=True))
        return VersionLines(
            firmware,
            version,
            name,
            _lines(version, shapers),
            worst,
            worst_at_pose,
            shapers_in_words(shapers),
            instead=_differ(shapers, choice),
        )

    def key(version: str) -> Hashable:
        shapers = recommended_in(version, choice)
        return _lines(version, shapers), *(_key(made_by(version, shaper)) for shaper in shapers.values())

    return _grouped(key, lines_of_version)


def current_lines(choice: Choice) -> dict[str, str | None]:
    """Return the lines of the recommended shapers for the current version by firmware; None where it lacks one."""
    lines = {}
    for name in FIRMWARE_TITLES:
        shapers = recommended_in(name, choice)
        lines[name] = None if _differ(shapers, choice) else _lines(name, shapers)
    return lines


def recommended_in(version: str, choice: Choice) -> dict[str, Candidate]:
    """Return the best shapers that a version of a firmware has, by axis; for all axes under an empty name.

    Empty if it has none of those compared.
    """
    for parts in (choice.by_axis, {"": choice}):
        parts = {axis: part for axis, part in parts.items() if axis in AXES}
        shapers = shapers_in(version, {axis: axis or AXES for axis in parts}, parts)
        if shapers:
            return shapers
    return {}


def _differ(shapers: Mapping[str, Candidate], choice: Choice) -> bool:
    """Whether shapers by axis differ from the recommended ones."""
    kinds = {axis: shaper.kind for axis, shaper in shapers.items()}
    return kinds != {axis: part.best.kind for axis, part in choice.parts.items() if axis in AXES}


def shapers_in_words(shapers: Mapping[str, Candidate]) -> str:
    """Return the kinds of shapers, by axis if there are several."""
    return joined([f"{shaper.kind} on {axis}" if axis else shaper.kind for axis, shaper in shapers.items()])


def _lines(version: str, shapers: Mapping[str, Candidate]) -> str | None:
    """Return the lines of shapers by axis, with one header."""
    texts = [
        configuration_lines(version, *shaper.design, axis or AXES) or "" for axis, shaper in shapers.items()
    ]
    return "\n".join(dict.fromkeys("\n".join(texts).splitlines())) or None


def schedule_lines_by_version(choice: Choice, schedule: Schedule) -> list[VersionLines]:
    """Return the commands of a schedule in the same way; the remaining vibration is that over all settings."""
    ringing = choice.ringing

    def lines_of_version(version: str, name: str) -> VersionLines:
        firmware, shapers = VERSIONS[version].firmware, schedule.shapers_in(version)
        if shapers is None:
            return VersionLines(firmware, version, name, None, None, None, None, instead=False)
        made = each_setting([made_by(version, candidate) for candidate in shapers], ringing)
        return VersionLines(
            firmware,
            version,
            name,
            schedule.commands(version),
            *_worst(made, ringing),
            joined(list(dict.fromkeys(shaper.kind for shaper in shapers))),
            instead=schedule.differs_in(version),
        )

    return _grouped(
        lambda version: (
            schedule.commands(version),
            *(_key(made_by(version, candidate)) for candidate in schedule.shapers_in(version) or ()),
        ),
        lines_of_version,
    )


def made_by(version: str, candidate: Candidate) -> Shaper:
    """Return the impulses that a version of a firmware makes of the lines of a fixed shaper."""
    if len(candidate.frequencies) > 1:
        return candidate.shaper
    zeta = ratio_in_use(version, candidate.kind, candidate.damping_ratio)
    return firmware_shaper(version, candidate.kind, candidate.frequencies[0], zeta)


def _worst(shaper: Shaper, ringing: Ringing) -> tuple[float, float]:
    """Return the most that impulses leave, of the largest vibration, and of that at the same pose."""
    shaped = shaped_by(shaper, ringing)
    return relative(shaper, ringing, shaped).worst, relative_at_pose(shaper, ringing, shaped).worst


def _key(shaper: Shaper) -> Hashable:
    """Return a key by which impulses are compared."""
    return tuple(map(float, np.round(np.concatenate(shaper), IMPULSE_DECIMALS)))


def _grouped(
    key: Callable[[str], Hashable], make_lines: Callable[[str, str], VersionLines]
) -> list[VersionLines]:
    """Return the lines of successive versions of a firmware with the same key."""
    version_lines = []
    for firmware in FIRMWARE_TITLES:
        versions = [version for version, release in VERSIONS.items() if release.firmware == firmware]
        groups: list[list[str]] = []
        for version in versions:
            if groups and key(groups[-1][0]) == key(version):
                groups[-1].append(version)
            else:
                groups.append([version])
        version_lines += [make_lines(group[0], version_name(group[0], group[-1])) for group in groups]
    return version_lines
