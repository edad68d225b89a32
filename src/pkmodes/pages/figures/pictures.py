"""The figures of a robot, for any mechanism.

They show what figures 7 to 20 of the paper show, and what it does not: which parameter each frequency depends on, and
where mode shapes change abruptly.
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
from pkmodes.core.support.progress import say
from pkmodes.machine.maps import left_out
from pkmodes.machine.maps.mapping import map_of
from pkmodes.machine.maps.poses import checked_poses
from pkmodes.pages.figures.quantities import (
    coarser,
    median_spread,
    motors_of,
    relative_sensitivities,
    smallest_mac,
    volume_of,
)
from pkmodes.pages.figures.working_plane import working_plane
from pkmodes.pages.plots import influence, maps
from pkmodes.pages.plots.dominant import dominant
from pkmodes.pages.plots.drawing import Drawing
from pkmodes.pages.plots.labels import typeset, visible
from pkmodes.pages.plots.mac_map import neighbouring_mac
from pkmodes.pages.plots.plane import Plane, plane_axes, where
from pkmodes.pages.plots.style import stated, styled
from pkmodes.pages.plots.svg import inline
from pkmodes.pages.plots.workspace import workspace

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pkmodes.core.model import Model

#: Length of the longest robot name below a figure.
LONGEST = 60


@dataclass(frozen=True)
class Picture:
    """A figure and what it shows.

    Attributes
    ----------
    name : str
        Of its file, without a suffix.
    title, description : str
    drawing : Drawing or None
        What draws the figure, as wide as a page and for a narrow screen, with the table of what it shows; None for
        words.
    about : str
        The robot and what of it is shown, which also stands below the figure in its file.
    instead : str
        What is said instead of a figure that would show the same everywhere; the figure then consists of these words.
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
        with styled():
            return stated(self.instead)

    def _repr_html_(self) -> str:
        """Return the figure with its caption, for notebooks."""
        drawn = (
            f"<p>{escape(self.instead)}</p>"
            if self.instead
            else inline(self.figure, self.title, self.description, cropped=True)
        )
        caption = f"<figcaption><b>{escape(self.title)}.</b> {escape(self.description)}</figcaption>"
        return f'<figure style="max-width:60rem">{drawn}{caption}</figure>'


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
        """What makes lengths of the components of the platform's motion, where it turns."""
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
    - draw: returns the figure, or a sentence where it would show the same everywhere
    - planar: the description for a mechanism that moves in a plane, if it is another
    - addition: returns what the description says besides of this robot
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


def known_to(spread: NDArray[Any] | None) -> str:
    """Return the uncertainty of the frequencies as a sentence; empty without standard deviations."""
    if spread is None:
        return ""
    sizes = joined([f"\u00b1{typeset(plain(size, 2))}" for size in spread.tolist()])
    through = "and" if len(spread) == 2 else "to"
    modes = "" if len(spread) == 1 else f" of modes 1 {through} {len(spread)}"
    text = f" From the standard deviations in the robot file, the frequencies{modes} are known to {sizes} Hz"
    return f"{text} (median)."


def with_rotations(lengths: NDArray[Any] | None) -> str:
    """State how rotations of the platform count; empty if it does not turn."""
    return (
        "" if lengths is None else f" Rotations are multiplied by {typeset(f'{1e3 * lengths[-1]:.4g}')} mm."
    )


#: The figures in order.  A new one needs an entry here, the function that draws it, and a row in
#: docs/how-to/figures.md.
PICTURES = (
    PictureKind(
        "workspace",
        "Working plane and condition number",
        "Left, outlines of the reachable volume at several heights, with the plane; right, the condition number of "
        "the platform Jacobian in the plane, and its median over the part of the plane that can be reached.",
        lambda robot: workspace(robot.plane, volume_of(robot.model, robot.plane)),
        planar="The condition number of the platform Jacobian in the workspace, and its median.",
    ),
    PictureKind(
        "frequencies",
        "Natural frequencies",
        "The range above a panel leaves out the lowest and the highest 2\N{NO-BREAK SPACE}% of the poses; its "
        "colours span at least 5\N{NO-BREAK SPACE}% of the frequency. Triangles mark the lowest (down) and the "
        "highest (up) frequency in the plane; squares are the motors, hollow ones at the edge those beyond it.",
        lambda robot: maps.frequencies(robot.plane, motors_of(robot.model, robot.plane)),
        addition=lambda robot: (
            left_out.exclusion_caption(robot.plane.dataset)
            + known_to(median_spread(robot.model, robot.plane, robot.drives))
        ),
    ),
    PictureKind(
        "directions",
        "Directions of motion of the {body}",
        "Lines show the direction in the plane, as long as its share of the motion.",
        lambda robot: maps.directions(robot.plane, robot.body, robot.lengths),
        addition=lambda robot: with_rotations(robot.lengths),
    ),
    PictureKind(
        "components",
        "In-plane and out-of-plane motion of the {body}",
        "Mass-normalised mode shapes on one scale.",
        lambda robot: maps.components(robot.plane, robot.body, robot.lengths),
        planar="Mass-normalised mode shapes on one scale; this mechanism does not move out of the plane.",
        addition=lambda robot: with_rotations(robot.lengths),
    ),
    PictureKind(
        "influence",
        "Influence of the parameters",
        "The relative change of each frequency for a relative change of each parameter, median over the plane.",
        lambda robot: influence.table(*robot.influences),
    ),
    PictureKind(
        "dominant",
        "The parameter with the largest influence",
        "At each pose, the parameter whose relative change changes the frequency most.",
        lambda robot: dominant(coarser(robot.plane), *robot.influences),
    ),
    PictureKind(
        "mac",
        "MAC between neighbouring poses",
        "The smallest MAC of each mode with the mode of the same number at the neighbouring poses: dark where shapes "
        "change abruptly.",
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
    say("choosing the plane of the pictures")
    places = working_plane(model) if grid is None else checked_poses(model.mechanism, grid)
    plane_axes(
        dict(zip(places.dims, places.shape, strict=True)), components, "grid"
    )  # before it is evaluated
    drives = model.robot.resolve_drives(drives)
    say("computing the modes in the plane")
    plane = Plane.of(map_of(model, places, shapes=True, drives=drives), components)
    robot = RobotPlane(model, plane, drives)
    about = f"{visible(model.robot.name, LONGEST)}, {motors_in_words(model.robot, drives)}, {where(plane)}"
    for number, kind in enumerate(PICTURES, start=1):
        say(f"picture {number} of {len(PICTURES)}: {kind.name}")
        description = kind.description if plane.normal else kind.planar or kind.description
        description += kind.addition(robot) if kind.addition else ""
        drawn, title = kind.draw(robot), kind.title.format(body=robot.body)
        if isinstance(drawn, str):
            yield Picture(kind.name, title, f"{drawn} {about}.", None, about, drawn)
        else:
            yield Picture(kind.name, title, f"{description} {about}.", drawn, about)
