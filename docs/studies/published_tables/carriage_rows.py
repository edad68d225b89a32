"""Moving masses from the printed shapes, by the carriages' rows in K phi = lambda M phi.

Once the belts are known, the rows of the carriages give lambda M_ss x: the forces of two belt spans on each
carriage.  Along the centre line M_ss (equation 24) is the same at every pose and symmetric in axes 2 and 3, so it
has four different entries; gravity is small and neglected here.  M_ss in turn gives the directions of the links.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import least_squares

import pkmodes
from geometry import OPPOSITE, SAME, Geometry
from printed import Array, Row
from pulley_rows import AXES, Belt

NAMES = ("M_11", "M_12", "M_22 + M_23", "M_22 - M_23")
#: Carriages that move less than this, as x/R_p, do not determine their mass precisely.
SMALL = 0.1


@dataclass(frozen=True)
class Links:
    """Link directions that match M_ss: height of the plane and `across`, for one choice of sides."""

    sides: tuple[float, ...]
    z: float
    across: float
    misfit: float


def moving_masses(
    rows: Sequence[Row], readings: Mapping[str, str], carriages: Mapping[str, Array], span: float, belt: Belt
) -> Array:
    """Estimate M_11, M_12, M_22 + M_23 and M_22 - M_23 [kg] by least squares over all rows with moving carriages.

    Parameters
    ----------
    rows : sequence of Row
    readings : mapping
        How the x column of each row is read.
    carriages : mapping
        Positions of carriages 1 and 2 from the start of their rails [m].
    span : float
        max - min [m].
    belt : Belt
        Belt with the unit stiffness and radius common to all axes.
    """
    system, right = [], []
    for row in rows:
        scale = np.array([belt.radius if readings[row.name] == "metres" else 1.0, 1.0, 1.0])
        a, b, c = (np.array([row.shape[row.axis(axis)] for axis in AXES]) / scale).T
        if np.abs(a).max() < SMALL:
            continue
        x = carriages[row.name]
        push = belt.unit * ((a - c) / x + (a - b) / (span - x)) / row.eigenvalue / np.abs(a).max()
        a = a / np.abs(a).max()
        if row.moves(0):  # axes 2 and 3 move equally
            system += [[a[0], 2.0 * a[1], 0.0, 0.0], [0.0, a[0], a[1], 0.0]]
            right += list(push)
        else:  # axes 2 and 3 move in opposition
            system.append([0.0, 0.0, 0.0, a[1]])
            right.append(push[1])
    return np.asarray(np.linalg.lstsq(np.array(system), np.array(right), rcond=None)[0])


def links(declared: pkmodes.Robot, masses: Array) -> list[Links]:
    """Find the link directions that give these moving masses, best sides first."""
    length = float(declared.parameters.link_length[0])

    def misfit(unknowns: Array, sides: tuple[float, ...]) -> Array:
        across, z = length * np.sin(unknowns[0]), -length * np.cos(unknowns[0]) * np.sin(unknowns[1])
        here = Geometry(
            span=10.0 * length, across=across, offset=0.0, z=z, first=5.0 * length, step=0.0, sides=sides
        )
        M, _ = pkmodes.Model(here.robot(declared)).matrices(here.poses(np.zeros(1)), on_error="nan")
        m = M[0]
        found = np.array([m[0, 0], m[0, 1], m[1, 1] + m[1, 2], m[1, 1] - m[1, 2]])
        return np.nan_to_num((found - masses) / np.linalg.norm(masses), nan=10.0)

    found = []
    for sides in (OPPOSITE, SAME):
        # Best of a few starts; the unknowns are two angles of the link, its sideways angle and its inclination.
        fits = [
            least_squares(misfit, start, args=(sides,), bounds=([0.02, 0.05], [1.5, 1.5]))
            for start in ([0.2, 0.5], [0.4, 0.9], [0.8, 0.5], [0.8, 1.2])
        ]
        best = min(fits, key=lambda fit: fit.cost)
        across, down = length * np.sin(best.x[0]), length * np.cos(best.x[0]) * np.sin(best.x[1])
        found.append(Links(sides, -float(down), float(across), float(np.linalg.norm(best.fun))))
    return sorted(found, key=lambda one: one.misfit)
