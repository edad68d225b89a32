r"""State space models of a robot at poses, in modal coordinates.

With the modes :math:`y = \Phi \eta` of the coordinates that are solved for, and prescribed motor angles u,

.. math:: \ddot\eta + D_m \dot\eta + \Lambda \eta = \Phi^T B_u f - (g \ddot u + c \dot u + k u) ,

where D_m is modal damping, B_u maps forces to coordinates, and g, c and k are inertia, damping and stiffness
between the modes and the prescribed motions.  The states
:math:`\xi = \eta + g u` and :math:`v = \dot\xi - h u`, with :math:`h = D_m g - c`, need no derivative of u:

.. math:: \dot\xi = v + h u , \qquad
    \dot v = -\Lambda \xi - D_m v + \Phi^T B_u f + (\Lambda g - k - D_m h) u .
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
    from scipy.signal import StateSpace as ScipyStateSpace

Array = NDArray[np.float64]
#: Feedthrough below this fraction of |C| |B| / max |A|, a measure of what the states contribute, counts as rounding.
FEEDTHROUGH_TOLERANCE = 1e-12
#: Text with which a MATLAB file begins, in place of SciPy's, which contains the date.
MAT_HEADER = b"MATLAB 5.0 MAT-file, written by pkmodes".ljust(116)


@dataclass(frozen=True, repr=False, eq=False)
class StateSpace(Channels):
    """State space models, one for each pose.

    Attributes
    ----------
    A : ndarray, shape (..., 2 k, 2 k)
        State matrix; the states are the coordinate and the rate of each of the k modes, in ascending order of
        frequency.  NaN, as are the other arrays, where a pose could not be evaluated.
    B : ndarray, shape (..., 2 k, inputs)
    C : ndarray, shape (..., outputs, 2 k)
    D : ndarray, shape (..., outputs, inputs)
    frequencies : ndarray, shape (..., k)
        Natural frequencies of these modes [Hz].
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

    def at(self, index: Index = ()) -> ScipyStateSpace[Any, Any]:
        """Return the model at one pose as a ``scipy.signal.StateSpace``.

        Parameters
        ----------
        index : int or tuple of int
            Index of the pose; not needed for a single one.

        Returns
        -------
        scipy.signal.StateSpace
            Its ``dt`` is the period of a discrete model.
        """
        from scipy.signal import StateSpace as ScipyStateSpace

        matrices = self._matrices(index)
        if self.tick is None:
            return ScipyStateSpace(*matrices)
        return ScipyStateSpace(*matrices, dt=self.tick)

    def to_control(self, index: Index = ()) -> Any:
        """Return the model at one pose as a ``control.StateSpace``, with the names of its inputs and outputs.

        Parameters
        ----------
        index : int or tuple of int
            Index of the pose; not needed for a single one.

        Returns
        -------
        control.StateSpace
            Its ``dt`` is the period of a discrete model.

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
            Index of the pose; not needed for a single one.

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
            Index of the pose; not needed for a single one.

        Returns
        -------
        bytes
            Version 5 of the format, with vectors as columns.

        Raises
        ------
        PkmodesError
            If `index` does not select one pose.
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
            Period between samples [s].

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
            raise PkmodesError(problem, "tick", "discretize the continuous models")
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
        augmented = np.zeros((*self.A.shape[:-2], states + inputs, states + inputs))
        augmented[..., :states, :states], augmented[..., :states, states:] = self.A, self.B
        finite = np.isfinite(augmented).all(axis=(-1, -2))
        exponential = np.full_like(augmented, np.nan)
        exponential[finite] = expm(augmented[finite] * tick)
        A, B = exponential[..., :states, :states], exponential[..., :states, states:]
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
        Poses in SI units.
    inputs, outputs : sequence
        As for `frf`.
    drives : {"free", "held"}, optional
        As for `modes`.
    modes : int, optional
        Number of modes kept, the lowest, rigid ones included; all by default.
    residual : bool
        Whether the static contribution of omitted modes is kept, in D (of displacements only).
    quantity : {"displacement", "velocity", "acceleration"}
        Quantity of every output.
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
        If a port is unknown or is no input or output with these drives, the number of modes is not possible, or a
        velocity or an acceleration would contain a derivative of an input.

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
    input_ports, output_ports = request.inputs, request.outputs
    system = model.solved(drives)
    rigid, count = system.rigid_modes, number_of_modes(system)
    min_modes, mode_count = max(rigid, 1), count if modes is None else modes
    if modes is not None and not (is_integer(mode_count) and min_modes <= mode_count <= count):
        problem = f"expected a number of modes from {min_modes} to {count}, found {shown(mode_count)}"
        which = f"; the {rigid} rigid ones are counted and kept" if rigid else ""
        raise PkmodesError(problem, "modes", f"give the number of the lowest modes that are kept{which}")
    checked = model.checked(poses, on_error)

    def evaluate(points: Array) -> tuple[Array, ...]:
        linearised = LinearisedRobot(model, points, drives, backend)
        has_residual = residual and quantity == "displacement"
        matrices = _modal_system(linearised, input_ports, output_ports, int(mode_count), has_residual)
        return _differentiate(matrices, QUANTITIES[quantity], input_ports, output_ports, quantity)

    A, B, C, D, frequencies = model.evaluated(evaluate, checked)
    return StateSpace(
        **request.fields(checked),
        A=A,
        B=B,
        C=C,
        D=D,
        frequencies=frequencies,
        tick=None,
    )


def _modal_system(
    robot: LinearisedRobot, inputs: Sequence[Port], outputs: Sequence[Port], mode_count: int, residual: bool
) -> tuple[Array, ...]:
    """Return A, B, C, D and the frequencies of the modes kept, at N poses.

    Symbols are those of the module's docstring; D is the feedthrough, and `modal_damping` is D_m.
    """
    shapes, eigenvalues, N = robot.own_shapes, robot.eigenvalues, len(robot.points)  # shapes: N, m, k
    rigid = robot.rigid
    forces = robot.kept.T @ input_vectors(robot, inputs)
    output_map = output_vectors(robot, outputs) @ robot.kept
    motors = prescribed(inputs, robot.prescribed.shape[1])
    M, K, viscous, loss = (block.prescribed @ motors for block in (*robot.matrices, *robot.dissipation))
    omega = np.sqrt(np.abs(eigenvalues))
    # g, k and c between the modes and the prescribed motions, Phi^T B_u, and the outputs of the modes.
    g, k, c = shapes @ M, shapes @ K, shapes @ viscous
    c += robot.rates[..., None] * g
    if loss.any():
        c[:, rigid:] += (shapes[:, rigid:] @ loss) / omega[:, rigid:, None]
    modal_forces = shapes @ forces
    modal_outputs = output_map @ np.swapaxes(shapes, -1, -2)  # N, outputs, m
    # Outputs that follow the inputs without delay: by prescribed motions, and by massless coordinates.
    D = output_vectors(robot, outputs) @ robot.prescribed @ motors + _massless_feedthrough(
        robot, forces - K, output_map
    )
    kept_modes = slice(0, mode_count)
    if residual:  # the static response of omitted modes, Lambda^-1 (Phi^T B_u - k)
        omitted = (modal_forces - k)[:, mode_count:] / eigenvalues[:, mode_count:, None]
        D = D + modal_outputs[:, :, mode_count:] @ omitted
    # The outputs are of eta = xi - g u.
    D = D - modal_outputs[:, :, kept_modes] @ g[:, kept_modes]
    modal_damping = robot.damping.matrix[:, kept_modes, kept_modes]
    h = modal_damping @ g[:, kept_modes] - c[:, kept_modes]
    # The states xi and v of each mode alternate.
    A, B = np.zeros((N, 2 * mode_count, 2 * mode_count)), np.zeros((N, 2 * mode_count, len(inputs)))
    C = np.zeros((N, len(outputs), 2 * mode_count))
    mode_indices = np.arange(mode_count)
    A[:, 2 * mode_indices, 2 * mode_indices + 1] = 1.0
    A[:, 2 * mode_indices + 1, 2 * mode_indices] = -eigenvalues[:, kept_modes]
    A[:, 1::2, 1::2] = -modal_damping
    B[:, 0::2] = h
    B[:, 1::2] = (
        modal_forces[:, kept_modes]
        + eigenvalues[:, kept_modes, None] * g[:, kept_modes]
        - k[:, kept_modes]
        - modal_damping @ h
    )
    C[:, :, 0::2] = modal_outputs[:, :, kept_modes]
    frequencies = np.sign(eigenvalues[:, kept_modes]) * omega[:, kept_modes] / (2.0 * np.pi)
    return A, B, C, D, frequencies


def _massless_feedthrough(robot: LinearisedRobot, forces: Array, output_map: Array) -> Array:
    """Return the feedthrough via massless coordinates, which respond without delay."""
    massless = robot.massless
    if not massless.any():
        return np.zeros((len(output_map), output_map.shape[1], forces.shape[-1]))
    K = robot.matrices[1].solved[:, massless][:, :, massless]
    return np.asarray(output_map[..., massless] @ np.linalg.solve(K, forces[:, massless]))


def _differentiate(
    matrices: tuple[Array, ...], order: int, inputs: Sequence[Port], outputs: Sequence[Port], quantity: str
) -> tuple[Array, ...]:
    """Return the matrices for outputs differentiated in time, which have no feedthrough before the last derivative.

    - matrices: A, B, C, D and frequencies
    - order: order of the derivative
    """
    A, B, C, D, frequencies = matrices
    for _ in range(order):
        scale = np.abs(C) @ np.abs(B) / np.maximum(np.abs(A).max(axis=(1, 2)), 1.0)[:, None, None]
        has_feedthrough = np.abs(D) > FEEDTHROUGH_TOLERANCE * np.maximum(scale, np.finfo(float).tiny)
        if has_feedthrough.any():
            _, o, i = np.argwhere(has_feedthrough)[0]
            problem = (
                f"the displacement of {outputs[o].name} follows {inputs[i].name} at once, so that its {quantity} "
                "contains a derivative of the input, which no proper system has"
            )
            raise PkmodesError(problem, "quantity", 'take "displacement", or the frequency responses (frf)')
        C, D = C @ A, C @ B
    return A, B, C, D, frequencies
