"""The back end that uses compiled libraries; NumPy solves the poses that these cannot solve accurately."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import FIELDS, UNSOLVED, Terms
from pkmodes.core.linalg.eigen import has_soft_ground_springs, has_stiff_joint
from pkmodes.core.mechanism.poses import CHUNK
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import EIGENVALUES, Codes, SinglePoseFunction, Solver, UnavailableError
from pkmodes.core.system.evaluation import Evaluation

if TYPE_CHECKING:
    from pkmodes.core.compiled.evaluator import Evaluator, PoseBuffer

Array = NDArray[np.float64]
#: Very soft and very stiff released joints cost digits: NumPy solves where the lowest eigenvalue of vibration is
#: below this fraction, or the highest one above this multiple, of the highest one of the base coordinates.
SOFT_FRACTION, STIFF_RATIO = 1e-5, 1e3
#: The same fraction for robots without released joints; NumPy refuses robots below a tenth of it.
SOFT_FRACTION_WITHOUT_JOINTS = 1e-6


class CompiledSolver(Solver):
    """Evaluates modes with the compiled library of a mechanism.

    - system: of the same robot or robots
    """

    name = "compiled"
    fields: ClassVar[frozenset[str]] = frozenset(FIELDS)
    checks_poses = True
    differentiates = True
    takes_several_robots = True
    #: The fields that need the eigenproblem.
    _mode_fields = frozenset(
        {"frequencies", EIGENVALUES, "shapes", "platform_shapes", "vibration_amplitudes"}
    )

    def __init__(self, evaluator: Evaluator, system: Evaluation) -> None:
        self.evaluator, self._system = evaluator, system
        self._released = len(system.coordinates) > system.base_count

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Load the library of a robot's mechanism, or build it.

        Raises UnavailableError if there is no library.
        """
        # Building and loading libraries needs modules that are slow to import.
        from pkmodes.core.compiled import loader
        from pkmodes.core.compiled.evaluator import Evaluator

        mechanism = system.mechanism
        try:
            library = loader.load(mechanism.package, mechanism.name)
            lanes = system.lanes()
        except loader.NoLibraryError as error:
            raise UnavailableError(
                f"the compiled back end is not available: {error.why}", mechanism.name, error.remedy
            ) from None
        evaluator = Evaluator(
            library,
            lanes,
            len(system.coordinates),
            largest_condition,
            components=len(mechanism.platform),
            size=len(mechanism.extended.COORDINATES),
            rigid_modes=system.rigid_modes,
        )
        return cls(evaluator, system)

    def compute(self, state: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill arrays."""
        indicator = self._indicator_field(arrays)
        if indicator is not None and indicator not in arrays:
            arrays = {**arrays, indicator: np.empty((len(state.points), self.evaluator.modes))}
        return self._mark_unresolved(self.evaluator.run(state.points, arrays, threads), arrays)

    def single_pose_function(self, pose_shapes: Mapping[str, tuple[int, ...]]) -> SinglePoseFunction:
        """Return what fills arrays at a single pose, with a separate buffer for each thread."""
        indicator, size = self._indicator_field(pose_shapes), len(self._system.mechanism.pose)
        all_shapes = (
            dict(pose_shapes) if indicator is None else {**pose_shapes, indicator: (self.evaluator.modes,)}
        )
        buffers: list[PoseBuffer] = []  # those that no thread is using

        def evaluate(point: Array) -> dict[str, Array] | None:
            try:
                buffer = buffers.pop()
            except IndexError:
                buffer = self.evaluator.buffer(size, all_shapes)
            fields = None
            if buffer.run(point) == 0 and not (
                indicator and self.unresolved(indicator, buffer.arrays[indicator][0])
            ):
                fields = {name: buffer.arrays[name].copy() for name in pose_shapes}
            buffers.append(buffer)
            return fields

        return evaluate

    def _indicator_field(self, names: Collection[str]) -> str | None:
        """Return the field from which to tell where the kernel loses digits, given the evaluated fields.

        None if no field needs the eigenproblem.
        """
        if self._mode_fields.isdisjoint(names):
            return None
        if EIGENVALUES in names or self._released or self._system.held_motions:
            return EIGENVALUES
        return "frequencies"

    def rates(
        self, state: RobotAtPoses, arrays: Mapping[str, Array], terms: Terms, threads: int = 1
    ) -> Codes:
        """Fill arrays, also with derivatives."""
        return self._mark_unresolved(self.evaluator.run(state.points, arrays, threads, terms=terms), arrays)

    def along(
        self, state: RobotAtPoses, modes: tuple[Array, Array] | None, terms: Terms, fields: Sequence[str]
    ) -> dict[str, Array] | None:
        """Return what the derivatives of given modes along paths need; None if a pose cannot be evaluated."""
        return self.evaluator.along(state.points, modes, terms, fields)

    def _mark_unresolved(self, codes: Codes, arrays: Mapping[str, Array]) -> Codes:
        """Mark the poses at which the kernel cannot resolve a vibration."""
        indicator = self._indicator_field(arrays)
        if indicator is not None:
            for start in range(0, len(codes), CHUNK):
                part = slice(start, start + CHUNK)
                unresolved = self.unresolved(indicator, arrays[indicator][part])
                if unresolved.any():
                    codes[part][(codes[part] == 0) & unresolved] = UNSOLVED
        return codes

    def unresolved(self, indicator: str, values: Array) -> NDArray[np.bool_]:
        """Return where joints are too soft or too stiff, springs to ground too soft, or magnitudes too different.

        - indicator: "eigenvalues" or "frequencies"
        - values: of this field, (N, m) or (m,)

        Returns (N,) or ().
        """
        system = self._system
        base_count, rigid = system.base_count, system.rigid_modes
        by_mode = values.T  # numbers where there is no batch
        highest_of_base = abs(by_mode[base_count - 1])
        if indicator != EIGENVALUES:
            return np.asarray(abs(by_mode[rigid]) < SOFT_FRACTION_WITHOUT_JOINTS**0.5 * highest_of_base)
        unresolved = (
            abs(by_mode[rigid])
            < (SOFT_FRACTION if self._released else SOFT_FRACTION_WITHOUT_JOINTS) * highest_of_base
        )
        if system.held_motions:
            unresolved = unresolved | has_soft_ground_springs(values, system.loose_motions)
        if self._released:
            unresolved = (
                unresolved
                | has_stiff_joint(values, base_count, rigid)
                | (by_mode[-1] > STIFF_RATIO * highest_of_base)
            )
        return np.asarray(unresolved)
