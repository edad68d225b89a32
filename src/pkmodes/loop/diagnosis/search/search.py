"""The search for causes: gate, refit of every plausible candidate, acceptance, and the gate again.

Each step makes the addition that lowers the criterion most: a cause, an error that all modes of a setup share, or the
exclusion of an outlier, so that no cause gets credit for what a bad measurement explains.  When the gate passes,
additions that are not needed are removed again, and every cause is compared with all others in its place.

There are many hundred pairs of causes; with measurement errors added, they would explain anything.  A pair is
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

    - nuisance_fit: the declared model with its nuisances refitted
    - first_gate: gate at that fit
    - last_gate: gate at the final fit
    """

    nuisance_fit: Fit
    first_gate: Gate
    final_fit: Fit
    last_gate: Gate


class Search:
    """A search for causes that explain one set of measurements.

    - progress: called with a sentence at each step
    """

    def __init__(
        self, store: FitStore, candidates: Sequence[Candidate], progress: Progress | None = None
    ) -> None:
        self.store, self.criteria = store, store.fitter.criteria
        self.candidates = tuple(candidate for candidate in candidates if candidate.claimable)
        self.general_candidates = tuple(candidate for candidate in candidates if candidate.general_of)
        self.remote_candidates = tuple(
            candidate for candidate in candidates if candidate.remote and not candidate.general_of
        )
        self._progress = progress or (lambda _: None)
        self.additions = Additions(store, self.candidates, self._progress)
        self._gates: dict[int, tuple[Fit, Gate]] = {}

    def run(self) -> Outcome | None:
        """Search; return None if the declared model cannot be evaluated."""
        self._progress("refitting the uncertain values")
        nuisance_fit = self.store.fit(Hypothesis())
        if nuisance_fit is None:
            return None
        first_gate = self.gate(nuisance_fit)
        final_fit, last_gate = nuisance_fit, first_gate
        while not last_gate.passed:
            addition = self._best_addition(final_fit, last_gate)
            if addition is None:
                break
            final_fit = self._exchange_causes(addition) if addition.causes != final_fit.causes else addition
            last_gate = self.gate(final_fit)
        if last_gate.passed:
            final_fit = self._remove_unneeded(final_fit)
            last_gate = self.gate(final_fit)
        return Outcome(nuisance_fit, first_gate, final_fit, last_gate)

    def gate(self, fit: Fit) -> Gate:
        """Test the residual of a fit."""
        result = self._known_gate(fit)
        if result is None:
            result = gate(self.store, fit, self.scores(fit))
            self._gates[id(fit.values)] = fit, result
        return result

    def scores(self, fit: Fit) -> Scores:
        """Return the scores at a fit of all candidates that it does not have, from its gate if it was tested."""
        gate_of_fit = self._known_gate(fit)
        if gate_of_fit is not None:
            return gate_of_fit.scores
        return score(
            self.store.fitter,
            fit,
            [candidate for candidate in self.candidates if candidate not in fit.causes],
        )

    def _known_gate(self, fit: Fit) -> Gate | None:
        """Return the gate of a fit with these values; None if it was not tested."""
        known_gate = self._gates.get(id(fit.values))
        return known_gate[1] if known_gate is not None and known_gate[0].values is fit.values else None

    def single_remote_causes(self) -> list[Fit]:
        """Return fits with one remote cause and nothing else, best first."""
        declared_fit = self.store.fit(Hypothesis())
        if declared_fit is None or not self.remote_candidates:
            return []
        return self.additions.with_another_cause(
            declared_fit, score(self.store.fitter, declared_fit, self.remote_candidates)
        )

    def better_remote_causes(self, fit: Fit) -> list[Fit]:
        """Return fits with one remote cause that explain significantly more than a fit, down to noise; best first."""
        limit = self.store.criterion(fit) - self.criteria.search.survives
        return [
            option
            for option in self.single_remote_causes()
            if self.store.criterion(option) < limit and self.gate(option).passed
        ]

    def single_joint_causes(self, claimed_fit: Fit) -> list[Fit]:
        """Return fits with the cause of a fit in one of its joints alone, best first."""
        name = claimed_fit.causes[0].name
        joints = {
            p for general in self.general_candidates if general.general_of == name for p in general.parameters
        }
        remote = [
            candidate for candidate in self.remote_candidates if joints.issuperset(candidate.parameters)
        ]
        base = self.store.fit(replace(claimed_fit.hypothesis, causes=()))
        if base is None or not remote:
            return []
        return self.additions.with_another_cause(base, score(self.store.fitter, base, remote))

    def rivals(self, fit: Fit, position: int) -> tuple[Fit, ...]:
        """Return fits with other causes in one place, best first; that cause is the last one in all of them."""
        causes, store = fit.causes, self.store
        hypothesis = fit.hypothesis.without(position)
        base = store.fit(hypothesis, store.values_without(fit, hypothesis))
        rivals = {causes[position].name: replace(fit, hypothesis=hypothesis.with_cause(causes[position]))}
        if base is not None:
            candidates = [*self.candidates]
            if len(causes) == 1:
                candidates += [
                    cause for cause in self.remote_candidates if cause.nameable or causes[0].remote
                ]
            alternatives = [candidate for candidate in candidates if candidate not in hypothesis.causes]
            for option in self.additions.with_another_cause(base, score(store.fitter, base, alternatives)):
                rivals.setdefault(option.causes[-1].name, option)
        return tuple(sorted(rivals.values(), key=store.criterion))

    # Steps -------------------------------------------------------------------------------------------------

    def _best_addition(self, fit: Fit, last_gate: Gate) -> Fit | None:
        """Return the fit with the best addition; None if nothing helps."""
        additions, criterion = self.additions, self.store.criterion
        options = additions.with_errors(fit)
        if not fit.causes:
            # Outliers and a shared error use up the allowed additions: a cause is tried in their place.
            options += (
                additions.with_another_cause(fit, last_gate.scores)
                if additions.allows_another_kind(fit)
                else additions.single_causes()
            )
            improves = any(criterion(option) < criterion(fit) for option in options)
            options += [] if improves else self.single_remote_causes()
            if all(self.store.p_value(option) <= self.criteria.gate.surely for option in options):
                without_outliers = additions.without_distant_rows(fit)
                if without_outliers:
                    return min(without_outliers, key=criterion)
        elif (refit := self._fit_again(fit, options)) is not None:
            return refit  # no addition is needed
        elif len(fit.causes) < self.criteria.search.most_causes and not fit.causes[0].remote:
            best_few = self.single_remote_causes()[: self.criteria.search.best_few]
            preferred = next((remote_fit for remote_fit in best_few if self.gate(remote_fit).passed), None)
            if preferred is not None:
                return preferred  # one cause, although it will not be claimed, is preferred to two
            options += additions.pairs() if self._may_need_second_cause(fit) else []
        best = min(options, key=criterion, default=fit)
        return best if criterion(best) < criterion(fit) else None

    def _fit_again(self, fit: Fit, options: Sequence[Fit]) -> Fit | None:
        """Refit the same hypothesis from fits with measurement errors; None if it is not better and down to noise.

        A cause that adds modes may be in a local minimum, with some modes paired wrongly.  These look like outliers
        or a shared error, and a fit that allows for those leads out of the minimum.
        """
        store, c = self.store, self.criteria
        starts = [option.values for option in options if store.criterion(option) < store.criterion(fit)]
        # Also from fits without the worst rows, for several numbers of rows.
        rows, h = store.fitter.rows_by_residual(fit)[0].tolist(), fit.hypothesis
        counts = [count for count in (1, 2, 4, 8) if count <= int(c.search.misled * len(rows))]
        reduced_hypotheses = [
            replace(h, excluded_rows=h.excluded_rows | set(rows[:count])) for count in counts
        ]
        starts += [
            rough_fit.values
            for rough_fit in store.fitter.rough_descents(
                [(hypothesis, fit.values) for hypothesis in reduced_hypotheses]
            )
        ]
        fits = [store.refit(h, values) for values in starts]
        best = min((f for f in fits if f is not None), key=lambda f: f.deviance, default=fit)
        is_better = best.deviance < fit.deviance - c.search.worth and store.p_value(best) > c.gate.surely
        return best if is_better else None

    def _may_need_second_cause(self, fit: Fit) -> bool:
        """Return whether a second cause may suffice: the first explains much, or little is left."""
        without_cause, c = self.store.fit_without(fit, 0), self.criteria
        return (
            without_cause is None
            or fit.chi2 < c.search.much * without_cause.chi2
            or fit.chi2 < c.search.little * self.store.degrees(fit)
        )

    def _exchange_causes(self, fit: Fit) -> Fit:
        """Exchange one of several causes for another while that lowers the criterion."""
        is_near_noise = fit.chi2 < self.criteria.search.little * self.store.degrees(fit)
        for _ in range(self.criteria.search.most_causes if len(fit.causes) > 1 and is_near_noise else 0):
            best = fit
            for position in range(len(fit.causes)):
                best = min([best, *self.rivals(fit, position)], key=self.store.criterion)
            if best is fit:
                break
            fit = best
        return fit

    def _remove_unneeded(self, fit: Fit) -> Fit:
        """Remove additions that are not needed to pass the gate."""
        h, store = fit.hypothesis, self.store
        reduced_hypotheses = [
            replace(h, excluded_rows=h.excluded_rows - {row}) for row in sorted(h.excluded_rows)
        ]
        reduced_hypotheses += [replace(h, has_shared_error=False)] if h.has_shared_error else []
        reduced_hypotheses += [h.without(position) for position in range(len(h.causes))]
        for hypothesis in reduced_hypotheses:
            reduced_fit = store.fit(hypothesis, store.values_without(fit, hypothesis))
            if (
                reduced_fit is not None
                and store.criterion(reduced_fit) < store.criterion(fit) + self.criteria.search.worth
                and self.gate(reduced_fit).passed
            ):
                return self._remove_unneeded(reduced_fit)
        return fit
