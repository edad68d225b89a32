"""The figures of a robot, for any mechanism.

They show what figures 7 to 20 of the paper show, and also which parameter each frequency depends on, and where mode
shapes change abruptly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import cached_property
from html import escape
from typing import TYPE_CHECKING, Any

from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.base.numbers import plain
from pkmodes.core.mechanism.length import lengths_of
from pkmodes.core.support.extras import require
from pkmodes.core.support.motors import motors_in_words
from pkmodes.core.support.ordering import joined
from pkmodes.core.support.progress import report_progress
from pkmodes.loop.sensitivity.alike import TIE_FRACTION
from pkmodes.machine.maps import left_out
from pkmodes.machine.maps.mapping import map_of
from pkmodes.machine.maps.poses import checked_poses
from pkmodes.pages.figures.quantities import (
    coarse_plane,
    median_spread,
    motor_positions,
    reachable_volume,
    relative_sensitivities,
    smallest_mac,
)
from pkmodes.pages.figures.working_plane import working_plane
from pkmodes.pages.plots import influence, maps
from pkmodes.pages.plots.dominant import dominant_parameters
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset, visible_text
from pkmodes.pages.plots.mac_map import neighbouring_mac
from pkmodes.pages.plots.plane import Plane, plane_axes, plane_location
from pkmodes.pages.plots.style import figure_style, sentence_figure
from pkmodes.pages.plots.svg import inline_svg
from pkmodes.pages.plots.workspace import workspace

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pkmodes.core.model import Model

#: Maximum length of the robot name below a figure.
MAX_ROBOT_NAME_LENGTH = 60


@dataclass(frozen=True)
class Picture:
    """A figure and what it shows.

    Attributes
    ----------
    name : str
        Name of its file, without a suffix.
    title, description : str
    drawing : Drawing or None
        Draws the figure, as wide as a page and for a narrow screen, and has the table of its numbers; None if
        `instead` replaces the figure.
    about : str
        The robot, its motors and the plane, also written below the figure in its file.
    instead : str
        The sentence that replaces a figure of one colour; empty for other figures. The figure then shows only this
        sentence.
    """

    name: str
    title: str
    description: str
    drawing: Drawing | None
    about: str = ""
    instead: str = ""

    @cached_property
    def figure(self) -> Figure:
        """The figure of matplotlib, as wide as a page."""
        if self.drawing is not None:
            return self.drawing.figure
        with figure_style():
            return sentence_figure(self.instead)

    def _repr_html_(self) -> str:
        """Return the figure with its caption, for notebooks."""
        content = (
            f"<p>{escape(self.instead)}</p>"
            if self.instead
            else inline_svg(self.figure, self.title, self.description, cropped=True)
        )
        caption = f"<figcaption><b>{escape(self.title)}.</b> {escape(self.description)}</figcaption>"
        return f'<figure style="max-width:60rem">{content}{caption}</figure>'


@dataclass(frozen=True, eq=False)
class RobotPlane:
    """What the figures show: a robot and its map in a plane, with mode shapes."""

    model: Model
    plane: Plane
    drives: str

    @property
    def body(self) -> str:
        """What moves in the plane."""
        return self.model.mechanism.moving_body()

    @cached_property
    def lengths(self) -> NDArray[Any] | None:
        """Factors that turn the components of the platform's motion into lengths; None if it does not rotate."""
        model = self.model
        return lengths_of(model.mechanism, model.robot.parameters) if model.mechanism.rotations else None

    @cached_property
    def influences(self) -> tuple[list[str], NDArray[Any]]:
        """Parameters and the relative sensitivities to them, from `relative_sensitivities`."""
        return relative_sensitivities(self.model, self.plane, self.drives)


@dataclass(frozen=True)
class PictureKind:
    """A figure that every robot has.

    - name, title, description: as those of the `Picture`; ``{body}`` in the title stands for what moves; the robot
      and its plane are added to the description
    - draw: returns the figure, or a sentence if the figure would have one colour
    - planar: the description for a mechanism that moves in a plane, if it differs
    - addition: returns sentences about this robot that are added to the description
    """

    name: str
    title: str
    description: str
    draw: Callable[[RobotPlane], Drawing | str]
    planar: str | None = None
    addition: Callable[[RobotPlane], str] | None = None

    @property
    def mark(self) -> bytes:
        """The part of the title that every robot's figure has."""
        return self.title.partition(" of the {body}")[0].encode()


def frequency_uncertainty(spread: NDArray[Any] | None) -> str:
    """Return the uncertainty of the frequencies as a sentence; empty without standard deviations."""
    if spread is None:
        return ""
    uncertainties = joined(
        [f"\u00b1{typeset(plain(standard_deviation, 2))}" for standard_deviation in spread.tolist()]
    )
    conjunction = "and" if len(spread) == 2 else "to"
    modes = "" if len(spread) == 1 else f" of modes 1 {conjunction} {len(spread)}"
    text = f" From the standard deviations in the robot file, the frequencies{modes} are known to {uncertainties} Hz"
    return f"{text} (median over the plane)."


def rotation_factor_sentence(lengths: NDArray[Any] | None) -> str:
    """Return the factor that turns rotations of the platform into lengths, as a sentence; empty without rotations."""
    return (
        "" if lengths is None else f" Rotations are multiplied by {typeset(f'{1e3 * lengths[-1]:.4g}')} mm."
    )


#: The figures in order.  A new one needs an entry here, the function that draws it, and a row in
#: docs/how-to/figures.md.
PICTURES = (
    PictureKind(
        "workspace",
        "Working plane and condition number",
        "Left, outlines of the reachable volume at several heights, with the plane; right, the condition "
        "number of the platform Jacobian in the plane, and its median over the part of the plane that can be "
        "reached.",
        lambda robot: workspace(robot.plane, reachable_volume(robot.model, robot.plane)),
        planar="The condition number of the platform Jacobian in the workspace, and its median.",
    ),
    PictureKind(
        "frequencies",
        "Natural frequencies",
        "The range above a panel leaves out the lowest and the highest 2\N{NO-BREAK SPACE}% of the poses; "
        "its colours span at least 5\N{NO-BREAK SPACE}% of the frequency. Triangles mark the lowest (down) "
        "and the highest (up) frequency in the plane; squares are the motors, hollow ones at the edge those "
        "beyond it.",
        lambda robot: maps.frequencies(robot.plane, motor_positions(robot.model, robot.plane)),
        addition=lambda robot: (
            left_out.exclusion_caption(robot.plane.dataset)
            + frequency_uncertainty(median_spread(robot.model, robot.plane, robot.drives))
        ),
    ),
    PictureKind(
        "directions",
        "Directions of motion of the {body}",
        "Lines show the direction in the plane, as long as its share of the motion.",
        lambda robot: maps.directions(robot.plane, robot.body, robot.lengths),
        addition=lambda robot: rotation_factor_sentence(robot.lengths),
    ),
    PictureKind(
        "components",
        "In-plane and out-of-plane motion of the {body}",
        "Mass-normalised mode shapes on one scale.",
        lambda robot: maps.components(robot.plane, robot.body, robot.lengths),
        planar="Mass-normalised mode shapes on one scale; this mechanism does not move out of the plane.",
        addition=lambda robot: rotation_factor_sentence(robot.lengths),
    ),
    PictureKind(
        "influence",
        "Influence of the parameters",
        "The relative change of each frequency for a relative change of each parameter, median over the plane.",
        lambda robot: influence.influence_table(*robot.influences),
    ),
    PictureKind(
        "dominant",
        "The parameter with the largest influence",
        "At each pose, the parameter whose relative change changes the frequency most; several are alike where their "
        f"influences are within {plain(100 * TIE_FRACTION)}\N{NO-BREAK SPACE}% of the largest.",
        lambda robot: dominant_parameters(coarse_plane(robot.plane), *robot.influences),
    ),
    PictureKind(
        "mac",
        "MAC between neighbouring poses",
        "The smallest MAC of each mode with the mode of the same number at the neighbouring poses: dark "
        "where shapes change abruptly.",
        lambda robot: neighbouring_mac(robot.plane, smallest_mac(robot.model, robot.plane)),
    ),
)


def pictures(model: Model, grid: Any = None, *, drives: str | None = None) -> Iterator[Picture]:
    """Draw the figures of a robot, one after the other.

    Parameters
    ----------
    model : Model
        The robot.
    grid : mapping of str to array_like, optional
        Two components of the pose with several values, the others with one; by default from
        `working_plane`.
    drives : {"free", "held"}, optional
        As for `pkmodes.Model.modes`.

    Yields
    ------
    Picture
        A figure with its title and description.

    Raises
    ------
    PkmodesError
        If the grid is not a plane, or no pose in it can be evaluated; or if the pose has one component only.
    MissingExtraError
        If matplotlib or xarray is not installed.
    """
    require("figures", "plot", "matplotlib", "xarray")
    components = [component.name for component in model.mechanism.pose]
    if len(components) < 2:
        problem = (
            f"the figures need two components of the pose, {model.mechanism.name} has only {components[0]}"
        )
        raise PkmodesError(problem, model.robot.source, "draw its frequencies in the report of a map")
    report_progress("choosing the plane of the pictures")
    pose_grid = working_plane(model) if grid is None else checked_poses(model.mechanism, grid)
    plane_axes(
        dict(zip(pose_grid.dims, pose_grid.shape, strict=True)), components, "grid"
    )  # before it is evaluated
    drives = model.robot.resolve_drives(drives)
    report_progress("computing the modes in the plane")
    plane = Plane.of(map_of(model, pose_grid, shapes=True, drives=drives), components)
    robot = RobotPlane(model, plane, drives)
    robot_name = visible_text(model.robot.name, MAX_ROBOT_NAME_LENGTH)
    about = f"{robot_name}, {motors_in_words(model.robot, drives)}, {plane_location(plane)}"
    for number, kind in enumerate(PICTURES, start=1):
        report_progress(f"picture {number} of {len(PICTURES)}: {kind.name}")
        description = kind.description if plane.normal else kind.planar or kind.description
        description += kind.addition(robot) if kind.addition else ""
        drawing, title = kind.draw(robot), kind.title.format(body=robot.body)
        if isinstance(drawing, str):
            yield Picture(kind.name, title, f"{drawing} {about}.", None, about, drawing)
        else:
            yield Picture(kind.name, title, f"{description} {about}.", drawing, about)
