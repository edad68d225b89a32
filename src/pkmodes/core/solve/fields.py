"""The quantities that are evaluated at poses: one table, from which results, maps, tables and JSON follow.

A further quantity is an entry of `FIELDS`, whose function says how it follows from others.  What it `needs` are
fields, or quantities of `pkmodes.core.solve.at_poses.RobotAtPoses`, such as ``eigenvalues`` or ``mass_matrix``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from pkmodes.core.base.drives import HELD
from pkmodes.core.linalg.damping import damping_ratios
from pkmodes.core.linalg.eigen import natural_frequencies
from pkmodes.core.linalg.statics import softest_stiffness, step_amplitudes
from pkmodes.core.mechanism.registry import Mechanism
from pkmodes.core.robot.robot import Robot

Array = NDArray[Any]
#: Axes after those of the poses.  In maps, modes are those of vibration; independent coordinates are entries of the
#: axis of all coordinates, and linear directions of that of all components of the platform's motion.
MODE, DIRECTION, COORDINATE, DRIVE = "mode", "direction", "coordinate", "drive"
INDEPENDENT, DEPENDENT, LINEAR, COMPONENT = "independent", "dependent", "linear", "component"
BASE_COORDINATE = "base coordinate"
NORMALISED = "mass-normalised, phi^T M phi = 1: displacements in 1/sqrt(kg), rotations in 1/(sqrt(kg) m)"
PER_MODE = "of the platform in each vibration mode"
#: Conditions under which maps have a field: mode shapes are kept, a robot dissipates, the motors are held.
SHAPES, DISSIPATION = "shapes", "dissipation"
ALL_CONDITIONS = frozenset({SHAPES, DISSIPATION, HELD})


@dataclass(frozen=True, kw_only=True)
class Field:
    """A quantity that is evaluated at poses.

    - name: in `pkmodes.Modes` and the arguments ``fields`` and ``out``, if it is one of the results there
    - dims: axes after those of the poses
    - needs: the quantities of which it is a function
    - function: computes its values at N poses, (N, ...), from theirs; by default it returns those of the only one
    - in_modes: whether `pkmodes.Modes` has it
    - variable: its name in maps, datasets and tables; empty if it is in none
    - key: its name in the JSON of ``pkmodes modes``; empty if it is not there
    - key_text: its description in the JSON Schema
    - units: in maps; of a mechanism
    - text: its description in maps; {plane}, {normal}, {independent} and {effort} are replaced
    - symbol: heading in the table of a notebook, followed by the number of the mode; empty if it has no columns there
    - only: the condition under which maps have it (`conditions_of`): "shapes", "dissipation" or "held"; empty for
      always.  With ``"held"`` it is null in JSON where motors are free and no spring holds them.
    - signed: whether it changes its sign with the sign of the mode shape
    - nullable: whether its numbers may be null in JSON
    - same_as: another field whose values it has, for mechanisms whose independent coordinates have its name
    - fallback: its value if the condition `only` does not hold: nothing dissipates, or the motors are free; NaN for
      rigid modes
    - on_demand: whether results evaluate it only when it is read, unless it was asked for by name
    - read_with: another such field, usually read too: at a few poses, reading one of them evaluates both
    """

    name: str
    dims: tuple[str, ...]
    needs: tuple[str, ...]
    function: Callable[..., Array] = lambda values: values
    in_modes: bool = True
    variable: str = ""
    key: str = ""
    key_text: str = ""
    units: str | Callable[[Mechanism], str] = "1"
    text: str = ""
    comment: str = ""
    symbol: str = ""
    dtype: str = "f8"
    only: str = ""
    signed: bool = False
    same_as: str = ""
    nullable: bool = False
    fallback: float = np.nan
    on_demand: bool = False
    read_with: str = ""

    def applies_to(self, mechanism: Mechanism) -> bool:
        """Return whether results of a mechanism have it."""
        return not self.same_as or mechanism.independent_are.replace(" ", "_") == self.name

    @property
    def heading(self) -> str:
        """Heading of its columns in reports, for a field with the same units for all mechanisms."""
        return f"{self.symbol} [{self.units}]"

    def units_of(self, mechanism: Mechanism) -> str:
        """Return its units for a mechanism."""
        return self.units if isinstance(self.units, str) else self.units(mechanism)


def _damping_ratios(
    eigenvalues: Array, shapes: Array, dissipation: Any, points: Array, rigid_modes: int
) -> Array:
    viscous, loss = dissipation.matrices(points)
    return damping_ratios(eigenvalues, shapes, viscous, loss, dissipation.ratio, rigid_modes)


def _vibration_amplitudes(
    eigenvalues: Array,
    shapes: Array,
    platform_shapes: Array,
    mass_matrix: Array,
    elastic_stiffness: Array,
    platform_jacobian: Array,
    rigid_modes: int,
    strain_free_motions: Callable[[Array, Array], Array],
    directions: Sequence[str],
) -> Array:
    linear = slice(len(directions))
    momenta = mass_matrix @ strain_free_motions(elastic_stiffness, platform_jacobian)[..., linear]
    amplitudes = step_amplitudes(eigenvalues, shapes, platform_shapes[..., linear], momenta)
    amplitudes[:, :rigid_modes] = np.nan
    return amplitudes


def _softest_stiffness(
    stiffness_matrix: Array, platform_motion: Array, held_basis: Array | None, directions: Sequence[str]
) -> Array:
    if held_basis is None:
        return np.full(len(stiffness_matrix), np.nan)
    return softest_stiffness(
        held_basis.T @ stiffness_matrix @ held_basis, platform_motion[..., : len(directions), :] @ held_basis
    )


def _platform_shapes(shapes: Array, platform_motion: Array) -> Array:
    return np.asarray(shapes @ np.swapaxes(platform_motion, -1, -2))


def _in_plane(motion: Array, directions: Sequence[str], normal: str | None) -> Array:
    plane = [i for i, name in enumerate(directions) if name != normal]
    return np.asarray(np.sqrt((motion[..., plane] ** 2).sum(axis=-1)))


def _out_of_plane(motion: Array, directions: Sequence[str], normal: str | None) -> Array:
    if normal is None:  # a mechanism that moves in a plane
        return 0.0 * _in_plane(motion, directions, normal)
    return np.abs(motion[..., list(directions).index(normal)])


def condition_number(jacobians: Array, lengths: Array) -> Array:
    """Return the ratio of the largest to the smallest singular value of matrices, (N, d, k), rows times lengths."""
    singular = np.linalg.svd(jacobians * lengths[:, None], compute_uv=False)
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
            function=natural_frequencies,
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
            name="damping_ratios",
            dims=(MODE,),
            needs=("eigenvalues", "shapes", "dissipation", "points", "rigid_modes"),
            function=_damping_ratios,
            variable="damping_ratio",
            key="damping_ratios",
            key_text="Damping ratio of each mode, as for light damping; null for the rigid ones.",
            nullable=True,
            text="damping ratio",
            comment="as for light damping",
            only=DISSIPATION,
            fallback=0.0,
            on_demand=True,
        ),
        Field(
            name="shapes",
            dims=(MODE, COORDINATE),
            needs=("shapes",),
            variable="shape",
            key="shapes",
            key_text="One list of n components for each mode, mass-normalised: phi^T M phi = 1 in SI units.",
            text="mode shape",
            comment=NORMALISED,
            only=SHAPES,
            signed=True,
        ),
        Field(
            name="platform_shapes",
            dims=(MODE, DIRECTION),
            needs=("shapes", "platform_motion"),
            function=_platform_shapes,
            variable="platform_shape",
            key="platform_shapes",
            key_text="For each mode the motion of the platform centre along the linear components of the "
            "pose and, where the platform turns, its small rotations about base axes, with the scale of the shape.",
            text=f"motion {PER_MODE}",
            comment=NORMALISED,
            signed=True,
        ),
        Field(
            name="vibration_amplitudes",
            dims=(MODE, LINEAR),
            needs=(
                "eigenvalues",
                "shapes",
                "platform_shapes",
                "mass_matrix",
                "elastic_stiffness",
                "platform_jacobian",
                "rigid_modes",
                "strain_free_motions",
                "directions",
            ),
            function=_vibration_amplitudes,
            variable="vibration_amplitude",
            key="vibration_amplitudes",
            key_text="With held motors, or motors on springs (servo_stiffness): for each mode the amplitude with "
            "which the platform rings after a step of its acceleration along each linear component of the pose, per "
            "acceleration [s^2].",
            nullable=True,
            units="s^2",
            text="vibration of the platform in each mode after a step of its acceleration, per acceleration",
            comment="norm over all directions, for a step along each; where frequencies are equal, it depends on the "
            "shapes chosen for them",
            only=HELD,
            on_demand=True,
        ),
        Field(
            name="in_plane",
            dims=(MODE,),
            needs=("platform_shapes", "directions", "normal"),
            function=_in_plane,
            in_modes=False,
            variable="in_plane",
            text=f"motion {PER_MODE}, magnitude in {{plane}}",
            comment=NORMALISED,
        ),
        Field(
            name="out_of_plane",
            dims=(MODE,),
            needs=("platform_shapes", "directions", "normal"),
            function=_out_of_plane,
            in_modes=False,
            variable="out_of_plane",
            text=f"motion {PER_MODE}, magnitude in {{normal}}",
            comment=NORMALISED,
        ),
        Field(
            name="joint_positions",
            dims=(INDEPENDENT,),
            needs=("joint_positions",),
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
            key="carriage_positions",
            key_text="The same as joint_positions in a list, for a robot with carriages [m].",
            same_as="joint_positions",
        ),
        Field(
            name="mass_matrix",
            dims=(COORDINATE, COORDINATE),
            needs=("mass_matrix",),
            key="mass_matrix",
            key_text="n by n, SI units.",
            on_demand=True,
            read_with="stiffness_matrix",
        ),
        Field(
            name="stiffness_matrix",
            dims=(COORDINATE, COORDINATE),
            needs=("stiffness_matrix",),
            key="stiffness_matrix",
            key_text="n by n, SI units.",
            on_demand=True,
            read_with="mass_matrix",
        ),
        Field(
            name="platform_motion",
            dims=(DIRECTION, COORDINATE),
            needs=("platform_motion",),
            in_modes=False,
        ),
        Field(
            name="platform_jacobian",
            dims=(COMPONENT, INDEPENDENT),
            needs=("platform_jacobian",),
            in_modes=False,
        ),
        Field(
            name="elastic_stiffness",
            dims=(BASE_COORDINATE, BASE_COORDINATE),
            needs=("elastic_stiffness",),
            in_modes=False,
        ),
        Field(
            name="static_rotation",
            dims=(DEPENDENT,),
            needs=("static_rotation",),
            in_modes=False,
        ),
        Field(
            name="static_torque",
            dims=(DRIVE,),
            needs=("static_torque",),
            in_modes=False,
            variable="static_torque",
            units=lambda mechanism: mechanism.drives[0].unit,
            text="{effort} that holds the pose against gravity",
        ),
        Field(
            name="condition",
            dims=(),
            needs=("platform_jacobian", "lengths"),
            function=condition_number,
            in_modes=False,
            variable="condition",
            text="condition number of the platform Jacobian D_p",
        ),
        Field(
            name="softest_stiffness",
            dims=(),
            needs=("stiffness_matrix", "platform_motion", "held_basis", "directions"),
            function=_softest_stiffness,
            in_modes=False,
            variable="softest_stiffness",
            units="N/m",
            text="stiffness of the platform in the direction in which it is softest",
            comment="smallest eigenvalue of the inverse of the compliance, with held motors",
            only=HELD,
        ),
    )
}


def mode_fields(mechanism: Mechanism | None = None) -> tuple[str, ...]:
    """Return the names of the fields of `pkmodes.Modes`, or those that it has for a mechanism."""
    return tuple(
        name
        for name, field in FIELDS.items()
        if field.in_modes and (mechanism is None or field.applies_to(mechanism))
    )


def conditions_of(robots: Iterable[Robot], shapes: bool, drives: str) -> frozenset[str]:
    """Return which conditions hold, of those under which maps have a field.

    - robots: all of a map: a field of damping is there if any of them dissipates
    - shapes: whether mode shapes are kept
    - drives: what the motors do, "free" or "held"
    """
    holds = {SHAPES: shapes, DISSIPATION: any(robot.dissipates for robot in robots), HELD: drives == HELD}
    return frozenset(name for name, held in holds.items() if held)


def map_fields(conditions: frozenset[str]) -> tuple[Field, ...]:
    """Return the fields of maps where some conditions hold; those that are kept with the mode shapes come last."""
    present = [
        field for field in FIELDS.values() if field.variable and (not field.only or field.only in conditions)
    ]
    return tuple(sorted(present, key=lambda field: field.only == SHAPES))


def missing_value(dtype: DTypeLike) -> float:
    """Return the value of fields of a type where a pose cannot be evaluated."""
    return -1 if np.dtype(dtype).kind == "i" else np.nan


def pose_shape(field: Field, lengths: Mapping[str, int]) -> tuple[int, ...]:
    """Return the shape of a field at one pose."""
    return tuple(lengths[dim] for dim in field.dims)


def axis_lengths(
    mechanism: Mechanism, modes: int, coordinates: int, independent: int | None = None
) -> dict[str, int]:
    """Return the lengths of the axes; those of independent coordinates by default without the other coordinates."""
    return {
        MODE: modes,
        COORDINATE: coordinates,
        DIRECTION: len(mechanism.platform),
        LINEAR: len(mechanism.directions),
        DRIVE: len(mechanism.drives),
        INDEPENDENT: len(mechanism.independent) if independent is None else independent,
        DEPENDENT: len(mechanism.coordinates) - len(mechanism.independent),
        COMPONENT: len(mechanism.pose),
        BASE_COORDINATE: len(mechanism.coordinates),
    }
