"""Fits that were made, each once, and what is asked of a fit: how good it is, and how it does without a cause."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from scipy import stats

from pkmodes.diagnosis.fit.cross_validation import left_out
from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.problem import Array, Candidate

Key = tuple[frozenset[str], frozenset[int], bool]


def key(hypothesis: Hypothesis) -> Key:
    """What a hypothesis is, whatever the order of its causes."""
    return frozenset(c.name for c in hypothesis.causes), hypothesis.excluded, hypothesis.scatter


class FitStore:
    """Fits of hypotheses about one structure and one set of measurements.

    Parameters
    ----------
    fitter : Fitter
    before : FitStore, optional
        Fits of the same data with other errors: where the same fits begin.
    """

    def __init__(self, fitter: Fitter, before: FitStore | None = None) -> None:
        self.fitter = fitter
        self._seeds = {} if before is None else before._values()
        self._rows = len(fitter.log)
        self._data = self._rows + int(fitter.shapes.count.sum())
        self._fits: dict[Key, Fit | None] = {}
        self._rough: set[Key] = set()
        self._begun: set[Key] = set()

    # Fits ------------------------------------------------------------------------------------------------------

    def fit(self, hypothesis: Hypothesis, start: Array | None = None) -> Fit | None:
        """Fit once, whatever the order of the causes; what began with a score again, from the first start given."""
        k = key(hypothesis)
        if k not in self._fits:
            self._fits[k] = self.fitter.fit(hypothesis, self.seed(hypothesis) if start is None else start)
            self._begun.add(k)
        elif start is not None and k not in self._begun:
            self._begun.add(k)
            again, known = self.fitter.fit(hypothesis, start), self._fits[k]
            if again is not None and (known is None or again.deviance < known.deviance):
                self._fits[k] = again
                self._rough.discard(k)
        found = self._fits[k]
        return found if found is None else replace(found, hypothesis=hypothesis)

    def again(self, hypothesis: Hypothesis, start: Array) -> Fit | None:
        """Fit again from somewhere else, whatever was tried before; the better one is kept."""
        k = key(hypothesis)
        found, known = self.fitter.fit(hypothesis, start), self._fits.get(k)
        if found is not None and (known is None or found.deviance < known.deviance):
            self._fits[k] = found
            self._rough.discard(k)
        return self.fit(hypothesis)

    def known(self, hypothesis: Hypothesis) -> bool:
        """Whether it was fitted already."""
        return key(hypothesis) in self._fits

    def roughly(self, jobs: Sequence[tuple[Hypothesis, Sequence[Array]]]) -> list[Fit]:
        """Fit several hypotheses roughly, each from the best of several starts; without those that cannot be."""
        starts = [(hypothesis, values) for hypothesis, some in jobs for values in some]
        reached, found = iter(self.fitter.roughly(starts)), []
        for hypothesis, some in jobs:
            best, k = min((next(reached) for _ in some), key=lambda descent: descent.chi2), key(hypothesis)
            if hypothesis.scatter or self.fitter.noise.uncertain:  # correlated errors: this is just a start
                self._fits[k] = self.fitter.fit(hypothesis, best.values)
            else:
                self._fits[k] = self.fitter.rough_fit(hypothesis, best)
                self._rough.add(k)
            found.append(self.fit(hypothesis))
        return [fit for fit in found if fit is not None]

    def finished(self, fits: list[Fit]) -> list[Fit]:
        """Finish the rough ones among the best, until the best are all finished; best first."""
        c = self.fitter.criteria
        while fits:
            fits = sorted(fits, key=self.criterion)
            best = self.criterion(fits[0])
            # What has arrived is worth the last digits where it may survive, or look like what does.
            near = {True: best + c.survives + c.told_apart, False: best + c.nearly}
            rough = next(
                (
                    i
                    for i, fit in enumerate(fits)
                    if key(fit.hypothesis) in self._rough
                    and (i < c.best_few or self.criterion(fit) <= near[fit.converged])
                ),
                None,
            )
            if rough is None:
                break
            k = key(fits[rough].hypothesis)
            self._rough.discard(k)
            self._fits[k] = self.fitter.fit(fits[rough].hypothesis, fits[rough].values) or fits[rough]
            fits[rough] = self.fit(fits[rough].hypothesis) or fits[rough]
        return fits

    def seed(self, hypothesis: Hypothesis) -> Array | None:
        """Where the fit of a hypothesis ended with other errors."""
        return self._seeds.get(key(hypothesis))

    def _values(self) -> dict[Key, Array]:
        return {k: fit.values for k, fit in self._fits.items() if fit is not None}

    def tried(self) -> tuple[Fit, ...]:
        """Every fit so far."""
        return tuple(fit for fit in self._fits.values() if fit is not None)

    def without(self, fit: Fit, place: int) -> Fit | None:
        """Return the fit with one of its causes taken away."""
        causes = fit.causes
        less = replace(fit.hypothesis, causes=(*causes[:place], *causes[place + 1 :]))
        return self.fit(less, self.undone(fit, less))

    def undone(self, fit: Fit, hypothesis: Hypothesis) -> Array:
        """Values of a fit, with those causes undone that a hypothesis has not."""
        values = fit.values.copy()
        for cause in fit.causes:
            if cause not in hypothesis.causes:
                index = list(self.fitter.indices(cause))
                values[index] = self.fitter.declared[index]
        return values

    # How good they are -----------------------------------------------------------------------------------------

    def degrees(self, fit: Fit) -> int:
        """Degrees of freedom: data less parameters without prior, excluded rows and the shared error."""
        h, fitter = fit.hypothesis, self.fitter
        rows = self._rows - len(h.excluded) + fitter.shapes.degrees(fitter.used(h))
        return rows - sum(fitter.priors.of(i) is None for i in self._added(fit)) - int(h.scatter)

    def p_value(self, fit: Fit) -> float:
        """Probability of sums of squares as large, of frequencies with priors and of shapes with stated errors."""
        shapes, degrees = self.fitter.shape_misfit(fit, stated=True)
        of_shapes = float(stats.chi2.sf(shapes, max(degrees, 1.0))) if degrees > 0.0 else 1.0
        return min(self.frequency_p_value(fit), of_shapes)

    def frequency_p_value(self, fit: Fit) -> float:
        """Of the frequencies and priors alone."""
        squares, degrees = self.frequency_misfit(fit)
        return float(stats.chi2.sf(squares, max(degrees, 1.0)))

    def frequency_misfit(self, fit: Fit) -> tuple[float, float]:
        """Sum of squares of the frequencies and priors, and its degrees of freedom."""
        fitter, h = self.fitter, fit.hypothesis
        if not fitter.shapes.size:
            return fit.chi2, float(self.degrees(fit))
        priors = [row for i in fit.free if (row := fitter.priors.of(i)) is not None]
        parts = [fit.leverage[fitter.frequency_rows], fit.leverage[fitter.prior_rows][priors]]
        white = [fit.white[fitter.frequency_rows], fit.white[fitter.prior_rows]]
        taken = sum(float(part.sum()) for part in parts)
        count = self._rows - len(h.excluded) + len(priors) - int(h.scatter)
        return sum(float(part @ part) for part in white), count - taken

    def criterion(self, fit: Fit) -> float:
        """Evidence against a fit: deviance and what each addition costs; smaller is better.

        A parameter costs the logarithm of the number of data (Schwarz's BIC); one with a prior costs what the data
        narrow it by, 2 ln(prior sigma / sigma), which is Laplace's approximation of its evidence.  Excluded rows
        have a price of their own.
        """
        h, fitter = fit.hypothesis, self.fitter
        price, each = 0.0, float(np.log(self._data))
        for i in self._added(fit):
            row = fitter.priors.of(i)
            if row is None:
                price += each
            else:
                k = fit.free.index(i)
                width = fitter.priors.width(fit.values)[row]
                price += max(float(np.log(width**2 / max(fit.covariance[k, k], 1e-300))), 0.0)
        count = int(h.scatter) + fitter.criteria.price_of_row * len(h.excluded)
        return fit.deviance + price + each * count

    def price(self, candidate: Candidate) -> float:
        """What a candidate costs at the most: the criterion's price of its parameters without prior."""
        free = [i for i in self.fitter.indices(candidate) if self.fitter.priors.of(i) is None]
        return float(np.log(self._data)) * len(free)

    def predicts(self, fit: Fit) -> bool:
        """Whether the last cause helps to predict setups that take no part in the fit."""
        less = self.without(fit, len(fit.causes) - 1)
        if less is None:
            return True
        places, priors = self.fitter.places(), self.fitter.prior_rows
        squares, leverage = left_out(fit, places)
        tells = leverage < self.fitter.criteria.alone
        others = left_out(less, places)[0]
        # What a cause saves by leaving the nuisances where they are declared counts as well.
        saved = float((less.white[priors] ** 2).sum() - (fit.white[priors] ** 2).sum())
        return tells.sum() < 2 or bool(squares[tells].sum() < others[tells].sum() + saved)

    def shape_scatter(self, fit: Fit) -> float | None:
        """Scatter of the shapes without stated errors that a fit leaves; None where there are none to tell."""
        squares, degrees = self.fitter.shape_misfit(fit, stated=False)
        if degrees < 1.0:
            return None
        return float(np.sqrt(squares / degrees)) * self.fitter.shape_scatter

    def _added(self, fit: Fit) -> list[int]:
        return [i for cause in fit.causes for i in self.fitter.indices(cause)]
