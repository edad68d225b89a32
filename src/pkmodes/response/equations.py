r"""The equations of motion at one pose, in modal coordinates, with the inputs and outputs of a response.

With the coordinates y that are solved for and prescribed motor angles u, :math:`q = T y + S u`.  Coordinates without
inertia follow the others statically, with complex stiffness; the forces of inputs are polynomials in
:math:`s = i \omega`, since a prescribed motion acts through stiffness, damping and inertia.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.response.linearised import LinearisedRobot
from pkmodes.response.receptance import receptance

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True)
class EquationsOfMotion:
    """At one pose, with k coordinates y and I inputs.

    Attributes
    ----------
    M, C, K : ndarray, shape (k, k)
        C without the damping of a ratio, K complex.
    modal : ndarray, shape (k, k)
        The damping of a ratio.
    forces : tuple of three ndarray, shape (k, I)
        Coefficients of 1, s and s^2.
    motion, prescribed : ndarray, shape (outputs, k) and (outputs, I)
        What the outputs show of y, and of the inputs themselves.
    shapes : ndarray, shape (m, k)
    eigenvalues : ndarray, shape (m,)
    rates : ndarray, shape (m,)
        Diagonal damping of the modes by the ratio, 2 zeta omega [1/s].
    massless : ndarray of bool, shape (k,)
    """

    M: Array
    C: Array
    K: Complex
    modal: Array
    forces: tuple[Complex, Complex, Complex]
    motion: Array
    prescribed: Array
    shapes: Array
    eigenvalues: Array
    rates: Array
    massless: NDArray[np.bool_]

    def response(self, omega: Array) -> Complex:
        """Return the displacements of the outputs per unit of each input, (F, outputs, I)."""
        r = self.massless
        if (self.C[r] != 0.0).any():
            return self.by_frequency(omega)
        s = 1j * omega[:, None, None]
        Z, shapes, motion, forces, direct = self._condensed()
        D = shapes @ self.C[np.ix_(~r, ~r)] @ shapes.T + np.diag(self.rates)
        moving = [(force != 0.0).any(axis=0) for force in forces]  # prescribed motions act at all three
        b = np.hstack([shapes @ force[:, some] for force, some in zip(forces, moving, strict=True)])
        summands = receptance(Z, D, b, motion @ shapes.T, omega)
        H = np.zeros((len(omega), *direct.shape), dtype=complex) + (direct + self.prescribed)
        ends = np.cumsum([some.sum() for some in moving])[:-1]
        for power, (some, part) in enumerate(zip(moving, np.split(summands, ends, axis=2), strict=True)):
            if some.any():
                H[:, :, some] += part if power == 0 else s**power * part
        return H

    def by_frequency(self, omega: Array) -> Complex:
        """Return the same from a linear system for each frequency."""
        s = 1j * omega[:, None, None]
        dynamic = self.K + s * (self.C + self.modal) + s**2 * self.M
        forces = self.forces[0] + s * self.forces[1] + s**2 * self.forces[2]
        return np.asarray(self.motion @ np.linalg.solve(dynamic, forces) + self.prescribed)

    def _condensed(self) -> tuple[Complex, Array, Complex, list[Complex], Complex]:
        """Return Z, and shapes, motion, forces and direct response without the coordinates that have no inertia."""
        r, q = self.massless, ~self.massless
        K, loss = self.K, self.K.imag
        motion: Complex = self.motion[:, q].astype(complex)
        forces = [force[q] for force in self.forces]
        direct: Complex = np.zeros((len(self.motion), self.forces[0].shape[1]), dtype=complex)
        change: Any = 1j * loss[np.ix_(q, q)]
        if r.any():
            follow = -np.linalg.solve(K[np.ix_(r, r)], np.hstack([K[np.ix_(r, q)], -self.forces[0][r]]))
            by_others, by_forces = np.split(follow, [int(q.sum())], axis=1)
            static = -np.linalg.solve(K.real[np.ix_(r, r)], K.real[np.ix_(r, q)])
            change = change + K[np.ix_(q, r)] @ by_others - K.real[np.ix_(q, r)] @ static
            motion = motion + self.motion[:, r] @ by_others
            forces[0] = forces[0] - K[np.ix_(q, r)] @ by_forces
            direct = direct + self.motion[:, r] @ by_forces
        shapes = self.shapes[:, q]
        Z: Complex = np.diag(self.eigenvalues) + shapes @ change @ shapes.T
        return Z, shapes, motion, forces, direct


def equations(
    at: LinearisedRobot, pose: int, inputs: Array, motors: Array, outputs: Array
) -> EquationsOfMotion:
    """Return the equations at one pose.

    Parameters
    ----------
    inputs : ndarray, shape (n, I)
        Generalised forces.
    motors : ndarray, shape (drives, I)
        Prescribed motor angles per unit of each input.
    outputs : ndarray, shape (outputs, n)
        What each output shows of the n coordinates.
    """
    T, own = at.kept, at.own_shapes[pose]
    M, K, C, loss = (matrix.own[pose] for matrix in (*at.matrices, *at.dissipation))
    M_u, K_u, C_u, loss_u = (matrix.prescribed[pose] @ motors for matrix in (*at.matrices, *at.dissipation))
    rates = at.rates[pose]
    momenta = (M @ own.T) * rates
    return EquationsOfMotion(
        M=M,
        C=C,
        K=K + 1j * loss,
        modal=momenta @ (own @ M),
        forces=(
            T.T @ inputs - K_u - 1j * loss_u,
            -(C_u + momenta @ (own @ M_u)).astype(complex),
            -M_u.astype(complex),
        ),
        motion=outputs @ T,
        prescribed=outputs @ at.prescribed @ motors,
        shapes=own,
        eigenvalues=at.eigenvalues[pose],
        rates=rates,
        massless=at.massless,
    )
