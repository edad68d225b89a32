"""Whether one term explains the data in place of what the catalogue would claim.

A cause that acts on the whole machine is one of few: it is preferred to the best of many terms unless that is better
by more than chance.  Several causes, or a wrong value of one axis, are not: of these there are as many as of terms.
Neither is a change between two states: one part at one place is as likely as all of a kind.
"""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.loop.diagnosis.beyond.evidence import EQUAL, TermEvidence, best_first
from pkmodes.loop.diagnosis.beyond.tried import fitter_of
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, parallel
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.diagnosis.search.score import score
from pkmodes.loop.diagnosis.verdict.classes import are_nested
from pkmodes.loop.diagnosis.verdict.evidence import Evidence

#: Terms are tried before one cause is claimed if the linear model promises one of them this part of its gain.
COMPETES = 0.5


def one_of_many(catalogue: Evidence) -> bool:
    """Return whether what would be claimed is several causes, or a wrong value of one axis, or any change."""
    local = any(fit.causes[-1].local for fits in catalogue.claim.own_classes for fit in fits)
    return len(catalogue.final.causes) > 1 or local or catalogue.criteria.claim.any_place


def may_compete(structure: Structure, catalogue: Evidence, held: Sequence[int]) -> bool:
    """Return whether some term of a structure may explain as much as the causes, by the linear model.

    - structure: with its terms, at all measured setups
    - held: held-out setups
    """
    declared = catalogue.outcome.nuisance_fit
    fitter = fitter_of(structure, catalogue, held, catalogue.fitter.shape_scatter)
    plain = FitStore(fitter).fit(Hypothesis(), fitter.padded(declared.values))
    if plain is None:
        return False
    terms = [term for term in structure.candidates if term.form and not term.starts]
    largest = max((entry.gain for entry in score(fitter, plain, terms).by_candidate), default=0.0)
    return largest >= COMPETES * (declared.deviance - catalogue.final.deviance)


def instead(of_terms: TermEvidence, catalogue: Evidence) -> Fit | None:
    """Return the best term that competes with what would be claimed; None if none does.

    Beside several causes or a value of one axis, each term that survives competes; beside one cause, a term that
    lowers the criterion by more than chance.  A term that does exactly the same as a cause, such as a mass on a
    carriage and a heavier carriage, does not compete, nor does one joint alone of a cause with a value for each.

    For changes, one joint alone competes where it is clearly better, and so does a term that differs from the cause
    only in modes that were not measured: a spring along x, where no mode along y was found.
    """
    criterion = of_terms.store.criterion
    again = [fit for fit in of_terms.tried.carried if fit.causes == catalogue.final.causes]
    if not again:  # what cannot be compared stays
        return None
    claimed = min(again, key=criterion)
    fitter, any_place = of_terms.fitter, catalogue.criteria.claim.any_place
    terms = [fit for group in of_terms.groups for fit in group if all(cause.form for cause in fit.causes)]
    if any_place and _single(claimed):
        equal = [fit for fit in terms if abs(criterion(fit) - criterion(claimed)) <= EQUAL]
        same = [fit for fit in equal if _single(fit) and same_everywhere(fitter, fit, claimed)]
        competing = [fit for fit in terms if fit not in same]
        return next(iter(best_first(of_terms.store, competing)), None)
    worth = catalogue.criteria.search.worth
    simpler = [fit for fit in terms if any_place and criterion(fit) < criterion(claimed) - worth]
    rivals = [fit for fit in terms if fit in simpler or not are_nested(fitter, fit, claimed)]
    if one_of_many(catalogue):
        competing = [fit for fit in rivals if abs(criterion(fit) - criterion(claimed)) > EQUAL]
    else:
        limit = criterion(claimed) - worth
        competing = [fit for fit in rivals if criterion(fit) < limit]
    return next(iter(best_first(of_terms.store, competing)), None)


def _single(fit: Fit) -> bool:
    return sum(len(cause.parameters) for cause in fit.causes) == 1


def same_everywhere(fitter: Fitter, a: Fit, b: Fit) -> bool:
    """Return whether two causes of one value change all modes at all setups alike to first order, measured or not."""
    index = [fitter.indices(fit.causes[-1])[0] for fit in (a, b)]
    return bool(parallel(fitter.structure.predict(fitter.declared, index).rates)[0, 1])
