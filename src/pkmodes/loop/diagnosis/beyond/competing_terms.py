"""Whether one term explains the data in place of what the catalogue would claim.

A cause that acts on the whole machine is one of few: it is preferred to the best of many terms unless that is better
by more than chance.  Several causes, or a wrong value of one axis, are not preferred: there are as many of these as
there are terms.  Neither is a change between two states: one part at one place is as likely as all parts of a kind.
"""

from __future__ import annotations

from collections.abc import Sequence

from pkmodes.loop.diagnosis.beyond.evidence import CRITERION_TOLERANCE, TermEvidence, sort_best_first
from pkmodes.loop.diagnosis.beyond.term_fits import fitter_without_held_out
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis, parallel_parameters
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Structure
from pkmodes.loop.diagnosis.search.score import score
from pkmodes.loop.diagnosis.verdict.classes import are_nested
from pkmodes.loop.diagnosis.verdict.evidence import Evidence

#: Terms are tried before a cause is claimed if one of them promises this part of its gain in the linear model.
MIN_GAIN_FRACTION = 0.5


def has_many_alternatives(catalogue: Evidence) -> bool:
    """Return whether the claim has many alternatives: several causes, a wrong value of one axis, or any change."""
    local = any(fit.causes[-1].local for fits in catalogue.claim.class_of_each_cause for fit in fits)
    return len(catalogue.final.causes) > 1 or local or catalogue.criteria.claim.terms_as_likely


def terms_may_compete(structure: Structure, catalogue: Evidence, held_out: Sequence[int]) -> bool:
    """Return whether some term of a structure may explain as much as the causes, by the linear model.

    - structure: the structure with its terms, at all measured setups
    - held_out: held-out setups
    """
    nuisance_fit = catalogue.outcome.nuisance_fit
    fitter = fitter_without_held_out(structure, catalogue, held_out, catalogue.fitter.shape_scatter)
    baseline = FitStore(fitter).fit(Hypothesis(), fitter.pad_with_declared(nuisance_fit.values))
    if baseline is None:
        return False
    terms = [term for term in structure.candidates if term.form and not term.starts]
    largest_gain = max((entry.gain for entry in score(fitter, baseline, terms).by_candidate), default=0.0)
    return largest_gain >= MIN_GAIN_FRACTION * (nuisance_fit.deviance - catalogue.final.deviance)


def competing_term(term_evidence: TermEvidence, catalogue: Evidence) -> Fit | None:
    """Return the best term that competes with what would be claimed; None if none does.

    Beside several causes or a value of one axis, each term that survives competes; beside one cause, a term that
    lowers the criterion by more than chance.  A term that does exactly the same as a cause, such as a mass on a
    carriage and a heavier carriage, does not compete, nor does one joint alone of a cause with a value for each.

    For changes, one joint alone competes where it is clearly better, and so does a term that differs from the cause
    only in modes that were not measured: a spring along x, where no mode along y was found.
    """
    criterion = term_evidence.store.criterion
    refits = [fit for fit in term_evidence.term_fits.catalogue_fits if fit.causes == catalogue.final.causes]
    if not refits:  # a claim that cannot be compared with terms stands
        return None
    claimed = min(refits, key=criterion)
    fitter, terms_as_likely = term_evidence.fitter, catalogue.criteria.claim.terms_as_likely
    terms = [
        fit for group in term_evidence.groups for fit in group if all(cause.form for cause in fit.causes)
    ]
    if terms_as_likely and _has_one_parameter(claimed):
        equal_fits = [fit for fit in terms if abs(criterion(fit) - criterion(claimed)) <= CRITERION_TOLERANCE]
        equivalent_fits = [
            fit
            for fit in equal_fits
            if _has_one_parameter(fit) and have_parallel_effects(fitter, fit, claimed)
        ]
        competing = [fit for fit in terms if fit not in equivalent_fits]
        return next(iter(sort_best_first(term_evidence.store, competing)), None)
    min_gain = catalogue.criteria.search.worth
    clearly_better = [
        fit for fit in terms if terms_as_likely and criterion(fit) < criterion(claimed) - min_gain
    ]
    rivals = [fit for fit in terms if fit in clearly_better or not are_nested(fitter, fit, claimed)]
    if has_many_alternatives(catalogue):
        competing = [fit for fit in rivals if abs(criterion(fit) - criterion(claimed)) > CRITERION_TOLERANCE]
    else:
        limit = criterion(claimed) - min_gain
        competing = [fit for fit in rivals if criterion(fit) < limit]
    return next(iter(sort_best_first(term_evidence.store, competing)), None)


def _has_one_parameter(fit: Fit) -> bool:
    return sum(len(cause.parameters) for cause in fit.causes) == 1


def have_parallel_effects(fitter: Fitter, a: Fit, b: Fit) -> bool:
    """Return whether two causes of one value change all modes at all setups alike to first order, measured or not."""
    index = [fitter.parameter_indices(fit.causes[-1])[0] for fit in (a, b)]
    return bool(parallel_parameters(fitter.structure.predict(fitter.declared, index).rates)[0, 1])
