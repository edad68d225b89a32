"""Sensors and forces of a campaign: which component of a mode shape each one shows."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from pkmodes.campaign.description import ForceTable, SensorTable
from pkmodes.campaign.motion import Motion, motion, motion_of_voltage
from pkmodes.core.base.errors import MeasurementError, nearest, shown
from pkmodes.response.directions import unit_direction
from pkmodes.signals.functions import Function, Kind, computed

#: Channel of a sensor that helps to find modes but is in no shape.
NONE = "none"
PLATFORM = "p_"
#: The name of a degree of freedom of a universal file along a negative direction.
NEGATIVE = re.compile(r"[0-9]+:-R?[XYZ]")


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
    """

    name: str
    setup: str | None
    weights: Mapping[str, float]

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
    directions: Collection[str],
    setups: Collection[str],
    source: str,
) -> tuple[Sensor, ...]:
    """Check the sensors of a campaign.

    Parameters
    ----------
    known : mapping of str to str
        Channels and their units, "" where it may be a length or an angle.
    directions : collection of str
        Linear components of the pose.
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
        place = _place(one, known, directions, setups, where)
        found.append(Sensor(place.name, place.setup, place.weights, _motion(one, place, known, where)))
    _check_names(found, f"{source}: sensor")
    return tuple(found)


def forces_of(
    given: Sequence[ForceTable],
    known: Mapping[str, str],
    directions: Collection[str],
    setups: Collection[str],
    source: str,
) -> tuple[Place, ...]:
    """Check the forces of a campaign: see `sensors_of`."""
    found = [
        _place(one, known, directions, setups, f"{source}: force.{i}") for i, one in enumerate(given, start=1)
    ]
    _check_names(found, f"{source}: force")
    return tuple(found)


def _place(
    given: SensorTable | ForceTable,
    known: Mapping[str, str],
    directions: Collection[str],
    setups: Collection[str],
    where: str,
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
        return Place(given.name, given.setup, _direction(given.direction, directions, f"{where}.direction"))
    channel, sign = str(given.channel), 1.0
    if channel == NONE:
        return Place(given.name, given.setup, {})
    if channel not in known and channel.startswith("-"):
        channel, sign = channel[1:].lstrip(), -1.0
    if channel not in known:
        raise MeasurementError(
            f"unknown channel {shown(channel)}", f"{where}.channel", nearest(channel, known)
        )
    return Place(given.name, given.setup, {channel: sign})


def _direction(given: Sequence[float], directions: Collection[str], where: str) -> dict[str, float]:
    if not directions:
        what = "only a robot's platform has directions"
        raise MeasurementError(
            what, where, "give a channel, with a minus before it if against its direction; or the robot file"
        )
    unit = unit_direction(given, directions, where, MeasurementError)
    return {f"{PLATFORM}{name}": float(share) for name, share in zip(directions, unit, strict=True) if share}


def _motion(given: SensorTable, place: Place, known: Mapping[str, str], where: str) -> Motion | None:
    if given.sensitivity is not None:
        if given.unit != "V":
            what = f'expected unit = "V" beside a sensitivity, found {shown(given.unit)}'
            raise MeasurementError(
                what, f"{where}.unit", "give the unit of the numbers, or leave the sensitivity out"
            )
        found = motion_of_voltage(given.sensitivity, f"{where}.sensitivity")
    elif given.unit is None:
        return None
    elif given.unit == "V":
        what = "expected a sensitivity beside volts, found none"
        raise MeasurementError(what, where, 'for example: sensitivity = "100 mV/g0"')
    else:
        found = motion(given.unit, f"{where}.unit")
    check_motion(found, place, known, f"{where}.unit")
    return found


def check_motion(found: Motion, place: Place, known: Mapping[str, str], where: str) -> None:
    """Refuse a linear motion of an angle, and an angular one of a length.

    Raises
    ------
    MeasurementError
    """
    for channel in place.weights:
        unit = known[channel]
        if unit and (unit == "rad") != found.angular:
            kind = "an angular" if found.angular else "a linear"
            remedy = f"{channel} is {'an angle' if unit == 'rad' else 'a length'}: give such a unit"
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
