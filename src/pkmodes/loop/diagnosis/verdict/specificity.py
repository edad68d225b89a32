"""Specificity: whether the data suffice to tell a cause from something outside the candidates.

The residual of a cause outside the candidates may look like a candidate by chance, especially with few data.  The
probability is estimated by simulation: residuals as large as the measured one, drawn from changes of the structure
that are not candidates, are compared with the linear signature of every candidate.  There are two kinds of draws:
arbitrary changes, independent in all setups, and plausible ones, combinations of the candidates.  A draw has the
size of what the claim explains and leaves, plus what noise would hide; it looks like a candidate if that explains as
much of it as the claim does of the residual.
"""

from __future__ import annotations

from dataclasses import dataclass
from itertools import combinations

import numpy as np

from pkmodes.core.linalg.decomposition import thin_svd
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, orthonormal
from pkmodes.loop.diagnosis.problem import Array, Prediction
from pkmodes.loop.diagnosis.search.score import Directions, score
from pkmodes.loop.diagnosis.search.search import Search

#: Relative singular value below which signatures differ only by numerical errors.
SIGNATURE_TOLERANCE = 1e-3
#: Number of draws of each kind, and their seed.
DRAWS, SEED = 2_000, 20_221_107
#: Modes beyond the highest measured one whose shapes are mixed into it.
MODES_ABOVE = 3


@dataclass(frozen=True)
class PlausibleChanges:
    r"""Directions of plausible changes.

    A plausible change affects the data as candidates do, remote ones included, smoothly over the setups, but in any
    combination.  With the unit signatures :math:`g_1 \dots g_n`, one of them at random with the size :math:`a` has
    the covariance :math:`\frac{a^2}{n} \sum g_k g_k^T`, with eigenvalues :math:`v_i` in units of the noise.  A change
    is drawn with the variance

    .. math:: w_i = \frac{v_i}{1 + v_i}

    along the i-th eigenvector.  Directions that stand out from the noise count equally, however many candidates are
    nearly parallel to them, and those that vanish in the noise do not count: :math:`\sum w_i` is the number of
    directions that the data resolve at this size.  It depends on the information in the data and not on the number of
    rows: the same rows twice, with errors :math:`\sqrt 2` times as large, change nothing.

    - axes: orthonormal directions in the whitened data, (D, k)
    - weights: their variances in the draws, between 0 and 1, (k,)
    - direction_count: number of directions in which the candidates differ, whatever the errors of the data
    """

    axes: Array
    weights: Array
    direction_count: int

    @classmethod
    def of(cls, directions: Directions, size: float) -> PlausibleChanges:
        """Return the directions in which changes like some candidates differ.

        - size: norm of their effect on the whitened data
        """
        signatures = np.hstack([axes for axes, _ in directions])
        axes, s, _ = thin_svd(signatures)
        variance = (size * s) ** 2 / signatures.shape[1]
        return cls(
            axes, variance / (1.0 + variance), int((s > SIGNATURE_TOLERANCE * s.max(initial=0.0)).sum())
        )

    @property
    def resolved_count(self) -> float:
        """Number of directions that the data resolve."""
        return float(self.weights.sum())

    def draws(self, count: int, rng: np.random.Generator) -> Array:
        """Draw changes, as coordinates along the axes, (k, count)."""
        changes: Array = np.sqrt(self.weights)[:, None] * rng.standard_normal((len(self.weights), count))
        return changes

    def squares(self, white: Array) -> float:
        """Return the squares of a residual in the resolved directions."""
        return float(self.weights @ (self.axes.T @ white) ** 2)


def p_coincidence(search: Search, final: Fit) -> float:
    """Return the probability that as many candidates explain a residual of this size although none caused it."""
    store, fitter, h = search.store, search.store.fitter, final.hypothesis
    fit_without_causes = store.fit(
        Hypothesis(excluded_rows=h.excluded_rows, has_shared_error=h.has_shared_error)
    )
    if fit_without_causes is None or not final.causes:
        return 0.0
    rng = np.random.default_rng(SEED)
    gain, directions = fit_without_causes.chi2 - final.chi2, search.gate(fit_without_causes).scores.directions
    used_row_mask, data = fitter.used_row_mask(h), slice(0, fitter.prior_slice.start)
    degrees = float(
        fitter.observations.degrees_of_freedom(used_row_mask) - fit_without_causes.leverage[data].sum()
    )
    changes = arbitrary_draws(fitter, fit_without_causes, DRAWS, rng)
    p_value = coincidence(search, final, gain, changes, directions, degrees, final.chi2)
    # A few candidates do not represent what else may be wrong: their combinations are not informative.
    all_directions = (*directions, *score(fitter, fit_without_causes, search.remote_candidates).directions)
    min_directions = search.criteria.claim.many * len(final.causes)
    if gain <= 0.0 or len(all_directions) < min_directions:
        return p_value
    plausible_changes = PlausibleChanges.of(all_directions, float(np.sqrt(gain)))
    if plausible_changes.direction_count >= min(min_directions, len(plausible_changes.axes)):
        rotated_directions = [(plausible_changes.axes.T @ axes, sign) for axes, sign in directions]
        changes, squares = plausible_changes.draws(DRAWS, rng), plausible_changes.squares(final.white)
        p_value = max(
            p_value,
            coincidence(
                search, final, gain, changes, rotated_directions, plausible_changes.resolved_count, squares
            ),
        )
    return p_value


def coincidence(
    search: Search,
    final: Fit,
    gain: float,
    changes: Array,
    directions: Directions,
    degrees: float,
    squares: float,
) -> float:
    """Return the fraction of changes that some candidates explain as well as the claimed causes do the residual.

    - gain: decrease of chi2 by the claimed causes
    - changes: effects of changes on the data, of any size, (D, n)
    - directions: those of the candidates, in the same D coordinates
    - degrees: number of directions in which the changes differ
    - squares: sum of squares that the claimed causes leave in these directions
    """
    spare_degrees = degrees - sum(len(cause.parameters) for cause in final.causes)
    if spare_degrees <= 0.0:
        return 1.0
    # What the claim leaves beyond noise, another cause may leave too, and noise may hide more.
    size = (
        gain
        + max(squares - spare_degrees, 0.0)
        + search.criteria.claim.spread * float(np.sqrt(2.0 * spare_degrees))
    )
    scaled_changes = changes * (np.sqrt(size) / np.maximum(np.linalg.norm(changes, axis=0), 1e-300))
    is_explained = np.zeros(changes.shape[1], dtype=bool)
    for causes in combinations(directions, len(final.causes)):
        (axes, sign), *others = causes
        if not others and sign:
            projections = axes[:, 0] @ scaled_changes
            removed_squares = np.where(projections > 0.0, projections**2, 0.0)
        else:
            basis = axes if not others else orthonormal(np.hstack([axes for axes, _ in causes]))
            removed_squares = ((basis.T @ scaled_changes) ** 2).sum(axis=0)
        is_explained |= removed_squares >= gain
    return float(is_explained.mean())


def arbitrary_draws(fitter: Fitter, fit: Fit, count: int, rng: np.random.Generator) -> Array:
    r"""Draw the effects of arbitrary changes on the whitened data beside a fit, (D, count).

    Independent relative changes :math:`\xi_{ij} = \xi_{ji}` of the modal stiffnesses and
    :math:`\eta_{ij} = \eta_{ji}` of the modal masses give

    .. math:: d \ln f_i = \tfrac12 (\xi_{ii} - \eta_{ii}), \qquad
        d\phi_i = \sum_{j \ne i} \phi_j \frac{\sqrt{\lambda_i \lambda_j} \, \xi_{ij} - \lambda_i \eta_{ij}}
        {\lambda_i - \lambda_j} :

    each shape changes mostly by the shapes of neighbouring modes, and the shapes of two neighbours change together,
    so twelve shape values carry less information than twelve independent ones.  The changes in different setups are
    independent, as if the structure differed between them.
    """
    data, modal_effects = fitter.prior_slice.start, modal_changes(fitter, fit)
    effects = np.zeros((len(fit.white), count))
    for rows in fitter.observations.data_indices_by_setup():
        effects[rows] = modal_effects[rows] @ rng.standard_normal((modal_effects.shape[1], count))
    effects -= fit.basis @ (fit.basis[:data].T @ effects[:data])
    return effects


def modal_changes(fitter: Fitter, fit: Fit) -> Array:
    """Return the effects of relative changes of the modal stiffnesses and masses on the whitened data, (D, k)."""
    used_row_mask = fitter.used_row_mask(fit.hypothesis)
    # Modes far above the measured ones do not contribute to their shapes.
    modes = int(fit.pairing.partner.max(initial=0)) + 1 + MODES_ABOVE
    eigenvalues, shapes = fit.prediction.eigenvalues[:, :modes], fit.prediction.shapes[:, :modes]
    mode_count = eigenvalues.shape[1]
    i, j = np.triu_indices(mode_count)
    magnitudes = np.abs(eigenvalues)
    gap = eigenvalues[:, i] - eigenvalues[:, j]
    # Nearly coincident modes rotate into each other under any change; they are compared as one subspace.
    min_gaps = 2.0 * fitter.criteria.pairing.mixed * np.maximum(magnitudes[:, i], magnitudes[:, j])
    gap = np.where(gap >= 0.0, 1.0, -1.0) * np.maximum(np.abs(gap), np.maximum(min_gaps, 1e-300))
    mean = np.sqrt(magnitudes[:, i] * magnitudes[:, j])
    rates = np.zeros((len(eigenvalues), mode_count, 2, len(i)))
    shape_rates = np.zeros((*shapes.shape, 2, len(i)))
    for t in np.flatnonzero(i == j):
        rates[:, i[t], 0, t], rates[:, i[t], 1, t] = eigenvalues[:, i[t]], -eigenvalues[:, i[t]]
    for t in np.flatnonzero(i != j):
        for a, b, sign in ((i[t], j[t], 1.0), (j[t], i[t], -1.0)):
            shape_rates[:, a, :, 0, t] = sign * (mean / gap)[:, t, None] * shapes[:, b]
            shape_rates[:, a, :, 1, t] = -sign * (magnitudes[:, a] / gap[:, t])[:, None] * shapes[:, b]
    changed_modes = Prediction(
        eigenvalues,
        rates.reshape(len(eigenvalues), mode_count, -1),
        shapes,
        fit.prediction.rigid,
        shape_rates.reshape(*shapes.shape, -1),
    )
    observations = fitter.observations
    return np.asarray(
        observations.rates(changed_modes, fit.pairing, used_row_mask)
        / observations.noise.stated_sigma[:, None]
    )
