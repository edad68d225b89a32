"""The modes of a record: its files are read, repeats averaged, and setups joined."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.base.numbers import plain
from pkmodes.modaltest.campaign.averaging import mean_modes
from pkmodes.modaltest.campaign.boards import UnknownOffsetError
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.copies import copied_repeats
from pkmodes.modaltest.campaign.edits import added_group, check_asked, refuse_added
from pkmodes.modaltest.campaign.grouping import grouped
from pkmodes.modaltest.campaign.inspection import Inspection, Repeats, inspection
from pkmodes.modaltest.campaign.joining import joined_setups
from pkmodes.modaltest.campaign.kinds import RecordKind
from pkmodes.modaltest.campaign.missing import Places, lacking, places_in, unnamed
from pkmodes.modaltest.campaign.mode_estimates import FileModes, ModeEstimate
from pkmodes.modaltest.campaign.results import LeftOut
from pkmodes.modaltest.campaign.roving import RovingPoint, change_of, points_of
from pkmodes.modaltest.campaign.roving_functions import ApartError
from pkmodes.modaltest.identification.asked import NEAR

#: Least share of the repeats in which a mode must be found.
OFTEN = 0.5


@dataclass(frozen=True, eq=False)
class MeasuredRecord:
    """The modes of a record over its repeats and setups, before they are edited.

    - modes, added: the modes found, and those that the user adds, in the order of the requested frequencies
    - inspections: of the first file of each setup, if requested
    - places: the files of each setup, each with whether it has the sensors and forces that it should have
    - log: messages about the record; each step writes to it
    """

    record: Record
    modes: Sequence[ModeEstimate]
    added: Sequence[ModeEstimate]
    left_out: Sequence[LeftOut]
    inspections: Sequence[Inspection]
    repeats: Sequence[Repeats]
    places: Sequence[Sequence[tuple[Path, Places]]]
    log: list[str]


@dataclass(frozen=True, eq=False)
class _Setup:
    """The readable files of a setup, and those left out; `places` as in `MeasuredRecord`."""

    names: Sequence[str]
    file_modes: Sequence[FileModes]
    left_out: Sequence[LeftOut]
    inspection: Inspection | None
    places: Sequence[Sequence[tuple[Path, Places]]] = ()

    @property
    def least(self) -> float:
        """Number of files in which a mode must be found."""
        return max(1.0, OFTEN * len(self.file_modes))

    def groups(self) -> list[dict[int, ModeEstimate]]:
        """Return the modes that are found often enough, each by the files in which it was found."""
        groups = grouped([file.modes for file in self.file_modes])
        return [group for group in groups if len(group) >= self.least]


def measured(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool = False
) -> MeasuredRecord:
    """Return the modes of a record.

    - keep_going: whether faulty files are left out instead of refused
    - inspect: whether the parts of the fits that a report draws are kept

    Raises MeasurementError if a file is faulty, or a mode that the user requests cannot be added.
    """
    check_asked(campaign.asked(record), record, kind, campaign.source)
    log = copied_repeats(record)
    try:
        setups = _read_setups(record, kind, campaign, keep_going, inspect, log)
    except UnknownOffsetError as error:
        record = replace(record, clocks={})
        log.insert(0, f"{record.pose}: each board is identified alone, with no phase between them: {error}")
        setups = _read_setups(record, kind, campaign, keep_going, inspect, log)
    return _averaged_record(record, setups, campaign, log)


def _read_setups(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool, log: list[str]
) -> dict[str, _Setup]:
    """Read the files of a record, setup by setup; those of a roving hammer are merged into one setup.

    - log: unchanged if a file is refused, so that the record can be read in another way
    """
    setups, messages = dict[str, _Setup](), list[str]()
    for name, paths in record.separate.items():
        files = {str(path): partial(_find, path, record, name, kind, campaign) for path in paths}
        setup = _read(name, files, record, campaign, keep_going, inspect, messages)
        left_out = {faulty.file for faulty in setup.left_out}
        read = [path for path in paths if str(path) not in left_out]
        has = [places_in(file.names_in_file, record, name, kind, campaign) for file in setup.file_modes]
        setups[name] = replace(setup, places=[list(zip(read, has, strict=True))])
    if kind.roving is not None:
        setups = _together(setups, kind.roving, record, campaign, keep_going, inspect, messages)
    log += messages
    return setups


def _find(path: Path, record: Record, setup: str, kind: RecordKind, campaign: Campaign) -> FileModes:
    """Return the modes of a file, by the keys of its sensors and forces, which are unique over all setups."""
    file_modes = kind.find(path, record, setup, campaign).changed(
        lambda mode: replace(mode, lengths=campaign.lengths)
    )
    if kind.by_channel:
        return file_modes
    places = {**campaign.forces_in(setup), **campaign.sensors_in(setup)}
    keys = {name: place.key for name, place in places.items()}

    def by_key(components: Mapping[str, complex]) -> dict[str, complex]:
        return {keys.get(name, name): value for name, value in components.items()}

    return file_modes.changed(
        lambda mode: replace(mode, shape=by_key(mode.shape), participation=by_key(mode.participation))
    )


def _read(
    setup: str,
    files: Mapping[str, Callable[[], FileModes]],
    record: Record,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
    log: list[str],
) -> _Setup:
    """Return the modes in each readable file of a setup; `files` are the functions that read them, by name."""
    results, read, left_out = list[FileModes](), list[str](), list[LeftOut]()
    drawn: Inspection | None = None
    low, high = record.band
    for name, find in files.items():
        try:
            file_modes = find()
        except MeasurementError as error:
            if not keep_going:
                raise
            left_out.append(LeftOut(name, f"{error.what} ({error.where})"))
            continue
        if inspect and file_modes.fit is not None and not results:
            drawn = inspection(setup, Path(name).name, len(files) - 1, file_modes.fit)
        added = tuple(
            candidate
            if isinstance(candidate, str) or low <= candidate.frequency <= high
            else "its fit leaves the band"
            for candidate in file_modes.added
        )
        modes = [*file_modes.modes, *(candidate for candidate in added if not isinstance(candidate, str))]
        beside = [
            (mode.frequency, max(1, round(mode.frequency / tone)) * tone)
            for mode in modes
            for tone in campaign.tones
        ]
        outside = [mode.frequency for mode in file_modes.modes if not low <= mode.frequency <= high]
        log += file_modes.messages
        log += [
            f"{name}: the mode at {frequency:.4g} Hz lies beside the tone at {multiple:.4g} Hz"
            for frequency, multiple in beside
            if abs(frequency / multiple - 1.0) <= NEAR
        ]
        if outside:
            listing = ", ".join(f"{frequency:.4g}" for frequency in outside)
            log.append(f"{name}: outside the band, left out: {listing} Hz")
        inside = tuple(mode for mode in file_modes.modes if low <= mode.frequency <= high)
        # The functions of a fit may be large.
        results.append(replace(file_modes, modes=inside, added=added, fit=None))
        read.append(Path(name).name)
    return _Setup(read, results, left_out, drawn)


def _together(
    setups: dict[str, _Setup],
    roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes],
    record: Record,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
    messages: list[str],
) -> dict[str, _Setup]:
    """Return the setups of a roving hammer as one, fitted together; other setups are returned unchanged.

    - messages: about the single files; those about the joint fit replace them
    """
    files = {
        name: {path: file for (path, _), file in zip(setup.places[0], setup.file_modes, strict=True)}
        for name, setup in setups.items()
        if setup.file_modes
    }
    points = points_of(files, campaign)
    if not points:
        return setups
    change = change_of({name: mean_modes(setups[name].groups()) for name in files})
    apart = plain(100.0 * change.apart, 2)
    differ = f"{record.pose}: the frequencies differ by {apart} % between the points that were hit"
    if change.apart > change.allowed:
        messages.insert(0, f"{differ}: each point is fitted by itself")
        return setups
    runs = {
        f"{record.pose}, file {i} of each setup": partial(
            _roved,
            roving,
            {
                name: RovingPoint(path, files[name][path].modes, change.factors[name])
                for name, path in paths.items()
            },
            record,
            campaign,
        )
        for i, paths in enumerate(points, start=1)
    }
    joint_messages = (
        [f"{differ}: half of it is in sigma"] if change.apart > (campaign.repeatability or 0.0) else []
    )
    surplus = [path.name for paths in files.values() for path in list(paths)[len(points) :]]
    if surplus:
        few = "one file" if len(points) == 1 else f"{len(points)} files"
        joint_messages.append(f"{record.pose}: not used, as some point has only {few}: {', '.join(surplus)}")
    try:
        joint = _read("", runs, record, campaign, keep_going, inspect, joint_messages)
    except ApartError as error:
        messages.insert(0, f"{record.pose}: each point is fitted by itself: {error}")
        return setups
    messages[:] = joint_messages
    merged = replace(
        joint,
        file_modes=[file.changed(change.on) for file in joint.file_modes],
        left_out=[faulty for setup in (*setups.values(), joint) for faulty in setup.left_out],
        places=[files for setup in setups.values() for files in setup.places],
    )
    return {"": merged}


def _roved(
    roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes],
    points: Mapping[str, RovingPoint],
    record: Record,
    campaign: Campaign,
) -> FileModes:
    """Return the modes of a roving hammer, fitted together."""
    return roving(points, record, campaign).changed(lambda mode: replace(mode, lengths=campaign.lengths))


def _averaged_record(
    record: Record, setups: Mapping[str, _Setup], campaign: Campaign, log: list[str]
) -> MeasuredRecord:
    """Average the modes of each setup over its repeats, and join the setups; likewise for modes that users add."""
    requested = campaign.asked(record).add
    modes: dict[str, list[ModeEstimate]] = {}
    added: dict[float, dict[str, ModeEstimate | str]] = {frequency: {} for frequency in requested}
    repeats: list[Repeats] = []
    for name, setup in setups.items():
        if not setup.file_modes:
            continue
        groups, added_groups = setup.groups(), dict[float, dict[int, ModeEstimate]]()
        for i, frequency in enumerate(requested):
            group = added_group([file.added[i] for file in setup.file_modes], frequency, setup.least)
            if isinstance(group, str):
                added[frequency][name] = group
            else:
                added_groups[frequency] = group
        all_groups = [*groups, *added_groups.values()]
        averages = mean_modes(all_groups)
        modes[name] = averages[: len(groups)]
        for frequency, mode in zip(added_groups, averages[len(groups) :], strict=True):
            added[frequency][name] = mode
        frequencies = [{i: mode.frequency for i, mode in sorted(group.items())} for group in all_groups]
        repeats.append(Repeats(name, tuple(setup.names), tuple(frequencies)))
    single = [name for name, setup in setups.items() if len(setup.file_modes) == 1]
    if single:
        which = "each setup" if len(single) == len(setups) else ", ".join(single)
        of = f" of {which}" if len(setups) > 1 else ""
        log.append(f"{record.pose}: a single file{of}: the scatter of repeats is unknown")
    places = [files for setup in setups.values() for files in setup.places]
    log += lacking(record.pose, places)
    log += unnamed(record.pose, [file for setup in setups.values() for file in setup.file_modes], campaign)
    repeatability = campaign.repeatability or 0.0
    return MeasuredRecord(
        record,
        joined_setups(modes, record.pose, repeatability, log) if modes else [],
        [
            _joined(frequency, by_setup, record, campaign, log)
            for frequency, by_setup in added.items()
            if modes
        ],
        [faulty for setup in setups.values() for faulty in setup.left_out],
        [setup.inspection for setup in setups.values() if setup.inspection is not None],
        repeats,
        places,
        log,
    )


def _joined(
    frequency: float,
    by_setup: Mapping[str, ModeEstimate | str],
    record: Record,
    campaign: Campaign,
    log: list[str],
) -> ModeEstimate:
    """Join a mode that the user adds over the setups in which it was found."""
    fitted = {setup: [mode] for setup, mode in by_setup.items() if not isinstance(mode, str)}
    if not fitted:
        reason = next(reason for reason in by_setup.values() if isinstance(reason, str))
        refuse_added(frequency, f"{reason} ({record.pose})", campaign.source)
    modes = joined_setups(fitted, record.pose, campaign.repeatability or 0.0, log)
    return min(modes, key=lambda mode: abs(mode.frequency - frequency))
