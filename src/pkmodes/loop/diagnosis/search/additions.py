"""Additions to a hypothesis: one or two causes, or a measurement error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from operator import itemgetter

import numpy as np

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore, Key, key
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.score import Score, Scores, allowed_sign, score
from pkmodes.loop.diagnosis.search.starts import starts

Progress = Callable[[str], None]
#: Largest number of pairs that are all refitted; more would take minutes.
MAX_PAIRS_TRIED = 120


class Additions:
    """Fits with additions.

    - progress: called with a sentence at each step
    """

    def __init__(self, store: FitStore, candidates: Sequence[Candidate], progress: Progress) -> None:
        self.store, self.fitter, self.criteria = store, store.fitter, store.fitter.criteria
        self.candidates = tuple(candidates)
        self._progress = progress
        self._rows, self._setups = len(self.fitter.observations.log_frequencies), len(self.fitter.data.labels)
        self._most_outliers = max(1, self._rows // self.criteria.search.rows_per_outlier)

    def allows_another_kind(self, fit: Fit) -> bool:
        """Return whether another kind of addition is allowed."""
        kinds = len(fit.causes) + bool(fit.hypothesis.excluded_rows) + fit.hypothesis.has_shared_error
        return kinds < self.criteria.search.most_additions

    def with_errors(self, fit: Fit, *, as_rivals: bool = False) -> list[Fit]:
        """Return fits with a shared error in each setup, and with one of the worst rows excluded.

        - as_rivals: whether they only compete with a claim: then a row may be excluded even if there are too few rows
          to show that it is wrong
        """
        h, c, options = fit.hypothesis, self.criteria, []
        has_enough_rows = self._rows >= c.search.rows_to_set_aside
        if has_enough_rows and self._is_hopeless(fit):
            return []
        has_room = self.allows_another_kind(fit) and not h.remote
        if has_room and not h.has_shared_error and self._setups >= 4 and self._rows >= 2 * self._setups:
            options.append(self.store.fit(replace(h, has_shared_error=True), fit.values))
        max_excluded = self._most_outliers if has_enough_rows or as_rivals else 0
        if (has_room or h.excluded_rows) and len(h.excluded_rows) < max_excluded:
            ranked_rows, normalised_residuals = self.fitter.rows_by_residual(fit)
            for row in ranked_rows[:3]:
                # A row that the others do not predict is not set aside: nothing shows that it is wrong.
                if normalised_residuals[row] > 3.0 and (as_rivals or fit.leverage[row] < c.search.redundant):
                    options.append(
                        self.store.fit(replace(h, excluded_rows=h.excluded_rows | {int(row)}), fit.values)
                    )
        return [option for option in options if option is not None]

    def without_distant_rows(self, fit: Fit) -> list[Fit]:
        """Return fits with a cause, without the rows farthest from any mode, that leave only noise.

        A row that is not a mode, such as a tone or a peak of noise, may be as far from the model as a large cause,
        and distort all fits: no cause helps until it is removed.  Where a cause helps by itself, no row is removed.
        """
        c, fits = self.criteria, list[Fit]()
        if self._rows < c.search.rows_to_set_aside or fit.causes or fit.hypothesis.excluded_rows:
            return fits
        for _ in range(self._most_outliers):
            ranked_rows, normalised_residuals = self.fitter.rows_by_residual(fit)
            if normalised_residuals[ranked_rows[0]] < c.search.strange:
                break
            h = fit.hypothesis
            reduced_fit = self.store.fit(
                replace(h, excluded_rows=h.excluded_rows | {int(ranked_rows[0])}), fit.values
            )
            if reduced_fit is None:
                break
            fit = reduced_fit
            fits += self.with_another_cause(fit, score(self.fitter, fit, self.candidates))
        return [option for option in fits if self.store.p_value(option) > c.gate.surely]

    def _is_hopeless(self, fit: Fit) -> bool:
        """Return whether the residual is far from noise even with shared errors and without the worst rows.

        A gross outlier may distort the fit, so many rows look wrong: the fit is repeated without the worst rows.
        """
        if not self._is_far_from_noise(fit):
            return False
        h = fit.hypothesis
        ranked_rows = self.fitter.rows_by_residual(fit)[0][: self._most_outliers]
        reduced_fit = self.store.fit(
            replace(h, excluded_rows=h.excluded_rows | set(ranked_rows.tolist())), fit.values
        )
        return reduced_fit is None or self._is_far_from_noise(reduced_fit)

    def _is_far_from_noise(self, fit: Fit) -> bool:
        residual = np.array(fit.residual[self.fitter.observations.frequency_slice])
        for rows in self.fitter.observations.noise.rows:
            residual[rows] -= np.median(residual[rows])  # robust against one outlier
        residual /= self.fitter.observations.sigma
        smallest_squares = np.sort(residual**2)[: max(self._rows - self._most_outliers, 0)]
        degrees = max(self._rows - self._most_outliers - self._setups, 1)
        return bool(smallest_squares.sum() > self.criteria.search.hopeless * degrees)

    def with_errors_only(self, max_criterion: float) -> list[Fit]:
        """Return fits with measurement errors and no cause, added one by one while they help.

        - max_criterion: largest criterion of interest; the additions stop if it cannot be reached
        """
        error_fits: list[Fit] = []
        fit = self.store.fit(Hypothesis())
        while fit is not None:
            options = self.with_errors(fit, as_rivals=True)
            error_fits += options
            best = min(options, key=self.store.criterion, default=fit)
            gain = self.store.criterion(fit) - self.store.criterion(best)
            # Rows are set aside one by one, the worst first: later ones gain less.
            remaining_additions = (
                self._most_outliers
                - len(best.hypothesis.excluded_rows)
                + (not best.hypothesis.has_shared_error)
            )
            is_reachable = self.store.criterion(best) - gain * remaining_additions <= max_criterion
            fit = best if gain > 0.0 and is_reachable else None
        return error_fits

    def with_another_cause(self, fit: Fit, scores: Scores) -> list[Fit]:
        """Return fits with one more cause, best first: those that the linear model favours, and absent effects."""
        gains = sorted((s.gain for s in scores.by_candidate), reverse=True)
        if not gains:
            return []
        c = self.criteria
        min_gain = min(c.search.promising * gains[0], gains[min(c.search.at_least, len(gains)) - 1])
        # The score is inaccurate for large changes: an absent effect, which may be large, is always tried.
        promising = [
            (fit, candidate_score)
            for candidate_score in scores.by_candidate
            if candidate_score.is_visible
            and (candidate_score.gain >= min_gain or allowed_sign(self.fitter, candidate_score.candidate))
        ]
        return self.store.complete(
            self.refit([addition for addition in promising if self._testable(fit, addition[1].candidate)])
        )

    def single_causes(self) -> list[Fit]:
        """Return fits with one cause and nothing else."""
        declared_fit = self.store.fit(Hypothesis())
        if declared_fit is None:
            return []
        return self.with_another_cause(declared_fit, score(self.fitter, declared_fit, self.candidates))

    def sufficient_causes(self) -> list[Fit]:
        """Return single causes that would remove a contradiction, even with very few data; best first."""
        declared_fit = self.store.fit(Hypothesis())
        if declared_fit is None:
            return []
        refitted = self.refit(
            [
                (declared_fit, candidate_score)
                for candidate_score in score(self.fitter, declared_fit, self.candidates).by_candidate
            ]
        )
        fits = [fit for fit in refitted if self.store.p_value(fit) > self.criteria.gate.level]
        return sorted(fits, key=self.store.criterion)

    def pairs(self) -> list[Fit]:
        """Return fits with two causes: all pairs if both pairs and data are few, else the most promising.

        The most promising pairs are those for which the linear model at the fit of one of the two causes promises
        most, and the best cause with every absent effect, for which the linear model is inaccurate.
        """
        store, c = self.store, self.criteria
        by_linear_model: dict[Key, tuple[float, Fit, Score]] = {}
        absent_effects: dict[Key, tuple[float, Fit, Score]] = {}
        singles = sorted(self.single_causes(), key=store.criterion)
        for single in singles:
            other_candidates = [candidate for candidate in self.candidates if candidate not in single.causes]
            for candidate_score in score(self.fitter, single, other_candidates).by_candidate:
                if candidate_score.is_visible and self._testable(single, candidate_score.candidate):
                    expected_criterion = (
                        store.criterion(single)
                        - candidate_score.gain
                        + store.price(candidate_score.candidate)
                    )
                    pair = key(single.hypothesis.with_cause(candidate_score.candidate))
                    promising_addition = expected_criterion, single, candidate_score
                    if candidate_score.gain > 0.0 or self.tries_all_pairs:
                        by_linear_model[pair] = min(
                            by_linear_model.get(pair, promising_addition),
                            promising_addition,
                            key=itemgetter(0),
                        )
                    if single is singles[0] and allowed_sign(self.fitter, candidate_score.candidate):
                        absent_effects[pair] = promising_addition
        count = len(by_linear_model) if self.tries_all_pairs else c.search.pairs
        best = {
            pair: by_linear_model[pair]
            for pair in sorted(by_linear_model, key=lambda pair: by_linear_model[pair][0])[:count]
        }
        return store.complete(
            self.refit(
                [(fit, candidate_score) for _, fit, candidate_score in {**absent_effects, **best}.values()]
            )
        )

    @property
    def tries_all_pairs(self) -> bool:
        """Whether data and candidates are few enough to try all pairs."""
        count = len(self.candidates)
        return self._rows <= self.criteria.search.few_rows and count * (count - 1) // 2 <= MAX_PAIRS_TRIED

    def _testable(self, fit: Fit, candidate: Candidate) -> bool:
        """Return whether a cause may be added, with enough data left to test it: otherwise it would fit anything."""
        free_parameters = sum(
            self.fitter.priors.row_of(i) is None for i in self.fitter.parameter_indices(candidate)
        )
        return fit.hypothesis.allows(candidate) and self.store.degrees(fit) > free_parameters

    def refit(self, additions: Sequence[tuple[Fit, Score]]) -> list[Fit]:
        """Return fits with one more cause; new ones are rough, each from the best of several starts."""
        store, known_fits, with_seed, without_seed = self.store, [], [], []
        for fit, candidate_score in additions:
            hypothesis = fit.hypothesis.with_cause(candidate_score.candidate)
            seed = store.start_values(hypothesis)
            if store.is_fitted(hypothesis):
                known_fits.append(store.fit(hypothesis))
                continue
            self._progress(f"refitting with {' and '.join(c.name for c in hypothesis.causes)}")
            if seed is None:
                without_seed.append((fit, candidate_score, hypothesis))
            else:
                with_seed.append((hypothesis, [seed]))
        with_starts = zip(
            (hypothesis for _, _, hypothesis in without_seed), starts(self.fitter, without_seed), strict=True
        )
        return [fit for fit in known_fits if fit is not None] + store.rough_fits([*with_seed, *with_starts])
