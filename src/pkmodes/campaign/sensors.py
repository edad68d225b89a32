"""Sensors and forces of a campaign: which component of a mode shape each one shows."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.campaign.description import ForceTable, RecordTable, SensorTable, quantity
from pkmodes.campaign.motion import Motion, motion, motion_of_voltage
from pkmodes.campaign.mounts import DISPLACEMENT, ORIGIN, ROTATION, Mount, Platform, Vector, along
from pkmodes.core.base.errors import MeasurementError, nearest, shown
from pkmodes.response.directions import unit_direction
from pkmodes.signals.functions import WORDS, Function, Kind, computed
from pkmodes.support.ordering import joined

#: Channel of a sensor that helps to find modes but is in no shape.
NONE = "none"
#: The kind of records of modes that another program has identified.
IDENTIFIED = "modes"
EXAMPLE_OF_AT = 'at = ["0 mm", "40 mm", "-5 mm"]'
#: A degree of freedom of a universal file along a negative direction, perhaps with its number in the file.
NEGATIVE = re.compile(r"[0-9]+:-R?[XYZ](?:#[0-9]+)?")


@dataclass(frozen=True)
class Place:
    """Where something acts or is measured.

    Attributes
    ----------
    name : str
        As in the files.
    setup : str or None
        The only setup in which it holds; None for all.
    weights : mapping of str to float
        What it shows of the channels: one channel, or a unit direction of the platform; empty for none.
    mount : Mount or None
        How it is fixed to a platform that turns; `weights` are then those where it is not turned.
    """

    name: str
    setup: str | None
    weights: Mapping[str, float]
    mount: Mount | None = field(default=None, kw_only=True)

    def where_turned(self, R: NDArray[np.float64]) -> Self:
        """Return it as it is where the platform's rotation is R, (3, 3)."""
        return self if self.mount is None else replace(self, weights=self.mount.weights(R))

    @property
    def key(self) -> str:
        """A name that no other sensor of the campaign has."""
        return self.name if self.setup is None else f"{self.name} of {self.setup}"


@dataclass(frozen=True)
class Sensor(Place):
    """A sensor.

    Attributes
    ----------
    motion : Motion or None
        What its numbers are; None if the files say it.
    """

    motion: Motion | None


def sensors_of(
    given: Sequence[SensorTable],
    known: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    source: str,
) -> tuple[Sensor, ...]:
    """Check the sensors of a campaign.

    Parameters
    ----------
    known : mapping of str to str
        Channels and their units, "" where it may be a length or an angle.
    platform : Platform
    setups : collection of str
        Setups of the records.

    Raises
    ------
    MeasurementError
        For the first one that is wrong.
    """
    found = []
    for i, one in enumerate(given, start=1):
        where = f"{source}: sensor.{i}"
        of = _motion(one, where)
        place = _place(one, known, platform, setups, where, angular=of is not None and of.angular)
        if of is not None:
            check_motion(of, place, known, f"{where}.unit")
        found.append(Sensor(place.name, place.setup, place.weights, of, mount=place.mount))
    _check_names(found, f"{source}: sensor")
    return tuple(found)


def forces_of(
    given: Sequence[ForceTable],
    known: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    source: str,
) -> tuple[Place, ...]:
    """Check the forces of a campaign: see `sensors_of`."""
    found = [
        _place(one, known, platform, setups, f"{source}: force.{i}") for i, one in enumerate(given, start=1)
    ]
    _check_names(found, f"{source}: force")
    return tuple(found)


def names_of(given: RecordTable, sensors: Sequence[SensorTable], where: str) -> dict[str, str]:
    """Check what the files of a record call time, frequency, force and the sensors.

    Raises
    ------
    MeasurementError
        If a name is none of these, one of theirs has two, or the record is one of identified modes.
    """
    known = [*WORDS, *dict.fromkeys(sensor.name for sensor in sensors)]
    for name in given.names:
        if name not in known:
            what = f"expected time, frequency, force or a sensor of the campaign, found {shown(name)}"
            raise MeasurementError(what, f"{where}.names", nearest(name, known))
    if given.names and given.kind == IDENTIFIED:
        what = f"expected a record of signals with names, found the kind {shown(given.kind)}"
        raise MeasurementError(what, f"{where}.names", 'for tables of modes: columns = { frequency = "f0" }')
    theirs = list(given.names.values())
    twice = next((name for i, name in enumerate(theirs) if name in theirs[:i]), None)
    if twice is not None:
        what = f"{shown(twice)} is given two names"
        raise MeasurementError(what, f"{where}.names", "each column of the files is one signal")
    return given.names


def _place(
    given: SensorTable | ForceTable,
    known: Mapping[str, str],
    platform: Platform,
    setups: Collection[str],
    where: str,
    *,
    angular: bool = False,
) -> Place:
    if not given.name:
        raise MeasurementError("expected a name, found none", f"{where}.name", "give its name in the files")
    if given.setup is not None and given.setup not in setups:
        what = f"no record has the setup {shown(given.setup)}"
        known_setups = [name for name in setups if name]
        remedy = (
            nearest(given.setup, known_setups) if known_setups else "leave it out: files are a plain list"
        )
        raise MeasurementError(what, f"{where}.setup", remedy)
    if (given.channel is None) == (given.direction is None):
        found = "both" if given.channel is not None else "neither"
        what = f"expected either a channel or a direction, found {found}"
        remedy = f'for example: channel = "{next(iter(known), NONE)}", or direction = [0.6, 0.8, 0]'
        raise MeasurementError(what, where, remedy)
    if given.direction is not None:
        unit = _direction(given.direction, platform, f"{where}.direction", angular=angular)
        at = _at(given, f"{where}.at")
        if platform.rotations:
            mount = Mount(along(platform.directions, unit), True, at, angular, platform)
            return _mounted(given, mount)
        weights = {
            f"{DISPLACEMENT}{name}": one for name, one in zip(platform.directions, unit, strict=True) if one
        }
        return Place(given.name, given.setup, weights)
    channel, sign = str(given.channel), 1.0
    if channel not in known and channel != NONE and channel.startswith("-"):
        channel, sign = channel[1:].lstrip(), -1.0
    if channel not in known and channel != NONE:
        raise MeasurementError(
            f"unknown channel {shown(channel)}", f"{where}.channel", nearest(channel, known)
        )
    if given.at is not None and channel not in platform.components:
        what = f"the channel {shown(channel)} is no motion of a platform, and has no place on one"
        raise MeasurementError(
            what, f"{where}.at", "leave it out, or give a direction or a channel of the platform"
        )
    at = _at(given, f"{where}.at")
    if platform.rotations and channel in platform.components:
        axis = along([channel[len(ROTATION) :]], [sign])
        return _mounted(given, Mount(axis, False, at, channel.startswith(ROTATION), platform))
    return Place(given.name, given.setup, {} if channel == NONE else {channel: sign})


def _mounted(given: SensorTable | ForceTable, mount: Mount) -> Place:
    return Place(given.name, given.setup, mount.weights(np.eye(3)), mount=mount)


def _at(given: SensorTable | ForceTable, where: str) -> Vector:
    """Return where on the platform something is [m], its origin by default."""
    if given.at is None:
        return ORIGIN
    if len(given.at) != len(ORIGIN):
        what = f"expected three lengths, along x, y, z of the platform, found {len(given.at)}"
        raise MeasurementError(what, where, f"for example: {EXAMPLE_OF_AT}")
    x, y, z = (quantity(one, "m", where) for one in given.at)
    return x, y, z


def _direction(given: Sequence[float], platform: Platform, where: str, *, angular: bool) -> list[float]:
    """Return a unit vector along the directions of a platform."""
    if not platform.directions:
        what = "only a robot's platform has directions"
        raise MeasurementError(
            what, where, "give a channel, with a minus before it if against its direction; or the robot file"
        )
    if angular and platform.rotations and platform.rotations != platform.directions:
        turns = joined([f"{ROTATION}{axis}" for axis in platform.rotations])
        what = f"expected a channel of a sensor of rotation, found a direction along {', '.join(platform.directions)}"
        raise MeasurementError(what, where, f"the platform turns by {turns} only: give that as its channel")
    return [float(one) for one in unit_direction(given, platform.directions, where, MeasurementError)]


def _motion(given: SensorTable, where: str) -> Motion | None:
    if given.sensitivity is not None:
        if given.unit != "V":
            what = f'expected unit = "V" beside a sensitivity, found {shown(given.unit)}'
            raise MeasurementError(
                what, f"{where}.unit", "give the unit of the numbers, or leave the sensitivity out"
            )
        return motion_of_voltage(given.sensitivity, f"{where}.sensitivity")
    if given.unit is None:
        return None
    if given.unit == "V":
        what = "expected a sensitivity beside volts, found none"
        raise MeasurementError(what, where, 'for example: sensitivity = "100 mV/g0"')
    return motion(given.unit, f"{where}.unit")


def check_motion(found: Motion, place: Place, known: Mapping[str, str], where: str) -> None:
    """Refuse a linear motion of an angle, and an angular one of a length.

    Raises
    ------
    MeasurementError
    """
    for channel in place.weights if place.mount is None else place.mount.shows:
        unit = known[channel]
        if unit and (unit == "rad") != found.angular:
            kind = "an angular" if found.angular else "a linear"
            remedy = f"{channel} is {'an angle' if unit == 'rad' else 'a length'}: give such a unit"
            if found.angular and place.mount is not None and place.mount.turns:
                remedy = f"write unit = {shown(found.unit)} in the campaign: its direction is then an axis"
            raise MeasurementError(f"{channel} cannot have {kind} motion", where, remedy)


def _check_names(found: Sequence[Place], where: str) -> None:
    for i, place in enumerate(found):
        for other in found[:i]:
            if place.name == other.name and (
                place.setup == other.setup or None in (place.setup, other.setup)
            ):
                what = f"the name {shown(place.name)} occurs twice in one setup"
                raise MeasurementError(
                    what, f"{where}.{i + 1}.name", "each column of the files is one sensor"
                )


def signed(one: Function) -> Function:
    """Return a function along the positive directions of its degrees of freedom; a coherence has no sign."""
    negative = [end for end in (one.response, one.reference) if NEGATIVE.fullmatch(end)]
    has_sign = one.kind in (Kind.FRF, Kind.TIME)
    return computed(one, np.negative) if has_sign and len(negative) == 1 else one


def unsigned(name: str) -> str:
    """Return the name of a degree of freedom without its sign, which is only a name."""
    return name.replace(":+", ":").replace(":-", ":")
