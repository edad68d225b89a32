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
from pkmodes.modaltest.campaign.sensors import MotionSensor, Transducer, unsigned
from pkmodes.modaltest.signals.reading import read_signals

#: Whether a file has each place that it should have, a sensor or a force, by its label.
Places = Mapping[str, bool]
#: Most names in a file that an error shows.
MOST = 6


def places_in(
    names_in_file: frozenset[str] | None, record: Record, setup: str, kind: RecordKind, campaign: Campaign
) -> Places:
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
    return presence | {_label(force): unsigned(name) in names_in_file for name, force in forces.items()}


def _label(place: Transducer) -> str:
    return f"the {'sensor' if isinstance(place, MotionSensor) else 'force'} {shown(place.key)}"


def lacking(pose: str, setups: Sequence[Sequence[tuple[Path, Places]]]) -> list[str]:
    """Return messages about what the files of a record lack."""
    all_places = [places for files in setups for _, places in files]
    labels = list(dict.fromkeys(label for places in all_places for label in places))
    nowhere = [label for label in labels if not any(places.get(label) for places in all_places)]
    messages = [f"{pose}: none of its files has {joined(nowhere, 'or')} of the campaign"] if nowhere else []
    for files in setups:
        present = {label for _, places in files for label, has in places.items() if has}
        for path, places in files:
            absent = [label for label, has in places.items() if not has and label in present]
            messages += [f"{path}: it lacks {joined(absent)}, which its repeats have"] if absent else []
    return messages


def unnamed(pose: str, files: Sequence[FileModes], campaign: Campaign) -> list[str]:
    """Return a message about references that no force names, if a hammer may have roved over them."""
    names = list(dict.fromkeys(name for file in files for name in file.unnamed))
    sensors = {sensor.name for sensor in campaign.sensors} & {
        name for file in files for name in file.names_in_file or ()
    }
    if not names or not (campaign.forces or len(names) > len(sensors)):
        return []
    return [
        f"{pose}: no [[force]] names the references {', '.join(names)}: their shapes have the places of the sensors "
        "only; for a roving hammer, add [[force]] for each reference"
    ]


def refuse_missing(files: Sequence[tuple[Record, Path, Places]], campaign: Campaign) -> None:
    """Refuse a sensor or force that is in no file of the campaign.

    Raises MeasurementError with the names in the files of the first record that should have it.
    """
    places = {**_numbered("sensor", campaign.sensors), **_numbered("force", campaign.forces)}
    for where, place in places.items():
        label = _label(place)
        wanting = [(record, path) for record, path, has in files if label in has]
        if not wanting or any(has.get(label) for _, _, has in files):
            continue
        first = wanting[0][0]
        main_paths = [path for record, path in wanting if record is first]
        beside = [path for main_path in main_paths for path in first.beside(main_path).values()]
        paths = first.setups[place.setup] if place.setup is not None else [*main_paths, *beside]
        of_sensors = isinstance(place, MotionSensor)
        names = list(dict.fromkeys(name for path in paths for name in _names(path, first, of_sensors)))
        listing = listed([shown(name) for name in names], MOST) or "none"
        new = [name for name in names if name not in {place.name for place in places.values()}]
        problem = f"expected {label} in a file, found {listing} in those of {first.pose}"
        remedy = nearest_name(place.name, new, "correct the name, or remove it from the campaign")
        if not names and not of_sensors:
            remedy = (
                "these files do not name their force: give each [[force]] the setup in which it acts alone"
            )
        raise MeasurementError(problem, f"{campaign.source}: {where}.name", remedy)


def _numbered(kind: str, places: Sequence[Transducer]) -> dict[str, Transducer]:
    return {f"{kind}.{i}": place for i, place in enumerate(places, start=1)}


def _names(path: Path, record: Record, sensors: bool) -> Iterator[str]:
    """Yield the names of the sensors in a file, or of the forces and references."""
    read = read_signals(path, signal_request(record))
    for function in read.functions:
        name = function.response if sensors or function.force else function.reference
        if name and not (sensors and function.force):
            yield name
    yield from (name for mode in read.modes for name in mode.shape if sensors)
