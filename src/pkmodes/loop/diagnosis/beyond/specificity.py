r"""Specificity: whether an effect that no term describes would look like a term.

Four kinds of residuals as large as the measured one are drawn, none of which a term causes: arbitrary changes of the
modes, independent in all setups, and combinations of all that was tried, as for the catalogue
(`verdict.specificity`); arbitrary changes of the modes, the same in all setups; and *laws*, in which a cause of the
catalogue varies: with the position, to first and second order, with the order in which setups were measured, or with
frequency.  A law is a signature times such a function of the row, without its mean,

.. math:: d_r = g_r \, (h_r - \sum g^2 h / \sum g^2) ,

since a mean would be equivalent to a change of the cause itself.  A law that explains these data as well as a term is
named.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np

from pkmodes.loop.diagnosis.beyond.term_fits import TermFits
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, orthonormal
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.search.score import Directions
from pkmodes.loop.diagnosis.verdict.specificity import (
    DRAWS,
    SEED,
    PlausibleChanges,
    arbitrary_draws,
    coincidence,
    modal_changes,
)

#: The part of a signature outside the span of the uncertain values is negligible below this relative size.
NEGLIGIBLE_REMAINDER = 1e-3


class Law(NamedTuple):
    """A law: what varies, and with what, in words; its signature, and that of its constant part, (D,)."""

    quantity: str
    dependence: str
    varying: Array
    constant: Array


def p_outside(term_fits: TermFits, final: Fit) -> float:
    """Return the largest probability, over the kinds, that an effect that no term describes looks like some term."""
    search, baseline, directions = term_fits.search, term_fits.baseline, term_fits.signature_directions
    fitter, gain = search.store.fitter, baseline.chi2 - final.chi2
    if gain <= 0.0:
        return 1.0
    rng, data = np.random.default_rng(SEED), slice(0, fitter.prior_slice.start)
    used_row_mask, min_directions = fitter.used_row_mask(final.hypothesis), search.criteria.claim.many
    degrees = float(fitter.observations.degrees_of_freedom(used_row_mask) - baseline.leverage[data].sum())
    draws = arbitrary_draws(fitter, baseline, DRAWS, rng)
    probabilities = [coincidence(search, final, gain, draws, directions, degrees, final.chi2)]
    # Combinations of only a few directions do not represent other errors of the model.
    law_directions = _unit_directions(baseline, [law.varying for law in laws(term_fits)])
    changes = modal_changes(fitter, baseline)
    common_changes = np.vstack([changes, np.zeros((len(baseline.white) - len(changes), changes.shape[1]))])
    for subspace, min_count in (
        (directions, min_directions),
        (law_directions, min_directions),
        (_unit_directions(baseline, common_changes.T), 1),
    ):
        if len(subspace) < min_count:
            continue
        plausible = PlausibleChanges.of(subspace, float(np.sqrt(gain)))
        if plausible.direction_count >= min(min_count, len(plausible.axes)):
            projected_directions = [(plausible.axes.T @ axes, sign) for axes, sign in directions]
            combined, squares = plausible.draws(DRAWS, rng), plausible.squares(final.white)
            probabilities.append(
                coincidence(
                    search, final, gain, combined, projected_directions, plausible.resolved_count, squares
                )
            )
    return max(probabilities)


def competing_law(term_fits: TermFits, final: Fit) -> Law | None:
    """Return the law that explains the data best, if it does so as well as a term; else None.

    The signatures of the law and of its constant part are fitted, linearised.  For changes, a law must be better by
    three standard deviations.
    """
    store, baseline, best_law = term_fits.search.store, term_fits.baseline, None
    criteria = store.fitter.criteria
    price = float(
        np.log(store.fitter.observations.degrees_of_freedom(store.fitter.used_row_mask(final.hypothesis)))
    )
    margin = criteria.search.survives
    limit = final.chi2 + price * len(final.causes[0].parameters)
    limit += margin if criteria.claim.laws_survive else -margin
    for law in laws(term_fits):
        signatures = np.stack([_remainder(baseline, law.constant), _remainder(baseline, law.varying)], axis=1)
        basis = orthonormal(signatures)
        residual = baseline.white - basis @ (basis.T @ baseline.white)
        cost = float(residual @ residual) + 2.0 * price
        if cost <= limit:
            best_law, limit = law, cost
    return best_law


def laws(term_fits: TermFits) -> Iterator[Law]:
    """Yield the laws: each claimable cause of one parameter, and all frequencies alike, varying from row to row."""
    fitter, baseline = term_fits.search.store.fitter, term_fits.baseline
    data, rows = slice(0, fitter.prior_slice.start), fitter.observations.frequency_slice
    one_parameter_causes = [
        (candidate.name, fitter.parameter_indices(candidate)[0])
        for candidate in term_fits.search.candidates
        if len(candidate.parameters) == 1
    ]
    raw = (
        fitter.signatures(baseline, [i for _, i in one_parameter_causes])[1]
        if one_parameter_causes
        else np.zeros((len(baseline.white), 0))
    )
    uniform_change = np.zeros((len(baseline.white), 1))
    uniform_change[rows, 0] = fitter.used_row_mask(baseline.hypothesis) / fitter.observations.sigma
    names = [*(name for name, _ in one_parameter_causes), "all frequencies alike"]
    signatures = np.nan_to_num(np.hstack([raw, uniform_change]))
    for dependence, function in _row_functions(term_fits):
        for name, g in zip(names, signatures.T, strict=True):
            constant = np.zeros_like(g)
            constant[data] = g[data]
            squares = constant[rows] ** 2
            varying = np.zeros_like(g)
            if squares.any():
                varying[rows] = constant[rows] * (function - (squares @ function) / squares.sum())
            if np.linalg.norm(varying) > NEGLIGIBLE_REMAINDER * np.linalg.norm(constant):
                yield Law(name, dependence, varying, constant)


def _row_functions(term_fits: TermFits) -> Iterator[tuple[str, Array]]:
    """Yield the functions of the rows with which laws vary: in words, and as values of order 1."""
    fitter = term_fits.search.store.fitter
    data = fitter.data
    points = np.nan_to_num(data.points[data.pose])
    for component, x in zip(data.components, points.T, strict=True):
        spread = float(x.std())
        if spread > 0.0:
            scaled = (x - x.mean()) / spread
            yield f"with {component}", scaled
            yield f"with the square of {component}", scaled**2
    if len(data.labels) > 2:
        yield "with the order of the setups", data.pose / (len(data.labels) - 1.0)
    log = fitter.observations.log_frequencies
    if float(log.std()) > 0.0:
        yield "with frequency", (log - log.mean()) / float(log.std())


def _unit_directions(baseline: Fit, signatures: Iterable[Array]) -> Directions:
    """Return the directions of signatures beside the uncertain values, without those that vanish there."""
    projected = [
        (_remainder(baseline, signature), float(np.linalg.norm(signature))) for signature in signatures
    ]
    sizes = [(remainder, float(np.linalg.norm(remainder)), full_size) for remainder, full_size in projected]
    return [
        (remainder[:, None] / size, 0)
        for remainder, size, full_size in sizes
        if size > NEGLIGIBLE_REMAINDER * full_size
    ]


def _remainder(baseline: Fit, signature: Array) -> Array:
    """Return the part of a signature that the uncertain values cannot produce."""
    return np.asarray(signature - baseline.basis @ (baseline.basis.T @ signature))
