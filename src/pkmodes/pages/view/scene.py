"""A scene: where the points of a robot are, how they move in each mode, and which springs hold the strain energy.

The page and still pictures are drawn from it without the model.
A displacement is linear in the amplitude: what is shown is the mode, enlarged.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.drives import FREE
from pkmodes.pages.view.measured_modes import Channel, MeasuredMode
from pkmodes.pages.view.workspace import Surface
from pkmodes_description import Element, Named

Array = NDArray[np.float64]
#: Amplitude of a displayed mode relative to the size of the robot.
AMPLITUDE = 0.06


@dataclass(frozen=True, eq=False)
class Scene:
    """A robot at N poses with m modes; P points with B different motions, n coordinates, S springs.

    Attributes
    ----------
    robot, title : str
        Name of the robot, and title of its mechanism.
    pose : tuple of Named
        Components of a pose.
    directions : tuple of str
        Linear pose components, in which the platform moves.
    platform : tuple of Named
        Components of the platform's motion: displacements, then small rotations about base axes.
    lengths : ndarray, shape (components,)
        Factors that convert these components to lengths: 1, or the characteristic length for rotations [m].
    coordinates, independent : tuple of str
        Names of all coordinates, and of the independent ones, from which the others follow.
    elements : tuple of Element
        Lines, wheels, blocks, plates and balls between points; `spring` indexes `springs`.
    springs : tuple of Named
        Name, unit of the stiffness, description.
    motions_of : ndarray of int, shape (P,)
        For each point the index of its motion.
    poses : ndarray, shape (N, d)
        In SI units.
    points : ndarray, shape (N, P, 3)
        In the base frame [m]; the first point is the platform.
    motions : ndarray, shape (N, B, 3, n)
        Derivatives of the points with respect to the coordinates.
    frequencies : ndarray, shape (N, m)
        Hz; the rigid-body modes first.
    shapes : ndarray, shape (N, m, n)
        Mass-normalised.
    platform_shapes : ndarray, shape (N, m, components)
    energies : ndarray, shape (N, m, S)
        k (g . phi)^2 / 2 of every spring [J], for the mass-normalised shape.
    rigid_modes : int
        Number of modes that strain no spring.
    vertical : ndarray, shape (3,)
        Unit vector against gravity.
    moving_body : str
        What moves with the pose, such as "tool head".
    moving_bodies : tuple of str
        What moves along each of the directions; empty where it is the platform.
    drives : {"free", "held"}
        What the motors do.
    chosen : int
        Index of the pose to show first.
    levels : tuple of ndarray, optional
        For each component of the pose, or each varied parameter, its values, if the states belong to a grid.
    places : ndarray of int, optional
        Index of the pose at each place of the grid, -1 where the robot cannot be.
    workspace : Surface, optional
        Boundary of the reachable workspace of the platform.
    order : ndarray of int, shape (N, m), optional
        On a grid, index of the mode that carries each number at each pose: see ``pkmodes.pages.view.pairing``.
    deviations : ndarray, shape (2 size - 1 along each axis, m - rigid_modes), optional
        How far frequencies between the states of a grid are off: see ``pkmodes.pages.view.interpolation``.
    checked : str
        Where between the states deviations were computed, in words; empty if at every stop of the sliders.
    varied : tuple of Named
        Parameters that change between the states, by path; empty where only the pose does.
    values : ndarray, shape (N, len(varied)), optional
        Their values at each state, in SI units.
    declared : int, optional
        The state that is the robot as declared, where parameters vary.
    labels : tuple of str
        Names of the poses, as of a measurement; empty where they have none.
    what : str
        Which model of the robot moves, such as "as declared"; empty where there is only one.
    measured : tuple of MeasuredMode, optional
        Measured modes at these poses; None for a scene without a measurement.
    channels : tuple of Channel
        Components at which their shapes were measured.
    head : tuple of (str, str)
        Lines of the head of a page, such as the customer.
    doing : str
        What the motors do, in words.
    sigmas : ndarray, shape (N, m), optional
        Standard deviations of the frequencies from those that the robot file states [Hz]; NaN where there is none.
    marked : frozenset of int
        Indices of the elements to mark: those of the part that a result names.
    """

    robot: str
    title: str
    pose: tuple[Named, ...]
    directions: tuple[str, ...]
    platform: tuple[Named, ...]
    lengths: Array
    coordinates: tuple[str, ...]
    independent: tuple[str, ...]
    elements: tuple[Element, ...]
    springs: tuple[Named, ...]
    motions_of: NDArray[np.intp]
    poses: Array
    points: Array
    motions: Array
    frequencies: Array
    shapes: Array
    platform_shapes: Array
    energies: Array
    rigid_modes: int
    vertical: Array
    moving_body: str = "platform"
    moving_bodies: tuple[str, ...] = ()
    drives: str = FREE
    chosen: int = 0
    levels: tuple[Array, ...] | None = None
    places: NDArray[np.intp] | None = None
    workspace: Surface | None = None
    order: NDArray[np.intp] | None = None
    deviations: Array | None = None
    checked: str = ""
    varied: tuple[Named, ...] = ()
    values: Array | None = None
    declared: int | None = None
    labels: tuple[str, ...] = ()
    what: str = ""
    measured: tuple[MeasuredMode, ...] | None = None
    channels: tuple[Channel, ...] = ()
    head: tuple[tuple[str, str], ...] = ()
    doing: str = f"motors {FREE}"
    sigmas: Array | None = None
    marked: frozenset[int] = frozenset()

    @property
    def size(self) -> float:
        """Diagonal of the box around the points at the pose shown first, of a single point at all poses [m]."""
        diagonal = np.linalg.norm(np.ptp(self.points[self.chosen], axis=0))
        return float(diagonal or np.linalg.norm(np.ptp(self.points, axis=(0, 1))) or 1.0)

    @property
    def axes(self) -> tuple[Named, ...]:
        """The quantities whose values are the levels of a grid."""
        return self.varied or self.pose

    @property
    def shares(self) -> Array:
        """Share of each spring in the elastic energy of each mode, (N, m, S); NaN for rigid-body modes."""
        total = self.energies.sum(axis=-1, keepdims=True)
        with np.errstate(invalid="ignore", divide="ignore"):
            shares: Array = self.energies / total
        shares[:, : self.rigid_modes] = np.nan
        return shares

    @property
    def moves(self) -> tuple[str, ...]:
        """Names of the components of the platform's motion, to follow "along": "x", or "about x"."""
        return tuple(
            f"about {component.name[-1]}" if component.unit == "rad" else component.name[-1]
            for component in self.platform
        )

    @property
    def bodies(self) -> tuple[str, ...]:
        """What moves along or about each of these components."""
        return tuple(
            self.moving_bodies[k] if k < len(self.moving_bodies) else self.moving_body
            for k in range(len(self.moves))
        )

    def displacements(self, pose: int, mode: int) -> Array:
        """Return the displacements of the points in a mode.

        Parameters
        ----------
        pose : int
            Index of the pose.
        mode : int
            Index of the mode, rigid-body modes included.

        Returns
        -------
        ndarray, shape (P, 3)
            For the mass-normalised shape [m].
        """
        displacements: Array = self.motions[pose] @ self.shapes[pose, mode]
        return displacements[self.motions_of]

    def scale(self, pose: int, mode: int) -> float:
        """Return the factor that makes the largest displacement of a mode 1 m.

        Parameters
        ----------
        pose : int
            Index of the pose.
        mode : int
            Index of the mode, rigid-body modes included.

        Returns
        -------
        float
            The rims of turning wheels count, too; 0 if nothing moves.
        """
        largest = float(np.linalg.norm(self.displacements(pose, mode), axis=-1).max())
        for element in self.elements:
            if element.turns:
                centre, tip = self.points[pose, list(element.points[:2])]
                rotation = self.shapes[pose, mode, self.coordinates.index(element.turns)]
                largest = max(largest, float(np.linalg.norm(tip - centre) * abs(rotation)))
        return 1.0 / largest if largest > 0.0 else 0.0

    def frames(
        self, pose: int | None = None, mode: int | None = None, count: int = 24, amplitude: float = AMPLITUDE
    ) -> Array:
        """Return the points over one period of a mode, for an animation.

        Parameters
        ----------
        pose : int, optional
            Index of the pose, by default the chosen one.
        mode : int, optional
            Index of the mode, by default the first vibration mode.
        count : int
            Number of frames, evenly spaced in time; the first is at rest.
        amplitude : float
            Largest displacement as a share of the robot's size.

        Returns
        -------
        ndarray, shape (count, P, 3)
            Positions [m]; `elements` connect them.

        Examples
        --------
        >>> import pkmodes
        >>> from pkmodes.pages.view import scene
        >>> moving = scene(pkmodes.load("robots/linear-delta-2022.toml"), [0.6, 0.0, -0.245])
        >>> moving.frames(count=8).shape
        (8, 46, 3)
        """
        pose = self.chosen if pose is None else pose
        mode = min(self.rigid_modes, self.shapes.shape[1] - 1) if mode is None else mode
        displacements = self.scale(pose, mode) * amplitude * self.size * self.displacements(pose, mode)
        phase = np.sin(2.0 * np.pi * np.arange(count) / count)
        frames: Array = self.points[pose] + phase[:, None, None] * displacements
        return frames
