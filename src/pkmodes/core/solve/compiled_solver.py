"""The back end of compiled libraries, which leaves the poses that they cannot solve accurately to NumPy."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.compiled.lanes import FIELDS, UNSOLVED, Terms
from pkmodes.core.linalg.eigen import has_soft_ground_springs, has_stiff_joint
from pkmodes.core.mechanism.poses import CHUNK
from pkmodes.core.solve.at_poses import RobotAtPoses
from pkmodes.core.solve.solver import EIGENVALUES, Alone, Codes, Solver, UnavailableError
from pkmodes.core.system.evaluation import Evaluation

if TYPE_CHECKING:
    from pkmodes.core.compiled.evaluator import Evaluator, Room

Array = NDArray[np.float64]
#: Very soft and very stiff released joints cost digits: NumPy solves where the lowest eigenvalue of vibration is
#: below this fraction, or the highest one above this multiple, of the highest one of the base coordinates.
SOFT, STIFF = 1e-5, 1e3
#: The fraction without released joints; NumPy refuses robots below a tenth of it.
APART = 1e-6


class CompiledSolver(Solver):
    """Evaluates modes with the compiled library of a mechanism.

    - system: of the same robot or robots
    """

    name = "compiled"
    fields: ClassVar[frozenset[str]] = frozenset(FIELDS)
    checks_poses = True
    differentiates = True
    together = True
    #: The fields that need the eigenproblem.
    _of_modes = frozenset({"frequencies", EIGENVALUES, "shapes", "platform_shapes", "vibration_amplitudes"})

    def __init__(self, evaluator: Evaluator, system: Evaluation) -> None:
        self.evaluator, self._system = evaluator, system
        self._released = len(system.coordinates) > system.first

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

    def compute(self, at: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill arrays."""
        shown = self._shown_by(arrays)
        if shown is not None and shown not in arrays:
            arrays = {**arrays, shown: np.empty((len(at.points), self.evaluator.modes))}
        return self._marked(self.evaluator.run(at.points, arrays, threads), arrays)

    def alone(self, tails: Mapping[str, tuple[int, ...]]) -> Alone:
        """Return what fills arrays at a single pose, in a separate room for each thread."""
        shown, size = self._shown_by(tails), len(self._system.mechanism.pose)
        all_tails = dict(tails) if shown is None else {**tails, shown: (self.evaluator.modes,)}
        rooms: list[Room] = []  # those that no thread is using

        def of_pose(point: Array) -> dict[str, Array] | None:
            try:
                room = rooms.pop()
            except IndexError:
                room = self.evaluator.room(size, all_tails)
            copies = None
            if room.run(point) == 0 and not (shown and self.unresolved(shown, room.arrays[shown][0])):
                copies = {name: room.arrays[name].copy() for name in tails}
            rooms.append(room)
            return copies

        return of_pose

    def _shown_by(self, names: Collection[str]) -> str | None:
        """Return the field that shows what the kernel cannot resolve, where some fields are evaluated.

        None if none of them needs the eigenproblem.
        """
        if self._of_modes.isdisjoint(names):
            return None
        if EIGENVALUES in names or self._released or self._system.held_motions:
            return EIGENVALUES
        return "frequencies"

    def rates(self, at: RobotAtPoses, arrays: Mapping[str, Array], terms: Terms, threads: int = 1) -> Codes:
        """Fill arrays, also with derivatives."""
        return self._marked(self.evaluator.run(at.points, arrays, threads, terms=terms), arrays)

    def along(
        self, at: RobotAtPoses, modes: tuple[Array, Array] | None, terms: Terms, fields: Sequence[str]
    ) -> dict[str, Array] | None:
        """Return what the derivatives of given modes along paths need; None if a pose cannot be evaluated."""
        return self.evaluator.along(at.points, modes, terms, fields)

    def _marked(self, codes: Codes, arrays: Mapping[str, Array]) -> Codes:
        """Mark the poses at which the kernel cannot resolve a vibration."""
        shown = self._shown_by(arrays)
        if shown is not None:
            for start in range(0, len(codes), CHUNK):
                part = slice(start, start + CHUNK)
                unresolved = self.unresolved(shown, arrays[shown][part])
                if unresolved.any():
                    codes[part][(codes[part] == 0) & unresolved] = UNSOLVED
        return codes

    def unresolved(self, shown: str, values: Array) -> NDArray[np.bool_]:
        """Return where joints are too soft or too stiff, springs to ground too soft, or magnitudes too different.

        - shown: "eigenvalues" or "frequencies"
        - values: of this field, (N, m) or (m,)

        Returns (N,) or ().
        """
        system = self._system
        first, rigid = system.first, system.rigid_modes
        of_mode = values.T  # numbers where there is no batch
        last = abs(of_mode[first - 1])
        if shown != EIGENVALUES:
            return np.asarray(abs(of_mode[rigid]) < APART**0.5 * last)
        unresolved = abs(of_mode[rigid]) < (SOFT if self._released else APART) * last
        if system.held_motions:
            unresolved = unresolved | has_soft_ground_springs(values, system.loose_motions)
        if self._released:
            unresolved = unresolved | has_stiff_joint(values, first, rigid) | (of_mode[-1] > STIFF * last)
        return np.asarray(unresolved)
