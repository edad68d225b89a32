"""Causes whose fit was blocked because the model cannot be evaluated at the values that it approaches.

A fit avoids such values and stops near them, so a poor fit is then no evidence against the cause.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.core.base.numbers import plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.problem import Array

#: Largest number of bisections towards the first value that cannot be evaluated, which is reported to three digits.
HALVINGS = 20


def unevaluated(store: FitStore, reported: Fit) -> Iterator[str]:
    """Yield a sentence for each fit (single causes and the reported one) that was blocked by values without modes."""
    fitter, least = store.fitter, store.criterion(reported)
    reported_texts = set[str]()
    for fit in _tried(store, reported):
        _, promised = _onward(fitter, fit)
        # Only if the linear model promises a fit about as good as the reported one.
        if promised <= fitter.criteria.search.survives or store.criterion(fit) - promised > least:
            continue
        text = _stopped(fitter, fit)
        if text and text not in reported_texts:
            reported_texts.add(text)
            yield text


def _tried(store: FitStore, reported: Fit) -> Iterator[Fit]:
    """Yield the reported fit and those of single causes; a cause without a fit is fitted from the plain fit."""
    fitter = store.fitter
    yield reported
    for candidate in fitter.structure.candidates:
        hypothesis = Hypothesis((candidate,))
        if not store.is_fitted(hypothesis) or hypothesis == reported.hypothesis:
            continue
        fit = store.fit(hypothesis)
        if fit is None and (plain := store.fit(Hypothesis())) is not None:
            fit = fitter.rough_fit(hypothesis, fitter.rough_descents([(hypothesis, plain.values)])[0])
        if fit is not None:
            yield fit


def _onward(fitter: Fitter, fit: Fit) -> tuple[Array, float]:
    """Return the step of the linear model within the bounds, and the decrease of the sum of squares that it predicts.

    The decrease is zero if the fit has converged.
    """
    free, lower, upper = np.array(fit.free, dtype=np.intp), fitter.lower, fitter.upper
    at, gradient = fit.values[free], fit.jacobian.T @ fit.white
    held = ((at <= lower[free]) & (gradient > 0.0)) | ((at >= upper[free]) & (gradient < 0.0))
    columns = fit.jacobian[:, ~held]
    size = np.linalg.norm(columns, axis=0)
    scale = 1.0 / np.where(size > 0.0, size, 1.0)
    scaled = np.linalg.lstsq(columns * scale, -fit.white, rcond=1e-9)[0]
    residual = fit.white + columns * scale @ scaled
    step = np.zeros_like(fit.values)
    step[free[~held]] = scale * scaled
    return step, float(fit.white @ fit.white - residual @ residual)


def _stopped(fitter: Fitter, fit: Fit) -> str:
    """Return where a fit was blocked; empty if it was not."""
    step, _ = _onward(fitter, fit)

    def at(part: float) -> Array:
        return np.clip(fit.values + part * step, fitter.lower, fitter.upper)

    if _evaluable(fitter, at(1.0)):
        return ""
    good, bad = 0.0, 1.0
    for _ in range(HALVINGS):
        if all(
            f"{passing:.3g}" == f"{failing:.3g}" for passing, failing in zip(at(good), at(bad), strict=True)
        ):
            break
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if _evaluable(fitter, at(middle)) else (good, middle)
    # The fit may converge before that: a long step of a linear model is inaccurate.
    there = fitter.rough_fit(fit.hypothesis, fitter.rough_descents([(fit.hypothesis, at(good))])[0])
    if there is None or _onward(fitter, there)[1] <= fitter.criteria.search.survives:
        return ""
    before, after = at(good), at(bad)
    decisive = [
        i for i in fit.free if not _evaluable(fitter, np.where(np.arange(len(after)) == i, after, before))
    ]
    where = []
    for i in decisive or fit.free:
        p = fitter.parameters[i]
        unit = "" if p.unit == "1" else f" {p.unit}"
        where.append((p.name, f"{'below' if after[i] < before[i] else 'above'} {plain(before[i], 3)}{unit}"))
    subject = " + ".join(cause.name for cause in fit.causes) or "the fit"
    if [name for name, _ in where] == [subject]:
        followed = where[0][1]
    else:
        followed = "to " + " and ".join(f"{name} {text}" for name, text in where)
    return f"{subject} could not be followed {followed}: the model cannot be evaluated there"


def _evaluable(fitter: Fitter, values: Array) -> bool:
    return bool(np.isfinite(fitter.structure.predict(values, ()).eigenvalues).all())
