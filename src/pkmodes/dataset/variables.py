"""The variables of a map: dimensions, units and descriptions."""

from __future__ import annotations

from dataclasses import dataclass

from pkmodes.mechanism.registry import Mechanism

#: The axis of poses that are not on a grid.
LIST = "pose"
MODE, DIRECTION, COORDINATE, DRIVE = "mode", "direction", "coordinate", "drive"
NORMALISED = "mass-normalised, phi^T M phi = 1: displacements in 1/sqrt(kg), rotations in 1/(sqrt(kg) m)"
#: Marks of a mode at a pose, for any step to a neighbour, as bits.
EVENTS = {"crossing": 1, "veering": 2, "uncertain": 4}
#: Mode numbers start at the first vibration mode.
FIRST = 1


@dataclass(frozen=True)
class Variable:
    """A variable of the dataset.

    Attributes
    ----------
    name : str
    dims : tuple of str
        After those of the poses.
    units, long_name, comment : str
    """

    name: str
    dims: tuple[str, ...]
    units: str
    long_name: str
    comment: str = ""

    @property
    def attributes(self) -> dict[str, str]:
        """Its attributes in the dataset."""
        found = {"units": self.units, "long_name": self.long_name}
        return {**found, "comment": self.comment} if self.comment else found


def variables(mechanism: Mechanism, normal: str | None, shapes: bool, tracked: bool) -> tuple[Variable, ...]:
    """Return the variables of a map.

    Parameters
    ----------
    mechanism : Mechanism
    normal : str or None
        Direction perpendicular to the plane of the grid.
    shapes, tracked : bool
        Whether shapes are kept, and modes tracked.
    """
    units = {q.name: q.unit for q in mechanism.coordinates}
    of_joints = {units[name] for name in mechanism.independent}
    plane = " and ".join(name for name in mechanism.directions if name != normal)
    per_mode = "of the platform in each vibration mode"
    found = [
        Variable(
            "frequency",
            (MODE,),
            "Hz",
            "natural frequency",
            "sqrt(abs(lambda))/(2 pi) with the sign of lambda",
        ),
        Variable("platform_shape", (MODE, DIRECTION), "1", f"motion {per_mode}", NORMALISED),
        Variable("in_plane", (MODE,), "1", f"motion {per_mode}, magnitude in {plane}", NORMALISED),
        Variable(
            "out_of_plane",
            (MODE,),
            "1",
            f"motion {per_mode}, magnitude in {normal or 'no other direction'}",
            NORMALISED,
        ),
        Variable(
            "joint_position",
            (COORDINATE,),
            of_joints.pop() if len(of_joints) == 1 else "1",
            f"{mechanism.independent_are} at the pose",
            "NaN for coordinates that do not follow from the pose" if shapes else "",
        ),
        Variable(
            "static_torque", (DRIVE,), mechanism.drives[0].unit, "torque that holds the pose against gravity"
        ),
        Variable("condition", (), "1", "condition number of the platform Jacobian D_p"),
        Variable("valid", (), "1", "whether the pose could be evaluated"),
        Variable("reason", (), "1", "why the pose could not be evaluated, empty where it could"),
    ]
    if shapes:
        found.append(Variable("shape", (MODE, COORDINATE), "1", "mode shape", NORMALISED))
    if tracked:
        found += [
            Variable(
                "rank", (MODE,), "1", "place of the tracked mode among the vibration modes, by frequency"
            ),
            Variable("tracking", (MODE,), "1", "events between this pose and its neighbours in the map"),
        ]
    return tuple(found)
