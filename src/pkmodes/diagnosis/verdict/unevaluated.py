"""Explanations that could not be followed, because the model cannot be evaluated where they lead.

A fit avoids such values, and ends beside them: that no cause explains the measurements is then no finding about these
causes.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.diagnosis.fit.fitter import Fitter
from pkmodes.diagnosis.fit.hypothesis import Fit, Hypothesis
from pkmodes.diagnosis.fit.store import FitStore
from pkmodes.diagnosis.problem import Array

#: Halvings of the way to the first value that cannot be evaluated, at most: three digits of it are told.
HALVINGS = 20


def unevaluated(store: FitStore, reported: Fit) -> Iterator[str]:
    """Say which single causes, and which parameters of the reported fit, were stopped by values without modes.

    Parameters
    ----------
    store : FitStore
    reported : Fit
    """
    fitter, least = store.fitter, store.criterion(reported)
    said = set[str]()
    for fit in _tried(store, reported):
        _, promised = _onward(fitter, fit)
        # Only what would have mattered: as good as what is reported, or nearly.
        if promised <= fitter.criteria.survives or store.criterion(fit) - promised > least:
            continue
        text = _stopped(fitter, fit)
        if text and text not in said:
            said.add(text)
            yield text


def _tried(store: FitStore, reported: Fit) -> Iterator[Fit]:
    """The reported fit and those of single causes; one that could not even begin is led there from the others."""
    fitter = store.fitter
    yield reported
    for candidate in fitter.structure.candidates:
        hypothesis = Hypothesis((candidate,))
        if not store.known(hypothesis) or hypothesis == reported.hypothesis:
            continue
        fit = store.fit(hypothesis)
        if fit is None and (plain := store.fit(Hypothesis())) is not None:
            fit = fitter.rough_fit(hypothesis, fitter.roughly([(hypothesis, plain.values)])[0])
        if fit is not None:
            yield fit


def _bounds(fitter: Fitter) -> tuple[Array, Array]:
    return np.array([p.lower for p in fitter.parameters]), np.array([p.upper for p in fitter.parameters])


def _onward(fitter: Fitter, fit: Fit) -> tuple[Array, float]:
    """The step of a linear model within the bounds, and by how much it would lower the sum of squares.

    That is nothing where a fit has arrived.
    """
    free, (lower, upper) = np.array(fit.free, dtype=np.intp), _bounds(fitter)
    at, gradient = fit.values[free], fit.jacobian.T @ fit.white
    held = ((at <= lower[free]) & (gradient > 0.0)) | ((at >= upper[free]) & (gradient < 0.0))
    columns = fit.jacobian[:, ~held]
    size = np.linalg.norm(columns, axis=0)
    scale = 1.0 / np.where(size > 0.0, size, 1.0)
    found = np.linalg.lstsq(columns * scale, -fit.white, rcond=1e-9)[0]
    left = fit.white + columns * scale @ found
    step = np.zeros_like(fit.values)
    step[free[~held]] = scale * found
    return step, float(fit.white @ fit.white - left @ left)


def _stopped(fitter: Fitter, fit: Fit) -> str:
    """Where a fit was stopped on its way; nothing where the way is free."""
    step, _ = _onward(fitter, fit)
    lower, upper = _bounds(fitter)

    def at(part: float) -> Array:
        return np.clip(fit.values + part * step, lower, upper)

    if _known(fitter, at(1.0)):
        return ""
    good, bad = 0.0, 1.0
    for _ in range(HALVINGS):
        if all(f"{one:.3g}" == f"{other:.3g}" for one, other in zip(at(good), at(bad), strict=True)):
            break
        middle = 0.5 * (good + bad)
        good, bad = (middle, bad) if _known(fitter, at(middle)) else (good, middle)
    # It may have arrived before: a long step of a linear model says little.
    there = fitter.rough_fit(fit.hypothesis, fitter.roughly([(fit.hypothesis, at(good))])[0])
    if there is None or _onward(fitter, there)[1] <= fitter.criteria.survives:
        return ""
    before, after = at(good), at(bad)
    alone = [i for i in fit.free if not _known(fitter, np.where(np.arange(len(after)) == i, after, before))]
    where = []
    for i in alone or fit.free:
        p = fitter.parameters[i]
        unit = "" if p.unit == "1" else f" {p.unit}"
        where.append((p.name, f"{'below' if after[i] < before[i] else 'above'} {before[i]:.3g}{unit}"))
    subject = " + ".join(cause.name for cause in fit.causes) or "the fit"
    if [name for name, _ in where] == [subject]:
        followed = where[0][1]
    else:
        followed = "to " + " and ".join(f"{name} {text}" for name, text in where)
    return f"{subject} could not be followed {followed}: the model cannot be evaluated there"


def _known(fitter: Fitter, values: Array) -> bool:
    return bool(np.isfinite(fitter.structure.predict(values, ()).eigenvalues).all())
