r"""State space models of a robot at poses, in modal coordinates.

With the modes :math:`y = \Phi \eta` of the coordinates that are solved for, and prescribed motor angles u,

.. math:: \ddot\eta + D \dot\eta + \Lambda \eta = \Phi^T B f - (g \ddot u + c \dot u + k u) ,

where g, c and k are inertia, damping and stiffness between the modes and the prescribed motions.  The states
:math:`\xi = \eta + g u` and :math:`v = \dot\xi - h u`, with :math:`h = D g - c`, need no derivative of u:

.. math:: \dot\xi = v + h u , \qquad
    \dot v = -\Lambda \xi - D v + \Phi^T B f + (\Lambda g - k - D h) u .
"""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass, replace
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import numpy as np
from numpy.typing import ArrayLike, NDArray
from scipy.linalg import expm

from pkmodes.core.base.arguments import is_integer
from pkmodes.core.base.errors import PkmodesError, shown
from pkmodes.core.mechanism.poses import OnError
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.support.writing import write_file
from pkmodes.core.system.evaluation import number_of_modes
from pkmodes.machine.response.channels import Channels, Index, ResponseRequest, control_library
from pkmodes.machine.response.linearised import LinearisedRobot
from pkmodes.machine.response.ports import QUANTITIES, Output, Port, input_vectors, output_vectors, prescribed

if TYPE_CHECKING:
    from scipy.signal import StateSpace as OfScipy

Array = NDArray[np.float64]
#: A direct part below this fraction of what the states contribute statically is rounding.
NOTHING = 1e-12
#: The text with which a MATLAB file begins; that of SciPy has the date.
MAT_HEADER = b"MATLAB 5.0 MAT-file, written by pkmodes".ljust(116)


@dataclass(frozen=True, repr=False, eq=False)
class StateSpace(Channels):
    """State space models, one for each pose.

    Attributes
    ----------
    A : ndarray, shape (..., 2 k, 2 k)
        The states are the coordinate and the rate of each of the k modes, ascending.  NaN, like the others, where a
        pose could not be evaluated.
    B : ndarray, shape (..., 2 k, inputs)
    C : ndarray, shape (..., outputs, 2 k)
    D : ndarray, shape (..., outputs, inputs)
    frequencies : ndarray, shape (..., k)
        Of these modes [Hz].
    tick : float or None
        Period of a discrete model [s]; None for a continuous one.
    """

    A: Array
    B: Array
    C: Array
    D: Array
    frequencies: Array
    tick: float | None

    def __repr__(self) -> str:
        time = "continuous" if self.tick is None else f"every {self.tick:g} s"
        return (
            f"StateSpace({self.A.shape}, {self.quantity} of {', '.join(self.outputs)}, {time}, "
            f"motors {self.drives})"
        )

    def at(self, index: Index = ()) -> OfScipy[Any, Any]:
        """Return the model at one pose as a ``scipy.signal.StateSpace``.

        Parameters
        ----------
        index : int or tuple of int
            Of the pose; not needed for a single one.

        Returns
        -------
        scipy.signal.StateSpace
            With the period of a discrete model.
        """
        from scipy.signal import StateSpace as OfScipy

        matrices = self._matrices(index)
        return OfScipy(*matrices) if self.tick is None else OfScipy(*matrices, dt=self.tick)

    def to_control(self, index: Index = ()) -> Any:
        """Return the model at one pose as a ``control.StateSpace``, with the names of its inputs and outputs.

        Parameters
        ----------
        index : int or tuple of int
            Of the pose; not needed for a single one.

        Returns
        -------
        control.StateSpace
            With the period of a discrete model.

        Raises
        ------
        MissingExtraError
            If python-control is not installed.
        """
        time = 0 if self.tick is None else self.tick
        names = {"inputs": list(self.inputs), "outputs": list(self.outputs)}
        return control_library().StateSpace(*self._matrices(index), time, **names)

    def to_mat(self, path: str | PathLike[str], index: Index = ()) -> None:
        """Write the model at one pose for MATLAB, as `as_mat` returns it.

        Parameters
        ----------
        path : str or path
            MATLAB file; an existing one is replaced.
        index : int or tuple of int
            Of the pose; not needed for a single one.

        Raises
        ------
        OutputError
            If the file cannot be written.
        """
        write_file(Path(path), self.as_mat(index))

    def as_mat(self, index: Index = ()) -> bytes:
        """Return the model at one pose as a MATLAB file: A, B, C, D, ``inputs``, ``outputs``, ``units``, ``pose``.

        Parameters
        ----------
        index : int or tuple of int
            Of the pose; not needed for a single one.

        Returns
        -------
        bytes
            Version 5 of the format, with vectors as columns.

        Raises
        ------
        PkmodesError
            If the pose is not one of several.
        """
        from scipy.io import savemat

        content: dict[str, Any] = dict(zip("ABCD", self._matrices(index), strict=True))
        content |= {
            "inputs": np.array(self.inputs, dtype=object),
            "outputs": np.array(self.outputs, dtype=object),
            "units": np.array(self.units, dtype=object),
            "pose": self.poses[self.one(index)],
        }
        if self.tick is not None:
            content["tick"] = self.tick
        written = io.BytesIO()
        savemat(cast("Any", written), content, oned_as="column")  # SciPy takes open files too
        written.seek(0)
        written.write(MAT_HEADER)
        return written.getvalue()

    def _matrices(self, index: Index) -> tuple[Array, Array, Array, Array]:
        where = self.one(index)
        return self.A[where], self.B[where], self.C[where], self.D[where]

    def discretized(self, tick: float) -> StateSpace:
        """Return discrete models for inputs that are held between ticks (zero-order hold).

        Parameters
        ----------
        tick : float
            [s].

        Returns
        -------
        StateSpace
            A and B for one tick; C and D as before.

        Raises
        ------
        PkmodesError
            If the models are discrete already, the period is not a positive number, or a mode is above half the
            sampling rate: leave it out with ``modes``.
        """
        if self.tick is not None:
            problem = f"these models are discrete already, every {self.tick:g} s"
            raise PkmodesError(problem, "tick", "discretise the continuous models")
        if not isinstance(tick, int | float | np.number) or not np.isfinite(tick) or tick <= 0.0:
            raise PkmodesError(f"expected a period in s, found {shown(tick)}", "tick", "for example: 0.001")
        highest = float(np.nanmax(np.abs(self.frequencies), initial=0.0))
        if highest > 0.5 / tick:
            problem = (
                f"a mode at {highest:.4g} Hz is above half the sampling rate, {0.5 / tick:.4g} Hz: samples "
                "every {:g} s do not show it".format(tick)
            )
            raise PkmodesError(problem, "tick", "keep fewer modes (modes=), or take a shorter period")
        states, inputs = self.B.shape[-2:]
        both = np.zeros((*self.A.shape[:-2], states + inputs, states + inputs))
        both[..., :states, :states], both[..., :states, states:] = self.A, self.B
        there = np.isfinite(both).all(axis=(-1, -2))
        stepped = np.full_like(both, np.nan)
        stepped[there] = expm(both[there] * tick)
        A, B = stepped[..., :states, :states], stepped[..., :states, states:]
        return replace(self, A=A, B=B, tick=float(tick))


def state_space(
    model: Model,
    poses: ArrayLike,
    inputs: Sequence[str],
    outputs: Sequence[Output],
    *,
    drives: str | None = None,
    modes: int | None = None,
    residual: bool = True,
    quantity: str = "displacement",
    on_error: OnError = "raise",
    backend: str = AUTO,
) -> StateSpace:
    """Build state space models in modal coordinates (docs/how-to/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        In SI units.
    inputs, outputs : sequence
        As for `frf`.
    drives : {"free", "held"}, optional
        As for `modes`.
    modes : int, optional
        Number of modes kept, the lowest, rigid ones included; all by default.
    residual : bool
        Whether the static contribution of omitted modes is kept, in D (of displacements only).
    quantity : {"displacement", "velocity", "acceleration"}
        Of every output.
    on_error : {"raise", "nan"}
        As for `modes`.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`: what solves the undamped eigenproblem.

    Returns
    -------
    StateSpace
        ``A``, ``B``, ``C`` and ``D`` with the leading axes of the poses.  The states are the coordinate and the
        rate of each mode.  Shapes of neighbouring poses may differ in sign and order: interpolate transfer
        functions, not these matrices.

    Raises
    ------
    PkmodesError
        If a port is unknown or is not one with these drives, the number of modes is not possible, or a velocity
        or an acceleration would contain a derivative of an input.

    Examples
    --------
    >>> import pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
    >>> system = model.state_space([0.6, 0.0, -0.245], ["motor_1"], ["p_x"], drives="held", modes=3)
    >>> system.A.shape, system.D.shape
    ((6, 6), (1, 1))
    >>> system.discretized(0.001).at().dt
    0.001
    """
    drives = model.robot.resolve_drives(drives)
    request = ResponseRequest.of(model, inputs, outputs, quantity, drives)
    into, out = request.inputs, request.outputs
    system = model.solved(drives)
    rigid, count = system.rigid_modes, number_of_modes(system)
    least, kept = max(rigid, 1), count if modes is None else modes
    if modes is not None and not (is_integer(kept) and least <= kept <= count):
        problem = f"expected a number of modes from {least} to {count}, found {shown(kept)}"
        which = f"; the {rigid} rigid ones are counted and kept" if rigid else ""
        raise PkmodesError(problem, "modes", f"give the number of the lowest modes that are kept{which}")
    checked = model.checked(poses, on_error)

    def at(points: Array) -> tuple[Array, ...]:
        vibrating = LinearisedRobot(model, points, drives, backend)
        parts = _matrices(vibrating, into, out, int(kept), residual and quantity == "displacement")
        return _differentiated(parts, QUANTITIES[quantity], into, out, quantity)

    A, B, C, D, frequencies = model.evaluated(at, checked)
    return StateSpace(
        **request.fields(checked),
        A=A,
        B=B,
        C=C,
        D=D,
        frequencies=frequencies,
        tick=None,
    )


def _matrices(
    at: LinearisedRobot, inputs: Sequence[Port], outputs: Sequence[Port], kept: int, residual: bool
) -> tuple[Array, ...]:
    """Return A, B, C, D and the frequencies of the modes kept, at N poses."""
    shapes, eigenvalues, N = at.own_shapes, at.eigenvalues, len(at.points)  # shapes: N, m, k
    damping, rigid = at.damping.matrix, at.rigid
    forces, L = at.kept.T @ input_vectors(at, inputs), output_vectors(at, outputs) @ at.kept
    motors = prescribed(inputs, at.prescribed.shape[1])
    M, K, viscous, loss = (block.prescribed @ motors for block in (*at.matrices, *at.dissipation))
    omega = np.sqrt(np.abs(eigenvalues))
    g, k, c = shapes @ M, shapes @ K, shapes @ viscous
    c += at.rates[..., None] * g
    if loss.any():
        c[:, rigid:] += (shapes[:, rigid:] @ loss) / omega[:, rigid:, None]
    shown_by = L @ np.swapaxes(shapes, -1, -2)  # N, outputs, m
    D = output_vectors(at, outputs) @ at.prescribed @ motors + _massless(at, forces - K, L)
    push, use = shapes @ forces, slice(0, kept)
    if residual:
        omitted = (push - k)[:, kept:] / eigenvalues[:, kept:, None]
        D = D + shown_by[:, :, kept:] @ omitted
    D = D - shown_by[:, :, use] @ g[:, use]
    d = damping[:, use, use]
    h = d @ g[:, use] - c[:, use]
    A, B = np.zeros((N, 2 * kept, 2 * kept)), np.zeros((N, 2 * kept, len(inputs)))
    C = np.zeros((N, len(outputs), 2 * kept))
    place = np.arange(kept)
    A[:, 2 * place, 2 * place + 1] = 1.0
    A[:, 2 * place + 1, 2 * place] = -eigenvalues[:, use]
    A[:, 1::2, 1::2] = -d
    B[:, 0::2] = h
    B[:, 1::2] = push[:, use] + eigenvalues[:, use, None] * g[:, use] - k[:, use] - d @ h
    C[:, :, 0::2] = shown_by[:, :, use]
    return A, B, C, D, np.sign(eigenvalues[:, use]) * omega[:, use] / (2.0 * np.pi)


def _massless(at: LinearisedRobot, forces: Array, L: Array) -> Array:
    """Return the outputs' direct response by coordinates without inertia, which give way to the inputs at once."""
    r = at.massless
    if not r.any():
        return np.zeros((len(L), L.shape[1], forces.shape[-1]))
    K = at.matrices[1].solved[:, r][:, :, r]
    return np.asarray(L[..., r] @ np.linalg.solve(K, forces[:, r]))


def _differentiated(
    parts: tuple[Array, ...], times: int, inputs: Sequence[Port], outputs: Sequence[Port], quantity: str
) -> tuple[Array, ...]:
    """Differentiate the outputs in time, which is impossible where an output follows an input at once."""
    A, B, C, D, frequencies = parts
    for _ in range(times):
        scale = np.abs(C) @ np.abs(B) / np.maximum(np.abs(A).max(axis=(1, 2)), 1.0)[:, None, None]
        direct = np.abs(D) > NOTHING * np.maximum(scale, np.finfo(float).tiny)
        if direct.any():
            _, o, i = np.argwhere(direct)[0]
            problem = (
                f"the displacement of {outputs[o].name} follows {inputs[i].name} at once, so that its {quantity} "
                "contains a derivative of the input, which no proper system has"
            )
            raise PkmodesError(problem, "quantity", 'take "displacement", or the frequency responses (frf)')
        C, D = C @ A, C @ B
    return A, B, C, D, frequencies
