"""Sensors and forces of a campaign: which component of a mode shape each one measures."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import MeasurementError, nearest_name, shown
from pkmodes.core.mechanism.directions import unit_direction
from pkmodes.core.support.ordering import joined
from pkmodes.modaltest.campaign.description import ForceTable, RecordTable, SensorTable, parse_quantity
from pkmodes.modaltest.campaign.motion import Motion, motion_of_voltage, parse_motion
from pkmodes.modaltest.campaign.mounts import (
    DISPLACEMENT,
    ORIGIN,
    ROTATION,
    Mount,
    Platform,
    Vector,
    vector_along,
)
from pkmodes.modaltest.signals.functions import RESERVED_NAMES, Function, FunctionKind, derived_function

#: Channel of a sensor that helps to find modes but appears in no shape.
NO_CHANNEL = "none"
#: Kind of record with modes that another program has identified.
MODES_KIND = "modes"
EXAMPLE_OF_AT = 'at = ["0 mm", "40 mm", "-5 mm"]'
#: A degree of freedom of a universal file along a negative direction, perhaps with its number in the file.
NEGATIVE = re.compile(r"[0-9]+:-R?[XYZ](?:#[0-9]+)?")


@dataclass(frozen=True)
class Transducer:
    """A place where a force acts or a sensor measures.

    - name: as in the files
    - setup: the only setup to which it applies; None for all
    - weights: contribution of each channel: one channel, or a unit direction of the platform; empty for none
    - mount: how it is fixed to a turning platform; `weights` are then those of the unrotated platform
    """

    name: str
    setup: str | None
    weights: Mapping[str, float]
    mount: Mount | None = field(default=None, kw_only=True)

    def rotated(self, R: NDArray[np.float64]) -> Self:
        """Return it at the rotation R of the platform, (3, 3)."""
        return self if self.mount is None else replace(self, weights=self.mount.motion_weights(R))

    @property
    def key(self) -> str:
        """A name that no other sensor of the campaign has."""
        return self.name if self.setup is None else f"{self.name} of {self.setup}"


@dataclass(frozen=True)
class MotionSensor(Transducer):
    """A sensor.

    - motion: the motion that its numbers represent; None if the files state it
    """

    motion: Motion | None


@dataclass(frozen=True)
class Force(Transducer):
    """A force.

    - fixed: whether it stays at its place, which then gives no component of a shape; else a hammer roves
    """

    fixed: bool


def check_sensors(
    tables: Sequence[SensorTable],
    channel_units: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    source: str,
) -> tuple[MotionSensor, ...]:
    """Check the sensors of a campaign.

    - channel_units: channels and their units, "" where it may be a length or an angle
    - setups: setups of the records

    Raises MeasurementError for the first sensor that is wrong.
    """
    sensors = []
    for i, table in enumerate(tables, start=1):
        where = f"{source}: sensor.{i}"
        motion = _sensor_motion(table, where)
        transducer = _transducer(
            table, channel_units, platform, setups, where, angular=motion is not None and motion.angular
        )
        if motion is not None:
            check_motion(motion, transducer, channel_units, f"{where}.unit")
        sensors.append(
            MotionSensor(
                transducer.name, transducer.setup, transducer.weights, motion, mount=transducer.mount
            )
        )
    _check_names(sensors, f"{source}: sensor")
    return tuple(sensors)


def check_forces(
    tables: Sequence[ForceTable],
    channel_units: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    source: str,
) -> tuple[Force, ...]:
    """Check the forces of a campaign: see `check_sensors`."""
    forces = []
    for i, table in enumerate(tables, start=1):
        transducer = _transducer(table, channel_units, platform, setups, f"{source}: force.{i}")
        forces.append(
            Force(transducer.name, transducer.setup, transducer.weights, table.fixed, mount=transducer.mount)
        )
    _check_names(forces, f"{source}: force")
    return tuple(forces)


def check_names_in_files(table: RecordTable, sensors: Sequence[SensorTable], where: str) -> dict[str, str]:
    """Check the names by which the files of a record call time, frequency, force and the sensors.

    Raises MeasurementError if a name is none of these, a name in the files is used twice, or the record is one of
    identified modes.
    """
    known_names = [*RESERVED_NAMES, *dict.fromkeys(sensor.name for sensor in sensors)]
    for name in table.names:
        if name not in known_names:
            problem = f"expected time, frequency, force or a sensor of the campaign, found {shown(name)}"
            raise MeasurementError(problem, f"{where}.names", nearest_name(name, known_names))
    if table.names and table.kind == MODES_KIND:
        problem = f"expected a record of signals with names, found the kind {shown(table.kind)}"
        raise MeasurementError(
            problem, f"{where}.names", 'for tables of modes: columns = { frequency = "f0" }'
        )
    file_names = list(table.names.values())
    duplicate = next((name for i, name in enumerate(file_names) if name in file_names[:i]), None)
    if duplicate is not None:
        problem = f"{shown(duplicate)} is given two names"
        raise MeasurementError(problem, f"{where}.names", "each column of the files is one signal")
    return table.names


def _transducer(
    table: SensorTable | ForceTable,
    channel_units: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    where: str,
    *,
    angular: bool = False,
) -> Transducer:
    if not table.name:
        raise MeasurementError("expected a name, found none", f"{where}.name", "give its name in the files")
    if table.setup is not None and table.setup not in setups:
        problem = f"no record has the setup {shown(table.setup)}"
        known_setups = [name for name in setups if name]
        remedy = (
            nearest_name(table.setup, known_setups)
            if known_setups
            else "leave it out: files are a plain list"
        )
        raise MeasurementError(problem, f"{where}.setup", remedy)
    if (table.channel is None) == (table.direction is None):
        stated = "both" if table.channel is not None else "neither"
        problem = f"expected either a channel or a direction, found {stated}"
        remedy = (
            f'for example: channel = "{next(iter(channel_units), NO_CHANNEL)}", or direction = [0.6, 0.8, 0]'
        )
        raise MeasurementError(problem, where, remedy)
    if table.direction is not None:
        unit = _direction(table.direction, platform, f"{where}.direction", angular=angular)
        position = _position(table, f"{where}.at")
        if platform.rotations:
            mount = Mount(vector_along(platform.directions, unit), True, position, angular, platform)
            return _mounted_transducer(table, mount)
        weights = {
            f"{DISPLACEMENT}{name}": component
            for name, component in zip(platform.directions, unit, strict=True)
            if component
        }
        return Transducer(table.name, table.setup, weights)
    channel, sign = str(table.channel), 1.0
    if channel not in channel_units and channel != NO_CHANNEL and channel.startswith("-"):
        channel, sign = channel[1:].lstrip(), -1.0
    if channel not in channel_units and channel != NO_CHANNEL:
        raise MeasurementError(
            f"unknown channel {shown(channel)}", f"{where}.channel", nearest_name(channel, channel_units)
        )
    if table.at is not None and channel not in platform.components:
        problem = f"the channel {shown(channel)} is not a motion of a platform, and has no place on one"
        raise MeasurementError(
            problem, f"{where}.at", "leave it out, or give a direction or a channel of the platform"
        )
    position = _position(table, f"{where}.at")
    if platform.rotations and channel in platform.components:
        axis = vector_along([channel[len(ROTATION) :]], [sign])
        return _mounted_transducer(
            table, Mount(axis, False, position, channel.startswith(ROTATION), platform)
        )
    return Transducer(table.name, table.setup, {} if channel == NO_CHANNEL else {channel: sign})


def _mounted_transducer(table: SensorTable | ForceTable, mount: Mount) -> Transducer:
    return Transducer(table.name, table.setup, mount.motion_weights(np.eye(3)), mount=mount)


def _position(table: SensorTable | ForceTable, where: str) -> Vector:
    """Return the place on the platform [m], its origin by default."""
    if table.at is None:
        return ORIGIN
    if len(table.at) != len(ORIGIN):
        problem = f"expected three lengths, along x, y, z of the platform, found {len(table.at)}"
        raise MeasurementError(problem, where, f"for example: {EXAMPLE_OF_AT}")
    x, y, z = (parse_quantity(coordinate, "m", where) for coordinate in table.at)
    return x, y, z


def _direction(vector: Sequence[float], platform: Platform, where: str, *, angular: bool) -> list[float]:
    """Return a unit vector along the directions of a platform."""
    if not platform.directions:
        problem = "only a robot's platform has directions"
        raise MeasurementError(
            problem,
            where,
            "give a channel, with a minus before it if against its direction; or the robot file",
        )
    if angular and platform.rotations and platform.rotations != platform.directions:
        rotation_names = joined([f"{ROTATION}{axis}" for axis in platform.rotations])
        problem = "expected a channel of a sensor of rotation, found a direction along "
        problem += ", ".join(platform.directions)
        raise MeasurementError(
            problem, where, f"the platform turns by {rotation_names} only: give that as its channel"
        )
    return [
        float(component) for component in unit_direction(vector, platform.directions, where, MeasurementError)
    ]


def _sensor_motion(table: SensorTable, where: str) -> Motion | None:
    if table.sensitivity is not None:
        if table.unit != "V":
            problem = f'expected unit = "V" beside a sensitivity, found {shown(table.unit)}'
            raise MeasurementError(
                problem, f"{where}.unit", "give the unit of the numbers, or leave the sensitivity out"
            )
        return motion_of_voltage(table.sensitivity, f"{where}.sensitivity")
    if table.unit is None:
        return None
    if table.unit == "V":
        problem = "expected a sensitivity beside volts, found none"
        raise MeasurementError(problem, where, 'for example: sensitivity = "100 mV/g0"')
    return parse_motion(table.unit, f"{where}.unit")


def check_motion(
    measured: Motion, transducer: Transducer, channel_units: Mapping[str, str], where: str
) -> None:
    """Refuse a linear motion for an angle, and an angular one for a length.

    Raises MeasurementError.
    """
    for channel in transducer.weights if transducer.mount is None else transducer.mount.sensed_components:
        unit = channel_units[channel]
        if unit and (unit == "rad") != measured.angular:
            kind = "an angular" if measured.angular else "a linear"
            remedy = f"{channel} is {'an angle' if unit == 'rad' else 'a length'}: give such a unit"
            if measured.angular and transducer.mount is not None and transducer.mount.turns_with_platform:
                remedy = f"write unit = {shown(measured.unit)} in the campaign: its direction is then an axis"
            raise MeasurementError(f"{channel} cannot have {kind} motion", where, remedy)


def _check_names(transducers: Sequence[Transducer], where: str) -> None:
    for i, transducer in enumerate(transducers):
        for earlier in transducers[:i]:
            if transducer.name == earlier.name and (
                transducer.setup == earlier.setup or None in (transducer.setup, earlier.setup)
            ):
                problem = f"the name {shown(transducer.name)} occurs twice in one setup"
                raise MeasurementError(
                    problem, f"{where}.{i + 1}.name", "each column of the files is one sensor"
                )


def apply_sign(function: Function) -> Function:
    """Return a function along the positive directions of its degrees of freedom; a coherence has no sign."""
    negative = [end for end in (function.response, function.reference) if NEGATIVE.fullmatch(end)]
    has_sign = function.kind in (FunctionKind.FRF, FunctionKind.TIME)
    return derived_function(function, np.negative) if has_sign and len(negative) == 1 else function


def without_sign(name: str) -> str:
    """Return the name of a degree of freedom without its sign."""
    return name.replace(":+", ":").replace(":-", ":")
