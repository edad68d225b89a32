"""The variables of a map: dimensions, units and descriptions."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.solve.fields import (
    COORDINATE,
    DIRECTION,
    INDEPENDENT,
    LINEAR,
    MODE,
    SHAPES,
    Field,
    map_fields,
)

#: The axis of poses that are not on a grid.
POSE_AXIS = "pose"
#: Flags of a mode at a pose, for steps to any neighbour, as bits.
EVENT_FLAGS = {"crossing": 1, "veering": 2, "uncertain": 4}
#: Mode numbers start at the first vibration mode.
FIRST_MODE = 1
#: The axis of a map on which the values along an axis of a field are entries.
MAP_AXES = {INDEPENDENT: COORDINATE, LINEAR: DIRECTION}


@dataclass(frozen=True)
class DatasetVariable:
    """A variable of the dataset.

    - dims: after those of the poses
    """

    name: str
    dims: tuple[str, ...]
    units: str
    long_name: str
    comment: str = ""

    @property
    def attributes(self) -> dict[str, str]:
        """Its attributes in the dataset."""
        attributes = {"units": self.units, "long_name": self.long_name}
        return {**attributes, "comment": self.comment} if self.comment else attributes


#: Variables on which poses could be evaluated, and those of tracked modes.
POSE_VARIABLES = (
    DatasetVariable("valid", (), "1", "whether the pose could be evaluated"),
    DatasetVariable("reason", (), "1", "why the pose could not be evaluated, empty where it could"),
)
TRACKING_VARIABLES = (
    DatasetVariable(
        "rank", (MODE,), "1", "place of the tracked mode among the vibration modes, by frequency"
    ),
    DatasetVariable("tracking", (MODE,), "1", "events between this pose and its neighbours in the map"),
)


def variables(
    mechanism: Mechanism, normal: str | None, conditions: frozenset[str], tracked: bool
) -> tuple[DatasetVariable, ...]:
    """Return the variables of a map.

    - normal: direction perpendicular to the plane of the grid
    - conditions: from `pkmodes.core.solve.fields.conditions_of`
    - tracked: whether modes are tracked
    """
    of_all, of_shapes = list[DatasetVariable](), list[DatasetVariable]()
    for field in map_fields(conditions):
        comment = field.comment
        if SHAPES in conditions and INDEPENDENT in field.dims:
            comment = "NaN for coordinates that do not follow from the pose"
        if mechanism.rotations and LINEAR in field.dims:
            comment = f"{comment}; NaN for rotations"
        text = field.text.format(
            plane=" and ".join(name for name in mechanism.directions if name != normal),
            normal=normal or "no other direction",
            independent=mechanism.independent_are,
            effort="force" if mechanism.drives[0].unit == "N" else "torque",
        )
        variable = DatasetVariable(field.variable, dims_of(field), field.units_of(mechanism), text, comment)
        (of_shapes if field.only == SHAPES else of_all).append(variable)
    return (*of_all, *POSE_VARIABLES, *of_shapes, *(TRACKING_VARIABLES if tracked else ()))


def dims_of_poses(axis_count: int) -> tuple[str, ...]:
    """Return the names of the axes of poses that are not on a grid: ``pose``, or ``pose_1``, ``pose_2``, ..."""
    return (POSE_AXIS,) if axis_count == 1 else tuple(f"{POSE_AXIS}_{i + 1}" for i in range(axis_count))


def dims_of(field: Field) -> tuple[str, ...]:
    """Return the axes of a field in a map, after those of the poses."""
    return tuple(MAP_AXES.get(dim, dim) for dim in field.dims)
