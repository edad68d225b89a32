"""What is tried beyond the catalogue: each term alone, beside the uncertain values.

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
from pkmodes.loop.diagnosis.search.starts import SIZES, starts
from pkmodes.loop.diagnosis.verdict.all_setups import AllSetups
from pkmodes.loop.diagnosis.verdict.evidence import Evidence

#: Number of terms that are refitted, by their scores, by their starts and by large sizes.
BEST, STARTED, LARGE = 40, 20, 10
#: Number of starts of each term kept after comparing them at a few setups, and then at all.
FITTED, COMPARED = 6, 4
#: Number of setups at which starts are compared.
SCOUTED = 4
#: Largest relative change of a frequency for which a linear estimate suffices as a start.
SMALL = 0.05
#: Part of the gain of a linear estimate below which a fit from there went astray.
ASTRAY = 0.5
#: Largest number of measurement errors beside terms, one more in each round, and of terms that are tried with them.
ROUNDS, BESIDE = 3, 3
#: Number of explanations of the catalogue with which terms are compared.
CARRIED = 12
#: Times that the search is repeated with a smaller scatter of the shapes.
SHARPENED = 2


@dataclass(frozen=True, eq=False)
class Tried:
    """Fits with one term each, and the explanations of the catalogue that leave noise.

    - setups: of the structure with its terms
    - plain: without any cause, with the measurement errors of the fits
    - fits: with one term, best first
    - carried: of the catalogue, fitted again beside the terms
    """

    setups: AllSetups
    search: Search
    terms: tuple[Candidate, ...]
    plain: Fit
    fits: tuple[Fit, ...]
    carried: tuple[Fit, ...]

    @cached_property
    def directions(self) -> Directions:
        """Directions of everything that was tried: of terms, of these from their starts, and of the catalogue."""
        fitter, sized = self.search.store.fitter, [term for term in self.terms if not term.starts]
        of_terms = score(fitter, self.plain, sized).directions
        started = [term for term in self.terms if term.starts]
        of_catalogue = self.search.scores(self.plain).directions
        return (*of_terms, *_directions_of_starts(fitter, self.plain, started), *of_catalogue)


def _directions_of_starts(
    fitter: Fitter, plain: Fit, terms: Sequence[Candidate]
) -> Iterator[tuple[Array, int]]:
    """Yield the directions of terms that have their own starts: one, that of their size, at each start.

    At size 0 the other parameters have no effect, but they determine the effect of a small size: a resonator pushes
    the modes on both sides of its frequency apart.
    """
    for fixed_values in zip_longest(*(dict.fromkeys(start[1:] for start in term.starts) for term in terms)):
        present = [
            (term, fixed) for term, fixed in zip(terms, fixed_values, strict=True) if fixed is not None
        ]
        values = plain.values.copy()
        for term, fixed in present:
            values[list(fitter.indices(term))[1:]] = fixed
        by = [fitter.indices(term)[0] for term, _ in present]
        raw = np.nan_to_num(fitter.signatures(replace(plain, values=values), by)[1])
        remainder = raw - plain.basis @ (plain.basis.T @ raw)
        size = np.linalg.norm(remainder, axis=0)
        for k in np.flatnonzero(size > MIN_REMAINDER * np.linalg.norm(raw, axis=0)):
            yield remainder[:, [k]] / size[k], 1


def tried(
    structure: Structure, catalogue: Evidence, held: Sequence[int], progress: Progress | None
) -> Tried | None:
    """Try all terms of a structure; None if it has none, or cannot be evaluated.

    - structure: with its terms, at all measured setups
    - catalogue: what the catalogue found
    - held: held-out setups
    """
    terms = tuple(term for term in structure.candidates if term.form)
    setups, scatter = catalogue.setups, catalogue.fitter.shape_scatter
    result, c = None, catalogue.criteria
    for _ in range(1 + SHARPENED if terms else 0):
        fitter = fitter_of(structure, catalogue, held, scatter)
        all_setups = AllSetups(structure, setups.data, fitter, list(held))
        result = _Explorer(all_setups, terms, catalogue, progress, result).explored()
        scatters = [] if result is None else [result.search.store.shape_scatter(fit) for fit in result.fits]
        sharper = min((estimate for estimate in scatters if estimate is not None), default=scatter)
        sharper = max(sharper, c.shapes.least_scatter)
        if sharper >= c.shapes.sharper * scatter:
            break
        scatter = sharper
    return result


def fitter_of(structure: Structure, catalogue: Evidence, held: Sequence[int], scatter: float) -> Fitter:
    """Return the fitter of a structure with its terms at the setups that are not held out."""
    data = catalogue.setups.data
    fitted = [i for i in range(len(data.labels)) if i not in held]
    return Fitter(structure.subset(fitted), data.at(fitted), catalogue.criteria, scatter)


@dataclass(frozen=True)
class _Trial:
    """A term with its start values, and the kind of each if there are several."""

    hypothesis: Hypothesis
    values: Sequence[Array]
    kinds: Sequence[float] = ()

    def best(self, order: Sequence[int]) -> list[Array]:
        """Return the best values in an order: the first of each kind, then others."""
        kinds = self.kinds or [0.0] * len(self.values)
        firsts = list({kinds[k]: k for k in reversed(order)}.values())
        chosen = [*(k for k in order if k in firsts), *(k for k in order if k not in firsts)][:FITTED]
        return [self.values[k] for k in chosen]


def _ranked(
    fitter: Fitter, jobs: Sequence[tuple[Hypothesis, Sequence[Array]]]
) -> list[list[tuple[float, int]]]:
    """Return, for each hypothesis, the sums of squares of its starts with their indices, smallest first."""
    if not jobs:
        return []
    costs = iter(fitter.chi2_of_many([(h, values) for h, starts in jobs for values in starts]))
    return [sorted((next(costs), k) for k in range(len(starts))) for _, starts in jobs]


class _Explorer:
    """A search among terms, with one scatter of the shapes.

    - before: the result with a larger scatter: only the terms that it refitted are refitted, from their values there
    """

    def __init__(
        self,
        setups: AllSetups,
        terms: tuple[Candidate, ...],
        catalogue: Evidence,
        progress: Progress | None,
        before: Tried | None,
    ) -> None:
        self.before = before
        self.setups, self.terms, self.catalogue, self.fitter = setups, terms, catalogue, setups.fitter
        self.store, self.criteria = FitStore(setups.fitter), setups.fitter.criteria
        self.progress = progress or (lambda _: None)
        self.search = Search(self.store, setups.structure.candidates, progress)

    def explored(self) -> Tried | None:
        """Try all terms; None if the structure cannot be evaluated."""
        self.progress(f"scoring {len(self.terms)} terms, each one form at one place")
        errors, attempted = Hypothesis(), list[Hypothesis]()
        plain = self.store.fit(errors, self.fitter.padded(self.catalogue.outcome.nuisance_fit.values))
        if plain is None:
            return None
        fits = first = self._refitted(plain)
        for _ in range(ROUNDS):
            if any(self._explains(fit) for fit in fits[: self.criteria.search.best_few]):
                break
            attempted.append(errors)
            # The measurement errors beside which the best terms explain most.
            options = [option for fit in fits[:BESIDE] for option in self.search.additions.with_errors(fit)]
            best = min(options, key=self.store.criterion, default=None)
            extended, again = errors, None
            if best is not None and self.store.criterion(best) < self.store.criterion(fits[0]):
                extended = replace(best.hypothesis, causes=())
            if extended not in attempted:
                again = self.store.fit(extended, plain.values)
            if again is None:
                fits = first
                break
            errors, fits = extended, self._refitted(again)
        errors = replace(fits[0].hypothesis, causes=()) if fits else Hypothesis()
        beside = self.store.fit(errors) or plain
        return Tried(self.setups, self.search, self.terms, beside, tuple(fits), tuple(self._carried()))

    def _carried(self) -> list[Fit]:
        """Return the best explanations of the catalogue that leave noise, fitted again."""
        store, level = self.catalogue.store, self.criteria.gate.surely
        names = {candidate.name for candidate in self.search.candidates}
        explaining = [
            fit
            for fit in {id(fit): fit for fit in (self.catalogue.final, *store.tried())}.values()
            if fit.causes
            and all(cause.name in names for cause in fit.causes)
            and not fit.at_bound
            and store.p_value(fit) > level
        ]
        # Fits with the same causes may set different rows aside: the best of them is carried.
        by_causes = {fit.causes: fit for fit in sorted(explaining, key=store.criterion, reverse=True)}
        best = sorted(by_causes.values(), key=store.criterion)[:CARRIED]
        fits = [self.store.fit(fit.hypothesis, self.fitter.padded(fit.values)) for fit in best]
        return [fit for fit in fits if fit is not None]

    def _refitted(self, plain: Fit) -> list[Fit]:
        """Return fits with one term beside the measurement errors of a fit, best first."""
        if self.before is not None:
            again = [(plain.hypothesis.adding(fit.causes[0]), [fit.values]) for fit in self.before.fits]
            return self.store.finished(self.store.roughly(again))
        sized = [term for term in self.terms if not term.starts and self._testable(plain, term)]
        scores = score(self.fitter, plain, sized).by_candidate
        visible = [entry for entry in scores if entry.visible and entry.gain > 0.0]
        best = sorted(visible, key=lambda entry: -entry.gain)[:BEST]
        # The linear estimate suffices for small changes of modes that are all paired.
        paired = bool((plain.pairing.partner[self.fitter.used(plain.hypothesis)] >= 0).all())
        small = [
            entry for entry in best if paired and float(entry.largest_rates @ np.abs(entry.step)) <= SMALL
        ]
        near = {entry.candidate.name for entry in small}
        far = [entry for entry in best if entry.candidate.name not in near]
        self.progress(f"refitting with the {len(best)} most promising of {len(self.terms)} terms")
        fits = self.search.additions.refit([(plain, entry) for entry in far])
        jobs = [(plain.hypothesis.adding(entry.candidate), [self._moved(plain, entry)]) for entry in small]
        overlooked = [entry for entry in scores if entry not in best and entry.largest_rates[0] > 0.0]
        begun = [*self._started(plain), *self._large(plain, overlooked)]
        started = [
            (h, [values[k] for _, k in order[:COMPARED]])
            for (h, values), order in zip(begun, _ranked(self.fitter, begun), strict=True)
        ]
        rough = self.store.roughly([*jobs, *started])
        return self.store.finished([*fits, *self._again(plain, small, rough)])

    def _again(self, plain: Fit, small: Sequence[Score], rough: Sequence[Fit]) -> list[Fit]:
        """Return fits, restarting those that went astray: close modes may have been exchanged."""
        gains = {entry.candidate.name: entry for entry in small}
        astray = [
            (fit, gains[name])
            for fit in rough
            if (name := fit.causes[0].name) in gains
            and fit.deviance > plain.deviance - ASTRAY * gains[name].gain
        ]
        kept = [fit for fit in rough if all(fit is not restarted for restarted, _ in astray)]
        begun = starts(self.fitter, [(plain, entry, fit.hypothesis) for fit, entry in astray])
        again = [
            (fit.hypothesis, [*values, fit.values]) for (fit, _), values in zip(astray, begun, strict=True)
        ]
        return [*kept, *self.store.roughly(again)]

    def _moved(self, plain: Fit, entry: Score) -> Array:
        """Return the values of a fit with the linear estimate of a term."""
        return self._with(
            plain, entry.candidate, plain.values[list(self.fitter.indices(entry.candidate))] + entry.step
        )

    def _testable(self, plain: Fit, term: Candidate) -> bool:
        """Return whether data are left to test a term."""
        return self.store.degrees(plain) > len(term.parameters)

    def _started(self, plain: Fit) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms with their own starts, each with its best starts."""
        terms = [term for term in self.terms if term.starts and self._testable(plain, term)]
        trials = []
        for term in terms:
            # The kind of a start is its value of the parameter with the fewest distinct values: the mass.
            columns = list(zip(*term.starts, strict=True))
            kinds = min(columns, key=lambda column: len({*column})) if len(columns) > 1 else ()
            values = [self._with(plain, term, start) for start in term.starts]
            trials.append(_Trial(plain.hypothesis.adding(term), values, kinds))
        if trials:
            self.progress(f"starting {len(trials)} terms with a frequency of their own")
        return self._promising(trials)[:STARTED]

    def _large(self, plain: Fit, scores: Sequence[Score]) -> list[tuple[Hypothesis, list[Array]]]:
        """Return the most promising terms for which the linear model predicts little, with their best sizes."""
        trials = [
            _Trial(
                plain.hypothesis.adding(entry.candidate),
                [
                    self._with(plain, entry.candidate, [sign * size / entry.largest_rates[0]])
                    for size in SIZES
                ],
            )
            for entry in scores
            if (sign := allowed_sign(self.fitter, entry.candidate))
        ]
        return self._promising(trials)[:LARGE]

    def _with(self, plain: Fit, term: Candidate, term_values: Sequence[float] | Array) -> Array:
        """Return the values of a fit with those of a term, within its bounds."""
        values, index = plain.values.copy(), list(self.fitter.indices(term))
        values[index] = np.clip(term_values, self.fitter.lower[index], self.fitter.upper[index])
        return values

    def _promising(self, trials: Sequence[_Trial]) -> list[tuple[Hypothesis, list[Array]]]:
        """Return terms with the best of their values, the most promising first, judged at a few setups."""
        count = len(self.fitter.data.labels)
        few = [int((k + 0.5) * count / SCOUTED) for k in range(SCOUTED)] if count > SCOUTED else range(count)
        scout = self.fitter.at(list(few)) if trials else self.fitter
        # Excluded rows are dropped for fewer setups, where rows are numbered differently.
        ranked = _ranked(scout, [(Hypothesis(trial.hypothesis.causes), trial.values) for trial in trials])
        ordered = sorted(zip(ranked, trials, strict=True), key=lambda pair: pair[0][0][0])
        return [
            (trial.hypothesis, trial.best([k for _, k in order]))
            for order, trial in ordered
            if np.isfinite(order[0][0])
        ]

    def _explains(self, fit: Fit) -> bool:
        """Return whether a fit leaves noise."""
        level = self.criteria.gate.surely
        return not fit.at_bound and self.store.p_value(fit) > level and self.search.gate(fit).passes_at(level)
