"""Fits beyond the catalogue: each term alone, together with the uncertain values.

All terms are scored at the refit of the uncertain values with exact rates, the most promising ones are refitted
together, and those that may survive are completed.  A term that may be anywhere, such as a resonator, is first
evaluated at all its starts, and one for which the linear model predicts little at several sizes.  If no term leaves
noise, the best ones are tried beside outliers or a shared error, under the same conditions as the catalogue's causes.
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

#: Largest number of terms that are refitted for their score, from their starts, and at large sizes.
MAX_TERMS_BY_SCORE, MAX_TERMS_BY_START, MAX_TERMS_BY_SIZE = 40, 20, 10
#: Number of starts of each term that remain after a comparison at a few setups, and then at all.
STARTS_AFTER_SUBSAMPLE, STARTS_AFTER_ALL_SETUPS = 6, 4
#: Number of setups at which starts are compared.
SUBSAMPLE_SETUPS = 4
#: Largest relative change of a frequency for which a linear estimate suffices as a start.
SMALL_CHANGE = 0.05
#: A fit went astray if it gains less than this part of what the linear estimate promises.
ASTRAY_GAIN = 0.5
#: Largest number of measurement errors in addition to terms, one more in each round, and of terms that are tried with
#: them.
MAX_ERROR_ROUNDS, MAX_TERMS_WITH_ERRORS = 3, 3
#: Number of explanations of the catalogue with which terms are compared.
MAX_CATALOGUE_FITS = 12
#: Times that the search is repeated with a smaller scatter of the shapes.
MAX_REPEATS = 2


@dataclass(frozen=True, eq=False)
class TermFits:
    """Fits with one term each, and the explanations of the catalogue that leave noise.

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
    def directions(self) -> Directions:
        """Directions of all terms, of terms at each of their starts, and of the candidates of the catalogue."""
        fitter, terms_without_starts = (
            self.search.store.fitter,
            [term for term in self.terms if not term.starts],
        )
        term_directions = score(fitter, self.baseline, terms_without_starts).directions
        terms_with_starts = [term for term in self.terms if term.starts]
        catalogue_directions = self.search.scores(self.baseline).directions
        return (
            *term_directions,
            *_directions_of_starts(fitter, self.baseline, terms_with_starts),
            *catalogue_directions,
        )


def _directions_of_starts(
    fitter: Fitter, baseline: Fit, terms: Sequence[Candidate]
) -> Iterator[tuple[Array, int]]:
    """Yield the directions of terms that have their own starts: that of the size, at each start.

    At size 0 the other parameters have no effect, but they determine the effect of a small size: a resonator pushes
    the modes on both sides of its frequency apart.
    """
    for fixed_values in zip_longest(*(dict.fromkeys(start[1:] for start in term.starts) for term in terms)):
        present_terms = [
            (term, fixed_values_of_term)
            for term, fixed_values_of_term in zip(terms, fixed_values, strict=True)
            if fixed_values_of_term is not None
        ]
        values = baseline.values.copy()
        for term, fixed_values_of_term in present_terms:
            values[list(fitter.parameter_indices(term))[1:]] = fixed_values_of_term
        parameter_indices = [fitter.parameter_indices(term)[0] for term, _ in present_terms]
        raw = np.nan_to_num(fitter.signatures(replace(baseline, values=values), parameter_indices)[1])
        remainder = raw - baseline.basis @ (baseline.basis.T @ raw)
        size = np.linalg.norm(remainder, axis=0)
        for k in np.flatnonzero(size > MIN_REMAINDER * np.linalg.norm(raw, axis=0)):
            yield remainder[:, [k]] / size[k], 1


def try_terms(
    structure: Structure, catalogue: Evidence, held_out: Sequence[int], progress: Progress | None
) -> TermFits | None:
    """Try all terms of a structure; None if it has none, or cannot be evaluated.

    - structure: the structure with its terms, at all measured setups
    - catalogue: evidence for the causes of the catalogue
    - held_out: held-out setups
    """
    terms = tuple(term for term in structure.candidates if term.form)
    setups, scatter = catalogue.setups, catalogue.fitter.shape_scatter
    result, c = None, catalogue.criteria
    for _ in range(1 + MAX_REPEATS if terms else 0):
        fitter = fitter_of(structure, catalogue, held_out, scatter)
        all_setups = AllSetups(structure, setups.data, fitter, list(held_out))
        result = _Explorer(all_setups, terms, catalogue, progress, result).explore()
        scatters = [] if result is None else [result.search.store.shape_scatter(fit) for fit in result.fits]
        smaller_scatter = min((estimate for estimate in scatters if estimate is not None), default=scatter)
        smaller_scatter = max(smaller_scatter, c.shapes.least_scatter)
        if smaller_scatter >= c.shapes.sharper * scatter:
            break
        scatter = smaller_scatter
    return result


def fitter_of(structure: Structure, catalogue: Evidence, held_out: Sequence[int], scatter: float) -> Fitter:
    """Return the fitter of a structure with its terms at the setups that are not held out."""
    data = catalogue.setups.data
    fitted = [i for i in range(len(data.labels)) if i not in held_out]
    return Fitter(structure.subset(fitted), data.at(fitted), catalogue.criteria, scatter)


@dataclass(frozen=True)
class _TermStarts:
    """A term with its start values, and the kind of each if there are several."""

    hypothesis: Hypothesis
    values: Sequence[Array]
    kinds: Sequence[float] = ()

    def best_values(self, order: Sequence[int]) -> list[Array]:
        """Return the best values in an order: the first of each kind, then others."""
        kinds = self.kinds or [0.0] * len(self.values)
        first_of_kind = list({kinds[k]: k for k in reversed(order)}.values())
        selected = [*(k for k in order if k in first_of_kind), *(k for k in order if k not in first_of_kind)][
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
        catalogue: Evidence,
        progress: Progress | None,
        previous: TermFits | None,
    ) -> None:
        self.previous = previous
        self.setups, self.terms, self.catalogue, self.fitter = setups, terms, catalogue, setups.fitter
        self.store, self.criteria = FitStore(setups.fitter), setups.fitter.criteria
        self.progress = progress or (lambda _: None)
        self.search = Search(self.store, setups.structure.candidates, progress)

    def explore(self) -> TermFits | None:
        """Try all terms; None if the structure cannot be evaluated."""
        self.progress(f"scoring {len(self.terms)} terms, each one form at one place")
        error_hypothesis, tried_hypotheses = Hypothesis(), list[Hypothesis]()
        baseline = self.store.fit(
            error_hypothesis, self.fitter.pad_with_declared(self.catalogue.outcome.nuisance_fit.values)
        )
        if baseline is None:
            return None
        fits = first_fits = self._refit_terms(baseline)
        for _ in range(MAX_ERROR_ROUNDS):
            if any(self._leaves_noise(fit) for fit in fits[: self.criteria.search.best_few]):
                break
            tried_hypotheses.append(error_hypothesis)
            # Measurement errors that let the best terms explain most.
            error_fits = [
                option
                for fit in fits[:MAX_TERMS_WITH_ERRORS]
                for option in self.search.additions.with_errors(fit)
            ]
            best_errors = min(error_fits, key=self.store.criterion, default=None)
            extended_hypothesis, refit = error_hypothesis, None
            if best_errors is not None and self.store.criterion(best_errors) < self.store.criterion(fits[0]):
                extended_hypothesis = replace(best_errors.hypothesis, causes=())
            if extended_hypothesis not in tried_hypotheses:
                refit = self.store.fit(extended_hypothesis, baseline.values)
            if refit is None:
                fits = first_fits
                break
            error_hypothesis, fits = extended_hypothesis, self._refit_terms(refit)
        error_hypothesis = replace(fits[0].hypothesis, causes=()) if fits else Hypothesis()
        final_baseline = self.store.fit(error_hypothesis) or baseline
        return TermFits(
            self.setups, self.search, self.terms, final_baseline, tuple(fits), tuple(self._refit_catalogue())
        )

    def _refit_catalogue(self) -> list[Fit]:
        """Return the best explanations of the catalogue that leave noise, fitted again."""
        store, level = self.catalogue.store, self.criteria.gate.surely
        names = {candidate.name for candidate in self.search.candidates}
        explaining = [
            fit
            for fit in {id(fit): fit for fit in (self.catalogue.final, *store.all_fits())}.values()
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
        """Return fits with one term in addition to the measurement errors of a fit, best first."""
        if self.previous is not None:
            previous_values = [
                (baseline.hypothesis.with_cause(fit.causes[0]), [fit.values]) for fit in self.previous.fits
            ]
            return self.store.complete(self.store.rough_fits(previous_values))
        terms_without_starts = [
            term for term in self.terms if not term.starts and self._is_testable(baseline, term)
        ]
        scores = score(self.fitter, baseline, terms_without_starts).by_candidate
        visible_entries = [entry for entry in scores if entry.is_visible and entry.gain > 0.0]
        best_entries = sorted(visible_entries, key=lambda entry: -entry.gain)[:MAX_TERMS_BY_SCORE]
        # The linear estimate suffices for small changes of modes that are all paired.
        are_all_paired = bool(
            (baseline.pairing.partner[self.fitter.used_row_mask(baseline.hypothesis)] >= 0).all()
        )
        small_entries = [
            entry
            for entry in best_entries
            if are_all_paired and float(entry.largest_rates @ np.abs(entry.step)) <= SMALL_CHANGE
        ]
        small_names = {entry.candidate.name for entry in small_entries}
        large_entries = [entry for entry in best_entries if entry.candidate.name not in small_names]
        self.progress(f"refitting with the {len(best_entries)} most promising of {len(self.terms)} terms")
        fits = self.search.additions.refit([(baseline, entry) for entry in large_entries])
        linear_starts = [
            (baseline.hypothesis.with_cause(entry.candidate), [self._values_with_step(baseline, entry)])
            for entry in small_entries
        ]
        overlooked = [entry for entry in scores if entry not in best_entries and entry.largest_rates[0] > 0.0]
        own_starts = [*self._terms_with_starts(baseline), *self._large_terms(baseline, overlooked)]
        best_starts = [
            (h, [values[k] for _, k in order[:STARTS_AFTER_ALL_SETUPS]])
            for (h, values), order in zip(own_starts, _rank_starts(self.fitter, own_starts), strict=True)
        ]
        rough_fits = self.store.rough_fits([*linear_starts, *best_starts])
        return self.store.complete([*fits, *self._restart_astray(baseline, small_entries, rough_fits)])

    def _restart_astray(
        self, baseline: Fit, small_entries: Sequence[Score], rough_fits: Sequence[Fit]
    ) -> list[Fit]:
        """Return the rough fits, restarting those that went astray, as when close modes are exchanged."""
        entry_by_name = {entry.candidate.name: entry for entry in small_entries}
        astray = [
            (fit, entry_by_name[name])
            for fit in rough_fits
            if (name := fit.causes[0].name) in entry_by_name
            and fit.deviance > baseline.deviance - ASTRAY_GAIN * entry_by_name[name].gain
        ]
        good_fits = [fit for fit in rough_fits if all(fit is not restarted for restarted, _ in astray)]
        new_starts = starts(self.fitter, [(baseline, entry, fit.hypothesis) for fit, entry in astray])
        restarts = [
            (fit.hypothesis, [*values, fit.values])
            for (fit, _), values in zip(astray, new_starts, strict=True)
        ]
        return [*good_fits, *self.store.rough_fits(restarts)]

    def _values_with_step(self, baseline: Fit, entry: Score) -> Array:
        """Return the values of a fit with the linear estimate of a term."""
        return self._values_with(
            baseline,
            entry.candidate,
            baseline.values[list(self.fitter.parameter_indices(entry.candidate))] + entry.step,
        )

    def _is_testable(self, baseline: Fit, term: Candidate) -> bool:
        """Return whether data are left to test a term."""
        return self.store.degrees(baseline) > len(term.parameters)

    def _terms_with_starts(self, baseline: Fit) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms with their own starts, each with its best starts."""
        terms = [term for term in self.terms if term.starts and self._is_testable(baseline, term)]
        trials = []
        for term in terms:
            # The kind of a start is its value of the parameter with the fewest distinct values: the mass.
            columns = list(zip(*term.starts, strict=True))
            kinds = min(columns, key=lambda column: len({*column})) if len(columns) > 1 else ()
            values = [self._values_with(baseline, term, start) for start in term.starts]
            trials.append(_TermStarts(baseline.hypothesis.with_cause(term), values, kinds))
        if trials:
            self.progress(f"starting {len(trials)} terms with a frequency of their own")
        return self._most_promising(trials)[:MAX_TERMS_BY_START]

    def _large_terms(self, baseline: Fit, scores: Sequence[Score]) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms for which the linear model predicts little, with their best sizes."""
        trials = [
            _TermStarts(
                baseline.hypothesis.with_cause(entry.candidate),
                [
                    self._values_with(baseline, entry.candidate, [sign * size / entry.largest_rates[0]])
                    for size in START_FREQUENCY_CHANGES
                ],
            )
            for entry in scores
            if (sign := allowed_sign(self.fitter, entry.candidate))
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
        # Excluded rows are dropped for fewer setups, where rows are numbered differently.
        ranked = _rank_starts(
            subsample_fitter, [(Hypothesis(trial.hypothesis.causes), trial.values) for trial in trials]
        )
        ordered = sorted(zip(ranked, trials, strict=True), key=lambda pair: pair[0][0][0])
        return [
            (trial.hypothesis, trial.best_values([k for _, k in order]))
            for order, trial in ordered
            if np.isfinite(order[0][0])
        ]

    def _leaves_noise(self, fit: Fit) -> bool:
        """Return whether a fit leaves noise."""
        level = self.criteria.gate.surely
        return not fit.at_bound and self.store.p_value(fit) > level and self.search.gate(fit).passes_at(level)
