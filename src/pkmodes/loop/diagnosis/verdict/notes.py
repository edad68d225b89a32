"""Notes to a verdict: sentences about the data and the fit."""

from __future__ import annotations

import warnings
from collections.abc import Iterator

import numpy as np
from scipy import stats

from pkmodes.core.base.drives import motors
from pkmodes.core.base.numbers import plain, signed, times
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import reached_bounds
from pkmodes.loop.diagnosis.readings.copies import all_alike
from pkmodes.loop.diagnosis.search.unmeasured import never_measured
from pkmodes.loop.diagnosis.verdict.naming import count
from pkmodes.loop.diagnosis.verdict.shapes import strange_shapes
from pkmodes.loop.diagnosis.verdict.unevaluated import unevaluated

#: Measured modes below this part of the lowest frequency of the declared model are not modes of it; smallest number
#: of setups with such modes that is reported.
CLEARLY_BELOW, FEWEST_SETUPS = 0.7, 2
#: Stated errors that are too small by more than the first factor are reported, and those that are too large by more
#: than the second, but only if the probability of such a small residual is below the third number.
TOO_SMALL, TOO_LARGE, SO_SMALL = 3.0, 2.0, 1e-4


def notes(store: FitStore, fit: Fit, adequate: bool) -> list[str]:
    """Return notes on the data and on a fit.

    - fit: the reported fit
    - adequate: whether its residual is noise
    """
    fitter = store.fitter
    return [
        *_shapes(store, fit),
        *_stated_errors(store, fit, adequate),
        *_nuisances(fitter, fit),
        *_set_aside(fitter, fit),
        *_unmeasured(fitter, fit),
        *unevaluated(store, fit),
    ]


def _shapes(store: FitStore, fit: Fit) -> Iterator[str]:
    data, c = store.fitter.data, store.fitter.criteria
    alike = all_alike(data, c.readings.same_shape)
    if alike:
        listed = ", ".join(alike[:5]) + (", ..." if len(alike) > 5 else "")
        poses = f"pose{'' if len(alike) == 1 else 's'} {listed}"
        yield f"all shapes of {poses} are the same: shapes of different modes must differ"
    scatter = store.shape_scatter(fit)
    if scatter is not None and scatter > c.shapes.most_scatter:
        yield (
            f"no explanation fits the shapes: they scatter by {100 * scatter:.0f} % of their largest component "
            "(sensors exchanged or miswired, or shapes of other modes)"
        )
    strange = strange_shapes(store, fit)
    if len(strange) == 1:
        row = strange[0]
        yield (
            f"the shape in line {data.lines[row]} is not that of the mode at its frequency "
            f"(MAC {plain(fit.pairing.mac[row], 2)})"
        )
    elif len(strange):
        lines = ", ".join(str(data.lines[i]) for i in strange[:8]) + (", ..." if len(strange) > 8 else "")
        yield (
            f"the shapes in lines {lines} are not those of the modes at their frequencies "
            f"(MAC {plain(fit.pairing.mac[strange].min(), 2)} or more)"
        )


def _stated_errors(store: FitStore, fit: Fit, adequate: bool) -> Iterator[str]:
    squares, degrees = store.frequency_misfit(fit)
    if degrees < 1.0:
        return
    ratio = (squares / degrees) ** 0.5
    if ratio < 1.0 / TOO_LARGE and stats.chi2.cdf(squares, degrees) < SO_SMALL:
        factor = times(1.0 / ratio) if ratio > 1e-6 else "far"
        yield f"the stated errors of the frequencies are {factor} too large: the residual scatters much less"
    elif adequate and ratio > TOO_SMALL:
        yield f"the stated errors of the frequencies are {times(ratio)} too small"


def _nuisances(fitter: Fitter, fit: Fit) -> Iterator[str]:
    away = fitter.priors.away(fit.values)
    for i, far in zip(fitter.priors.index, away, strict=True):
        p = fitter.parameters[i]
        free = i in fit.free
        unit = "" if p.unit == "1" else f" {p.unit}"
        if free and abs(far) > fitter.criteria.reasons.far:
            yield (
                f"{p.name} = {plain(float(fit.values[i]), 4)}{unit} is {abs(far):.1f} sigma from its declared value, "
                f"{plain(p.value, 4)}{unit}: the declared value or its sigma is wrong, or it compensates for a cause"
            )
    for i in fit.free:
        p = fitter.parameters[i]
        for bound in reached_bounds(p, fit.values[i], p.sigma or 0.0):
            if bound != p.value:
                yield f"{p.name} is at its bound, {plain(bound, 4)}"


def _set_aside(fitter: Fitter, fit: Fit) -> Iterator[str]:
    for row in sorted(fit.hypothesis.excluded):
        data = fitter.data
        yield (
            f"line {data.lines[row]} ({data.labels[data.pose[row]]}, {data.frequency[row]:g} Hz) is set aside as an "
            "outlier: check it"
        )
    if fit.hypothesis.scatter:
        pattern = drift(fitter, fit)
        also = f": {pattern}" if pattern else ""
        share = f"the modes of a pose share an error of {plain(100 * fit.scatter, 2)} %"
        yield f"{share} that the file does not state{also}"


def low_modes(declared: MatchStage) -> list[str]:
    """Return a note if measured modes lie clearly below all of the declared model at half of the setups or more.

    Such modes have no partner, whatever its parameter values: something stands on a spring that the model lacks.
    """
    data, spectrum = declared.data, declared.predicted.spectrum
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of a setup without any mode
        lowest = np.nanmin(spectrum, axis=1)
    below = data.frequency < CLEARLY_BELOW * lowest[data.pose]
    counts = np.bincount(data.pose[below], minlength=len(lowest))
    measured = np.unique(data.pose)
    setups = int((counts[measured] > 0).sum())
    if setups < max(FEWEST_SETUPS, len(measured) / 2.0):
        return []
    largest, low, high = int(counts.max()), data.frequency[below].min(), data.frequency[below].max()
    where = (
        f"at {plain(low, 3)} Hz"
        if np.isclose(low, high, rtol=1e-2)
        else f"from {plain(low, 3)} to {plain(high, 3)} Hz"
    )
    which = "a measured mode lies" if largest == 1 else f"up to {count(largest)} measured modes lie"
    at = "every" if setups == len(measured) else f"{setups} of {len(measured)}"
    held = " or something holds motions that are free in the model, such as motors or a cable"
    also = f",{held}" if declared.prediction.rigid else ""
    return [
        f"{which} below the lowest mode of the declared model at {at} pose{'' if at == 'every' else 's'}, {where}: "
        f"something stands on a spring, such as the machine on its base{also}"
    ]


def drift(fitter: Fitter, fit: Fit) -> str:
    """Return a sentence if the error that the modes of a pose share drifts with the order of the poses."""
    residual = fit.residual[fitter.observations.frequency_rows]
    means = np.array([residual[rows].mean() for rows in fitter.observations.noise.rows if len(rows)])
    if len(means) < 5:
        return ""
    order = np.arange(len(means))
    if stats.spearmanr(order, means).pvalue > fitter.criteria.gate.level:
        return ""
    slope = float(np.polyfit(order, means, 1)[0])
    return f"it drifts with the order of the poses, by {signed(100 * slope * (len(means) - 1))} % from first to last"


def _unmeasured(fitter: Fitter, fit: Fit) -> Iterator[str]:
    mixed = len(set(fitter.data.drives)) > 1
    for low, high, setups, drives in never_measured(fitter, fit):
        where = (
            f"{plain(low, 4)} Hz"
            if np.isclose(low, high, rtol=1e-3)
            else f"{plain(low, 4)} to {plain(high, 4)} Hz"
        )
        at = f"{setups} poses" + (f" with {motors([drives])}" if mixed else "")
        yield f"a mode at {where} was expected at {at} but never measured"
