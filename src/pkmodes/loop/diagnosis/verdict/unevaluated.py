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
    fitter, lowest_criterion = store.fitter, store.criterion(reported)
    reported_texts = set[str]()
    for fit in _fits_to_examine(store, reported):
        _, expected_gain = _linear_step(fitter, fit)
        # Only if the linear model promises a fit about as good as the reported one.
        if (
            expected_gain <= fitter.criteria.search.survives
            or store.criterion(fit) - expected_gain > lowest_criterion
        ):
            continue
        text = _blocked_in_words(fitter, fit)
        if text and text not in reported_texts:
            reported_texts.add(text)
            yield text


def _fits_to_examine(store: FitStore, reported: Fit) -> Iterator[Fit]:
    """Yield the reported fit and those of single causes; a cause without a fit is fitted from that without causes."""
    fitter = store.fitter
    yield reported
    for candidate in fitter.structure.candidates:
        hypothesis = Hypothesis((candidate,))
        if not store.is_fitted(hypothesis) or hypothesis == reported.hypothesis:
            continue
        fit = store.fit(hypothesis)
        if fit is None and (base := store.fit(Hypothesis())) is not None:
            fit = fitter.rough_fit(hypothesis, fitter.rough_descents([(hypothesis, base.values)])[0])
        if fit is not None:
            yield fit


def _linear_step(fitter: Fitter, fit: Fit) -> tuple[Array, float]:
    """Return the step of the linear model within the bounds, and the decrease of the sum of squares that it predicts.

    The decrease is zero if the fit has converged.
    """
    free, lower, upper = np.array(fit.free, dtype=np.intp), fitter.lower, fitter.upper
    current_values, gradient = fit.values[free], fit.jacobian.T @ fit.white
    is_at_active_bound = ((current_values <= lower[free]) & (gradient > 0.0)) | (
        (current_values >= upper[free]) & (gradient < 0.0)
    )
    columns = fit.jacobian[:, ~is_at_active_bound]
    norms = np.linalg.norm(columns, axis=0)
    scale = 1.0 / np.where(norms > 0.0, norms, 1.0)
    scaled = np.linalg.lstsq(columns * scale, -fit.white, rcond=1e-9)[0]
    residual = fit.white + columns * scale @ scaled
    step = np.zeros_like(fit.values)
    step[free[~is_at_active_bound]] = scale * scaled
    return step, float(fit.white @ fit.white - residual @ residual)


def _blocked_in_words(fitter: Fitter, fit: Fit) -> str:
    """Return where a fit was blocked; empty if it was not."""
    step, _ = _linear_step(fitter, fit)

    def values_at(part_of_step: float) -> Array:
        return np.clip(fit.values + part_of_step * step, fitter.lower, fitter.upper)

    if _evaluable(fitter, values_at(1.0)):
        return ""
    passing_part, failing_part = 0.0, 1.0
    for _ in range(HALVINGS):
        if all(
            f"{passing:.3g}" == f"{failing:.3g}"
            for passing, failing in zip(values_at(passing_part), values_at(failing_part), strict=True)
        ):
            break
        middle = 0.5 * (passing_part + failing_part)
        passing_part, failing_part = (
            (middle, failing_part) if _evaluable(fitter, values_at(middle)) else (passing_part, middle)
        )
    # The fit may converge before that: a long step of a linear model is inaccurate.
    resumed_fit = fitter.rough_fit(
        fit.hypothesis, fitter.rough_descents([(fit.hypothesis, values_at(passing_part))])[0]
    )
    if resumed_fit is None or _linear_step(fitter, resumed_fit)[1] <= fitter.criteria.search.survives:
        return ""
    passing_values, failing_values = values_at(passing_part), values_at(failing_part)
    indices = np.arange(len(fit.values))
    decisive = [
        i for i in fit.free if not _evaluable(fitter, np.where(indices == i, failing_values, passing_values))
    ]
    changes = []
    for i in decisive or fit.free:
        p = fitter.parameters[i]
        unit = "" if p.unit == "1" else f" {p.unit}"
        side = "below" if failing_values[i] < passing_values[i] else "above"
        changes.append((p.name, f"{side} {plain(passing_values[i], 3)}{unit}"))
    subject = " + ".join(cause.name for cause in fit.causes) or "the fit"
    if [name for name, _ in changes] == [subject]:
        direction = changes[0][1]
    else:
        direction = "to " + " and ".join(f"{name} {text}" for name, text in changes)
    return f"{subject} could not be followed {direction}: the model cannot be evaluated there"


def _evaluable(fitter: Fitter, values: Array) -> bool:
    return bool(np.isfinite(fitter.structure.predict(values, ()).eigenvalues).all())
