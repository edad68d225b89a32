"""The figures of a robot, for any mechanism.

They show what figures 7 to 20 of the paper show, and what it does not: which parameter each frequency depends on, and
where mode shapes change abruptly.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from html import escape
from typing import TYPE_CHECKING, Any

from pkmodes.base.errors import PkmodesError
from pkmodes.base.extras import require
from pkmodes.figures.working_plane import working_plane
from pkmodes.maps.places import places_of
from pkmodes.plots.style import styled

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from pkmodes.model.model import Model


@dataclass(frozen=True)
class Picture:
    """A figure and what it shows.

    Attributes
    ----------
    name : str
        Of its file, without a suffix.
    title, description : str
    figure : matplotlib.figure.Figure
    """

    name: str
    title: str
    description: str
    figure: Figure

    def _repr_html_(self) -> str:
        """Return the figure with its caption, for notebooks."""
        from pkmodes.plots.svg import inline

        with styled():
            drawn = inline(self.figure, self.title, self.description, cropped=True)
        caption = f"<figcaption><b>{escape(self.title)}.</b> {escape(self.description)}</figcaption>"
        return f'<figure style="max-width:60rem">{drawn}{caption}</figure>'


def pictures(model: Model, grid: Any = None) -> Iterator[Picture]:
    """Draw the figures of a robot, one after the other.

    Parameters
    ----------
    model : Model
        The robot.
    grid : mapping of str to array_like, optional
        Two components of the pose with several values, the others with one; by default from
        `working_plane`.

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
    from pkmodes.figures.quantities import coarser, motors_of, relative_sensitivities, smallest_mac, volume_of
    from pkmodes.plots import influence, mac, maps
    from pkmodes.plots.plane import Plane, plane_axes, where
    from pkmodes.plots.workspace import workspace

    components = [component.name for component in model.mechanism.pose]
    if len(components) < 2:
        what = f"the figures need two components of the pose, {model.mechanism.name} has {components[0]} only"
        raise PkmodesError(what, model.robot.source, "draw its frequencies by the report of a map")
    places = working_plane(model) if grid is None else places_of(model.mechanism, grid)
    plane_axes(
        dict(zip(places.dims, places.shape, strict=True)), components, "grid"
    )  # before it is evaluated
    plane = Plane.of(model.map(places, shapes=True), components)
    paths, relative = relative_sensitivities(model, plane)
    about = f"{model.robot.name}, {where(plane)}"

    def drawn(name: str, title: str, description: str, draw: Callable[[], Figure]) -> Picture:
        with styled():
            return Picture(name, title, f"{description} {about}.", draw())

    yield drawn(
        "workspace",
        "Working plane and condition number",
        "Left, outlines of the reachable volume at several heights, with the plane; right, the condition number of "
        "the platform Jacobian in the plane."
        if plane.normal
        else "The condition number of the platform Jacobian in the workspace.",
        lambda: workspace(plane, volume_of(model, plane)),
    )
    yield drawn(
        "frequencies",
        "Natural frequencies",
        "Triangles mark the lowest (down) and highest (up) frequency along the centre line, without its ends; "
        "squares at the edge mark the motors; the colour scale ignores the lowest and highest 2 % of the values.",
        lambda: maps.frequencies(plane, motors_of(model, plane)),
    )
    yield drawn(
        "directions",
        "Directions of the platform's motion",
        "Lines show the direction in the plane, as long as its share of the motion.",
        lambda: maps.directions(plane),
    )
    yield drawn(
        "components",
        "In-plane and out-of-plane motion of the platform",
        "Mass-normalised mode shapes on one scale.",
        lambda: maps.components(plane),
    )
    yield drawn(
        "influence",
        "Influence of the parameters",
        "The relative change of each frequency for a relative change of each parameter, median over the plane.",
        lambda: influence.table(paths, relative),
    )
    yield drawn(
        "dominant",
        "The parameter with the largest influence",
        "At each pose, the parameter whose relative change changes the frequency most.",
        lambda: influence.dominant(coarser(plane), paths, relative),
    )
    yield drawn(
        "mac",
        "MAC between neighbouring poses",
        "The smallest MAC of each mode with the mode of the same number at the neighbouring poses: dark where shapes "
        "change abruptly.",
        lambda: mac.neighbours(plane, smallest_mac(model, plane)),
    )
