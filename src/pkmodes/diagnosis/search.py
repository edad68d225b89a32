"""The search for causes: gate, refit of every plausible candidate, acceptance, and the gate again.

A step adds what lowers an information criterion most: a cause, an error that all modes of a setup share, or the
exclusion of an outlier, so that no cause gets credit for what a bad measurement explains.  When the gate passes,
everything that is not needed is taken away again, and every cause is tried against all others in its place.

Two causes have many hundred pairs to choose from, and with errors of the measurement beside them they would
explain anything.  They are sought only where one cause surely leaves something and no remote one explains all
of it alone, and never together with outliers or shared errors.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fitting import Fit, Fitter, Hypothesis
from pkmodes.diagnosis.gate import ALPHA, SURELY, Gate
from pkmodes.diagnosis.left_out import left_out
from pkmodes.diagnosis.missing import p_missing
from pkmodes.diagnosis.problem import Array, Candidate
from pkmodes.diagnosis.score import Score, Scores, one_sided, score
from pkmodes.diagnosis.starts import starts

Progress = Callable[[str], None]
Key = tuple[frozenset[str], frozenset[int], bool]

#: A rival survives up to this difference of the criterion: three standard deviations.
SURVIVES = 9.0
#: What is not needed to pass the gate is taken away unless it lowers the criterion by more than this.
WORTH = 6.0
#: Causes that are added at most, and kinds of additions: causes, outliers, an error shared in each setup.
MOST_CAUSES = MOST_ADDITIONS = 2
#: How many pairs of causes are refitted.
PAIRS = 16
#: A second cause is sought if the first leaves less than this part of chi2, or less than this per degree of freedom.
MUCH, LITTLE = 0.6, 25.0
#: Candidates are refitted if a linear model promises this fraction of the best gain, and the best few anyhow.
PROMISING, AT_LEAST = 0.15, 10
#: Of rough fits, the best few are finished, and those that differ from the best by less than this.
BEST_FEW, NEARLY = 4, 60.0
#: A setup with more leverage than this determines something alone: no other predicts it, with the cause or without.
ALONE = 0.7
#: An excluded row costs as much as three parameters: it was chosen among all.
PRICE_OF_ROW = 3.0


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
        self.fitter = fitter
        self.candidates = tuple(candidate for candidate in candidates if not candidate.remote)
        self.remote = tuple(candidate for candidate in candidates if candidate.remote)
        self._progress = progress or (lambda _: None)
        self._rows = len(fitter.log)
        self._setups = len(fitter.data.labels)
        self._fits: dict[Key, Fit | None] = {}
        self._rough: set[Key] = set()
        self._begun: set[Key] = set()

    def run(self) -> Outcome | None:
        """Search; None where the declared model cannot be evaluated."""
        self._progress("refitting the nuisance parameters")
        first = self.fit(Hypothesis())
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

    def tried(self) -> tuple[Fit, ...]:
        """Every fit so far."""
        return tuple(fit for fit in self._fits.values() if fit is not None)

    def gate(self, fit: Fit) -> Gate:
        """Test what is left."""
        others = [candidate for candidate in self.candidates if candidate not in fit.causes]
        scores = score(self.fitter, fit, others)
        unpaired = int((fit.pairing.partner[self.fitter.used(fit.hypothesis)] < 0).sum())
        level = SURELY if len(fit.causes) == 1 and not fit.causes[0].remote else ALPHA
        return Gate(self.p_value(fit), scores.p_value, unpaired, self.p_missing(fit), scores, level)

    def p_missing(self, fit: Fit) -> float:
        """Probability that nobody measured the modes that the causes of a fit add among the measured ones."""
        return p_missing(self.fitter, self.fit(Hypothesis()) or fit, fit)

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
        return self.fit(less, self._without(fit, less))

    def predicts(self, fit: Fit) -> bool:
        """Whether the last cause helps to predict setups that take no part in the fit."""
        less = self.without(fit, len(fit.causes) - 1)
        if less is None:
            return True
        squares, leverage = left_out(fit, self.fitter.noise)
        tells = leverage < ALONE
        others = left_out(less, self.fitter.noise)[0]
        # What a cause saves by leaving the nuisances where they are declared counts as well.
        saved = float((less.white[self._rows :] ** 2).sum() - (fit.white[self._rows :] ** 2).sum())
        return tells.sum() < 2 or bool(squares[tells].sum() < others[tells].sum() + saved)

    # Steps -------------------------------------------------------------------------------------------------

    def _addition(self, fit: Fit, gate: Gate) -> Fit | None:
        """The best of all that can be added; None where nothing helps."""
        options = self._noise(fit)
        if not fit.causes:
            # With outliers and a shared error there is no room left: a cause instead, not beside them.
            options += self._causes(fit, gate.scores) if _additions(fit) < MOST_ADDITIONS else self._singles()
            improves = any(self.criterion(option) < self.criterion(fit) for option in options)
            options += [] if improves else self.alone()
        elif len(fit.causes) < MOST_CAUSES and not fit.causes[0].remote:
            remote = next((one for one in self.alone()[:BEST_FEW] if self.gate(one).passed), None)
            if remote is not None:
                return remote  # one cause, though nothing will be claimed, before two
            options += self._pairs() if self._hopeful(fit) else []
        best = min(options, key=self.criterion, default=fit)
        return best if self.criterion(best) < self.criterion(fit) else None

    def errors(self) -> list[Fit]:
        """Fits with errors of the measurement and no cause: one after another, as long as they help."""
        found: list[Fit] = []
        fit = self.fit(Hypothesis())
        while fit is not None:
            options = self._noise(fit)
            found += options
            best = min(options, key=self.criterion, default=fit)
            fit = best if self.criterion(best) < self.criterion(fit) else None
        return found

    def alone(self) -> list[Fit]:
        """Fits with one remote cause and nothing else, best first."""
        plain = self.fit(Hypothesis())
        if plain is None or not self.remote:
            return []
        return self._causes(plain, score(self.fitter, plain, self.remote))

    def _hopeful(self, fit: Fit) -> bool:
        """Whether a second cause may do: the first did much of the work, or little is left."""
        base = self.without(fit, 0)
        return base is None or fit.chi2 < MUCH * base.chi2 or fit.chi2 < LITTLE * self.degrees(fit)

    def _singles(self) -> list[Fit]:
        """One cause, and nothing else."""
        plain = self.fit(Hypothesis())
        return [] if plain is None else self._causes(plain, score(self.fitter, plain, self.candidates))

    def _pairs(self) -> list[Fit]:
        """Two causes: the pairs for which a linear model at the fit of one of them promises most.

        And the best cause with every absent one, of which a linear model says little.
        """
        promised: dict[Key, tuple[float, Fit, Score]] = {}
        absent: dict[Key, tuple[float, Fit, Score]] = {}
        singles = sorted(self._singles(), key=self.criterion)
        for single in singles:
            others = [candidate for candidate in self.candidates if candidate not in single.causes]
            for one in score(self.fitter, single, others).each:
                number = len(one.candidate.parameters)
                if one.visible and self.degrees(single) > number:
                    left = self.criterion(single) - one.gain + float(np.log(self._rows)) * number
                    key, promise = _key(single.hypothesis.adding(one.candidate)), (left, single, one)
                    if one.gain > 0.0:
                        promised[key] = min(promised.get(key, promise), promise, key=_first)
                    if single is singles[0] and one_sided(self.fitter, one.candidate):
                        absent[key] = promise
        best = {key: promised[key] for key in sorted(promised, key=lambda key: promised[key][0])[:PAIRS]}
        found = [self._refit(single, one) for _, single, one in {**absent, **best}.values()]
        return self._finished([pair for pair in found if pair is not None])

    def _noise(self, fit: Fit) -> list[Fit]:
        """A shared error in each setup, and the exclusion of the row that fits worst."""
        h, found = fit.hypothesis, []
        room = _additions(fit) < MOST_ADDITIONS and not any(cause.remote for cause in h.causes)
        if room and not h.scatter and self._setups >= 4 and self._rows >= 2 * self._setups:
            found.append(self.fit(replace(h, scatter=True), fit.values))
        if (room or h.excluded) and len(h.excluded) < max(1, self._rows // 30):
            rows = np.abs(fit.residual / self.fitter.sigma)
            for row in np.argsort(rows)[::-1][:3]:
                if rows[row] > 3.0:
                    found.append(self.fit(replace(h, excluded=h.excluded | {int(row)}), fit.values))
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
        return self._finished([option for option in found if option is not None])

    def _finished(self, fits: list[Fit]) -> list[Fit]:
        """Finish the rough ones among the best, until the best are all finished."""
        while fits:
            fits = sorted(fits, key=self.criterion)
            near = [fit for fit in fits if self.criterion(fit) <= self.criterion(fits[0]) + NEARLY]
            some = fits[: max(BEST_FEW, len(near))]
            rough = next((i for i, fit in enumerate(some) if _key(fit.hypothesis) in self._rough), None)
            if rough is None:
                break
            key = _key(fits[rough].hypothesis)
            self._rough.discard(key)
            self._fits[key] = self.fitter.fit(fits[rough].hypothesis, fits[rough].values) or fits[rough]
            fits[rough] = self.fit(fits[rough].hypothesis) or fits[rough]
        return fits

    def _refit(self, fit: Fit, one: Score) -> Fit | None:
        """Fit roughly with one cause more, from the best of several starts."""
        hypothesis = fit.hypothesis.adding(one.candidate)
        if _key(hypothesis) in self._fits:
            return self.fit(hypothesis)
        self._progress(f"refitting with {' and '.join(c.name for c in hypothesis.causes)}")
        key = _key(hypothesis)
        begun = starts(self.fitter, fit, one, hypothesis)
        fits = [self.fitter.fit(hypothesis, values, rough=True) for values in begun]
        best = min((f for f in fits if f is not None), key=lambda f: f.deviance, default=None)
        self._fits[key] = best
        if best is not None and not best.converged:
            self._rough.add(key)
        return self.fit(hypothesis)

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
            less = self.fit(hypothesis, self._without(fit, hypothesis))
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
        base = self.fit(hypothesis, self._without(fit, hypothesis))
        found = {causes[place].name: replace(fit, hypothesis=hypothesis.adding(causes[place]))}
        if base is not None:
            known = [*self.candidates]
            if len(causes) == 1:
                known += [cause for cause in self.remote if cause.nameable or causes[0].remote]
            others = [candidate for candidate in known if candidate not in hypothesis.causes]
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

    def fit(self, hypothesis: Hypothesis, start: Array | None = None) -> Fit | None:
        """Fit once, whatever the order of the causes; what began with a score again, from the first start given."""
        key = _key(hypothesis)
        if key not in self._fits:
            self._fits[key] = self.fitter.fit(hypothesis, start)
            self._begun.add(key)
        elif start is not None and key not in self._begun:
            self._begun.add(key)
            again, known = self.fitter.fit(hypothesis, start), self._fits[key]
            if again is not None and (known is None or again.deviance < known.deviance):
                self._fits[key] = again
                self._rough.discard(key)
        found = self._fits[key]
        return found if found is None else replace(found, hypothesis=hypothesis)


def _first(promise: tuple[float, Fit, Score]) -> float:
    return promise[0]


def _additions(fit: Fit) -> int:
    """Kinds of things that a fit assumes beyond the declared model."""
    return len(fit.causes) + bool(fit.hypothesis.excluded) + fit.hypothesis.scatter


def _key(hypothesis: Hypothesis) -> Key:
    return frozenset(c.name for c in hypothesis.causes), hypothesis.excluded, hypothesis.scatter
