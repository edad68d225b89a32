"""Small motion of a machine about a static pose: what there is to integrate in time.

Mass, stiffness and the stiffness of the weight come from the rig (`pkmodes_rig.engine`, `pkmodes_rig.rows`), as modes
of the undamped machine, which are all its motions.  Friction is added here: viscous and Coulomb friction at
coordinates, and losses that are given mode by mode, as for complex stiffness.  In modal coordinates eta,

    eta'' + C eta' + Lambda eta = Phi^T f,        u = Phi eta,

with u the displacements at all coordinates and platform directions, and f forces along them.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from pkmodes_rig.engine import TrueModes

#: Motions that strain nothing are held by soft cords, as a free machine is in a laboratory: their frequency [Hz]
#: and damping ratio.
CORDS, CORDS_RATIO = 0.8, 0.3


@dataclass(frozen=True)
class Losses:
    """How a machine dissipates.

    Attributes
    ----------
    ratio : float
        Damping ratio of every vibration mode.
    viscous, coulomb : mapping of str to float
        Viscous friction [N s/m, N m s/rad] and Coulomb friction [N, N m] at coordinates.
    factor : float
        Loss factor of the elements whose share of the strain energy is given to `small_motion`.
    """

    ratio: float = 0.005
    viscous: Mapping[str, float] = field(default_factory=dict)
    coulomb: Mapping[str, float] = field(default_factory=dict)
    factor: float = 0.0


@dataclass(frozen=True, eq=False)
class SmallMotion:
    """A machine at a pose, in modal coordinates.

    Attributes
    ----------
    eigenvalues : ndarray, shape (m,)
        Lambda [rad^2/s^2], ascending.
    damping : ndarray, shape (m, m)
        C [1/s].
    shapes : mapping of str to ndarray, shape (m,)
        Rows of Phi, mass-normalised.
    coulomb : mapping of str to float
        Coulomb friction [N, N m] at coordinates.
    rigid : int
        Number of modes on cords, the first ones.
    """

    eigenvalues: np.ndarray
    damping: np.ndarray
    shapes: Mapping[str, np.ndarray]
    coulomb: Mapping[str, float]
    rigid: int

    @property
    def state_matrix(self) -> np.ndarray:
        """The matrix A of x' = A x + B f, x = (eta, eta'), shape (2 m, 2 m)."""
        m = len(self.eigenvalues)
        return np.block([[np.zeros((m, m)), np.eye(m)], [-np.diag(self.eigenvalues), -self.damping]])

    def rows(self, names: Sequence[str]) -> np.ndarray:
        """Return rows of Phi, shape (len(names), m)."""
        return np.array([self.shapes[name] for name in names]).reshape(len(names), len(self.eigenvalues))

    @property
    def truth(self) -> Truth:
        """Modes of the vibrations, without Coulomb friction."""
        poles, vectors = np.linalg.eig(self.state_matrix)
        m = len(self.eigenvalues)
        natural, found, used = np.sqrt(self.eigenvalues), [], set[int]()
        for i in range(self.rigid, m):  # the damped mode that consists mostly of the undamped one
            share = np.abs(vectors[i]) / np.linalg.norm(vectors[:m], axis=0)
            share[poles.imag <= 0.0] = -1.0
            share[list(used)] = -1.0
            k = int(np.argmax(share))
            used.add(k)
            found.append((abs(poles[k]), -poles[k].real / abs(poles[k]), vectors[:m, k] / vectors[i, k]))
        sizes, ratios, mixtures = (np.array(column) for column in zip(*found, strict=True))
        return Truth(
            natural[self.rigid :] / (2.0 * np.pi),
            sizes / (2.0 * np.pi),
            ratios,
            {name: mixtures @ row for name, row in self.shapes.items()},
        )


@dataclass(frozen=True, eq=False)
class Truth:
    """What a perfect identification of a machine gives.

    Attributes
    ----------
    natural : ndarray, shape (m,)
        Undamped natural frequencies [Hz].
    frequencies : ndarray, shape (m,)
        abs(pole) / (2 pi) [Hz]; equal to `natural` but for damping that couples modes.
    ratios : ndarray, shape (m,)
        Damping ratios, -re(pole) / abs(pole).
    shapes : mapping of str to ndarray of complex128, shape (m,)
    """

    natural: np.ndarray
    frequencies: np.ndarray
    ratios: np.ndarray
    shapes: Mapping[str, np.ndarray]


def small_motion(modes: TrueModes, losses: Losses, shares: np.ndarray | None = None) -> SmallMotion:
    """Return the machine whose undamped modes are these.

    Parameters
    ----------
    modes : TrueModes
    losses : Losses
    shares : ndarray, shape (m,), optional
        Share of each mode's stiffness that belongs to the elements with a loss factor.
    """
    omega = 2.0 * np.pi * np.abs(modes.frequencies)
    omega[: modes.rigid] = 2.0 * np.pi * CORDS
    ratios = np.full(len(omega), losses.ratio)
    if shares is not None:
        ratios += 0.5 * losses.factor * shares
    ratios[: modes.rigid] = CORDS_RATIO
    damping = np.diag(2.0 * ratios * omega)
    for name, coefficient in losses.viscous.items():
        damping += coefficient * np.outer(modes.shapes[name], modes.shapes[name])
    coulomb = {name: force for name, force in losses.coulomb.items() if force}
    return SmallMotion(omega**2, damping, modes.shapes, coulomb, modes.rigid)
