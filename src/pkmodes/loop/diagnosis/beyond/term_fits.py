"""Fits beyond the catalogue: one term at a time, with the uncertain values free.

All terms are scored at the refit of the uncertain values with exact rates, the most promising are refitted, one fit
per term, in one batch, and those that may survive are completed.  A term with several starts, such as a resonator, is
first evaluated at each of them.  A term whose linear effect is small is evaluated at several sizes.  If no term
reduces the residual to noise, the best ones are tried beside outliers or a shared error, under the same conditions as
the catalogue's causes.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from itertools import zip_longest

import numpy as np

from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array, Candidate, Structure
from pkmodes.loop.diagnosis.search.additions import Progress
from pkmodes.loop.diagnosis.search.score import MIN_REMAINDER, Directions, Score, allowed_sign, score
from pkmodes.loop.diagnosis.search.search import Search
from pkmodes.loop.diagnosis.search.starts import START_FREQUENCY_CHANGES, starts
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.evidence import Evidence

#: Largest numbers of terms that are refitted: best by score; with their own starts; at large sizes.
MAX_TERMS_BY_SCORE, MAX_TERMS_BY_START, MAX_TERMS_BY_SIZE = 40, 20, 10
#: Number of starts of each term that remain after a comparison at a few setups, and then at all.
STARTS_AFTER_SUBSAMPLE, STARTS_AFTER_ALL_SETUPS = 6, 4
#: Number of setups at which starts are compared.
SUBSAMPLE_SETUPS = 4
#: Largest relative change of a frequency for which a linear estimate suffices as a start.
SMALL_CHANGE = 0.05
#: A fit has failed if it gains less than this fraction of what the linear estimate predicts.
MIN_FRACTION_OF_PREDICTED_GAIN = 0.5
#: Largest number of rounds, each of which adds one measurement error; and largest number of terms tried with it.
MAX_ERROR_ROUNDS, MAX_TERMS_WITH_ERRORS = 3, 3
#: Number of explanations of the catalogue with which terms are compared.
MAX_CATALOGUE_FITS = 12
#: Times that the search is repeated with a smaller scatter of the shapes.
MAX_REPEATS = 2


@dataclass(frozen=True, eq=False)
class TermFits:
    """Fits with one term each, and the explanations of the catalogue that leave only noise.

    - setups: setups of the structure with its terms
    - baseline: fit without any cause, with the measurement errors of the fits
    - fits: fits with one term, best first
    - catalogue_fits: explanations of the catalogue, fitted again beside the terms
    """

    setups: AllSetups
    search: Search
    terms: tuple[Candidate, ...]
    baseline: Fit
    fits: tuple[Fit, ...]
    catalogue_fits: tuple[Fit, ...]

    @cached_property
    def signature_directions(self) -> Directions:
        """Directions of all terms, of terms at each of their starts, and of the candidates of the catalogue."""
        fitter = self.search.store.fitter
        terms_without_starts = [term for term in self.terms if not term.starts]
        term_directions = score(fitter, self.baseline, terms_without_starts).directions
        terms_with_starts = [term for term in self.terms if term.starts]
        catalogue_directions = self.search.scores(self.baseline).directions
        return (
            *term_directions,
            *_signature_directions_at_starts(fitter, self.baseline, terms_with_starts),
            *catalogue_directions,
        )


def _signature_directions_at_starts(
    fitter: Fitter, baseline: Fit, terms: Sequence[Candidate]
) -> Iterator[tuple[Array, int]]:
    """For terms with their own starts, yield the normalised signature of the size parameter at each start.

    At size 0 the other parameters have no effect, but they determine the effect of a small size: a resonator pushes
    the modes on both sides of its frequency apart.
    """
    for other_parameters in zip_longest(
        *(dict.fromkeys(start[1:] for start in term.starts) for term in terms)
    ):
        present_terms = [
            (term, other_parameters_of_term)
            for term, other_parameters_of_term in zip(terms, other_parameters, strict=True)
            if other_parameters_of_term is not None
        ]
        values = baseline.values.copy()
        for term, other_parameters_of_term in present_terms:
            values[list(fitter.parameter_indices(term))[1:]] = other_parameters_of_term
        parameter_indices = [fitter.parameter_indices(term)[0] for term, _ in present_terms]
        raw = np.nan_to_num(fitter.signatures(replace(baseline, values=values), parameter_indices)[1])
        remainder = raw - baseline.basis @ (baseline.basis.T @ raw)
        norms = np.linalg.norm(remainder, axis=0)
        for k in np.flatnonzero(norms > MIN_REMAINDER * np.linalg.norm(raw, axis=0)):
            yield remainder[:, [k]] / norms[k], 1


def try_terms(
    structure: Structure, catalogue_evidence: Evidence, held_out: Sequence[int], progress: Progress | None
) -> TermFits | None:
    """Try all terms of a structure; None if it has none, or cannot be evaluated.

    - structure: the structure with its terms, at all measured setups
    - catalogue_evidence: evidence for the causes of the catalogue
    - held_out: held-out setups
    """
    terms = tuple(term for term in structure.candidates if term.form)
    setups, scatter = catalogue_evidence.setups, catalogue_evidence.fitter.shape_scatter
    result, c = None, catalogue_evidence.criteria
    for _ in range(1 + MAX_REPEATS if terms else 0):
        fitter = fitter_without_held_out(structure, catalogue_evidence, held_out, scatter)
        all_setups = AllSetups(structure, setups.data, fitter, list(held_out))
        result = _Explorer(all_setups, terms, catalogue_evidence, progress, result).explore()
        scatters = [] if result is None else [result.search.store.shape_scatter(fit) for fit in result.fits]
        smaller_scatter = min((estimate for estimate in scatters if estimate is not None), default=scatter)
        smaller_scatter = max(smaller_scatter, c.shapes.least_scatter)
        if smaller_scatter >= c.shapes.sharper * scatter:
            break
        scatter = smaller_scatter
    return result


def fitter_without_held_out(
    structure: Structure, catalogue_evidence: Evidence, held_out: Sequence[int], scatter: float
) -> Fitter:
    """Return the fitter of a structure with its terms at the setups that are not held out."""
    data = catalogue_evidence.setups.data
    fitted = [i for i in range(len(data.labels)) if i not in held_out]
    return Fitter(structure.subset(fitted), data.at(fitted), catalogue_evidence.criteria, scatter)


@dataclass(frozen=True)
class _TermStarts:
    """A term with its start values, and the group of each if there are several."""

    hypothesis: Hypothesis
    values: Sequence[Array]
    groups: Sequence[float] = ()

    def best_values(self, order: Sequence[int]) -> list[Array]:
        """Return start values in the given order, the best of each group first, at most STARTS_AFTER_SUBSAMPLE."""
        groups = self.groups or [0.0] * len(self.values)
        best_of_group = list({groups[k]: k for k in reversed(order)}.values())
        selected = [*(k for k in order if k in best_of_group), *(k for k in order if k not in best_of_group)][
            :STARTS_AFTER_SUBSAMPLE
        ]
        return [self.values[k] for k in selected]


def _rank_starts(
    fitter: Fitter, jobs: Sequence[tuple[Hypothesis, Sequence[Array]]]
) -> list[list[tuple[float, int]]]:
    """Return, for each hypothesis, the sums of squares of its starts with their indices, smallest first."""
    if not jobs:
        return []
    costs = iter(fitter.chi2_of_many([(h, values) for h, starts in jobs for values in starts]))
    return [sorted((next(costs), k) for k in range(len(starts))) for _, starts in jobs]


class _Explorer:
    """A search among terms, with one scatter of the shapes.

    - previous: the result with a larger scatter; only its terms are refitted, from their values there
    """

    def __init__(
        self,
        setups: AllSetups,
        terms: tuple[Candidate, ...],
        catalogue_evidence: Evidence,
        progress: Progress | None,
        previous: TermFits | None,
    ) -> None:
        self.previous = previous
        self.setups, self.terms, self.catalogue_evidence = setups, terms, catalogue_evidence
        self.fitter = setups.fitter
        self.store, self.criteria = FitStore(setups.fitter), setups.fitter.criteria
        self.progress = progress or (lambda _: None)
        self.search = Search(self.store, setups.structure.candidates, progress)

    def explore(self) -> TermFits | None:
        """Try all terms; None if the structure cannot be evaluated."""
        self.progress(
            f"scoring {len(self.terms)} terms (one element, such as a spring or a mass, at one location)"
        )
        baseline = self.store.fit(
            Hypothesis(), self.fitter.pad_with_declared(self.catalogue_evidence.outcome.nuisance_fit.values)
        )
        if baseline is None:
            return None
        fits = first_fits = self._refit_terms(baseline)
        assumed_errors, tried_errors = Hypothesis(), list[Hypothesis]()
        for _ in range(MAX_ERROR_ROUNDS):
            if any(self._reduces_residual_to_noise(fit) for fit in fits[: self.criteria.search.best_few]):
                break
            tried_errors.append(assumed_errors)
            # Measurement errors that let the best terms explain most.
            fits_with_another_error = [
                option
                for fit in fits[:MAX_TERMS_WITH_ERRORS]
                for option in self.search.additions.with_errors(fit)
            ]
            best_fit = min(fits_with_another_error, key=self.store.criterion, default=None)
            next_errors, next_baseline = assumed_errors, None
            if best_fit is not None and self.store.criterion(best_fit) < self.store.criterion(fits[0]):
                next_errors = replace(best_fit.hypothesis, causes=())
            if next_errors not in tried_errors:
                next_baseline = self.store.fit(next_errors, baseline.values)
            if next_baseline is None:
                fits = first_fits
                break
            assumed_errors, fits = next_errors, self._refit_terms(next_baseline)
        final_errors = replace(fits[0].hypothesis, causes=()) if fits else Hypothesis()
        final_baseline = self.store.fit(final_errors) or baseline
        return TermFits(
            self.setups, self.search, self.terms, final_baseline, tuple(fits), tuple(self._refit_catalogue())
        )

    def _refit_catalogue(self) -> list[Fit]:
        """Return the best explanations of the catalogue that reduce the residual to noise, fitted again."""
        store, level = self.catalogue_evidence.store, self.criteria.gate.surely
        names = {candidate.name for candidate in self.search.candidates}
        explaining = [
            fit
            for fit in {id(fit): fit for fit in (self.catalogue_evidence.final, *store.all_fits())}.values()
            if fit.causes
            and all(cause.name in names for cause in fit.causes)
            and not fit.at_bound
            and store.p_value(fit) > level
        ]
        # Fits with the same causes may set different rows aside: the best of them is carried.
        by_causes = {fit.causes: fit for fit in sorted(explaining, key=store.criterion, reverse=True)}
        best_fits = sorted(by_causes.values(), key=store.criterion)[:MAX_CATALOGUE_FITS]
        fits = [
            self.store.fit(fit.hypothesis, self.fitter.pad_with_declared(fit.values)) for fit in best_fits
        ]
        return [fit for fit in fits if fit is not None]

    def _refit_terms(self, baseline: Fit) -> list[Fit]:
        """Fit each term separately, with the measurement errors assumed in the baseline; best first."""
        if self.previous is not None:
            previous_values = [
                (baseline.hypothesis.with_cause(fit.causes[0]), [fit.values]) for fit in self.previous.fits
            ]
            return self.store.complete(self.store.rough_fits(previous_values))
        terms_without_starts = [
            term for term in self.terms if not term.starts and self._is_testable(baseline, term)
        ]
        scores = score(self.fitter, baseline, terms_without_starts).by_candidate
        visible_scores = [
            term_score for term_score in scores if term_score.is_visible and term_score.gain > 0.0
        ]
        best_scores = sorted(visible_scores, key=lambda term_score: -term_score.gain)[:MAX_TERMS_BY_SCORE]
        # The linear estimate suffices for small changes of modes that are all paired.
        are_all_paired = bool(
            (baseline.pairing.partner[self.fitter.used_row_mask(baseline.hypothesis)] >= 0).all()
        )
        small_change_scores = [
            term_score
            for term_score in best_scores
            if are_all_paired and float(term_score.largest_rates @ np.abs(term_score.step)) <= SMALL_CHANGE
        ]
        small_change_names = {term_score.candidate.name for term_score in small_change_scores}
        large_change_scores = [
            term_score for term_score in best_scores if term_score.candidate.name not in small_change_names
        ]
        self.progress(f"refitting with the {len(best_scores)} most promising of {len(self.terms)} terms")
        fits = self.search.additions.refit([(baseline, term_score) for term_score in large_change_scores])
        linear_starts = [
            (
                baseline.hypothesis.with_cause(term_score.candidate),
                [self._values_with_step(baseline, term_score)],
            )
            for term_score in small_change_scores
        ]
        remaining_scores = [
            term_score
            for term_score in scores
            if term_score not in best_scores and term_score.largest_rates[0] > 0.0
        ]
        hypotheses_with_starts = [
            *self._terms_with_starts(baseline),
            *self._terms_at_large_sizes(baseline, remaining_scores),
        ]
        best_starts = [
            (h, [values[k] for _, k in order[:STARTS_AFTER_ALL_SETUPS]])
            for (h, values), order in zip(
                hypotheses_with_starts, _rank_starts(self.fitter, hypotheses_with_starts), strict=True
            )
        ]
        rough_fits = self.store.rough_fits([*linear_starts, *best_starts])
        return self.store.complete(
            [*fits, *self._restart_failed_fits(baseline, small_change_scores, rough_fits)]
        )

    def _restart_failed_fits(
        self, baseline: Fit, small_change_scores: Sequence[Score], rough_fits: Sequence[Fit]
    ) -> list[Fit]:
        """Return the rough fits, restarting those that failed, as when close modes are exchanged."""
        score_by_name = {term_score.candidate.name: term_score for term_score in small_change_scores}
        failed_fits = [
            (fit, score_by_name[name])
            for fit in rough_fits
            if (name := fit.causes[0].name) in score_by_name
            and fit.deviance > baseline.deviance - MIN_FRACTION_OF_PREDICTED_GAIN * score_by_name[name].gain
        ]
        good_fits = [fit for fit in rough_fits if all(fit is not restarted for restarted, _ in failed_fits)]
        new_starts = starts(
            self.fitter, [(baseline, term_score, fit.hypothesis) for fit, term_score in failed_fits]
        )
        restarts = [
            (fit.hypothesis, [*values, fit.values])
            for (fit, _), values in zip(failed_fits, new_starts, strict=True)
        ]
        return [*good_fits, *self.store.rough_fits(restarts)]

    def _values_with_step(self, baseline: Fit, term_score: Score) -> Array:
        """Return the values of a fit with the linear estimate of a term."""
        return self._values_with(
            baseline,
            term_score.candidate,
            baseline.values[list(self.fitter.parameter_indices(term_score.candidate))] + term_score.step,
        )

    def _is_testable(self, baseline: Fit, term: Candidate) -> bool:
        """Return whether data are left to test a term."""
        return self.store.degrees(baseline) > len(term.parameters)

    def _terms_with_starts(self, baseline: Fit) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms with their own starts, each with its best starts."""
        terms = [term for term in self.terms if term.starts and self._is_testable(baseline, term)]
        trials = []
        for term in terms:
            # Starts are grouped by the parameter with the fewest distinct values, which is the mass.
            columns = list(zip(*term.starts, strict=True))
            groups = min(columns, key=lambda column: len({*column})) if len(columns) > 1 else ()
            values = [self._values_with(baseline, term, start) for start in term.starts]
            trials.append(_TermStarts(baseline.hypothesis.with_cause(term), values, groups))
        if trials:
            self.progress(f"comparing starts of {len(trials)} terms that have their own resonance")
        return self._most_promising(trials)[:MAX_TERMS_BY_START]

    def _terms_at_large_sizes(
        self, baseline: Fit, scores: Sequence[Score]
    ) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms for which the linear model predicts little, with their best sizes."""
        trials = [
            _TermStarts(
                baseline.hypothesis.with_cause(term_score.candidate),
                [
                    self._values_with(
                        baseline, term_score.candidate, [sign * size / term_score.largest_rates[0]]
                    )
                    for size in START_FREQUENCY_CHANGES
                ],
            )
            for term_score in scores
            if (sign := allowed_sign(self.fitter, term_score.candidate))
        ]
        return self._most_promising(trials)[:MAX_TERMS_BY_SIZE]

    def _values_with(self, baseline: Fit, term: Candidate, term_values: Sequence[float] | Array) -> Array:
        """Return the values of a fit with those of a term, within its bounds."""
        values, index = baseline.values.copy(), list(self.fitter.parameter_indices(term))
        values[index] = np.clip(term_values, self.fitter.lower[index], self.fitter.upper[index])
        return values

    def _most_promising(self, trials: Sequence[_TermStarts]) -> list[tuple[Hypothesis, list[Array]]]:
        """Return terms with the best of their values, the most promising first, judged at a few setups."""
        count = len(self.fitter.data.labels)
        subsample_setups = (
            [int((k + 0.5) * count / SUBSAMPLE_SETUPS) for k in range(SUBSAMPLE_SETUPS)]
            if count > SUBSAMPLE_SETUPS
            else range(count)
        )
        subsample_fitter = self.fitter.at_setups(list(subsample_setups)) if trials else self.fitter
        # Excluded rows are omitted: the fitter of the subset numbers its rows differently.
        ranked = _rank_starts(
            subsample_fitter, [(Hypothesis(trial.hypothesis.causes), trial.values) for trial in trials]
        )
        ordered = sorted(zip(ranked, trials, strict=True), key=lambda pair: pair[0][0][0])
        return [
            (trial.hypothesis, trial.best_values([k for _, k in order]))
            for order, trial in ordered
            if np.isfinite(order[0][0])
        ]

    def _reduces_residual_to_noise(self, fit: Fit) -> bool:
        """Return whether a fit reduces the residual to noise."""
        level = self.criteria.gate.surely
        return not fit.at_bound and self.store.p_value(fit) > level and self.search.gate(fit).passes_at(level)
