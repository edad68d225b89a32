"""Uncertainty of the declared robot's frequencies at the measured setups."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from pkmodes.core.mechanism.poses import MAX_CONDITION
from pkmodes.core.model import Model
from pkmodes.core.robot.robot import Robot
from pkmodes.loop.measured.measurements import Measurements
from pkmodes.loop.sensitivity.spread import spread_of, stated_sigmas
from pkmodes.loop.updating.load_cases import load_cases_of

Array = NDArray[np.float64]


def declared_spread(robot: Robot, data: Measurements) -> Array | None:
    """Return the standard deviations of the frequencies of the declared robot at S setups.

    - robot: as declared
    - data: a value that they set at a setup is known there, and has no standard deviation

    Returns (S, m): of the elastic modes, ascending [Hz]; NaN where a pose cannot be evaluated, or a setup has fewer
    modes.  None where the robot file states no standard deviations.
    """
    if not stated_sigmas(robot):
        return None
    loads = load_cases_of(robot, data)
    spreads: dict[int, Array] = {}
    for c, case in enumerate(loads.cases):
        setups = np.flatnonzero(loads.case_index == c)
        model = Model(case.robot, MAX_CONDITION)
        set_values = data.load(int(setups[0]))
        spread = spread_of(model, data.points[setups], case.drives, "nan", set_values)
        rigid = model.solved(case.drives).rigid_modes
        for i, setup in enumerate(setups.tolist()):
            spreads[setup] = np.empty(0) if spread is None else spread[i, rigid:]
    mode_count = max((len(row) for row in spreads.values()), default=0)
    padded = np.full((len(loads.case_index), mode_count), np.nan)
    for setup, row in spreads.items():
        padded[setup, : len(row)] = row
    return padded
