"""Measured damping beside that of the model."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from pkmodes.core.model import Model
from pkmodes.diagnosis.compare import Comparison
from pkmodes.updating.measured_robot import MeasuredRobot


def with_damping(result: Comparison, measured: MeasuredRobot) -> Comparison:
    """Return a comparison whose rows have the measured damping ratios, and those of their partners in the model."""
    data, loads = measured.data, measured.loads
    known = np.flatnonzero(~np.isnan(data.damping))
    if not len(known):
        return result
    rows = list(result.rows)
    for c, case in enumerate(loads.cases):
        mine = [int(i) for i in known if loads.of[data.pose[i]] == c]
        if not mine:
            continue
        model, setups = Model(case.robot), sorted({int(data.pose[i]) for i in mine})
        modes = model.modes(data.points[setups], drives=case.drives, fields=["damping_ratios"])
        # Partners count the most rigid modes that any setup has.
        ratios, first = modes.damping_ratios, result.rigid - modes.rigid_modes
        for i in mine:
            partner = rows[i].partner
            rows[i] = replace(
                rows[i],
                damping=float(data.damping[i]),
                sigma_damping=float(data.damping_sigma[i]),
                predicted_damping=None
                if partner is None
                else float(ratios[setups.index(int(data.pose[i])), partner - 1 - first]),
            )
    return replace(result, rows=tuple(rows))
