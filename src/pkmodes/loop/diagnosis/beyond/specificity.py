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

from pkmodes.loop.diagnosis.beyond.tried import Tried
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

#: Relative size below which what remains of a signature is negligible.
SAME = 1e-3


class Law(NamedTuple):
    """A law: in words, what varies and with what; its signature, and that of its constant part, (D,)."""

    quantity: str
    along: str
    varying: Array
    constant: Array


def p_outside(tried: Tried, final: Fit) -> float:
    """Return the largest probability, over the kinds, that an effect that no term describes looks like some term."""
    search, plain, directions = tried.search, tried.plain, tried.directions
    fitter, gain = search.store.fitter, plain.chi2 - final.chi2
    if gain <= 0.0:
        return 1.0
    rng, data = np.random.default_rng(SEED), slice(0, fitter.prior_rows.start)
    used, many = fitter.used(final.hypothesis), search.criteria.claim.many
    degrees = float(fitter.observations.degrees_of_freedom(used) - plain.leverage[data].sum())
    drawn = arbitrary_draws(fitter, plain, DRAWS, rng)
    kinds = [coincidence(search, final, gain, drawn, directions, degrees, final.chi2)]
    # A few directions do not represent what else may be wrong: their combinations are not informative.
    varying = _unit(plain, [law.varying for law in laws(tried)])
    changes = modal_changes(fitter, plain)
    common = np.vstack([changes, np.zeros((len(plain.white) - len(changes), changes.shape[1]))])
    for subspace, few in ((directions, many), (varying, many), (_unit(plain, common.T), 1)):
        if len(subspace) < few:
            continue
        plausible = PlausibleChanges.of(subspace, float(np.sqrt(gain)))
        if plausible.direction_count >= min(few, len(plausible.axes)):
            along = [(plausible.axes.T @ axes, sign) for axes, sign in directions]
            combined, squares = plausible.draws(DRAWS, rng), plausible.squares(final.white)
            kinds.append(coincidence(search, final, gain, combined, along, plausible.resolved_count, squares))
    return max(kinds)


def like_a_law(tried: Tried, final: Fit) -> Law | None:
    """Return the law that explains the data best, if it does so as well as a term; else None.

    The signatures of the law and of its constant part are fitted, linearised.  For changes, a law must be better by
    three standard deviations.
    """
    store, plain, best = tried.search.store, tried.plain, None
    criteria = store.fitter.criteria
    price = float(np.log(store.fitter.observations.degrees_of_freedom(store.fitter.used(final.hypothesis))))
    survives = criteria.search.survives
    limit = final.chi2 + price * len(final.causes[0].parameters)
    limit += survives if criteria.claim.laws_survive else -survives
    for law in laws(tried):
        both = np.stack([_beside(plain, law.constant), _beside(plain, law.varying)], axis=1)
        basis = orthonormal(both)
        residual = plain.white - basis @ (basis.T @ plain.white)
        cost = float(residual @ residual) + 2.0 * price
        if cost <= limit:
            best, limit = law, cost
    return best


def laws(tried: Tried) -> Iterator[Law]:
    """Yield the laws: each claimable cause of one parameter, and all frequencies alike, varying from row to row."""
    fitter, plain = tried.search.store.fitter, tried.plain
    data, rows = slice(0, fitter.prior_rows.start), fitter.observations.frequency_rows
    single = [
        (candidate.name, fitter.indices(candidate)[0])
        for candidate in tried.search.candidates
        if len(candidate.parameters) == 1
    ]
    raw = fitter.signatures(plain, [i for _, i in single])[1] if single else np.zeros((len(plain.white), 0))
    alike = np.zeros((len(plain.white), 1))
    alike[rows, 0] = fitter.used(plain.hypothesis) / fitter.observations.sigma
    names = [*(name for name, _ in single), "all frequencies alike"]
    signatures = np.nan_to_num(np.hstack([raw, alike]))
    for along, function in _functions(tried):
        for name, g in zip(names, signatures.T, strict=True):
            constant = np.zeros_like(g)
            constant[data] = g[data]
            squares = constant[rows] ** 2
            varying = np.zeros_like(g)
            if squares.any():
                varying[rows] = constant[rows] * (function - (squares @ function) / squares.sum())
            if np.linalg.norm(varying) > SAME * np.linalg.norm(constant):
                yield Law(name, along, varying, constant)


def _functions(tried: Tried) -> Iterator[tuple[str, Array]]:
    """Yield what laws may vary with, in words and as values in the rows, of order 1."""
    fitter = tried.search.store.fitter
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


def _unit(plain: Fit, signatures: Iterable[Array]) -> Directions:
    """Return the directions of signatures beside the uncertain values, without those that vanish there."""
    projected = [(_beside(plain, signature), float(np.linalg.norm(signature))) for signature in signatures]
    sizes = [(remainder, float(np.linalg.norm(remainder)), whole) for remainder, whole in projected]
    return [(remainder[:, None] / size, 0) for remainder, size, whole in sizes if size > SAME * whole]


def _beside(plain: Fit, signature: Array) -> Array:
    """Return the part of a signature that the uncertain values cannot produce."""
    return np.asarray(signature - plain.basis @ (plain.basis.T @ signature))
