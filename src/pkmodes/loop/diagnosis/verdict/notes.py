"""Notes to a verdict: sentences about the data and the fit."""

from __future__ import annotations

import warnings
from collections.abc import Iterator, Set

import numpy as np
from scipy import stats

from pkmodes.core.base.drives import HELD, motors_text
from pkmodes.core.base.numbers import format_factor, format_signed, plain, three_digits
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.fit.hypothesis import Fit
from pkmodes.loop.diagnosis.fit.store import FitStore
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import WithMotorCandidates, reached_bounds
from pkmodes.loop.diagnosis.readings.copies import setups_with_equal_shapes
from pkmodes.loop.diagnosis.search.unmeasured import never_measured
from pkmodes.loop.diagnosis.verdict.naming import number_in_words
from pkmodes.loop.diagnosis.verdict.shapes import strange_shapes
from pkmodes.loop.diagnosis.verdict.unevaluated import unevaluated

#: Measured modes below this part of the lowest frequency of the declared model are not modes of it; smallest number
#: of setups with such modes that is reported.
MAX_FREQUENCY_RATIO, MIN_SETUPS = 0.7, 2
#: Stated errors that are too small by more than the first factor are reported, and those that are too large by more
#: than the second, but only if the probability of such a small residual is below the third number.
MAX_UNDERSTATEMENT, MAX_OVERSTATEMENT, MAX_P_OF_SMALL_RESIDUAL = 3.0, 2.0, 1e-4


def notes(store: FitStore, fit: Fit, adequate: bool) -> list[str]:
    """Return notes on the data and on a fit.

    - fit: the reported fit
    - adequate: whether its residual is noise
    """
    fitter = store.fitter
    return [
        *_shape_notes(store, fit),
        *_stated_error_notes(store, fit, adequate),
        *_nuisance_notes(fitter, fit),
        *_set_aside_notes(fitter, fit),
        *_unmeasured_mode_notes(fitter, fit),
        *unevaluated(store, fit),
    ]


def motors_that_give_way(fitter: Fitter, claimed: Set[str]) -> Iterator[str]:
    """Yield how to test for motors that give way, where all motors were held and this could not be a cause.

    - claimed: names of the causes claimed, with those that act alike; empty if none is claimed.  A cause is
      questioned only if motors that give way act like it.
    """
    structure = fitter.structure
    if not isinstance(structure, WithMotorCandidates) or {*fitter.data.drives} != {HELD}:
        return
    springs, joints = structure.motor_effects.springs, structure.motor_effects.joints
    if springs and (not claimed or not claimed.isdisjoint(joints)):
        yield (
            f"with held motors {' or '.join(springs)} is no candidate: if the motors give way, as steppers do, "
            'diagnose with free ones (--drives free, drives="free")'
        )


def _shape_notes(store: FitStore, fit: Fit) -> Iterator[str]:
    data, c = store.fitter.data, store.fitter.criteria
    labels_of_equal_shapes = setups_with_equal_shapes(data, c.readings.same_shape)
    if labels_of_equal_shapes:
        listed = ", ".join(labels_of_equal_shapes[:5]) + (", ..." if len(labels_of_equal_shapes) > 5 else "")
        poses = f"pose{'' if len(labels_of_equal_shapes) == 1 else 's'} {listed}"
        yield f"all shapes of {poses} are the same: shapes of different modes must differ"
    scatter = store.shape_scatter(fit)
    if scatter is not None and scatter > c.shapes.most_scatter:
        yield (
            f"no explanation fits the shapes: they scatter by {100 * scatter:.0f} % of their largest "
            "component (sensors exchanged or miswired, or shapes of other modes)"
        )
    strange_rows = strange_shapes(store, fit)
    if len(strange_rows) == 1:
        row = strange_rows[0]
        yield (
            f"the shape in line {data.lines[row]} is not that of the mode at its frequency (MAC "
            f"{plain(fit.pairing.mac[row], 2)})"
        )
    elif len(strange_rows):
        lines = ", ".join(str(data.lines[i]) for i in strange_rows[:8]) + (
            ", ..." if len(strange_rows) > 8 else ""
        )
        yield (
            f"the shapes in lines {lines} are not those of the modes at their frequencies (MAC "
            f"{plain(fit.pairing.mac[strange_rows].min(), 2)} or more)"
        )


def _stated_error_notes(store: FitStore, fit: Fit, adequate: bool) -> Iterator[str]:
    squares, degrees = store.frequency_misfit(fit)
    if degrees < 1.0:
        return
    ratio = (squares / degrees) ** 0.5
    subject = "the stated errors of the frequencies are"
    root = f" (by the root of chi2 per degree of freedom, {three_digits(ratio**2)})"
    if ratio < 1.0 / MAX_OVERSTATEMENT and stats.chi2.cdf(squares, degrees) < MAX_P_OF_SMALL_RESIDUAL:
        factor = format_factor(1.0 / ratio) if ratio > 1e-6 else "far"
        yield f"{subject} {factor} too large: the residual scatters much less{root}"
    elif adequate and ratio > MAX_UNDERSTATEMENT:
        yield f"{subject} {format_factor(ratio)} too small{root}"


def _nuisance_notes(fitter: Fitter, fit: Fit) -> Iterator[str]:
    deviations = fitter.priors.distances(fit.values)
    for i, deviation in zip(fitter.priors.index, deviations, strict=True):
        p = fitter.parameters[i]
        is_free = i in fit.free
        unit = "" if p.unit == "1" else f" {p.unit}"
        if is_free and abs(deviation) > fitter.criteria.reasons.far:
            yield (
                f"{p.name} = {plain(float(fit.values[i]), 4)}{unit} is {abs(deviation):.1f} sigma from its "
                f"declared value, {plain(p.value, 4)}{unit}: the declared value or its sigma is wrong, or it "
                "compensates for a cause"
            )
    for i in fit.free:
        p = fitter.parameters[i]
        for bound in reached_bounds(p, fit.values[i], p.sigma or 0.0):
            if bound != p.value:
                yield f"{p.name} is at its bound, {plain(bound, 4)}"


def _set_aside_notes(fitter: Fitter, fit: Fit) -> Iterator[str]:
    for row in sorted(fit.hypothesis.excluded_rows):
        data = fitter.data
        yield (
            f"line {data.lines[row]} ({data.labels[data.pose[row]]}, {data.frequency[row]:g} Hz) is set aside "
            "as an outlier: check it"
        )
    if fit.hypothesis.has_shared_error:
        pattern = drift(fitter, fit)
        drift_clause = f": {pattern}" if pattern else ""
        error_clause = f"the modes of a pose share an error of {plain(100 * fit.shared_error, 2)} %"
        yield f"{error_clause} that the file does not state{drift_clause}"


def low_modes(declared: MatchStage) -> list[str]:
    """Return a note if measured modes lie clearly below all of the declared model at half of the setups or more.

    Such modes have no partner, whatever its parameter values: something stands on a spring that the model lacks.
    """
    data, spectrum = declared.data, declared.predicted.elastic_frequencies
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of a setup without any mode
        lowest_frequencies = np.nanmin(spectrum, axis=1)
    is_below = data.frequency < MAX_FREQUENCY_RATIO * lowest_frequencies[data.pose]
    counts = np.bincount(data.pose[is_below], minlength=len(lowest_frequencies))
    measured = np.unique(data.pose)
    setups = int((counts[measured] > 0).sum())
    if setups < max(MIN_SETUPS, len(measured) / 2.0):
        return []
    max_count, low, high = int(counts.max()), data.frequency[is_below].min(), data.frequency[is_below].max()
    frequency_range = (
        f"at {plain(low, 3)} Hz"
        if np.isclose(low, high, rtol=1e-2)
        else f"from {plain(low, 3)} to {plain(high, 3)} Hz"
    )
    modes_in_words = (
        "a measured mode lies" if max_count == 1 else f"up to {number_in_words(max_count)} measured modes lie"
    )
    poses = "every pose" if setups == len(measured) else f"{setups} of {len(measured)} poses"
    explanation = "something stands on a spring, such as the machine on its base"
    if declared.prediction.rigid:
        explanation += ", or something holds motions that are free in the model, such as motors or a cable"
    return [
        f"{modes_in_words} below the lowest mode of the declared model at {poses}, {frequency_range}: {explanation}"
    ]


def drift(fitter: Fitter, fit: Fit) -> str:
    """Return a sentence if the error that the modes of a pose share drifts with the order of the poses."""
    residual = fit.residual[fitter.observations.frequency_slice]
    means = np.array([residual[rows].mean() for rows in fitter.observations.noise.rows if len(rows)])
    if len(means) < 5:
        return ""
    pose_order = np.arange(len(means))
    if stats.spearmanr(pose_order, means).pvalue > fitter.criteria.gate.level:
        return ""
    slope = float(np.polyfit(pose_order, means, 1)[0])
    drift = format_signed(100 * slope * (len(means) - 1))
    return f"it drifts with the order of the poses, by {drift} % from first to last"


def _unmeasured_mode_notes(fitter: Fitter, fit: Fit) -> Iterator[str]:
    is_mixed = len(set(fitter.data.drives)) > 1
    for low, high, setups, drives in never_measured(fitter, fit):
        frequency_range = (
            f"{plain(low, 4)} Hz"
            if np.isclose(low, high, rtol=1e-3)
            else f"{plain(low, 4)} to {plain(high, 4)} Hz"
        )
        setups_in_words = f"{setups} poses" + (f" with {motors_text([drives])}" if is_mixed else "")
        yield f"a mode at {frequency_range} was expected at {setups_in_words} but never measured"
