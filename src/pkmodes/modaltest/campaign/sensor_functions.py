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

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.base.numbers import plain
from pkmodes.core.robot.units import MAX_MAGNITUDE, MIN_MAGNITUDE
from pkmodes.modaltest.campaign.campaign import Record
from pkmodes.modaltest.campaign.motion import Motion, motion_or_none, parse_motion
from pkmodes.modaltest.campaign.sensors import MotionSensor, apply_sign, check_motion
from pkmodes.modaltest.signals.functions import Function, FunctionKind, SignalFile, SignalRequest
from pkmodes.modaltest.signals.reading import read_signals

#: All sensors are converted to accelerations, which most of them measure.
ACCELERATION = 2
#: Units whose factors differ by less are the same: files round them.
UNIT_TOLERANCE = 1e-3
#: The content that a file should have, and its abscissa, in words.
CONTENT_WORDS = {
    FunctionKind.FRF: ("frequency response functions", "frequencies"),
    FunctionKind.TIME: ("signals in time", "times"),
    FunctionKind.SPECTRUM: ("power spectra", "frequencies"),
}


@dataclass(frozen=True, eq=False)
class SensorFunctions:
    """The functions of one kind that a campaign's sensors have in a file.

    - file: with all of the file's functions that the campaign names
    - used: functions of the sensors, all with the same abscissa
    """

    file: SignalFile
    used: tuple[Function, ...]


def signal_request(record: Record, names: frozenset[str] | None = None) -> SignalRequest:
    """Return the request for a file of a record: the functions of some sensors, all by default."""
    blows = record.kind == "impact"
    return SignalRequest(record.rate, names, record.header, record.band, names=record.names, force=blows)


def sensor_functions(
    path: Path, kind: FunctionKind, names: frozenset[str], record: Record, *, signs: bool = False
) -> SensorFunctions:
    """Read the functions of the named sensors.

    - names: names as in the file; all if it is empty and the kind needs no sensors
    - record: record to which the file belongs: its band, outside of which functions of frequency may have gaps, its
      sampling rate, and the names of a table's columns
    - signs: whether the sign in the name of a degree of freedom counts

    Raises MeasurementError if the file is faulty or has none of them, or their times or frequencies differ.
    """
    request = signal_request(record, names or None)
    file = read_signals(path, request)
    if signs:
        file = replace(file, functions=tuple(map(apply_sign, file.functions)))
    of_kind = [function for function in file.functions if function.kind is kind and not function.force]
    used = [
        function
        for function in of_kind
        if function.response in names or (not names and kind is FunctionKind.SPECTRUM)
    ]
    if not used:
        _refuse_unknown_names(path, kind, names, replace(request, sensors=None))
    for function in used:
        if not np.array_equal(function.abscissa, used[0].abscissa):
            name, first = shown(function.response), shown(used[0].response)
            problem = f"the {CONTENT_WORDS[kind][1]} of {name} differ from those of {first}"
            raise MeasurementError(problem, file.source, "measure all functions of a file together")
    return SensorFunctions(file, tuple(used))


def _refuse_unknown_names(
    path: Path, kind: FunctionKind, names: frozenset[str], request: SignalRequest
) -> None:
    """Refuse a file without the campaign's sensors, listing what it has instead."""
    file = read_signals(path, request)
    available = list(
        dict.fromkeys(
            function.response for function in file.functions if function.kind is kind and not function.force
        )
    )
    if not available:
        problem = f"expected {CONTENT_WORDS[kind][0]}, found {len(file.functions)} other functions"
        problem += f"; skipped: {'; '.join(file.skipped)}" if file.skipped else ""
        raise MeasurementError(
            problem, file.source, "choose another kind of record, or export other functions"
        )
    problem = f"expected a sensor of the campaign, found {', '.join(map(shown, available[:6]))}"
    remedy = f"add [[sensor]] for each measured direction, named as in the file: name = {shown(available[0])}"
    remedy = nearest_name(available[0], names, remedy) if names else remedy
    raise MeasurementError(problem, file.source, remedy)


def refuse_repeated(name: str, subject: str, source: str) -> NoReturn:
    """Refuse a name that occurs several times in a file; the campaign may choose one of them by number."""
    remedy = f"if one of them counts, choose it by its number in the file, name = {shown(f'{name}#2')}"
    raise MeasurementError(f"{subject} occurs twice", source, f"{remedy}; give repeats as files of their own")


def motion_of(function: Function, sensor: MotionSensor, channels: Mapping[str, str], source: str) -> Motion:
    """Return the motion that a function measures: as the campaign declares, else by the unit in the file.

    Raises MeasurementError if neither states it, if they contradict each other, or it does not suit the sensor's
    channels.
    """
    where = f"{source}: {function.response}"
    if sensor.motion is None and function.unit is None:
        problem = "expected the unit of the sensor, found none in the file"
        raise MeasurementError(problem, where, 'give it in the campaign: unit = "m/s^2"')
    measured = sensor.motion or parse_motion(str(function.unit), where)
    check_motion(measured, sensor, channels, where)
    declared, unit = sensor.motion, function.unit
    if declared is None or unit is None:
        return measured
    file_motion = motion_or_none(unit)
    if declared.from_volts and not function.unit_assumed:
        agree = unit == "V"
    elif file_motion is None:
        agree = False
    else:
        # A type without a unit is "acceleration" even for a rotation.
        same_kind = file_motion.derivative == declared.derivative and (
            function.unit_assumed or file_motion.angular == declared.angular
        )
        agree = same_kind and (
            function.unit_assumed or math.isclose(file_motion.factor, declared.factor, rel_tol=UNIT_TOLERANCE)
        )
    if not agree:
        problem = f"the campaign says {shown(declared.unit)} of this sensor, and the file {shown(unit)}"
        raise MeasurementError(problem, where, "correct the campaign, or leave the unit out of it")
    return measured


def check_size(values: NDArray[Any], source: str) -> None:
    """Refuse numbers outside any machine's range: their squares would overflow.

    Raises MeasurementError.
    """
    size = float(np.nanmax(np.abs(values), initial=0.0))
    if size > 0.0 and not MIN_MAGNITUDE <= size <= MAX_MAGNITUDE:
        problem = f"expected numbers in SI units of moderate size, found up to {plain(size, 3)}"
        raise MeasurementError(problem, source, "check the units of the sensors")


def dead_channel_messages(names: Sequence[str], source: str) -> list[str]:
    """Return a message for each sensor without a signal."""
    return [
        f"{source}: {name} shows nothing: all its values are equal; this file gives no shape component of it"
        for name in names
    ]


@contextmanager
def errors_in_file(source: str) -> Iterator[None]:
    """Name the file in the errors of an identification."""
    try:
        yield
    except MeasurementError as error:
        raise MeasurementError(error.what, f"{source}: {error.where}", error.remedy) from None
