"""What a back end provides: a solver of one robot's eigenproblem.

A further back end is a subclass of `Solver` and a line in `pkmodes.core.solve.backends.SOLVERS`.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Mapping, Sequence
from typing import ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.compiled.lanes import UNSOLVED, Terms
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.system.evaluation import Evaluation

Array = NDArray[np.float64]
Codes = NDArray[np.int8]
SinglePoseFunction = Callable[[Array], dict[str, Array] | None]
__all__ = ["EIGENVALUES", "SHAPES", "UNSOLVED", "Codes", "SinglePoseFunction", "Solver", "UnavailableError"]
EIGENVALUES, SHAPES = "eigenvalues", "shapes"


class UnavailableError(PkmodesError):
    """A back end cannot be used here."""


class Solver(ABC):
    """Solves the eigenproblem of one robot at poses.

    - name: as the user gives it
    - fields: the quantities that `compute` fills, at least ``eigenvalues`` and ``shapes``; other fields follow from
      them
    - cheap_fields: fields that cost no more than a copy where `compute` has solved for modes
    - checks_poses: whether `compute` checks the poses itself.  If not, it is given poses that can be evaluated, a few
      thousand at a time.
    - differentiates: whether it has `rates`
    - takes_several_robots: whether `init` also takes several robots, stacked into one system, with the same
      coordinates without inertia
    """

    name: ClassVar[str]
    fields: ClassVar[frozenset[str]] = frozenset({EIGENVALUES, SHAPES})
    cheap_fields: ClassVar[frozenset[str]] = frozenset()
    checks_poses: ClassVar[bool] = False
    differentiates: ClassVar[bool] = False
    takes_several_robots: ClassVar[bool] = False

    @property
    def inner(self) -> Solver:
        """The solver of the system that is solved, with shapes in its own coordinates."""
        return self

    @classmethod
    @abstractmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Prepare for a robot.

        - system: the robot; if `together`, also several
        - largest_condition: poses with a larger condition number are singular; for back ends that check poses

        Raises UnavailableError if the back end cannot be used here.
        """

    @abstractmethod
    def compute(self, state: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill arrays at N poses.

        - arrays: contiguous, by name of `fields`, each (N, ...); eigenvalues (N, m) ascending, shapes (N, m, n) as
          `condensed_eigh` returns them
        - threads: largest number of threads

        Returns (N,): 0 where the arrays are filled, `UNSOLVED` where NumPy has to do it; from a back end that checks
        poses, also indices into `pkmodes.core.mechanism.poses.codes_of`, where it fills NaN.
        """

    def single_pose_function(self, pose_shapes: Mapping[str, tuple[int, ...]]) -> SinglePoseFunction | None:
        """Return what fills arrays at a single pose with less overhead than `compute`; None if nothing does.

        - pose_shapes: shapes at one pose of fields of `fields`

        It returns, from a pose, (1, d), new arrays, (1, *tail), by field, to the last digit those of `compute`; None
        where `compute` has to evaluate the pose, because its code is not 0.  Several threads may call it.
        """
        return None

    def rates(
        self, state: RobotAtPoses, arrays: Mapping[str, Array], terms: Terms, threads: int = 1
    ) -> Codes:
        """Fill arrays as `compute` does, also with derivatives along paths, by the names of `Evaluator.run`."""
        raise NotImplementedError

    def along(
        self, state: RobotAtPoses, modes: tuple[Array, Array] | None, terms: Terms, fields: Sequence[str]
    ) -> dict[str, Array] | None:
        """Return what the derivatives of given modes along paths need; None if NumPy has to evaluate it.

        - modes: eigenvalues and shapes, (N, m) and (N, m, n); None for no mode
        - terms: of each robot
        - fields: as of `pkmodes.core.compiled.evaluator.Evaluator.along`
        """
        return None
