"""Evaluate the scene of a robot at some poses: points, modes and springs."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from dataclasses import dataclass
from html import escape
from typing import ClassVar

import numpy as np
from msgspec.structs import replace
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.mechanism.length import lengths_of
from pkmodes.core.model import Model
from pkmodes.core.robot.pose_table import poses_by_name
from pkmodes.core.robot.report_fields import head_of
from pkmodes.core.support.motors import motors_in_words
from pkmodes.pages.view.page import page
from pkmodes.pages.view.robot_drawing import RobotDrawing, Springs, springs_with_stiffness
from pkmodes.pages.view.scene import Scene
from pkmodes_description import Named

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class NotebookScene(Scene):
    """A scene that a notebook shows as its page."""

    def _repr_html_(self) -> str:
        """Return the page in a frame, for notebooks."""
        source = escape(page(self), quote=True)
        title = escape(f"{self.robot} in three dimensions", quote=True)
        return f'<iframe title="{title}" srcdoc="{source}" style="width:100%;height:760px;border:0"></iframe>'


def scene(model: Model, poses: ArrayLike, chosen: int = 0, *, drives: str | None = None) -> Scene:
    """Evaluate the scene of a robot at some poses.

    Parameters
    ----------
    model : Model
        The robot.
    poses : array_like, shape (d,) or (N, d)
        In SI units.
    chosen : int
        Index of the pose to show first.
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Returns
    -------
    Scene
        At these poses.

    Raises
    ------
    PoseError
        If a pose cannot be evaluated.
    """
    points = poses_by_name(poses, model.mechanism)
    pose_array = np.atleast_2d(np.asarray(points, dtype=float))
    return scene_of([model] * len(pose_array), pose_array, chosen, drives=drives)


def scene_of(models: Sequence[Model], poses: Array, chosen: int = 0, *, drives: str | None = None) -> Scene:
    """Evaluate the scene of machines that differ in their values, each at a pose.

    Where some machines have joints that others lock, only as many modes are kept as all machines have.

    - models: of one mechanism, length N; the first, or the one shown first, gives its name
    - poses: in SI units, (N, d)
    - chosen: index of the state to show first
    - drives: as for `pkmodes.Model.modes`

    Raises PoseError if a pose cannot be evaluated.
    """
    drives = models[chosen].robot.resolve_drives(drives)
    starts = [i for i, model in enumerate(models) if i == 0 or model is not models[i - 1]]
    ends = [*starts[1:], len(models)]
    machine_motions = [
        _MachineMotion.of(models[start], poses[start:end], drives)
        for start, end in zip(starts, ends, strict=True)
    ]
    model = models[chosen]
    drawing, mechanism = RobotDrawing(model.robot), model.mechanism
    coordinates = tuple(
        name
        for name in mechanism.extended.COORDINATES
        if any(name in part.coordinates for part in machine_motions)
    )
    all_springs = tuple(
        dict.fromkeys(spring for part in machine_motions for spring in part.springs.descriptions)
    )
    mode_count = min(part.frequencies.shape[1] for part in machine_motions)
    rigid_count = min(part.rigid for part in machine_motions)
    aligned = [_align_coordinates(part, coordinates, all_springs) for part in machine_motions]
    springs, spring_index = springs_with_stiffness(
        Springs(all_springs, *(np.concatenate([part.springs[field] for part in aligned]) for field in (1, 2)))
    )
    pose_arrays = {
        key: np.concatenate([getattr(part, key) for part in aligned]) for key in _MachineMotion.POSE_FIELDS
    }
    modal_arrays = {
        key: np.concatenate([getattr(part, key)[:, :mode_count] for part in aligned])
        for key in _MachineMotion.MODE_FIELDS
    }
    strains = np.einsum("psn,pmn->pms", springs.strain, modal_arrays["shapes"])
    energies = 0.5 * springs.stiffness[:, None] * strains**2
    for start, end, part in zip(starts, ends, machine_motions, strict=True):
        # A mode that is rigid in one machine need not be in another.
        energies[start:end, rigid_count : part.rigid] = 0.0
    return NotebookScene(
        robot=model.robot.name,
        title=mechanism.title,
        moving_body=mechanism.moving_body(),
        moving_bodies=mechanism.moving_bodies,
        pose=mechanism.pose,
        directions=mechanism.directions,
        platform=mechanism.platform,
        lengths=lengths_of(mechanism, model.robot.parameters),
        coordinates=coordinates,
        independent=mechanism.independent,
        elements=tuple(
            replace(element, spring=spring_index[element.spring] if element.spring >= 0 else -1)
            for element in drawing.drawing.elements
        ),
        springs=springs.descriptions,
        motions_of=np.array(drawing.drawing.motions, dtype=np.intp),
        poses=pose_arrays["poses"],
        points=pose_arrays["points"],
        motions=pose_arrays["motions"],
        frequencies=modal_arrays["frequencies"],
        shapes=modal_arrays["shapes"],
        platform_shapes=modal_arrays["platform_shapes"],
        energies=energies,
        rigid_modes=rigid_count,
        vertical=drawing.vertical,
        drives=drives,
        chosen=chosen,
        head=tuple(head_of(model.robot.report)),
        doing=motors_in_words(model.robot, drives),
    )


@dataclass(frozen=True, eq=False)
class _MachineMotion:
    """Modes, points and springs of one machine at some poses; arrays as in `Scene`."""

    POSE_FIELDS: ClassVar = ("poses", "points", "motions")
    MODE_FIELDS: ClassVar = ("frequencies", "shapes", "platform_shapes")

    coordinates: tuple[str, ...]
    springs: Springs
    rigid: int
    poses: Array
    points: Array
    motions: Array
    frequencies: Array
    shapes: Array
    platform_shapes: Array

    @classmethod
    def of(cls, model: Model, poses: Array, drives: str) -> _MachineMotion:
        """Evaluate a machine at poses, (N, d)."""
        drawing, modes = RobotDrawing(model.robot), model.modes(poses, drives=drives)
        return cls(
            coordinates=modes.coordinates,
            springs=drawing.springs(modes.poses),
            rigid=modes.rigid_modes,
            poses=modes.poses,
            points=drawing.points(modes.poses),
            motions=drawing.motions(modes.poses),
            frequencies=modes.frequencies,
            shapes=modes.shapes,
            platform_shapes=modes.platform_shapes,
        )


def _align_coordinates(
    part: _MachineMotion, coordinates: tuple[str, ...], springs: tuple[Named, ...]
) -> _MachineMotion:
    """Return a part with zeros for the coordinates and springs that only other machines have."""
    if part.coordinates == coordinates and part.springs.descriptions == springs:
        return part
    coordinate_columns = [coordinates.index(name) for name in part.coordinates]
    spring_columns = [springs.index(spring) for spring in part.springs.descriptions]

    def fill_columns(values: Array) -> Array:
        zeros = np.zeros((*values.shape[:-1], len(coordinates)))
        zeros[..., coordinate_columns] = values
        return zeros

    count = len(part.poses)
    stiffness, strain = np.zeros((count, len(springs))), np.zeros((count, len(springs), len(coordinates)))
    stiffness[:, spring_columns] = part.springs.stiffness
    strain[:, spring_columns] = fill_columns(part.springs.strain)
    return dataclasses.replace(
        part,
        coordinates=coordinates,
        springs=Springs(springs, stiffness, strain),
        motions=fill_columns(part.motions),
        shapes=fill_columns(part.shapes),
    )
