"""The functions of the campaign's sensors in a file: found by name, with one abscissa, in units of motion."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, NoReturn

import numpy as np
from numpy.typing import NDArray

from pkmodes.campaign.campaign import Record
from pkmodes.campaign.motion import Motion, motion, motion_or_none
from pkmodes.campaign.sensors import Sensor, check_motion, signed
from pkmodes.core.base.errors import MeasurementError, nearest, shown
from pkmodes.core.robot.units import LARGEST, SMALLEST
from pkmodes.signals.functions import Asked, Function, Kind, SignalFile
from pkmodes.signals.reading import read_signals

#: Sensors are brought to accelerations: what most of them measure.
ACCELERATION = 2
#: Units are the same whose factors differ by less: files round them.
SAME = 1e-3
#: What a file should have, and its abscissa, in words.
WORDS = {
    Kind.FRF: ("frequency response functions", "frequencies"),
    Kind.TIME: ("signals in time", "times"),
    Kind.SPECTRUM: ("power spectra", "frequencies"),
}


@dataclass(frozen=True, eq=False)
class SensorFunctions:
    """The functions of one kind that a campaign's sensors have in a file.

    Attributes
    ----------
    read : SignalFile
        With all of the file's functions that the campaign names.
    used : tuple of Function
        Those of the sensors, all with the same abscissa.
    """

    read: SignalFile
    used: tuple[Function, ...]


def asked_of(record: Record, names: frozenset[str] | None = None) -> Asked:
    """Return what is wanted of a file of a record: the functions of some sensors, all by default."""
    blows = record.kind == "impact"
    return Asked(record.rate, names, record.header, record.band, names=record.names, force=blows)


def sensor_functions(
    path: Path, kind: Kind, names: frozenset[str], record: Record, *, signs: bool = False
) -> SensorFunctions:
    """Read the functions of the sensors with some names.

    Parameters
    ----------
    names : frozenset of str
        As in the file; all if it is empty and the kind needs no sensors.
    record : Record
        To which the file belongs: its band, outside of which functions of frequency may have gaps, its sampling rate,
        and the names of a table's columns.
    signs : bool
        Whether the sign in the name of a degree of freedom counts.

    Raises
    ------
    MeasurementError
        If the file is faulty or has none of them, or their times or frequencies differ.
    """
    asked = asked_of(record, names or None)
    read = read_signals(path, asked)
    if signs:
        read = replace(read, functions=tuple(map(signed, read.functions)))
    of_kind = [one for one in read.functions if one.kind is kind and not one.force]
    used = [one for one in of_kind if one.response in names or (not names and kind is Kind.SPECTRUM)]
    if not used:
        _refuse_unknown_names(path, kind, names, replace(asked, sensors=None))
    for one in used:
        if not np.array_equal(one.abscissa, used[0].abscissa):
            what = f"the {WORDS[kind][1]} of {shown(one.response)} differ from those of {shown(used[0].response)}"
            raise MeasurementError(what, read.source, "measure all functions of a file together")
    return SensorFunctions(read, tuple(used))


def _refuse_unknown_names(path: Path, kind: Kind, names: frozenset[str], asked: Asked) -> None:
    """Say what a file has instead of the campaign's sensors."""
    read = read_signals(path, asked)
    found = list(dict.fromkeys(one.response for one in read.functions if one.kind is kind and not one.force))
    if not found:
        what = f"expected {WORDS[kind][0]}, found {len(read.functions)} other functions"
        what += f"; skipped: {'; '.join(read.skipped)}" if read.skipped else ""
        raise MeasurementError(what, read.source, "choose another kind of record, or export other functions")
    what = f"expected a sensor of the campaign, found {', '.join(map(shown, found[:6]))}"
    remedy = f"add [[sensor]] for each measured direction, named as in the file: name = {shown(found[0])}"
    remedy = nearest(found[0], names, remedy) if names else remedy
    raise MeasurementError(what, read.source, remedy)


def refuse_repeated(name: str, what: str, source: str) -> NoReturn:
    """Refuse what a file has several times under one name, of which the campaign may choose one."""
    remedy = f"if one of them counts, choose it by its number in the file, name = {shown(f'{name}#2')}"
    raise MeasurementError(f"{what} occurs twice", source, f"{remedy}; give repeats as files of their own")


def motion_of(one: Function, sensor: Sensor, channels: Mapping[str, str], source: str) -> Motion:
    """Return what the numbers of a function are: as the campaign says, else by the unit in the file.

    Raises
    ------
    MeasurementError
        If neither says it, if they contradict each other, or it is not a motion of the sensor's channels.
    """
    where = f"{source}: {one.response}"
    if sensor.motion is None and one.unit is None:
        what = "expected the unit of the sensor, found none in the file"
        raise MeasurementError(what, where, 'give it in the campaign: unit = "m/s^2"')
    found = sensor.motion or motion(str(one.unit), where)
    check_motion(found, sensor, channels, where)
    if sensor.motion is not None and one.unit is not None:
        _check_agrees(one, sensor.motion, where)
    return found


def _check_agrees(one: Function, said: Motion, where: str) -> None:
    """Refuse a unit in the file that is another one than that of the campaign."""
    unit = str(one.unit)
    of_file = motion_or_none(unit)
    if said.of_volts and not one.assumed:
        agree = unit == "V"
    elif of_file is None:
        agree = False
    else:
        # A type without a unit says "acceleration", of a rotation, too.
        alike = of_file.derivative == said.derivative and (one.assumed or of_file.angular == said.angular)
        agree = alike and (one.assumed or math.isclose(of_file.factor, said.factor, rel_tol=SAME))
    if not agree:
        what = f"the campaign says {shown(said.unit)} of this sensor, and the file {shown(unit)}"
        raise MeasurementError(what, where, "correct the campaign, or leave the unit out of it")


def check_size(values: NDArray[Any], source: str) -> None:
    """Refuse numbers that no machine has: their squares would overflow.

    Raises
    ------
    MeasurementError
    """
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if size > 0.0 and not SMALLEST <= size <= LARGEST:
        what = f"expected numbers in SI units of moderate size, found up to {size:.3g}"
        raise MeasurementError(what, source, "check the units of the sensors")


def dead_channels(names: Sequence[str], source: str) -> list[str]:
    """Return a sentence for each sensor that shows nothing."""
    return [
        f"{source}: {name} shows nothing: all its values are equal; this file gives no shape component of it"
        for name in names
    ]


@contextmanager
def in_file(source: str) -> Iterator[None]:
    """Name the file in the errors of an identification."""
    try:
        yield
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{source}: {error.where}", error.remedy) from None
