"""The search for causes: gate, refit of every plausible candidate, acceptance, and the gate again.

A step adds what lowers an information criterion most: a cause, an error that all modes of a setup share, or the
exclusion of an outlier, so that no cause gets credit for what a bad measurement explains.  When the gate passes,
everything that is not needed is taken away again, and every cause is tried against all others in its place.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fitting import Fit, Fitter, Hypothesis
from pkmodes.diagnosis.problem import Array, Candidate
from pkmodes.diagnosis.score import Score, Scores, one_sided, score

Progress = Callable[[str], None]
Key = tuple[frozenset[str], frozenset[int], bool]

#: The gate's two tests, each at this level: is there more left than noise, and does it point at a candidate?
ALPHA = 0.01
#: A rival survives up to this difference of the criterion: three standard deviations.
SURVIVES = 9.0
#: What is not needed to pass the gate is taken away unless it lowers the criterion by more than this.
WORTH = 6.0
#: Causes that are added at most; more would explain anything.
MOST_CAUSES = 2
#: Of how many single causes the best companions are sought, and how many of them are refitted.
FIRSTS, COMPANIONS = 4, 8
#: A second cause is sought if the first leaves less than this part of chi2, or less than this per degree of freedom.
MUCH, LITTLE = 0.6, 25.0
#: Candidates are refitted if a linear model promises this fraction of the best gain, and the best few anyhow.
PROMISING, AT_LEAST = 0.15, 10
#: Fractions of the linear estimate, and of a change of the frequencies by one, at which refits start.
STARTS = (0.003, 0.01, 0.03, 0.06, 0.1, 0.2, 0.4, 1.0, 3.0)
#: A setup with more leverage than this determines something alone: no other predicts it, with the cause or without.
ALONE = 0.7
#: An excluded row costs as much as three parameters: it was chosen among all.
PRICE_OF_ROW = 3.0


@dataclass(frozen=True)
class Gate:
    """Whether what a fit leaves is noise.

    Attributes
    ----------
    p_value : float
        Of the sum of squares.
    p_candidates : float
        Of the best candidate, calibrated for their number.
    unpaired : int
        Measured modes that the model has no mode for.
    scores : Scores
    """

    p_value: float
    p_candidates: float
    unpaired: int
    scores: Scores

    @property
    def passed(self) -> bool:
        """Nothing is left beyond noise."""
        return self.unpaired == 0 and self.p_value > ALPHA and self.p_candidates > ALPHA


@dataclass(frozen=True)
class Outcome:
    """What the search came to.

    Attributes
    ----------
    nuisances : Fit
        The declared model with its nuisances refitted.
    first : Gate
        At that fit.
    final : Fit
    last : Gate
        At the final fit.
    """

    nuisances: Fit
    first: Gate
    final: Fit
    last: Gate


class Search:
    """Searches the causes of what one set of measurements shows.

    Parameters
    ----------
    fitter : Fitter
    candidates : sequence of Candidate
    progress : callable, optional
        Called with a sentence at each step.
    """

    def __init__(
        self, fitter: Fitter, candidates: Sequence[Candidate], progress: Progress | None = None
    ) -> None:
        self.fitter, self.candidates = fitter, tuple(candidates)
        self._progress = progress or (lambda _: None)
        self._rows = len(fitter.log)
        self._setups = len(fitter.data.labels)
        self._fits: dict[Key, Fit | None] = {}

    def run(self) -> Outcome | None:
        """Search; None where the declared model cannot be evaluated."""
        self._progress("refitting the nuisance parameters")
        first = self._fit(Hypothesis(), None)
        if first is None:
            return None
        gate = self.gate(first)
        final, last = first, gate
        while not last.passed:
            addition = self._addition(final, last)
            if addition is None:
                break
            final = self._settled(addition) if addition.causes != final.causes else addition
            last = self.gate(final)
        if last.passed:
            final = self._needed(final)
            last = self.gate(final)
        return Outcome(first, gate, final, last)

    def pairs_like(self, final: Fit) -> tuple[Fit, ...]:
        """Every fit with two causes that differs from the final one in nothing else, if that has two."""
        if len(final.causes) < MOST_CAUSES:
            return ()
        h = final.hypothesis
        return tuple(
            fit
            for fit in self._fits.values()
            if fit is not None
            and len(fit.causes) == MOST_CAUSES
            and (fit.hypothesis.excluded, fit.hypothesis.scatter) == (h.excluded, h.scatter)
        )

    def explained_by_larger_errors(self, final: Fit) -> bool:
        """Whether errors larger than stated, by one factor, explain the residual nearly as well as the causes.

        The deviance of the most likely factor, with the rows set aside and the shared error of the final fit.
        """
        h = final.hypothesis
        base = self._fit(Hypothesis(excluded=h.excluded, scatter=h.scatter), None)
        if base is None:
            return False
        count = self._rows - len(h.excluded)
        inflated = self.criterion(base) - base.chi2 + count * (1.0 + np.log(max(base.chi2 / count, 1.0)))
        return bool(inflated + np.log(self._rows) <= self.criterion(final) + SURVIVES)

    def gate(self, fit: Fit) -> Gate:
        """Test what is left."""
        others = [candidate for candidate in self.candidates if candidate not in fit.causes]
        scores = score(self.fitter, fit, others)
        unpaired = int((fit.pairing.partner[self.fitter.used(fit.hypothesis)] < 0).sum())
        return Gate(self.p_value(fit), scores.p_value, unpaired, scores)

    def p_value(self, fit: Fit) -> float:
        """Probability of a sum of squares as large, under the hypothesis."""
        return float(stats.chi2.sf(fit.chi2, max(self.degrees(fit), 1)))

    def degrees(self, fit: Fit) -> int:
        """Degrees of freedom: rows less parameters without prior, excluded rows and the shared error."""
        h = fit.hypothesis
        return self._rows - len(h.excluded) - sum(len(c.parameters) for c in h.causes) - int(h.scatter)

    def criterion(self, fit: Fit) -> float:
        """Schwarz's information criterion (BIC), excluded rows at their price; smaller is better."""
        h = fit.hypothesis
        count = sum(len(c.parameters) for c in h.causes) + int(h.scatter) + PRICE_OF_ROW * len(h.excluded)
        return fit.deviance + float(np.log(self._rows)) * count

    def without(self, fit: Fit, place: int) -> Fit | None:
        """Return the fit with one of its causes taken away."""
        causes = fit.causes
        less = replace(fit.hypothesis, causes=(*causes[:place], *causes[place + 1 :]))
        return self._fit(less, self._without(fit, less))

    def predicts(self, fit: Fit) -> bool:
        """Whether the last cause helps to predict setups that take no part in the fit."""
        less = self.without(fit, len(fit.causes) - 1)
        if less is None:
            return True
        squares, leverage = self.fitter.left_out(fit)
        tells = leverage < ALONE
        return tells.sum() < 2 or bool(squares[tells].sum() < self.fitter.left_out(less)[0][tells].sum())

    # Steps -------------------------------------------------------------------------------------------------

    def _addition(self, fit: Fit, gate: Gate) -> Fit | None:
        """The best of all that can be added; None where nothing helps."""
        options = self._noise(fit)
        if not fit.causes:
            options += self._causes(fit, gate.scores)
        elif len(fit.causes) < MOST_CAUSES and self._hopeful(fit):
            options += self._pairs(fit)
        best = min(options, key=self.criterion, default=fit)
        return best if self.criterion(best) < self.criterion(fit) else None

    def _hopeful(self, fit: Fit) -> bool:
        """Whether a second cause may do: the first did much of the work, or little is left."""
        base = self.without(fit, 0)
        return base is None or fit.chi2 < MUCH * base.chi2 or fit.chi2 < LITTLE * self.degrees(fit)

    def _pairs(self, fit: Fit) -> list[Fit]:
        """Two causes: companions of the best single ones, since the first need not be one of the two."""
        base = self.without(fit, 0)
        if base is None:
            return []
        singles = self._causes(base, score(self.fitter, base, self.candidates))
        found = []
        for single in sorted(singles, key=self.criterion)[:FIRSTS]:
            others = [candidate for candidate in self.candidates if candidate not in single.causes]
            each = score(self.fitter, single, others).each
            for one in sorted(each, key=lambda s: -s.gain)[:COMPANIONS]:
                if one.visible and one.gain > 0.0 and self.degrees(single) > len(one.candidate.parameters):
                    found.append(self._refit(single, one))
        return [pair for pair in found if pair is not None]

    def _noise(self, fit: Fit) -> list[Fit]:
        """A shared error in each setup, and the exclusion of the row that fits worst."""
        h, found = fit.hypothesis, []
        if not h.scatter and self._setups >= 4 and self._rows >= 2 * self._setups:
            found.append(self._fit(replace(h, scatter=True), fit.values))
        if len(h.excluded) < max(1, self._rows // 30):
            rows = np.abs(fit.residual / self.fitter.sigma)
            for row in np.argsort(rows)[::-1][:3]:
                if rows[row] > 3.0:
                    found.append(self._fit(replace(h, excluded=h.excluded | {int(row)}), fit.values))
        return [option for option in found if option is not None]

    def _causes(self, fit: Fit, scores: Scores) -> list[Fit]:
        gains = sorted((s.gain for s in scores.each), reverse=True)
        if not gains:
            return []
        enough = min(PROMISING * gains[0], gains[min(AT_LEAST, len(gains)) - 1])
        found = []
        for one in scores.each:
            # Of a cause that is absent the score says little where it is large: it is always tried.
            known = self.degrees(fit) > len(one.candidate.parameters)  # otherwise it would fit anything
            if known and one.visible and (one.gain >= enough or one_sided(self.fitter, one.candidate)):
                found.append(self._refit(fit, one))
        return [option for option in found if option is not None]

    def _refit(self, fit: Fit, one: Score) -> Fit | None:
        """Fit with one cause more, from the best of several starts."""
        hypothesis = fit.hypothesis.adding(one.candidate)
        if _key(hypothesis) in self._fits:
            return self._fit(hypothesis, None)
        self._progress(f"refitting with {' and '.join(c.name for c in hypothesis.causes)}")
        starts = self._starts(fit, one)
        costs = [self.fitter.chi2_of(start, hypothesis) for start in starts]
        order = np.argsort(costs, kind="stable")
        return self._fit(hypothesis, starts[order[0]])

    def _starts(self, fit: Fit, one: Score) -> list[Array]:
        """The linear estimate and, for a cause of one sign and unknown size, several magnitudes."""
        index = list(self.fitter.indices(one.candidate))
        lower = np.array([self.fitter.parameters[i].lower for i in index])
        upper = np.array([self.fitter.parameters[i].upper for i in index])
        here = fit.values[index]
        steps = [one.step, 0.5 * one.step]
        sign = one_sided(self.fitter, one.candidate)
        if sign and one.largest[0] > 0.0:
            sizes = STARTS[1::2] if fit.causes else STARTS
            steps += [np.array([sign * size / one.largest[0]]) for size in sizes]
        found = []
        for step in steps:
            # A large cause drives the nuisances far away when it is not there: begin at the declared ones too.
            for values in (fit.values, self.fitter.declared)[: 1 if fit.causes else 2]:
                start = fit.values.copy()
                start[list(self.fitter.nuisances)] = values[list(self.fitter.nuisances)]
                start[index] = np.clip(here + step, lower, upper)
                found.append(start)
        return found

    def _settled(self, fit: Fit) -> Fit:
        """With several causes: exchange one for another while that lowers the criterion."""
        near = fit.chi2 < LITTLE * self.degrees(fit)
        for _ in range(MOST_CAUSES if len(fit.causes) > 1 and near else 0):
            best = fit
            for place in range(len(fit.causes)):
                best = min([best, *self.rivals(fit, place)], key=self.criterion)
            if best is fit:
                break
            fit = best
        return fit

    def _needed(self, fit: Fit) -> Fit:
        """Take away what the gate does not need."""
        h = fit.hypothesis
        smaller = [replace(h, excluded=h.excluded - {row}) for row in sorted(h.excluded)]
        smaller += [replace(h, scatter=False)] if h.scatter else []
        smaller += [replace(h, causes=(*h.causes[:i], *h.causes[i + 1 :])) for i in range(len(h.causes))]
        for hypothesis in smaller:
            less = self._fit(hypothesis, self._without(fit, hypothesis))
            if (
                less is not None
                and self.gate(less).passed
                and self.criterion(less) < self.criterion(fit) + WORTH
            ):
                return self._needed(less)
        return fit

    def rivals(self, fit: Fit, place: int) -> tuple[Fit, ...]:
        """Fits with other causes in one place, best first; in all of them that cause is the last one."""
        causes = fit.causes
        hypothesis = replace(fit.hypothesis, causes=(*causes[:place], *causes[place + 1 :]))
        base = self._fit(hypothesis, self._without(fit, hypothesis))
        found = {causes[place].name: replace(fit, hypothesis=hypothesis.adding(causes[place]))}
        if base is not None:
            others = [candidate for candidate in self.candidates if candidate not in hypothesis.causes]
            for option in self._causes(base, score(self.fitter, base, others)):
                found.setdefault(option.causes[-1].name, option)
        return tuple(sorted(found.values(), key=self.criterion))

    def _without(self, fit: Fit, hypothesis: Hypothesis) -> Array:
        """Values of a fit, with those causes undone that a hypothesis has not."""
        values = fit.values.copy()
        for cause in fit.causes:
            if cause not in hypothesis.causes:
                index = list(self.fitter.indices(cause))
                values[index] = self.fitter.declared[index]
        return values

    def _fit(self, hypothesis: Hypothesis, start: Array | None) -> Fit | None:
        """Fit once, whatever the order of the causes."""
        key = _key(hypothesis)
        if key not in self._fits:
            self._fits[key] = self.fitter.fit(hypothesis, start)
        found = self._fits[key]
        return found if found is None else replace(found, hypothesis=hypothesis)


def _key(hypothesis: Hypothesis) -> Key:
    return frozenset(c.name for c in hypothesis.causes), hypothesis.excluded, hypothesis.scatter
