"""The channels in which shapes of a robot are measured, and which of them are axes of one sensor.

A sensor may be mounted in another direction than the file states.
"""

from __future__ import annotations

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.loop.diagnosis.problem import Sensor


def channels(mechanism: Mechanism) -> dict[str, str]:
    """Return the shape components of a robot with their units: all coordinates, released or not, and the platform."""
    extended = mechanism.extended
    coordinates = dict(zip(extended.COORDINATES, extended.COORDINATE_UNITS, strict=True))
    return coordinates | {component.name: component.unit for component in mechanism.platform}


def sensors(mechanism: Mechanism) -> tuple[Sensor, ...]:
    """Return the sensors with several axes: on the platform, and on parts that an effect moves in all directions.

    One on the platform may measure displacements, another one rotations.
    The coordinates of such a part are those of one effect, one for each direction of the platform's motion, of the
    same unit and in the same order: the displacements of a frame.
    """
    axes = mechanism.directions
    components = tuple(component.name for component in mechanism.platform)
    platform_groups = (axes, components[: len(axes)]), (mechanism.rotations, components[len(axes) :])
    multi_axis = [
        Sensor(mechanism.moving_body(), channels, axis_names)
        for axis_names, channels in platform_groups
        if len(axis_names) > 1
    ]
    if len(axes) < 2:
        return tuple(multi_axis)
    for effect in mechanism.effects_in_order:
        names = tuple(coordinate.name for coordinate in effect.coordinates)
        stem = names[0].removesuffix(axes[0]) if names else ""
        same_unit = len({coordinate.unit for coordinate in effect.coordinates}) == 1
        if same_unit and names == tuple(f"{stem}{axis}" for axis in axes):
            multi_axis.append(Sensor("", names, axes))
    return tuple(multi_axis)
