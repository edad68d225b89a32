r"""Effects of arbitrary changes of a structure on the data.

Independent relative changes :math:`\xi_{ij} = \xi_{ji}` of the modal stiffnesses and
:math:`\eta_{ij} = \eta_{ji}` of the modal masses give

.. math:: d \ln f_i = \tfrac12 (\xi_{ii} - \eta_{ii}), \qquad
    d\phi_i = \sum_{j \ne i} \phi_j \frac{\sqrt{\lambda_i \lambda_j} \, \xi_{ij} - \lambda_i \eta_{ij}}
    {\lambda_i - \lambda_j} :

each shape changes mostly by the shapes of neighbouring modes, and the shapes of two neighbours change together, so
twelve shape values carry less information than twelve independent ones.
"""

from __future__ import annotations

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit
from pkmodes.diagnosis.problem import Array, Prediction

#: Modes beyond the highest measured one whose shapes are mixed into it.
ABOVE = 3


def draws(fitter: Fitter, plain: Fit, count: int, rng: np.random.Generator) -> Array:
    """Draw the effects of arbitrary changes on the whitened data beside a fit, (D, count).

    The changes in different setups are independent, as if the structure differed between them.
    """
    used, data = fitter.used(plain.hypothesis), fitter.prior_rows.start
    # Modes far above the measured ones do not contribute to their shapes.
    modes = int(plain.pairing.partner.max(initial=0)) + 1 + ABOVE
    changed = _changed(plain.prediction, modes, fitter.criteria.mixed)
    changes = fitter.rows.rates(changed, plain.pairing, used) / fitter.noise.stated[:, None]
    drawn = np.zeros((len(plain.white), count))
    for place in fitter.places():
        drawn[place] = changes[place] @ rng.standard_normal((changes.shape[1], count))
    drawn -= plain.basis @ (plain.basis[:data].T @ drawn[:data])
    return drawn


def _changed(prediction: Prediction, modes: int, least: float) -> Prediction:
    """Return the lowest modes with their derivatives with respect to relative changes of modal stiffness and mass."""
    eigenvalues, shapes = prediction.eigenvalues[:, :modes], prediction.shapes[:, :modes]
    m = eigenvalues.shape[1]
    i, j = np.triu_indices(m)
    size = np.abs(eigenvalues)
    gap = eigenvalues[:, i] - eigenvalues[:, j]
    # Nearly coincident modes rotate into each other under any change; they are compared as one subspace.
    smallest = 2.0 * least * np.maximum(size[:, i], size[:, j])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(smallest, 1e-300))
    mean = np.sqrt(size[:, i] * size[:, j])
    rates = np.zeros((len(eigenvalues), m, 2, len(i)))
    along = np.zeros((*shapes.shape, 2, len(i)))
    for t in np.flatnonzero(i == j):
        rates[:, i[t], 0, t], rates[:, i[t], 1, t] = eigenvalues[:, i[t]], -eigenvalues[:, i[t]]
    for t in np.flatnonzero(i != j):
        for a, b, sign in ((i[t], j[t], 1.0), (j[t], i[t], -1.0)):
            along[:, a, :, 0, t] = sign * (mean / gap)[:, t, None] * shapes[:, b]
            along[:, a, :, 1, t] = -sign * (size[:, a] / gap[:, t])[:, None] * shapes[:, b]
    return Prediction(
        eigenvalues,
        rates.reshape(len(eigenvalues), m, -1),
        shapes,
        prediction.rigid,
        along.reshape(*shapes.shape, -1),
    )
