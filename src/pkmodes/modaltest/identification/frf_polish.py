r"""Maximum-likelihood fit of a few neighbouring modes to the lines around them.

In a window of lines, and after subtraction of the modes outside it,

.. math:: H_{sr}(f) = \sum_m \frac{\phi_{sm} L_{rm}}{j \omega - \lambda_m} + \sum_{k=0}^3 c_{srk} f^k ,

where the polynomial stands for whatever is smooth: residual terms, modes outside the band, and what differentiation
to velocity or acceleration adds.  It is projected out (variable projection: Golub and Pereyra, SIAM
Journal on Numerical Analysis 10, 1973).  The model is holomorphic in its parameters, so that the Gauss-Newton method
works on complex numbers; with circular noise of known variance at each channel its minimum is the maximum-likelihood
estimate (Guillaume, Verboven and Vanlanduit, ISMA 23, 1998).
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from pkmodes.modaltest.identification.modes import IdentifiedModes

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

#: Coefficients of the smooth part at each channel: a cubic leaves 1 % of the curvature of a mode that lies one window
#: width outside the window.
SMOOTH_TERMS = 4
#: Maximum number of steps: Gauss-Newton converges in a few or, for modes that the lines do not resolve, not at all.
MAX_STEPS = 25
#: Relative decrease of the cost that ends the iteration: far below what one line's noise contributes.
CONVERGED_CHANGE = 1e-7
#: Damping of the steps (Levenberg and Marquardt), relative to the diagonal: initial, and at which the fit gives up.
INITIAL_DAMPING, MAX_DAMPING = 1e-4, 1e8


@dataclass(frozen=True, eq=False)
class Window:
    """Lines with the smooth part projected out.

    - s: j omega, (F,) [1/s]
    - sigma: relative noise of the lines, by which all other arrays are divided, (F,)
    - smooth: orthonormal, (F, K)
    - H: without the smooth part, (F, S, R); 0 where not measured
    - weights: inverse variances, (S, R), 0 where not measured
    """

    s: Complex
    sigma: Array
    smooth: Complex
    H: Complex
    weights: Array


@dataclass(frozen=True, eq=False)
class WindowFit(IdentifiedModes):
    """Modes fitted in a window.

    - cost: weighted sum of squares of the residual
    """

    cost: float
    converged: bool


def make_window(frequencies: Array, H: Complex, weights: Array, sigma: Array) -> Window:
    """Return lines ready for `polish`.

    - frequencies: (F,) [Hz]
    - H: (F, S, R); NaN where not measured
    - weights: inverse variances, (S, R)
    - sigma: relative noise of the lines, (F,)
    """
    middle, half_range = frequencies.mean(), 0.5 * float(np.ptp(frequencies))
    powers = np.vander((frequencies - middle) / half_range, SMOOTH_TERMS)
    smooth = np.linalg.qr(powers / sigma[:, None])[0].astype(complex)
    used_weights = np.where(np.isfinite(H).all(axis=0), weights, 0.0)
    values = np.where(used_weights > 0.0, H, 0.0) / sigma[:, None, None]
    values = values - np.tensordot(smooth, np.tensordot(smooth.conj(), values, (0, 0)), 1)
    s = np.asarray(2j * math.pi * frequencies, dtype=complex)
    return Window(s, sigma, smooth, np.asarray(values), used_weights)


def pole_basis(window: Window, poles: Complex) -> Complex:
    """Return 1/(j omega - lambda) and its derivative by lambda without their smooth part, (F, 2 N)."""
    g = 1.0 / (window.s[:, None] - poles)
    E = np.concatenate([g, g**2], axis=1) / window.sigma[:, None]
    return np.asarray(E - window.smooth @ (window.smooth.conj().T @ E))


def polish(window: Window, poles: Complex, participation: Complex) -> WindowFit:
    """Fit modes from a starting point.

    - poles: (N,) [1/s]
    - participation: at any scale, (N, R)
    """
    N = len(poles)
    total_energy = float((window.weights * (np.abs(window.H) ** 2).sum(axis=0)).sum())
    state = _normalise(poles, _least_squares_shapes(window, poles, participation), participation)
    E = pole_basis(window, state[0])
    cost, gradient, A = _normal_equations(window, E, *state, total_energy)
    damping, converged = INITIAL_DAMPING, False
    for _ in range(MAX_STEPS):
        step = np.linalg.solve(A + np.diag(damping * A.diagonal().real + 1e-300), gradient)
        trial = _apply_step(state, np.asarray(step, dtype=complex), N)
        if (trial[0].real < 0.0).all() and (np.abs(step[:N]) < 3.0 * np.abs(state[0].real)).all():
            trial = _normalise(*trial)
            E = pole_basis(window, trial[0])
            trial_equations = _normal_equations(window, E, *trial, total_energy)
            if trial_equations[0] <= cost:
                converged = cost - trial_equations[0] <= CONVERGED_CHANGE * cost
                state, (cost, gradient, A) = trial, trial_equations
                damping = max(damping / 10.0, 1e-12)
                if converged:
                    break
                continue
        damping *= 10.0
        if damping > MAX_DAMPING:
            converged = float(np.abs(gradient[:N]).max()) < np.inf
            break
    return WindowFit(*state, cost, converged)


def derivative_columns(shapes: Complex, participation: Complex) -> tuple[NDArray[np.int64], Complex]:
    """Return the derivatives of the model by its parameters as products of a basis function and a channel vector.

    The parameters are the poles, the shapes (mode by mode), and the participations except the largest of each mode,
    which sets the scale.

    Returns, in this order:
    - functions: functions of `pole_basis`, (P,)
    - channels: (P, S, R)
    """
    (N, S), R = shapes.shape, participation.shape[1]
    functions, channels = [*range(N, 2 * N)], [*(shapes[:, :, None] * participation[:, None, :])]
    for m in range(N):
        for s in range(S):
            functions.append(m)
            channel = np.zeros((S, R), complex)
            channel[s] = participation[m]
            channels.append(channel)
    for m, scale_index in enumerate(np.abs(participation).argmax(axis=1)):
        for r in range(R):
            if r != scale_index:
                functions.append(m)
                channel = np.zeros((S, R), complex)
                channel[:, r] = shapes[m]
                channels.append(channel)
    return np.array(functions), np.array(channels)


def _normal_equations(
    window: Window, E: Complex, poles: Complex, shapes: Complex, participation: Complex, total_energy: float
) -> tuple[float, Complex, Complex]:
    """Return the cost, the right-hand side and the matrix of the normal equations."""
    N = len(poles)
    gram = E.conj().T @ E
    X = np.tensordot(E.conj(), window.H, (0, 0))
    residues = shapes[:, :, None] * participation[:, None, :]
    remainder = X - np.tensordot(gram[:, :N], residues, 1)
    explained = (residues.conj() * window.weights * (X[:N] + remainder[:N])).sum().real
    functions, channels = derivative_columns(shapes, participation)
    P = len(functions)
    weighted = (channels.conj() * window.weights).reshape(P, -1)
    gradient = (weighted * remainder[functions].reshape(P, -1)).sum(axis=1)
    A = (weighted @ channels.reshape(P, -1).T) * gram[np.ix_(functions, functions)]
    unmeasured = A.diagonal().real <= 0.0  # a sensor without data
    A[unmeasured, unmeasured] = 1.0
    return total_energy - float(explained), gradient, A


def _least_squares_shapes(window: Window, poles: Complex, participation: Complex) -> Complex:
    """Return the least-squares shapes (N, S) for given poles and participations."""
    E = pole_basis(window, poles)[:, : len(poles)]
    gram, X = E.conj().T @ E, np.tensordot(E.conj(), window.H, (0, 0))
    shapes = np.empty((len(poles), window.H.shape[1]), complex)
    for s, w in enumerate(window.weights):
        matrix = gram * ((participation.conj() * w) @ participation.T)
        right_side = (participation.conj() * w * X[:, s]).sum(axis=1)
        scales = np.sqrt(np.maximum(matrix.diagonal().real, 1e-300))
        scaled_solution = np.linalg.lstsq(
            matrix / (scales[:, None] * scales), right_side / scales, rcond=1e-12
        )[0]
        shapes[:, s] = scaled_solution / scales
    return shapes


def _apply_step(
    state: tuple[Complex, Complex, Complex], step: Complex, N: int
) -> tuple[Complex, Complex, Complex]:
    poles, shapes, participation = state
    S, R = shapes.shape[1], participation.shape[1]
    new_participation = participation.copy()
    participation_step = step[N + N * S :].reshape(N, R - 1)
    for m, scale_index in enumerate(np.abs(participation).argmax(axis=1)):
        new_participation[m, np.arange(R) != scale_index] += participation_step[m]
    return poles + step[:N], shapes + step[N : N + N * S].reshape(N, S), new_participation


def _normalise(poles: Complex, shapes: Complex, participation: Complex) -> tuple[Complex, Complex, Complex]:
    """Return participations whose largest component is 1."""
    largest = np.take_along_axis(participation, np.abs(participation).argmax(axis=1)[:, None], 1)
    largest = np.where(largest == 0.0, 1.0, largest)
    return poles, shapes * largest, participation / largest
