"""Additions to a hypothesis: one or two causes, or a measurement error."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from operator import itemgetter

import numpy as np

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore, Key, key
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.score import Score, Scores, one_sided, score
from pkmodes.loop.diagnosis.search.starts import starts

Progress = Callable[[str], None]
#: Largest number of pairs that are all refitted; more would take minutes.
FEW_PAIRS = 120


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

    def room(self, fit: Fit) -> bool:
        """Return whether another kind of addition is allowed."""
        kinds = len(fit.causes) + bool(fit.hypothesis.excluded) + fit.hypothesis.scatter
        return kinds < self.criteria.search.most_additions

    def noise(self, fit: Fit, *, rival: bool = False) -> list[Fit]:
        """Return fits with a shared error in each setup, and with one of the worst rows excluded.

        - rival: whether they only compete with a claim: then a row may be excluded even if there are too few rows to
          show that it is wrong
        """
        h, c, fits = fit.hypothesis, self.criteria, []
        enough = self._rows >= c.search.rows_to_set_aside
        if enough and self._hopeless(fit):
            return []
        room = self.room(fit) and not h.remote
        if room and not h.scatter and self._setups >= 4 and self._rows >= 2 * self._setups:
            fits.append(self.store.fit(replace(h, scatter=True), fit.values))
        allowed = self._most_outliers if enough or rival else 0
        if (room or h.excluded) and len(h.excluded) < allowed:
            worst, sigmas = self.fitter.worst_rows(fit)
            for row in worst[:3]:
                # A row that the others do not predict is not set aside: nothing shows that it is wrong.
                if sigmas[row] > 3.0 and (rival or fit.leverage[row] < c.search.redundant):
                    fits.append(self.store.fit(replace(h, excluded=h.excluded | {int(row)}), fit.values))
        return [option for option in fits if option is not None]

    def without_distant_rows(self, fit: Fit) -> list[Fit]:
        """Return fits with a cause, without the rows farthest from any mode, that leave only noise.

        A row that is not a mode, such as a tone or a peak of noise, may be as far from the model as a large cause,
        and distort all fits: no cause helps until it is removed.  None is needed where a cause helps by itself.
        """
        c, fits = self.criteria, list[Fit]()
        if self._rows < c.search.rows_to_set_aside or fit.causes or fit.hypothesis.excluded:
            return fits
        for _ in range(self._most_outliers):
            worst, sigmas = self.fitter.worst_rows(fit)
            if sigmas[worst[0]] < c.search.strange:
                break
            h = fit.hypothesis
            less = self.store.fit(replace(h, excluded=h.excluded | {int(worst[0])}), fit.values)
            if less is None:
                break
            fit = less
            fits += self.causes(fit, score(self.fitter, fit, self.candidates))
        return [option for option in fits if self.store.p_value(option) > c.gate.surely]

    def _hopeless(self, fit: Fit) -> bool:
        """Return whether far too much is left even with a shared error in each setup and without the worst rows.

        A gross outlier may distort the fit, so many rows look wrong: the fit is repeated without the worst rows.
        """
        if not self._far(fit):
            return False
        h = fit.hypothesis
        worst = self.fitter.worst_rows(fit)[0][: self._most_outliers]
        without = self.store.fit(replace(h, excluded=h.excluded | set(worst.tolist())), fit.values)
        return without is None or self._far(without)

    def _far(self, fit: Fit) -> bool:
        residual = np.array(fit.residual[self.fitter.observations.frequency_rows])
        for rows in self.fitter.observations.noise.rows:
            residual[rows] -= np.median(residual[rows])  # robust against one outlier
        residual /= self.fitter.observations.sigma
        kept = np.sort(residual**2)[: max(self._rows - self._most_outliers, 0)]
        degrees = max(self._rows - self._most_outliers - self._setups, 1)
        return bool(kept.sum() > self.criteria.search.hopeless * degrees)

    def errors(self, enough: float) -> list[Fit]:
        """Return fits with measurement errors and no cause, added one by one while they help.

        - enough: largest criterion of interest; the additions stop if it cannot be reached
        """
        errors: list[Fit] = []
        fit = self.store.fit(Hypothesis())
        while fit is not None:
            options = self.noise(fit, rival=True)
            errors += options
            best = min(options, key=self.store.criterion, default=fit)
            gain = self.store.criterion(fit) - self.store.criterion(best)
            # Rows are set aside one by one, the worst first: later ones gain less.
            remaining = self._most_outliers - len(best.hypothesis.excluded) + (not best.hypothesis.scatter)
            within = self.store.criterion(best) - gain * remaining <= enough
            fit = best if gain > 0.0 and within else None
        return errors

    def causes(self, fit: Fit, scores: Scores) -> list[Fit]:
        """Return fits with one more cause, best first: those that the linear model favours, and absent effects."""
        gains = sorted((s.gain for s in scores.by_candidate), reverse=True)
        if not gains:
            return []
        c = self.criteria
        enough = min(c.search.promising * gains[0], gains[min(c.search.at_least, len(gains)) - 1])
        # The score is inaccurate for large changes: an absent effect, which may be large, is always tried.
        promising = [
            (fit, entry)
            for entry in scores.by_candidate
            if entry.visible and (entry.gain >= enough or one_sided(self.fitter, entry.candidate))
        ]
        return self.store.complete(
            self.refitted([x for x in promising if self._testable(fit, x[1].candidate)])
        )

    def singles(self) -> list[Fit]:
        """Return fits with one cause and nothing else."""
        plain = self.store.fit(Hypothesis())
        return [] if plain is None else self.causes(plain, score(self.fitter, plain, self.candidates))

    def would_do(self) -> list[Fit]:
        """Return single causes that would remove a contradiction, even with very few data; best first."""
        plain = self.store.fit(Hypothesis())
        if plain is None:
            return []
        refitted = self.refitted(
            [(plain, entry) for entry in score(self.fitter, plain, self.candidates).by_candidate]
        )
        fits = [fit for fit in refitted if self.store.p_value(fit) > self.criteria.gate.level]
        return sorted(fits, key=self.store.criterion)

    def pairs(self) -> list[Fit]:
        """Return fits with two causes: all pairs if both pairs and data are few, else the most promising.

        These are the pairs for which the linear model at the fit of one of them promises most, and the best cause
        with every absent effect, for which the linear model is inaccurate.
        """
        store, c = self.store, self.criteria
        promised: dict[Key, tuple[float, Fit, Score]] = {}
        absent: dict[Key, tuple[float, Fit, Score]] = {}
        singles = sorted(self.singles(), key=store.criterion)
        for single in singles:
            further = [candidate for candidate in self.candidates if candidate not in single.causes]
            for entry in score(self.fitter, single, further).by_candidate:
                if entry.visible and self._testable(single, entry.candidate):
                    expected = store.criterion(single) - entry.gain + store.price(entry.candidate)
                    pair, promise = (
                        key(single.hypothesis.with_cause(entry.candidate)),
                        (expected, single, entry),
                    )
                    if entry.gain > 0.0 or self.few:
                        promised[pair] = min(promised.get(pair, promise), promise, key=itemgetter(0))
                    if single is singles[0] and one_sided(self.fitter, entry.candidate):
                        absent[pair] = promise
        count = len(promised) if self.few else c.search.pairs
        best = {pair: promised[pair] for pair in sorted(promised, key=lambda pair: promised[pair][0])[:count]}
        return store.complete(self.refitted([(fit, entry) for _, fit, entry in {**absent, **best}.values()]))

    @property
    def few(self) -> bool:
        """Whether data and candidates are few enough to try all pairs."""
        count = len(self.candidates)
        return self._rows <= self.criteria.search.few_rows and count * (count - 1) // 2 <= FEW_PAIRS

    def _testable(self, fit: Fit, candidate: Candidate) -> bool:
        """Return whether a cause may be added, and data are left to test it: otherwise it would fit anything."""
        free = sum(self.fitter.priors.row_of(i) is None for i in self.fitter.indices(candidate))
        return fit.hypothesis.allows(candidate) and self.store.degrees(fit) > free

    def refitted(self, additions: Sequence[tuple[Fit, Score]]) -> list[Fit]:
        """Return fits with one more cause; new ones are rough, each from the best of several starts."""
        store, fitted, seeded, new = self.store, [], [], []
        for fit, entry in additions:
            hypothesis = fit.hypothesis.with_cause(entry.candidate)
            seed = store.start_values(hypothesis)
            if store.is_fitted(hypothesis):
                fitted.append(store.fit(hypothesis))
                continue
            self._progress(f"refitting with {' and '.join(c.name for c in hypothesis.causes)}")
            if seed is None:
                new.append((fit, entry, hypothesis))
            else:
                seeded.append((hypothesis, [seed]))
        begun = zip((hypothesis for _, _, hypothesis in new), starts(self.fitter, new), strict=True)
        return [fit for fit in fitted if fit is not None] + store.rough_fits([*seeded, *begun])
