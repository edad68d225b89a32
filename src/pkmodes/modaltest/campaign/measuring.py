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
from pkmodes.modaltest.campaign.copies import copy_messages
from pkmodes.modaltest.campaign.edits import check_requests, refuse_request, select_requested
from pkmodes.modaltest.campaign.grouping import group_modes
from pkmodes.modaltest.campaign.inspection import Inspection, Repeats, inspect_fit
from pkmodes.modaltest.campaign.joining import join_setups
from pkmodes.modaltest.campaign.kinds import RecordKind
from pkmodes.modaltest.campaign.missing import Presence, missing_messages, presence_in_file, unnamed_messages
from pkmodes.modaltest.campaign.mode_estimates import FileModes, ModeEstimate
from pkmodes.modaltest.campaign.results import LeftOut
from pkmodes.modaltest.campaign.roving import RovingPoint, estimate_change, match_repeats
from pkmodes.modaltest.campaign.roving_functions import SeparateFitError
from pkmodes.modaltest.identification.requested_modes import SAME_MODE_TOLERANCE

#: Minimum share of the repeats in which a mode must be found.
MIN_REPEAT_SHARE = 0.5


@dataclass(frozen=True, eq=False)
class MeasuredRecord:
    """The modes of a record over its repeats and setups, before they are edited.

    - modes, added: the modes found, and those that the user adds, in the order of the requested frequencies
    - inspections: inspections of the first file of each setup, if requested
    - presence: the files of each setup, each with whether it has the sensors and forces that it should have
    - log: messages about the record; each step writes to it
    """

    record: Record
    modes: Sequence[ModeEstimate]
    added: Sequence[ModeEstimate]
    left_out: Sequence[LeftOut]
    inspections: Sequence[Inspection]
    repeats: Sequence[Repeats]
    presence: Sequence[Sequence[tuple[Path, Presence]]]
    log: list[str]


@dataclass(frozen=True, eq=False)
class _Setup:
    """The readable files of a setup, and those left out; `presence` as in `MeasuredRecord`."""

    names: Sequence[str]
    file_modes: Sequence[FileModes]
    left_out: Sequence[LeftOut]
    inspection: Inspection | None
    presence: Sequence[Sequence[tuple[Path, Presence]]] = ()

    @property
    def min_files(self) -> float:
        """Number of files in which a mode must be found."""
        return max(1.0, MIN_REPEAT_SHARE * len(self.file_modes))

    def groups(self) -> list[dict[int, ModeEstimate]]:
        """Return the modes that are found often enough, each by the files in which it was found."""
        groups = group_modes([file.modes for file in self.file_modes])
        return [group for group in groups if len(group) >= self.min_files]


def measure_record(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool = False
) -> MeasuredRecord:
    """Return the modes of a record.

    - keep_going: whether faulty files are left out instead of refused
    - inspect: whether the parts of the fits that a report draws are kept

    Raises MeasurementError if a file is faulty, or a mode that the user requests cannot be added.
    """
    check_requests(campaign.edits_of(record), record, kind, campaign.source)
    log = copy_messages(record)
    try:
        setups = _read_setups(record, kind, campaign, keep_going, inspect, log)
    except UnknownOffsetError as error:
        record = replace(record, clocks={})
        log.insert(0, f"{record.pose}: each board is identified alone, with no phase between them: {error}")
        setups = _read_setups(record, kind, campaign, keep_going, inspect, log)
    return _average_record(record, setups, campaign, log)


def _read_setups(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool, log: list[str]
) -> dict[str, _Setup]:
    """Read the files of a record, setup by setup; those of a roving hammer are merged into one setup.

    - log: unchanged if a file is refused, so that the record can be read in another way
    """
    setups, messages = dict[str, _Setup](), list[str]()
    for name, paths in record.independent_setups.items():
        files = {str(path): partial(_find_modes, path, record, name, kind, campaign) for path in paths}
        setup = _read_files(name, files, record, campaign, keep_going, inspect, messages)
        faulty_files = {faulty.file for faulty in setup.left_out}
        readable = [path for path in paths if str(path) not in faulty_files]
        presence = [
            presence_in_file(file.names_in_file, record, name, kind, campaign) for file in setup.file_modes
        ]
        setups[name] = replace(setup, presence=[list(zip(readable, presence, strict=True))])
    if kind.fit_roving is not None:
        setups = _merge_roving_setups(
            setups, kind.fit_roving, record, campaign, keep_going, inspect, messages
        )
    log += messages
    return setups


def _find_modes(path: Path, record: Record, setup: str, kind: RecordKind, campaign: Campaign) -> FileModes:
    """Return the modes of a file, by the keys of its sensors and forces, which are unique over all setups."""
    file_modes = kind.find_modes(path, record, setup, campaign).map_modes(
        lambda mode: replace(mode, lengths=campaign.lengths)
    )
    if kind.by_channel:
        return file_modes
    transducers = {**campaign.forces_in(setup), **campaign.sensors_in(setup)}
    keys = {name: transducer.key for name, transducer in transducers.items()}

    def by_key(components: Mapping[str, complex]) -> dict[str, complex]:
        return {keys.get(name, name): value for name, value in components.items()}

    return file_modes.map_modes(
        lambda mode: replace(mode, shape=by_key(mode.shape), participation=by_key(mode.participation))
    )


def _read_files(
    setup: str,
    files: Mapping[str, Callable[[], FileModes]],
    record: Record,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
    log: list[str],
) -> _Setup:
    """Return the modes in each readable file of a setup; `files` are the functions that read them, by name."""
    results, names, left_out = list[FileModes](), list[str](), list[LeftOut]()
    first_inspection: Inspection | None = None
    low, high = record.band
    for name, find_modes in files.items():
        try:
            file_modes = find_modes()
        except MeasurementError as error:
            if not keep_going:
                raise
            left_out.append(LeftOut(name, f"{error.what} ({error.where})"))
            continue
        if inspect and file_modes.fit is not None and not results:
            first_inspection = inspect_fit(setup, Path(name).name, len(files) - 1, file_modes.fit)
        added = tuple(
            candidate
            if isinstance(candidate, str) or low <= candidate.frequency <= high
            else "its fit leaves the band"
            for candidate in file_modes.added
        )
        modes = [*file_modes.modes, *(candidate for candidate in added if not isinstance(candidate, str))]
        tone_pairs = [
            (mode.frequency, max(1, round(mode.frequency / tone)) * tone)
            for mode in modes
            for tone in campaign.tones
        ]
        frequencies_outside = [
            mode.frequency for mode in file_modes.modes if not low <= mode.frequency <= high
        ]
        log += file_modes.messages
        log += [
            f"{name}: the mode at {frequency:.4g} Hz lies beside the tone at {multiple:.4g} Hz"
            for frequency, multiple in tone_pairs
            if abs(frequency / multiple - 1.0) <= SAME_MODE_TOLERANCE
        ]
        if frequencies_outside:
            listing = ", ".join(f"{frequency:.4g}" for frequency in frequencies_outside)
            log.append(f"{name}: outside the band, left out: {listing} Hz")
        in_band = tuple(mode for mode in file_modes.modes if low <= mode.frequency <= high)
        # The functions of a fit may be large.
        results.append(replace(file_modes, modes=in_band, added=added, fit=None))
        names.append(Path(name).name)
    return _Setup(names, results, left_out, first_inspection)


def _merge_roving_setups(
    setups: dict[str, _Setup],
    fit_roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes],
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
        name: {path: file for (path, _), file in zip(setup.presence[0], setup.file_modes, strict=True)}
        for name, setup in setups.items()
        if setup.file_modes
    }
    points = match_repeats(files, campaign)
    if not points:
        return setups
    change = estimate_change({name: mean_modes(setups[name].groups()) for name in files})
    difference = plain(100.0 * change.difference, 2)
    difference_message = (
        f"{record.pose}: the frequencies differ by {difference} % between the points that were hit"
    )
    if change.difference > change.allowed:
        messages.insert(0, f"{difference_message}: each point is fitted by itself")
        return setups
    readers = {
        f"{record.pose}, file {i} of each setup": partial(
            _fit_roving_together,
            fit_roving,
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
        [f"{difference_message}: half of it is in sigma"]
        if change.difference > (campaign.repeatability or 0.0)
        else []
    )
    surplus = [path.name for paths in files.values() for path in list(paths)[len(points) :]]
    if surplus:
        file_count = "one file" if len(points) == 1 else f"{len(points)} files"
        joint_messages.append(
            f"{record.pose}: not used, as some point has only {file_count}: {', '.join(surplus)}"
        )
    try:
        joint = _read_files("", readers, record, campaign, keep_going, inspect, joint_messages)
    except SeparateFitError as error:
        messages.insert(0, f"{record.pose}: each point is fitted by itself: {error}")
        return setups
    messages[:] = joint_messages
    merged = replace(
        joint,
        file_modes=[file.map_modes(change.add_to_sigma) for file in joint.file_modes],
        left_out=[faulty for setup in (*setups.values(), joint) for faulty in setup.left_out],
        presence=[files for setup in setups.values() for files in setup.presence],
    )
    return {"": merged}


def _fit_roving_together(
    fit_roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes],
    points: Mapping[str, RovingPoint],
    record: Record,
    campaign: Campaign,
) -> FileModes:
    """Return the modes of a roving hammer, fitted together."""
    return fit_roving(points, record, campaign).map_modes(
        lambda mode: replace(mode, lengths=campaign.lengths)
    )


def _average_record(
    record: Record, setups: Mapping[str, _Setup], campaign: Campaign, log: list[str]
) -> MeasuredRecord:
    """Average the modes of each setup over its repeats, and join the setups; likewise for modes that users add."""
    requested = campaign.edits_of(record).add
    modes: dict[str, list[ModeEstimate]] = {}
    added: dict[float, dict[str, ModeEstimate | str]] = {frequency: {} for frequency in requested}
    repeats: list[Repeats] = []
    for name, setup in setups.items():
        if not setup.file_modes:
            continue
        groups, added_groups = setup.groups(), dict[float, dict[int, ModeEstimate]]()
        for i, frequency in enumerate(requested):
            group = select_requested([file.added[i] for file in setup.file_modes], frequency, setup.min_files)
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
    unrepeated = [name for name, setup in setups.items() if len(setup.file_modes) == 1]
    if unrepeated:
        setup_names = "each setup" if len(unrepeated) == len(setups) else ", ".join(unrepeated)
        of_setups = f" of {setup_names}" if len(setups) > 1 else ""
        log.append(f"{record.pose}: a single file{of_setups}: the scatter of repeats is unknown")
    presence = [files for setup in setups.values() for files in setup.presence]
    log += missing_messages(record.pose, presence)
    log += unnamed_messages(
        record.pose, [file for setup in setups.values() for file in setup.file_modes], campaign
    )
    repeatability = campaign.repeatability or 0.0
    return MeasuredRecord(
        record,
        join_setups(modes, record.pose, repeatability, log) if modes else [],
        [
            _join_requested(frequency, by_setup, record, campaign, log)
            for frequency, by_setup in added.items()
            if modes
        ],
        [faulty for setup in setups.values() for faulty in setup.left_out],
        [setup.inspection for setup in setups.values() if setup.inspection is not None],
        repeats,
        presence,
        log,
    )


def _join_requested(
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
        refuse_request(frequency, f"{reason} ({record.pose})", campaign.source)
    modes = join_setups(fitted, record.pose, campaign.repeatability or 0.0, log)
    return min(modes, key=lambda mode: abs(mode.frequency - frequency))
