r"""The equations of motion at one pose, with the inputs and outputs of a response, and their frequency responses.

With the coordinates y that are solved for and prescribed motor angles u, :math:`q = T y + S u`.  Coordinates without
inertia follow the others statically, with complex stiffness; the forces of inputs are polynomials in
:math:`s = i \omega`, since a prescribed motion acts through stiffness, damping and inertia.

Responses come from one decomposition, instead of a linear system for every frequency:

.. math:: H(\omega) = l \, (Z + i \omega D - \omega^2)^{-1} \, b

with symmetric complex Z and real D of size m, in modal coordinates.  Modes that nothing couples are summed one by
one; for coupled ones the poles s_k of the first-order form give :math:`H = \sum_k R_k / (i \omega - s_k)`.  Fast
modes take digits from slow ones: one step of iterative refinement gives them back, and modes beyond all frequencies,
such as those of a stiff joint, follow statically.  Where the poles have no independent vectors, or nearly none
(critical damping), the linear systems are solved after all (Ewins, Modal Testing, 2nd edition, section 2).
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from pkmodes.machine.response.linearised import LinearisedRobot

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Off-diagonal entries below this fraction of the geometric mean of their diagonal entries couple nothing.
COUPLING_TOLERANCE = 1e-13
#: Largest condition number of the matrix of the poles' vectors.
MAX_VECTOR_CONDITION = 1e4
#: A mode follows statically if omega^2 is below this fraction of its eigenvalue, and damping is a small correction,
STATIC_INERTIA_SHARE = 1e-14
#: below this fraction of the elastic force.
STATIC_DAMPING_SHARE = 1e-8
#: Ratio of the fastest to the slowest mode from which the responses are refined.
MIN_REFINED_RATIO = 500.0
#: Number of steps of iterative refinement.
REFINEMENT_STEPS = 1


@dataclass(frozen=True)
class EquationsOfMotion:
    """At one pose, with k coordinates y and I inputs.

    - M, C, K: C without the damping of a ratio, K complex, (k, k)
    - modal: the damping of a ratio, (k, k)
    - forces: coefficients of 1, s and s^2, each (k, I)
    - motion, prescribed: what the outputs show of y, and of the inputs themselves, (outputs, k) and (outputs, I)
    - shapes: (m, k)
    - eigenvalues: (m,)
    - rates: diagonal damping of the modes by the ratio, 2 zeta omega, (m,) [1/s]
    - massless: (k,)
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
        massless = self.massless
        if (self.C[massless] != 0.0).any():
            return self.by_frequency(omega)
        Z, shapes, motion, forces, direct = self._condensed()
        D = shapes @ self.C[np.ix_(~massless, ~massless)] @ shapes.T + np.diag(self.rates)
        input_masks = [(force != 0.0).any(axis=0) for force in forces]  # prescribed motions act at all three
        b = np.hstack(
            [shapes @ force[:, input_mask] for force, input_mask in zip(forces, input_masks, strict=True)]
        )
        receptances = _receptance(Z, D, b, motion @ shapes.T, omega)
        feedthrough = direct + self.prescribed
        if input_masks[0].all() and not (input_masks[1].any() or input_masks[2].any()):
            if feedthrough.any():
                receptances += feedthrough
            return receptances
        H = np.empty((len(omega), *direct.shape), dtype=complex)
        H[...] = feedthrough
        powers: tuple[Any, ...] = (1.0, 1j * omega[:, None], -(omega[:, None] ** 2))
        column = 0
        for power, input_mask in zip(powers, input_masks, strict=True):
            for i in np.flatnonzero(input_mask):
                H[:, :, i] += power * receptances[:, :, column]
                column += 1
        return H

    def by_frequency(self, omega: Array) -> Complex:
        """Return the same from a linear system for each frequency."""
        s = 1j * omega[:, None, None]
        dynamic = self.K + s * (self.C + self.modal) + s**2 * self.M
        forces = self.forces[0] + s * self.forces[1] + s**2 * self.forces[2]
        return np.asarray(self.motion @ np.linalg.solve(dynamic, forces) + self.prescribed)

    def _condensed(self) -> tuple[Any, Array, Any, list[Any], Any]:
        """Return Z, and shapes, motion, forces and direct response without the coordinates that have no inertia.

        Real where nothing has a loss factor.
        """
        massless, inertial = self.massless, ~self.massless
        lossless = not self.K.imag.any()
        K: Any = self.K.real if lossless else self.K
        motion: Any = self.motion[:, inertial]
        forces: list[Any] = [force[inertial] for force in self.forces]
        direct: Any = np.zeros((len(self.motion), self.forces[0].shape[1]))
        change: Any = None if lossless else 1j * K.imag[np.ix_(inertial, inertial)]
        if massless.any():
            static_response = -np.linalg.solve(
                K[np.ix_(massless, massless)],
                np.hstack([K[np.ix_(massless, inertial)], -self.forces[0][massless]]),
            )
            by_coordinates, by_forces = np.split(static_response, [int(inertial.sum())], axis=1)
            if not lossless:
                static = -np.linalg.solve(
                    K.real[np.ix_(massless, massless)], K.real[np.ix_(massless, inertial)]
                )
                change = (
                    change
                    + K[np.ix_(inertial, massless)] @ by_coordinates
                    - K.real[np.ix_(inertial, massless)] @ static
                )
            motion = motion + self.motion[:, massless] @ by_coordinates
            forces[0] = forces[0] - K[np.ix_(inertial, massless)] @ by_forces
            direct = direct + self.motion[:, massless] @ by_forces
        shapes = self.shapes[:, inertial]
        Z = np.diag(self.eigenvalues)
        return Z if lossless else Z + shapes @ change @ shapes.T, shapes, motion, forces, direct


def equations(
    robot: LinearisedRobot, pose: int, inputs: Array, motors: Array, outputs: Array
) -> EquationsOfMotion:
    """Return the equations at one pose.

    - inputs: generalised forces, (n, I)
    - motors: prescribed motor angles per unit of each input, (drives, I)
    - outputs: what each output shows of the n coordinates, (outputs, n)
    """
    T, shapes = robot.kept, robot.own_shapes[pose]
    M, K, C, loss = (matrix.solved[pose] for matrix in (*robot.matrices, *robot.dissipation))
    M_u, K_u, C_u, loss_u = (
        matrix.prescribed[pose] @ motors for matrix in (*robot.matrices, *robot.dissipation)
    )
    rates = robot.rates[pose]
    momenta = (M @ shapes.T) * rates
    return EquationsOfMotion(
        M=M,
        C=C,
        K=K + 1j * loss,
        modal=momenta @ (shapes @ M),
        forces=(
            T.T @ inputs - K_u - 1j * loss_u,
            -(C_u + momenta @ (shapes @ M_u)).astype(complex),
            -M_u.astype(complex),
        ),
        motion=outputs @ T,
        prescribed=outputs @ robot.prescribed @ motors,
        shapes=shapes,
        eigenvalues=robot.eigenvalues[pose],
        rates=rates,
        massless=robot.massless,
    )


def _receptance(Z: Complex, D: Array, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    """Return H, (F, outputs, inputs).

    - Z, D: (m, m)
    - b: (m, inputs)
    - l: (outputs, m)
    - omega: angular frequencies, (F,) [rad/s]
    """
    coupled = (_coupling(Z) | _coupling(D)).any(axis=1)
    if not coupled.any():
        return _uncoupled_receptance(np.diagonal(Z), np.diagonal(D), b, l, omega)
    H = _coupled_receptance(
        Z[np.ix_(coupled, coupled)], D[np.ix_(coupled, coupled)], b[coupled], l[:, coupled], omega
    )
    if not coupled.all():
        z, d = np.diagonal(Z)[~coupled], np.diagonal(D)[~coupled]
        H += _uncoupled_receptance(z, d, b[~coupled], l[:, ~coupled], omega)
    return H


def _coupling(matrix: NDArray[np.generic]) -> NDArray[np.bool_]:
    magnitudes = np.abs(matrix)
    root = np.sqrt(np.diagonal(magnitudes))
    coupled_mask = magnitudes > COUPLING_TOLERANCE * root[:, None] * root
    np.fill_diagonal(coupled_mask, False)
    return np.asarray(coupled_mask | coupled_mask.T)


def _uncoupled_receptance(z: Any, d: Array, b: Any, l: Any, omega: Array) -> Complex:  # noqa: E741
    """Return sum_k l_k b_k / (z_k + i omega d_k - omega^2), infinite or NaN at a resonance without damping."""
    dynamic = np.empty((len(z), 2, len(omega)))
    np.subtract(z.real[:, None], omega**2, out=dynamic[:, 0])
    np.multiply(d[:, None], omega, out=dynamic[:, 1])
    if z.imag.any():
        dynamic[:, 1] += z.imag[:, None]
    return _sum_residues(dynamic, l, b)


def _sum_residues(denominators: Array, l: Any, b: Any) -> Complex:  # noqa: E741
    """Return sum_k l_k b_k / denominator_k, (F, outputs, inputs).

    - denominators: real and imaginary parts, (m, 2, F); replaced by those of the reciprocals
    """
    square = denominators[:, 0] ** 2
    square += denominators[:, 1] ** 2
    with np.errstate(divide="ignore", invalid="ignore"):
        denominators[:, 0] /= square
        denominators[:, 1] /= square
    reciprocals, (m, _, count) = denominators, denominators.shape
    outputs, inputs = len(l), b.shape[1]
    residues = (l[:, None, :] * b.T).reshape(outputs * inputs, m)
    H = np.empty((count, outputs * inputs), dtype=complex)
    # The imaginary part of a reciprocal is minus that of the denominator over the square.
    parts = (residues.real @ reciprocals.reshape(m, -1)).reshape(-1, 2, count)
    H.real, H.imag = parts[:, 0].T, 0.0 - parts[:, 1].T  # no negative zero: its phase would be -180 degrees
    if residues.imag.any():
        parts = (residues.imag @ reciprocals.reshape(m, -1)).reshape(-1, 2, count)
        H.real += parts[:, 1].T
        H.imag += parts[:, 0].T
    return H.reshape(count, outputs, inputs)


def _coupled_receptance(Z: Complex, D: Any, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    stiffness, max_omega = np.abs(np.diagonal(Z)), omega.max(initial=0.0)
    static_mask = (max_omega**2 <= STATIC_INERTIA_SHARE * stiffness) & (
        max_omega * np.diagonal(D) <= STATIC_DAMPING_SHARE * stiffness
    )
    if not static_mask.any() or static_mask.all():
        return _receptance_by_poles(Z, D, b, l, omega)
    dynamic, static = ~static_mask, static_mask
    root = np.sqrt(stiffness[static])  # their sizes differ widely: each has its own scale
    scaled = Z[np.ix_(static, static)] / root[:, None] / root
    by_dynamic, by_forces = (
        np.linalg.solve(scaled, right_side / root[:, None]) / root[:, None]
        for right_side in (Z[np.ix_(static, dynamic)], b[static])
    )
    damping = D[np.ix_(dynamic, static)] @ by_dynamic
    H = _receptance_by_poles(
        Z[np.ix_(dynamic, dynamic)] - Z[np.ix_(dynamic, static)] @ by_dynamic,
        D[np.ix_(dynamic, dynamic)]
        - damping
        - damping.T
        + by_dynamic.T @ D[np.ix_(static, static)] @ by_dynamic,
        b[dynamic] - by_dynamic.T @ b[static],
        l[:, dynamic] - l[:, static] @ by_dynamic,
        omega,
    )
    damping_correction = (
        np.linalg.solve(scaled, (D[np.ix_(static, static)] @ by_forces) / root[:, None]) / root[:, None]
    )
    return np.asarray(
        H + l[:, static] @ by_forces - 1j * omega[:, None, None] * (l[:, static] @ damping_correction)
    )


def _receptance_by_poles(Z: Complex, D: Any, b: Complex, l: Complex, omega: Array) -> Complex:  # noqa: E741
    m = len(D)
    min_omega = omega[omega > 0.0].min(initial=np.inf)
    scales = np.sqrt(np.abs(np.diagonal(Z)))
    scales = np.maximum(scales, np.where(np.isfinite(min_omega), min_omega, scales.max()))
    A = np.zeros((2 * m, 2 * m), dtype=complex)
    A[:m, m:] = np.diag(scales)  # the states are scales * eta and eta_dot
    A[m:, :m] = -Z / scales
    A[m:, m:] = -D
    poles, V = _eig(A)
    if np.linalg.cond(V) > MAX_VECTOR_CONDITION:
        dynamic_stiffness = Z + 1j * omega[:, None, None] * D - omega[:, None, None] ** 2 * np.eye(m)
        return np.asarray(l @ np.linalg.solve(dynamic_stiffness, np.broadcast_to(b, (len(omega), *b.shape))))
    inverse_vectors = np.linalg.inv(V)[:, m:]
    shapes = V[:m] / scales[:, None]
    if scales.max() <= MIN_REFINED_RATIO * scales.min():
        denominators = np.empty((2 * m, 2, len(omega)))
        denominators[:, 0] = -poles.real[:, None]
        np.subtract(omega, poles.imag[:, None], out=denominators[:, 1])
        return _sum_residues(denominators, l @ shapes, inverse_vectors @ b)
    gain = (1.0 / (1j * omega - poles[:, None]))[:, None, :]  # 2m, 1, F
    X = _modal_response(shapes, gain, (inverse_vectors @ b)[:, :, None])  # m, inputs, F
    for _ in range(REFINEMENT_STEPS):
        flat = X.reshape(m, -1)
        residual = (
            b[:, :, None]
            - (Z @ flat).reshape(X.shape)
            - 1j * omega * (D @ flat).reshape(X.shape)
            + omega**2 * X
        )
        X = X + _modal_response(
            shapes, gain, (inverse_vectors @ residual.reshape(m, -1)).reshape(2 * m, *X.shape[1:])
        )
    H = (l @ X.reshape(m, -1)).reshape(len(l), *X.shape[1:])
    return np.ascontiguousarray(np.moveaxis(H, -1, 0))


def _modal_response(shapes: Complex, gain: Complex, pole_forces: Complex) -> Complex:
    """Return the response of the modes to forces on the poles, (m, inputs, F)."""
    pole_responses = gain * pole_forces
    response: Complex = (shapes @ pole_responses.reshape(len(pole_responses), -1)).reshape(
        len(shapes), *pole_responses.shape[1:]
    )
    return response


def _eig(A: Complex) -> tuple[Complex, Complex]:
    """Return eigenvalues and vectors, computed in mixed coordinates.

    LAPACK scales rows and columns first, which spoils matrices with entries that are nothing but rounding, such as
    the stiffness of a rigid mode; where all entries are of one size it has nothing to scale.
    """
    n = len(A)
    v = np.cos(np.arange(n, dtype=float) ** 2 + 1.0)
    mixing = np.eye(n) - 2.0 * np.outer(v, v) / (v @ v)  # a reflection
    values, vectors = np.linalg.eig(mixing @ A @ mixing)
    return values, mixing @ vectors
