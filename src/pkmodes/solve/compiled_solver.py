"""The back end of compiled libraries, which leaves the poses that they cannot solve accurately to NumPy."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, ClassVar, Self

import numpy as np
from numpy.typing import NDArray

from pkmodes.compiled.lanes import FIELDS, UNSOLVED, Along, Terms
from pkmodes.linalg.eigen import has_stiff_joint, held_softly
from pkmodes.mechanism.poses import CHUNK
from pkmodes.solve.at_poses import RobotAtPoses
from pkmodes.solve.solver import EIGENVALUES, Codes, Solver, UnavailableError
from pkmodes.system.evaluation import Evaluation

if TYPE_CHECKING:
    from pkmodes.compiled.evaluator import Evaluator

Array = NDArray[np.float64]
#: Very soft and very stiff released joints cost digits: NumPy solves where the lowest eigenvalue of vibration is
#: below this fraction, or the highest one above this multiple, of the highest one of the base coordinates.
SOFT, STIFF = 1e-5, 1e3
#: Without released joints, below this fraction; NumPy refuses a tenth of it.
APART = 1e-6


class CompiledSolver(Solver):
    """Evaluates modes with the compiled library of a mechanism.

    Parameters
    ----------
    system : Evaluation
        Of the same robot or robots.
    """

    name = "compiled"
    fields: ClassVar[frozenset[str]] = frozenset(FIELDS)
    checks_poses = True
    differentiates = True
    together = True
    #: The fields that need the eigenproblem.
    _of_modes = frozenset({"frequencies", EIGENVALUES, "shapes", "platform_shapes"})

    def __init__(self, evaluator: Evaluator, system: Evaluation) -> None:
        self.evaluator, self._system = evaluator, system
        self._released = len(system.coordinates) > system.first

    @classmethod
    def init(cls, system: Evaluation, largest_condition: float) -> Self:
        """Load the library of a robot's mechanism, or build it.

        Raises
        ------
        UnavailableError
            If there is no library.
        """
        # Building and loading libraries needs modules that are slow to import.
        from pkmodes.compiled import loader
        from pkmodes.compiled.evaluator import Evaluator

        mechanism = system.mechanism
        try:
            library = loader.load(mechanism.package, mechanism.name)
            lanes = system.lanes()
        except loader.UnavailableError as error:
            raise UnavailableError(
                f"the compiled back end is not available: {error.why}", mechanism.name, error.remedy
            ) from None
        directions = len(mechanism.directions)
        return cls(Evaluator(library, lanes, len(system.coordinates), largest_condition, directions), system)

    def compute(self, at: RobotAtPoses, arrays: Mapping[str, Array], threads: int = 1) -> Codes:
        """Fill arrays."""
        shown = EIGENVALUES if self._released or self._system.held_motions else "frequencies"
        if not {shown, EIGENVALUES} & set(arrays) and not self._of_modes.isdisjoint(arrays):
            # They show what the kernel cannot resolve.
            arrays = {**arrays, shown: np.empty((len(at.points), self.evaluator.modes))}
        return self._marked(self.evaluator.run(at.points, arrays, threads), arrays)

    def rates(self, at: RobotAtPoses, arrays: Mapping[str, Array], terms: Terms, threads: int = 1) -> Codes:
        """Fill arrays, also with derivatives."""
        return self._marked(self.evaluator.run(at.points, arrays, threads, terms=terms), arrays)

    def along(self, at: RobotAtPoses, eigenvalues: Array, shapes: Array, terms: Terms) -> Along | None:
        """Return what the derivatives of given modes along paths need; None if a pose cannot be evaluated."""
        return self.evaluator.along(at.points, eigenvalues, shapes, terms)

    def _marked(self, codes: Codes, arrays: Mapping[str, Array]) -> Codes:
        """Mark the poses at which the kernel cannot resolve a vibration."""
        if not self._of_modes.isdisjoint(arrays):
            for start in range(0, len(codes), CHUNK):
                part = slice(start, start + CHUNK)
                unresolved = self._unresolved({name: array[part] for name, array in arrays.items()})
                if unresolved.any():
                    codes[part][(codes[part] == 0) & unresolved] = UNSOLVED
        return codes

    def _unresolved(self, arrays: Mapping[str, Array]) -> NDArray[np.bool_]:
        """Return where joints are too soft or too stiff, springs to ground too soft, or magnitudes too different."""
        system = self._system
        first, rigid = system.first, system.rigid_modes
        if EIGENVALUES not in arrays:
            frequencies = arrays["frequencies"]
            return np.asarray(np.abs(frequencies[:, rigid]) < APART**0.5 * np.abs(frequencies[:, first - 1]))
        eigenvalues = arrays[EIGENVALUES]
        last = np.abs(eigenvalues[:, first - 1])
        unresolved = np.abs(eigenvalues[:, rigid]) < (SOFT if self._released else APART) * last
        unresolved |= held_softly(eigenvalues, system.held_motions)
        if self._released:
            unresolved |= has_stiff_joint(eigenvalues, first, rigid) | (eigenvalues[:, -1] > STIFF * last)
        return np.asarray(unresolved)
