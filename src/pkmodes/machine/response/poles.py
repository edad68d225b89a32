"""Poles of a robot, and where the light-damping approximation of the damping ratio differs from that of the pole.

The poles are the eigenvalues of the damped system in modal coordinates (`pkmodes.core.linalg.damping`), whatever the
damping.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.numbers import plain
from pkmodes.core.linalg.damping import ModalDamping
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.machine.response.linearised import LinearisedRobot, nan_in_both_parts

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]
#: Modes are solved separately if their eigenvalues exceed all lower ones by this factor
MIN_SEPARATION_RATIO = 1e6
#: and the damping coupling D_ij^2 / lambda_j is below this.
MAX_COUPLING = 1e-12
#: A note names ratios that differ from that of their pole by more than this fraction.
MAX_RATIO_DIFFERENCE = 0.1


def poles_at(
    model: Model,
    poses: ArrayLike,
    on_error: OnError = "raise",
    *,
    drives: str | None = None,
    backend: str = AUTO,
) -> Complex:
    """Compute the poles of small vibrations, whatever the damping (docs/how-to/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        Poses in SI units.
    on_error : {"raise", "nan"}
        As for `modes`.
    drives : {"free", "held"}, optional
        As for `modes`.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`: what solves the undamped eigenproblem.

    Returns
    -------
    ndarray of complex128, shape (..., 2 m)
        In 1/s, by ascending magnitude; of a pair, the one with positive imaginary part first.  They are exact for
        viscous friction and damping ratios; a loss factor is replaced by the equivalent viscous
        damping at the frequency of each mode.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
    >>> model.poles([0.6, 0.0, -0.245], drives="held")[:2].round(2)
    array([-4.05+202.7j, -4.05-202.7j])
    """
    motors = model.robot.resolve_drives(drives)

    def evaluate(points: Array) -> Complex:
        return poles(LinearisedRobot(model, points, motors, backend).damping)

    (values,) = model.evaluated(evaluate, model.checked(poses, on_error))
    return nan_in_both_parts(np.asarray(values, dtype=complex))


def notes_on_damping(linearised: LinearisedRobot, ratios: Array) -> list[str]:
    """Return notes on modes where the light-damping approximation of the damping ratio differs from that of the pole.

    - linearised: robot at one pose
    - ratios: of `pkmodes.Modes.damping_ratios`, (m,)
    """
    if not np.nan_to_num(ratios).any():
        return []
    exact = ratios_of_poles(linearised.damping)[0]
    notes = []
    for i in range(linearised.rigid, len(ratios)):
        if abs(ratios[i] - exact[i]) > MAX_RATIO_DIFFERENCE * exact[i]:
            notes.append(
                f"mode {i + 1 - linearised.rigid}: the damping ratio {plain(ratios[i], 3)} assumes light "
                f"damping; that of the pole is {plain(exact[i], 3)}: use the poles"
            )
    return notes


def poles(damping: ModalDamping) -> Complex:
    """Return the poles, (N, 2 m) [1/s]: ascending magnitude, of a pair the one with positive imaginary part first."""
    D = damping.matrix
    if np.count_nonzero(D) <= np.count_nonzero(np.diagonal(D, axis1=-2, axis2=-1)):  # it couples no modes
        # The roots of s^2 + d s + lambda = 0 of each mode, without cancellation.
        half = 0.5 * np.diagonal(D, axis1=-2, axis2=-1)
        discriminant = half**2 - damping.eigenvalues
        root = np.sqrt(discriminant.astype(complex))
        first = -(half + root)
        with np.errstate(divide="ignore", invalid="ignore"):
            second_real_root = np.where(first == 0.0, 0.0, damping.eigenvalues / first)
        return _sorted(
            np.concatenate([first, np.where(discriminant >= 0.0, second_real_root, root - half)], axis=1)
        )
    values = np.linalg.eigvals(_state_matrix(damping)).astype(complex)
    for pose, parts in _separable_parts(damping):
        values[pose] = np.concatenate([np.linalg.eigvals(_state_matrix(part))[0] for part in parts])
    return _sorted(values)


def ratios_of_poles(damping: ModalDamping) -> Array:
    """Return the damping ratios -Re(s)/|s| of the poles in which each mode takes part most, (N, m)."""
    ratios = _ratios_of_one_block(damping)
    for pose, parts in _separable_parts(damping):
        ratios[pose] = np.concatenate([_ratios_of_one_block(part)[0] for part in parts])
    return ratios


def _separable_parts(damping: ModalDamping) -> Iterator[tuple[int, list[ModalDamping]]]:
    """Yield the poses with modes far above the others, with the modes in separate parts.

    Rounding errors of the fast modes would cost the slow modes digits.  Damping that couples the parts changes their
    poles by a fraction D_ij^2 / lambda_j.
    """
    eigenvalues, D, rigid_count = damping
    magnitudes = np.abs(eigenvalues)
    m = magnitudes.shape[1]
    if m <= rigid_count:
        return
    lowest_vibration = magnitudes[:, rigid_count]
    for pose in np.flatnonzero(magnitudes[:, -1] > MIN_SEPARATION_RATIO * lowest_vibration):
        cuts = [
            i
            for i in range(rigid_count + 1, m)
            if magnitudes[pose, i] > MIN_SEPARATION_RATIO * magnitudes[pose, i - 1]
            and (D[pose, :i, i:] ** 2 <= MAX_COUPLING * magnitudes[pose, i:]).all()
        ]
        if cuts:
            ends = [0, *cuts, m]
            yield (
                int(pose),
                [
                    ModalDamping(eigenvalues[pose : pose + 1, a:b], D[pose : pose + 1, a:b, a:b], 0)
                    for a, b in pairwise(ends)
                ],
            )


def _ratios_of_one_block(damping: ModalDamping) -> Array:
    values, vectors = np.linalg.eig(_state_matrix(damping))
    m = damping.eigenvalues.shape[1]
    participation = np.abs(vectors[:, :m]) ** 2 + np.abs(vectors[:, m:]) ** 2
    is_upper_half = (values.imag >= 0.0)[:, None]
    strongest = np.where(is_upper_half, participation, -1.0).argmax(axis=2)
    pole = np.take_along_axis(values, strongest, axis=1)
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray(-pole.real / np.abs(pole))


def _state_matrix(damping: ModalDamping) -> Array:
    """Return the matrix of the rates of (omega eta, eta_dot), whose entries are all in 1/s."""
    eigenvalues, D, _ = damping
    count, m = eigenvalues.shape
    omega, mode_indices = np.sqrt(np.abs(eigenvalues)), np.arange(m)
    A = np.zeros((count, 2 * m, 2 * m))
    A[:, mode_indices, m + mode_indices] = omega
    A[:, m + mode_indices, mode_indices] = -np.sign(eigenvalues) * omega
    A[:, m:, m:] = -D
    return A


def _sorted(values: Complex) -> Complex:
    """Sort poles by magnitude; conjugates, which differ by rounding at most, by descending imaginary part."""
    magnitudes = np.abs(values)
    order = np.argsort(magnitudes, axis=1, kind="stable")
    values, magnitudes = np.take_along_axis(values, order, 1), np.take_along_axis(magnitudes, order, 1)
    is_equal = np.diff(magnitudes, axis=1) <= 1e-12 * magnitudes[:, 1:]
    groups = np.concatenate([np.zeros((len(values), 1), int), np.cumsum(~is_equal, axis=1)], axis=1)
    order = np.lexsort((-values.imag, groups), axis=-1)
    return np.take_along_axis(values, order, 1)
