"""The evaluator of one robot: poses in, modes, matrices and statics out.

It checks poses, calls the generated model chunk by chunk, solves, and reshapes the results to the caller's axes.
It contains no physics.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.backends import AUTO, COMPILED, NUMPY, checked_threads, chosen, compiled
from pkmodes.evaluation import evaluation, matrices
from pkmodes.gathering import Fields, Gathered, Out, chosen_fields
from pkmodes.kinematics import Kinematics
from pkmodes.poses import CHUNK, MAX_CONDITION, OnError
from pkmodes.results import CARRIAGES, JOINTS, Modes, Statics
from pkmodes.robot.robot import Robot
from pkmodes.solving import fields_of_modes

if TYPE_CHECKING:
    from xarray import Dataset

    from pkmodes.compiled.evaluator import Evaluator
    from pkmodes.sensitivity.sensitivities import ResolvedPaths, Sensitivities

Array = NDArray[np.float64]


class Model(Kinematics):
    """Evaluator of one robot.

    Every method takes one pose of shape (d,) or an array of shape (..., d), in SI units and with the mechanism's
    pose components, and returns arrays with the same leading axes.  With ``on_error="raise"`` the first pose that
    cannot be evaluated raises a `PoseError`; with ``"nan"`` it gives NaN.  An array that does not hold poses always
    raises a `PoseError`.

    Parameters
    ----------
    robot : Robot
        From `pkmodes.read_robot`; `pkmodes.load` creates the model of a robot file directly.
    max_condition : float
        Poses at which the condition number of the mechanism is larger are rejected as singular.

    Attributes
    ----------
    robot : Robot
    kind : Mechanism
        Description of the mechanism: pose components, coordinates, drives.
    coordinates : tuple of str
        Names of the generalised coordinates (docs/model.md).
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        super().__init__(robot, max_condition)
        self._evaluation = evaluation(robot)
        self.coordinates = self._evaluation.coordinates
        self._evaluators: dict[str, Evaluator | None] = {}
        self._resolved_paths: tuple[tuple[str, ...] | None, ResolvedPaths] | None = None

    def __repr__(self) -> str:
        return f"Model({self.robot.name!r}, {self.robot.mechanism}, {len(self.coordinates)} coordinates)"

    def __reduce__(self) -> tuple[Any, ...]:
        # The evaluation may hold modules, which cannot be pickled; it is rebuilt from the robot.
        return type(self), (self.robot, self.max_condition)

    def with_values(self, values: Mapping[str, Any]) -> Model:
        """Return the evaluator of the robot with other values: see `pkmodes.Robot.with_values`."""
        return Model(self.robot.with_values(values), self.max_condition)

    def modes(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        fields: Fields = None,
        out: Out = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Modes:
        """Compute natural frequencies, mode shapes and matrices.

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN, ``valid`` False, and a ``reason``.
        fields : sequence of str, optional
            Which of `Modes.FIELDS` to compute and keep, such as ``("frequencies", "platform_shapes")``; by default
            all, or the fields in `out`.  The values of a field do not depend on the other fields requested.
        out : mapping of str to ndarray, optional
            Arrays to fill in place, by field, with the shapes given in `Modes`; they become the fields.
        backend : {"auto", "numpy", "compiled"}
            What evaluates the modes: by default the compiled library if there is one, unless the environment variable
            ``PKMODES_BACKEND`` says otherwise.  `Modes.backend` tells which one ran.
        threads : int, optional
            Threads of the compiled library, by default one per core; the results do not depend on it.

        Returns
        -------
        Modes
            With the leading axes of the poses.

        Raises
        ------
        PkmodesError
            If a field is unknown, or an array in `out` has the wrong shape or type or is read-only. Also if
            `backend` is "compiled" and there is no compiled library.

        Examples
        --------
        >>> import pkmodes
        >>> model = pkmodes.load("robots/linear-delta-2022.toml")
        >>> modes = model.modes([[0.6, 0.0, -0.245], [0.1, 0.0, -0.245]], "nan", fields=["frequencies"])
        >>> modes.frequencies[:, 3].round(3)
        array([55.559,    nan])
        >>> modes.reason
        array(['', 'limits'], dtype='<U9')
        """
        asked = chosen_fields(fields, out, Modes.fields_of(self.kind))
        # Both names refer to the same values; they share one array unless the caller passes a second one.
        same = {JOINTS, CARRIAGES} <= set(asked) and CARRIAGES not in (out or ())
        computed = [name for name in asked if not (same and name == CARRIAGES)]
        evaluator, number = self._compiled(backend), checked_threads(threads)
        if evaluator is None:
            checked = self._check(poses, on_error)
            gathered = Gathered(checked, out)
            for where, p in checked.parts(CHUNK):
                gathered.put(where, fields_of_modes(self.robot, self._evaluation, p, computed))
            arrays = gathered.arrays
        else:
            from pkmodes.compiled_modes import compiled_modes

            checked, arrays = compiled_modes(
                evaluator, self.robot, self._evaluation, poses, on_error, computed, out, number
            )
        if same:
            arrays[CARRIAGES] = arrays[JOINTS]
        return Modes(
            codes=checked.codes.reshape(checked.batch),
            known=checked.known,
            arrays=arrays,
            poses=checked.points.reshape((*checked.batch, -1)),
            coordinates=self.coordinates,
            rigid_modes=self._evaluation.rigid_modes,
            robot=self.robot,
            backend=NUMPY if evaluator is None else COMPILED,
        )

    def frequencies(
        self,
        poses: ArrayLike,
        on_error: OnError = "raise",
        *,
        out: Array | None = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Array:
        """Compute only the natural frequencies; they equal those of `modes` to the last digit.

        Parameters
        ----------
        poses, on_error, backend, threads
            As for `modes`; `check` says why a pose gives NaN.
        out : ndarray of float, shape (..., m), optional
            Filled in place and returned.

        Returns
        -------
        ndarray, shape (..., m)
            sqrt(abs(lambda)) / (2 pi) with the sign of lambda [Hz], the rigid-body modes first.
        """
        given = None if out is None else {"frequencies": out}
        found = self.modes(
            poses, on_error, fields=("frequencies",), out=given, backend=backend, threads=threads
        )
        return found.frequencies

    def _compiled(self, backend: str) -> Evaluator | None:
        """The compiled evaluator, None where NumPy computes."""
        name = chosen(backend)
        if name not in self._evaluators:
            self._evaluators[name] = compiled(self.kind, self._evaluation, self.max_condition, name)
        return self._evaluators[name]

    def matrices(self, poses: ArrayLike, on_error: OnError = "raise") -> tuple[Array, Array]:
        """Compute the mass and stiffness matrices (equations 33 and 48).

        Returns
        -------
        M, K : ndarray, shape (..., n, n)
            In SI units, in the order of `coordinates`; NaN where a pose could not be evaluated.
        """
        checked = self._check(poses, on_error)
        M, K = self._evaluate(lambda p: matrices(self._evaluation, p), checked)
        return M, K

    def statics(self, poses: ArrayLike, on_error: OnError = "raise") -> Statics:
        """Compute the torques and rotations that hold the pose (equation 44)."""
        checked = self._check(poses, on_error)
        torques, rotations = self._evaluate(self._evaluation.statics, checked)
        return Statics(checked.codes.reshape(checked.batch), checked.known, torques, rotations)

    def sensitivities(
        self,
        poses: ArrayLike,
        parameters: Sequence[str] | None = None,
        *,
        close: float = 1e-6,
        on_error: OnError = "raise",
        fields: Fields = None,
        out: Out = None,
        backend: str = AUTO,
        threads: int | None = None,
    ) -> Sensitivities:
        """Compute exact derivatives of matrices and modes with respect to parameters, at fixed platform poses.

        Parameters
        ----------
        poses, on_error, out
            As for `modes`.
        parameters : sequence of str, optional
            Parameter paths (docs/sensitivities.md); by default all quantities of the robot and all effect parameters.
        close : float
            Modes whose eigenvalues differ by less than this fraction form one group.
        fields : sequence of str, optional
            Which of `Sensitivities.FIELDS` to compute and keep; by default all, or the fields in `out`.
            ``"frequencies"`` and ``"eigenvalues"`` alone take a hundredth of the time or, without the compiled
            library, a sixth.
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
            self._resolved(parameters),
            poses,
            on_error,
            self.max_condition,
            close,
            fields,
            out,
            self._compiled(backend),
            checked_threads(threads),
        )

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
        progress: Callable[[int, int], None] | None = None,
    ) -> Dataset:
        """Compute the modes over the workspace, and over ranges of parameters.

        Parameters
        ----------
        grid : mapping of str to array_like, or array_like of shape (N, d), optional
            Ascending values, or one number, for each component of the pose, in SI units; or poses one after the
            other.  By default a grid over the reachable workspace.
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
        >>> found = model.map({"x": np.linspace(0.3, 0.8, 6), "y": 0.0, "z": -0.245})
        >>> found.frequency.sel(mode=1).squeeze().round(2).values
        array([46.34, 49.55, 54.23, 55.56, 50.33, 46.8 ])
        """
        from pkmodes.maps.mapping import map_of

        return map_of(
            self,
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
            progress=progress,
        )

    def _resolved(self, parameters: Sequence[str] | None) -> ResolvedPaths:
        """Resolve parameter paths; those of the last call are kept."""
        from pkmodes.sensitivity.sensitivities import ResolvedPaths

        if parameters is None:
            key: tuple[str, ...] | None = None
        elif isinstance(parameters, list | tuple) and all(isinstance(path, str) for path in parameters):
            key = tuple(parameters)
        else:  # anything else is converted or refused
            return ResolvedPaths(self.robot, parameters)
        found = self._resolved_paths
        if found is None or found[0] != key:
            found = self._resolved_paths = key, ResolvedPaths(self.robot, parameters)
        return found[1]
