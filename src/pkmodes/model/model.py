"""The evaluator of one robot: poses in, modes, matrices, statics, derivatives and maps out."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import wraps
from os import PathLike
from typing import TYPE_CHECKING, Any, Concatenate, ParamSpec, TypeVar

from numpy.typing import ArrayLike

from pkmodes.base.drives import FREE, checked_drives
from pkmodes.mechanism.poses import MAX_CONDITION, OnError
from pkmodes.model.responses import Responses
from pkmodes.robot.robot import Robot
from pkmodes.solve.backends import AUTO, checked_threads
from pkmodes.solve.dynamics import Dynamics
from pkmodes.solve.field_arrays import Fields, Out
from pkmodes.solve.kinematics import Kinematics

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from xarray import Dataset

    from pkmodes.sensitivity.sensitivities import ResolvedPaths, Sensitivities


P = ParamSpec("P")
R = TypeVar("R")


def _of_kinematics(method: Callable[Concatenate[Kinematics, P], R]) -> Callable[Concatenate[Model, P], R]:
    """Make a method of the model from one of its kinematics."""

    @wraps(method)
    def of_model(self: Model, /, *args: P.args, **kwargs: P.kwargs) -> R:
        return method(self.kinematics, *args, **kwargs)

    return of_model


def _of_dynamics(method: Callable[Concatenate[Dynamics, P], R]) -> Callable[Concatenate[Model, P], R]:
    """Make a method of the model from one of its dynamics."""

    @wraps(method)
    def of_model(self: Model, /, *args: P.args, **kwargs: P.kwargs) -> R:
        return method(self.dynamics, *args, **kwargs)

    return of_model


class Model(Responses):
    """Evaluator of one robot.

    Every method takes one pose of shape (d,) or an array of shape (..., d), in SI units and with the mechanism's
    pose components, and returns arrays with the same leading axes.  A table, as of pandas, is taken by the names of
    its columns, which may have units (``x [mm]``).  With ``on_error="raise"`` the first pose that cannot be evaluated
    raises a `PoseError`; with ``"nan"`` it gives NaN.  An array that does not hold poses always raises a
    `PoseError`.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`; `pkmodes.load` creates the model of a robot file directly.
    max_condition : float
        Poses at which the condition number of the mechanism is larger are rejected as singular.

    Attributes
    ----------
    robot : Robot
    mechanism : Mechanism
        Description of the mechanism: pose components, coordinates, drives.
    coordinates : tuple of str
        Names of the generalised coordinates (docs/model.md).
    """

    check = _of_kinematics(Kinematics.check)
    platform_jacobian = _of_kinematics(Kinematics.platform_jacobian)
    condition = _of_kinematics(Kinematics.condition)
    inverse_kinematics = _of_kinematics(Kinematics.inverse_kinematics)
    direct_kinematics = _of_kinematics(Kinematics.direct_kinematics)
    assembly = _of_kinematics(Kinematics.assembly)
    modes = _of_dynamics(Dynamics.modes)
    frequencies = _of_dynamics(Dynamics.frequencies)
    matrices = _of_dynamics(Dynamics.matrices)
    statics = _of_dynamics(Dynamics.statics)

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        self.kinematics = Kinematics(robot, max_condition)
        self.dynamics = Dynamics(self.kinematics)
        self.robot, self.mechanism = robot, robot.mechanism
        self.coordinates = self.dynamics.coordinates
        self._resolved_paths: tuple[tuple[tuple[str, ...] | None, str], ResolvedPaths] | None = None

    def __repr__(self) -> str:
        return f"Model({self.robot.name!r}, {self.robot.mechanism_name}, {len(self.coordinates)} coordinates)"

    def __reduce__(self) -> tuple[Any, ...]:
        # The evaluation may hold modules, which cannot be pickled; it is rebuilt from the robot.
        return type(self), (self.robot, self.max_condition)

    @property
    def max_condition(self) -> float:
        """The largest condition number of a pose that is not singular."""
        return self.kinematics.max_condition

    @property
    def reasons(self) -> dict[str, str]:
        """Codes that ``reason`` may have for a pose that cannot be evaluated, with their meanings."""
        return self.kinematics.reasons

    @property
    def has_assemblies(self) -> bool:
        """Whether the mechanism has several assembly branches: see `assembly`."""
        return self.kinematics.has_assemblies

    def with_values(self, values: Mapping[str, Any]) -> Model:
        """Return the evaluator of the robot with other values.

        Parameters
        ----------
        values : mapping of str to value
            By dotted path, as for `pkmodes.Robot.with_values`.

        Returns
        -------
        Model
            With the same largest condition number.

        Raises
        ------
        PkmodesError
            As for `pkmodes.Robot.with_values`.
        """
        return Model(self.robot.with_values(values), self.max_condition)

    def sensitivities(
        self,
        poses: ArrayLike,
        parameters: Sequence[str] | None = None,
        *,
        close: float = 1e-6,
        on_error: OnError = "raise",
        fields: Fields = None,
        drives: str = FREE,
        out: Out = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Sensitivities:
        """Compute exact derivatives of matrices and modes with respect to parameters, at fixed platform poses.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        parameters : sequence of str, optional
            Parameter paths (docs/sensitivities.md); by default all quantities of the robot and all effect parameters.
        close : float
            Modes whose eigenvalues differ by less than this fraction form one group.
        on_error : {"raise", "nan"}
            As for `modes`.
        fields : sequence of str, optional
            Which of ``Sensitivities.FIELDS`` to compute and keep; by default all, or the fields in `out`.
            ``"frequencies"`` and ``"eigenvalues"`` alone take a hundredth of the time or, without the compiled
            library, a sixth.
        drives : {"free", "held"}
            As for `modes`.
        out : mapping of str to ndarray, optional
            As for `modes`.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`: what solves the eigenproblem and evaluates these two fields.  With the same back end,
            repeated modes have the same basis.
        threads : int, optional
            As for `modes`.

        Returns
        -------
        Sensitivities
            With the leading axes of the poses.

        Raises
        ------
        PkmodesError
            If a path is unknown (the message suggests the nearest), or a field or an array in `out` is invalid as
            in `modes`.
        """
        from pkmodes.sensitivity.sensitivities import sensitivities

        return sensitivities(
            self._resolved(parameters, checked_drives(drives)),
            poses,
            on_error,
            self.max_condition,
            close,
            fields,
            out,
            self.dynamics.solver(backend, drives),
            checked_threads(threads),
        )

    def frequency_sigmas(
        self, poses: ArrayLike, on_error: OnError = "raise", *, drives: str = FREE
    ) -> NDArray[np.float64]:
        """Compute the standard deviations of the frequencies from those that the robot file states.

        The law of propagation of uncertainty with exact derivatives, good to first order.  Values are independent
        unless a ``[[covariance]]`` of the robot file correlates them.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`.
        drives : {"free", "held"}
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., m)
            In Hz, in the order of `frequencies`; NaN where a frequency is 0 to rounding.  Each of several repeated
            modes has the root mean square over their group.

        Raises
        ------
        PkmodesError
            If the robot file states no standard deviation of a value that changes a frequency.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> model = model.with_values({"belt.width": {"value": "15 mm", "sigma": "2 %"}})
        >>> model.frequency_sigmas([0.6, 0.0, -0.245])[3:].round(2)
        array([0.56, 0.6 , 0.62, 1.31, 1.34, 1.34])
        """
        from pkmodes.sensitivity.spread import needed_spread_of

        return needed_spread_of(self.dynamics, poses, checked_drives(drives), on_error)

    def map(
        self,
        grid: Any = None,
        *,
        sweep: Mapping[str, Any] | None = None,
        samples: int | None = None,
        seed: int = 0,
        shapes: bool = False,
        tracked: bool = False,
        out: str | PathLike[str] | None = None,
        overwrite: bool = False,
        scheduler: str | None = None,
        threads: int | None = None,
        backend: str = AUTO,
        drives: str = FREE,
        progress: Callable[[int, int], None] | None = None,
    ) -> Dataset:
        """Compute the modes over the workspace, and over ranges of parameters.

        Parameters
        ----------
        grid : mapping of str to array_like, or array_like of shape (N, d), optional
            Ascending values, or one number, for each component of the pose, in SI units; or poses one after the
            other.  By default a grid over the reachable workspace, within the usable limits of the robot.
        sweep : mapping of str to array_like, optional
            Values of parameters in SI units, by path; all combinations are evaluated.
        samples : int, optional
            Number of robots whose values with a standard deviation are drawn from normal distributions.
        seed : int
            Of the draws.
        shapes : bool
            Whether to keep mode shapes.
        tracked : bool
            Whether to number modes by their shapes instead of by rank, from the middle of the map outwards.
        out : path-like, optional
            File to write: ``.nc`` (NetCDF-4), ``.zarr``, or a table in ``.csv`` or ``.parquet``.  The map is computed
            in a folder next to it, ``<out>.partial``: after an interruption the same call continues there.
        overwrite : bool
            Whether an existing file may be replaced.
        scheduler : str, optional
            Address of a Dask scheduler whose workers evaluate the map.
        threads : int, optional
            Without a scheduler, by default one per core.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.
        drives : {"free", "held"}
            As for `modes`.
        progress : callable, optional
            Called with the number of poses done and their total.

        Returns
        -------
        xarray.Dataset
            Described in docs/maps.md.  Where `out` is NetCDF or Zarr, its values are read from the file when they are
            needed.

        Raises
        ------
        PkmodesError
            If an argument is invalid, no pose can be evaluated, or the workers of a scheduler cannot finish.
        OutputError
            If the file exists or cannot be written, or an interrupted map there is another one or damaged.
        MissingExtraError
            If the libraries of the extra ``map`` are not installed.

        Examples
        --------
        >>> import numpy as np, pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> dataset = model.map({"x": np.linspace(0.3, 0.8, 6), "y": 0.0, "z": -0.245})
        >>> dataset.frequency.sel(mode=1).squeeze().round(2).values
        array([46.34, 49.55, 54.23, 55.56, 50.33, 46.8 ])
        """
        from pkmodes.maps.mapping import map_of

        return map_of(
            self.kinematics,
            grid,
            sweep=sweep,
            samples=samples,
            seed=seed,
            shapes=shapes,
            tracked=tracked,
            out=out,
            overwrite=overwrite,
            scheduler=scheduler,
            threads=threads,
            backend=backend,
            drives=drives,
            progress=progress,
        )

    def _resolved(self, parameters: Sequence[str] | None, drives: str) -> ResolvedPaths:
        """Resolve parameter paths; those of the last call are kept."""
        from pkmodes.sensitivity.sensitivities import ResolvedPaths

        if parameters is None:
            names: tuple[str, ...] | None = None
        elif isinstance(parameters, list | tuple) and all(isinstance(path, str) for path in parameters):
            names = tuple(parameters)
        else:  # anything else is converted or refused
            return ResolvedPaths(self.robot, parameters, drives)
        key, last = (names, drives), self._resolved_paths
        if last is None or last[0] != key:
            last = self._resolved_paths = key, ResolvedPaths(self.robot, parameters, drives)
        return last[1]
