"""Evaluate a scene: what a picture of a robot shows at some poses."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

import numpy as np
from msgspec.structs import replace
from numpy.typing import ArrayLike

from pkmodes.base.drives import FREE
from pkmodes.measured.pose_table import poses_by_name
from pkmodes.model.model import Model
from pkmodes.robot.report_fields import head_of
from pkmodes.view.page import page
from pkmodes.view.robot_drawing import RobotDrawing, present
from pkmodes.view.scene import Scene


@dataclass(frozen=True, eq=False)
class NotebookScene(Scene):
    """A scene that a notebook shows as its page."""

    def _repr_html_(self) -> str:
        """Return the page in a frame, for notebooks."""
        source = escape(page(self), quote=True)
        title = escape(f"{self.robot} in three dimensions", quote=True)
        return f'<iframe title="{title}" srcdoc="{source}" style="width:100%;height:760px;border:0"></iframe>'


def scene(model: Model, poses: ArrayLike, chosen: int = 0, *, drives: str = FREE) -> Scene:
    """Evaluate what a picture of a robot shows at some poses.

    Parameters
    ----------
    model : Model
        The robot.
    poses : array_like, shape (d,) or (N, d)
        In SI units.
    chosen : int
        Index of the pose to show first.
    drives : {"free", "held"}
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
    drawing, mechanism = RobotDrawing(model.robot), model.mechanism
    points = poses_by_name(poses, mechanism)
    modes = model.modes(np.atleast_2d(np.asarray(points, dtype=float)), drives=drives)
    springs, index = present(drawing.springs(modes.poses))
    strains = np.einsum("psn,pmn->pms", springs.strain, modes.shapes)
    return NotebookScene(
        robot=model.robot.name,
        title=mechanism.title,
        pose=mechanism.pose,
        directions=mechanism.directions,
        coordinates=modes.coordinates,
        elements=tuple(
            replace(element, spring=index[element.spring] if element.spring >= 0 else -1)
            for element in drawing.drawing.elements
        ),
        springs=springs.named,
        motions_of=np.array(drawing.drawing.motions, dtype=np.intp),
        poses=modes.poses,
        points=drawing.points(modes.poses),
        motions=drawing.motions(modes.poses),
        frequencies=modes.frequencies,
        shapes=modes.shapes,
        platform_shapes=modes.platform_shapes,
        energies=0.5 * springs.stiffness[:, None] * strains**2,
        rigid_modes=modes.rigid_modes,
        vertical=drawing.vertical,
        drives=drives,
        chosen=chosen,
        head=tuple(head_of(model.robot.report)),
    )
