"""Dynamics of one robot at poses: modes, frequencies, matrices and statics.

Poses are checked, the generated model is called chunk by chunk, and the results are reshaped to the caller's axes.
There is no physics here.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.mechanism.poses import CHUNK, MAX_CONDITION, OnError
from pkmodes.robot.robot import Robot
from pkmodes.solve.backends import AUTO, COMPILED, NUMPY, checked_threads, chosen, compiled
from pkmodes.solve.gathering import Fields, Gathered, Out, chosen_fields
from pkmodes.solve.kinematics import Kinematics
from pkmodes.solve.results import CARRIAGES, JOINTS, Modes, Statics
from pkmodes.solve.solving import fields_of_modes
from pkmodes.system.evaluation import evaluation, matrices

if TYPE_CHECKING:
    from pkmodes.compiled.evaluator import Evaluator

Array = NDArray[np.float64]


class Dynamics(Kinematics):
    """The part of `pkmodes.Model` that computes vibrations and static equilibria.

    Parameters
    ----------
    robot : Robot
    max_condition : float
        Poses at which the condition number of the mechanism is larger are rejected as singular.

    Attributes
    ----------
    coordinates : tuple of str
        Names of the generalised coordinates (docs/model.md).
    """

    def __init__(self, robot: Robot, max_condition: float = MAX_CONDITION) -> None:
        super().__init__(robot, max_condition)
        self._evaluation = evaluation(robot)
        self.coordinates = self._evaluation.coordinates
        self._evaluators: dict[str, Evaluator | None] = {}

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
            Which of ``Modes.FIELDS`` to compute and keep, such as ``("frequencies", "platform_shapes")``; by default
            all, or the fields in `out`.  The values of a field do not depend on the other fields requested.
        out : mapping of str to ndarray, optional
            Arrays to fill in place, by field, with the shapes given in `Modes`; they become the fields.
        backend : {"auto", "numpy", "compiled"}
            What evaluates the modes: by default the compiled library if there is one, unless the environment variable
            ``PKMODES_BACKEND`` says otherwise.  ``Modes.backend`` tells which one ran.
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
        asked = chosen_fields(fields, out, Modes.fields_of(self.mechanism))
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
            from pkmodes.solve.compiled_modes import compiled_modes

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
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            As for `modes`; `check` says why a pose gives NaN.
        out : ndarray of float, shape (..., m), optional
            Filled in place and returned.
        backend : {"auto", "numpy", "compiled"}
            As for `modes`.
        threads : int, optional
            As for `modes`.

        Returns
        -------
        ndarray, shape (..., m)
            In Hz: sqrt(abs(lambda)) / (2 pi) with the sign of lambda, the rigid-body modes first.
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
            self._evaluators[name] = compiled(self.mechanism, self._evaluation, self.max_condition, name)
        return self._evaluators[name]

    def matrices(self, poses: ArrayLike, on_error: OnError = "raise") -> tuple[Array, Array]:
        """Compute the mass and stiffness matrices (equations 33 and 48).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        M : ndarray, shape (..., n, n)
            In SI units, in the order of `coordinates`; NaN where a pose could not be evaluated.
        K : ndarray, shape (..., n, n)
            Likewise.
        """
        checked = self._check(poses, on_error)
        M, K = self._evaluate(lambda p: matrices(self._evaluation, p), checked)
        return M, K

    def statics(self, poses: ArrayLike, on_error: OnError = "raise") -> Statics:
        """Compute the torques and rotations that hold the pose (equation 44).

        Parameters
        ----------
        poses : array_like, shape (d,) or (..., d)
            In SI units.
        on_error : {"raise", "nan"}
            With "nan", a pose that cannot be evaluated gives NaN.

        Returns
        -------
        Statics
            With the leading axes of the poses.
        """
        checked = self._check(poses, on_error)
        torques, rotations = self._evaluate(self._evaluation.statics, checked)
        return Statics(checked.codes.reshape(checked.batch), checked.known, torques, rotations)
