"""The quantities that are evaluated at poses: one table, from which results, maps, tables and JSON follow.

A further quantity is an entry of `FIELDS`, whose function says how it follows from others.  What it `needs` are
fields, or quantities of `pkmodes.solve.at_poses.RobotAtPoses`, such as ``eigenvalues`` or ``mass_matrix``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from pkmodes.dataset.motion import in_plane, out_of_plane
from pkmodes.linalg.eigen import natural_frequencies
from pkmodes.mechanism.registry import Mechanism

Array = NDArray[Any]
#: Axes after those of the poses.  In maps, modes are those of vibration, and independent coordinates are entries of
#: the axis of all coordinates.
MODE, DIRECTION, COORDINATE, DRIVE, INDEPENDENT = "mode", "direction", "coordinate", "drive", "independent"
NORMALISED = "mass-normalised, phi^T M phi = 1: displacements in 1/sqrt(kg), rotations in 1/(sqrt(kg) m)"
PER_MODE = "of the platform in each vibration mode"


@dataclass(frozen=True, kw_only=True)
class Field:
    """A quantity that is evaluated at poses.

    Attributes
    ----------
    name : str
        In `pkmodes.Modes` and the arguments ``fields`` and ``out``, if it is one of the results there.
    dims : tuple of str
        Axes after those of the poses.
    needs : tuple of str
        The quantities of which it is a function.
    of : callable
        From their values at N poses, its values, (N, ...).
    in_modes : bool
        Whether `pkmodes.Modes` has it.
    variable : str
        Its name in maps, datasets and tables; empty if it is in none.
    key : str
        Its name in the JSON of ``pkmodes modes``; empty if it is not there.
    key_text : str
        What it is, for the JSON Schema.
    units : str or callable
        In maps; of a mechanism.
    text : str
        What it is, for maps; {plane}, {normal} and {independent} are replaced.
    symbol : str
        Heading in the table of a notebook, followed by the number of the mode; empty if it has no columns there.
    with_shapes : bool
        Whether maps keep it only on request, with the mode shapes.
    same_as : str
        Another field whose values it has, for mechanisms whose independent coordinates have its name.
    """

    name: str
    dims: tuple[str, ...]
    needs: tuple[str, ...]
    of: Callable[..., Array]
    in_modes: bool = True
    variable: str = ""
    key: str = ""
    key_text: str = ""
    units: str | Callable[[Mechanism], str] = "1"
    text: str = ""
    comment: str = ""
    symbol: str = ""
    dtype: str = "f8"
    with_shapes: bool = False
    same_as: str = ""

    def is_of(self, mechanism: Mechanism) -> bool:
        """Return whether results of a mechanism have it."""
        return not self.same_as or mechanism.independent_are.replace(" ", "_") == self.name

    @property
    def heading(self) -> str:
        """Heading of its columns in reports, for a field with the same units for all mechanisms."""
        return f"{self.symbol} [{self.units}]"

    def units_of(self, mechanism: Mechanism) -> str:
        """Return its units for a mechanism."""
        return self.units if isinstance(self.units, str) else self.units(mechanism)


def _itself(values: Array) -> Array:
    return values


def _platform_shapes(shapes: Array, platform_motion: Array) -> Array:
    return np.asarray(shapes @ np.swapaxes(platform_motion, -1, -2))


def condition_number(jacobians: Array) -> Array:
    """Return the ratio of the largest to the smallest singular value of matrices, (N, d, k)."""
    singular = np.linalg.svd(jacobians, compute_uv=False)
    with np.errstate(divide="ignore"):
        return np.asarray(singular[..., 0] / singular[..., -1])


def _unit_of_joints(mechanism: Mechanism) -> str:
    units = {q.unit for q in mechanism.coordinates if q.name in mechanism.independent}
    return units.pop() if len(units) == 1 else "1"


FIELDS: dict[str, Field] = {
    field.name: field
    for field in (
        Field(
            name="frequencies",
            dims=(MODE,),
            needs=("eigenvalues",),
            of=natural_frequencies,
            variable="frequency",
            key="frequencies_hz",
            key_text="sqrt(|lambda|) / (2 pi) with the sign of lambda [Hz], ascending, the rigid-body ones "
            "first; m of them.",
            units="Hz",
            text="natural frequency",
            comment="sqrt(abs(lambda))/(2 pi) with the sign of lambda",
            symbol="f",
        ),
        Field(
            name="shapes",
            dims=(MODE, COORDINATE),
            needs=("shapes",),
            of=_itself,
            variable="shape",
            key="shapes",
            key_text="One list of n components for each mode, mass-normalised: phi^T M phi = 1 in SI units.",
            text="mode shape",
            comment=NORMALISED,
            with_shapes=True,
        ),
        Field(
            name="platform_shapes",
            dims=(MODE, DIRECTION),
            needs=("shapes", "platform_motion"),
            of=_platform_shapes,
            variable="platform_shape",
            key="platform_shapes",
            key_text="For each mode the motion of the platform centre along the linear components of the "
            "pose, with the scale of the shape.",
            text=f"motion {PER_MODE}",
            comment=NORMALISED,
        ),
        Field(
            name="in_plane",
            dims=(MODE,),
            needs=("platform_shapes", "directions", "normal"),
            of=in_plane,
            in_modes=False,
            variable="in_plane",
            text=f"motion {PER_MODE}, magnitude in {{plane}}",
            comment=NORMALISED,
        ),
        Field(
            name="out_of_plane",
            dims=(MODE,),
            needs=("platform_shapes", "directions", "normal"),
            of=out_of_plane,
            in_modes=False,
            variable="out_of_plane",
            text=f"motion {PER_MODE}, magnitude in {{normal}}",
            comment=NORMALISED,
        ),
        Field(
            name="joint_positions",
            dims=(INDEPENDENT,),
            needs=("joint_positions",),
            of=_itself,
            variable="joint_position",
            key="joint_positions",
            key_text="The independent coordinates at the pose, by name, in SI units.",
            units=_unit_of_joints,
            text="{independent} at the pose",
        ),
        Field(
            name="carriage_positions",
            dims=(INDEPENDENT,),
            needs=("joint_positions",),
            of=_itself,
            key="carriage_positions",
            key_text="The same as joint_positions in a list, for a robot with carriages [m].",
            same_as="joint_positions",
        ),
        Field(
            name="mass_matrix",
            dims=(COORDINATE, COORDINATE),
            needs=("mass_matrix",),
            of=_itself,
            key="mass_matrix",
            key_text="n by n, SI units.",
        ),
        Field(
            name="stiffness_matrix",
            dims=(COORDINATE, COORDINATE),
            needs=("stiffness_matrix",),
            of=_itself,
            key="stiffness_matrix",
            key_text="n by n, SI units.",
        ),
        Field(
            name="static_torque",
            dims=(DRIVE,),
            needs=("static_torques",),
            of=_itself,
            in_modes=False,
            variable="static_torque",
            units=lambda mechanism: mechanism.drives[0].unit,
            text="torque that holds the pose against gravity",
        ),
        Field(
            name="condition",
            dims=(),
            needs=("platform_jacobian",),
            of=condition_number,
            in_modes=False,
            variable="condition",
            text="condition number of the platform Jacobian D_p",
        ),
    )
}


def of_modes(mechanism: Mechanism | None = None) -> tuple[str, ...]:
    """Return the names of the fields of `pkmodes.Modes`, or those that it has for a mechanism."""
    return tuple(
        name
        for name, field in FIELDS.items()
        if field.in_modes and (mechanism is None or field.is_of(mechanism))
    )


def of_maps(shapes: bool) -> tuple[Field, ...]:
    """Return the fields of maps, with or without those that are kept with the mode shapes, which come last."""
    listed = [field for field in FIELDS.values() if field.variable]
    return (
        *(field for field in listed if not field.with_shapes),
        *(field for field in listed if field.with_shapes and shapes),
    )


def missing(dtype: DTypeLike) -> float:
    """Return the value of fields of a type where a pose cannot be evaluated."""
    return -1 if np.dtype(dtype).kind == "i" else np.nan


def tail(field: Field, sizes: Mapping[str, int]) -> tuple[int, ...]:
    """Return the shape of a field at one pose."""
    return tuple(sizes[dim] for dim in field.dims)


def sizes_of(
    mechanism: Mechanism, modes: int, coordinates: int, independent: int | None = None
) -> dict[str, int]:
    """Return the lengths of the axes; those of independent coordinates by default without the other coordinates."""
    return {
        MODE: modes,
        COORDINATE: coordinates,
        DIRECTION: len(mechanism.directions),
        DRIVE: len(mechanism.drives),
        INDEPENDENT: len(mechanism.independent) if independent is None else independent,
    }
