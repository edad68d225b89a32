r"""Standard deviations of modes of subspace identification, to first order.

A change dH of the Hankel matrix of the correlations changes an eigenvalue of the state matrix by

.. math:: d\lambda_i = w_i (dH_\downarrow - \lambda_i dH_\uparrow) b_i ,

where w_i is a row of the left eigenvectors times the pseudo-inverse of the observability matrix, and b_i takes H to
the eigenvector (Reynders, Pintelon and De Roeck, Mechanical Systems and Signal Processing 22(4), 2008; Doehler and
Mevel, ibid. 38(2), 2013).  The references take the covariance of dH from segments of the record.  Here dH is a sum
over spectral lines, so that d lambda is a sum of a quadratic form z(f) of the lines.  Lines of a record are nearly
independent, and their expectation is a smooth function of frequency, so that half the sum of squares of the
differences between neighbours is the variance of the sum.  There are far more lines than segments; and the
uncertainty of a decay or a sweep is found too, in which segments differ although nothing is random.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.ssi import OrderModes
from pkmodes.modaltest.identification.ssi_bands import BandPart, SpectralLines

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class ModeSigmas:
    """Standard deviations of a mode: frequency [Hz], damping ratio, and shape relative to its largest component."""

    frequency: float
    damping: float
    shape: float


def mode_sigmas(
    lines: Sequence[SpectralLines],
    part: BandPart,
    references: Array,
    first_lag: int,
    order: OrderModes,
    i: int,
    scales: Array,
) -> ModeSigmas:
    """Return the standard deviations of mode i of a model order.

    - lines: lines of the pieces of the record, without padding
    - references: (S, r)
    - first_lag: first lag of the Hankel matrix
    - scales: factors from responses to components of the shape, (S,)
    """
    s = complex(part.pole(order.values[i : i + 1])[0])
    variances = np.zeros(2)
    shape = order.shapes[:, i] * scales
    largest = int(np.argmax(np.abs(shape)))
    shape_variances = np.zeros(len(shape))
    for piece in lines:
        dlambda, dshape = _line_contributions(piece.select(part), part, references, first_lag, order, i)
        ds = part.rate * dlambda / order.values[i]
        dabs = (ds * s.conjugate()).real / abs(s)
        dzeta = -ds.real / abs(s) + s.real * dabs / abs(s) ** 2
        changes = dshape * scales
        ratio = (changes - (shape / shape[largest]) * changes[:, largest : largest + 1]) / shape[largest]
        variances += [_variance_of_sum(dabs) / (2.0 * math.pi) ** 2, _variance_of_sum(dzeta)]
        shape_variances += [_variance_of_sum(column) for column in ratio.real.T]
    other_variances = np.delete(shape_variances, largest)
    frequency, damping = np.sqrt(variances)
    return ModeSigmas(
        float(frequency),
        float(damping),
        math.sqrt(float(other_variances.mean())) if other_variances.size else 0.0,
    )


def _line_contributions(
    lines: SpectralLines, part: BandPart, references: Array, first_lag: int, order: OrderModes, i: int
) -> tuple[Complex, Complex]:
    """Return the contribution of each line to eigenvalue and shape: (F,) and (F, S)."""
    Y = lines.values
    S, r = references.shape
    blocks = order.rows.shape[1] // S
    theta = 2.0 * math.pi * (lines.frequencies - part.start) / part.rate
    turns = np.exp(1j * np.outer(theta, np.arange(blocks)))
    weight = part.window(lines.frequencies) * lines.step * np.exp(1j * first_lag * theta)
    right = ((Y.conj() @ references) * (turns @ order.columns[:, i].reshape(blocks, r))).sum(axis=1) * weight
    rows = order.rows.reshape(-1, blocks, S)
    left = np.einsum("fs,fns->fn", Y, np.tensordot(turns, rows, (1, 1)))
    change = left * (right * (np.exp(1j * theta) - order.values[i]))[:, None]
    differences = order.values[i] - order.values
    differences[i] = np.inf
    return change[:, i], Y * right[:, None] + (change / differences) @ order.shapes.T


def _variance_of_sum(values: Array) -> float:
    """Return the variance of the sum of independent values whose expectation changes slowly."""
    return 0.5 * float((np.diff(values) ** 2).sum())
