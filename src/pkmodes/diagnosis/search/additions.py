"""What can be added to a hypothesis: a cause, two of them, or an error of the measurement."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.fit.store import FitStore, Key, key
from pkmodes.diagnosis.problem import Candidate
from pkmodes.diagnosis.search.score import Score, Scores, one_sided, score
from pkmodes.diagnosis.search.starts import starts

Progress = Callable[[str], None]


class Additions:
    """Fits with something added.

    Parameters
    ----------
    store : FitStore
    candidates : sequence of Candidate
    progress : callable
        Called with a sentence at each step.
    """

    def __init__(self, store: FitStore, candidates: Sequence[Candidate], progress: Progress) -> None:
        self.store, self.fitter, self.criteria = store, store.fitter, store.fitter.criteria
        self.candidates = tuple(candidates)
        self._progress = progress
        self._rows, self._setups = len(self.fitter.log), len(self.fitter.data.labels)

    def room(self, fit: Fit) -> bool:
        """Whether a fit may assume anything more beyond the declared model."""
        kinds = len(fit.causes) + bool(fit.hypothesis.excluded) + fit.hypothesis.scatter
        return kinds < self.criteria.most_additions

    def noise(self, fit: Fit, *, rival: bool = False) -> list[Fit]:
        """A shared error in each setup, and the exclusion of the row that fits worst.

        Parameters
        ----------
        fit : Fit
        rival : bool, optional
            Whether they only stand against a claim: then a row may be the one that is wrong though there are too few
            to tell.
        """
        h, c, found = fit.hypothesis, self.criteria, []
        enough = self._rows >= c.rows_to_set_aside
        if enough and self._hopeless(fit):
            return []
        room = self.room(fit) and not any(cause.remote for cause in h.causes)
        if room and not h.scatter and self._setups >= 4 and self._rows >= 2 * self._setups:
            found.append(self.store.fit(replace(h, scatter=True), fit.values))
        most = max(1, self._rows // c.rows_per_outlier) if enough or rival else 0
        if (room or h.excluded) and len(h.excluded) < most:
            rows = np.abs(fit.residual[self.fitter.frequency_rows] / self.fitter.sigma)
            for row in np.argsort(rows)[::-1][:3]:
                # What the others do not predict is not set aside: nothing says that it is wrong.
                if rows[row] > 3.0 and (rival or fit.leverage[row] < c.redundant):
                    found.append(self.store.fit(replace(h, excluded=h.excluded | {int(row)}), fit.values))
        return [option for option in found if option is not None]

    def _hopeless(self, fit: Fit) -> bool:
        """Whether far too much is left when each setup has an error of its own and the worst rows are set aside.

        A row that is very wrong may have drawn the fit away, so that many seem so: it is judged again without them.
        """
        if not self._far(fit):
            return False
        h = fit.hypothesis
        rows = np.abs(fit.residual[self.fitter.frequency_rows] / self.fitter.sigma)
        worst = np.argsort(rows)[::-1][: max(1, self._rows // self.criteria.rows_per_outlier)]
        without = self.store.fit(replace(h, excluded=h.excluded | set(worst.tolist())), fit.values)
        return without is None or self._far(without)

    def _far(self, fit: Fit) -> bool:
        left = np.array(fit.residual[self.fitter.frequency_rows])
        for rows in self.fitter.noise.rows:
            left[rows] -= np.median(left[rows])  # which one row that is wrong does not move
        left /= self.fitter.sigma
        most = max(1, self._rows // self.criteria.rows_per_outlier)
        kept = np.sort(left**2)[: max(self._rows - most, 0)]
        degrees = max(self._rows - most - self._setups, 1)
        return bool(kept.sum() > self.criteria.hopeless * degrees)

    def errors(self, enough: float) -> list[Fit]:
        """Fits with errors of the measurement and no cause: one after another, as long as they help.

        Parameters
        ----------
        enough : float
            Criterion that matters; what cannot come so low is not tried to its end.
        """
        found: list[Fit] = []
        fit = self.store.fit(Hypothesis())
        most = max(1, self._rows // self.criteria.rows_per_outlier)
        while fit is not None:
            options = self.noise(fit, rival=True)
            found += options
            best = min(options, key=self.store.criterion, default=fit)
            gain = self.store.criterion(fit) - self.store.criterion(best)
            # Rows are set aside one by one, the worst first: what follows gains less.
            more = most - len(best.hypothesis.excluded) + (not best.hypothesis.scatter)
            within = self.store.criterion(best) - gain * more <= enough
            fit = best if gain > 0.0 and within else None
        return found

    def causes(self, fit: Fit, scores: Scores) -> list[Fit]:
        """One cause more, best first: those of which a linear model promises much, and every absent one."""
        gains = sorted((s.gain for s in scores.each), reverse=True)
        if not gains:
            return []
        c = self.criteria
        enough = min(c.promising * gains[0], gains[min(c.at_least, len(gains)) - 1])
        # Of a cause that is absent the score says little where it is large: it is always tried.
        promising = [
            (fit, one)
            for one in scores.each
            if one.visible and (one.gain >= enough or one_sided(self.fitter, one.candidate))
        ]
        return self.store.finished(
            self._refitted([x for x in promising if self._testable(fit, x[1].candidate)])
        )

    def singles(self) -> list[Fit]:
        """One cause, and nothing else."""
        plain = self.store.fit(Hypothesis())
        return [] if plain is None else self.causes(plain, score(self.fitter, plain, self.candidates))

    def would_do(self) -> list[Fit]:
        """Single causes that would remove a contradiction, however few the data; best first."""
        plain = self.store.fit(Hypothesis())
        if plain is None:
            return []
        found = self._refitted([(plain, one) for one in score(self.fitter, plain, self.candidates).each])
        fits = [fit for fit in found if self.store.p_value(fit) > self.criteria.gate]
        return sorted(fits, key=self.store.criterion)

    def pairs(self) -> list[Fit]:
        """Two causes: all pairs where they are few and the data too, else the most promising.

        Those are the pairs for which a linear model at the fit of one of them promises most, and the best cause with
        every absent one, of which a linear model says little.
        """
        store, c = self.store, self.criteria
        promised: dict[Key, tuple[float, Fit, Score]] = {}
        absent: dict[Key, tuple[float, Fit, Score]] = {}
        singles = sorted(self.singles(), key=store.criterion)
        for single in singles:
            others = [candidate for candidate in self.candidates if candidate not in single.causes]
            for one in score(self.fitter, single, others).each:
                if one.visible and self._testable(single, one.candidate):
                    left = store.criterion(single) - one.gain + store.price(one.candidate)
                    pair, promise = key(single.hypothesis.adding(one.candidate)), (left, single, one)
                    if one.gain > 0.0 or self.few:
                        promised[pair] = min(promised.get(pair, promise), promise, key=_first)
                    if single is singles[0] and one_sided(self.fitter, one.candidate):
                        absent[pair] = promise
        most = len(promised) if self.few else c.pairs
        best = {pair: promised[pair] for pair in sorted(promised, key=lambda pair: promised[pair][0])[:most]}
        return store.finished(self._refitted([(fit, one) for _, fit, one in {**absent, **best}.values()]))

    @property
    def few(self) -> bool:
        """Whether data and candidates are so few that every pair is tried."""
        count = len(self.candidates)
        return self._rows <= self.criteria.few_rows and count * (count - 1) // 2 <= self.criteria.few_pairs

    def _testable(self, fit: Fit, candidate: Candidate) -> bool:
        """Whether something is left to test the fit with: otherwise a cause would fit anything."""
        free = sum(self.fitter.priors.of(i) is None for i in self.fitter.indices(candidate))
        return self.store.degrees(fit) > free

    def _refitted(self, additions: Sequence[tuple[Fit, Score]]) -> list[Fit]:
        """Fits with one cause more, rough ones where they are new, each from the best of several starts."""
        store, known, seeded, new = self.store, [], [], []
        for fit, one in additions:
            hypothesis = fit.hypothesis.adding(one.candidate)
            seed = store.seed(hypothesis)
            if store.known(hypothesis):
                known.append(store.fit(hypothesis))
                continue
            self._progress(f"refitting with {' and '.join(c.name for c in hypothesis.causes)}")
            if seed is None:
                new.append((fit, one, hypothesis))
            else:
                seeded.append((hypothesis, [seed]))
        begun = zip((hypothesis for _, _, hypothesis in new), starts(self.fitter, new), strict=True)
        return [fit for fit in known if fit is not None] + store.roughly([*seeded, *begun])


def _first(promise: tuple[float, Fit, Score]) -> float:
    return promise[0]
