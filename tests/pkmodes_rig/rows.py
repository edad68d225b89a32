"""A robot described by rows: a spring or an inertia acts on a linear combination of coordinates.

Apart from its loops, a robot is linear in the coordinates and follows from the specification only; nothing here is
shared with the derived model.  `corexy` consists of rows only; `rotary_delta` takes its loops from MuJoCo.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from scipy.linalg import eigh

from pkmodes_rig.engine import RIGID, TrueModes

#: Causes outside the catalogue, with the unit of their strength.
OUTSIDE = {
    "tuned_absorber": "a mass [kg] on the platform or tool head slides in one direction on a spring",
    "directional_cable": "a spring [N/m] from the platform or tool head to ground pulls in one direction only",
    "one_servo": "only the position loop of drive 1 holds like a spring [N m/rad]",
    "arm_hose": "a hose along arm 1 of the rotary delta pulls it back [N m/rad]",
    "one_link": "only the link of axis 1 is elastic [m/N]",
    "rocking_frame": "the frame of the rotary delta rocks about a horizontal axis on the floor [rad/(N m)]",
    "one_gearbox": "only the shaft of motor 1 of the CoreXY winds up [rad/(N m)]",
    "one_run": "only run 1 of belt 1 has a soft end [m/N]",
    "leg_hose": "a spring [N/m] to ground along leg 1 of a hexapod, or along rail 1 of a hexaglide",
    "racking_gantry": "the beam of the CoreXY yaws about its middle and takes the tool head along [rad/(N m)]",
}
#: Direction in which absorbers slide and cables pull, not in a plane of symmetry, by platform dimension.
ALONG = {3: np.array([2.0, 3.0, 6.0]) / 7, 2: np.array([0.6, 0.8])}
#: Frequency of the isolated absorber [Hz], slightly below the lowest vibration mode, by platform dimension.
TUNED = {3: 50.0, 2: 90.0}


class Rows:
    """Mass matrix, spring stiffness and gravity stiffness in named coordinates, assembled row by row.

    Parameters
    ----------
    names : sequence of str
        Coordinates.
    platform : array, shape (d, n)
        Absolute velocity of the platform per velocity of each coordinate.
    turning : array, shape (r, n), optional
        Its angular velocity, where it turns.
    """

    def __init__(self, names: Sequence[str], platform: np.ndarray, turning: np.ndarray | None = None) -> None:
        self.names, self.platform = list(names), np.asarray(platform, dtype=float)
        n = len(self.names)
        self.turning = np.zeros((0, n)) if turning is None else np.asarray(turning, dtype=float)
        self.M, self.springs, self.weights = np.zeros((3, n, n))

    def row(self, **parts: float) -> np.ndarray:
        """Return a row with these entries, zero elsewhere."""
        row = np.zeros(len(self.names))
        for name, part in parts.items():
            row[self.names.index(name)] = part
        return row

    def spring(self, row: np.ndarray, stiffness: float) -> None:
        """Add a spring that a row strains, or one for each of several rows."""
        self.springs += stiffness * np.atleast_2d(row).T @ np.atleast_2d(row)

    def inertia(self, row: np.ndarray, amount: float) -> None:
        """Add a mass or inertia that moves with a row, or with each of several rows."""
        self.M += amount * np.atleast_2d(row).T @ np.atleast_2d(row)

    def motors(self, drive: str) -> list[dict[str, float]]:
        """Return the angle of each motor: that of the rotor it drives, and of the gearbox if it can wind up."""
        rotors = [name for name in self.names if name.startswith(f"{drive}_")]
        return [{q: 1.0 for q in (name, name.replace(drive, "psi")) if q in self.names} for name in rotors]

    def modes(self, locked: Sequence[str], held: Sequence[Mapping[str, float]] = ()) -> TrueModes:
        """Compute the modes with some coordinates locked, and with some motors locked.

        Parameters
        ----------
        held : sequence of mapping
            From `motors`.
        """
        rotors = [next(iter(motor)) for motor in held]
        kept = np.array([name not in (*locked, *rotors) for name in self.names])
        of_kept = np.eye(len(self.names))
        for rotor, motor in zip(rotors, held, strict=True):
            of_kept[self.names.index(rotor)] = self.row(**{rotor: 1.0}) - self.row(**motor)
        of_kept = of_kept[:, kept]
        M, elastic, weights = (
            of_kept.T @ matrix @ of_kept for matrix in (self.M, self.springs, self.weights)
        )
        K = elastic + weights
        heavy = np.diag(M) > 0
        follow = np.eye(len(M))[:, heavy]
        if not heavy.all():  # coordinates without inertia follow statically
            follow[~heavy] = -np.linalg.solve(K[np.ix_(~heavy, ~heavy)], K[np.ix_(~heavy, heavy)])
        M, K, elastic = (follow.T @ matrix @ follow for matrix in (M, K, elastic))
        eigenvalues, vectors = eigh(K, M)
        strains = eigh(elastic, M, eigvals_only=True)
        shapes = of_kept @ follow @ vectors
        named = dict(zip(self.names, shapes, strict=True))
        named |= dict(zip(("p_x", "p_y", "p_z"), self.platform @ shapes, strict=False))
        named |= dict(zip(("r_x", "r_y", "r_z"), self.turning @ shapes, strict=False))
        return TrueModes(
            frequencies=np.sign(eigenvalues) * np.sqrt(np.abs(eigenvalues)) / (2 * np.pi),
            rigid=int(np.sum(strains < RIGID * strains[-1])),
            shapes=named,
            mass_matrix=M,
            stiffness_matrix=K,
            coordinates=tuple(np.array(self.names)[kept]),
            held=bool(held),
        )


def completed(
    rows: Rows,
    drive: str,
    effects: Mapping[str, float],
    outside: Mapping[str, float],
    *,
    motors: Sequence[Mapping[str, float]] = (),
    tuned: float = 0.0,
) -> Rows:
    """Add the effects and causes common to all mechanisms: at the drives, the platform and the frame.

    Parameters
    ----------
    rows : Rows
    drive : str
        Coordinates of the rotors, without their numbers.
    effects, outside : mapping
    motors : sequence of mapping, optional
        Angle of each motor, its rotor first, where not every rotor is driven.
    tuned : float, optional
        Frequency of the isolated absorber [Hz]; by default that in `TUNED`.
    """
    count = len(rows.platform)
    motors = motors or rows.motors(drive)
    for motor in motors:
        rows.inertia(rows.row(**{next(iter(motor)): 1.0}), effects.get("gearbox_inertia.inertia", 0.0))
        rows.spring(rows.row(**motor), effects.get("servo_stiffness.stiffness", 0.0))
    rows.spring(rows.row(**{next(iter(motors[0])): 1.0}), outside.get("one_servo", 0.0))
    rows.spring(rows.platform, effects.get("cable_stiffness.stiffness", 0.0))
    along = ALONG[count] @ rows.platform
    rows.spring(along, outside.get("directional_cable", 0.0))
    for name in [name for name in rows.names if name.startswith("u_")]:
        if compliance := frame_compliance(name, effects):
            rows.spring(rows.row(**{name: 1.0}), 1.0 / compliance)
            rows.inertia(rows.row(**{name: 1.0}), effects["frame_compliance.mass"])
    if mass := outside.get("tuned_absorber"):
        own = rows.row(absorber=1.0)
        rows.inertia(rows.platform, mass)
        rows.inertia(along, -mass)
        rows.inertia(along + own, mass)
        rows.spring(own, mass * (2 * np.pi * (tuned or TUNED[count])) ** 2)
    return rows


def frame_compliance(name: str, effects: Mapping[str, float]) -> float:
    """Return the compliance of a displacement of the frame, ``u_x``: that of its direction, or the isotropic one."""
    by_direction = effects.get(f"frame_compliance.compliance_{name.removeprefix('u_')}", 0.0)
    return by_direction or effects.get("frame_compliance.compliance", 0.0)


def without(outside: Mapping[str, float]) -> list[str]:
    """Return the coordinates that are locked because no cause outside the catalogue needs them."""
    return [] if outside.get("tuned_absorber") else ["absorber"]
