"""Sensors and forces of a campaign that its files lack.

A name found in no file at all is wrong, and is refused.  Names missing from only some files are reported.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.support.ordering import joined, listed
from pkmodes.modaltest.campaign.campaign import Campaign, Record
from pkmodes.modaltest.campaign.kinds import RecordKind
from pkmodes.modaltest.campaign.mode_estimates import FileModes
from pkmodes.modaltest.campaign.sensor_functions import signal_request
from pkmodes.modaltest.campaign.sensors import MotionSensor, Transducer, without_sign
from pkmodes.modaltest.signals.reading import read_signals

#: Whether a file has each place that it should have, a sensor or a force, by its label.
Presence = Mapping[str, bool]
#: Most names in a file that an error shows.
MAX_NAMES = 6


def presence_in_file(
    names_in_file: frozenset[str] | None, record: Record, setup: str, kind: RecordKind, campaign: Campaign
) -> Presence:
    """Return whether a file has the places that apply to its setup; empty for a file that needs none.

    - names_in_file: names in the file: `FileModes.names_in_file`
    """
    if names_in_file is None:
        return {}
    sensors, forces = campaign.sensors_in(setup), campaign.forces_in(setup) if kind.forces else {}
    presence = {_label(sensor): name in names_in_file for name, sensor in sensors.items()}
    presence |= {
        _label(sensor): sensor.key in names_in_file
        for sensor in campaign.sensors
        if sensor.setup in record.clocks
    }
    return presence | {_label(force): without_sign(name) in names_in_file for name, force in forces.items()}


def _label(transducer: Transducer) -> str:
    return f"the {'sensor' if isinstance(transducer, MotionSensor) else 'force'} {shown(transducer.key)}"


def missing_messages(pose: str, setups: Sequence[Sequence[tuple[Path, Presence]]]) -> list[str]:
    """Return messages about what the files of a record lack."""
    all_presence = [presence for files in setups for _, presence in files]
    labels = list(dict.fromkeys(label for presence in all_presence for label in presence))
    missing_everywhere = [
        label for label in labels if not any(presence.get(label) for presence in all_presence)
    ]
    messages = (
        [f"{pose}: none of its files has {joined(missing_everywhere, 'or')} of the campaign"]
        if missing_everywhere
        else []
    )
    for files in setups:
        present = {label for _, presence in files for label, is_present in presence.items() if is_present}
        for path, presence in files:
            absent = [label for label, is_present in presence.items() if not is_present and label in present]
            messages += [f"{path}: it lacks {joined(absent)}, which its repeats have"] if absent else []
    return messages


def unnamed_messages(pose: str, files: Sequence[FileModes], campaign: Campaign) -> list[str]:
    """Return a message about references that no force names, if a hammer may have roved over them."""
    fixed_names = {without_sign(force.name) for force in campaign.forces if force.fixed}
    all_names = dict.fromkeys(name for file in files for name in file.unnamed)
    names = [name for name in all_names if without_sign(name) not in fixed_names]
    sensors = {sensor.name for sensor in campaign.sensors} & {
        name for file in files for name in file.names_in_file or ()
    }
    roves = any(not force.fixed for force in campaign.forces)
    if not names or not (roves or len(names) > len(sensors)):
        return []
    return [
        f"{pose}: no [[force]] names the references {', '.join(names)}: their shapes have the places of the sensors "
        "only; for a roving hammer, add [[force]] for each reference"
    ]


def refuse_missing(files: Sequence[tuple[Record, Path, Presence]], campaign: Campaign) -> None:
    """Refuse a sensor or force that is in no file of the campaign.

    Raises MeasurementError with the names in the files of the first record that should have it.
    """
    transducers = {**_numbered("sensor", campaign.sensors), **_numbered("force", campaign.forces)}
    for where, transducer in transducers.items():
        label = _label(transducer)
        expecting = [(record, path) for record, path, presence in files if label in presence]
        if not expecting or any(presence.get(label) for _, _, presence in files):
            continue
        first = expecting[0][0]
        main_paths = [path for record, path in expecting if record is first]
        simultaneous_paths = [
            path for main_path in main_paths for path in first.simultaneous_files(main_path).values()
        ]
        paths = (
            first.setups[transducer.setup]
            if transducer.setup is not None
            else [*main_paths, *simultaneous_paths]
        )
        is_sensor = isinstance(transducer, MotionSensor)
        names = list(dict.fromkeys(name for path in paths for name in _names(path, first, is_sensor)))
        listing = listed([shown(name) for name in names], MAX_NAMES) or "none"
        unused_names = [
            name for name in names if name not in {transducer.name for transducer in transducers.values()}
        ]
        problem = f"expected {label} in a file, found {listing} in those of {first.pose}"
        remedy = nearest_name(
            transducer.name, unused_names, "correct the name, or remove it from the campaign"
        )
        if not names and not is_sensor:
            remedy = (
                "these files do not name their force: give each [[force]] the setup in which it acts alone"
            )
        raise MeasurementError(problem, f"{campaign.source}: {where}.name", remedy)


def _numbered(kind: str, transducers: Sequence[Transducer]) -> dict[str, Transducer]:
    return {f"{kind}.{i}": transducer for i, transducer in enumerate(transducers, start=1)}


def _names(path: Path, record: Record, sensors: bool) -> Iterator[str]:
    """Yield the names of the sensors in a file, or of the forces and references."""
    file = read_signals(path, signal_request(record))
    for function in file.functions:
        name = function.response if sensors or function.force else function.reference
        if name and not (sensors and function.force):
            yield name
    yield from (name for mode in file.modes for name in mode.shape if sensors)
