"""Dependence of the frequencies on the level of excitation, which no candidate of a linear model explains."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from pkmodes.core.base.numbers import format_factor, format_signed, p_in_words, plain
from pkmodes.loop.diagnosis.fit.fitter import Fitter
from pkmodes.loop.diagnosis.match.stage import MatchStage
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.diagnosis.readings.copies import POSITION_TOLERANCE
from pkmodes.loop.measured.amplitude import UNREPEATED_FACTOR, AmplitudeDependence, amplitude_dependence
from pkmodes.loop.measured.measurements import Measurements

#: How the frequencies change and what may cause it, by the sign of the change.
TREND_WORDS = {
    -1: ("they fall with the level", "as when friction slips or a contact opens"),
    0: ("some fall and others rise with the level", "as when contacts open and close"),
    1: ("they rise with the level", "as when a gap closes or a spring hardens"),
}


def level_dependence(fitter: Fitter, values: Array) -> AmplitudeDependence | None:
    """Return how the measured frequencies depend on the level; None if no setups differ in their level alone.

    - values: of all parameters: the model determines which rows are the same mode, and how uncertain positions move
      it
    """
    data = fitter.data
    if np.isfinite(data.level).sum() < 2:
        return None
    stage = MatchStage(fitter.structure, data, fitter.observations.pairer, values)
    partner, motion = stage.pairing.partner, None
    position_rates = fitter.structure.position_rates(values) if data.point_sigma.any() else None
    if position_rates is not None:
        motion = np.where(
            (partner >= 0)[:, None], position_rates.log_rates[data.pose, np.maximum(partner, 0)], 0.0
        )
        # How the position moves a mode that the model lacks is unknown: it is matched with no other.
        partner = np.where(partner >= 0, partner, -1 - np.arange(len(partner)))
    return amplitude_dependence(data, list(_setups_that_differ_in_level(stage)), partner, motion)


def format_level_dependence(trend: AmplitudeDependence, data: Measurements) -> str:
    """Return how frequencies depend on the level."""
    unit, row = f" {data.level_unit}" if data.level_unit else "", trend.clearest.row
    min_change, max_change = (format_signed(100.0 * change) for change in trend.range)
    change = min_change if min_change == max_change else f"{min_change} to {max_change}"
    mode = f"mode {data.mode[row]}" if data.mode[row] else f"{plain(data.frequency[row], 4)} Hz"
    clearest = f", clearest in line {data.lines[row]} ({data.labels[data.pose[row]]}, {mode})"
    change_words, likely_cause = TREND_WORDS[trend.direction]
    basis = "with the scatter of setups at one level"
    if not trend.repeated:
        basis = (
            f"even with errors {format_factor(UNREPEATED_FACTOR)} as large as stated, but no level was measured "
            "again, so the repeatability of setups is unknown"
        )
    return (
        f"from a level of {plain(trend.low, 3)} to {plain(trend.high, 3)}{unit} frequencies at the same position "
        f"change by {change} %{clearest if len(trend.changes) > 1 else ''}: {change_words}, {likely_cause} "
        f"({p_in_words(trend.p_value)} {basis})"
    )


def notes_on_amplitude(fitter: Fitter, values: Array) -> tuple[str, ...]:
    """Return a note if frequencies depend on the level."""
    trend = level_dependence(fitter, values)
    return () if trend is None or not trend.significant else (format_amplitude_note(trend, fitter.data),)


def format_amplitude_note(trend: AmplitudeDependence, data: Measurements) -> str:
    """Return a note on frequencies that depend on the level."""
    return f"the frequencies depend on amplitude: {format_level_dependence(trend, data)}"


def _setups_that_differ_in_level(stage: MatchStage) -> Iterator[list[int]]:
    """Yield groups of setups that differ only in their level: their positions agree within the stated errors.

    Setups without positions are the same if the model has the same modes there.
    """
    data, log_frequencies = stage.data, stage.prediction.log_frequencies
    conditions, has_positions = data.conditions, bool(data.points.any())
    remaining_setups = [int(i) for i in np.flatnonzero(np.isfinite(data.level))]
    while remaining_setups:
        setup = remaining_setups[0]
        if has_positions:
            tolerance = POSITION_TOLERANCE + np.hypot(data.point_sigma, data.point_sigma[setup])
            at_same_position = (np.abs(data.points - data.points[setup]) <= tolerance).all(axis=1)
        else:
            at_same_position = np.isclose(
                log_frequencies, log_frequencies[setup], rtol=0.0, atol=1e-9, equal_nan=True
            ).all(axis=1)
        group = [i for i in remaining_setups if at_same_position[i] and conditions[i] == conditions[setup]]
        remaining_setups = [i for i in remaining_setups if i not in group]
        yield group
