"""Frequency response functions of a robot at poses, also as datasets, for python-control, and as CSV."""

from __future__ import annotations

import csv
import io
from collections.abc import Sequence
from dataclasses import dataclass
from os import PathLike
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from pkmodes.core.base.arguments import real_numbers
from pkmodes.core.base.errors import PkmodesError
from pkmodes.core.mechanism.poses import OnError, format_pose
from pkmodes.core.model import Model
from pkmodes.core.solve.backends import AUTO
from pkmodes.core.support.writing import write_file
from pkmodes.machine.dataset.attributes import import_xarray
from pkmodes.machine.dataset.variables import dims_of_poses
from pkmodes.machine.response.channels import Channels, ResponseRequest, control_library
from pkmodes.machine.response.equations import equations
from pkmodes.machine.response.linearised import LinearisedRobot, nan_in_both_parts
from pkmodes.machine.response.ports import QUANTITIES, Output, Port, input_vectors, output_vectors, prescribed

if TYPE_CHECKING:
    from xarray import Dataset

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]


@dataclass(frozen=True, repr=False, eq=False)
class FrequencyResponse(Channels):
    """Responses of outputs to inputs, for exp(+i omega t).

    Attributes
    ----------
    values : ndarray of complex128, shape (..., F, outputs, inputs)
        NaN where a pose could not be evaluated.
    frequencies : ndarray, shape (F,)
        Frequencies [Hz].
    request : ResponseRequest
        The robot and the ports that were requested.
    """

    values: Complex
    frequencies: Array
    request: ResponseRequest

    def __repr__(self) -> str:
        shape = self.values.shape
        return (
            f"FrequencyResponse({shape}, {self.quantity} of {', '.join(self.outputs)}, motors {self.drives})"
        )

    def to_dataset(self) -> Dataset:
        """Return the responses as a dataset.

        Returns
        -------
        xarray.Dataset
            ``response`` with the dimensions of the poses, then ``frequency``, ``output``, ``input``.

        Raises
        ------
        MissingExtraError
            If the libraries of the extra ``map`` are not installed.
        """
        xr = import_xarray()
        leading = dims_of_poses(self.poses.ndim - 1)
        components = {
            component.name: (leading, self.poses[..., i], {"units": component.unit})
            for i, component in enumerate(self.robot.mechanism.pose)
        }
        text = f"{self.quantity} of the outputs per unit of the inputs, exp(+i omega t)"
        data = {
            "response": ((*leading, "frequency", "output", "input"), self.values, {"long_name": text}),
            "unit": (("output", "input"), np.array(self.units, dtype=object)),
            "valid": (leading, self.valid),
            "reason": (leading, self.reason),
        }
        coords = {
            **components,
            "frequency": ("frequency", self.frequencies, {"units": "Hz"}),
            "output": list(self.outputs),
            "input": list(self.inputs),
        }
        attributes = {"robot": self.robot.name, "drives": self.drives, "quantity": self.quantity}
        dataset: Dataset = xr.Dataset(data, coords, attributes)
        return dataset

    def to_control(self, index: tuple[int, ...] | int = ()) -> Any:
        """Return the response at one pose as a ``control.FrequencyResponseData``.

        Parameters
        ----------
        index : int or tuple of int
            Index of the pose; not needed for a single one.

        Returns
        -------
        control.FrequencyResponseData
            With the names of inputs and outputs.

        Raises
        ------
        MissingExtraError
            If python-control is not installed.
        """
        values = self.values[self.one(index)]
        return control_library().FrequencyResponseData(
            np.moveaxis(values, 0, -1),  # outputs, inputs, frequencies
            2.0 * np.pi * self.frequencies,
            inputs=list(self.inputs),
            outputs=list(self.outputs),
        )

    def to_csv(self, path: str | PathLike[str], index: tuple[int, ...] | int = ()) -> None:
        """Write the response at one pose, as `as_csv` returns it.

        Parameters
        ----------
        path : str or path
            CSV file; an existing one is replaced.
        index : int or tuple of int
            Index of the pose; not needed for a single one.

        Raises
        ------
        OutputError
            If the file cannot be written.
        """
        write_file(Path(path), self.as_csv(index))

    def as_csv(self, index: tuple[int, ...] | int = ()) -> str:
        """Return the response at one pose as a table: ``frequency`` and ``re:OUTPUT/INPUT``, ``im:OUTPUT/INPUT``.

        Parameters
        ----------
        index : int or tuple of int
            Index of the pose; not needed for a single one.

        Returns
        -------
        str
            CSV, with the units as comments.

        Raises
        ------
        PkmodesError
            If `index` does not select one pose.
        """
        pose_index = self.one(index)
        text = io.StringIO()
        text.write(f"# robot: {self.robot.name}\n")
        text.write(f"# pose: {format_pose(self.robot.mechanism, self.poses[pose_index], 'g')}\n")
        text.write(f"# drives: {self.drives}\n")
        text.write(f"# quantity: {self.quantity}\n")
        channels = [
            (o, i, f"{output}/{input_name}")
            for o, output in enumerate(self.outputs)
            for i, input_name in enumerate(self.inputs)
        ]
        for o, i, name in channels:
            text.write(f"# unit: {name} = {self.units[o][i]}\n")
        writer = csv.writer(text, lineterminator="\n")
        writer.writerow(
            ["frequency", *(f"{part}:{name}" for _, _, name in channels for part in ("re", "im"))]
        )
        for f, row in zip(self.frequencies, self.values[pose_index], strict=True):
            cells = [number for o, i, _ in channels for number in (row[o, i].real, row[o, i].imag)]
            writer.writerow([repr(float(f)), *(repr(float(cell)) for cell in cells)])
        return text.getvalue()


def frequency_response(
    model: Model,
    poses: ArrayLike,
    frequencies: ArrayLike,
    inputs: Sequence[str],
    outputs: Sequence[Output],
    *,
    drives: str | None = None,
    quantity: str = "displacement",
    on_error: OnError = "raise",
    backend: str = AUTO,
) -> FrequencyResponse:
    """Compute frequency response functions, for exp(+i omega t) (docs/how-to/response.md).

    Parameters
    ----------
    model : Model
        The evaluator of the robot.
    poses : array_like, shape (d,) or (..., d)
        Poses in SI units.
    frequencies : array_like, shape (F,)
        Frequencies in Hz; 0 only where no rigid mode exists.
    inputs : sequence of str
        ``torque_j`` of a free motor [N m], the prescribed angle ``motor_j`` of a held one [rad],
        ``force_<direction>`` on the platform [N], and ``moment_<axis>`` on one that turns [N m].  Of a motor that
        moves a length, ``torque_j`` is the force [N] and ``motor_j`` the length [m].
    outputs : sequence of str or mapping
        ``p_<direction>``, ``r_<axis>`` of a platform that turns, ``{"name": [dx, dy, dz]}`` for another direction of
        the platform, ``motor_j``, and every coordinate of the robot.
    drives : {"free", "held"}, optional
        As for `modes`.
    quantity : {"displacement", "velocity", "acceleration"}
        Quantity of every output.
    on_error : {"raise", "nan"}
        As for `modes`.
    backend : {"auto", "numpy", "compiled"}
        As for `modes`: what solves the undamped eigenproblem.

    Returns
    -------
    FrequencyResponse
        ``values`` of shape (..., F, outputs, inputs).

    Raises
    ------
    PkmodesError
        If a port is unknown (the message suggests the nearest) or is no input or output with these drives, or a
        frequency is invalid.

    Examples
    --------
    >>> import numpy as np, pkmodes
    >>> model = pkmodes.load("robots/linear-delta-2022.toml").with_values({"damping.ratio": 0.02})
    >>> found = model.frf([0.6, 0.0, -0.245], np.linspace(10, 60, 501), ["force_x"], ["p_x"], drives="held")
    >>> float(found.frequencies[abs(found.values[:, 0, 0]).argmax()].round(1))
    36.2
    """
    drives = model.robot.resolve_drives(drives)
    request = ResponseRequest.of(model, inputs, outputs, quantity, drives)
    hertz = checked_frequencies(frequencies, model.solved(drives).rigid_modes, drives)
    omega = 2.0 * np.pi * hertz
    checked = model.checked(poses, on_error)

    def evaluate(points: Array) -> Complex:
        linearised = LinearisedRobot(model, points, drives, backend)
        return responses(linearised, request.inputs, request.outputs, omega, quantity)

    (values,) = model.evaluated(evaluate, checked)
    return FrequencyResponse(
        **request.fields(checked),
        values=nan_in_both_parts(np.asarray(values, dtype=complex)),
        frequencies=hertz,
        request=request,
    )


def responses(
    robot: LinearisedRobot, inputs: Sequence[Port], outputs: Sequence[Port], omega: Array, quantity: str
) -> Complex:
    """Return responses at N poses, (N, F, outputs, inputs), at angular frequencies [rad/s]."""
    B, L = input_vectors(robot, inputs), output_vectors(robot, outputs)
    motors = prescribed(inputs, robot.prescribed.shape[1])
    values = np.empty((len(robot.points), len(omega), len(outputs), len(inputs)), dtype=complex)
    for pose in range(len(robot.points)):
        values[pose] = equations(robot, pose, B[pose], motors, L[pose]).response(omega)
    if QUANTITIES[quantity]:
        values *= (1j * omega[:, None, None]) ** QUANTITIES[quantity]
    return values


def checked_frequencies(frequencies: ArrayLike, rigid: int, drives: str) -> Array:
    """Return frequencies [Hz] as an array.

    Raises PkmodesError if they are not finite numbers of at least 0, or 0 although the robot has rigid modes.
    """
    example = "for example: numpy.linspace(1, 400, 1000)"
    hertz = np.atleast_1d(real_numbers(frequencies, "frequencies in Hz", "frequencies", example))
    if hertz.ndim != 1 or not hertz.size:
        problem = f"expected a list of frequencies in Hz, found an array of shape {hertz.shape}"
        raise PkmodesError(problem, "frequencies", example)
    is_invalid = ~(np.isfinite(hertz) & (hertz >= 0.0))
    if is_invalid.any():
        problem = f"expected frequencies of at least 0 Hz, found {hertz[int(np.argmax(is_invalid))]:g}"
        raise PkmodesError(problem, "frequencies", "give finite numbers in Hz")
    if rigid and (hertz == 0.0).any():
        problem = (
            f"found 0 Hz, but with motors {drives} the machine has {rigid} rigid modes: it moves without end"
        )
        raise PkmodesError(problem, "frequencies", 'begin above 0 Hz, or use drives="held"')
    return hertz
