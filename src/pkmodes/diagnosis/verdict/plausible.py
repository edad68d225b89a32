r"""Effects of plausible changes of a structure on the data.

A plausible change affects the data as candidates do, remote ones included, smoothly over the setups, but in any
combination.  With the unit signatures :math:`g_1 \dots g_n`, one of them at random with the size :math:`a` has the
covariance :math:`\frac{a^2}{n} \sum g_k g_k^T`, with eigenvalues :math:`v_i` in units of the noise.  A change is
drawn with the variance

.. math:: w_i = \frac{v_i}{1 + v_i}

along the i-th eigenvector.  Directions that stand out from the noise count equally, however many candidates are
nearly parallel to them, and those that vanish in the noise do not count: :math:`\sum w_i` is the number of directions
that the data resolve at this size.  It depends on the information in the data and not on the number of rows: the same
rows twice, with errors :math:`\sqrt 2` times as large, change nothing.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from pkmodes.diagnosis.problem import Array
from pkmodes.diagnosis.search.score import Directions

#: Relative singular value below which signatures differ by their numerical errors only.
SAME = 1e-3


@dataclass(frozen=True)
class Plausible:
    """Directions of plausible changes.

    Attributes
    ----------
    axes : ndarray, shape (D, k)
        Orthonormal directions in the whitened data.
    weights : ndarray, shape (k,)
        Their variances in the draws, between 0 and 1.
    different : int
        Number of directions in which the candidates differ, whatever the errors of the data.
    """

    axes: Array
    weights: Array
    different: int

    @classmethod
    def of(cls, directions: Directions, size: float) -> Plausible:
        """Return the directions in which changes like some candidates differ.

        Parameters
        ----------
        size : float
            Norm of their effect on the whitened data.
        """
        signatures = np.hstack([axes for axes, _ in directions])
        axes, s, _ = np.linalg.svd(signatures, full_matrices=False)
        variance = (size * s) ** 2 / signatures.shape[1]
        return cls(axes, variance / (1.0 + variance), int((s > SAME * s.max(initial=0.0)).sum()))

    @property
    def resolved(self) -> float:
        """Number of directions that the data resolve."""
        return float(self.weights.sum())

    def draws(self, count: int, rng: np.random.Generator) -> Array:
        """Draw changes, as coordinates along the axes, (k, count)."""
        drawn: Array = np.sqrt(self.weights)[:, None] * rng.standard_normal((len(self.weights), count))
        return drawn

    def squares(self, white: Array) -> float:
        """Return the squares of a residual in the resolved directions."""
        return float(self.weights @ (self.axes.T @ white) ** 2)
