"""The search for causes: gate, refit of every plausible candidate, acceptance, and the gate again.

Each step makes the addition that lowers the criterion most: a cause, an error that all modes of a setup share, or the
exclusion of an outlier, so that no cause gets credit for what a bad measurement explains.  When the gate passes,
additions that are not needed are removed again, and every cause is compared with all others in its place.

There are many hundred pairs of causes; with measurement errors beside them they would explain anything.  A pair is
sought only if one cause clearly leaves a residual and no single remote cause explains everything, and never together
with outliers or shared errors.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Candidate
from pkmodes.loop.diagnosis.search.additions import Additions, Progress
from pkmodes.loop.diagnosis.search.gate import Gate, gate
from pkmodes.loop.diagnosis.search.score import Scores, score


@dataclass(frozen=True)
class Outcome:
    """The result of a search.

    - nuisances: the declared model with its nuisances refitted
    - first: gate at that fit
    - last: gate at the final fit
    """

    nuisances: Fit
    first: Gate
    final: Fit
    last: Gate


class Search:
    """A search for causes that explain one set of measurements.

    - progress: called with a sentence at each step
    """

    def __init__(
        self, store: FitStore, candidates: Sequence[Candidate], progress: Progress | None = None
    ) -> None:
        self.store, self.criteria = store, store.fitter.criteria
        self.candidates = tuple(candidate for candidate in candidates if candidate.claimable)
        self.general = tuple(candidate for candidate in candidates if candidate.general_of)
        self.remote = tuple(
            candidate for candidate in candidates if candidate.remote and not candidate.general_of
        )
        self._progress = progress or (lambda _: None)
        self.additions = Additions(store, self.candidates, self._progress)
        self._gates: dict[int, tuple[Fit, Gate]] = {}

    def run(self) -> Outcome | None:
        """Search; return None if the declared model cannot be evaluated."""
        self._progress("refitting the uncertain values")
        first = self.store.fit(Hypothesis())
        if first is None:
            return None
        before = self.gate(first)
        final, last = first, before
        while not last.passed:
            addition = self._addition(final, last)
            if addition is None:
                break
            final = self._settled(addition) if addition.causes != final.causes else addition
            last = self.gate(final)
        if last.passed:
            final = self._needed(final)
            last = self.gate(final)
        return Outcome(first, before, final, last)

    def gate(self, fit: Fit) -> Gate:
        """Test the residual of a fit."""
        tested = self._tested(fit)
        if tested is None:
            tested = gate(self.store, fit, self.scores(fit))
            self._gates[id(fit.values)] = fit, tested
        return tested

    def scores(self, fit: Fit) -> Scores:
        """Return the scores at a fit of all candidates that it does not have, from its gate if it was tested."""
        tested = self._tested(fit)
        if tested is not None:
            return tested.scores
        return score(
            self.store.fitter,
            fit,
            [candidate for candidate in self.candidates if candidate not in fit.causes],
        )

    def _tested(self, fit: Fit) -> Gate | None:
        """Return the gate of a fit with these values; None if it was not tested."""
        tested = self._gates.get(id(fit.values))
        return tested[1] if tested is not None and tested[0].values is fit.values else None

    def alone(self) -> list[Fit]:
        """Return fits with one remote cause and nothing else, best first."""
        plain = self.store.fit(Hypothesis())
        if plain is None or not self.remote:
            return []
        return self.additions.causes(plain, score(self.store.fitter, plain, self.remote))

    def better_alone(self, fit: Fit) -> list[Fit]:
        """Return fits with one remote cause that explain significantly more than a fit, down to noise; best first."""
        limit = self.store.criterion(fit) - self.criteria.search.survives
        return [
            option
            for option in self.alone()
            if self.store.criterion(option) < limit and self.gate(option).passed
        ]

    def in_one_joint(self, beside: Fit) -> list[Fit]:
        """Return fits with the cause of a fit in one of its joints alone, best first."""
        name = beside.causes[0].name
        joints = {p for general in self.general if general.general_of == name for p in general.parameters}
        remote = [candidate for candidate in self.remote if joints.issuperset(candidate.parameters)]
        plain = self.store.fit(replace(beside.hypothesis, causes=()))
        if plain is None or not remote:
            return []
        return self.additions.causes(plain, score(self.store.fitter, plain, remote))

    def rivals(self, fit: Fit, place: int) -> tuple[Fit, ...]:
        """Return fits with other causes in one place, best first; that cause is the last one in all of them."""
        causes, store = fit.causes, self.store
        hypothesis = fit.hypothesis.without(place)
        base = store.fit(hypothesis, store.values_without(fit, hypothesis))
        rivals = {causes[place].name: replace(fit, hypothesis=hypothesis.with_cause(causes[place]))}
        if base is not None:
            candidates = [*self.candidates]
            if len(causes) == 1:
                candidates += [cause for cause in self.remote if cause.nameable or causes[0].remote]
            alternatives = [candidate for candidate in candidates if candidate not in hypothesis.causes]
            for option in self.additions.causes(base, score(store.fitter, base, alternatives)):
                rivals.setdefault(option.causes[-1].name, option)
        return tuple(sorted(rivals.values(), key=store.criterion))

    # Steps -------------------------------------------------------------------------------------------------

    def _addition(self, fit: Fit, at: Gate) -> Fit | None:
        """Return the fit with the best addition; None if nothing helps."""
        additions, criterion = self.additions, self.store.criterion
        options = additions.noise(fit)
        if not fit.causes:
            # Outliers and a shared error use up the allowed additions: a cause is tried in their place.
            options += additions.causes(fit, at.scores) if additions.room(fit) else additions.singles()
            improves = any(criterion(option) < criterion(fit) for option in options)
            options += [] if improves else self.alone()
            if all(self.store.p_value(option) <= self.criteria.gate.surely for option in options):
                without = additions.without_distant_rows(fit)
                if without:
                    return min(without, key=criterion)
        elif (again := self._again(fit, options)) is not None:
            return again  # no addition is needed
        elif len(fit.causes) < self.criteria.search.most_causes and not fit.causes[0].remote:
            best_few = self.alone()[: self.criteria.search.best_few]
            remote = next((single for single in best_few if self.gate(single).passed), None)
            if remote is not None:
                return remote  # one cause, although it will not be claimed, is preferred to two
            options += additions.pairs() if self._hopeful(fit) else []
        best = min(options, key=criterion, default=fit)
        return best if criterion(best) < criterion(fit) else None

    def _again(self, fit: Fit, options: Sequence[Fit]) -> Fit | None:
        """Refit the same hypothesis from fits with measurement errors; None if it is not better and down to noise.

        A cause that adds modes may be in a local minimum, with some modes paired wrongly.  These look like outliers
        or a shared error, and a fit that allows for those leads out of the minimum.
        """
        store, c = self.store, self.criteria
        starts = [option.values for option in options if store.criterion(option) < store.criterion(fit)]
        # Also from fits without the worst rows, for several numbers of rows.
        rows, h = store.fitter.worst_rows(fit)[0].tolist(), fit.hypothesis
        counts = [count for count in (1, 2, 4, 8) if count <= int(c.search.misled * len(rows))]
        fewer = [replace(h, excluded=h.excluded | set(rows[:count])) for count in counts]
        starts += [
            rough.values for rough in store.fitter.rough_descents([(less, fit.values) for less in fewer])
        ]
        fits = [store.refit(h, values) for values in starts]
        best = min((f for f in fits if f is not None), key=lambda f: f.deviance, default=fit)
        better = best.deviance < fit.deviance - c.search.worth and store.p_value(best) > c.gate.surely
        return best if better else None

    def _hopeful(self, fit: Fit) -> bool:
        """Return whether a second cause may suffice: the first explains much, or little is left."""
        base, c = self.store.fit_without(fit, 0), self.criteria
        return (
            base is None
            or fit.chi2 < c.search.much * base.chi2
            or fit.chi2 < c.search.little * self.store.degrees(fit)
        )

    def _settled(self, fit: Fit) -> Fit:
        """Exchange one of several causes for another while that lowers the criterion."""
        near = fit.chi2 < self.criteria.search.little * self.store.degrees(fit)
        for _ in range(self.criteria.search.most_causes if len(fit.causes) > 1 and near else 0):
            best = fit
            for place in range(len(fit.causes)):
                best = min([best, *self.rivals(fit, place)], key=self.store.criterion)
            if best is fit:
                break
            fit = best
        return fit

    def _needed(self, fit: Fit) -> Fit:
        """Remove additions that are not needed to pass the gate."""
        h, store = fit.hypothesis, self.store
        smaller = [replace(h, excluded=h.excluded - {row}) for row in sorted(h.excluded)]
        smaller += [replace(h, scatter=False)] if h.scatter else []
        smaller += [h.without(place) for place in range(len(h.causes))]
        for hypothesis in smaller:
            less = store.fit(hypothesis, store.values_without(fit, hypothesis))
            if (
                less is not None
                and store.criterion(less) < store.criterion(fit) + self.criteria.search.worth
                and self.gate(less).passed
            ):
                return self._needed(less)
        return fit
