"""Standard deviations of measured shapes: the stated ones, unless no sensor or machine is so accurate."""

from __future__ import annotations

import numpy as np

from pkmodes.loop.diagnosis.criteria import Criteria
from pkmodes.loop.diagnosis.match.pairs import pairs_of_setups
from pkmodes.loop.diagnosis.problem import Array
from pkmodes.loop.measured.measurements import Measurements


def shape_errors(data: Measurements, criteria: Criteria) -> Array:
    """Return the standard deviation of the components of each row's shape, relative to the largest, (R,).

    NaN where none is stated.

    A stated value below that of any sensor is replaced by the uncertainty due to sensors and machine.  A change of
    the machine that moves two frequencies by their errors rotates the shapes into each other by an angle of about
    the relative error over the relative distance of the frequencies (Fox and Kapoor, AIAA Journal 6(12), 1968).
    Modes so close that they are compared as one subspace do not count.
    """
    is_too_small = data.shape_sigma < criteria.shapes.least_sigma
    if not is_too_small.any():
        return data.shape_sigma
    log_frequencies, errors = np.log(data.frequency), data.sigma / data.frequency
    squares = np.zeros(len(log_frequencies))
    for a, b in pairs_of_setups(data.pose, np.argsort(data.pose, kind="stable")):
        log_differences = np.abs(log_frequencies[a] - log_frequencies[b])
        is_separate = log_differences > criteria.pairing.mixed
        angles = (errors[a] ** 2 + errors[b] ** 2) / np.where(is_separate, log_differences, np.inf) ** 2
        squares[a] += angles  # each row once in `a`, and once in `b`
        squares[b] += angles
    smallest_errors = np.clip(np.sqrt(squares), criteria.shapes.least_sigma, criteria.shapes.most_scatter)
    return np.where(is_too_small, smallest_errors, data.shape_sigma)
