"""Modes in the course of an identification: their poles, and the residues of their functions."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, eq=False)
class IdentifiedModes:
    """Several modes.

    - poles: (N,) [1/s]
    - shapes: at any scale, (N, S); NaN where not measured
    - participation: participations of the references, (N, R); its product with the shape is the residue
    """

    poles: Complex
    shapes: Complex
    participation: Complex

    @property
    def frequencies(self) -> Array:
        """Undamped natural frequencies, (N,) [Hz]."""
        return np.abs(self.poles) / (2.0 * math.pi)

    @property
    def half_widths(self) -> Array:
        """Half bandwidths, (N,) [Hz]."""
        return np.abs(self.poles.real) / (2.0 * math.pi)

    @property
    def residues(self) -> Complex:
        """Residues, (N, S, R)."""
        return np.asarray(self.shapes[:, :, None] * self.participation[:, None, :])

    def select(self, mask: NDArray[np.bool_]) -> IdentifiedModes:
        """Return some of the modes."""
        return IdentifiedModes(self.poles[mask], self.shapes[mask], self.participation[mask])

    def response(self, frequencies: Array) -> Complex:
        """Return the sum of the modes and their conjugates at frequencies [Hz], (F, S, R)."""
        s = 2j * math.pi * frequencies[:, None]
        return np.asarray(
            np.tensordot(1.0 / (s - self.poles), self.residues, 1)
            + np.tensordot(1.0 / (s - self.poles.conj()), self.residues.conj(), 1)
        )
