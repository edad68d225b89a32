"""Evidence for the rules beyond the catalogue: the best term, its class, and its rivals."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cached_property

import numpy as np
from scipy import stats

from pkmodes.loop.diagnosis.beyond.specificity import Law, competing_law, p_outside
from pkmodes.loop.diagnosis.beyond.term_fits import TermFits
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.ranges import max_plausible_deviations
from pkmodes.loop.diagnosis.search.score import allowed_sign, p_of_smallest, score
from pkmodes.loop.diagnosis.search.search import Outcome, Search
from pkmodes.loop.diagnosis.verdict.claim import Claim, fitted_values
from pkmodes.loop.diagnosis.verdict.classes import classes, survivors
from pkmodes.loop.diagnosis.verdict.evidence import Evidence
from pkmodes.loop.diagnosis.verdict.findings import Finding
from pkmodes.loop.diagnosis.verdict.held_out import HeldOut, check_held_out
from pkmodes.loop.diagnosis.verdict.possible import describe_member, violated_usual_range
from pkmodes.loop.diagnosis.verdict.reasons import causes_in_words
from pkmodes.loop.diagnosis.verdict.stability import Trial, trials

#: Largest number of equally good terms that a reason names.
MAX_TERMS_NAMED = 3
#: Number of explanations outside its class with which a claim is compared, under other errors and at all setups.
MAX_CONTENDERS = 6
#: Explanations whose criteria differ by less are equally good: the difference is rounding of their residuals.
CRITERION_TOLERANCE = 1e-6


class TermEvidence(Evidence):
    """The evidence for the best term, compared with all others and the explanations of the catalogue.

    - groups: classes of the explanations that leave noise, that of the best one first
    """

    def __init__(self, term_fits: TermFits) -> None:
        search, store = term_fits.search, term_fits.search.store
        self.term_fits = term_fits
        rivals = sort_best_first(store, [*term_fits.fits, *term_fits.catalogue_fits])
        surviving = survivors(search, rivals)
        groups = [_order_class(search, group) for group in classes(store, surviving)]
        self.groups = groups
        best = next(iter(sort_best_first(store, term_fits.fits)), term_fits.baseline)
        final = _representative(search, groups[0]) if groups else best
        p_value = _p_value(term_fits, final)
        causes = dict.fromkeys(cause for group in groups for fit in group for cause in fit.causes)
        plausible = max_plausible_deviations(store.fitter, term_fits.baseline, list(causes))
        implausible = {
            name_of_explanation(fit)
            for group in groups
            for fit in group
            if violated_usual_range(store.fitter, fit)
        }
        claim = Claim(
            final,
            search.gate(final),
            (groups,),
            p_values=(p_value,),
            max_deviations=plausible,
            implausible_names=frozenset(implausible),
        )
        outcome = Outcome(term_fits.baseline, search.gate(term_fits.baseline), final, claim.last_gate)
        super().__init__(term_fits.setups, search, outcome, claim)

    @property
    def has_term(self) -> bool:
        """Whether some term, alone or in the class of the best explanation, leaves noise."""
        return any(cause.form for group in self.groups[:1] for fit in group for cause in fit.causes)

    @property
    def term_names(self) -> str:
        """The best term in words, with its name, and those that are equally good."""
        reference = self.store.criterion(self.final)
        equal_fits = [
            fit
            for fit in self.term_fits.fits
            if abs(self.store.criterion(fit) - reference) < CRITERION_TOLERANCE
        ]
        ranked = sort_best_first(self.store, equal_fits) or [self.final]
        words = " or ".join(causes_in_words(fit.causes) for fit in ranked[:MAX_TERMS_NAMED])
        return words if len(ranked) <= MAX_TERMS_NAMED else f"{words} or {len(ranked) - MAX_TERMS_NAMED} more"

    def finding(self, k: int) -> Finding:
        """Return a class with its values, as a part of a result."""
        fitter, group = self.fitter, self.groups[k]
        parameter_indices = [
            tuple(i for cause in fit.causes for i in fitter.parameter_indices(cause)) for fit in group
        ]
        labels = [name_of_explanation(fit) for fit in group]
        alternatives = {
            name: fitted_values(fitter, fit, indices)
            for name, fit, indices in zip(labels, group, parameter_indices, strict=True)
        }
        covariances = {
            name: tuple(map(tuple, fit.covariance_of(indices).tolist()))
            for name, fit, indices in zip(labels, group, parameter_indices, strict=True)
        }
        return Finding(
            name=labels[0],
            members=tuple(labels),
            parameters=alternatives[labels[0]],
            alternatives=alternatives,
            p_value=_p_value(self.term_fits, group[0]),
            sentence=group[0].causes[-1].sentence,
            covariances=covariances,
            about={
                name: replace(
                    describe_member(fitter, fit, self.claim.max_deviations),
                    name=name,
                    sentence=" and ".join(cause.sentence or cause.name for cause in fit.causes),
                )
                for name, fit in zip(labels, group, strict=True)
            },
        )

    @cached_property
    def contenders(self) -> list[Fit]:
        """The best explanations outside the class of the best one."""
        members = {name_of_explanation(fit) for group in self.groups[:1] for fit in group}
        store = self.store
        limit = store.criterion(self.final) + self.criteria.claim.near
        other_fits = [
            fit
            for fit in (*self.term_fits.fits, *self.term_fits.catalogue_fits)
            if name_of_explanation(fit) not in members and not fit.at_bound and store.criterion(fit) < limit
        ]
        return sort_best_first(store, other_fits)[:MAX_CONTENDERS]

    @cached_property
    def trials(self) -> list[Trial]:
        """The best explanations if errors and priors were different."""
        return trials(self.search, self.final, self.groups[:1], self.contenders)

    @cached_property
    def held_out(self) -> HeldOut:
        """The test of the final fit by the held-out setups."""
        return check_held_out(self.setups, self.search, self.final, self.contenders)

    @cached_property
    def p_outside(self) -> float:
        """Probability that an effect that no term describes would look like a term."""
        return p_outside(self.term_fits, self.final)

    @cached_property
    def law(self) -> Law | None:
        """A law that explains the data as well."""
        return competing_law(self.term_fits, self.final)

    @cached_property
    def remaining_term(self) -> tuple[Candidate, float] | None:
        """The term to which the remaining residual points, with the p-value of its score; None if there is none."""
        terms = [term for term in self.term_fits.terms if not term.starts and term not in self.final.causes]
        scores = score(self.fitter, self.final, terms)
        best_entry = min(scores.by_candidate, key=lambda entry: entry.p_value, default=None)
        if best_entry is None or scores.p_value > self.criteria.gate.surely:
            return None
        return best_entry.candidate, scores.p_value


def name_of_explanation(fit: Fit) -> str:
    """Return the name of an explanation: of a term, or of one or two causes of the catalogue."""
    return " + ".join(cause.name for cause in fit.causes)


def sort_best_first(store: FitStore, fits: Sequence[Fit]) -> list[Fit]:
    """Return explanations by their criteria, equally good ones by their names."""
    by_name = sorted(fits, key=name_of_explanation)
    return sorted(by_name, key=lambda fit: float(np.round(store.criterion(fit) / CRITERION_TOLERANCE)))


def _order_class(search: Search, group: Sequence[Fit]) -> list[Fit]:
    """Return the members of a class, the best first, plausible ones before others.

    A term with more parameters that explains no more than another term is left out: a resonator of a high frequency
    is a mass, and a heavy one of a low frequency a spring to ground.
    """
    store = search.store
    terms = [fit for fit in group if all(cause.form for cause in fit.causes)]
    best_criterion = min(map(store.criterion, terms or group))
    fewest_parameters = min(len(store.added_parameters(fit)) for fit in group)
    members = [
        fit
        for fit in group
        if fit not in terms
        or len(store.added_parameters(fit)) == fewest_parameters
        or store.criterion(fit) <= best_criterion
    ]
    fitter = store.fitter
    return sorted(sort_best_first(store, members), key=lambda fit: bool(violated_usual_range(fitter, fit)))


def _representative(search: Search, group: Sequence[Fit]) -> Fit:
    """Return the first member of a class whose residual is noise in all respects, a term before others."""
    level = search.criteria.gate.surely
    noise_fits = [fit for fit in group if search.gate(fit).passes_at(level)]
    terms = [fit for fit in noise_fits if all(cause.form for cause in fit.causes)]
    return next(iter([*terms, *noise_fits]), group[0])


def _p_value(term_fits: TermFits, final: Fit) -> float:
    """Return the p-value of a likelihood-ratio test of the best term, corrected for the number of candidates."""
    cause = next(iter(final.causes), None)
    if cause is None:
        return 1.0
    fitter, gain = term_fits.search.store.fitter, max(term_fits.baseline.deviance - final.deviance, 0.0)
    p = float(stats.chi2.sf(gain, sum(len(added_cause.parameters) for added_cause in final.causes)))
    if len(final.causes) == 1 and allowed_sign(fitter, cause):
        p *= 0.5
    return min(p_of_smallest(term_fits.signature_directions, p), 1.0)
