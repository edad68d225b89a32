"""The channels in which shapes of a robot are measured, and which of them are axes of one sensor.

A sensor may be mounted in another direction than the file says.
"""

from __future__ import annotations

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.diagnosis.problem import Sensor

#: Prefix of the channels of the platform's absolute motion.
PLATFORM = "p_"


def channels(mechanism: Mechanism) -> dict[str, str]:
    """Return the shape components of a robot with their units: all coordinates, released or not, and the platform."""
    units = {component.name: component.unit for component in mechanism.pose}
    extended = mechanism.extended
    coordinates = dict(zip(extended.COORDINATES, extended.COORDINATE_UNITS, strict=True))
    return coordinates | {f"{PLATFORM}{name}": units[name] for name in mechanism.directions}


def sensors(mechanism: Mechanism) -> tuple[Sensor, ...]:
    """Return the sensors with several axes: on the platform, and on parts that an effect moves in all directions.

    The coordinates of such a part are those of one effect, one for each direction of the platform's motion, of the
    same unit and in the same order: the displacements of a frame.
    """
    axes = mechanism.directions
    if len(axes) < 2:
        return ()
    units = {component.name: component.unit for component in mechanism.pose}
    found = []
    if len({units[axis] for axis in axes}) == 1:
        place = mechanism.pose_is.partition(" in ")[0].removesuffix(" centre")
        found.append(Sensor(place, tuple(f"{PLATFORM}{axis}" for axis in axes), axes))
    for effect in mechanism.effects_in_order:
        names = tuple(coordinate.name for coordinate in effect.coordinates)
        stem = names[0].removesuffix(axes[0]) if names else ""
        alike = len({coordinate.unit for coordinate in effect.coordinates}) == 1
        if alike and names == tuple(f"{stem}{axis}" for axis in axes):
            found.append(Sensor("", names, axes))
    return tuple(found)
