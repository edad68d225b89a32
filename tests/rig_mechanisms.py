"""The virtual test rig for the rotary delta and the CoreXY: true modes with any effects, and with strangers to them.

Nothing here is shared with the derived model.  What a robot has beyond its loops is linear in the coordinates, and is
written down as rows from the contract: a spring or an inertia acts on a row, a number for each coordinate.  The
CoreXY is nothing but rows.  Of the rotary delta MuJoCo knows the loops (`rig_rotary_delta`).
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from scipy.linalg import eigh

from rig_engine import RIGID, TrueModes

#: What each cause outside the catalogue is, and what its strength measures.
OUTSIDE = {
    "tuned_absorber": "a mass [kg] on the platform or tool head slides along one direction on a spring",
    "directional_cable": "a spring [N/m] from the platform or tool head to ground pulls along one direction only",
    "one_servo": "the position loop of drive 1 alone holds like a spring [N m/rad]",
    "arm_hose": "a hose along arm 1 of the rotary delta pulls it back [N m/rad]",
    "one_link": "the linkage of axis 1 alone is elastic [m/N]",
    "rocking_frame": "the frame of the rotary delta rocks about a horizontal axis on the floor [rad/(N m)]",
    "one_gearbox": "the shaft of motor 1 of the CoreXY alone winds up [rad/(N m)]",
    "one_run": "run 1 of belt 1 alone has a soft end [m/N]",
    "racking_gantry": "the beam of the CoreXY yaws about its middle and takes the tool head along [rad/(N m)]",
}
#: Where absorbers slide and cables pull: no plane of symmetry.
ALONG = {3: np.array([2.0, 3.0, 6.0]) / 7, 2: np.array([0.6, 0.8])}
#: Frequency of an absorber by itself [Hz], a little below the lowest vibrations.
TUNED = {3: 50.0, 2: 90.0}
#: Length of the beam that yaws [m], and where its middle is.
BEAM, MIDDLE = 0.4, 0.15

#: Belts of a CoreXY, and three Gauss points of a run: places and shares.
BELTS = (0, 1)


class Rows:
    """Mass matrix, stiffness of springs and weights in named coordinates, built up row by row.

    Parameters
    ----------
    names : sequence of str
        Coordinates.
    platform : array, shape (d, n)
        Absolute velocity of the platform by those of the coordinates.
    """

    def __init__(self, names: Sequence[str], platform: np.ndarray) -> None:
        self.names, self.platform = list(names), np.asarray(platform, dtype=float)
        n = len(self.names)
        self.M, self.springs, self.weights = np.zeros((3, n, n))

    def row(self, **parts: float) -> np.ndarray:
        """A row with these parts, zero elsewhere."""
        found = np.zeros(len(self.names))
        for name, part in parts.items():
            found[self.names.index(name)] = part
        return found

    def spring(self, row: np.ndarray, stiffness: float) -> None:
        """A spring strained by a row, or alike by several."""
        self.springs += stiffness * np.atleast_2d(row).T @ np.atleast_2d(row)

    def inertia(self, row: np.ndarray, amount: float) -> None:
        """A mass or an inertia that moves by a row, or in each of several."""
        self.M += amount * np.atleast_2d(row).T @ np.atleast_2d(row)

    def modes(self, locked: Sequence[str], base: int) -> TrueModes:
        """Modes with some coordinates locked; of the base model the first `base` coordinates have inertia."""
        kept = np.array([name not in locked for name in self.names])
        M, elastic = self.M[np.ix_(kept, kept)], self.springs[np.ix_(kept, kept)]
        K = elastic + self.weights[np.ix_(kept, kept)]
        heavy = np.diag(M) > 0
        follow = np.eye(len(M))[:, heavy]
        if not heavy.all():  # what has no inertia follows without delay
            follow[~heavy] = -np.linalg.solve(K[np.ix_(~heavy, ~heavy)], K[np.ix_(~heavy, heavy)])
        M, K, elastic = (follow.T @ matrix @ follow for matrix in (M, K, elastic))
        eigenvalues, vectors = eigh(K, M)
        strains = eigh(elastic, M, eigvals_only=True)
        shapes = np.zeros((len(self.names), len(eigenvalues)))
        shapes[kept] = follow @ vectors
        named = dict(zip(self.names, shapes, strict=True))
        named |= dict(zip(("p_x", "p_y", "p_z"), self.platform @ shapes, strict=False))
        return TrueModes(
            frequencies=np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2 * np.pi),
            rigid=int(np.sum(strains < RIGID * strains[-1])),
            shapes=named,
            mass_matrix=M,
            stiffness_matrix=K,
            coordinates=tuple(np.array(self.names)[kept]),
        )


def corexy(
    q: Any, p: np.ndarray, effects: Mapping[str, float] = {}, outside: Mapping[str, float] = {}
) -> TrueModes:
    """Modes of a CoreXY at one pose.

    Parameters
    ----------
    q : Parameters
        One robot, without batch axes.
    p : array, shape (2)
    effects : mapping
        Parameters of the catalogue's effects in SI units, by ``"<effect>.<parameter>"``.
    outside : mapping
        Strengths of some of `OUTSIDE`.
    """
    released = {
        "psi": effects.get("gearbox_compliance.compliance", 0.0),
        "eps": effects.get("clamp_compliance.compliance", 0.0),
    }
    frame = effects.get("frame_compliance.compliance", 0.0)
    names = ["x", "y", "theta_1", "theta_2", "psi_1", "psi_2", "eps_1", "eps_2", "u_x", "u_y"]
    names += ["absorber", "rack"]
    lever = p[0] - MIDDLE
    head = np.zeros((2, len(names)))
    head[0, [0, 8]], head[1, [1, 9, 11]] = 1.0, (1.0, 1.0, lever)
    rows = Rows(names, head)
    beam = [rows.row(u_x=1.0), rows.row(y=1.0, u_y=1.0)]
    rows.inertia(head, q.toolhead_mass + effects.get("payload.mass", 0.0))
    rows.inertia(np.array(beam), q.gantry_mass)
    for i in BELTS:
        theta, psi, eps = (rows.row(**{f"{name}_{i + 1}": 1.0}) for name in ("theta", "psi", "eps"))
        rows.inertia(theta, q.pulley_inertia[i])
        rows.inertia(theta + psi, q.gear_ratio[i] ** 2 * q.motor_inertia[i])
        g = q.belt_path_direction[i]
        at_head = rows.row(x=g[0], y=g[1], rack=g[1] * lever) + eps
        at_pulley = -q.pulley_radius[i] * theta
        lengths = q.belt_path_lengths[i] + np.array([1.0, -1.0]) * (g @ p)
        unit = q.belt_width[i] * q.belt_specific_stiffness[i]
        unit *= 1.0 + effects.get(f"axis_belt_stiffness.factor_{i + 1}", 0.0)
        for run, length in enumerate(lengths):
            soft = effects.get("belt_end_compliance.compliance", 0.0)
            soft += outside.get("one_run", 0.0) if (i, run) == (0, 0) else 0.0
            rows.spring(at_head - at_pulley, 1.0 / (length / unit + soft))
            mass = effects.get("belt_mass.linear_density", 0.0) * length
            rows.inertia(at_head, mass / 6)  # linear between the ends: [[2, 1], [1, 2]] / 6
            rows.inertia(at_pulley, mass / 6)
            rows.inertia(at_head + at_pulley, mass / 6)
        for name, compliance in released.items():
            own = compliance + (outside.get("one_gearbox", 0.0) if (name, i) == ("psi", 0) else 0.0)
            if own:
                rows.spring(rows.row(**{f"{name}_{i + 1}": 1.0}), 1.0 / own)
    locked = [f"{name}_{i + 1}" for name, compliance in released.items() if not compliance for i in BELTS]
    if outside.get("one_gearbox"):
        locked.remove("psi_1")
    if racking := outside.get("racking_gantry"):
        rows.inertia(rows.row(rack=1.0), q.gantry_mass * BEAM**2 / 12)
        rows.spring(rows.row(rack=1.0), 1.0 / racking)
    else:
        locked.append("rack")
    if not frame:
        locked += ["u_x", "u_y"]
    return completed(rows, "theta", effects, outside).modes([*locked, *_without(outside)], 4)


def completed(rows: Rows, drive: str, effects: Mapping[str, float], outside: Mapping[str, float]) -> Rows:
    """Add what every mechanism may have: at its drives, at its platform, and under its frame."""
    count = len(rows.platform)
    for name in [name for name in rows.names if name.startswith(f"{drive}_")]:
        rows.inertia(rows.row(**{name: 1.0}), effects.get("gearbox_inertia.inertia", 0.0))
        rows.spring(rows.row(**{name: 1.0}), effects.get("servo_stiffness.stiffness", 0.0))
    rows.spring(rows.row(**{f"{drive}_1": 1.0}), outside.get("one_servo", 0.0))
    rows.spring(rows.platform, effects.get("cable_stiffness.stiffness", 0.0))
    along = ALONG[count] @ rows.platform
    rows.spring(along, outside.get("directional_cable", 0.0))
    if compliance := effects.get("frame_compliance.compliance"):
        for name in [name for name in rows.names if name.startswith("u_")]:
            rows.spring(rows.row(**{name: 1.0}), 1.0 / compliance)
            rows.inertia(rows.row(**{name: 1.0}), effects["frame_compliance.mass"])
    if mass := outside.get("tuned_absorber"):
        own = rows.row(absorber=1.0)
        rows.inertia(rows.platform, mass)
        rows.inertia(along, -mass)
        rows.inertia(along + own, mass)
        rows.spring(own, mass * (2 * np.pi * TUNED[count]) ** 2)
    return rows


def _without(outside: Mapping[str, float]) -> list[str]:
    return [] if outside.get("tuned_absorber") else ["absorber"]
