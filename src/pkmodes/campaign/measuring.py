"""The modes of a record over its files: repeats are averaged, setups joined."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from pkmodes.campaign.averaging import Mean, averaged
from pkmodes.campaign.campaign import Campaign, Record
from pkmodes.campaign.copies import copied_repeats
from pkmodes.campaign.edits import added_group, check_asked, refuse_added
from pkmodes.campaign.found import FileModes, Found
from pkmodes.campaign.grouping import grouped
from pkmodes.campaign.inspection import Inspection, Repeats, inspection
from pkmodes.campaign.joining import joined
from pkmodes.campaign.kinds import Kind
from pkmodes.campaign.results import LeftOut
from pkmodes.core.base.errors import MeasurementError
from pkmodes.identification.asked import NEAR

#: A mode must be in this share of the repeats.
OFTEN = 0.5


@dataclass(frozen=True, eq=False)
class Measured:
    """The modes of a record over its repeats and setups, before they are edited.

    Attributes
    ----------
    means, added : sequence of Mean
        The modes found, and those that the user adds, by the frequencies asked for.
    inspections : sequence of Inspection
        Of the first file of each setup, if they were asked for.
    """

    record: Record
    means: Sequence[Mean]
    added: Sequence[Mean]
    left_out: Sequence[LeftOut]
    messages: Sequence[str]
    inspections: Sequence[Inspection]
    repeats: Sequence[Repeats]


@dataclass(frozen=True, eq=False)
class _Setup:
    """The files of a setup that could be read, what to say of them, and those left out."""

    paths: Sequence[Path]
    found: Sequence[FileModes]
    messages: Sequence[str]
    left_out: Sequence[LeftOut]
    inspection: Inspection | None


def measured(
    record: Record, kind: Kind, campaign: Campaign, keep_going: bool, inspect: bool = False
) -> Measured:
    """Return the modes of a record.

    Parameters
    ----------
    keep_going : bool
        Whether faulty files are left out instead of refused.
    inspect : bool
        Whether what a report draws is kept.

    Raises
    ------
    MeasurementError
        If a file is faulty, or a mode that the user asks for cannot be added.
    """
    asked = campaign.asked(record)
    check_asked(asked, record, kind, campaign.source)
    means: dict[str, list[Mean]] = {}
    added: dict[float, dict[str, Mean | str]] = {wanted: {} for wanted in asked.add}
    left_out: list[LeftOut] = []
    messages = copied_repeats(record)
    inspections: list[Inspection] = []
    repeats: list[Repeats] = []
    for setup, paths in record.setups.items():
        one = _read(record, setup, paths, kind, campaign, keep_going, inspect)
        left_out += one.left_out
        messages += one.messages
        if not one.found:
            continue
        inspections += [] if one.inspection is None else [one.inspection]
        messages += _gaps_in_the_record(record, setup, one, campaign)
        least = max(1.0, OFTEN * len(one.found))
        groups = [group for group in grouped([file.modes for file in one.found]) if len(group) >= least]
        more: dict[float, dict[int, Found]] = {}
        for i, wanted in enumerate(asked.add):
            group = added_group([file.added[i] for file in one.found], wanted, least)
            if isinstance(group, str):
                added[wanted][setup] = group
            else:
                more[wanted] = group
        together = averaged([*groups, *more.values()])
        means[setup] = together[: len(groups)]
        for wanted, mean in zip(more, together[len(groups) :], strict=True):
            added[wanted][setup] = mean
        names = tuple(path.name for path in one.paths)
        repeats.append(Repeats(setup, names, tuple(map(_frequencies, [*groups, *more.values()]))))
    found, notes = joined(means) if means else ([], [])
    further = [_joined(wanted, each, record, campaign, notes) for wanted, each in added.items() if means]
    said = [*messages, *(f"{record.pose}: {note}" for note in notes)]
    return Measured(record, found, further, left_out, said, inspections, repeats)


def _read(
    record: Record,
    setup: str,
    paths: Sequence[Path],
    kind: Kind,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
) -> _Setup:
    """Return the modes in each file of a setup that can be read."""
    files: list[FileModes] = []
    read: list[Path] = []
    left_out: list[LeftOut] = []
    messages: list[str] = []
    drawn: Inspection | None = None
    for path in paths:
        try:
            found = kind.find(path, record, setup, campaign)
        except MeasurementError as error:
            if not keep_going:
                raise
            left_out.append(LeftOut(str(path), f"{error.what} ({error.where})"))
            continue
        if inspect and found.fit is not None and not files:
            drawn = inspection(setup, path.name, found.fit)
        found = replace(found, fit=None)  # its functions may be large
        added = tuple(_added(one, record, setup, kind, campaign) for one in found.added)
        every = [*found.modes, *(one for one in added if not isinstance(one, str))]
        messages += [*found.messages, *_beside_tones(every, path, campaign.tones)]
        inside = _in_band(found.modes, record, path, messages)
        modes = tuple(_named(mode, setup, kind, campaign) for mode in inside)
        files.append(replace(found, modes=modes, added=added))
        read.append(path)
    return _Setup(read, files, messages, left_out, drawn)


def _added(one: Found | str, record: Record, setup: str, kind: Kind, campaign: Campaign) -> Found | str:
    """Return a mode that the user adds, or why there is none in a file."""
    if isinstance(one, str):
        return one
    low, high = record.band
    return _named(one, setup, kind, campaign) if low <= one.frequency <= high else "its fit leaves the band"


def _gaps_in_the_record(record: Record, setup: str, one: _Setup, campaign: Campaign) -> list[str]:
    """Name the sensors that are in no file, and single files."""
    said: list[str] = []
    unseen = sorted(campaign.named_in(setup).difference(*(file.seen for file in one.found)))
    if unseen:
        said.append(f"{record.pose}: sensors or forces that are in none of the files: {', '.join(unseen)}")
    if len(one.found) == 1:
        of = f" of the setup {setup}" if setup else ""
        said.append(f"{record.pose}: a single file{of}: the scatter of repeats is unknown")
    return said


def _joined(
    wanted: float,
    by_setup: Mapping[str, Mean | str],
    record: Record,
    campaign: Campaign,
    notes: list[str],
) -> Mean:
    """Return a mode that the user adds over the setups in which it was found."""
    found = {setup: [one] for setup, one in by_setup.items() if not isinstance(one, str)}
    if not found:
        reasons = [one for one in by_setup.values() if isinstance(one, str)]
        refuse_added(wanted, f"{reasons[0]} ({record.pose})", campaign.source)
    means, more = joined(found)
    notes += more
    return min(means, key=lambda mean: abs(mean.mode.frequency - wanted))


def _frequencies(group: Mapping[int, Found]) -> dict[int, float]:
    return {i: mode.frequency for i, mode in sorted(group.items())}


def _in_band(modes: Sequence[Found], record: Record, path: Path, messages: list[str]) -> list[Found]:
    low, high = record.band
    inside = [mode for mode in modes if low <= mode.frequency <= high]
    if len(inside) < len(modes):
        outside = ", ".join(f"{mode.frequency:.4g}" for mode in modes if mode not in inside)
        messages.append(f"{path}: outside the band, left out: {outside} Hz")
    return inside


def _beside_tones(modes: Sequence[Found], path: Path, tones: Sequence[float]) -> list[str]:
    """Name the modes that lie beside a stated tone or one of its multiples."""
    found = []
    for mode in modes:
        for tone in tones:
            multiple = max(1, round(mode.frequency / tone))
            if abs(mode.frequency / (multiple * tone) - 1.0) <= NEAR:
                found.append(
                    f"{path}: the mode at {mode.frequency:.4g} Hz lies beside the tone at {multiple * tone:.4g} Hz"
                )
    return found


def _named(mode: Found, setup: str, kind: Kind, campaign: Campaign) -> Found:
    """Return a mode whose sensors have names of their own where they hold in one setup only."""
    if kind.by_channel:
        return mode
    known = {**campaign.forces_in(setup), **campaign.sensors_in(setup)}
    names = {name: place.key for name, place in known.items()}
    return replace(
        mode,
        shape={names[name]: value for name, value in mode.shape.items()},
        participation={names.get(name, name): value for name, value in mode.participation.items()},
    )
