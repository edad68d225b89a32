"""How alike measured shapes and modes of a model are: the modal assurance criterion, of one mode or of several.

Measured shapes may be at any of the model's channels, blank where they were not measured, and of any scale and sign
(MAC; Allemang, Sound and Vibration 37(8), 2003).  Modes whose frequencies nearly agree may be any combination of
each other: a measured shape is then compared with the space that they span.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Index = NDArray[np.intp]

#: Modes whose measured components differ by less than this fraction are seen alike.
ALIKE = 1e-6


class MeasuredShapes:
    """Shapes that were measured in one setup.

    Parameters
    ----------
    shapes : ndarray, shape (r, C)
        NaN where a component was not measured.
    """

    def __init__(self, shapes: Array) -> None:
        self.measured = np.isfinite(shapes)
        values = np.where(self.measured, shapes, 0.0)
        largest = np.max(np.abs(values), axis=1, initial=0.0, keepdims=True)
        self.shapes = values / np.where(largest > 0.0, largest, 1.0)
        self.told = (self.measured.sum(axis=1) >= 2) & self.shapes.any(axis=1)
        masks = np.unique(self.measured[self.told], axis=0)
        #: Which components were measured together, and in which rows.
        self.patterns = [
            (mask, np.flatnonzero(self.told & (self.measured == mask).all(axis=1))) for mask in masks
        ]


class Likeness:
    """Modal assurance criteria of measured shapes with modes of a model.

    Parameters
    ----------
    measured : MeasuredShapes
    shapes : ndarray, shape (m, C)
        All modes of the model at the channels, mass-normalised.
    modes : ndarray of int, shape (k,)
        The modes to compare with.
    moves : ndarray, shape (C,)
        How much each channel moves, see `channel_motion`.

    Attributes
    ----------
    alone : ndarray, shape (r, k)
        With each mode; NaN for rows of which no shape is known.
    """

    def __init__(self, measured: MeasuredShapes, shapes: Array, modes: Index, moves: Array) -> None:
        self._measured, self._spaces = measured, dict[bytes, Array]()
        self.alone = np.full((len(measured.shapes), len(modes)), np.nan)
        if not shapes.shape[1]:
            return
        # What moves in none of the modes that all models are measured by counts by this one.
        moves = np.where(moves > 0.0, moves, channel_motion(shapes))
        weights = np.where(moves > 0.0, 1.0 / np.where(moves > 0.0, moves, 1.0), 0.0)
        self._model, self._shapes = shapes[modes] * weights, measured.shapes * weights
        lengths = (self._shapes**2).sum(axis=1)
        told = measured.told & (lengths > 0.0)
        self._lengths = np.where(told, lengths, np.nan)
        sizes = measured.measured.astype(float) @ (self._model**2).T
        along = (self._shapes @ self._model.T) ** 2
        self.alone[told] = (along / (np.where(sizes > 0.0, sizes, 1.0) * self._lengths[:, None]))[told]

    def together(self, members: NDArray[np.bool_]) -> Array:
        """Part of each measured shape that lies in the space of some of the modes; NaN where any shape would."""
        key = members.tobytes()
        if key not in self._spaces:
            self._spaces[key] = self._in_space(members)
        return self._spaces[key]

    def _in_space(self, members: NDArray[np.bool_]) -> Array:
        found = np.full(len(self.alone), np.nan)
        for mask, rows in self._measured.patterns:
            if mask.sum() > members.sum():
                # By singular values: where the sensors see two modes alike, they span one direction.
                basis, size, _ = np.linalg.svd(self._model[members][:, mask].T, full_matrices=False)
                basis = basis[:, size > ALIKE * size[0]]
                found[rows] = ((self._shapes[rows][:, mask] @ basis) ** 2).sum(axis=1) / self._lengths[rows]
        return found


def channel_motion(shapes: Array) -> Array:
    """How much each channel moves in all modes together, (..., C): metres beside radians count by that.

    For mass-normalised shapes it is the root of the inverse of the channel's effective mass.  Hypotheses that are to
    be compared must be measured by the same model's, or one that adds modes would seem to fit better.

    Parameters
    ----------
    shapes : ndarray, shape (..., m, C)
    """
    moves: Array = np.sqrt(np.nansum(shapes**2, axis=-2))
    return moves
