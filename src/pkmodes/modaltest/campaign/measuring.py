"""The modes of a record over its files: repeats are averaged, setups joined."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

from pkmodes.core.base.errors import MeasurementError
from pkmodes.core.support.numbers import plain
from pkmodes.modaltest.campaign.averaging import Mean, averaged
from pkmodes.modaltest.campaign.boards import UnknownOffsetError
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.copies import copied_repeats
from pkmodes.modaltest.campaign.edits import added_group, check_asked, refuse_added
from pkmodes.modaltest.campaign.found import FileModes, Found
from pkmodes.modaltest.campaign.grouping import grouped
from pkmodes.modaltest.campaign.inspection import Inspection, Repeats, inspection
from pkmodes.modaltest.campaign.joining import joined_setups
from pkmodes.modaltest.campaign.kinds import RecordKind
from pkmodes.modaltest.campaign.missing import Places, lacking, places_in, unnamed
from pkmodes.modaltest.campaign.results import LeftOut
from pkmodes.modaltest.campaign.roving import RovingPoint, change_of, points_of
from pkmodes.modaltest.campaign.roving_functions import ApartError
from pkmodes.modaltest.identification.asked import NEAR

#: Least share of the repeats in which a mode must be found.
OFTEN = 0.5


@dataclass(frozen=True, eq=False)
class MeasuredRecord:
    """The modes of a record over its repeats and setups, before they are edited.

    - means, added: the modes found, and those that the user adds, in the order of the requested frequencies
    - inspections: of the first file of each setup, if requested
    - places: the files of each setup, each with whether it has the sensors and forces that it should have
    """

    record: Record
    means: Sequence[Mean]
    added: Sequence[Mean]
    left_out: Sequence[LeftOut]
    messages: Sequence[str]
    inspections: Sequence[Inspection]
    repeats: Sequence[Repeats]
    places: Sequence[Sequence[tuple[Path, Places]]]


@dataclass(frozen=True, eq=False)
class _Setup:
    """The readable files of a setup, messages about them, and those left out; `places` as in `MeasuredRecord`."""

    names: Sequence[str]
    file_modes: Sequence[FileModes]
    messages: Sequence[str]
    left_out: Sequence[LeftOut]
    inspection: Inspection | None
    places: Sequence[Sequence[tuple[Path, Places]]] = ()


def measured(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool = False
) -> MeasuredRecord:
    """Return the modes of a record.

    - keep_going: whether faulty files are left out instead of refused
    - inspect: whether the parts of the fits that a report draws are kept

    Raises MeasurementError if a file is faulty, or a mode that the user requests cannot be added.
    """
    try:
        return _measured(record, kind, campaign, keep_going, inspect)
    except UnknownOffsetError as error:
        separate = _measured(replace(record, clocks={}), kind, campaign, keep_going, inspect)
        message = f"{record.pose}: each board is identified alone, with no phase between them: {error}"
        return replace(separate, messages=[message, *separate.messages])


def _measured(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool
) -> MeasuredRecord:
    edits = campaign.asked(record)
    check_asked(edits, record, kind, campaign.source)
    setups = _setups(record, kind, campaign, keep_going, inspect)
    means: dict[str, list[Mean]] = {}
    added: dict[float, dict[str, Mean | str]] = {frequency: {} for frequency in edits.add}
    messages = copied_repeats(record)
    repeats: list[Repeats] = []
    for name, setup in setups.items():
        messages += setup.messages
        if not setup.file_modes:
            continue
        groups = _groups(setup)
        added_groups: dict[float, dict[int, Found]] = {}
        for i, frequency in enumerate(edits.add):
            group = added_group([file.added[i] for file in setup.file_modes], frequency, _least(setup))
            if isinstance(group, str):
                added[frequency][name] = group
            else:
                added_groups[frequency] = group
        averages = averaged([*groups, *added_groups.values()])
        means[name] = averages[: len(groups)]
        for frequency, mean in zip(added_groups, averages[len(groups) :], strict=True):
            added[frequency][name] = mean
        repeats.append(
            Repeats(name, tuple(setup.names), tuple(map(_frequencies, [*groups, *added_groups.values()])))
        )
    joint_means, notes = joined_setups(means, campaign.repeatability or 0.0) if means else ([], [])
    further = [
        _joined(frequency, by_setup, record, campaign, notes)
        for frequency, by_setup in added.items()
        if means
    ]
    places = [files for setup in setups.values() for files in setup.places]
    file_modes = [file for setup in setups.values() for file in setup.file_modes]
    messages += [
        *_single(record, setups),
        *lacking(record.pose, places),
        *unnamed(record.pose, file_modes, campaign),
    ]
    all_messages = [*messages, *(f"{record.pose}: {note}" for note in notes)]
    left_out = [faulty for setup in setups.values() for faulty in setup.left_out]
    inspections = [setup.inspection for setup in setups.values() if setup.inspection is not None]
    return MeasuredRecord(record, joint_means, further, left_out, all_messages, inspections, repeats, places)


def _setups(
    record: Record, kind: RecordKind, campaign: Campaign, keep_going: bool, inspect: bool
) -> dict[str, _Setup]:
    """Return the setups of a record; those of a roving hammer are merged into one."""
    setups = {}
    for name, paths in record.separate.items():
        files = {str(path): partial(_find, path, record, name, kind, campaign) for path in paths}
        setup = _read(name, files, record, campaign, keep_going, inspect)
        left_out = {faulty.file for faulty in setup.left_out}
        read = [path for path in paths if str(path) not in left_out]
        has = [places_in(file.names_in_file, record, name, kind, campaign) for file in setup.file_modes]
        setups[name] = replace(setup, places=[list(zip(read, has, strict=True))])
    if kind.roving is None:
        return setups
    return _together(setups, kind.roving, record, campaign, keep_going, inspect)


def _together(
    setups: dict[str, _Setup],
    roving: Callable[[Mapping[str, RovingPoint], Record, Campaign], FileModes],
    record: Record,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
) -> dict[str, _Setup]:
    """Return the setups of a roving hammer as one, fitted together; other setups are returned unchanged."""
    files = _files(setups)
    points = points_of(files, campaign)
    if not points:
        return setups
    change = change_of({name: averaged(_groups(setups[name])) for name in files})
    apart = plain(100.0 * change.apart, 2)
    differ = f"{record.pose}: the frequencies differ by {apart} % between the points that were hit"
    if change.apart > change.allowed:
        return _with_message(setups, f"{differ}: each point is fitted by itself")
    runs = {
        f"{record.pose}, file {i} of each setup": partial(
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
    try:
        joint = _read("", runs, record, campaign, keep_going, inspect)
    except ApartError as error:
        return _with_message(setups, f"{record.pose}: each point is fitted by itself: {error}")
    noted = [f"{differ}: half of it is in sigma"] if change.apart > (campaign.repeatability or 0.0) else []
    noted += _unused(record.pose, files, points)
    merged = replace(
        joint,
        file_modes=[file.changed(change.on) for file in joint.file_modes],
        messages=[*noted, *joint.messages],
        left_out=[faulty for setup in (*setups.values(), joint) for faulty in setup.left_out],
        places=[files for setup in setups.values() for files in setup.places],
    )
    return {"": merged}


def _files(setups: Mapping[str, _Setup]) -> dict[str, dict[Path, FileModes]]:
    """Return the modes of each file, for the setups with any readable file."""
    return {
        name: {path: file for (path, _), file in zip(setup.places[0], setup.file_modes, strict=True)}
        for name, setup in setups.items()
        if setup.file_modes
    }


def _with_message(setups: Mapping[str, _Setup], message: str) -> dict[str, _Setup]:
    """Return setups with a message put before the others."""
    first = next(iter(setups))
    return {**setups, first: replace(setups[first], messages=[message, *setups[first].messages])}


def _unused(
    pose: str, files: Mapping[str, Mapping[Path, FileModes]], points: Sequence[Mapping[str, Path]]
) -> list[str]:
    """Name the surplus files of points that have more files than other points."""
    unused = [path.name for paths in files.values() for path in list(paths)[len(points) :]]
    few = "one file" if len(points) == 1 else f"{len(points)} files"
    return [f"{pose}: as some point has only {few}, not used: {', '.join(unused)}"] if unused else []


def _least(setup: _Setup) -> float:
    """Return the number of files of a setup in which a mode must be found."""
    return max(1.0, OFTEN * len(setup.file_modes))


def _groups(setup: _Setup) -> list[dict[int, Found]]:
    return [g for g in grouped([file.modes for file in setup.file_modes]) if len(g) >= _least(setup)]


def _read(
    setup: str,
    files: Mapping[str, Callable[[], FileModes]],
    record: Record,
    campaign: Campaign,
    keep_going: bool,
    inspect: bool,
) -> _Setup:
    """Return the modes in each readable file of a setup; `files` are the functions that read them, by name."""
    results: list[FileModes] = []
    read: list[str] = []
    left_out: list[LeftOut] = []
    messages: list[str] = []
    drawn: Inspection | None = None
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
        added = tuple(_added(candidate, record) for candidate in file_modes.added)
        modes = [*file_modes.modes, *(candidate for candidate in added if not isinstance(candidate, str))]
        messages += [*file_modes.messages, *_beside_tones(modes, name, campaign.tones)]
        inside = _in_band(file_modes.modes, record, name, messages)
        # The functions of a fit may be large.
        results.append(replace(file_modes, modes=tuple(inside), added=added, fit=None))
        read.append(Path(name).name)
    return _Setup(read, results, messages, left_out, drawn)


def _find(path: Path, record: Record, setup: str, kind: RecordKind, campaign: Campaign) -> FileModes:
    """Return the modes of a file of a setup, by the keys of its sensors and forces."""
    file_modes = kind.find(path, record, setup, campaign)
    return file_modes if kind.by_channel else file_modes.changed(lambda mode: _named(mode, setup, campaign))


def _added(candidate: Found | str, record: Record) -> Found | str:
    """Return a mode that the user adds, or why there is none in a file."""
    if isinstance(candidate, str):
        return candidate
    low, high = record.band
    return candidate if low <= candidate.frequency <= high else "its fit leaves the band"


def _single(record: Record, setups: Mapping[str, _Setup]) -> list[str]:
    """Report which setups have a single file."""
    single = [name for name, setup in setups.items() if len(setup.file_modes) == 1]
    of = f" of {'each setup' if len(single) == len(setups) else ', '.join(single)}" if len(setups) > 1 else ""
    return [f"{record.pose}: a single file{of}: the scatter of repeats is unknown"] if single else []


def _joined(
    frequency: float,
    by_setup: Mapping[str, Mean | str],
    record: Record,
    campaign: Campaign,
    notes: list[str],
) -> Mean:
    """Join a mode that the user adds over the setups in which it was found."""
    fitted = {setup: [outcome] for setup, outcome in by_setup.items() if not isinstance(outcome, str)}
    if not fitted:
        reasons = [outcome for outcome in by_setup.values() if isinstance(outcome, str)]
        refuse_added(frequency, f"{reasons[0]} ({record.pose})", campaign.source)
    means, joining_notes = joined_setups(fitted, campaign.repeatability or 0.0)
    notes += joining_notes
    return min(means, key=lambda mean: abs(mean.mode.frequency - frequency))


def _frequencies(group: Mapping[int, Found]) -> dict[int, float]:
    return {i: mode.frequency for i, mode in sorted(group.items())}


def _in_band(modes: Sequence[Found], record: Record, file: str, messages: list[str]) -> list[Found]:
    low, high = record.band
    inside = [mode for mode in modes if low <= mode.frequency <= high]
    if len(inside) < len(modes):
        outside = ", ".join(f"{mode.frequency:.4g}" for mode in modes if mode not in inside)
        messages.append(f"{file}: outside the band, left out: {outside} Hz")
    return inside


def _beside_tones(modes: Sequence[Found], file: str, tones: Sequence[float]) -> list[str]:
    """Name the modes that lie beside a stated tone or one of its multiples."""
    sentences = []
    for mode in modes:
        for tone in tones:
            multiple = max(1, round(mode.frequency / tone))
            if abs(mode.frequency / (multiple * tone) - 1.0) <= NEAR:
                sentences.append(
                    f"{file}: the mode at {mode.frequency:.4g} Hz lies beside the tone at {multiple * tone:.4g} Hz"
                )
    return sentences


def _named(mode: Found, setup: str, campaign: Campaign) -> Found:
    """Return a mode by the keys of its sensors and forces, which are unique where they belong to a single setup."""
    places = {**campaign.forces_in(setup), **campaign.sensors_in(setup)}
    names = {name: place.key for name, place in places.items()}
    return replace(
        mode,
        shape={names.get(name, name): value for name, value in mode.shape.items()},
        participation={names.get(name, name): value for name, value in mode.participation.items()},
    )
